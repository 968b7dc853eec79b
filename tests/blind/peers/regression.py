#!/usr/bin/env python3
"""A rival: a plain regression of what the inverse dynamics get wrong on the obvious feature of each effect.
Run: regression.py CASES ANSWERS.json

Position is differentiated twice by a Savitzky-Golay filter (35 ms, cubic), the documented model gives the effort that the
motion asks for, and the difference to the measured (else the commanded) effort is regressed, on two thirds of the rows,
on one feature at a time and then on two; the share that is explained on the last third ranks them. The controller is a regression
of the command on its own error. Nothing here simulates.
"""
import sys

import numpy as np

from cases import answer, answer_all

WINDOW = 35e-3  # s
NAMED, SECOND, QUIET = 0.5, 0.15, 1.5  # share explained; share of the rest for a second; residual over its noise


def derivatives(position, step):
    """Smoothed position, velocity and acceleration, the smoothing itself, and how much white noise the acceleration has."""
    half = max(3, int(round(WINDOW / step / 2)))
    k = np.arange(-half, half + 1)
    fit = np.linalg.pinv(np.vander(k * step, 4, increasing=True))
    smooth = [np.convolve(position, row[::-1], mode="valid") for row in fit[:3]]
    return smooth[0], smooth[1], 2 * smooth[2], fit[0], 2 * np.sqrt((fit[2] ** 2).sum()), half


def waves(name, phase, flips=None):
    s, c = np.sin(phase), np.cos(phase)
    return name, np.column_stack([s, c] if flips is None else [s * flips, c * flips])


def strongest(residual, grid, of):
    """Frequency at which a wave in `of` takes most of the residual."""
    r = residual - residual.mean()
    power = [abs(np.exp(1j * w * of) @ r) for w in grid]
    return grid[int(np.argmax(power))]


def features(q, v, a, u, t, residual):
    side, speed = np.sign(v), np.percentile(np.abs(v), 95)
    span, thin = np.ptp(q), slice(None, None, max(1, len(q) // 3000))
    places = np.geomspace(4, 400, 120) * np.pi / span
    times = np.geomspace(1, 120, 160)
    n, m = (strongest((residual * f)[thin], places, q[thin]) for f in (np.ones_like(side), side))
    w = strongest(residual[thin], times, t[thin])
    yield "inertia", a[:, None]
    yield "coulomb-level", side[:, None]
    yield "viscous", v[:, None]
    yield "constant-load", np.ones((len(v), 1))
    yield "asymmetric-friction", np.abs(v)[:, None]
    yield "gravity", np.sin(q)[:, None]
    yield "sensor-offset", np.cos(q)[:, None]
    yield "stribeck", (side * np.exp(-(v / (0.1 * speed)) ** 2))[:, None]
    yield "load-dependent-friction", (np.abs(u) * side)[:, None]
    yield "friction-drift", (t * side)[:, None]
    yield "effort-gain", u[:, None]
    yield "delay", np.gradient(u)[:, None]
    yield waves("cogging", n * q)
    yield waves("position-dependent-friction", m * q, side)
    yield waves("periodic-disturbance", w * t)


def explained(columns, residual, fold, floor):
    """Share of the held-out squares beyond the noise that a fit to the other rows takes."""
    x = np.column_stack(columns)
    b = np.linalg.lstsq(x[~fold], residual[~fold], rcond=None)[0]
    left = residual[fold] - x[fold] @ b
    before, noise = residual[fold] @ residual[fold], floor ** 2 * fold.sum()
    return (before - left @ left) / max(before - noise, 0.1 * before)


def audit(joint, records):
    """Gains of the controller, from the command and its own error."""
    rows, commands = [], []
    for r in records:
        if r.effort_command is None or r.reference_position is None or r.velocity is None or r.position is None:
            return []
        rate = r.reference_velocity if joint.with_rate and r.reference_velocity is not None else 0 * r.time
        free = np.abs(r.effort_command) < 0.999 * joint.limit
        rows.append(np.column_stack([r.reference_position - r.position, rate - r.velocity])[free])
        commands.append(r.effort_command[free])
    x, y = np.vstack(rows), np.concatenate(commands)
    k, *_ = np.linalg.lstsq(x, y, rcond=None)
    off = [("gain-k_p", k[0] / joint.k_p - 1), ("gain-k_v", k[1] / joint.k_v - 1 if joint.k_v else 0)]
    misfit = np.std(y - x @ k) / np.std(y)
    return [name for name, part in off if abs(part) > max(0.01, 5 * misfit)]


def dynamics(joint, records):
    """Rows of all records: motion, effort, and what the documented model misses."""
    parts, floors = [], []
    for r in records:
        effort = r.effort_measured if r.effort_measured is not None else None
        if effort is None and r.effort_command is not None:
            effort = joint.gain * r.effort_command
        if effort is None or r.position is None:
            raise ValueError("no effort was logged")
        step = np.median(np.diff(r.time))
        q, v, a, weights, amplified, half = derivatives(r.position, step)
        smooth, t = np.convolve(effort, weights[::-1], mode="valid"), r.time[half:-half] - r.time[0]
        asked = (joint.inertia * a + joint.coulomb * np.sign(v) + joint.viscous * v +
                 joint.gravity * np.sin(q + joint.phase) - joint.load)
        # where the window holds a reversal, the smoothed model is not the model of the smoothed motion
        still = np.abs(v) < 0.03 * np.percentile(np.abs(v), 95)
        moving = np.convolve(still, np.ones(2 * half + 1), mode="same") < 0.5
        parts.append(np.column_stack([q, v, a, smooth, t, smooth - asked])[moving])
        noise = max(joint.noise, np.median(np.abs(np.diff(r.position, 3))) / 0.6745 / np.sqrt(20))
        floors.append(np.hypot(joint.inertia * amplified * noise, joint.effort_noise * np.sqrt((weights ** 2).sum())))
    return np.vstack(parts), max(floors)


def answer_case(joint, records):
    if not joint.single:
        raise ValueError("more than one mass, or a motor: not in this model")
    found = audit(joint, records)
    rows, floor = dynamics(joint, records)
    q, v, a, u, t, residual = rows.T
    fold = np.arange(len(residual)) * 12 // len(residual) % 3 == 2
    size = np.sqrt(np.mean(residual ** 2))
    single = {name: x for name, x in features(q, v, a, u, t, residual)}
    share = {name: explained([x], residual, fold, floor) for name, x in single.items()}
    order = sorted(share, key=share.get, reverse=True)
    if found:
        return answer("gap", [found, *[[n] for n in order[:4]]], [0.9, *[0.02] * 4])
    if floor > 0 and size < QUIET * floor:
        return answer("no-gap")
    if share[order[0]] < NAMED:
        return answer("unknown", [[n] for n in order[:5]], [max(0.0, share[n]) / 5 for n in order[:5]])
    best = order[0]
    pairs = {n: explained([single[best], single[n]], residual, fold, floor) for n in order[1:]}
    partner = max(pairs, key=pairs.get)
    first = [best]
    if pairs[partner] - share[best] > SECOND * max(1e-9, 1 - share[best]) and pairs[partner] - share[best] > 0.1:
        first.append(partner)
    rest = [[n] for n in order if n != best][:4]
    sure = min(0.95, pairs[partner] if len(first) > 1 else share[best])
    after = size * np.sqrt(max(0.0, 1 - sure))
    return answer("gap", [first, *rest], [sure, *[(1 - sure) / 5] * len(rest)], size, after)


if __name__ == "__main__":
    answer_all(sys.argv[1], sys.argv[2], answer_case)
