"""Records as data frames: checked, and written the way that the program reads them."""
from __future__ import annotations

import re
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Mapping

from .logs import read_log
from .program import StickslipError

if TYPE_CHECKING:
    import pandas


LONGEST_FILE_NAME = 255  # bytes, of every common file system


def _numbers(where: str, given: "pandas.Series") -> "pandas.Series":
    """The column in plain numbers, of whatever kind pandas has them: nullable, Arrow's, categories, text, objects."""
    import numpy
    import pandas
    from pandas.api import types

    if types.is_bool_dtype(given.dtype):
        given = given.astype(float) if given.dtype == bool else given.astype("Float64")
    if types.is_complex_dtype(given.dtype) or types.is_datetime64_any_dtype(given.dtype) or types.is_timedelta64_dtype(given.dtype):
        raise StickslipError(f"{where} holds {given.dtype}, expected numbers")
    if types.is_numeric_dtype(given.dtype):
        plain = isinstance(given.dtype, numpy.dtype)  # whole numbers stay whole: nanoseconds have more digits than a float
        return given if plain else pandas.Series(given.to_numpy(dtype=float, na_value=numpy.nan), index=given.index)
    values = pandas.to_numeric(given.astype(object), errors="coerce")
    if types.is_complex_dtype(values.dtype):
        raise StickslipError(f"{where} holds complex numbers, expected real ones")
    wrong = numpy.flatnonzero((values.isna() & given.notna()).to_numpy())
    if len(wrong):
        raise StickslipError(f"{where}, row {wrong[0]}: got {given.iloc[wrong[0]]!r}, expected a number")
    return values


def _seconds(times: "pandas.Series") -> "pandas.Series":
    """Dates and durations as seconds since the first; other times as they are."""
    from pandas.api import types

    if types.is_datetime64_any_dtype(times.dtype) or types.is_timedelta64_dtype(times.dtype):
        return (times - times.iloc[0]).dt.total_seconds()
    return times


def _table(name: str, record: Any) -> "pandas.DataFrame":
    """Data frame, dict of columns, NumPy array with named fields, or xarray's Dataset over one dimension."""
    import numpy
    import pandas

    if isinstance(record, numpy.ndarray) and record.dtype.names and record.ndim == 1:
        record = pandas.DataFrame({field: record[field] for field in record.dtype.names})
    elif hasattr(record, "to_dataframe") and hasattr(record, "dims"):
        if len(record.dims) != 1:
            raise StickslipError(f"{name}: got a dataset over {', '.join(map(str, record.dims))}, expected one over time alone")
        record = record.to_dataframe()
    elif not isinstance(record, (pandas.DataFrame, Mapping)):
        raise StickslipError(f"{name}: got {type(record).__name__}, expected a data frame, a dict of columns, an array with named "
                             "fields, or a file")
    try:
        return pandas.DataFrame(record)
    except (TypeError, ValueError) as error:
        raise StickslipError(f"{name}: {error}") from None


def as_frame(name: str, record: Any) -> "pandas.DataFrame":
    """A data frame whose columns are numbers where they can be; times are seconds. Other columns stay as they are: a log may
    have some that nobody reads, and the program complains about those that it does."""
    import pandas
    from pandas.api import types

    frame = _table(name, record)
    dated = types.is_datetime64_any_dtype(frame.index.dtype) or types.is_timedelta64_dtype(frame.index.dtype)
    if "time" not in frame.columns and (dated or frame.index.name == "time"):
        frame = frame.rename_axis("time").reset_index()
    if frame.empty:
        raise StickslipError(f"{name}: has no rows")
    for column in frame.columns:
        if not isinstance(column, str):
            raise StickslipError(f"{name}: got {column!r} as the name of a column, expected text")
    twice = frame.columns[frame.columns.duplicated()]
    if len(twice):
        raise StickslipError(f"{name}: got {list(frame.columns).count(twice[0])} columns called {twice[0]!r}, expected one")

    def plain(column: str) -> "pandas.Series":
        given = _seconds(frame[column]) if column == "time" else frame[column]
        try:
            return _numbers(column, given)
        except StickslipError:
            return given

    return pandas.DataFrame({column: plain(column) for column in frame.columns})


def numbers_of(name: str, frame: "pandas.DataFrame", column: str) -> "pandas.Series":
    """One column in which every row has a finite number; complains by record, column and row about everything else."""
    import numpy

    if column not in frame:
        raise StickslipError(f"{name}: has no column {column}, it has {', '.join(frame.columns)}")
    values = _numbers(f"{name}: column {column!r}", frame[column])
    for wrong, said in ((values.isna(), "has no value; remove such rows or fill them"),
                        (numpy.isinf(values.astype(float)), "is infinite, expected a finite number")):
        if wrong.any():
            raise StickslipError(f"{name}: column {column!r}, row {int(numpy.flatnonzero(wrong.to_numpy())[0])}: {said}")
    return values


def write_csv(frame: "pandas.DataFrame", file: Path) -> None:
    """With all digits. Text that a record may have beside its signals stays in one cell: the program's tables have no quotes."""
    from pandas.api import types

    def one_cell(value: Any) -> Any:
        return re.sub(r'[",\s]+', " ", str(value))

    frame.assign(**{column: frame[column].map(one_cell, na_action="ignore") for column in frame.columns
                    if not types.is_numeric_dtype(frame[column].dtype)}).to_csv(file, index=False)


def write_record(name: str, record: Any, folder: Path, log: Mapping[str, Any]) -> Path:
    """The record as CSV with all digits. A file in CSV stays where it is; logs are read with the options in `log`."""
    if not isinstance(name, str):
        raise TypeError(f"records: got {name!r} as the name of a record, expected text, {{\"run1\": frame}}")
    if isinstance(record, (str, Path)):
        if str(record).lower().endswith((".csv", ".csv.gz")):
            return Path(record)
        record = read_log(record, **log)
    frame = as_frame(name, record)
    file = folder / (re.sub(r"[^\w.-]+", "-", name) + ".csv")
    if len(file.name.encode()) > LONGEST_FILE_NAME:
        raise StickslipError(f"records: got a name of {len(name)} characters, {name[:30]!r}…; a file is written under it, whose name "
                             f"may have {LONGEST_FILE_NAME} bytes with its ending .csv")
    if file.exists():
        raise StickslipError(f"{name}: two records would be written as {file.name}; give them different names")
    write_csv(frame, file)
    return file


@contextmanager
def told_of_records(folder: str) -> Iterator[None]:
    """Errors about files that `write_record` made in the folder name the record and the row of its data frame."""
    def place(found: re.Match) -> str:
        row = int(found[2]) - 2  # behind the header, from 0
        return f"{found[1]}: " + (f"row {row}: " if row >= 0 else "")

    try:
        yield
    except StickslipError as error:
        text = re.sub(re.escape(folder) + r"/([^/\s]+)\.csv:(\d+):\d+: ", place, str(error))
        raise type(error)(text.replace(folder + "/", "")) from None
