"""Logs as they are, as data frames in the columns of a record: time, reference_position, position, velocity, effort_measured, ….

>>> frame = stickslip.read_log("run.mcap", joint="elbow")
>>> frame.attrs["guessed"]      # what the log does not say and the reader assumed
"""
from __future__ import annotations

import inspect
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Mapping

from ..program import StickslipError
from . import arrays, bam, mcap, parquet, ros2_bag, rosbag, sage

if TYPE_CHECKING:
    import pandas

_BY_SUFFIX: dict[str, Callable[..., "pandas.DataFrame"]] = {
    ".mcap": mcap.read, ".db3": ros2_bag.read_database, ".bag": rosbag.read, ".parquet": parquet.read, ".json": bam.read,
    ".npz": arrays.read_npz, ".mat": arrays.read_mat, ".h5": arrays.read_hdf5, ".hdf5": arrays.read_hdf5, ".nc": arrays.read_netcdf,
}


def _check_options(path: Path, reader: Callable[..., "pandas.DataFrame"], options: Mapping[str, Any]) -> None:
    """Readers take options of their own and hand the others on to those of arrays."""
    known: list[str] = []
    functions: tuple[Callable[..., Any], ...] = (reader, arrays.columns_of)
    for function in functions:
        taken = inspect.signature(function).parameters
        known += [name for name, p in taken.items() if p.kind is p.POSITIONAL_OR_KEYWORD and name not in ("path", "joint", "arrays", *known)]
        if not any(p.kind is p.VAR_KEYWORD for p in taken.values()):
            break
    for name in options:
        if name not in known:
            raise StickslipError(f"{path}: logs of this kind take no option {name}=, they take {', '.join(known) or 'none'}")


def read_log(file: str | Path, joint: str | None = None, **options: Any) -> "pandas.DataFrame":
    """Reads one joint's record from a log; the format follows from the suffix, a folder is a bag of ROS 2 or SAGE's. `joint` is its name
    where the log has several. Options are those of the format's reader (topics, column names).

    The frame has a row for each sample: time [s], positions [rad or m], velocities, efforts [N·m or N]; frame.attrs["guessed"] lists what
    the log does not say and was assumed. Raises StickslipError for a file that is damaged, of another kind, or without that joint.
    """
    path = Path(file)
    if not path.exists():
        raise StickslipError(f"{path}: there is no such file")
    reader: Callable[..., "pandas.DataFrame"] | None = _BY_SUFFIX.get(path.suffix.lower())
    if path.is_dir():
        reader = ros2_bag.read_folder if ros2_bag.is_bag(path) else sage.read
    if reader is None and path.name.lower().endswith((".csv", ".csv.gz")):
        import pandas

        return pandas.read_csv(path)
    if reader is None:
        raise StickslipError(f"{path}: got a file {path.suffix or 'without suffix'}, expected {', '.join(_BY_SUFFIX)}, .csv, a bag of ROS 2 or a folder of SAGE")
    _check_options(path, reader, options)
    try:
        return reader(path, joint=joint, **options)
    except StickslipError:
        raise
    except ImportError as error:
        raise StickslipError(f"{path}: reading it needs {error.name} in this Python, {sys.executable} (Debian: python3-{error.name})") from None
    except MemoryError:
        raise StickslipError(f"{path}: is damaged: a size in it exceeds memory") from None
    except Exception as error:  # whatever a parser trips over in a damaged file
        raise StickslipError(f"{path}: is damaged or of another kind than its suffix says: {str(error).strip()}") from error
