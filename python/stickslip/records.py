"""Records as data frames: checked, and written the way that the program reads them."""
from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Mapping

from .logs import read_log
from .program import StickslipError


def as_frame(name: str, record: Any):
    """A data frame of plain numbers; complains by record, column and row about everything else."""
    import numpy
    import pandas

    if not isinstance(record, (pandas.DataFrame, Mapping)):
        raise StickslipError(f"{name}: got {type(record).__name__}, expected a data frame, a dict of columns, or a file")
    try:
        frame = pandas.DataFrame(record)
    except ValueError as error:
        raise StickslipError(f"{name}: {error}") from None
    if frame.empty:
        raise StickslipError(f"{name}: has no rows")
    for column in frame.columns:
        if not isinstance(column, str):
            raise StickslipError(f"{name}: got {column!r} as the name of a column, expected text")
    twice = frame.columns[frame.columns.duplicated()]
    if len(twice):
        raise StickslipError(f"{name}: got {list(frame.columns).count(twice[0])} columns called {twice[0]!r}, expected one")
    columns = {}
    for column in frame.columns:
        given = frame[column]
        if given.dtype == bool:
            given = given.astype(int)
        values = pandas.to_numeric(given, errors="coerce") if given.dtype == object else given
        if not numpy.issubdtype(values.dtype, numpy.number) or numpy.issubdtype(values.dtype, numpy.complexfloating):
            raise StickslipError(f"{name}: column {column!r} holds {given.dtype}, expected numbers (times in seconds)")
        if given.dtype == object and bool((values.isna() & given.notna()).any()):
            row = int(numpy.flatnonzero((values.isna() & given.notna()).to_numpy())[0])
            raise StickslipError(f"{name}: column {column!r}, row {row}: got {given.iloc[row]!r}, expected a number")
        columns[str(column)] = values
    clean = pandas.DataFrame(columns)
    missing = clean.columns[clean.isna().any()]
    if len(missing):
        row = int(numpy.flatnonzero(clean[missing[0]].isna().to_numpy())[0])
        raise StickslipError(f"{name}: column {missing[0]!r}, row {row}: has no value; remove such rows or fill them")
    return clean


def write_record(name: str, record: Any, folder: Path, log: Mapping[str, Any]) -> Path:
    """The record as CSV with all digits. A file in CSV stays where it is; logs are read with the options in `log`."""
    if isinstance(record, (str, Path)):
        if str(record).lower().endswith((".csv", ".csv.gz")):
            return Path(record)
        record = read_log(record, **log)
    frame = as_frame(name, record)
    file = folder / (re.sub(r"[^\w.-]+", "-", name) + ".csv")
    if file.exists():
        raise StickslipError(f"{name}: two records would be written as {file.name}; give them different names")
    frame.to_csv(file, index=False)
    return file
