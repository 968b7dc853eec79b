"""`stickslip convert IN OUT.csv`: one joint's record out of a log. What the reader guessed goes to standard error."""
from __future__ import annotations

import argparse
import contextlib
import os
import re
import signal
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from .logs import read_log
from .program import BAD_INPUT, INTERRUPTED, StickslipError

if TYPE_CHECKING:
    import pandas

INTERRUPTS = (signal.SIGINT, signal.SIGTERM)


def convert() -> int:
    parser = argparse.ArgumentParser(prog="stickslip convert", description="A record in CSV from a log: bags of ROS 2 and 1, Parquet, "
                                     "SAGE folder, BAM JSON, .npz, .mat, HDF5, NetCDF")
    parser.add_argument("log", metavar="IN")
    parser.add_argument("csv", metavar="OUT.csv")
    parser.add_argument("--joint", help="name of the joint, where the log has several")
    parser.add_argument("--topic", help="ROS: topic of the joint states")
    parser.add_argument("--command", help="ROS: topic of the commands")
    parser.add_argument("--time", help="arrays: name of the time")
    parser.add_argument("--group", help="HDF5, MATLAB: group or struct that holds the arrays")
    parser.add_argument("--episode", type=int, help="LeRobot: number of the episode")
    asked = parser.parse_args()
    options = {k: v for k, v in vars(asked).items() if k not in ("log", "csv", "joint") and v is not None}
    try:
        if not asked.csv.endswith((".csv", ".csv.gz")):
            raise StickslipError(f"{asked.csv}: got this as the file to write, expected a name that ends in .csv or .csv.gz")
        frame = read_log(asked.log, joint=asked.joint, **options)
        write_whole(Path(asked.csv), frame)
        ignore_interrupts()  # from here on there is nothing left to interrupt
    except StickslipError as error:
        complain(re.sub(r"\b(with|option) (joint|topic|command|time|group|episode)=", r"\1 --\2", str(error)))  # as it is said here
        return BAD_INPUT
    except OSError as error:
        complain(f"{error.filename or asked.csv}: {error.strerror}")
        return BAD_INPUT
    for guess in frame.attrs.get("guessed", []):
        complain(f"guessed: {guess}")
    try:
        print(f"{asked.csv}: {len(frame)} rows, columns {', '.join(frame.columns)}", flush=True)
    except OSError as error:
        complain(f"stickslip: the answer could not be written to standard output ({error.strerror})")
        return INTERRUPTED
    return 0


def write_whole(file: Path, frame: "pandas.DataFrame") -> None:
    """The record under another name until it is whole, so that a full disk or Ctrl-C leaves no half of it."""
    file.parent.mkdir(parents=True, exist_ok=True)
    part = file.with_name(file.name + ".part")
    try:
        frame.to_csv(part, index=False, compression="gzip" if file.name.endswith(".gz") else None)
        os.replace(part, file)
    except BaseException:
        part.unlink(missing_ok=True)
        raise


def ignore_interrupts() -> None:
    """To the end of the process: with SIG_IGN Python complains of one that is pending, and it forgets handlers before it ends."""
    signal.pthread_sigmask(signal.SIG_BLOCK, INTERRUPTS)
    for interrupt in INTERRUPTS:
        signal.signal(interrupt, lambda *_: None)


def hear(*_: object) -> None:
    """One interrupt is enough: a terminal and the program that started this one both send it."""
    ignore_interrupts()
    raise KeyboardInterrupt


def complain(text: object) -> None:
    """To standard error, where it can be written."""
    if sys.stderr is not None:
        with contextlib.suppress(OSError):
            print(text, file=sys.stderr, flush=True)


def main() -> int:
    """`convert`, and what an interrupt makes of it."""
    try:
        for interrupt in INTERRUPTS:
            signal.signal(interrupt, hear)
        signal.pthread_sigmask(signal.SIG_UNBLOCK, INTERRUPTS)  # `stickslip convert` starts with them blocked
        code = convert()
    except KeyboardInterrupt:
        complain("interrupted before the record was complete: nothing is written")
        code = INTERRUPTED
    for stream in (sys.stdout, sys.stderr):  # what they could not write has been told; the interpreter would add a code of its own
        with contextlib.suppress(OSError, ValueError, AttributeError):
            stream.flush()
    return code


if __name__ == "__main__":
    sys.exit(main())
