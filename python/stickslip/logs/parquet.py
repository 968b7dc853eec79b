"""LeRobot data sets: Parquet with lists in observation.state and action. Needs pyarrow, which Debian 12 and 13 do not have."""
from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from ..program import StickslipError
from .arrays import columns_of
from .common import frame_of, joint_index


def _joint_names(path: Path, feature: str) -> list[str]:
    """Names of the entries of a feature, from meta/info.json of the data set that the file lies in."""
    for folder in path.resolve().parents:
        info = folder / "meta" / "info.json"
        if info.exists():
            names = json.loads(info.read_text(encoding="utf-8")).get("features", {}).get(feature, {}).get("names")
            if isinstance(names, dict):
                names = next(iter(names.values()))
            return [str(n) for n in names or []]
    return []


def _joints(path: Path, table, name: str):
    """The column of lists as rows of joints; a column of numbers is one joint's."""
    import numpy

    lists = [numpy.atleast_1d(values) for values in table[name]]
    lengths = sorted(set(len(values) for values in lists))
    if len(lengths) > 1:
        raise StickslipError(f"{path}: {name} has {lengths[0]} to {lengths[-1]} joints a row, expected as many in each")
    return numpy.stack(lists)


def read(path: Path, joint: str | None = None, episode: int | None = None, **options: Any):
    try:
        from pyarrow import parquet
    except ImportError:
        raise StickslipError(f"{path}: reading Parquet needs pyarrow (pip install pyarrow)") from None

    table = parquet.read_table(path).to_pandas()
    if "observation.state" not in table or "action" not in table:
        return columns_of(path, {name: table[name].to_numpy() for name in table.columns}, joint, **options)
    if "episode_index" in table:
        episodes = sorted(set(int(e) for e in table["episode_index"]))
        if episode is None and len(episodes) > 1:
            raise StickslipError(f"{path}: holds the episodes {episodes[0]} to {episodes[-1]}; say which with episode=")
        if episode is not None:
            table = table[table["episode_index"] == episode]
            if table.empty:
                raise StickslipError(f"{path}: has no episode {episode}, it has {episodes[0]} to {episodes[-1]}")
    state, action = _joints(path, table, "observation.state"), _joints(path, table, "action")
    if state.shape != action.shape:
        raise StickslipError(f"{path}: observation.state has {state.shape[1]} joints, action has {action.shape[1]}")
    names = _joint_names(path, "observation.state") or [str(i) for i in range(state.shape[1])]
    index = joint_index(str(path), names, joint)
    guessed = ["observation.state read as position, action as reference, both in rad: many data sets hold degrees or per cent of travel"]
    return frame_of(path, {"time": table["timestamp"].to_numpy(), "reference_position": action[:, index], "position": state[:, index]}, guessed)
