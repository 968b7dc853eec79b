"""Random joints for loops.py, with their mechanism: x' = A x + B w, reading C x, C_v its rate, w what leaves the drive's lag."""
import math

import numpy as np
from loop_laws import LAWS, pick


def curve_only(f_v, states):
    return f_v + sum(h * b / -lam for lam, b, h in states), []


class Plant:
    """A joint as drawn: its loop, and of its mechanism what mechanism() puts together."""


def draw(r):
    """A joint as text, with what the oracle needs: a function of (velocity_only) for the plant, and the loop."""
    p = Plant()
    model = r.choice(['single-mass', 'single-mass', 'two-mass', 'three-mass', 'lever'])
    V0 = pick(r, 1e-4, 1e-2)
    p.scale = r.choice([1, 1, pick(r, 0.8, 1.2)])
    p.V = V0 / p.scale
    p.force = r.random() < 0.15
    text = {'joint': f'model = "{model}"\n' + ('motion = "revolute"\n' if r.random() < 0.3 else '')}
    p.k_p, p.k_v = pick(r, 1e3, 1e6), r.choice([0, pick(r, 1, 1e3), pick(r, 1, 1e3)])
    if r.random() < 0.05:
        p.k_v = -p.k_v / 10
    p.k_c = r.choice([0, 0, pick(r, 1e2, 1e5)])
    p.force_gain = pick(r, 0.1, 10) if p.force else 0
    {'single-mass': draw_single_mass, 'two-mass': draw_two_masses, 'three-mass': draw_three_masses,
     'lever': draw_lever}[model](r, p, text)
    draw_frictions(r, p, text)
    draw_neighbours(r, p, text)
    draw_drive(r, p, text)
    text['control'], sensor = draw_loop(r, p, V0)
    if sensor:
        text['sensor'] = sensor
    draw_normal(r, p, text)
    p.text = as_toml(text)
    p.open = lambda curve: mechanism(p, curve)
    return p


def draw_single_mass(r, p, text):
    m = pick(r, 0.1, 10)
    text['joint'] += f'inertia = {m!r}\n'
    p.inertia, p.ratio, p.springs, p.dampers = [m], [1.0], [], []


def draw_two_masses(r, p, text):
    N = r.choice([1, pick(r, 1, 100)])
    M, m = pick(r, 0.1, 3) / N**2, pick(r, 0.1, 3)
    k, c = pick(r, 1e4, 1e7), r.choice([0, pick(r, 1, 300)])
    text['joint'] += f'motor_inertia = {M!r}\nlink_inertia = {m!r}\n'
    text['joint.transmission'] = f'stiffness = {k!r}\ndamping = {c!r}\nratio = {N!r}\n'
    p.inertia, p.ratio, p.springs, p.dampers = [M * N**2, m], [N, 1.0], [k], [c]


def draw_three_masses(r, p, text, lever=False):
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
    text['joint.motor_transmission'] = f'stiffness = {k1 / side**2!r}\ndamping = {c1 / side**2!r}\nratio = {N1!r}\n'
    text['joint.transmission_link'] = f'stiffness = {k2!r}\ndamping = {c2!r}\nratio = {N2!r}\n'
    p.inertia, p.ratio = [M * N**2, mid * N2**2, m], [float(N), float(N2), 1.0]
    p.springs, p.dampers = [k1, k2], [c1, c2]


def draw_lever(r, p, text):
    draw_three_masses(r, p, text, lever=True)


def draw_frictions(r, p, text):
    """Friction of every body, the load, and the effort that steady sliding takes."""
    n = len(p.inertia)
    # in a force ramp the bodies above a spring slide faster by what stretches it
    speed = [1.0] * n
    if p.force:
        for i in range(n - 1, 0, -1):
            speed[i - 1] = speed[i] + (p.k_p + p.k_c) / p.springs[i - 1]
    names = {1: ['friction'], 2: ['friction.motor', 'friction.link'],
             3: ['friction.motor', 'friction.transmission', 'friction.link']}[n]
    p.frictions, steady = [], 0.0
    for name, N, v in zip(names, p.ratio, speed):
        toml, f_v, states, level = r.choice(LAWS)(r, N * v * p.V)
        load = 1.0
        if r.random() < 0.2:
            load = pick(r, 0.5, 2)
            toml += f'normal_load = {load!r}\n'
        # behind a reduction the force is N times as large and its velocity N times as fast
        p.frictions.append((load * N * N * f_v, [(lam, N * b, load * N * h) for lam, b, h in states]))
        steady += N * load * level
        p.level = level  # friction per normal load of the link, the last body
        text[name] = toml
    p.mu = 0.0
    if n == 1 and r.random() < 0.15:
        p.mu = r.uniform(0.05, 0.5)
        text['friction'] += f'load_coefficient = {p.mu!r}\n'
    constant = 0.0
    if r.random() < 0.2:
        constant = -pick(r, 0.1, 20)
        text['load'] = f'constant = {constant!r}\n'
    p.effort = steady / (1 - p.mu) - constant


def draw_neighbours(r, p, text):
    p.neighbours = []
    if r.random() < 0.12:
        for _ in range(r.choice([1, 2])):
            mk = pick(r, 0.05, 3)
            jk = r.choice([-1, 1]) * r.uniform(0.1, 0.6) * math.sqrt(mk * p.inertia[-1] / 2)
            p.neighbours.append((mk, jk, pick(r, 1e2, 1e5), pick(r, 0.1, 300)))
        text['neighbours'] = p.neighbours


def draw_drive(r, p, text):
    """What the command becomes at the motor: `gain` and `lag`, and the `drag` of a motor's back-EMF."""
    p.gain, p.drag, p.lag = 1.0, 0.0, r.choice([0, pick(r, 5e-5, 1e-2)])
    kind = r.choice(['effort', 'effort', 'motor'])
    drive = f'lag = {p.lag!r}\n' if p.lag else ''
    drive += draw_motor(r, p) if kind == 'motor' else draw_effort_drive(r, p)
    if drive:
        text['actuator'] = drive


def draw_effort_drive(r, p):
    drive = ''
    if r.random() < 0.4:
        p.gain = pick(r, 0.3, 3) * r.choice([1] if p.force else [1, 1, 1, -1])
        drive += f'effort_gain = {p.gain!r}\n'
    if r.random() < 0.15 and not p.force:
        sag = p.effort * pick(r, 2, 100)
        drive += f'sag_effort = {sag!r}\n'
        p.gain *= (1 - p.effort / sag) ** 2
    return drive


def draw_motor(r, p):
    k_t, k_e, R = pick(r, 0.5, 5), pick(r, 0.05, 5), pick(r, 0.1, 2)
    drive = f'kind = "dc-motor"\nk_t = {k_t!r}\nk_e = {k_e!r}\nresistance = {R!r}\n'
    gear = r.choice([1, pick(r, 0.5, 2)])
    if gear != 1:
        drive += f'effort_gain = {gear!r}\n'
    p.gain, p.drag = gear * k_t / R, gear * k_t * k_e / R
    volts = p.effort * R / (gear * k_t) + k_e * p.V
    if r.random() < 0.4:
        U = abs(volts) * pick(r, 1.5, 20)
        drive += f'supply_voltage = {U!r}\n'
        if r.random() < 0.5:
            drive += 'signal = "duty"\n'
            p.gain *= U
    return drive


def draw_loop(r, p, V0):
    """The tables [control] and [sensor]."""
    control = f'kind = "{"force" if p.force else "position"}"\nV0 = {V0!r}\nk_p = {p.k_p!r}\n'
    if p.k_v:
        control += f'k_v = {p.k_v!r}\n'
    if p.k_c:
        control += f'contact_stiffness = {p.k_c!r}\n'
    if p.force:
        control += f'force_gain = {p.force_gain!r}\n'
    p.feedback = 'link' if len(p.inertia) > 1 and not p.force and r.random() < 0.5 else 'motor'
    control += f'feedback = "{p.feedback}"\n'
    p.sampled = r.random() < 0.65
    p.T = pick(r, 2e-5, 5e-3) if p.sampled else None
    late, reading = draw_delay(r, p)
    if late:
        control += f'delay = {late!r}\n'
    sensor = f'position_scale = {p.scale!r}\n' if p.scale != 1 else ''
    if reading:
        sensor += f'delay = {reading!r}\n'
    control += draw_estimate(r, p)
    return draw_integral(r, p, control), sensor


def draw_delay(r, p):
    """Dead time of the command and of the reading: none, whole ticks, close to whole ones, or any."""
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
    return late, reading


def draw_estimate(r, p):
    p.tau = r.choice([0, pick(r, 1e-5, 1e-2)])
    p.average = r.choice([1, 1, 2, 3, 8, 50]) if p.sampled else 1
    p.exact = p.sampled and r.random() < 0.2
    if p.sampled:
        form = 'exact' if p.exact else 'backward-difference'
        return (f'period = {p.T!r}\nvelocity_estimate = {{ form = "{form}", tau = {p.tau!r}, average = {p.average} }}\n')
    return f'velocity_estimate = {{ tau = {p.tau!r} }}\n' if p.tau else ''


def draw_integral(r, p, control):
    """The text of the control with an integral gain, as a cascade, or as it is."""
    p.k_i, p.cascade = 0.0, None
    if p.force:
        return control
    if r.random() < 0.2:
        K_pos, K_v = pick(r, 10, 2000), pick(r, 1, 1e3)
        K_i = r.choice([0, pick(r, 10, 1e5)])
        p.cascade = (K_pos, K_v, K_i)
        control = control.replace(f'k_p = {p.k_p!r}\n', '')
        if p.k_v:
            control = control.replace(f'k_v = {p.k_v!r}\n', '')
        control += f'structure = "cascade"\nposition_gain = {K_pos!r}\nvelocity_gain = {K_v!r}\n'
        if K_i:
            control += f'velocity_integral_gain = {K_i!r}\n'
    elif r.random() < 0.3:
        p.k_i = pick(r, 1e2, 1e8)
        control += f'k_i = {p.k_i!r}\n'
    return control


def draw_normal(r, p, text):
    """A normal load on the link that moves: (n0 + n1 s + n2 s^2) of its motion, or from the effort of the last spring."""
    p.normal, p.alpha, p.from_load = (0.0, 0.0, 0.0), 0.0, 0.0
    if r.random() > 0.25:
        return
    mu, normal = p.level, ''
    if r.random() < 0.5:
        mu = r.uniform(0.05, 1)
        normal = f'mu = {mu!r}\n'
    p.normal_mu = mu
    if len(p.inertia) > 1 and not p.force and r.random() < 0.4:
        p.from_load = r.choice([-1, 1]) * r.uniform(0.05, 0.4) / mu
        normal += f'from_load = {p.from_load!r}\n'
    else:
        n0, n1, n2 = (r.choice([0, r.choice([-1, 1]) * pick(r, low, high)])
                      for low, high in ((1e2, 1e5), (0.1, 100), (0.001, 0.05)))
        n2 /= mu
        p.normal, p.alpha = (n0, n1, n2), r.choice([0, pick(r, 0.01, 1)]) * mu
        normal += f'displacement = {n0!r}\nvelocity = {n1!r}\nacceleration = {n2!r}\nalpha = {p.alpha!r}\n'
    text['normal'] = normal


def as_toml(text):
    rest = {k: v for k, v in text.items() if k != 'neighbours'}
    out = ''.join(f'[{k}]\n{v}' for k, v in rest.items())
    for mk, jk, k, c in text.get('neighbours', []):
        out += f'[[neighbour]]\ninertia = {mk!r}\ncoupling = {jk!r}\nk_p = {k!r}\nk_v = {c!r}\n'
    return out


def mechanism(p, curve):
    """A, B, C, C_v of the mechanism behind its drive; `curve`: with steady curves in place of the laws."""
    n, N = len(p.inertia), len(p.inertia) + len(p.neighbours)
    link = n - 1
    frictions = [curve_only(*f) if curve else f for f in p.frictions]
    states = [(i, s) for i in range(n) for s in frictions[i][1]]
    M, K, D = bodies(p, [f_v for f_v, _ in frictions])
    if any(p.normal):
        at_once = p.normal_mu - sum(taken_shares(p, states, link))
        K[link, link] += at_once * p.normal[0]
        D[link, link] += at_once * p.normal[1]
        M[link, link] += at_once * p.normal[2]
    size = 2 * N + len(states) + (1 if p.lag else 0)
    A, B = np.zeros((size, size)), np.zeros(size)
    inv = np.linalg.inv(M)
    A[:N, N:2 * N] = np.eye(N)
    A[N:2 * N, :N] = -inv @ K
    A[N:2 * N, N:2 * N] = -inv @ D
    for j, (i, (lam, b, h)) in enumerate(states):
        A[2 * N + j, 2 * N + j] = lam
        A[2 * N + j, N + i] = b
        A[N:2 * N, 2 * N + j] -= inv[:, i] * h
    push = inv[:, 0] * (1 - p.mu) * p.gain
    if p.lag:
        A[N:2 * N, size - 1] = push
        A[size - 1, size - 1] = -1 / p.lag
        B[size - 1] = 1 / p.lag
    else:
        B[N:2 * N] = push
    press_states(p, A, B, states, link, N)
    C, C_v = np.zeros(size), np.zeros(size)
    if p.force:
        C[link], C_v[link] = p.k_p + p.k_c, 0
        C[N + link] = p.k_v
    else:
        at = link if p.feedback == 'link' else 0
        C[at], C_v[N + at] = p.scale, p.scale
    return A, B, C, C_v


def taken_shares(p, states, link):
    """Of each state of the link's friction, the share of alpha that a step of the normal load takes out of it."""
    memory = [h * b / -lam if i == link else 0.0 for i, (lam, b, h) in states]
    whole = sum(memory)
    return [p.alpha * m / whole if whole else 0.0 for m in memory]


def press_states(p, A, B, states, link, N):
    """alpha s/(s - lambda) of the load is alpha less alpha (-lambda)/(s - lambda), which the state holds."""
    n0, n1, n2 = p.normal
    load = n2 * A[N + link]
    load[link] += n0
    load[N + link] += n1
    for j, ((i, (lam, b, h)), share) in enumerate(zip(states, taken_shares(p, states, link))):
        if share:
            A[2 * N + j] += share * -lam / h * load
            B[2 * N + j] += share * -lam / h * n2 * B[N + link]


def bodies(p, slopes):
    """M, K, D of bodies and neighbours: springs, surroundings, finger, and the friction's slope of every body."""
    n, N = len(p.inertia), len(p.inertia) + len(p.neighbours)
    M, K, D = np.zeros((N, N)), np.zeros((N, N)), np.zeros((N, N))
    for i in range(n):
        M[i, i] = p.inertia[i]
        D[i, i] += slopes[i]
    for i, (k, c) in enumerate(zip(p.springs, p.dampers)):
        e = np.zeros(N)
        e[i], e[i + 1] = 1, -1
        # friction of the link that grows with what the last spring carries
        pushed = e - (np.eye(N)[i + 1] * -p.from_load * p.normal_mu if p.from_load and i == n - 2 else 0)
        K += k * np.outer(pushed, e)
        D += c * np.outer(pushed, e)
    link = n - 1
    share = 1 - p.mu  # the loop keeps it of its effort
    for j, (mk, jk, k, c) in enumerate(p.neighbours):
        M[n + j, n + j] = mk
        M[n + j, link] = jk
        M[link, n + j] = jk * share  # what is no inertia and no friction of its own loses the rest
        K[n + j, n + j], D[n + j, n + j] = k, c
    K[link, link] += p.k_c * (share if n == 1 else 1)
    if p.force:
        K[link, link] += p.k_p * (share if n == 1 else 1)
        D[link, link] += p.k_v * (share if n == 1 else 1)
    D[0, 0] += p.drag * share
    return M, K, D
