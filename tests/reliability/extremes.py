#!/usr/bin/env python3
"""Extreme numbers through every verb of the program: zero, denormals, 1e±300, the ends of the doubles.

Each case changes one number of a joint (or, one in three, two of them) and runs one verb. It must end by itself and in time, with
an exit code of the program's own, with words where it refuses, and with JSON in which nothing is NaN or infinite and no answer
lacks without a reason. Prints figures. Run: extremes.py STICKSLIP [CASES] [SEED] [JOBS]"""
import concurrent.futures
import itertools
import json
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
CASES = int(sys.argv[2]) if len(sys.argv) > 2 else 300
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 20261121
JOBS = int(sys.argv[4]) if len(sys.argv) > 4 else 2
CPU_SECONDS = 120  # of one case; a design of three masses takes 15 s with ordinary numbers, 90 s where rounding decides
WALL_SECONDS = 900  # nothing may wait for ever without computing
CODES = {0, 1, 2, 4}
EXTREMES = ["0", "5e-324", "1e-308", "1e-300", "1e-150", "1e150", "1e300", "1.7e308", "-1e-300", "-1e300"]

SINGLE = """[joint]
motion = "prismatic"
model = "single-mass"
inertia = 1.0
[control]
kind = "position"
k_p = 2.0e4
k_v = 10.0
V0 = 1.0e-3
"""
TAIL = "period = 1e-3\n"
LAWS = {
    "rate-and-state": "f0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n",
    "ageing": "f0 = 60.0\nA = 1.0\nB = 1.5\nL = 1e-5\nV_star = 1e-3\n",
    "coulomb-viscous": "coulomb = 20\nviscous = 100\n",
    "kinetic-static": "kinetic = 15\nstatic = 20\n",
    "stribeck": "c0 = 15\nc1 = 5\nc2 = 300\nc3 = 100\nc4 = 1\n",
    "dahl": "coulomb = 15\nsigma0 = 1e6\nexponent = 1\n",
    "lugre": "sigma0 = 1e6\nsigma1 = 1e3\nsigma2 = 50\ncoulomb = 15\nstatic = 20\nstribeck_velocity = 2e-3\n",
    "maxwell-slip": "viscous = 20\nelements = [{ stiffness = 1e5, yield = 5 }, { stiffness = 1e6, yield = 10 }]\n",
    "time-lag": 'lag = 0.01\ncurve = { law = "stribeck", c0 = 15, c1 = 5, c2 = 300, c3 = 100, c4 = 1 }\n',
    "kernel": "f_v = 1e3\nexponentials = [{ weight = -5e4, rate = 100 }]\ndelays = []\n",
}
AXES = """[axes]
"control.k_p" = { from = 1e3, to = 1e6, points = 4, scale = "log" }
"control.k_v" = { from = 1.0, to = 1e3, points = 3, scale = "log" }
[nonlinear]
enabled = true
"""


def number_paths(text):
    """The dotted paths of the plain numbers in a joint, by the program's own way of naming them."""
    table, paths = "", []
    for line in text.splitlines():
        if line.startswith("["):
            table = line.strip("[]")
        elif "=" in line and line.split("=")[1].strip()[:1] in "0123456789-":
            paths.append(f"{table}.{line.split('=')[0].strip()}")
    return paths


def joints(folder):
    for law, keys in LAWS.items():
        text = f'{SINGLE}{TAIL}[friction]\nlaw = "{law}"\n{keys}'
        (folder / f"{law}.toml").write_text(text)
        yield law, text
    three = pathlib.Path(__file__).resolve().parent.parent / "fuzz/corpus/joint/three-mass.toml"
    (folder / "three-mass.toml").write_text(three.read_text())
    yield "three-mass", three.read_text()


def record(folder):
    """Motion at constant velocity with a little ripple, enough to be read."""
    rows = ["time,reference_position,position,velocity,effort_command,effort_measured"]
    for k in range(400):
        t = k * 1e-3
        x = 1e-3 * t + 1e-7 * ((k * 7) % 5)
        rows.append(f"{t:.6f},{1e-3 * t:.9f},{x:.9f},{1e-3:.6f},{60 + k % 3},{60 + k % 4}")
    (folder / "record.csv").write_text("\n".join(rows) + "\n")


def with_values(text, sets):
    """The joint with other numbers written into it, for the verbs that have no --set."""
    lines, table = [], ""
    for line in text.splitlines():
        if line.startswith("["):
            table = line.strip("[]")
        key = f"{table}.{line.split('=')[0].strip()}"
        lines.append(f"{line.split('=')[0]}= {sets[key]}" if key in sets else line)
    return "\n".join(lines) + "\n"


def command(verb, name, text, sets, folder, number):
    joint = folder / f"{name}.toml"
    flags = [part for path, value in sets.items() for part in ("--set", f"{path}={value}")]
    changed = folder / f"{number}.toml"
    if verb == "sweep":
        changed.write_text(with_values(text, sets) + AXES)
        return ["sweep", changed, "-o", folder / f"{number}", "--threads", "1", "--json", "--no-report"]
    if verb == "diagnose":
        changed.write_text(with_values(text, sets))
        return ["diagnose", changed, folder / "record.csv", "-o", folder / f"{number}", "--threads", "1", "--json", "--no-report"]
    if verb == "simulate":
        return ["simulate", joint, *flags, "-o", folder / f"{number}"]
    if verb == "boundary":
        return ["boundary", joint, *flags, "--along", "control.k_p=1e3..1e6", "--kind", "velocity-only", "linear", "fold",
                "--threads", "1", "--json"]
    if verb == "margins":
        return ["margins", joint, *flags, "--threads", "1", "--json"]
    if verb == "design":
        return ["design", joint, *flags, "--require", "sample_time=1e-3", "--require", "position_noise=1e-6", "--threads", "1",
                "--json"]
    return ["evaluate", joint, *flags, "--json"]


def refuse_constant(name):
    raise ValueError(f"{name} in JSON")


def unexplained(verb, answer):
    """What an answer of `evaluate` lacks without saying why; the other verbs have their own tests of that."""
    if verb != "evaluate":
        return ""
    if answer["linear"] is None and not answer.get("reason"):
        return "no linear verdict and no reason"
    nonlinear = answer["nonlinear"]
    if nonlinear["outcome"] in ("undecided", "solver-failure") and not nonlinear["reason"]:
        return "undecided without a reason"
    return ""


def judge(case):
    verb, name, sets, arguments = case
    try:
        run = subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, timeout=WALL_SECONDS,
                             preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS)))
    except subprocess.TimeoutExpired:
        return f"no end within {WALL_SECONDS} s", None
    words = (run.stdout + run.stderr).decode(errors="replace")
    if run.returncode in (-signal.SIGXCPU, -signal.SIGKILL):
        return f"no end within {CPU_SECONDS} s of computing", None
    if run.returncode < 0:
        return f"signal {-run.returncode}", None
    if run.returncode not in CODES:
        return f"exit code {run.returncode}: {words[-200:]}", run.returncode
    if run.returncode == 2:
        return ("" if len(words.strip()) > 10 else "refused without words"), 2
    if "--json" in arguments:
        try:
            answer = json.loads(run.stdout, parse_constant=refuse_constant)
            return unexplained(verb, answer), run.returncode
        except ValueError as error:
            return f"{error}: {words[-200:]}", run.returncode
    return ("nan or inf in words" if any(w in words.lower().split() for w in ("nan", "inf", "-nan", "-inf")) else ""), run.returncode


def main():
    rng = random.Random(SEED)
    verbs = ["evaluate"] * 4 + ["sweep", "simulate", "boundary", "margins", "design", "diagnose"]
    failures, codes = [], {}
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        record(folder)
        every = [(name, text, path, value) for name, text in joints(folder) for path in number_paths(text) for value in EXTREMES]
        rng.shuffle(every)
        cases = []
        for number, (name, text, path, value) in enumerate(itertools.islice(itertools.cycle(every), CASES)):
            sets = {path: value}
            if number % 3 == 2:
                sets.setdefault(rng.choice(number_paths(text)), rng.choice(EXTREMES))
            verb = verbs[number % len(verbs)]
            cases.append((verb, name, sets, command(verb, name, text, sets, folder, number)))
        with concurrent.futures.ThreadPoolExecutor(JOBS) as pool:
            for case, (fault, code) in zip(cases, pool.map(judge, cases)):
                codes[code] = codes.get(code, 0) + 1
                if fault:
                    failures.append(case)
                    print(f"FAULT {case[0]} {case[1]} {' '.join(f'{p}={v}' for p, v in case[2].items())}: {fault}", flush=True)
    kinds = ", ".join(f"{count} with code {code}" for code, count in sorted(codes.items(), key=str))
    print(f"extreme values: {CASES} runs of 7 verbs over {len(LAWS) + 1} joints (seed {SEED}; {kinds}), faults: {len(failures)}")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
