"""Logs of BAM (Better Actuator Models): one JSON a run."""
from __future__ import annotations

import json
from pathlib import Path

from ..program import StickslipError
from .common import frame_of

_COLUMNS = {"timestamp": "time", "goal_position": "reference_position", "position": "position", "speed": "velocity", "torque_enable": "torque_enable",
            "input_volts": "supply_voltage", "temp": "temperature"}


def read(path: Path, joint: str | None = None):
    try:
        log = json.loads(path.read_text(encoding="utf-8"))
    except (ValueError, UnicodeDecodeError) as error:
        raise StickslipError(f"{path}: is no JSON: {error}") from None
    entries = log.get("entries") if isinstance(log, dict) else None
    if not isinstance(entries, list) or not entries or not isinstance(entries[0], dict):
        raise StickslipError(f"{path}: has no list \"entries\", as a log of BAM has")
    for row, entry in enumerate(entries):
        for key in ("timestamp", "position", "goal_position"):
            if not isinstance(entry.get(key), (int, float)):
                raise StickslipError(f"{path}: entries[{row}]: got {entry.get(key)!r} for {key}, expected a number")
    columns = {ours: [float(e[theirs]) if e.get(theirs) is not None else float("nan") for e in entries]
               for theirs, ours in _COLUMNS.items() if theirs in entries[0]}
    guessed = ["\"load\" is the drive's duty and is kept as the column load, it is no effort"] if "load" in entries[0] else []
    if "load" in entries[0]:
        columns["load"] = [float(e.get("load") or 0) for e in entries]
    frame = frame_of(path, columns, guessed)
    frame.attrs["log"] = {k: v for k, v in log.items() if k != "entries"}  # mass, length, kp, vin, motor, trajectory
    return frame
