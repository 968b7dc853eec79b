"""The outcome of the benchmark's 200 points with SciPy's LSODA, the way a user of SciPy would write it.

Prints the CPU seconds, the number of points, of failures and of points judged to oscillate. Called by benchmark_simulation.
"""
import sys
import time
import warnings

import numpy as np
from scipy.integrate import solve_ivp

warnings.filterwarnings("ignore")
A, B, f0, L, m, V_star = 1.0, 1.5, 60.0, 1e-5, 1.0, 1e-6
TURNS, KICK = 50, 0.01


def points():
    for V0 in np.logspace(-6, -2, 5):
        for share in np.linspace(0, 1.5, 5):
            k_v = share * (B - A) / V0
            damping = k_v if share < 1 else 0.0
            k_cr = ((B - A - damping * V0) / L) * (1 + m * V0 / (L * (damping + A / V0)))
            for ratio in np.logspace(np.log10(0.2), np.log10(5), 8):
                yield V0, k_v, ratio * k_cr


def oscillates(V0, k_v, k_p):
    f_ss = f0 + (A - B) * np.log(V0 / V_star)
    theta = -B * np.log(V0 / V_star)

    def rate(t, y):
        x, z, state = y
        V, log = np.exp(z), z - np.log(V_star)
        return [V - V0, -(k_v * (V - V0) + k_p * x + f0 + A * log + state - f_ss) / (m * V), -(V / L) * (state + B * log)]

    # one per cent of velocity with the forces kept balanced by the state
    start = [0, np.log((1 + KICK) * V0), theta - A * np.log(1 + KICK) - k_v * KICK * V0]
    turn = 2 * np.pi * np.sqrt((m * V0**2 / (A * L) + k_v * V0 / A + 1) / (k_p * L / A)) * L / V0
    run = solve_ivp(rate, (0, TURNS * turn), start, method="LSODA", rtol=1e-8, atol=[1e-8 * L, 1e-8, 1e-8])
    late = run.t > 0.6 * run.t[-1]
    return run.status == 0, np.max(np.abs(run.y[1][late] - np.log(V0))) > 0.3


stride = int(sys.argv[1]) if len(sys.argv) > 1 else 1
chosen = list(points())[::stride]
begin = time.process_time()
answers = [oscillates(*p) for p in chosen]
seconds = time.process_time() - begin
print(seconds, len(chosen), sum(not ok for ok, _ in answers), sum(bool(o) for _, o in answers))
