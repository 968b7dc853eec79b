"""What the readers share: choosing a joint, merging topics in time, saying what was guessed."""
from __future__ import annotations

import difflib
from pathlib import Path
from typing import Any, Sequence

from ..program import StickslipError


def joint_index(source: str, names: Sequence[str], joint: str | None) -> int:
    """Place of the joint among names; complains about none, several and unknown ones."""
    listed = ", ".join(names) or "none"
    if joint is None:
        if len(names) == 1:
            return 0
        raise StickslipError(f"{source}: has the joints {listed}; say which with joint=")
    found = [i for i, name in enumerate(names) if name == joint]
    if len(found) > 1:
        raise StickslipError(f"{source}: has {len(found)} joints called {joint!r}, expected one")
    if not found:
        near = difflib.get_close_matches(joint, names, 1)
        raise StickslipError(f"{source}: has no joint {joint!r}, it has {listed}" + (f"; did you mean {near[0]!r}?" if near else ""))
    return found[0]


def frame_of(source: Path | str, columns: dict[str, Any], guessed: Sequence[str] = ()):
    """Columns of equal length, rows in order of time, time from 0; rows without a value are left out and counted."""
    import numpy
    import pandas

    lengths = {name: len(values) for name, values in columns.items()}
    if len(set(lengths.values())) > 1:
        raise StickslipError(f"{source}: columns differ in length: " + ", ".join(f"{n} {k}" for n, k in lengths.items()))
    if "time" not in columns:
        raise StickslipError(f"{source}: has no time")
    frame = pandas.DataFrame({name: numpy.asarray(values, dtype=float) for name, values in columns.items()})
    guessed = list(guessed)
    finite = frame.replace([numpy.inf, -numpy.inf], numpy.nan)
    complete = finite.drop(columns=[name for name in frame if name != "time" and finite[name].isna().all()]).dropna()
    if len(complete) < len(frame):
        guessed.append(f"{len(frame) - len(complete)} of {len(frame)} rows lack a value and were left out")
    if not complete["time"].is_monotonic_increasing:
        complete = complete.sort_values("time", kind="stable")
        guessed.append("rows were not in order of time and were sorted")
    if complete.empty:
        raise StickslipError(f"{source}: has no complete row")
    with numpy.errstate(over="ignore"):
        from_zero = complete["time"] - complete["time"].iloc[0]
    if not numpy.isfinite(from_zero).all():
        raise StickslipError(f"{source}: its times reach from {complete['time'].iloc[0]:.3g} to {complete['time'].iloc[-1]:.3g}")
    complete = complete.assign(time=from_zero)
    twice = complete["time"].duplicated()  # of times from zero: far from it, two that differ may give one
    if bool(twice.any()):
        complete = complete[~twice]
        guessed.append(f"{int(twice.sum())} rows with the time of the one before were left out")
    complete = complete.reset_index(drop=True)
    complete.attrs["guessed"] = guessed
    return complete


def held(times, at, values):
    """What was last sent at each of the times: commands hold until the next one. NaN before the first."""
    import numpy

    index = numpy.searchsorted(numpy.asarray(at), numpy.asarray(times), side="right") - 1
    out = numpy.asarray(values, dtype=float)[numpy.maximum(index, 0)]
    return numpy.where(index < 0, numpy.nan, out)
