"""Files of arrays: .npz, MATLAB, HDF5, NetCDF. Every one-dimensional array of the length of the time is a column."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Iterable, Mapping

from ..program import StickslipError
from .apart import read_apart
from .common import frame_of, joint_index

_TIMES = ("t", "time", "timestamp", "timestamps", "Time", "T")
_SAME = {"q": "position", "qd": "velocity", "dq": "velocity", "q_ref": "reference_position", "q_des": "reference_position", "reference": "reference_position", "tau": "effort_measured",
         "torque": "effort_measured", "effort": "effort_measured", "joint_positions": "position", "joint_velocities": "velocity",
         "joint_efforts": "effort_measured", "positions": "position", "velocities": "velocity", "torques": "effort_measured",
         "command": "effort_command", "u": "effort_command"}


_SIGNALS = {*_SAME.values(), "reference_velocity", "effort_measured", "load_effort", "inertia"}


def _kind(value: Any) -> str:
    return "text" if value.dtype.kind in "SU" else "objects" if value.dtype.kind == "O" else str(value.dtype)


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
    for name, value in found.items():
        if (columns or {}).get(name, _SAME.get(name, name)) in _SIGNALS and value.dtype.kind not in "fiubM":
            raise StickslipError(f"{path}: array {name}: got {_kind(value)}, expected numbers")
    found = {name: value for name, value in found.items() if value.dtype.kind in "fiubM" and value.ndim in (1, 2)}
    key = time or next((name for name in _TIMES if name in found), None)
    if key is None or key not in found:
        raise StickslipError(f"{path}: has no time among {', '.join(arrays) or 'nothing'}; say which array it is with time=")
    rows = len(found[key])
    names = [str(n) for n in numpy.ravel(arrays["joint_names"])] if "joint_names" in arrays else []
    seconds, unit = _seconds(found[key])
    out, guessed = {"time": seconds}, [f"array {key} read as {unit}, from its step"] if unit else []
    for name, value in found.items():
        if name == key or value.dtype.kind == "M":
            continue
        ours = (columns or {}).get(name, name if columns else _SAME.get(name, name))
        if len(value) != rows:
            if ours in _SIGNALS:
                guessed.append(f"array {name} has {len(value)} rows, the time {rows}: left out")
            continue
        if ours != name and not (columns or {}).get(name) and (ours in found or ours in out):
            guessed.append(f"array {name} left out: there is another {ours}")
            continue
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
        arrays: dict[str, Any] = {}
        for name in file.files:
            try:
                arrays[name] = file[name]
            except ValueError as error:
                if "pickle" not in str(error):
                    raise
                raise StickslipError(f"{path}: array {name}: got objects of Python, expected numbers") from None
        return columns_of(path, arrays, joint, **options)


def _one_of_each(path: Path, placed: Iterable[tuple[str, str, Any]], option: str) -> dict[str, Any]:
    """Arrays by name; of two with one name, neither is taken for the other."""
    places: dict[str, str] = {}
    arrays: dict[str, Any] = {}
    for place, name, value in placed:
        if name in places:
            raise StickslipError(f"{path}: has {places[name]} and {place}, expected one {name}; {option}")
        places[name], arrays[name] = place, value
    return arrays


def read_mat(path: Path, joint: str | None = None, group: str | None = None, **options: Any):
    import importlib.util

    with path.open("rb") as file:
        if file.read(128)[:10] != b"MATLAB 5.0":
            return read_hdf5(path, joint, group, **options)  # MATLAB 7.3 is HDF5
    if importlib.util.find_spec("scipy") is None:
        raise StickslipError(f"{path}: reading .mat needs scipy (Debian: python3-scipy)")
    arrays = read_apart("scipy.io:loadmat", path, squeeze_me=True)
    arrays = {name: value for name, value in arrays.items() if not name.startswith("__")}
    structs = [name for name, value in arrays.items() if value.dtype.names]
    if group and group not in structs:
        raise StickslipError(f"{path}: has no struct {group!r}, it has {', '.join(structs) or 'none'}")
    flat: list[tuple[str, str, Any]] = []
    for name, value in arrays.items():
        if group and name != group:
            continue
        if not value.dtype.names:
            flat.append((name, name, value))
        for field in value.dtype.names or ():
            inner = value[field]
            flat.append((f"{name}.{field}", field, inner.item() if inner.dtype == object and inner.size == 1 else inner))
    return columns_of(path, _one_of_each(path, flat, "say which struct with group="), joint, **options)


def read_hdf5(path: Path, joint: str | None = None, group: str | None = None, **options: Any):
    try:
        import h5py
    except ImportError:
        raise StickslipError(f"{path}: reading HDF5 needs h5py (Debian: python3-h5py)") from None
    with h5py.File(path, "r") as file:
        groups = [name for name, node in file.items() if isinstance(node, h5py.Group)]
        if group and not isinstance(file.get(group), h5py.Group):
            raise StickslipError(f"{path}: has no group {group!r}, it has {', '.join(groups) or 'none'}")
        nodes: list[tuple[str, str, Any]] = []

        def take(place: str, node: Any) -> None:
            if isinstance(node, h5py.Dataset):
                nodes.append((place, place.split("/")[-1], node[()]))

        (file[group] if group else file).visititems(take)
    return columns_of(path, _one_of_each(path, nodes, "say which group with group="), joint, **options)


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
