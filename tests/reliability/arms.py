#!/usr/bin/env python3
"""Two-joint arms with a cause in each joint, drawn at random and simulated by an engine of their own, diagnosed with their loads.

Run: STICKSLIP_PROGRAM=… arms.py [ARMS] [FIRST_SEED]. The engine and the closed form of the arm are those of tests/python/test_arm.py:
nothing of ours computes a motion. Each joint gets one cause or none; with its name, or with one for the very same motion, it counts
as right. Prints each wrong one, then the count.
"""
import pathlib
import random
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "python"), str(ROOT / "tests" / "python")]
import stickslip  # noqa: E402
import test_arm as arm  # noqa: E402

SAME = {"constant-load": {"constant-load", "asymmetric-friction"}}


def drawn(dice):
    """A cause for each joint, and the numbers of the arm with both."""
    friction, gains, load = [list(f) for f in arm.FRICTION], [list(g) for g in arm.GAINS], [0.0, 0.0]
    causes = []
    for i in range(2):
        cause = dice.choice((None, "coulomb-level", "viscous", "gain-k_p", "gain-k_v", "constant-load"))
        sign = dice.choice((-1, 1))
        if cause == "coulomb-level":
            friction[i][0] *= 1 + sign * dice.uniform(0.2, 0.5)
        elif cause == "viscous":
            friction[i][1] *= dice.uniform(1.8, 3)
        elif cause == "gain-k_p":
            gains[i][0] *= 1 + sign * dice.uniform(0.1, 0.3)
        elif cause == "gain-k_v":
            gains[i][1] *= 1 + sign * dice.uniform(0.15, 0.4)
        elif cause == "constant-load":
            load[i] = sign * dice.uniform(0.3, 0.7) * friction[i][0]
        causes.append(cause)
    return causes, {"friction": friction, "gains": gains, "load": load}


def main():
    arms = int(sys.argv[1]) if len(sys.argv) > 1 else 40
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 1
    right = total = 0
    with tempfile.TemporaryDirectory() as folder:
        urdf = pathlib.Path(folder) / "two.urdf"
        urdf.write_text(arm.URDF)
        joints = arm.joint_files()
        for seed in range(first, first + arms):
            causes, numbers = drawn(random.Random(seed))
            records = stickslip.with_arm_load(arm.simulated(6, seed, **numbers), urdf, armature=dict(zip(joints, arm.ROTOR)))
            for cause, (name, joint) in zip(causes, joints.items()):
                answer = stickslip.diagnose(joint, {"run": records[name]}, threads=1)
                named = answer["effects"][0]["names"] if answer["verdict"] == "gap" else []
                good = answer["verdict"] == "no-gap" if cause is None else len(named) == 1 and named[0] in SAME.get(cause, {cause})
                right, total = right + good, total + 1
                if not good:
                    print(f"arm {seed}, {name}: planted {cause}, answered {answer['verdict']} {' + '.join(named)}", flush=True)
            print(f"{right} of {total} joints right", flush=True)
    return 0 if right >= 0.95 * total else 1


if __name__ == "__main__":
    sys.exit(main())
