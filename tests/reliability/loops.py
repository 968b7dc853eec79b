#!/usr/bin/env python3
"""Verdicts of real loops against a monodromy and a count of roots that share nothing with the program.

loops.py PROGRAM JOINTS SEED [KEEP]: writes random joints of every law, model, kind of control and element of a loop as files,
asks PROGRAM (build/tests/reliability/reliability_loops) and compares; joints with a mismatch are kept in KEEP. Compared are
  - sampled loops: ln max|z|/T of the map of one tick, written out tick by tick, with matrix exponentials; sliding by
    the steady curve alike; a look inside and outside each end of each window of stable gains
  - continuous loops: eigenvalues, and behind dead time the number of roots right of a line by the argument principle
The laws are linearised here from their formulas (docs/reference.md), the mechanism is put together here. Needs numpy;
mpmath decides what lies within rounding of the boundary.
"""
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import mpmath
    import numpy as np
except ImportError as missing:
    print(f'skipped: {missing}')
    sys.exit(77)

# --- laws: df = f_v v + sum h_i x_i, x_i' = lambda_i x_i + b_i v ---------------------------------------------------


def pick(r, low, high):
    return low * (high / low) ** r.random()


def law_coulomb_viscous(r, V):
    c, viscous = pick(r, 1, 100), pick(r, 0.1, 100)
    return f'law = "coulomb-viscous"\ncoulomb = {c!r}\nviscous = {viscous!r}\n', viscous, [], c + viscous * V


def law_kinetic_static(r, V):
    c = pick(r, 1, 100)
    return f'law = "kinetic-static"\nkinetic = {c!r}\nstatic = {1.4 * c!r}\n', 0.0, [], c


def law_stribeck(r, V):
    c0, c1, c2 = pick(r, 1, 60), pick(r, 0.1, 50), pick(r, 0.01, 10)
    c3, c4 = V * pick(r, 0.3, 10), pick(r, 0.6, 3)
    part = c2 * math.exp(-((V / c3) ** c4))
    slope = c1 - part * c4 * (V / c3) ** c4 / V
    text = f'law = "stribeck"\nc0 = {c0!r}\nc1 = {c1!r}\nc2 = {c2!r}\nc3 = {c3!r}\nc4 = {c4!r}\n'
    return text, slope, [], c0 + c1 * V + part


def slip_numbers(r):
    n = r.choice([1, 1, 2, 3])
    A = pick(r, 0.2, 3)
    B = [A * pick(r, 0.3, 2.5) / (n if r.random() < 0.5 else 1) for _ in range(n)]
    L = [pick(r, 1e-6, 3e-4) for _ in range(n)]
    return A, B, L, pick(r, 30, 200), pick(r, 1e-4, 1e-2)


def slip_text(name, A, B, L, f0, V_star):
    lists = (repr(B[0]), repr(L[0])) if len(B) == 1 else (repr(B), repr(L))
    return f'law = "{name}"\nf0 = {f0!r}\nA = {A!r}\nB = {lists[0]}\nL = {lists[1]}\nV_star = {V_star!r}\n'


def law_rate_and_state(r, V, name='rate-and-state'):
    A, B, L, f0, V_star = slip_numbers(r)
    # theta' = -(V/L)(theta + B ln(V/V*)); ageing (B/L)(V* exp(-theta/B) - V): the same about steady sliding
    states = [(-V / l, -b / l, 1.0) for b, l in zip(B, L)]
    return slip_text(name, A, B, L, f0, V_star), A / V, states, f0 + (A - sum(B)) * math.log(V / V_star)


def law_ageing(r, V):
    return law_rate_and_state(r, V, 'ageing')


def law_regularised(r, V):
    A, B, L, f0, V_star = slip_numbers(r)
    theta = -sum(B) * math.log(V / V_star)
    # X = V/(2 V*) e^{(f0 + theta)/A} may overflow, its logarithm not: asinh X = ln X + ln(1 + sqrt(1 + X^-2))
    log_X = math.log(V / (2 * V_star)) + (f0 + theta) / A
    root = math.sqrt(1 + math.exp(-2 * log_X))
    share = 1 / root
    states = [(-V / l, -b / l, share) for b, l in zip(B, L)]
    text = slip_text('rate-and-state-regularised', A, B, L, f0, V_star)
    if r.random() < 0.5:
        text += 'evolution = "ageing"\n'
    return text, A * share / V, states, A * (log_X + math.log(1 + root))


def law_dahl(r, V):
    c, sigma0, i = pick(r, 1, 50), pick(r, 1e4, 1e7), r.choice([1, 1, 2, 1.5])
    # z' = V (1 - sigma0 z/F_c)^i at its end z = F_c/sigma0: no b; a state only for i = 1
    states = [(-V * sigma0 / c, 0.0, sigma0)] if i == 1 else []
    return f'law = "dahl"\ncoulomb = {c!r}\nsigma0 = {sigma0!r}\nexponent = {i!r}\n', 0.0, states, c


def law_lugre(r, V):
    c, sigma0, sigma2 = pick(r, 1, 50), pick(r, 1e4, 1e7), pick(r, 0.01, 50)
    s, v_s = c * pick(r, 1.001, 1.6), V * pick(r, 0.4, 10)
    sigma1 = pick(r, 0.1, 1) * math.sqrt(sigma0)
    peak = (s - c) * math.exp(-((V / v_s) ** 2))
    g, slope = c + peak, -2 * V / v_s**2 * peak
    lam, b = -sigma0 * V / g, V * slope / g
    text = (
        f'law = "lugre"\nsigma0 = {sigma0!r}\nsigma1 = {sigma1!r}\nsigma2 = {sigma2!r}\ncoulomb = {c!r}\n'
        f'static = {s!r}\nstribeck_velocity = {v_s!r}\n'
    )
    return text, sigma1 * b + sigma2, [(lam, b, sigma0 + sigma1 * lam)], g + sigma2 * V


def law_maxwell(r, V):
    n = r.choice([1, 2, 3])
    elements = [(pick(r, 1e4, 1e6), pick(r, 0.5, 10)) for _ in range(n)]
    viscous = pick(r, 0.1, 50)
    total = sum(w for _, w in elements)
    text = 'law = "maxwell-slip"\n'
    if r.random() < 0.4:  # slipping for good
        body = f'viscous = {viscous!r}\n'
        f_v, states, level = viscous, [], 1.0
    else:
        C, ratio, v_s = pick(r, 10, 1e4), pick(r, 1.01, 1.5), V * pick(r, 0.4, 8)
        level = 1 + (ratio - 1) * math.exp(-((V / v_s) ** 2))
        slope = -2 * V / v_s**2 * (level - 1)
        # F_i' = C (W_i - F_i/r)/sum W about F_i = W_i r
        states = [(-C / (level * total), C * w * slope / (level * total), 1.0) for _, w in elements]
        f_v = viscous
        body = f'viscous = {viscous!r}\nattraction = {C!r}\nstatic_ratio = {ratio!r}\nstribeck_velocity = {v_s!r}\n'
    rows = ', '.join(f'{{ stiffness = {k!r}, yield = {w!r} }}' for k, w in elements)
    return text + f'elements = [{rows}]\n' + body, f_v, states, total * level + viscous * V


LAWS = [
    law_coulomb_viscous,
    law_kinetic_static,
    law_stribeck,
    law_rate_and_state,
    law_rate_and_state,
    law_ageing,
    law_regularised,
    law_dahl,
    law_lugre,
    law_maxwell,
]

# --- the mechanism: x' = A x + B w, reading C x, C_v its rate, w what leaves the drive's lag -----------------------


def curve_only(f_v, states):
    return f_v + sum(h * b / -lam for lam, b, h in states), []


class Plant:
    pass


def draw(r):
    """A joint as text, with what the oracle needs: a function of (velocity_only) for the plant, and the loop."""
    p = Plant()
    model = r.choice(['single-mass', 'single-mass', 'two-mass', 'three-mass', 'lever'])
    V0 = pick(r, 1e-4, 1e-2)
    scale = r.choice([1, 1, pick(r, 0.8, 1.2)])
    V = V0 / scale
    force = r.random() < 0.15
    p.force = force
    text = {'joint': f'model = "{model}"\n' + ('motion = "revolute"\n' if r.random() < 0.3 else '')}
    k_p, k_v = pick(r, 1e3, 1e6), r.choice([0, pick(r, 1, 1e3), pick(r, 1, 1e3)])
    if r.random() < 0.05:
        k_v = -k_v / 10
    k_c = r.choice([0, 0, pick(r, 1e2, 1e5)])
    force_gain = pick(r, 0.1, 10) if force else 0
    loads = []  # inertia, ratio
    if model == 'single-mass':
        m = pick(r, 0.1, 10)
        text['joint'] += f'inertia = {m!r}\n'
        inertia, ratio, springs, dampers = [m], [1.0], [], []
    elif model == 'two-mass':
        N = r.choice([1, pick(r, 1, 100)])
        M, m = pick(r, 0.1, 3) / N**2, pick(r, 0.1, 3)
        k, c = pick(r, 1e4, 1e7), r.choice([0, pick(r, 1, 300)])
        text['joint'] += f'motor_inertia = {M!r}\nlink_inertia = {m!r}\n'
        text['joint.transmission'] = f'stiffness = {k!r}\ndamping = {c!r}\nratio = {N!r}\n'
        inertia, ratio, springs, dampers = [M * N**2, m], [N, 1.0], [k], [c]
    else:
        lever = model == 'lever'
        N1, N2 = r.choice([1, pick(r, 1, 20)]), r.choice([1, pick(r, 1, 5)])
        N = N1 * N2
        M, mid, m = pick(r, 0.1, 3) / N**2, pick(r, 0.1, 3) / N2**2, pick(r, 0.1, 3)
        side = N if lever else N2  # the first spring stands at the motor's side, or at its own joint side
        k1, c1 = pick(r, 1e4, 1e7), r.choice([0, pick(r, 1, 300)])
        k2, c2 = pick(r, 1e4, 1e7), r.choice([0, pick(r, 1, 300)])
        d = pick(r, 0.1, 2)
        text['joint'] += f'motor_inertia = {M!r}\nlink_inertia = {m!r}\n'
        text['joint'] += f'transmission_inertia = {(mid * d * d if lever else mid)!r}\n'
        if lever:
            text['joint'] += f'lever_arm = {d!r}\n'
        text['joint.motor_transmission'] = (
            f'stiffness = {k1 / side**2!r}\ndamping = {c1 / side**2!r}\nratio = {N1!r}\n'
        )
        text['joint.transmission_link'] = f'stiffness = {k2!r}\ndamping = {c2!r}\nratio = {N2!r}\n'
        inertia, ratio = [M * N**2, mid * N2**2, m], [float(N), float(N2), 1.0]
        springs, dampers = [k1, k2], [c1, c2]
    n = len(inertia)
    # in a force ramp the bodies above a spring slide faster by what stretches it
    speed = [1.0] * n
    if force:
        for i in range(n - 1, 0, -1):
            speed[i - 1] = speed[i] + (k_p + k_c) / springs[i - 1]
    names = ['friction'] if n == 1 else ['friction.motor', 'friction.link']
    if n == 3:
        names = ['friction.motor', 'friction.transmission', 'friction.link']
    frictions, steady = [], 0.0
    for i in range(n):
        own = ratio[i] * speed[i] * V
        toml, f_v, states, level = r.choice(LAWS)(r, own)
        N = ratio[i]
        load = 1.0
        if r.random() < 0.2:
            load = pick(r, 0.5, 2)
            toml += f'normal_load = {load!r}\n'
        # behind a reduction the force is N times as large and its velocity N times as fast
        frictions.append((load * N * N * f_v, [(lam, N * b, load * N * h) for lam, b, h in states]))
        steady += N * load * level
        text[names[i]] = toml
    mu = 0.0
    if n == 1 and r.random() < 0.15:
        mu = r.uniform(0.05, 0.5)
        text['friction'] += f'load_coefficient = {mu!r}\n'
    constant = 0.0
    if r.random() < 0.2:
        constant = -pick(r, 0.1, 20)
        text['load'] = f'constant = {constant!r}\n'
    p.effort = steady / (1 - mu) - constant
    neighbours = []
    if r.random() < 0.12:
        for _ in range(r.choice([1, 2])):
            mk = pick(r, 0.05, 3)
            jk = r.choice([-1, 1]) * r.uniform(0.1, 0.6) * math.sqrt(mk * inertia[-1] / 2)
            neighbours.append((mk, jk, pick(r, 1e2, 1e5), pick(r, 0.1, 300)))
        text['neighbours'] = neighbours
    # --- drive
    gain, drag, lag = 1.0, 0.0, r.choice([0, pick(r, 5e-5, 1e-2)])
    kind = r.choice(['effort', 'effort', 'motor']) if not force else r.choice(['effort', 'effort', 'motor'])
    drive = f'lag = {lag!r}\n' if lag else ''
    if kind == 'effort':
        if r.random() < 0.4:
            gain = pick(r, 0.3, 3) * r.choice([1, 1, 1, -1] if not force else [1])
            drive += f'effort_gain = {gain!r}\n'
        if r.random() < 0.15 and not force:
            sag = p.effort * pick(r, 2, 100)
            drive += f'sag_effort = {sag!r}\n'
            gain *= (1 - p.effort / sag) ** 2
    else:
        k_t, k_e, R = pick(r, 0.5, 5), pick(r, 0.05, 5), pick(r, 0.1, 2)
        drive += f'kind = "dc-motor"\nk_t = {k_t!r}\nk_e = {k_e!r}\nresistance = {R!r}\n'
        gear = r.choice([1, pick(r, 0.5, 2)])
        if gear != 1:
            drive += f'effort_gain = {gear!r}\n'
        gain, drag = gear * k_t / R, gear * k_t * k_e / R
        volts = p.effort * R / (gear * k_t) + k_e * V
        if r.random() < 0.4:
            U = abs(volts) * pick(r, 1.5, 20)
            drive += f'supply_voltage = {U!r}\n'
            if r.random() < 0.5:
                drive += 'signal = "duty"\n'
                gain *= U
    if drive:
        text['actuator'] = drive
    sensor = f'position_scale = {scale!r}\n' if scale != 1 else ''
    # --- loop
    control = f'kind = "{"force" if force else "position"}"\nV0 = {V0!r}\nk_p = {k_p!r}\n'
    if k_v:
        control += f'k_v = {k_v!r}\n'
    if k_c:
        control += f'contact_stiffness = {k_c!r}\n'
    if force:
        control += f'force_gain = {force_gain!r}\n'
    feedback = 'link' if n > 1 and not force and r.random() < 0.5 else 'motor'
    control += f'feedback = "{feedback}"\n'
    p.sampled = r.random() < 0.65
    p.T = pick(r, 2e-5, 5e-3) if p.sampled else None
    unit = p.T or 1e-3
    choice = r.random()
    if choice < 0.25:
        p.delay = 0.0
    elif choice < 0.5:
        p.delay = unit * r.choice([1, 2, 3, 7])
    elif choice < 0.6:
        p.delay = unit * r.choice([0.999999, 1.000001, 1e-6, 0.5])
    else:
        p.delay = unit * pick(r, 0.01, 6)
    reading = p.delay * r.random() if r.random() < 0.2 else 0.0
    late = p.delay - reading
    p.delay = late + reading
    if late:
        control += f'delay = {late!r}\n'
    if reading:
        sensor += f'delay = {reading!r}\n'
    p.tau = r.choice([0, pick(r, 1e-5, 1e-2)])
    p.average = r.choice([1, 1, 2, 3, 8, 50]) if p.sampled else 1
    p.exact = p.sampled and r.random() < 0.2
    if p.sampled:
        control += f'period = {p.T!r}\n'
        control += (
            f'velocity_estimate = {{ form = "{"exact" if p.exact else "backward-difference"}", tau = {p.tau!r}, '
            f'average = {p.average} }}\n'
        )
    elif p.tau:
        control += f'velocity_estimate = {{ tau = {p.tau!r} }}\n'
    p.k_i = 0.0
    p.cascade = None
    if not force:
        if r.random() < 0.2:
            K_pos, K_v = pick(r, 10, 2000), pick(r, 1, 1e3)
            K_i = r.choice([0, pick(r, 10, 1e5)])
            p.cascade = (K_pos, K_v, K_i)
            control = control.replace(f'k_p = {k_p!r}\n', '')
            if k_v:
                control = control.replace(f'k_v = {k_v!r}\n', '')
            control += f'structure = "cascade"\nposition_gain = {K_pos!r}\nvelocity_gain = {K_v!r}\n'
            if K_i:
                control += f'velocity_integral_gain = {K_i!r}\n'
        elif r.random() < 0.3:
            p.k_i = pick(r, 1e2, 1e8)
            control += f'k_i = {p.k_i!r}\n'
    text['control'] = control
    if sensor:
        text['sensor'] = sensor
    p.k_p, p.k_v, p.force_gain = k_p, k_v, force_gain
    p.text = as_toml(text)
    p.open = lambda curve: mechanism(
        inertia, springs, dampers, frictions, neighbours, mu, k_c, (k_p, k_v) if force else None, gain, drag, lag, scale,
        feedback, curve)
    return p


def as_toml(text):
    rest = {k: v for k, v in text.items() if k != 'neighbours'}
    out = ''.join(f'[{k}]\n{v}' for k, v in rest.items())
    for mk, jk, k, c in text.get('neighbours', []):
        out += f'[[neighbour]]\ninertia = {mk!r}\ncoupling = {jk!r}\nk_p = {k!r}\nk_v = {c!r}\n'
    return out


def mechanism(inertia, springs, dampers, frictions, neighbours, mu, k_c, finger, gain, drag, lag, scale, feedback, curve):
    n, q = len(inertia), len(neighbours)
    frictions = [curve_only(*f) if curve else f for f in frictions]
    N = n + q
    M, K, D = np.zeros((N, N)), np.zeros((N, N)), np.zeros((N, N))
    for i in range(n):
        M[i, i] = inertia[i]
        D[i, i] += frictions[i][0]
    for i, (k, c) in enumerate(zip(springs, dampers)):
        e = np.zeros(N)
        e[i], e[i + 1] = 1, -1
        K += k * np.outer(e, e)
        D += c * np.outer(e, e)
    link = n - 1
    for j, (mk, jk, k, c) in enumerate(neighbours):
        M[n + j, n + j] = mk
        M[n + j, link] = jk
        M[link, n + j] = jk * (1 - mu)  # what is no inertia and no friction of its own loses that share
        K[n + j, n + j], D[n + j, n + j] = k, c
    # the loop keeps the share 1 - mu of its effort
    share = 1 - mu
    K[link, link] += k_c * (share if n == 1 else 1)
    if finger:
        K[link, link] += finger[0] * (share if n == 1 else 1)
        D[link, link] += finger[1] * (share if n == 1 else 1)
    D[0, 0] += drag * share
    states = [(i, s) for i in range(n) for s in frictions[i][1]]
    size = 2 * N + len(states) + (1 if lag else 0)
    A, B = np.zeros((size, size)), np.zeros(size)
    inv = np.linalg.inv(M)
    A[:N, N:2 * N] = np.eye(N)
    A[N:2 * N, :N] = -inv @ K
    A[N:2 * N, N:2 * N] = -inv @ D
    for j, (i, (lam, b, h)) in enumerate(states):
        A[2 * N + j, 2 * N + j] = lam
        A[2 * N + j, N + i] = b
        A[N:2 * N, 2 * N + j] -= inv[:, i] * h
    push = inv[:, 0] * share * gain
    if lag:
        A[N:2 * N, size - 1] = push
        A[size - 1, size - 1] = -1 / lag
        B[size - 1] = 1 / lag
    else:
        B[N:2 * N] = push
    C, C_v = np.zeros(size), np.zeros(size)
    if finger:
        C[link], C_v[link] = finger[0] + k_c, 0
        C[N + link] = finger[1]
    else:
        at = link if feedback == 'link' else 0
        C[at], C_v[N + at] = scale, scale
    return A, B, C, C_v


# --- controllers: u = -(K_p y + K_v v + K_i sum y + K_t sum v) -----------------------------------------------------


def gains(p, g):
    """With the gain that windows are given in changed to g (None: as in the file)."""
    if p.force:
        return p.force_gain if g is None else g, 0.0, 0.0, 0.0
    if p.cascade:
        K_pos, K_v, K_i = p.cascade
        if g is not None:
            K_pos = g
        # K_v (K_pos e + e') + K_i * integral of (K_pos e + e'), the last by the estimate, whose sum is the position
        # where nothing filters it
        if p.tau == 0 and p.average == 1 and not p.exact:
            return K_v * K_pos + K_i, K_v, K_i * K_pos, 0.0
        return K_v * K_pos, K_v, K_i * K_pos, K_i
    return p.k_p if g is None else g, p.k_v, p.k_i, 0.0


def tick_map(p, plant, g, lib=np):
    """The map from one tick to the next, column by column from the controller written out."""
    A, B, C, C_v = plant
    K_p, K_v, K_i, K_t = gains(p, g)
    n = len(B)
    ticks = p.delay / p.T
    whole = int(math.floor(ticks + 1e-12))
    part = ticks - whole if ticks - whole > 1e-12 else 0.0
    held = whole + (1 if part else 0)
    if lib is np:
        E0, F0 = flow(A, B, part * p.T)
        E1, F1 = flow(A, B, (1 - part) * p.T)
    else:
        E0, F0 = exact_flow(A, B, mpmath.mpf(part) * p.T)
        E1, F1 = exact_flow(A, B, (1 - mpmath.mpf(part)) * p.T)
    # memory: x, the last `average` readings, v, the integral's share, commands (newest first)
    size = n + p.average + 2 + held
    X = np.eye(size) if lib is np else np.array([[mpmath.mpf(int(i == j)) for j in range(size)] for i in range(size)])
    x, at = X[:n], n
    readings = [X[at + i] for i in range(p.average)]
    at += p.average
    v, share = X[at], X[at + 1]
    old = [X[at + 2 + i] for i in range(held)]
    y = C @ x
    if p.exact:
        v = C_v @ x
    else:
        fresh = [y] + readings[:-1]
        d = (sum(fresh) - sum(readings)) / p.average / p.T
        v = v + p.T / (p.tau + p.T) * (d - v)
    share = share + p.T * (K_i * y + K_t * v)
    u = -(K_p * y + K_v * v + share)
    line = [u] + old
    if part:
        x = E0 @ x + np.outer(F0, line[whole + 1])
        x = E1 @ x + np.outer(F1, line[whole])
    else:
        x = E1 @ x + np.outer(F1, line[whole])
    rows = [x] + [np.array([y] + readings[:-1])] + [np.array([v, share])]
    if held:
        rows.append(np.array(line[:held]))
    M = np.concatenate(rows)
    # what nobody reads is no part of the loop
    dead = []
    at = n
    if p.exact or (K_v == 0 and K_t == 0):
        dead += list(range(at, at + p.average)) + [at + p.average]
    if K_i == 0 and K_t == 0:
        dead.append(at + p.average + 1)
    live = [i for i in range(size) if i not in dead]
    return M[np.ix_(live, live)]


def flow(A, B, h):
    """e^{Ah} and its integral on B, by scaling, a Taylor series and squaring of the extended matrix."""
    n = len(B)
    W = np.zeros((n + 1, n + 1))
    W[:n, :n], W[:n, n] = A * h, B * h
    d = np.ones(n + 1)
    for _ in range(40):  # balance by powers of two
        for i in range(n):
            c = np.abs(W[:, i]).sum() - abs(W[i, i])
            row = np.abs(W[i]).sum() - abs(W[i, i])
            if c > 0 and row > 0:
                f = 2.0 ** round(math.log2(row / c) / 2)
                W[:, i] *= f
                W[i] /= f
                d[i] *= f
    k = max(0, math.ceil(math.log2(max(np.abs(W).sum(1).max(), 1e-300) / 0.25)))
    W = W / 2.0**k
    E, term = np.eye(n + 1), np.eye(n + 1)
    for i in range(1, 16):
        term = term @ W / i
        E = E + term
    for _ in range(k):
        E = E @ E
    E = d[:, None] * E / d[None, :]
    return E[:n, :n], E[:n, n]


def exact_flow(A, B, h):
    n = len(B)
    W = mpmath.zeros(n + 1)
    for i in range(n):
        for j in range(n):
            W[i, j] = A[i, j] * h
        W[i, n] = B[i] * h
    E = mpmath.expm(W, method='taylor')
    out = np.array([[E[i, j] for j in range(n + 1)] for i in range(n)])
    return out[:, :n], out[:, n]


def balanced(M):
    size = np.abs
    M = M.copy()
    for _ in range(30):
        for i in range(len(M)):
            c, row = size(M[:, i]).sum() - abs(M[i, i]), size(M[i]).sum() - abs(M[i, i])
            if c > 0 and row > 0:
                f = 2.0 ** round(math.log2(row / c) / 2)
                M[:, i] *= f
                M[i] /= f
    return M


def sampled_growth(p, plant, g, exact=False):
    if exact:
        with mpmath.workdps(50):
            mp = tuple(np.array([[mpmath.mpf(v) for v in row] for row in m]) if m.ndim == 2 else
                       np.array([mpmath.mpf(v) for v in m]) for m in plant)
            M = tick_map(p, mp, g, mpmath)
            z = mpmath.eig(mpmath.matrix(M.tolist()), left=False, right=False)
            return float(mpmath.log(max(abs(v) for v in z)) / p.T)
    M = tick_map(p, plant, g)
    if not np.isfinite(M).all():
        return math.nan
    return math.log(np.abs(np.linalg.eigvals(balanced(M))).max()) / p.T


def late_system(p, plant, g):
    """s -> A0 + A_d e^{-s delay}: plant, filter, integrals."""
    A, B, C, C_v = plant
    K_p, K_v, K_i, K_t = gains(p, g)
    n = len(B)
    extra = 0
    filtered = p.tau > 0 and (K_v != 0 or K_t != 0)
    size = n + (1 if filtered else 0) + (1 if K_i else 0)
    A0 = np.zeros((size, size))
    A0[:n, :n] = A
    reading = np.zeros(size)
    reading[:n] = C
    velocity, travelled = np.zeros(size), reading.copy()
    velocity[:n] = C_v
    at = n
    if filtered:  # F' = (y - F)/tau: the estimate is F', its integral F
        velocity = reading / p.tau
        velocity[at] = -1 / p.tau
        A0[at] = velocity
        travelled = np.zeros(size)
        travelled[at] = 1
        at += 1
    total = np.zeros(size)
    if K_i:
        A0[at] = reading
        total[at] = 1
    command = -(K_p * reading + K_v * velocity + K_i * total + K_t * travelled)
    wide = np.zeros(size)
    wide[:n] = B
    return A0, np.outer(wide, command)


def late_growth(p, plant, g):
    A0, Ad = late_system(p, plant, g)
    return np.linalg.eigvals(balanced(A0 + Ad)).real.max()


def roots_right_of(p, plant, g, sigma):
    """By the argument principle on Re s = sigma; None where the line runs through a root."""
    A0, Ad = late_system(p, plant, g)
    n = len(A0)
    bound = np.abs(np.linalg.eigvals(balanced(A0))).max()
    size = max(bound, np.abs(np.linalg.eigvals(balanced(A0 + Ad))).max(), np.abs(np.linalg.eigvals(balanced(A0 - Ad))).max())
    scale = np.ones(n)
    W = np.abs(A0) + np.abs(Ad)
    for _ in range(30):
        for i in range(n):
            c, row = W[:, i].sum() - W[i, i], W[i].sum() - W[i, i]
            if c > 0 and row > 0:
                f = 2.0 ** round(math.log2(row / c) / 2)
                W[:, i] *= f
                W[i] /= f
                scale[i] *= f
    A0 = A0 * scale[None, :] / scale[:, None]
    Ad = Ad * scale[None, :] / scale[:, None]
    eye = np.eye(n)

    def chi(w):
        s = sigma + 1j * w
        S = s[:, None, None] * eye - A0 - Ad * np.exp(-s * p.delay)[:, None, None]
        sign, log = np.linalg.slogdet(S)
        return sign

    top = 1e4 * size * (1 + math.exp(-sigma * p.delay))
    w = np.concatenate([[0.0], np.geomspace(1e-9 * size, top, 3000)])
    if p.delay:
        w = np.unique(np.concatenate([w, np.arange(0, min(top, 400 / p.delay), 0.05 / p.delay)]))
    value = chi(w)
    for _ in range(40):
        turn = np.angle(value[1:] / value[:-1])
        wide = np.abs(turn) > 0.35
        if not wide.any():
            break
        if wide.sum() > 200000:
            return None
        i = np.nonzero(wide)[0]
        between = 0.5 * (w[i] + w[i + 1])
        w = np.insert(w, i + 1, between)
        value = np.insert(value, i + 1, chi(between))
    else:
        return None
    turned = np.angle(value[1:] / value[:-1]).sum()
    # beyond the top each factor s of chi has turned to i: chi(i oo) has the phase n pi/2, chi(sigma) is real
    count = (n * math.pi / 2 - turned - np.angle(np.exp(1j * n * math.pi / 2) / value[-1])) / math.pi
    return round(count) if abs(count - round(count)) < 0.05 else None


# --- comparison ----------------------------------------------------------------------------------------------------


class Count:
    def __init__(self):
        self.joints = self.verdicts = self.growths = self.curves = self.ends = self.gains = 0
        self.skipped, self.wrong, self.kinds = {}, [], {}

    def skip(self, why):
        self.skipped[why] = self.skipped.get(why, 0) + 1


def stable(p, plant, g, own_growth=None):
    """True, False, or None within rounding of the boundary."""
    if p.sampled:
        growth = sampled_growth(p, plant, g)
        if not math.isfinite(growth):
            return None
        if abs(growth) * p.T < 1e-9:
            growth = sampled_growth(p, plant, g, exact=True)
            if abs(growth) * p.T < 1e-13:
                return None
        return growth < 0
    if p.delay == 0:
        growth = late_growth(p, plant, g)
        A0, Ad = late_system(p, plant, g)
        if abs(growth) < 1e-11 * np.abs(np.linalg.eigvals(A0 + Ad)).max():
            return None
        return growth < 0
    count = roots_right_of(p, plant, g, 0.0)
    return None if count is None else count == 0


def compare(p, told, count, problems):
    if 'error' in told:
        problems.append('error: ' + told['error'])
        return
    if told['reason'] != 0:
        count.skip(f'no verdict, reason {told["reason"]}')
        return
    count.joints += 1
    kind = ('force ' if p.force else '') + ('sampled' if p.sampled else 'late' if p.delay else 'continuous')
    count.kinds[kind] = count.kinds.get(kind, 0) + 1
    plant, curve = p.open(False), p.open(True)
    for name, of, growth in (('growth', plant, told['growth']), ('curve', curve, told['velocity_only_growth'])):
        if growth is None:
            count.skip('no ' + name)
            continue
        if p.sampled:
            own = sampled_growth(p, of, None)
            unit = 1e-3 / p.T
            if abs(own - growth) > 1e-6 * (abs(own) + unit):
                own = sampled_growth(p, of, None, exact=True)
            if abs(own - growth) > 1e-6 * (abs(own) + unit):
                problems.append(f'{name} {growth} is {own}')
        elif p.delay == 0:
            own = late_growth(p, of, None)
            size = np.abs(np.linalg.eigvals(sum(late_system(p, of, None)))).max()
            if abs(own - growth) > 1e-7 * abs(own) + 1e-9 * size:
                problems.append(f'{name} {growth} is {own}')
        else:
            size = np.abs(np.linalg.eigvals(sum(late_system(p, of, None)))).max()
            step = 1e-5 * abs(growth) + 1e-8 * size
            right, left = (roots_right_of(p, of, None, growth + k * step) for k in (1, -1))
            if right is None or left is None:
                count.skip('line through a root')
                continue
            if right != 0 or left == 0:
                problems.append(f'{name} {growth}: {right} roots right of it, {left} with it')
        count.growths += 1
    if told['stable'] != (told['growth'] < 0):
        problems.append('verdict and growth')
    if told['point_growth'] is not None and abs(told['point_growth'] - told['growth']) > 1e-9 * abs(told['growth']):
        problems.append('row of a sweep')
    count.verdicts += 1
    if p.force:
        return
    windows, to = told['windows'], told['searched_to'] or math.inf
    if p.cascade:  # told in k_p = K_v K_pos + K_i, looked at here over K_pos
        K_v, K_i = p.cascade[1:]
        windows = [(max(0, (low - K_i) / K_v), high and (high - K_i) / K_v) for low, high in windows]
        to = (to - K_i) / K_v
    own_gain = p.cascade[0] if p.cascade else p.k_p
    if told['doubtful']:
        count.skip('doubtful bands')
    looks = []
    edge = 1e-6
    for low, high in windows:
        if low > 0:
            looks += [(low * (1 - edge), None), (low * (1 + edge), True)]
        if high is not None:
            looks += [(high * (1 - edge), True), (high * (1 + edge), None)]
        count.ends += (low > 0) + (high is not None)
    for k in range(4):
        looks.append((own_gain * 10 ** ((k - 1.5) * 0.8), None))
    for g, _ in looks:
        if g >= to:
            continue
        inside = any(low < g < (high or math.inf) for low, high in windows)
        truth = stable(p, plant, g)
        if truth is None:
            count.skip('gain within rounding')
            continue
        count.gains += 1
        if truth != inside:
            problems.append(f'gain {g!r} is {"stable" if truth else "unstable"}, windows {windows}')


def main():
    program, joints, seed = sys.argv[1], int(sys.argv[2]), int(sys.argv[3])
    keep = Path(sys.argv[4]) if len(sys.argv) > 4 else None
    count = Count()
    with tempfile.TemporaryDirectory() as folder:
        drawn = []
        for i in range(joints):
            p = draw(random.Random(f'{seed} {i}'))
            p.path = Path(folder) / f'{i}.toml'
            p.path.write_text(p.text)
            drawn.append(p)
        answer = subprocess.run([program], input='\n'.join(str(p.path) for p in drawn) + '\n', text=True,
                                stdout=subprocess.PIPE, check=True).stdout
        for i, (p, line) in enumerate(zip(drawn, answer.splitlines(), strict=True)):
            problems = []
            compare(p, json.loads(line), count, problems)
            if problems:
                count.wrong.append(i)
                if len(count.wrong) <= 20:
                    print(f'MISMATCH joint {i} of seed {seed}:', '; '.join(problems[:3]), flush=True)
                if keep:
                    keep.mkdir(exist_ok=True, parents=True)
                    (keep / f'{seed}-{i}.toml').write_text(p.text)
    print(f'{count.joints} joints ({", ".join(f"{v} {k}" for k, v in sorted(count.kinds.items()))}), {count.growths} growth '
          f'rates, {count.ends} ends of windows, {count.gains} gains, {len(count.wrong)} joints with a mismatch')
    print('not compared:', ', '.join(f'{k} {v}' for k, v in sorted(count.skipped.items())) or 'nothing')
    return 1 if count.wrong else 0


if __name__ == '__main__':
    sys.exit(main())
