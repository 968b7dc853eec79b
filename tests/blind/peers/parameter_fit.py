#!/usr/bin/env python3
"""A rival: fits inertia, friction, offset, load, gravity and dead time of the whole loop at once by CMA-ES, as PACE does
(Bjelonic et al. 2025), and names the number that matters most. Run: parameter_fit.py CASES ANSWERS.json [GENERATIONS]

The loop of the joint file is simulated along each reference with Coulomb and viscous friction, at the loop's own ticks
(loop.c); the objective is the mean square of the position error in noise floors. CMA-ES follows Hansen, "The CMA Evolution
Strategy: A Tutorial" (2016), with default constants and a fixed seed. Every fitted number is then put back to its document, one at
a time: the causes are those whose return costs most. The fit has no name for anything else.
"""
import ctypes
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

from cases import answer, answer_all

NAMES = ("inertia", "viscous", "coulomb-level", "sensor-offset", "constant-load", "gravity", "delay")
QUIET, NAMED, PARTNER = 1.25, 0.5, 0.2  # gap in floors; share explained; share that a second must cost


class Law(ctypes.Structure):
    _fields_ = [(name, ctypes.c_double) for name in ("tick", "k_p", "k_v", "filtered", "limit", "gain", "phase")]


def compiled():
    """loop.c as a function; cc makes it anew in every run."""
    source, library = pathlib.Path(__file__).with_name("loop.c"), pathlib.Path(tempfile.mkdtemp()) / "loop.so"
    subprocess.run(["cc", "-O2", "-shared", "-fPIC", str(source), "-o", str(library), "-lm"], check=True)
    misfit = ctypes.CDLL(str(library)).misfit
    misfit.restype = ctypes.c_double
    return misfit


def pointer(values):
    return values.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


class Motion:
    """One record as the loop follows it: references at its ticks, and readings at its rows."""

    def __init__(self, joint, record):
        step = np.median(np.diff(record.time))
        self.every = max(1, int(round(step / joint.period))) if joint.period else 1
        tick, self.rows = step / self.every, len(record.time)
        at, time = np.arange(self.rows * self.every) * tick, record.time - record.time[0]
        self.reference = np.interp(at, time, record.reference_position)
        rate = np.zeros(len(at))
        if joint.with_rate:
            logged = record.reference_velocity
            rate = np.interp(at, time, logged) if logged is not None else np.gradient(self.reference, tick)
        self.rate, self.measured = np.ascontiguousarray(rate), np.ascontiguousarray(record.position)
        self.law = Law(tick, joint.k_p, joint.k_v, tick / (joint.tau + tick), min(joint.limit, 1e300), joint.gain, joint.phase)

    def misfit(self, function, numbers):
        return function(ctypes.byref(self.law), pointer(numbers), pointer(self.reference), pointer(self.rate),
                        pointer(self.measured), self.rows, self.every)


class Objective:
    def __init__(self, joint, records):
        used = [r for r in records if r.reference_position is not None]
        if not used:
            raise ValueError("no reference was logged")
        self.motions, self.function = [Motion(joint, r) for r in used], FUNCTION
        third = np.concatenate([np.diff(r.position, 3) for r in used])
        self.noise = max(joint.noise, np.median(np.abs(third)) / 0.6745 / np.sqrt(20), 1e-12)
        span = max(np.ptp(r.position) for r in used)
        effort = joint.coulomb + joint.gravity + joint.k_p * span * 0.02
        self.documented = np.array([joint.inertia, joint.viscous, joint.coulomb, 0, joint.load, joint.gravity, 0])
        self.usual = np.array([0.2 * joint.inertia, 0.5 * joint.viscous + 1e-3, 0.3 * joint.coulomb + 1e-3 * effort, 0.01 * span,
                               0.2 * effort, 0.2 * max(joint.gravity, effort), 2e-3])

    def numbers(self, x):
        p = self.documented + x * self.usual
        for i in (0, 1, 2, 6):
            p[:, i] = np.abs(p[:, i])
        p[:, 0] = np.maximum(p[:, 0], 0.05 * self.documented[0])
        return p

    def __call__(self, x):
        """Mean square of the position error over that of noise, of every candidate."""
        rows = sum(m.rows for m in self.motions)
        value = np.array([sum(m.rows * m.misfit(self.function, np.ascontiguousarray(p)) for m in self.motions) / rows
                          for p in self.numbers(x)]) / self.noise ** 2
        return np.where(np.isfinite(value), value, 1e30)


def cma_es(objective, start, generations, seed):
    """Least log of the objective; Hansen 2016, figure 6."""
    rng, n = np.random.default_rng(seed), len(start)
    lam = 4 + int(3 * np.log(n))
    lam *= 2
    mu = lam // 2
    w = np.log(mu + 0.5) - np.log(np.arange(1, mu + 1))
    w /= w.sum()
    mu_eff = 1 / (w ** 2).sum()
    c_sigma, c_c = (mu_eff + 2) / (n + mu_eff + 5), (4 + mu_eff / n) / (n + 4 + 2 * mu_eff / n)
    d_sigma = 1 + 2 * max(0, np.sqrt((mu_eff - 1) / (n + 1)) - 1) + c_sigma
    c_1 = 2 / ((n + 1.3) ** 2 + mu_eff)
    c_mu = min(1 - c_1, 2 * (mu_eff - 2 + 1 / mu_eff) / ((n + 2) ** 2 + mu_eff))
    chi = np.sqrt(n) * (1 - 1 / (4 * n) + 1 / (21 * n * n))
    mean, sigma, C = start.copy(), 0.5, np.eye(n)
    p_sigma, p_c = np.zeros(n), np.zeros(n)
    best, least = mean, np.inf
    for g in range(generations):
        values, B = np.linalg.eigh(C)
        D = np.sqrt(np.maximum(values, 1e-20))
        y = rng.standard_normal((lam, n)) * D @ B.T
        x = mean + sigma * y
        cost = objective(x)
        order = np.argsort(cost)
        if cost[order[0]] < least:
            least, best = cost[order[0]], x[order[0]]
        step = w @ y[order[:mu]]
        mean = mean + sigma * step
        p_sigma = (1 - c_sigma) * p_sigma + np.sqrt(c_sigma * (2 - c_sigma) * mu_eff) * (B @ ((B.T @ step) / D))
        h = np.linalg.norm(p_sigma) / np.sqrt(1 - (1 - c_sigma) ** (2 * (g + 1))) < (1.4 + 2 / (n + 1)) * chi
        p_c = (1 - c_c) * p_c + h * np.sqrt(c_c * (2 - c_c) * mu_eff) * step
        C = (1 - c_1 - c_mu) * C + c_1 * (np.outer(p_c, p_c) + (1 - h) * c_c * (2 - c_c) * C)
        C += c_mu * (y[order[:mu]].T * w) @ y[order[:mu]]
        sigma *= np.exp(c_sigma / d_sigma * (np.linalg.norm(p_sigma) / chi - 1))
    return best, least


def answer_case(joint, records, generations=60):
    if not joint.single:
        raise ValueError("more than one mass, or a motor: not in this model")
    objective = Objective(joint, records)
    before = objective(np.zeros((1, len(NAMES))))[0]
    if np.sqrt(before) < QUIET:
        return answer("no-gap", before=np.sqrt(before), after=np.sqrt(before))
    best, after = cma_es(objective, np.zeros(len(NAMES)), generations, seed=1)
    back = np.tile(best, (len(NAMES), 1))
    back[np.arange(len(NAMES)), np.arange(len(NAMES))] = 0
    gained = max(before - max(after, 1), 1e-12)
    cost = np.clip((objective(back) - after) / gained, 0, 1e6)
    share = 1 - (max(after, 1) - 1) / max(before - 1, 1e-12)
    order = np.argsort(-cost)
    weights = cost / max(cost.sum(), 1e-12)
    first = [NAMES[order[0]]] + [NAMES[i] for i in order[1:2] if cost[i] > PARTNER * cost[order[0]]]
    rest = [[NAMES[i]] for i in order if NAMES[i] not in first][:4]
    sure = float(np.clip(share, 0, 1) * weights[[NAMES.index(n) for n in first]].sum())
    others = [float(np.clip(share, 0, 1) * weights[NAMES.index(n[0])]) for n in rest]
    verdict = "gap" if share > NAMED else "unknown"
    return answer(verdict, [first, *rest], [sure, *others], float(np.sqrt(before)), float(np.sqrt(after)))


FUNCTION = compiled() if __name__ == "__main__" else None

if __name__ == "__main__":
    wanted = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    answer_all(sys.argv[1], sys.argv[2], lambda joint, records: answer_case(joint, records, wanted))
