"""Random friction laws for loops.py, as TOML and linearised: df = f_v v + sum h_i x_i, x_i' = lambda_i x_i + b_i v."""
import math


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
