"""Folders of SAGE: control.csv and state_motor.csv with bracketed lists in a cell, joint_list.txt, times in µs."""
from __future__ import annotations

import csv
from pathlib import Path

from ..program import StickslipError
from .common import frame_of, held, joint_index


def _numbers(text: str | None) -> list[float]:
    if not text:
        raise ValueError("got nothing, expected numbers")
    inner = text.strip()
    # without its bracket a list may be cut off within its last number, which then is another number
    if inner.startswith("[") != inner.endswith("]"):
        raise ValueError(f"got {text!r}, expected a list in brackets")
    try:
        return [float(word) for word in inner.strip("[]").replace(",", " ").split()]
    except ValueError:
        raise ValueError(f"got {text!r}, expected numbers") from None


def _table(path: Path, wanted: str, keys: tuple[str, ...], count: int):
    if not path.exists():
        raise StickslipError(f"{path}: there is no such file; a folder of SAGE has joint_list.txt, state_motor.csv and control.csv")
    times: list[float] = []
    values: dict[str, list[list[float]]] = {key: [] for key in keys}
    with path.open(newline="", encoding="utf-8") as file:
        table = csv.DictReader(file)
        columns = table.fieldnames or []
        if not {"timestamp", *keys} <= set(columns):
            raise StickslipError(f"{path}: has the columns {', '.join(columns) or 'none'}, expected timestamp, {', '.join(keys)}")
        for row in table:
            if row.get("type") and row["type"] != wanted:
                continue
            line = f"{path}: row {len(times) + 1}"
            key = "timestamp"
            try:
                times.append(*_numbers(row[key]))
                for key in keys:
                    values[key].append(_numbers(row[key]))
            except TypeError:
                raise StickslipError(f"{line}: timestamp: got {row[key]!r}, expected one number") from None
            except ValueError as error:
                raise StickslipError(f"{line}: {key}: {error}") from None
            for key in keys:
                if len(values[key][-1]) != count:
                    raise StickslipError(f"{line}: {key} has {len(values[key][-1])} values, joint_list.txt has {count} joints")
    if not times:
        raise StickslipError(f"{path}: has no row of type {wanted}")
    return times, values


def read(path: Path, joint: str | None = None):
    names_file = path / "joint_list.txt"
    if not names_file.exists():
        raise StickslipError(f"{path}: is a folder without joint_list.txt; a folder of SAGE has it beside state_motor.csv and control.csv, "
                             "a bag of ROS 2 has metadata.yaml beside .mcap or .db3")
    names = [line.strip() for line in names_file.read_text(encoding="utf-8").splitlines() if line.strip()]
    index = joint_index(str(path), names, joint)
    t, state = _table(path / "state_motor.csv", "STATE_MOTOR", ("positions", "velocities", "torques"), len(names))
    t_sent, sent = _table(path / "control.csv", "CONTROL", ("positions",), len(names))
    # a log of half a minute lasts 3e7 µs or 30 s: only the former has steps above 1
    micro = len(t) > 1 and (t[-1] - t[0]) / (len(t) - 1) > 1
    scale = 1e-6 if micro else 1.0
    guessed = [f"times read as {'µs' if micro else 's'}, from their step", "angles read as rad: the log does not say",
               "reference is the last position that was sent before each row"]
    columns = {"time": [v * scale for v in t], "reference_position": held(t, t_sent, [p[index] for p in sent["positions"]]),
               "position": [p[index] for p in state["positions"]], "velocity": [p[index] for p in state["velocities"]],
               "effort_measured": [p[index] for p in state["torques"]]}
    return frame_of(path, columns, guessed)
