"""MCAP, the container of ROS 2 logs (https://mcap.dev/spec): records behind a magic number, messages mostly in
compressed chunks. zstd and lz4 need their Python packages."""
from __future__ import annotations

import struct
import zlib
from pathlib import Path
from typing import Iterator

from ..program import StickslipError
from .ros_record import Message, record

MAGIC = b"\x89MCAP0\r\n"
SCHEMA, CHANNEL, MESSAGE, CHUNK, DATA_END = 0x03, 0x04, 0x05, 0x06, 0x0F


def _text(data: bytes, at: int) -> tuple[str, int]:
    length, = struct.unpack_from("<I", data, at)
    if at + 4 + length > len(data):
        raise ValueError("a text reaches beyond its record")
    return data[at + 4:at + 4 + length].decode("utf-8"), at + 4 + length


def _records(data: bytes, within: str, begin: int = 0) -> Iterator[tuple[int, int, bytes]]:
    """Where each record begins, its kind, its content. `begin`: place of the first byte in what `within` names."""
    at = 0
    while at < len(data):
        place = f"the record at byte {begin + at} of {within}"
        if at + 9 > len(data):
            raise ValueError(f"{place} ends in its head")
        kind, length = struct.unpack_from("<BQ", data, at)
        if at + 9 + length > len(data):
            raise ValueError(f"{place} is cut off: {length} bytes are said, {len(data) - at - 9} are there")
        yield begin + at, kind, data[at + 9:at + 9 + length]
        at += 9 + length


def _unpacked(path: Path, chunk: bytes, place: str) -> bytes:
    _, _, size, crc = struct.unpack_from("<QQQI", chunk, 0)
    compression, at = _text(chunk, 28)
    length, = struct.unpack_from("<Q", chunk, at)
    data = chunk[at + 8:at + 8 + length]
    if compression == "zstd":
        try:
            import zstandard
        except ImportError:
            raise StickslipError(f"{path}: chunks are packed with zstd: install python3-zstandard, or run `mcap compress --compression none`") from None
        data = zstandard.ZstdDecompressor().decompress(data, max_output_size=size)
    elif compression == "lz4":
        try:
            import lz4.frame
        except ImportError:
            raise StickslipError(f"{path}: chunks are packed with lz4: install python3-lz4, or run `mcap compress --compression none`") from None
        data = lz4.frame.decompress(data)
    elif compression:
        raise ValueError(f"chunks are packed with {compression!r}")
    if len(data) != size:
        raise ValueError(f"{place} has {len(data)} bytes, it says {size}")
    if crc and zlib.crc32(data) != crc:
        raise ValueError(f"{place}: its checksum is {zlib.crc32(data):08x}, it says {crc:08x}")
    return data


def messages(path: Path) -> Iterator[Message]:
    data = path.read_bytes()
    if not data.startswith(MAGIC):
        raise StickslipError(f"{path}: does not begin as MCAP does")
    if not data.endswith(MAGIC):
        raise StickslipError(f"{path}: does not end as MCAP does: it is cut off; `mcap recover` makes a whole one")
    schemas: dict[int, str] = {}
    channels: dict[int, tuple[str, str, int]] = {}

    def read(block: bytes, within: str, begin: int = 0) -> Iterator[Message]:
        for at, kind, body in _records(block, within, begin):
            place = f"the record at byte {at} of {within}"
            if kind == SCHEMA:
                schemas[struct.unpack_from("<H", body)[0]] = _text(body, 2)[0]
            elif kind == CHANNEL:
                channel, schema = struct.unpack_from("<HH", body)
                topic, behind = _text(body, 4)
                channels[channel] = (topic, _text(body, behind)[0], schema)
            elif kind == MESSAGE:
                channel, _, logged = struct.unpack_from("<HIQ", body)
                if channel not in channels:
                    raise ValueError(f"{place} is a message of channel {channel}, which is not declared")
                topic, encoding, schema = channels[channel]
                if encoding == "cdr":
                    yield topic, schemas.get(schema, ""), logged * 1e-9, body[22:]
            elif kind == CHUNK:
                chunk = f"the chunk at byte {at}"
                yield from read(_unpacked(path, body, chunk), f"{chunk}, unpacked")
            elif kind == DATA_END:
                return

    yield from read(data[len(MAGIC):-len(MAGIC)], "the file", len(MAGIC))


def read(path: Path, joint: str | None = None, topic: str | None = None, command: str | None = None):
    return record(path, messages(path), True, joint, topic, command)
