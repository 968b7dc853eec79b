"""ROS 1 bags, version 2.0 (http://wiki.ros.org/Bags/Format/2.0): records of a head of named fields and data."""
from __future__ import annotations

import bz2
import struct
from pathlib import Path
from typing import Iterator

from ..program import StickslipError
from .ros_record import Message, record

MAGIC = b"#ROSBAG V2.0\n"
MESSAGE, CHUNK, CONNECTION = 0x02, 0x05, 0x07


def _fields(head: bytes) -> dict[str, bytes]:
    fields, at = {}, 0
    while at < len(head):
        length, = struct.unpack_from("<I", head, at)
        name, equals, value = head[at + 4:at + 4 + length].partition(b"=")
        if not equals or at + 4 + length > len(head):
            raise ValueError("the head of a record is broken")
        fields[name.decode("ascii")] = value
        at += 4 + length
    return fields


def _records(data: bytes, within: str, begin: int = 0) -> Iterator[tuple[int, dict[str, bytes], bytes]]:
    """Where each record begins, its fields, its data. `begin`: place of the first byte in what `within` names."""
    at = 0
    while at < len(data):
        place, parts, first = f"the record at byte {begin + at} of {within}", [], begin + at
        for _ in range(2):
            if at + 4 > len(data):
                raise ValueError(f"{place} is cut off: 4 bytes of a length are said, {len(data) - at} are there; `rosbag reindex` repairs it")
            length, = struct.unpack_from("<I", data, at)
            if at + 4 + length > len(data):
                raise ValueError(f"{place} is cut off: {length} bytes are said, {len(data) - at - 4} are there; `rosbag reindex` repairs it")
            parts.append(data[at + 4:at + 4 + length])
            at += 4 + length
        yield first, _fields(parts[0]), parts[1]


def _unpacked(path: Path, fields: dict[str, bytes], data: bytes) -> bytes:
    compression = fields.get("compression", b"none").decode("ascii")
    if compression == "bz2":
        return bz2.decompress(data)
    if compression == "lz4":
        try:
            import lz4.frame
        except ImportError:
            raise StickslipError(f"{path}: chunks are packed with lz4: install python3-lz4, or run `rosbag decompress`") from None
        return lz4.frame.decompress(data)
    if compression != "none":
        raise ValueError(f"chunks are packed with {compression!r}")
    return data


def messages(path: Path) -> Iterator[Message]:
    data = path.read_bytes()
    if not data.startswith(MAGIC):
        raise StickslipError(f"{path}: does not begin as a ROS 1 bag of version 2.0 does")
    connections: dict[bytes, tuple[str, str]] = {}

    def read(block: bytes, within: str, begin: int = 0) -> Iterator[Message]:
        for at, fields, body in _records(block, within, begin):
            kind = fields.get("op", b"\0")[0]
            if kind == CONNECTION:
                connections[fields["conn"]] = (fields["topic"].decode(), _fields(body)["type"].decode())
            elif kind == MESSAGE:
                seconds, nanoseconds = struct.unpack("<II", fields["time"])
                topic, type_name = connections[fields["conn"]]
                yield topic, type_name, seconds + 1e-9 * nanoseconds, body
            elif kind == CHUNK:
                yield from read(_unpacked(path, fields, body), f"the chunk at byte {at}, unpacked")

    yield from read(data[len(MAGIC):], "the file", len(MAGIC))


def read(path: Path, joint: str | None = None, topic: str | None = None, command: str | None = None):
    return record(path, messages(path), False, joint, topic, command)
