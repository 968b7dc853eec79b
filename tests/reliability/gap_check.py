#!/usr/bin/env python3
"""How often a check of a gap is wrong: fresh noise on an unchanged joint must pass, a Coulomb level that is 10 % higher must not.

Run: gap_check.py PROGRAM [REPEATS] [FIRST_SEED] [documented|gap]. Two joints, or one of them: one that moves as documented when the baseline is made, one whose
Coulomb level is 20 % above its document then, so that the baseline has a gap. Prints one line a question, with the bound that the
count leaves at 95 % confidence (Clopper and Pearson 1934), the count so far every tenth repeat, and ends with 1 where a promise is broken: a regression in fresh
noise, or fewer than 95 % found.
"""
import math
import pathlib
import subprocess
import sys
import tempfile

JOINT = """[joint]
motion = "revolute"
inertia = 0.3
[control]
k_p = 400
k_v = 20
period = 2e-3
velocity_estimate = { form = "backward-difference", tau = 0.003 }
[friction]
law = "coulomb-viscous"
coulomb = 1.0
viscous = 0.3
[sensor]
encoder_quantum = 1e-5
position_noise = 5e-5
effort_noise = 0.02
"""
MOTIONS = {"rounds": lambda t: 0.5 * (1 - math.cos(3 * t)), "turns": lambda t: 0.3 * math.sin(1.1 * t) + 0.05 * math.sin(7 * t)}
SECONDS, PERIOD = 8, 2e-3


def run(*words):
    return subprocess.run([str(w) for w in words], capture_output=True, text=True)


def records(program, folder, coulomb, seed):
    """A folder of records with fresh noise."""
    made = folder / f"records-{coulomb}-{seed}"
    made.mkdir()
    for number, name in enumerate(MOTIONS):
        out = folder / "one"
        done = run(program, "simulate", folder / "joint.toml", "--reference", folder / f"{name}.csv", "--set",
                   f"friction.coulomb={coulomb}", "--seed", 2 * seed + number, "-o", out)
        assert done.returncode == 0, done.stderr
        (out / "record.csv").rename(made / f"{name}.csv")
    return made


def failures(program, folder, baseline, coulomb, seeds):
    """How many checks report a regression, and what they say."""
    failed, said = 0, {}
    for number, seed in enumerate(seeds):
        if number % 10 == 0 and number:
            print(f"    {failed} of {number}", flush=True)
        made = records(program, folder, coulomb, seed)
        done = run(program, "check", folder / "joint.toml", made, baseline, "--threads", 1)
        assert done.returncode in (0, 1), done.stderr
        failed += done.returncode
        for line in done.stdout.splitlines():
            if line.startswith("FAIL"):
                kind = line[5:45]
                said[kind] = said.get(kind, 0) + 1
        for file in made.iterdir():
            file.unlink()
    return failed, said


def beta_bound(count, total, upper):
    """End of the 95 % interval of Clopper and Pearson on one side, by bisection on the binomial sum."""
    def tail(p):
        terms = range(0, count + 1) if upper else range(count, total + 1)
        return sum(math.comb(total, k) * p**k * (1 - p) ** (total - k) for k in terms)
    if upper and count == total or not upper and count == 0:
        return float(upper)
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = (low + high) / 2
        if (tail(middle) > 0.05) == upper:
            low = middle
        else:
            high = middle
    return (low + high) / 2


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    repeats = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1000
    broken = False
    with tempfile.TemporaryDirectory() as room:
        folder = pathlib.Path(room)
        (folder / "joint.toml").write_text(JOINT)
        for name, at in MOTIONS.items():
            rows = "".join(f"{k * PERIOD:.4f},{at(k * PERIOD):.9f}\n" for k in range(round(SECONDS / PERIOD)))
            (folder / f"{name}.csv").write_text("time,reference_position\n" + rows)
        only = sys.argv[4] if len(sys.argv) > 4 else "documented gap"
        for what, level in [(what, level) for what, level in (("as documented", 1.0), ("with a gap", 1.2)) if what.split()[-1] in only]:
            baseline = folder / f"baseline-{level}.json"
            stored = run(program, "check", folder / "joint.toml", records(program, folder, level, first - 1), baseline, "--update")
            assert stored.returncode == 0, stored.stderr
            print(f"baseline {what}: {stored.stdout.strip().rsplit('.json: ')[-1]}", flush=True)
            seeds = range(first, first + repeats)
            wrong, said = failures(program, folder, baseline, level, seeds)
            print(f"  fresh noise: {wrong} regressions in {repeats} repeats (at most {beta_bound(wrong, repeats, True):.1%}) {said or ''}", flush=True)
            found, said = failures(program, folder, baseline, round(1.1 * level, 6), seeds)
            print(f"  Coulomb level 10 % higher: found in {found} of {repeats} (at least {beta_bound(found, repeats, False):.1%})", flush=True)
            broken |= wrong > 0 or found < 0.95 * repeats
    return int(broken)


if __name__ == "__main__":
    sys.exit(main())
