"""The program that computes everything. Each call is a process of its own: answers are the program's JSON, an interrupt
ends it cleanly, and other threads of Python go on meanwhile."""
from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
import sys
import threading
from pathlib import Path
from typing import Any, Sequence

from . import progress

DONE, CHECK_FAILED, BAD_INPUT, INTERRUPTED, UNDECIDED = range(5)
SLOW = ("sweep", "diagnose", "check")  # verbs that draw a line of progress


class StickslipError(Exception):
    """The program refused the input. The message says file, line, what it got and what it expected."""


class Interrupted(StickslipError):
    """The program stopped before it was done, for want of space or by a signal; a sweep can be resumed."""


def executable() -> str:
    """Path of the program: STICKSLIP_PROGRAM, the one of this wheel, or `stickslip` on the PATH. Raises StickslipError where there is none."""
    asked = os.environ.get("STICKSLIP_PROGRAM")
    own = Path(__file__).parent / "bin" / "stickslip"
    found = asked or (str(own) if own.exists() else shutil.which("stickslip"))
    if not found:
        raise StickslipError("the program stickslip was not found: install its package, or set STICKSLIP_PROGRAM to its path")
    return found


def _environment() -> dict[str, str]:
    """So that logs which the program hands to Python's readers are read by this Python and this package."""
    environment = dict(os.environ)
    package = str(Path(__file__).resolve().parent.parent)
    for name, place in (("PATH", os.path.dirname(sys.executable)), ("PYTHONPATH", package)):
        before = environment.get(name)
        environment[name] = place + (os.pathsep + before if before else "")
    return environment


def _communicate(process: subprocess.Popen, terminal: int | None, show: progress.Show | None) -> tuple[str, str]:
    if terminal is None or show is None:
        return process.communicate()
    listener = progress.Listener(show)
    reader = threading.Thread(target=progress.read_all, args=(terminal, listener), daemon=True)
    reader.start()
    out = process.communicate()[0]
    reader.join()
    return out, listener.end()


def _reasons(out: str) -> str:
    """Why an answer in JSON is a refusal, such as records in units that contradict the joint."""
    try:
        return "\n".join(json.loads(out)["reasons"])
    except (ValueError, TypeError, KeyError):
        return ""


def _terminal() -> tuple[int | None, int]:
    """Both ends of a pseudo-terminal; where the machine has none, such as in a container without /dev/pts, progress is not shown."""
    try:
        return os.openpty()
    except OSError:
        return None, subprocess.PIPE


def run(arguments: Sequence[Any], allowed: Sequence[int] = (DONE, CHECK_FAILED, UNDECIDED),
        show: progress.Show | None = None) -> subprocess.CompletedProcess:
    """Runs `stickslip ARGUMENTS` and returns what it printed. Ctrl-C (or the stop button of a notebook) interrupts the
    program, waits for it to keep what it has, and raises KeyboardInterrupt. `show` is told the line of progress each time
    that it changes; by default it stands below the cell of a notebook or on the terminal."""
    command = [executable(), *map(str, arguments)]
    show = show or (progress.default() if command[1] in SLOW else None)
    terminal, error = (None, subprocess.PIPE) if show is None else _terminal()
    process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=error, text=True, encoding="utf-8",
                               start_new_session=True, env=_environment())
    if terminal is not None:
        os.close(error)
    try:
        out, err = _communicate(process, terminal, show)
    except BaseException:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        raise
    if process.returncode not in allowed:
        message = err.strip() or _reasons(out) or out.strip() or f"ended with {process.returncode}"
        raise (Interrupted if process.returncode == INTERRUPTED else StickslipError)(message)
    return subprocess.CompletedProcess(command, process.returncode, out, err)


def answer_of(arguments: Sequence[Any], **options: Any) -> Any:
    """The JSON that `stickslip ARGUMENTS --json` prints."""
    return json.loads(run([*arguments, "--json"], **options).stdout)


def version() -> str:
    """Version of the program, "0.2.0"."""
    return run(["--version"]).stdout.split()[-1]
