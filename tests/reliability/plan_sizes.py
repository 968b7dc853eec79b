#!/usr/bin/env python3
"""Does `plan` predict what `diagnose` finds? Run: plan_sizes.py STICKSLIP JOINT TRAJECTORY [SEEDS [EFFECT…]]

For effects that are one number of the joint file, blind cases of that number are simulated along the trajectory over a grid of
sizes, in steps of a quarter, about the least one that `plan` predicts. The least size that is found is where at least half of the seeds
are named, by the effect or by one that the diagnosis cannot distinguish from it, located by bisection on the grid. Prints both and their
ratio; ends with 1 where a ratio is beyond 1.5 either way.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

PROGRAM, JOINT, TRAJECTORY = sys.argv[1:4]
SEEDS = int(sys.argv[4]) if len(sys.argv) > 4 else 3
STEP, WIDEST, AGREES = 1.25, 8, 1.5
# effect: path of its number, and how a size changes it
NUMBERS = {
    "coulomb-level": ("friction.coulomb", lambda x, size: x + size),
    "viscous": ("friction.viscous", lambda x, size: x + size),
    "constant-load": ("load.constant", lambda x, size: x + size),
    "inertia": ("joint.inertia", lambda x, size: x * (1 + size)),
    "effort-gain": ("actuator.effort_gain", lambda x, size: x * (1 + size)),
    "delay": ("control.delay", lambda x, size: x + size),
    "actuator-lag": ("actuator.lag", lambda x, size: x + size),
}


def run(*arguments):
    return subprocess.run([PROGRAM, *map(str, arguments)], check=True, capture_output=True, text=True).stdout


def documented(path, joint):
    table, key = path.split(".")
    return joint.get(table, {}).get(key, 1.0 if key == "effort_gain" else 0.0)


def named(effect, path, value, seed, folder):
    run("simulate", JOINT, "--reference", TRAJECTORY, "--set", f"{path}={value!r}", "--seed", seed, "-o", folder)
    answer = json.loads(run("diagnose", JOINT, folder / "record.csv", "--json", "--no-report", "--threads", 1, "-o", folder))
    sets = [e["names"] for e in answer["effects"][:1]] + answer["ambiguous_with"]
    return answer["verdict"] == "gap" and any(effect in names for names in sets)


def least_found(effect, predicted, joint, folder):
    """None where not even the largest size of the grid is found."""
    path, change = NUMBERS[effect]

    def found(i):
        value = change(documented(path, joint), predicted * STEP ** i)
        return 2 * sum(named(effect, path, value, seed, folder) for seed in range(1, SEEDS + 1)) >= SEEDS

    missed, seen = -WIDEST, WIDEST
    if not found(seen):
        return None
    while seen - missed > 1:
        middle = (seen + missed) // 2
        missed, seen = (missed, middle) if found(middle) else (middle, seen)
    return predicted * STEP ** (seen - 0.5)  # between the largest that is missed and the smallest that is found


joint = tomllib.loads(pathlib.Path(JOINT).read_text(encoding="utf-8"))
sizes = {e["name"]: e for e in json.loads(run("plan", JOINT, TRAJECTORY, "--json"))["effects"]}
outside = 0
with tempfile.TemporaryDirectory() as folder:
    for effect in sys.argv[5:] or NUMBERS:
        predicted = sizes.get(effect, {}).get("least_size")
        if not predicted:
            print(f"{effect:18} no size predicted")
            continue
        found = least_found(effect, predicted, joint, pathlib.Path(folder))
        ratio = predicted / found if found else 0
        outside += not 1 / AGREES <= ratio <= AGREES
        print(f"{effect:18} predicted {predicted:9.3g}  found {found or float('nan'):9.3g}  ratio {ratio:6.2f}", flush=True)
print(f"{outside} beyond a factor of {AGREES}")
sys.exit(1 if outside else 0)
