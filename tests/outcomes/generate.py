#!/usr/bin/python3
"""Tables of outcomes from motions that nothing in this repository integrates: m x'' = k_p (V0 t - x) + k_v (V0 - x') - f,
each row started close to rest (a thousandth of V0) and followed until it slides or repeats. LSODA for friction with
memory, a classical Runge-Kutta of all rows at once with sticking for friction without.

    generate.py LAW > outcomes.csv     LAW: slip | ageing | kinetic-static | stribeck
"""
import os
import sys

import numpy
from scipy.integrate import solve_ivp

MASS = 1.0
A, B, L, V_STAR = 1.0, 1.5, 1e-5, 1e-3  # Dupont's reference joint
DROP, LEVEL = 0.25, 60.0                # static above kinetic friction, N
C2, C3 = 0.4, 2e-3                      # Stribeck peak, N, and its velocity, m/s
K_P = numpy.geomspace(8e3, 3e5, 7)
K_V = (0.0, 20.0, 60.0)
V_0 = numpy.geomspace(3e-4, 6e-3, 4)
SWING = 0.5  # of V0: a velocity that swings by more in the end does not slide


def memory_row(k_p, k_v, V0, ageing):
    """The velocity never reaches zero: y = stretch of the spring, ln(v/V0), theta."""
    def rate(_, y):
        v = V0 * numpy.exp(y[1])
        if ageing:  # theta = B ln(age V*/L)
            age = L / V_STAR * numpy.exp(y[2] / B)
            slow = B * (1 / age - v / L)
        else:
            slow = -v / L * (y[2] + B * numpy.log(v / V_STAR))
        force = k_p * y[0] + k_v * (V0 - v) - A * numpy.log(v / V_STAR) - y[2]
        return [V0 - v, force / (MASS * v), slow]

    v = 1e-3 * V0
    friction = (A - B) * numpy.log(v / V_STAR)
    turn = 2 * numpy.pi * numpy.sqrt(MASS / k_p) + 10 * L / V0 + 10 * B / (k_p * V0)
    start = [(friction - k_v * (V0 - v)) / k_p, numpy.log(v / V0), -B * numpy.log(v / V_STAR)]
    for method in ("LSODA", "Radau"):
        run = solve_ivp(rate, (0, 15 * turn), start, method=method, rtol=1e-6, atol=[1e-12, 1e-6, 1e-8])
        if run.success and numpy.all(numpy.isfinite(run.y)):
            break
    else:
        raise RuntimeError(f"no motion at k_p = {k_p}, k_v = {k_v}, V0 = {V0}: {run.message}")
    late = run.t > 0.75 * run.t[-1]
    speed = numpy.exp(run.y[1][late])
    return speed.max() - speed.min() > SWING, (run.y[0][late].max() - run.y[0][late].min()) / 2


def static_rows(k_p, k_v, V0, force_of, static):
    """All rows at once; a row at rest stays while its spring pulls less than the static friction."""
    omega = numpy.sqrt(k_p / MASS)
    h = 0.01 / omega
    x = numpy.full_like(k_p, static) / k_p - k_v * V0 / k_p
    v = numpy.zeros_like(k_p)
    rest = numpy.ones(len(k_p), bool)

    def rate(x, v):
        return V0 - v, (k_p * x + k_v * (V0 - v) - force_of(v)) / MASS

    turns = 80
    # a stick lasts as long as the command needs to wind the spring up again
    waits = numpy.max(2 * (static - LEVEL + 1e-9) / (k_p * V0) * omega) / (2 * numpy.pi)
    steps = int((turns + 8 * min(waits, 200)) * 2 * numpy.pi / 0.01)
    low, high = numpy.full_like(k_p, numpy.inf), numpy.full_like(k_p, -numpy.inf)
    slow, fast = low.copy(), high.copy()
    for step in range(steps):
        pull = k_p * x + k_v * V0
        rest &= pull <= static
        a, b = rate(x, v)
        c, d = rate(x + h / 2 * a, v + h / 2 * b)
        e, f = rate(x + h / 2 * c, v + h / 2 * d)
        g, i = rate(x + h * e, v + h * f)
        moved = x + h / 6 * (a + 2 * c + 2 * e + g), v + h / 6 * (b + 2 * d + 2 * f + i)
        x = numpy.where(rest, x + h * V0, moved[0])
        stops = ~rest & (moved[1] <= 0)
        v = numpy.where(rest | stops, 0, moved[1])
        rest |= stops & (k_p * x + k_v * V0 <= static)
        if step > 0.7 * steps:
            low, high = numpy.minimum(low, x), numpy.maximum(high, x)
            slow, fast = numpy.minimum(slow, v), numpy.maximum(fast, v)
    return (fast - slow) / V0 > SWING, (high - low) / 2


def main(law):
    # LSODA writes its complaints into the table: only what is printed here goes there
    table = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    rows = [(k, c, V) for k in K_P for c in K_V for V in V_0]
    print("# made by an independent simulation of", law, "friction", file=table)
    print("k_p,k_v,V0,outcome,amplitude", file=table)
    if law in ("slip", "ageing"):
        outcomes = [memory_row(*row, law == "ageing") for row in rows]
    else:
        k_p, k_v, V0 = (numpy.array(column) for column in zip(*rows))
        if law == "kinetic-static":
            sticks, amplitude = static_rows(k_p, k_v, V0, lambda v: LEVEL, LEVEL + DROP)
        else:
            sticks, amplitude = static_rows(k_p, k_v, V0, lambda v: LEVEL + C2 * numpy.exp(-(v / C3) ** 2) + 2 * v, LEVEL + C2)
        outcomes = list(zip(sticks, amplitude))
    for (k, c, V), (sticks, amplitude) in zip(rows, outcomes):
        print(f"{k:.6g},{c:g},{V:.6g},{'stick-slip' if sticks else 'stable'},{f'{amplitude:.5g}' if sticks else ''}",
              file=table)


main(sys.argv[1])
