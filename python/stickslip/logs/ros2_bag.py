"""Bags of ROS 2 as `ros2 bag record` leaves them (https://github.com/ros2/rosbag2): a folder with metadata.yaml and one file or
several, in MCAP or in SQLite (.db3, what distributions up to Humble record)."""
from __future__ import annotations

import contextlib
import re
import sqlite3
from itertools import chain
from pathlib import Path
from typing import Iterator

from ..program import StickslipError
from . import mcap
from .ros_record import Message, record

ZSTD = b"\x28\xb5\x2f\xfd"


def is_bag(folder: Path) -> bool:
    return (folder / "metadata.yaml").exists() or any(folder.glob("*.mcap")) or any(folder.glob("*.db3"))


def of_database(path: Path) -> Iterator[Message]:
    if path.read_bytes()[:16] != b"SQLite format 3\0":
        raise StickslipError(f"{path}: does not begin as SQLite does, expected a .db3 file of ros2 bag")
    with contextlib.closing(sqlite3.connect(f"{path.resolve().as_uri()}?mode=ro", uri=True)) as base:
        topics = {i: (name, kind) for i, name, kind, form in base.execute("SELECT id, name, type, serialization_format FROM topics")
                  if form == "cdr"}
        for topic, when, data in base.execute("SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp"):
            if data[:4] == ZSTD:
                raise StickslipError(f"{path}: its messages are packed with zstd; `ros2 bag convert` makes a bag that is not packed")
            if topic in topics:
                yield (*topics[topic], when * 1e-9, data)


def read_database(path: Path, joint: str | None = None, topic: str | None = None, command: str | None = None):
    return record(path, of_database(path), True, joint, topic, command)


def read_folder(path: Path, joint: str | None = None, topic: str | None = None, command: str | None = None):
    def number(file: Path) -> tuple[int, str]:  # run_2 comes before run_10
        counted = re.search(r"_(\d+)$", file.stem)
        return (int(counted[1]) if counted else 0, file.name)

    files = sorted([*path.glob("*.mcap"), *path.glob("*.db3")], key=number)
    packed = sorted(path.glob("*.zstd"))
    if packed:
        raise StickslipError(f"{packed[0]}: is packed with zstd; `zstd -d --rm {packed[0].name}` unpacks it")
    if not files:
        raise StickslipError(f"{path}: has no .mcap and no .db3 file beside metadata.yaml")
    messages = (mcap.messages(file) if file.suffix == ".mcap" else of_database(file) for file in files)
    return record(path, chain.from_iterable(messages), True, joint, topic, command)
