#!/usr/bin/env python3
"""Nothing broken in silence: a disk that fills up at any write of any verb, an output that nobody can take, Ctrl-C at any instant.

Disk: a verb runs once with room; then on disks that are too small by a random amount it must end by itself with a code of its own and
words that say so, and leave no file that is neither whole nor, while it was being written, under another name: JSON that is there can be
read. Output: the same with standard output on /dev/full. Ctrl-C: SIGINT at a random instant must end it with code 3 and the word
"interrupted", or with the code of an undisturbed run where that had come first; JSON that is there can be read.

Prints figures and FINDING lines. Run: silence.py STICKSLIP [TRIES] [SEED] [VERB...], as root (it mounts small disks in a namespace of its
own; code 77 where it may not)."""
import collections
import ctypes
import json
import math
import pathlib
import random
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
TRIES = int(sys.argv[2]) if len(sys.argv) > 2 else 3
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 20261124
ONLY = sys.argv[4:]
ROOM_KIB = 65_536
LONGEST = 300
SPACE = re.compile("no space|free|make room", re.IGNORECASE)
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples"
CORPUS = pathlib.Path(__file__).resolve().parents[1] / "fuzz/corpus"
CLONE_NEWNS, MS_REC, MS_PRIVATE = 0x20000, 0x4000, 0x40000

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


def inputs(folder):
    def run(*words):
        subprocess.run([PROGRAM, *words], cwd=folder, check=True, capture_output=True)
    shutil.copy(EXAMPLES / "02-ball-screw/joint-with-memory.toml", folder / "joint.toml")
    shutil.copy(CORPUS / "robot/arm.urdf", folder / "arm.urdf")
    (folder / "spec.toml").write_text(SMALL_SPEC)
    (folder / "motion.csv").write_text(REFERENCE)
    run("new", "joint", "--from", "joint.toml", "--plain", "--set", "control.period=1e-3", "--set",
        "control.velocity_estimate.form=exact", "-o", "loop.toml")
    run("simulate", "loop.toml", "--reference", "motion.csv", "-o", "driven")
    shutil.copy(folder / "driven/record.csv", folder / "record.csv")
    run("sweep", "spec.toml", "-o", "swept", "--no-report", "--keep-journal")
    run("diagnose", "loop.toml", "record.csv", "-o", "diagnosed")


def verbs():
    """Name: its words, OUT for where it writes."""
    k_p = "--along", "control.k_p=1e3..1e6"
    return {
        "sweep": ["sweep", "spec.toml", "-o", "OUT"],
        "boundary": ["boundary", "joint.toml", *k_p, "--along", "control.V0=1e-4..1e-2", "-o", "OUT"],
        "boundary-fold": ["boundary", "joint.toml", *k_p, "--kind", "fold", "-o", "OUT"],
        "design": ["design", str(EXAMPLES / "04-design/spec.toml"), "-o", "OUT"],
        "margins": ["margins", "joint.toml", "-o", "OUT"],
        "check": ["check", str(EXAMPLES / "02-ball-screw/spec-with-memory.toml"), str(EXAMPLES / "02-ball-screw/baseline.json"), "-o", "OUT"],
        "evaluate": ["evaluate", "joint.toml", "-o", "OUT"],
        "figures": ["figures", "-o", "OUT"],
        "merge": ["merge", "swept", "-o", "OUT"],
        "report": ["report", "swept", "swept", "-o", "OUT"],
        "simulate": ["simulate", "joint.toml", "-o", "OUT"],
        "record": ["simulate", "loop.toml", "--reference", "motion.csv", "-o", "OUT"],
        "new": ["new", "joint", "-o", "OUT"],
        "import": ["import", "arm.urdf", "--joint", "elbow", "-o", "OUT"],
        "export": ["export", "joint.toml", "--to", "mjcf"],
        "diagnose": ["diagnose", "loop.toml", "record.csv", "-o", "OUT"],
        "compare": ["compare", "diagnosed", "diagnosed", "-o", "OUT"],
        "timeline": ["timeline", "diagnosed", "-o", "OUT"],
        "plan": ["plan", "loop.toml", "motion.csv", "-o", "OUT"],
        "list": ["list", "keys"],
    }


class Disk:
    """A small disk for one run."""

    def __init__(self, kib):
        self.path = pathlib.Path(tempfile.mkdtemp(prefix="disk"))
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={kib}k", "tmpfs", self.path], check=True)

    def __enter__(self):
        return self.path

    def __exit__(self, *_):
        subprocess.run(["umount", "-l", self.path], check=False)
        self.path.rmdir()


class Findings:
    def __init__(self):
        self.count = collections.Counter()

    def add(self, verb, what, said=""):
        self.count[verb] += 1
        print(f"FINDING {verb}: {what}: {said.strip()[-300:]}", flush=True)


def words_for(words, out):
    return [str(PROGRAM), *(str(out) if w == "OUT" else w for w in words)]


def unreadable(folder):
    """JSON files that are there and are none."""
    broken = []
    for file in folder.rglob("*.json"):
        try:
            json.loads(file.read_bytes())
        except ValueError:
            broken.append(file.name)
    return broken


def used_kib(folder):
    return int(subprocess.run(["df", "--output=used", "-k", folder], capture_output=True, text=True, check=True).stdout.split()[-1])


def fill(verb, words, folder, rng, findings):
    """Disks with less room than the verb needs. Returns how many were tried."""
    if "OUT" not in words:
        return 0
    with Disk(ROOM_KIB) as disk:
        whole = subprocess.run(words_for(words, disk / "out"), cwd=folder, capture_output=True, text=True, timeout=LONGEST)
        need = used_kib(disk)
    if whole.returncode not in (0, 1, 4):
        findings.add(verb, f"undisturbed: code {whole.returncode}", whole.stderr)
        return 0
    for _ in range(TRIES):
        kib = 4 * rng.randint(1, max(1, need // 4 - 1))
        if kib >= need:
            continue
        with Disk(kib) as disk:
            done = subprocess.run(words_for(words, disk / "out"), cwd=folder, capture_output=True, text=True, timeout=LONGEST)
            if done.returncode in (0, 1, 4) or done.returncode < 0:
                findings.add(verb, f"{kib} of {need} KiB: code {done.returncode}", done.stderr)
            elif not SPACE.search(done.stderr):
                findings.add(verb, f"{kib} of {need} KiB: said without the word", done.stderr)
            if broken := unreadable(disk):
                findings.add(verb, f"{kib} of {need} KiB: left {broken}")
    return TRIES


def full_output(verb, words, folder, findings):
    with Disk(ROOM_KIB) as disk, open("/dev/full", "wb") as full:
        done = subprocess.run(words_for(words, disk / "out"), cwd=folder, stdout=full, stderr=subprocess.PIPE, text=True,
                              timeout=LONGEST)
        plain = subprocess.run(words_for(words, disk / "again"), cwd=folder, capture_output=True, text=True, timeout=LONGEST)
    if plain.stdout and (done.returncode in (0, 1, 4) or done.returncode < 0 or not SPACE.search(done.stderr)):
        findings.add(verb, f"/dev/full: code {done.returncode}", done.stderr)


def started(words, folder):
    """A run whose first line has been reached: until then, while the program is loaded, SIGINT is the system's."""
    run = subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    while run.poll() is None:
        try:
            caught = re.search(r"SigCgt:\s*([0-9a-f]+)", pathlib.Path(f"/proc/{run.pid}/status").read_text())
        except OSError:
            break
        if caught and int(caught.group(1), 16) >> (signal.SIGINT - 1) & 1:
            break
        time.sleep(0.001)
    return run


def interrupt(verb, words, folder, rng, findings):
    """SIGINT at random instants. Returns how many ended by it."""
    with Disk(ROOM_KIB) as disk:
        run = started(words_for(words, disk / "out"), folder)
        begin = time.monotonic()
        run.communicate(timeout=LONGEST)
        code, takes = run.returncode, time.monotonic() - begin
    ended = 0
    for _ in range(TRIES):
        with Disk(ROOM_KIB) as disk:
            victim = started(words_for(words, disk / "out"), folder)
            at = rng.uniform(0, takes)
            time.sleep(at)
            victim.send_signal(signal.SIGINT)
            try:
                said = victim.communicate(timeout=LONGEST)[1]
            except subprocess.TimeoutExpired:
                victim.kill()
                said = victim.communicate()[1]
                findings.add(verb, f"SIGINT after {at:.3f} s is not heard", said)
                continue
            ended += victim.returncode == 3
            if victim.returncode not in (3, code):
                findings.add(verb, f"SIGINT after {at:.3f} of {takes:.3f} s: code {victim.returncode}", said)
            elif victim.returncode == 3 and "interrupted" not in said.lower():
                findings.add(verb, f"SIGINT after {at:.3f} s: 3 without the word", said)
            if broken := unreadable(disk):
                findings.add(verb, f"SIGINT after {at:.3f} s: left {broken}")
    return ended


def main():
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNS) != 0 or libc.mount(b"none", b"/", None, MS_REC | MS_PRIVATE, None) != 0:
        print("skipped: no right to mount a small disk")
        return 77
    rng, findings, disks, outputs, heard = random.Random(SEED), Findings(), 0, 0, 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        inputs(folder)
        for verb, words in verbs().items():
            if ONLY and verb not in ONLY:
                continue
            disks += fill(verb, words, folder, rng, findings)
            full_output(verb, words, folder, findings)
            outputs += 1
            ended = interrupt(verb, words, folder, rng, findings)
            heard += ended
            print(f"{verb}: {ended} of {TRIES} instants ended it with code 3, findings {findings.count[verb]}", flush=True)
    print(f"silence: {disks} full disks, {outputs} outputs that nobody takes, {heard} interruptions heard, "
          f"findings: {sum(findings.count.values())}")
    return 1 if findings.count else 0


if __name__ == "__main__":
    sys.exit(main())
