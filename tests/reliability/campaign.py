#!/usr/bin/env python3
"""Counts that take days, in slices: kill -9, torn journals, inputs, random points, joints, logs. A campaign is stopped and continued
as one likes, and goes in parts to as many machines as there are.

Run: campaign.py BUILD LOG [--only KIND...] [--goal KIND=N...] [--hours H] [--part K/N]
     campaign.py --sum LOG...

Each slice has a number, its seed follows from it, and LOG gets one line of JSON when it ends: what stands there is not run again.
--hours ends between two slices; Ctrl-C and kill lose the slice in hand only. Part K of N runs the slices K, K+N, K+2N, …, so that the
logs of all parts add up (tests/cluster/campaign.sbatch). A finding is printed, kept in LOG, and does not end the campaign; the exit code
is 1 then, 3 where the goals are not reached yet. Lines of another program than BUILD's do not count towards a goal.

--sum adds up logs, program by program, with the bound that a count without a finding leaves: less than 1 − 0.05^(1/n) of all are
faulty, at 95 % confidence (Clopper, Pearson 1934).
"""
import argparse
import hashlib
import json
import pathlib
import re
import subprocess
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
CORPUS = HERE.parent / "fuzz/corpus"
TARGETS = sorted(folder.name for folder in CORPUS.iterdir())
FIRST_SEED = 20261123
CONFIDENCE = 0.95
INTERRUPTED = 3


def joints():
    return sorted((CORPUS / "joint").glob("*.toml"))


def fuzz_kinds():
    """One kind of slice a target; the goal of all of them together is 10^9."""
    return {f"inputs-{t}": (10**9 // len(TARGETS), 200_000, lambda b, n, seed, t=t: [
        b / "tests/fuzz" / f"fuzz_{t}", "--inputs", n, "--seed", seed, CORPUS / t], r": (\d+) inputs from", r"FINDING")
        for t in TARGETS}


# kind: goal, size of a slice, command of a slice, what counts in its output, what of it is a finding (beside its exit code)
KINDS = {
    "kills": (10_000, 20, lambda b, n, seed: [HERE / "faults.sh", b / "sweep/stickslip", n, seed, 0], r"kills survived: (\d+)", None),
    "torn": (10_000, 20, lambda b, n, seed: [HERE / "faults.sh", b / "sweep/stickslip", 0, seed, n], r"after (\d+) damages", None),
    "linear": (10**7, 5_000, lambda b, n, seed: [b / "tests/reliability/reliability_points", "--points", n, "--seed", seed, *joints()],
               r"^linear points checked: (\d+)", r"FAULT"),
    "nonlinear": (10**5, 200, lambda b, n, seed: [b / "tests/reliability/reliability_points", "--points", 0, "--nonlinear", n, "--seed",
                                                  seed, *joints()], r"^nonlinear points checked: (\d+)", r"FAULT"),
    "joints": (10**5, 500, lambda b, n, seed: [b / "tests/reliability/reliability_consistency", "--from", (seed - FIRST_SEED) * n,
                                               "--joints", (seed - FIRST_SEED + 1) * n], r", (\d+) of them in this run", r"FAULT"),
    "roots": (10**5, 500, lambda b, n, seed: [b / "tests/reliability/reliability_consistency", "--roots", "--from",
                                              (seed - FIRST_SEED) * n, "--joints", (seed - FIRST_SEED + 1) * n],
              r", (\d+) of them in this run", r"FAULT"),
    "extremes": (10**4, 30, lambda b, n, seed: [sys.executable, HERE / "extremes.py", b / "sweep/stickslip", n, seed], r"(\d+) runs", None),
    "silence": (10**4, 3, lambda b, n, seed: [sys.executable, HERE / "silence.py", b / "sweep/stickslip", n, seed], r"silence: (\d+) full disks",
                "FINDING"),
    "logs": (10**6, 2_000, lambda b, n, seed: [sys.executable, HERE / "logs.py", n, seed], r"(\d+) damaged logs", r"FINDING"),
    **fuzz_kinds(),
}


def program_of(build):
    return hashlib.sha256((build / "sweep/stickslip").read_bytes()).hexdigest()[:12]


def lines_of(log):
    """What is in a log; a line that a power cut tore is not there."""
    done = []
    for line in log.read_text(encoding="utf-8").splitlines() if log.exists() else []:
        try:
            done.append(json.loads(line))
        except json.JSONDecodeError:
            continue
    return done


def run_slice(kind, number, build):
    goal, size, command, counted, finding = KINDS[kind]
    begin = time.monotonic()
    done = subprocess.run([str(word) for word in command(build, size, FIRST_SEED + number)], capture_output=True, text=True)
    said = done.stdout + done.stderr
    found = re.search(counted, said, re.MULTILINE)
    count = int(found.group(1)) if found else 0
    sound = done.returncode == 0 and count >= size and not (finding and re.search(finding, said))
    return {"kind": kind, "slice": number, "program": program_of(build), "count": count,
            "sound": sound, "seconds": round(time.monotonic() - begin, 1), **({} if sound else {"said": said[-4000:]})}


def reached(lines, program):
    sums = {}
    for line in lines:
        if line["program"] == program:
            sums[line["kind"]] = sums.get(line["kind"], 0) + line["count"]
    return sums


def campaign(build, log, kinds, goals, hours, part, parts):
    program, begin, kinds = program_of(build), time.monotonic(), list(kinds)
    log.parent.mkdir(parents=True, exist_ok=True)
    lines = lines_of(log)
    ran = {(line["kind"], line["slice"]) for line in lines if line["program"] == program}
    following = {kind: part for kind in kinds}
    with log.open("a", encoding="utf-8") as out:
        if log.stat().st_size and not log.read_bytes().endswith(b"\n"):
            out.write("\n")  # behind a line that was torn
        while True:
            sums = reached(lines, program)
            # a part of N has its share of the goal to reach
            behind = {kind: sums.get(kind, 0) * parts / goals[kind] for kind in kinds if sums.get(kind, 0) * parts < goals[kind]}
            if not behind or time.monotonic() - begin > hours * 3600:
                return lines, not behind and len(kinds) == len(goals)
            kind = min(behind, key=behind.get)
            while (kind, following[kind]) in ran:
                following[kind] += parts
            ran.add((kind, following[kind]))
            line = run_slice(kind, following[kind], build)
            lines.append(line)
            out.write(json.dumps(line) + "\n")
            out.flush()
            if not line["sound"]:
                print(f"FINDING in slice {line['slice']} of {kind}: {line['said'].strip()[-400:]}", flush=True)
            if not line["count"]:
                print(f"{kind} is left out: a slice of it counted nothing", flush=True)
                kinds.remove(kind)


def report(lines):
    for program in dict.fromkeys(line["program"] for line in lines):
        print(f"program {program}")
        for kind in KINDS:
            mine = [line for line in lines if line["program"] == program and line["kind"] == kind]
            if not mine:
                continue
            count, unsound = sum(line["count"] for line in mine), sum(not line["sound"] for line in mine)
            bound = f"faulty less than {1 - (1 - CONFIDENCE) ** (1 / count):.2g} of all" if count and not unsound else ""
            print(f"  {kind:18} {count:>13,} of {KINDS[kind][0]:,}, slices with a finding: {unsound}  {bound}  "
                  f"{sum(line['seconds'] for line in mine):.0f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path)
    parser.add_argument("log", nargs="?", type=pathlib.Path)
    parser.add_argument("--sum", nargs="+", type=pathlib.Path, metavar="LOG")
    parser.add_argument("--only", nargs="+", choices=KINDS, default=list(KINDS), metavar="KIND")
    parser.add_argument("--goal", nargs="+", default=[], metavar="KIND=N")
    parser.add_argument("--hours", type=float, default=1e9)
    parser.add_argument("--part", default="0/1", metavar="K/N")
    asked = parser.parse_args()
    if asked.sum:
        report([line for log in asked.sum for line in lines_of(log)])
        return 0
    if not asked.build or not asked.log:
        parser.error("expected BUILD and LOG, or --sum LOG...")
    goals = {kind: KINDS[kind][0] for kind in asked.only}
    for goal in asked.goal:
        kind, _, count = goal.partition("=")
        if kind not in goals or not count.isdigit():
            parser.error(f"{goal}: expected KIND=N with a kind of {', '.join(asked.only)}")
        goals[kind] = int(count)
    part, parts = (int(n) for n in asked.part.split("/"))
    lines, complete = [], False
    try:
        lines, complete = campaign(asked.build.resolve(), asked.log, asked.only, goals, asked.hours, part, parts)
    except KeyboardInterrupt:
        lines = lines_of(asked.log)
    report(lines)
    if any(not line["sound"] for line in lines):
        return 1
    return 0 if complete else INTERRUPTED


if __name__ == "__main__":
    sys.exit(main())
