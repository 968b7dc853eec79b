"""Random joints for loops.py, with their mechanism: x' = A x + B w, reading C x, C_v its rate, w what leaves the drive's lag."""
import math

import numpy as np
from loop_laws import LAWS, pick


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
