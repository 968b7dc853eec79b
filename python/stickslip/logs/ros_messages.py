"""Messages of ROS that carry a joint, from their bytes: sensor_msgs/JointState and std_msgs numbers. ROS 1 packs without
gaps; ROS 2 (CDR, XCDR1) aligns each value to its size, counted behind a head of four bytes."""
from __future__ import annotations

import struct
from dataclasses import dataclass
from typing import Any

NUMBERS = {"std_msgs/Float64": "d", "std_msgs/Float32": "f", "std_msgs/Int32": "i"}


@dataclass
class JointState:
    stamp: float  # s
    names: list[str]
    position: list[float]
    velocity: list[float]
    effort: list[float]


class Reader:
    """Reads values one after the other. Every length is checked against what is left."""

    def __init__(self, data: bytes, cdr: bool):
        self.cdr, self.data = cdr, data
        self.order = "<"
        self.start = self.at = 0
        if cdr:
            if len(data) < 4:
                raise ValueError("a message of ROS 2 without its head")
            self.order = "<" if data[1] & 1 else ">"
            self.start = self.at = 4

    def number(self, kind: str) -> Any:
        size = struct.calcsize(kind)
        if self.cdr:
            self.at += -(self.at - self.start) % size
        if self.at + size > len(self.data):
            raise ValueError("a message ends early")
        value = struct.unpack_from(self.order + kind, self.data, self.at)[0]
        self.at += size
        return value

    def string(self) -> str:
        length = self.number("I")
        if self.at + length > len(self.data):
            raise ValueError("a message ends early")
        text = self.data[self.at:self.at + length]
        self.at += length
        return text.rstrip(b"\0").decode("utf-8")

    def strings(self) -> list[str]:
        count = self.number("I")
        if count > len(self.data):
            raise ValueError("a message says that it has more names than bytes")
        return [self.string() for _ in range(count)]

    def doubles(self) -> list[float]:
        count = self.number("I")
        if count * 8 > len(self.data):
            raise ValueError("a message says that it has more numbers than bytes")
        return [self.number("d") for _ in range(count)]


def plain_type(name: str) -> str:
    """"sensor_msgs/msg/JointState" and "sensor_msgs/JointState" are the same message."""
    return name.replace("/msg/", "/")


def joint_state(data: bytes, cdr: bool) -> JointState:
    reader = Reader(data, cdr)
    if not cdr:
        reader.number("I")  # seq
    seconds, nanoseconds = reader.number("i" if cdr else "I"), reader.number("I")
    reader.string()  # frame_id
    return JointState(seconds + 1e-9 * nanoseconds, reader.strings(), reader.doubles(), reader.doubles(), reader.doubles())


def value(type_name: str, data: bytes, cdr: bool) -> float:
    """A single number, or the first of a Float64MultiArray."""
    reader = Reader(data, cdr)
    if plain_type(type_name) in NUMBERS:
        return float(reader.number(NUMBERS[plain_type(type_name)]))
    raise ValueError(f"messages of type {type_name} carry no single number")


def multi_array(data: bytes, cdr: bool) -> list[float]:
    """std_msgs/Float64MultiArray: the numbers behind its layout."""
    reader = Reader(data, cdr)
    for _ in range(min(reader.number("I"), 64)):
        reader.string()
        reader.number("I"), reader.number("I")
    reader.number("I")
    return reader.doubles()
