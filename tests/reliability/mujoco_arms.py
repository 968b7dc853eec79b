#!/usr/bin/env python3
"""Arms in MuJoCo, a cause or none in each joint, diagnosed joint by joint with their loads.

Run: STICKSLIP_PROGRAM=… mujoco_arms.py [ARMS] [FIRST_SEED] [ur5e|two-links]: a public arm of six joints, or two links in a plane; needs `npm ci` in tests/simulators. Nothing of ours computes a motion. A
joint counts as right with the cause that was planted, or with one for the very same motion. Prints each wrong one, then the
count with the bound that it leaves at 95 % confidence (Clopper and Pearson 1934).
"""
import json
import pathlib
import random
import subprocess
import sys
import tempfile

import pandas

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "reliability")]
import stickslip  # noqa: E402
from gap_check import beta_bound  # noqa: E402

SAME = {"constant-load": {"constant-load", "asymmetric-friction"}}
PERIOD, NOISE, QUANTUM, ROTOR = 2e-3, 3e-5, 1e-6, 0.1
# inertia of each joint at its largest, friction of a strain wave gear; gains give 4 Hz with damping 0.8 at that inertia
NUMBERS = {"ur5e": {"inertia": (1.8, 2.0, 0.6, 0.14, 0.12, 0.1), "coulomb": (6.0, 6.0, 3.0, 0.8, 0.8, 0.6),
                    "viscous": (3.0, 3.0, 1.5, 0.4, 0.4, 0.3)},
           "two-links": {"inertia": (1.5, 0.21), "coulomb": (3.0, 1.0), "viscous": (1.0, 0.3)}}
OMEGA, DAMPING = 25.0, 0.8


def machine(dice, seed, arm):
    """The documented joints, what each really is, and the planted causes."""
    documented, real, causes = [], [], []
    for i, (inertia, coulomb, viscous) in enumerate(zip(*NUMBERS[arm].values())):
        joint = {"coulomb": coulomb, "viscous": viscous, "load": 0.0, "k_p": inertia * OMEGA**2, "k_v": 2 * DAMPING * inertia * OMEGA,
                 "motion": [[0.5 + 0.05 * i, 1.1 + 0.17 * i], [0.08, 3.9 + 0.37 * i]]}
        documented.append(dict(joint))
        cause, sign = dice.choice((None, "coulomb-level", "viscous", "gain-k_p", "gain-k_v", "constant-load")), dice.choice((-1, 1))
        if cause == "coulomb-level":
            joint["coulomb"] *= 1 + sign * dice.uniform(0.2, 0.5)
        elif cause == "viscous":
            joint["viscous"] *= dice.uniform(1.8, 3)
        elif cause == "gain-k_p":
            joint["k_p"] *= 1 + sign * dice.uniform(0.1, 0.3)
        elif cause == "gain-k_v":
            joint["k_v"] *= 1 + sign * dice.uniform(0.15, 0.4)
        elif cause == "constant-load":
            joint["load"] = sign * dice.uniform(0.3, 0.7) * coulomb
        real.append(joint)
        causes.append(cause)
    return documented, {"arm": arm, "seconds": 8, "period": PERIOD, "noise": NOISE, "quantum": QUANTUM, "seed": seed, "joints": real}, causes


def joint_file(documented, inertia):
    return stickslip.Joint.from_dict({
        "joint": {"motion": "revolute", "inertia": inertia},
        "control": {"k_p": documented["k_p"], "k_v": documented["k_v"], "period": PERIOD, "velocity_estimate": {"form": "backward-difference"}},
        "friction": {"law": "coulomb-viscous", "coulomb": documented["coulomb"], "viscous": documented["viscous"]},
        "sensor": {"encoder_quantum": QUANTUM, "position_noise": NOISE}})


def main():
    arms = int(sys.argv[1]) if len(sys.argv) > 1 else 10
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    arm = sys.argv[3] if len(sys.argv) > 3 else "ur5e"
    right = total = singles = named = 0
    for seed in range(first, first + arms):
        documented, made, causes = machine(random.Random(seed), seed, arm)
        with tempfile.TemporaryDirectory() as room:
            folder = pathlib.Path(room)
            (folder / "machine.json").write_text(json.dumps(made))
            subprocess.run(["node", ROOT / "tests/simulators/simulate_arm.mjs", folder / "machine.json", folder], check=True)
            names = [f"joint{i + 1}" for i in range(len(documented))]
            records = {name: pandas.read_csv(folder / f"{name}.csv") for name in names}
            records = stickslip.with_arm_load(records, folder / "arm.urdf", armature=dict.fromkeys(names, ROTOR))
        for i, (name, cause) in enumerate(zip(names, causes)):
            joint = joint_file(documented[i], float(records[name]["inertia"].iloc[0]))
            answer = stickslip.diagnose(joint, {"run": records[name]}, threads=1)
            found = answer["effects"][0]["names"] if answer["verdict"] == "gap" else []
            good = answer["verdict"] == "no-gap" if cause is None else len(found) == 1 and found[0] in SAME.get(cause, {cause})
            right, total = right + good, total + 1
            if cause is not None:
                named, singles = named + good, singles + 1
            if not good:
                print(f"arm {seed}, {name}: planted {cause}, answered {answer['verdict']} {' + '.join(found)}, "
                      f"{answer['gap']['overall']['before']:.2f} to {answer['gap']['overall']['after']:.2f} noise floors", flush=True)
        print(f"{right} of {total} joints right, {named} of {singles} causes (at least {beta_bound(named, singles, False):.3f})", flush=True)
    return 0 if named >= 0.95 * singles else 1


if __name__ == "__main__":
    sys.exit(main())
