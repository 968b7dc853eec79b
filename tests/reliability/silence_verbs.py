"""What silence.py runs: every verb of the program with small inputs, so that it ends in seconds and still writes all its files."""
import math
import pathlib
import shutil
import subprocess
import sys

TESTS = pathlib.Path(__file__).resolve().parents[1]
EXAMPLES = TESTS.parent / "examples"
CORPUS = TESTS / "fuzz/corpus"

REFERENCE = "time,reference_position\n" + "".join(f"{k * 1e-3:.4f},{5e-3 * (1 - math.cos(2e-3 * k)):.9f}\n" for k in range(6000))
SMALL_SPEC = """joint = "joint.toml"
[axes]
"control.k_p" = { from = 1e4, to = 1e6, points = 40, scale = "log" }
"control.V0" = { from = 1e-4, to = 1e-2, points = 30, scale = "log" }
[design]
"control.k_p" = 6e4
[nonlinear]
enabled = true
"""
ARM_JOINT = """[joint]
motion = "revolute"
inertia = 0.3
[control]
k_p = 400
k_v = 20
period = 2e-3
velocity_estimate = { form = "backward-difference" }
[friction]
law = "coulomb-viscous"
coulomb = 1.0
viscous = 0.3
[sensor]
encoder_quantum = 1e-6
position_noise = 1e-6
"""
ARM_REFERENCE = "time,reference_position\n" + "".join(f"{k * 2e-3:.3f},{0.4 * (1 - math.cos(7e-3 * k)):.9f}\n" for k in range(1500))
TRUTH = '{"case-01": {"verdict": "gap", "effects": ["constant-load"]}, "case-02": {"verdict": "gap", "effects": ["gravity"]}}\n'
OUTCOMES = "control.k_p [N/m],control.V0 [m/s],outcome\n" + "".join(
    f"{k_p:g},{v:g},{'stick-slip' if k_p < 6e4 else 'stable-sliding'}\n" for k_p in (2e4, 4e4, 8e4, 2e5) for v in (5e-4, 1e-3, 2e-3))


def inputs(program, folder):
    """The files that the verbs read, in `folder`."""
    def run(*words):
        done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True)
        if done.returncode not in (0, 1, 4):
            sys.exit(f"{' '.join(words)}: code {done.returncode}: {done.stderr}")

    shutil.copy(EXAMPLES / "02-ball-screw/joint-with-memory.toml", folder / "joint.toml")
    shutil.copy(EXAMPLES / "08-hunting-arm/joint.toml", folder / "hunting.toml")
    shutil.copy(CORPUS / "robot/arm.urdf", folder / "arm.urdf")
    (folder / "spec.toml").write_text(SMALL_SPEC)
    (folder / "motion.csv").write_text(REFERENCE)
    (folder / "outcomes.csv").write_text(OUTCOMES)
    run("new", "joint", "--from", "joint.toml", "--plain", "--set", "control.period=1e-3", "--set",
        "control.velocity_estimate.form=exact", "-o", "loop.toml")
    run("simulate", "loop.toml", "--reference", "motion.csv", "-o", "driven")
    shutil.copy(folder / "driven/record.csv", folder / "record.csv")
    run("sweep", "spec.toml", "-o", "swept", "--no-report", "--keep-journal")
    run("diagnose", "loop.toml", "record.csv", "-o", "2026-11-24")
    arm(folder, run)


def arm(folder, run):
    """A robot of two joints, logs of it in several formats, and blind cases of one of them."""
    (folder / "arm-motion.csv").write_text(ARM_REFERENCE)
    columns = {}
    for name, cause in (("shoulder", "load.gravity_amplitude=6"), ("elbow", "load.constant=3")):
        (folder / f"{name}.toml").write_text(ARM_JOINT)
        run("simulate", f"{name}.toml", "--reference", "arm-motion.csv", "--set", cause, "-o", f"loop-{name}")
        rows = [line.split(",") for line in (folder / f"loop-{name}/record.csv").read_text().splitlines() if line[0] != "#"]
        for k, head in enumerate(rows[0]):
            columns[head if head == "time" else f"{name}_{head}"] = [row[k] for row in rows[1:]]
    (folder / "arm.csv").write_text("\n".join([",".join(columns), *(",".join(row) for row in zip(*columns.values()))]) + "\n")
    (folder / "robot.toml").write_text('title = "arm"\n[joints]\nshoulder = "shoulder.toml"\nelbow = "elbow.toml"\n')
    run("check", "elbow.toml", "loop-elbow/record.csv", "gap.json", "--update")
    for k, name in enumerate(("elbow", "shoulder"), 1):
        case = folder / f"sealed/case-0{k}"
        case.mkdir(parents=True)
        shutil.copy(folder / f"{name}.toml", case / "joint.toml")
        shutil.copy(folder / f"loop-{name}/record.csv", case / "record.csv")
    (folder / "truth.json").write_text(TRUTH)
    sys.path[:0] = [str(TESTS / "python")]
    import log_samples
    log_samples.mcap(folder / "log.mcap")


def verbs():
    """Name: its words, OUT for where it writes."""
    k_p = "--along", "control.k_p=1e3..1e6"
    out = "-o", "OUT"
    return {
        "sweep": ["sweep", "spec.toml", *out],
        "sweep-shard": ["sweep", "spec.toml", "--shard", "1/2", *out],
        "boundary": ["boundary", "joint.toml", *k_p, "--along", "control.V0=1e-4..1e-2", *out],
        "boundary-fold": ["boundary", "joint.toml", *k_p, "--kind", "fold", *out],
        "boundary-over": ["boundary", "joint.toml", "--over", "control.k_p=1e3..1e6", "control.V0=1e-4..1e-2", "--json", *out],
        "design": ["design", str(EXAMPLES / "04-design/spec.toml"), *out],
        "design-set-point": ["design", "hunting.toml", "--set-point", "--over", "control.dead_zone", *out],
        "margins": ["margins", "joint.toml", *out],
        "check": ["check", str(EXAMPLES / "02-ball-screw/spec-with-memory.toml"), str(EXAMPLES / "02-ball-screw/baseline.json"), *out],
        "check-update": ["check", str(EXAMPLES / "02-ball-screw/spec-with-memory.toml"), "OUT", "--update"],
        "check-gap": ["check", "elbow.toml", "loop-elbow/record.csv", "gap.json", "--junit", "OUT/gap.xml", *out],
        "evaluate": ["evaluate", "joint.toml", *out],
        "evaluate-json": ["evaluate", "joint.toml", "--json"],
        "figures": ["figures", *out],
        "merge": ["merge", "swept", "--keep-journal", *out],
        "report": ["report", "swept", "swept", *out],
        "simulate": ["simulate", "joint.toml", *out],
        "record": ["simulate", "loop.toml", "--reference", "motion.csv", *out],
        "new": ["new", "joint", *out],
        "new-spec": ["new", "spec", *out],
        "convert": ["convert", "log.mcap", "OUT/run.csv", "--joint", "elbow", "--command", "/commands"],
        "convert-packed": ["convert", "log.mcap", "OUT/run.csv.gz", "--joint", "elbow", "--command", "/commands"],
        "import": ["import", "arm.urdf", "--joint", "elbow", *out],
        "export": ["export", "joint.toml", "--to", "mjcf"],
        "export-gap": ["export", "elbow.toml", "--to", "mjcf", "--records", "loop-elbow/record.csv", "--json"],
        "diagnose": ["diagnose", "loop.toml", "record.csv", *out],
        "diagnose-outcomes": ["diagnose", "joint.toml", "outcomes.csv", *out],
        "diagnose-log": ["diagnose", "elbow.toml", "log.mcap", "--joint", "elbow", "--command", "/commands", *out],
        "robot": ["diagnose", "robot.toml", "arm.csv", "--all-joints", *out],
        "arm-load": ["arm-load", "arm.csv", "--robot", "arm.urdf", *out],
        "calibrate": ["calibrate", "elbow.toml", "loop-elbow/record.csv", "--cases", "2", *out],
        "blind": ["blind", "sealed", "--truth", "truth.json", "--answers", "OUT/answers.json", "--score", "OUT/score.json"],
        "compare": ["compare", "2026-11-24", "2026-11-24", *out],
        "timeline": ["timeline", "2026-11-24", *out],
        "plan": ["plan", "elbow.toml", "arm-motion.csv", *out],
        "list": ["list", "keys"],
        "man-page": ["man-page"],
        "completion": ["completion", "bash"],
        "help": ["--help"],
    }
