"""Growth rates and counts of roots for loops.py. Controllers: u = -(K_p y + K_v v + K_i sum y + K_t sum v)."""
import math

import mpmath
import numpy as np


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
    with np.errstate(over='ignore', invalid='ignore'):
        M = tick_map(p, plant, g)
    if not np.abs(M).max() < 1e150:  # sums of it overflow
        return sampled_growth(p, plant, g, exact=True)
    return math.log(np.abs(np.linalg.eigvals(balanced(M))).max()) / p.T


def delayed_system(p, plant, g):
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


def delayed_growth(p, plant, g):
    A0, Ad = delayed_system(p, plant, g)
    return np.linalg.eigvals(balanced(A0 + Ad)).real.max()


def roots_right_of(p, plant, g, sigma):
    """By the argument principle on Re s = sigma; None where the line runs through a root."""
    A0, Ad = delayed_system(p, plant, g)
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
