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
    import mpmath  # for loop_oracle
    import numpy as np
except ImportError as missing:
    print(f'skipped: {missing}')
    sys.exit(77)

from loop_joints import draw
from loop_oracle import delayed_growth, delayed_system, roots_right_of, sampled_growth


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
        growth = delayed_growth(p, plant, g)
        A0, Ad = delayed_system(p, plant, g)
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
    plant = p.open(False)
    for name, of, growth in (('growth', plant, told['growth']), ('curve', p.open(True), told['velocity_only_growth'])):
        if growth is None:
            count.skip('no ' + name)
        else:
            compare_growth(p, name, of, growth, count, problems)
    if told['stable'] != (told['growth'] < 0):
        problems.append('verdict and growth')
    if told['point_growth'] is not None and abs(told['point_growth'] - told['growth']) > 1e-9 * abs(told['growth']):
        problems.append('row of a sweep')
    count.verdicts += 1
    if not p.force:
        compare_windows(p, told, plant, count, problems)


def compare_growth(p, name, of, growth, count, problems):
    if p.sampled:
        def agrees(own):
            return abs(own - growth) <= 1e-6 * (abs(own) + 1e-3 / p.T)

        own = sampled_growth(p, of, None)
        if not agrees(own):
            own = sampled_growth(p, of, None, exact=True)
        if not agrees(own):
            problems.append(f'{name} {growth} is {own}')
        count.growths += 1
        return
    size = np.abs(np.linalg.eigvals(sum(delayed_system(p, of, None)))).max()
    if p.delay == 0:
        own = delayed_growth(p, of, None)
        if abs(own - growth) > 1e-7 * abs(own) + 1e-9 * size:
            problems.append(f'{name} {growth} is {own}')
    else:
        step = 1e-5 * abs(growth) + 1e-8 * size
        right, left = (roots_right_of(p, of, None, growth + k * step) for k in (1, -1))
        if right is None or left is None:
            count.skip('line through a root')
            return
        if right != 0 or left == 0:
            problems.append(f'{name} {growth}: {right} roots right of it, {left} with it')
    count.growths += 1


def compare_windows(p, told, plant, count, problems):
    """A look inside and outside each end of each window of stable gains, and at four gains about the joint's own."""
    windows, to = told['windows'], told['searched_to'] or math.inf
    if p.cascade:  # told in k_p = K_v K_pos + K_i, looked at here over K_pos
        K_v, K_i = p.cascade[1:]
        windows = [(max(0, (low - K_i) / K_v), high and (high - K_i) / K_v) for low, high in windows]
        to = (to - K_i) / K_v
    own_gain = p.cascade[0] if p.cascade else p.k_p
    if told['doubtful']:
        count.skip('doubtful bands')
    looks, edge = [], 1e-6
    for low, high in windows:
        if low > 0:
            looks += [low * (1 - edge), low * (1 + edge)]
        if high is not None:
            looks += [high * (1 - edge), high * (1 + edge)]
        count.ends += (low > 0) + (high is not None)
    looks += [own_gain * 10 ** ((k - 1.5) * 0.8) for k in range(4)]
    for g in (g for g in looks if g < to):
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
    report(count)
    return 1 if count.wrong else 0


def report(count):
    print(f'{count.joints} joints ({", ".join(f"{v} {k}" for k, v in sorted(count.kinds.items()))}), {count.growths} growth '
          f'rates, {count.ends} ends of windows, {count.gains} gains, {len(count.wrong)} joints with a mismatch')
    print('not compared:', ', '.join(f'{k} {v}' for k, v in sorted(count.skipped.items())) or 'nothing')


if __name__ == '__main__':
    sys.exit(main())
