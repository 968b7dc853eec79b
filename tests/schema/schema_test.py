#!/usr/bin/env python3
"""The schemas in docs/schema against what the program really writes. Run: schema_test.py STICKSLIP

Every schema is also held against the same output with a required field removed and with a field of another type: a
schema that accepts anything proves nothing.
"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

import jsonschema

ROOT = pathlib.Path(__file__).parent.parent.parent
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
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


def stickslip(*arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=ROOT)
    assert done.returncode in (0, 4), done.stdout + done.stderr
    return done.stdout


def check(name, value):
    schema = json.loads((ROOT / "docs/schema" / f"{name}.schema.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft202012Validator(schema)
    for error in validator.iter_errors(value):
        sys.exit(f"{name}: {'.'.join(map(str, error.path))}: {error.message[:200]}")
    for key in schema["required"]:
        broken = copy.deepcopy(value)
        del broken[key]
        assert not validator.is_valid(broken), f"{name}: {key} is not missed"
        broken[key] = {"another": "thing"} if not isinstance(value[key], dict) else 1
        assert not validator.is_valid(broken), f"{name}: {key} may be anything"
    print(f"{name}: {value['format']} holds")


with tempfile.TemporaryDirectory() as folder:
    spec, out = pathlib.Path(folder, "spec.toml"), str(pathlib.Path(folder, "out"))
    spec.write_text(SPEC, encoding="utf-8")
    check("sweep-run", json.loads(stickslip("sweep", str(spec), "-o", out, "--json")))
    check("sweep-answer", json.loads(pathlib.Path(out, "answer.json").read_text(encoding="utf-8")))
    for joint in (str(pathlib.Path(out, "joint.toml")), "examples/02-ball-screw/spec-with-memory.toml"):
        check("evaluate", json.loads(stickslip("evaluate", joint, "--json")))
