"""Files of arrays: .npz, MATLAB, HDF5, NetCDF. Every one-dimensional array of the length of the time is a column."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Mapping

from ..program import StickslipError
from .apart import read_apart
from .common import frame_of, joint_index

_TIMES = ("t", "time", "timestamp", "timestamps", "Time", "T")
_SAME = {"q": "position", "qd": "velocity", "dq": "velocity", "q_ref": "reference_position", "q_des": "reference_position", "reference": "reference_position", "tau": "effort_measured",
         "torque": "effort_measured", "effort": "effort_measured", "joint_positions": "position", "joint_velocities": "velocity",
         "joint_efforts": "effort_measured", "positions": "position", "velocities": "velocity", "torques": "effort_measured",
         "command": "effort_command", "u": "effort_command"}


def _seconds(time: Any) -> tuple[Any, str]:
    """Times from their beginning, and the unit if it is another one than s: the longest that makes rows closer than half a second,
    since whoever logs less often sees no friction. Whole numbers of nanoseconds have more digits than a float."""
    import numpy

    if time.dtype.kind == "M":
        return (time - time[0]) / numpy.timedelta64(1, "s"), ""
    if time.ndim != 1 or len(time) < 2 or time.dtype.kind == "b":
        return time.astype(float), ""
    from_start = (time.astype("int64") - int(time[0]) if time.dtype.kind in "iu" else time).astype(float)
    step = numpy.median(numpy.abs(numpy.diff(from_start)))
    if not step >= 0.5 or numpy.isinf(step):
        return time.astype(float), ""
    for unit, factor in (("ms", 1e-3), ("µs", 1e-6), ("ns", 1e-9)):
        if step * factor < 0.5:
            return from_start * factor, unit
    return time.astype(float), ""


def columns_of(path: Path, arrays: Mapping[str, Any], joint: str | None, time: str | None = None, columns: Mapping[str, str] | None = None):
    """`columns` renames arrays: {"my_angle": "position"}. Two-dimensional ones hold a joint a column."""
    import numpy

    found = {name: numpy.squeeze(numpy.asarray(value)) for name, value in arrays.items()}
    found = {name: value for name, value in found.items() if value.dtype.kind in "fiubM" and value.ndim in (1, 2)}
    key = time or next((name for name in _TIMES if name in found), None)
    if key is None or key not in found:
        raise StickslipError(f"{path}: has no time among {', '.join(arrays) or 'nothing'}; say which array it is with time=")
    rows = len(found[key])
    names = [str(n) for n in numpy.ravel(arrays["joint_names"])] if "joint_names" in arrays else []
    seconds, unit = _seconds(found[key])
    out, guessed = {"time": seconds}, [f"array {key} read as {unit}, from its step"] if unit else []
    for name, value in found.items():
        if name == key or len(value) != rows or value.dtype.kind == "M":
            continue
        ours = (columns or {}).get(name, name if columns else _SAME.get(name, name))
        if ours != name and not (columns or {}).get(name):
            guessed.append(f"array {name} read as {ours}")
        if value.ndim == 2:
            names = names or [str(i) for i in range(value.shape[1])]
            if len(names) != value.shape[1]:
                raise StickslipError(f"{path}: array {name} has {value.shape[1]} columns, there are {len(names)} joints")
            value = value[:, joint_index(f"{path}: array {name}", names, joint)]
        out[ours] = value.astype(float)
    if len(out) == 1:
        raise StickslipError(f"{path}: no array has the {rows} rows of the time")
    guessed.append("units read as SI: the file does not say")
    return frame_of(path, out, guessed)


def read_npz(path: Path, joint: str | None = None, **options: Any):
    import numpy

    with numpy.load(path, allow_pickle=False) as file:
        return columns_of(path, {name: file[name] for name in file.files}, joint, **options)


def read_mat(path: Path, joint: str | None = None, **options: Any):
    import importlib.util

    with path.open("rb") as file:
        if file.read(128)[:10] != b"MATLAB 5.0":
            return read_hdf5(path, joint, **options)  # MATLAB 7.3 is HDF5
    if importlib.util.find_spec("scipy") is None:
        raise StickslipError(f"{path}: reading .mat needs scipy (Debian: python3-scipy)")
    arrays = read_apart("scipy.io:loadmat", path, squeeze_me=True)
    arrays = {name: value for name, value in arrays.items() if not name.startswith("__")}
    flat: dict[str, Any] = {}
    for name, value in arrays.items():
        if value.dtype.names:  # a struct: its fields
            for field in value.dtype.names:
                flat[field] = value[field].item() if value[field].dtype == object and value[field].size == 1 else value[field]
        else:
            flat[name] = value
    return columns_of(path, flat, joint, **options)


def read_hdf5(path: Path, joint: str | None = None, group: str | None = None, **options: Any):
    try:
        import h5py
    except ImportError:
        raise StickslipError(f"{path}: reading HDF5 needs h5py (Debian: python3-h5py)") from None
    with h5py.File(path, "r") as file:
        root = file[group] if group else file
        arrays: dict[str, Any] = {}
        root.visititems(lambda name, node: arrays.__setitem__(name.split("/")[-1], node[()]) if isinstance(node, h5py.Dataset) else None)
    return columns_of(path, arrays, joint, **options)


def read_netcdf(path: Path, joint: str | None = None, **options: Any):
    import xarray

    _refuse_cut_classic(path)
    with xarray.open_dataset(path, decode_times=False) as dataset:
        return columns_of(path, {str(name): dataset[name].values for name in dataset.variables}, joint, **options)


def _refuse_cut_classic(path: Path) -> None:
    """The NetCDF library reads zeros where a file of the classic format is cut off; SciPy's reader complains."""
    with path.open("rb") as file:
        if file.read(3) != b"CDF":
            return
    try:
        from scipy.io import netcdf_file
    except ImportError:
        raise StickslipError(f"{path}: reading classic NetCDF needs scipy (Debian: python3-scipy)") from None
    with netcdf_file(path, mmap=False) as file:
        for variable in file.variables.values():
            variable[:]
