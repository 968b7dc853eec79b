#!/usr/bin/env python3
"""The schemas in docs/schema against what the program really writes. Run: schema_test.py STICKSLIP [STICKSLIP_OF_CODES]

With the second program, whose sentences are codes, every question is asked twice: exit codes and answers must be the
same but for the sentences, also where a program reads what the other wrote.

Every schema is also held against the same output with a required field removed and with a field of another type: a
schema that accepts anything proves nothing.
"""
import copy
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import jsonschema

ROOT = pathlib.Path(__file__).parent.parent.parent
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
OF_CODES = str(pathlib.Path(sys.argv[2]).resolve()) if len(sys.argv) > 2 else None
SENTENCES = {"refused", "reasons", "notes", "reason", "sentence", "text", "answer", "could_be_missed", "why", "searched_from",
             "growth_reason", "fold_reason", "error_reason", "eigenvalues_note", "description", "tell_tale", "signature"}
TIMES = {"seconds", "computed"}  # what a run cost: the second program finds what the first has computed
told, held = set(), set()
SPEC = """
[joint]
motion = "prismatic"
model = "single-mass"
inertia = 1.0
[control]
k_p = 6e4
k_v = 10.0
V0 = 1e-3
[friction]
law = "rate-and-state"
f0 = 60.0
A = 1.0
B = 1.5
L = 1e-5
V_star = 1e-3
[axes]
"control.k_p" = { from = 1e4, to = 1e5, points = 21, scale = "log" }
"control.k_v" = { from = 1.0, to = 1e3, points = 9, scale = "log" }
"control.V0" = { from = 1e-4, to = 1e-2, points = 3, scale = "log" }
"""


LOOP = """
[joint]
motion = "revolute"
inertia = 0.05
[control]
k_p = 20.0
k_v = 0.5
period = 1e-3
velocity_estimate = { form = "backward-difference" }
[friction]
law = "coulomb-viscous"
coulomb = 0.3
viscous = 0.05
[sensor]
position_noise = 1e-6
"""


def differences(one, other, place=""):
    """Where two answers differ, sentences left aside: what the second program says instead begins with #."""
    if isinstance(one, dict) and isinstance(other, dict) and one.keys() == other.keys():
        return [d for key in one if key not in TIMES for d in differences(one[key], other[key], f"{place}.{key}")]
    if isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        return [d for a, b in zip(one, other) for d in differences(a, b, place + "[]")]
    if isinstance(one, str) and isinstance(other, str) and "#" in other and place.split(".")[-1].rstrip("[]") in SENTENCES:
        told.add(place)
        return []
    return [] if one == other else [f"{place}: {one!r} and {other!r}"]


def stickslip(*arguments, codes=(0, 4)):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode in codes, done.stdout + done.stderr
    if OF_CODES:
        coded = subprocess.run([OF_CODES, *arguments], capture_output=True, text=True, cwd=ROOT)
        assert coded.returncode == done.returncode, f"{arguments}: {done.returncode}, of codes {coded.returncode}"
        if "--json" in arguments and (found := differences(json.loads(done.stdout), json.loads(coded.stdout))):
            sys.exit("\n".join([" ".join(arguments), *found]))
    return done.stdout


def back_and_forth(file):
    """Three seconds of a reference that moves, turns and stops."""
    with open(file, "w", encoding="utf-8") as out:
        out.write("time,reference_position\n")
        for i in range(3000):
            t = i * 1e-3
            q = 0.5 * (1 - math.cos(2 * math.pi * t)) if t < 2 else 0.0
            out.write(f"{t:.3f},{q:.9g}\n")


def check(name, value):
    schema = json.loads((ROOT / "docs/schema" / f"{name}.schema.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    for error in validator.iter_errors(value):
        sys.exit(f"{name}: {'.'.join(map(str, error.path))}: {error.message[:200]}")
    held.add(name)
    for key in schema.get("required", ()):
        broken = copy.deepcopy(value)
        del broken[key]
        assert not validator.is_valid(broken), f"{name}: {key} is not missed"
        broken[key] = {"another": "thing"} if not isinstance(value[key], dict) else 1
        assert not validator.is_valid(broken), f"{name}: {key} may be anything"
    print(f"{name}: {value.get('format', 'without a format')} holds")


with tempfile.TemporaryDirectory() as folder:
    spec, out = pathlib.Path(folder, "spec.toml"), str(pathlib.Path(folder, "out"))
    spec.write_text(SPEC, encoding="utf-8")
    check("sweep-run", json.loads(stickslip("sweep", str(spec), "-o", out, "--json")))
    check("sweep-plan", json.loads(pathlib.Path(out, "plan.json").read_text(encoding="utf-8")))
    check("run", json.loads(pathlib.Path(out, "run.json").read_text(encoding="utf-8")))
    check("sweep-run", json.loads(stickslip("sweep", str(spec), "-o", out, "--no-report", "--json")))
    check("sweep-answer", json.loads(pathlib.Path(out, "answer.json").read_text(encoding="utf-8")))
    check("drawn-charts", json.loads(pathlib.Path(out, "charts", "drawn.json").read_text(encoding="utf-8")))
    ball_screw = "examples/02-ball-screw/joint-with-memory.toml"
    for question in (
        (ball_screw, "--set", "control.k_v=0", "--along", "control.k_p=1e3..1e7"),
        (ball_screw, "--set", "control.k_v=0", "--along", "control.k_p=1e3..1e4"),  # the boundary lies outside
        (ball_screw, "--kind", "v-min", "--along", "control.V0=1 um/s..10 mm/s"),
        (str(spec), "--kind", "linear", "--over", "control.k_p", "control.k_v", "--guard", "6"),
    ):
        check("boundary", json.loads(stickslip("boundary", *question, "--json")))
    check("margins", json.loads(stickslip("margins", ball_screw, "--json")))
    check("margins", json.loads(stickslip("margins", str(spec), "--uncertain", "friction.L=20%", "--over", "control.k_p",
                                          "control.k_v", "--guard", "6", "--json")))
    for margin in ("1", "99"):  # feasible, and not
        check("design", json.loads(stickslip("design", "examples/04-design/spec.toml", "--require", f"margin={margin}",
                                             "--require", "front_points=3", "--json", codes=(0, 1))))
    check("set-point-design", json.loads(stickslip("design", "examples/08-hunting-arm/joint.toml", "--set-point", "--friction-margin", "0", "--json",
                                                   codes=(0, 1))))
    baseline = pathlib.Path(folder, "baseline.json")
    stickslip("check", str(spec), str(baseline), "--update")
    check("baseline", json.loads(baseline.read_text(encoding="utf-8")))
    stickslip("check", str(spec), str(baseline))
    stickslip("report", out)
    # records of the loop itself, of one with a load that the file lacks, and too few rows
    loop, motion = pathlib.Path(folder, "loop.toml"), pathlib.Path(folder, "motion.csv")
    loop.write_text(LOOP, encoding="utf-8")
    back_and_forth(motion)
    for load in ("0", "0.2"):
        record = pathlib.Path(folder, f"record-{load}")
        stickslip("simulate", str(loop), "--reference", str(motion), "--set", f"load.constant={load}", "-o", str(record))
        check("diagnosis", json.loads(stickslip("diagnose", str(loop), str(record / "record.csv"), "--no-report", "--json",
                                                "-o", str(record))))
    # the same joint later, its diagnoses held against each other
    dated = [pathlib.Path(folder, "runs", day) for day in ("2026-03-01", "2026-04-01")]
    for run, load in zip(dated, ("0", "0.2")):
        stickslip("diagnose", str(loop), str(pathlib.Path(folder, f"record-{load}", "record.csv")), "--no-report", "-o", str(run))
    check("comparison", json.loads(stickslip("compare", str(dated[0]), str(dated[1]), "--json")))
    check("timeline", json.loads(stickslip("timeline", str(pathlib.Path(folder, "runs")), "--no-report", "--json", "-o",
                                           str(pathlib.Path(folder, "timeline")))))
    # cases on the joint itself (the cause of the first does not show in this motion); a promise from as many answers as a
    # cluster would give
    calibration, recorded = pathlib.Path(folder, "calibration.json"), str(pathlib.Path(folder, "record-0.2", "record.csv"))
    stickslip("calibrate", str(loop), recorded, "--cases", "2", "-o", str(calibration))
    answered = json.loads(calibration.read_text(encoding="utf-8"))
    check("calibration", answered)
    answered["cases"] = [{**answered["cases"][0], "name": str(n)} for n in range(59)]
    calibration.write_text(json.dumps(answered), encoding="utf-8")
    promised = json.loads(stickslip("diagnose", str(loop), recorded, "--no-report", "--json", "-o", folder, "--guarantee", "0.95",
                                    "--calibration", str(calibration)))
    check("diagnosis", promised)
    assert promised["set"]["cases"] == 59, promised["set"]
    gap = pathlib.Path(folder, "gap.json")
    stickslip("check", str(loop), str(pathlib.Path(folder, "record-0", "record.csv")), str(gap), "--update")
    check("gap-baseline", json.loads(gap.read_text(encoding="utf-8")))
    worse = json.loads(stickslip("check", str(loop), str(pathlib.Path(folder, "record-0.2", "record.csv")), str(gap), "--json", codes=(1,)))
    check("gap-check", worse)
    check("comparison", worse["comparison"])
    few = pathlib.Path(folder, "few.csv")
    few.write_text("".join((record / "record.csv").read_text(encoding="utf-8").splitlines(keepends=True)[:50]), encoding="utf-8")
    check("diagnosis", json.loads(stickslip("diagnose", str(loop), str(few), "--no-report", "--json", "-o", str(record))))
    # a robot: a joint that is diagnosed, one that the log lacks, one whose file is broken
    arm, log = pathlib.Path(folder, "arm"), pathlib.Path(folder, "log.csv")
    arm.mkdir()
    (arm / "elbow.toml").write_text(LOOP, encoding="utf-8")
    (arm / "base.toml").write_text(LOOP, encoding="utf-8")
    (arm / "wrist.toml").write_text(LOOP.replace("inertia", "inertai"), encoding="utf-8")
    rows = (pathlib.Path(folder, "record-0.2") / "record.csv").read_text(encoding="utf-8").splitlines()
    rows[0] = ",".join(name if name == "time" else "elbow_" + name for name in rows[0].split(","))
    log.write_text("\n".join(rows) + "\n", encoding="utf-8")
    robot = json.loads(stickslip("diagnose", str(arm), str(log), "--all-joints", "--no-report", "--json", "-o",
                                 str(pathlib.Path(folder, "robot")), codes=(2,)))
    check("robot-diagnosis", robot)
    for joint in range(len(robot["joints"])):
        for key in ("name", "status", *(("verdict", "gap") if robot["joints"][joint]["status"] == "diagnosed" else ("problems",))):
            broken = copy.deepcopy(robot)
            del broken["joints"][joint][key]
            schema = json.loads((ROOT / "docs/schema/robot-diagnosis.schema.json").read_text(encoding="utf-8"))
            assert not jsonschema.Draft202012Validator(schema).is_valid(broken), f"robot-diagnosis: joint {joint} does not miss {key}"
    for joint, *changes in ((str(pathlib.Path(out, "joint.toml")),), ("examples/02-ball-screw/spec-with-memory.toml",),
                            (str(loop), "--set", "control.V0=0.1"), ("examples/08-hunting-arm/joint.toml",),
                            (str(loop), "--set", "control.V0=0.1", "--set", "control.effort_limit=1e-3"),
                            (str(spec), "--set", "control.k_v=1e4"), (str(spec), "--set", "control.delay=1e-3")):
        check("evaluate", json.loads(stickslip("evaluate", joint, *changes, "--json")))
    check("boundary", json.loads(stickslip("boundary", "examples/08-hunting-arm/joint.toml", "--kind", "hunting", "--along",
                                           "control.k_i=1..1e4", "--json")))
    for simulator in ("mjcf", "urdf", "sdf", "isaaclab", "ros2_control"):
        check("export", json.loads(stickslip("export", str(loop), "--to", simulator, "--json")))
        check("export", json.loads(stickslip("export", str(loop), "--to", simulator, "--json", "--records",
                                             str(pathlib.Path(folder, "record-0.2", "record.csv")))))
    robot = pathlib.Path(folder, "elbow.xml")
    robot.write_text(stickslip("export", str(loop), "--to", "mjcf", "--name", "elbow"), encoding="utf-8")
    check("import", json.loads(stickslip("import", str(robot), "--joint", "elbow", "--json")))
    check("plan", json.loads(stickslip("plan", str(loop), str(motion), "--json", "-o", str(pathlib.Path(folder, "planned")))))
    check("motion", json.loads((record / "motion.json").read_text(encoding="utf-8")))
    for what in ("laws", "joints", "effects", "parameters", "keys"):
        check("list", json.loads(stickslip("list", what, "--json")))
    check("figures", json.loads(stickslip("figures", "--json", "-o", str(pathlib.Path(folder, "figures")))))
    # a blind test case, answered and scored
    cases, truth, score = (pathlib.Path(folder, name) for name in ("cases", "truth.json", "score.json"))
    (cases / "case-00").mkdir(parents=True)
    (cases / "case-00" / "joint.toml").write_text(LOOP, encoding="utf-8")
    (cases / "case-00" / "record.csv").write_bytes((pathlib.Path(folder, "record-0.2") / "record.csv").read_bytes())
    truth.write_text(json.dumps({"case-00": {"verdict": "gap", "effects": ["gravity"], "kind": "single"}}), encoding="utf-8")
    stickslip("blind", str(cases), "--truth", str(truth), "--score", str(score))
    check("score", json.loads(score.read_text(encoding="utf-8")))
    check("answers", json.loads((cases / "answers.json").read_text(encoding="utf-8")))
# every JSON that the program writes says its format, every format has a schema, every schema was held against real output
schemas = {file.name.removesuffix(".schema.json"): json.loads(file.read_text(encoding="utf-8"))
           for file in (ROOT / "docs/schema").glob("*.json")}
assert held == schemas.keys(), f"held against no output: {', '.join(sorted(schemas.keys() - held))}"
formats = {schema["properties"]["format"]["const"] for schema in schemas.values() if "format" in schema.get("required", ())}
written = {name for room in ("sweep", "analysis") for file in (ROOT / room).rglob("*.[ch]*")
           for name in re.findall(r'"(stickslip[- ][a-z -]+[/ ]\d+)"', file.read_text(encoding="utf-8"))}
written -= {"stickslip plan 1",  # salt of the id of a plan
            "stickslip baseline 1"}  # read, and written no more
assert written == formats, f"formats with a schema or in the code alone: {', '.join(sorted(written ^ formats))}"
assert [name for name, schema in schemas.items() if "format" not in schema.get("required", ())] == ["answers"]

# every reason for people has its code beside it
for name in ("evaluate", "boundary", "set-point-design", "robot-diagnosis", "diagnosis"):
    def without_code(schema, place=""):
        keys = schema.get("properties", {})
        for key, below in keys.items():
            if key in ("why", "reason", "reasons", "growth_reason", "fold_reason", "error_reason") and not {
                    key + "_code", key + "_codes", key.rstrip("s") + "_codes"} & keys.keys():
                yield f"{place}.{key}"
            yield from without_code(below, f"{place}.{key}")
        if isinstance(schema.get("items"), dict):
            yield from without_code(schema["items"], place + "[]")
    bare = list(without_code(json.loads((ROOT / "docs/schema" / f"{name}.schema.json").read_text(encoding="utf-8"))))
    assert not bare, f"{name}: no code beside {', '.join(bare)}"
if OF_CODES:
    print("sentences were codes at", ", ".join(sorted(told)))
    missing = {".reasons[]", ".notes[]", ".answer", ".sentence", ".nonlinear.reason", ".linear.margins.reason",
               ".linear.response.reason", ".set_point.reason", ".loop.not_used[].why", ".not_expressible[].why",
               ".lines[].answer", ".regressions[].text"} - told
    assert not missing, f"no code stood for {', '.join(sorted(missing))}: nothing was compared there"
