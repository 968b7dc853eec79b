#!/usr/bin/env python3
"""Nothing broken in silence: a disk that fills up at any write of any verb, an output that nobody can take, Ctrl-C at any instant.

A verb runs once undisturbed; then, each time with the chance of a seed,
room     the disk of its output is too small by a random amount, or (one in two) so are its temporary files;
size     no file may be longer than a random number of bytes (RLIMIT_FSIZE, as a quota or a batch system sets it);
locked   its output may not be written (a disk mounted read-only).
It must end by itself with code 2 or 3 and words that say why, and leave no file that is neither whole nor under another name.
output   standard output on /dev/full, and closed: the same.
words    standard error on /dev/full, and closed: code, output and files are those of the undisturbed run.
Ctrl-C   SIGINT or SIGTERM at a random instant, to the program or as a terminal sends it to all of its processes: code 3 and the word
         "interrupted", or the code of the undisturbed run where that had come first; JSON that is there can be read, and no process is
         left behind.

Prints figures and FINDING lines. Run: silence.py STICKSLIP [TRIES] [SEED] [VERB...], as root (it mounts small disks in a namespace of its
own; code 77 where it may not)."""
import collections
import ctypes
import json
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time

from silence_verbs import TESTS, inputs, verbs

PROGRAM = pathlib.Path(sys.argv[1]).resolve()
TRIES = int(sys.argv[2]) if len(sys.argv) > 2 else 3
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 20261124
ONLY = sys.argv[4:]
ROOM_KIB = 65_536
LONGEST = 300
SLOW_TO_HEAR = 60  # s; a task of a diagnosis takes a few of computing, and the machine may be busy
REFUSED = (2, 3)
ANSWERED = (0, 1, 4)
SPACE = re.compile("no space|free|make room|too large|read-only|permission|bad file descriptor", re.IGNORECASE)
PASSING = re.compile(r"\.part$|\.partial$|\.probe$|\.journal$|\.lock$|\.\d+$")  # names of what is being written, or is a journal
RUN = re.compile(r"run\.(\d+\.)?json$")  # has times
KEEP_ANSWERS = ("calibrate", "blind")  # they write what is answered case by case, each time a whole file
CLONE_NEWNS, MS_RDONLY, MS_REMOUNT, MS_REC, MS_PRIVATE = 0x20000, 1, 32, 0x4000, 0x40000
ENVIRONMENT = {**os.environ, "PATH": f"{pathlib.Path(sys.executable).parent}:{os.environ.get('PATH', '')}", "PYTHONPATH": str(TESTS.parent / "python"),
               "PYTHONDONTWRITEBYTECODE": "1"}


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


class Verb:
    """One verb with what its undisturbed run left."""

    def __init__(self, name, words, folder, findings):
        self.name, self.words, self.folder, self.findings = name, words, folder, findings
        self.writes = any("OUT" in word for word in words)
        with Disk(ROOM_KIB) as disk:
            begin = time.monotonic()
            self.whole = self.run(disk)
            self.seconds = time.monotonic() - begin
            self.need = used_kib(disk)
            self.sizes = sizes_of(disk)
        if self.whole.returncode not in ANSWERED:
            self.find(f"undisturbed: code {self.whole.returncode}", self.whole.stderr)

    def command(self, disk):
        return [str(PROGRAM), *(word.replace("OUT", str(disk / "out")) for word in self.words)]

    def run(self, disk, **how):
        how = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, "env": ENVIRONMENT, **how}
        return subprocess.run(self.command(disk), cwd=self.folder, text=True, timeout=LONGEST, **how)

    def find(self, what, said=""):
        self.findings.add(self.name, what, said or "")

    def judge_refusal(self, what, done, disk):
        """Of a run that could not write all of its answer."""
        if done.returncode not in REFUSED:
            self.find(f"{what}: code {done.returncode}", done.stderr)
        elif not SPACE.search(done.stderr or ""):
            self.find(f"{what}: said without the reason", done.stderr)
        elif "Traceback" in done.stderr:
            self.find(f"{what}: a traceback", done.stderr)
        self.judge_files(what, disk)

    def judge_files(self, what, disk):
        if broken := unreadable(disk):
            self.find(f"{what}: left {broken}")
        for file, size in sizes_of(disk).items():
            if size < self.sizes.get(file, 0) and not (RUN.search(file) or self.name in KEEP_ANSWERS):
                self.find(f"{what}: left {file} with {size} of {self.sizes[file]} bytes")


def unreadable(folder):
    """JSON files that are there and are none."""
    broken = []
    for file in folder.rglob("*.json"):
        try:
            json.loads(file.read_bytes())
        except ValueError:
            broken.append(file.name)
    return broken


def sizes_of(folder):
    return {str(file.relative_to(folder)): file.stat().st_size for file in folder.rglob("*")
            if file.is_file() and not PASSING.search(file.name)}


def used_kib(folder):
    return int(subprocess.run(["df", "--output=used", "-k", folder], capture_output=True, text=True, check=True).stdout.split()[-1])


def rooms(verb, rng):
    """Disks with less room than the verb needs, for its output or for its temporary files. Returns how many were tried."""
    tried = 0
    for attempt in range(TRIES):
        kib = 4 * rng.randint(1, max(1, verb.need // 4 - 1))
        if attempt % 2:  # nothing else tells how much of them there is
            with Disk(4 * rng.randint(1, 8)) as small, Disk(ROOM_KIB) as disk:
                done = verb.run(disk, env={**ENVIRONMENT, "TMPDIR": str(small)})
                if done.returncode != verb.whole.returncode or set(sizes_of(disk)) != set(verb.sizes):
                    verb.judge_refusal("no room for temporary files", done, disk)
                if left := [file.name for file in small.iterdir()]:
                    verb.find(f"no room for temporary files: left {left}")
        elif verb.writes and kib < verb.need:
            with Disk(kib) as disk:
                verb.judge_refusal(f"{kib} of {verb.need} KiB", verb.run(disk), disk)
        tried += 1
    return tried


def sizes(verb, rng):
    """Files that may not grow beyond a random size."""
    longest = max(verb.sizes.values(), default=0)
    tries = TRIES if longest > 1 else 0
    for _ in range(tries):
        most = rng.randint(1, longest - 1) if rng.random() < 0.5 else int(longest ** rng.random())
        with Disk(ROOM_KIB) as disk:
            done = verb.run(disk, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (most, most)))
            verb.judge_refusal(f"files of {most} of {longest} bytes at most", done, disk)
    return tries


def locked(verb, libc):
    if not verb.writes:
        return 0
    with Disk(ROOM_KIB) as disk:
        libc.mount(b"none", str(disk).encode(), None, MS_REMOUNT | MS_RDONLY, None)
        verb.judge_refusal("read-only", verb.run(disk), disk)
    return 1


def outputs(verb):
    """Standard output that takes nothing."""
    if not verb.whole.stdout:
        return 0
    for what in ("/dev/full", "closed"):
        with Disk(ROOM_KIB) as disk, open("/dev/full", "wb") as full:
            how = {"stdout": full} if what == "/dev/full" else {"stdout": None, "preexec_fn": lambda: os.close(1)}
            verb.judge_refusal(f"standard output {what}", verb.run(disk, **how), disk)
    return 2


def unheard_words(verb):
    """Standard error that takes nothing."""
    for what in ("/dev/full", "closed"):
        with Disk(ROOM_KIB) as disk, open("/dev/full", "wb") as full:
            how = {"stderr": full} if what == "/dev/full" else {"stderr": None, "preexec_fn": lambda: os.close(2)}
            done = verb.run(disk, **how)
            if done.returncode != verb.whole.returncode:
                verb.find(f"standard error {what}: code {done.returncode}, not {verb.whole.returncode}", done.stdout)
            verb.judge_files(f"standard error {what}", disk)
            if set(sizes_of(disk)) != set(verb.sizes):
                verb.find(f"standard error {what}: files {sorted(set(sizes_of(disk)) ^ set(verb.sizes))}")
    return 2


def started(command, folder):
    """A run whose first line has been reached: until then, while the program is loaded, SIGINT is the system's."""
    run = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT,
                           start_new_session=True)
    while run.poll() is None:
        try:
            caught = re.search(r"SigCgt:\s*([0-9a-f]+)", pathlib.Path(f"/proc/{run.pid}/status").read_text())
        except OSError:
            break
        if caught and int(caught.group(1), 16) >> (signal.SIGINT - 1) & 1:
            break
        time.sleep(0.001)
    return run


def left_behind(session):
    """Processes of a session whose leader has ended."""
    left = []
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = stat.read_text().rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[3]) == session and fields[0] != "Z":
            left.append(int(stat.parent.name))
    return left


def interrupt(verb, rng):
    """SIGINT or SIGTERM at random instants. Returns how many ended by it."""
    ended = 0
    for attempt in range(TRIES):
        with Disk(ROOM_KIB) as disk, Disk(ROOM_KIB) as temporary:
            ENVIRONMENT["TMPDIR"] = str(temporary)
            victim = started(verb.command(disk), verb.folder)
            del ENVIRONMENT["TMPDIR"]
            at, by, all_of_it = rng.uniform(0, verb.seconds), rng.choice((signal.SIGINT, signal.SIGTERM)), attempt % 2
            what = f"{by.name}{' to all' if all_of_it else ''} after {at:.3f} of {verb.seconds:.3f} s"
            time.sleep(at)
            begin = time.monotonic()
            if victim.poll() is None:
                (os.killpg if all_of_it else os.kill)(victim.pid, by)
            try:
                out, said = victim.communicate(timeout=LONGEST)
            except subprocess.TimeoutExpired:
                os.killpg(victim.pid, signal.SIGKILL)
                verb.find(f"{what} is not heard", victim.communicate()[1])
                continue
            took = time.monotonic() - begin
            ended += victim.returncode == 3
            if victim.returncode not in (3, verb.whole.returncode):
                verb.find(f"{what}: code {victim.returncode}", said)
            elif victim.returncode == 3 and ("interrupted" not in (out + said).lower() or "Traceback" in said):
                verb.find(f"{what}: 3 without the word", said)
            elif victim.returncode == 3 and took > SLOW_TO_HEAR:
                verb.find(f"{what}: heard after {took:.0f} s only", said)
            if broken := unreadable(disk):
                verb.find(f"{what}: left {broken}")
            if left := left_behind(victim.pid):
                verb.find(f"{what}: left processes behind: {left}")
                os.killpg(victim.pid, signal.SIGKILL)
            if left := [file.name for file in temporary.iterdir()]:
                verb.find(f"{what}: left temporary files: {left}")
    return ended


def unlisted(words_of_verbs):
    """Verbs of the program that silence_verbs.py does not run."""
    said = subprocess.run([PROGRAM], capture_output=True, text=True).stderr
    there = re.search(r"Commands: ([^.]+)\.", said).group(1).split(", ")
    return sorted(set(there) - {words[0] for words in words_of_verbs})


def main():
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNS) != 0 or libc.mount(b"none", b"/", None, MS_REC | MS_PRIVATE, None) != 0:
        print("skipped: no right to mount a small disk")
        return 77
    findings, disks, streams, heard = Findings(), 0, 0, 0
    for verb in unlisted(verbs().values()):
        findings.add(verb, "is not among the verbs of silence_verbs.py")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        inputs(PROGRAM, folder)
        for name, words in verbs().items():
            if ONLY and name not in ONLY:
                continue
            rng = random.Random(f"{SEED} {name}")  # the same faults where a verb runs alone
            verb = Verb(name, words, folder, findings)
            disks += rooms(verb, rng) + sizes(verb, rng) + locked(verb, libc)
            streams += outputs(verb) + unheard_words(verb)
            ended = interrupt(verb, rng)
            heard += ended
            print(f"{name}: {ended} of {TRIES} instants ended it with code 3, findings {findings.count[name]}", flush=True)
    print(f"silence: {disks} full disks, {streams} outputs that nobody takes, {heard} interruptions heard, "
          f"findings: {sum(findings.count.values())}")
    return 1 if findings.count else 0


if __name__ == "__main__":
    sys.exit(main())
