"""Logs written from the specifications of their formats, apart from the readers."""
import bz2
import json
import struct
import zlib

import numpy

NAMES = ["shoulder", "elbow"]
T = numpy.arange(40) * 0.01
Q = numpy.stack([numpy.sin(T), 0.5 * numpy.cos(3 * T)], axis=1)
DQ = numpy.stack([numpy.cos(T), -1.5 * numpy.sin(3 * T)], axis=1)
TAU = numpy.stack([2 * T, 3 - T], axis=1)
COMMAND = Q + 0.01


class Cdr:
    """Little-endian XCDR1 behind its head."""

    def __init__(self):
        self.body = b""

    def add(self, kind, *values):
        for value in values:
            size = struct.calcsize(kind)
            self.body += b"\0" * (-len(self.body) % size) + struct.pack("<" + kind, value)
        return self

    def string(self, text):
        data = text.encode() + b"\0"
        self.add("I", len(data))
        self.body += data
        return self

    def doubles(self, values):
        self.add("I", len(values))
        return self.add("d", *values) if len(values) else self

    def message(self):
        return b"\0\1\0\0" + self.body


def ros2_joint_state(k, names=NAMES):
    stamp = 1_700_000_000 + T[k]
    cdr = Cdr().add("i", int(stamp)).add("I", int(round((stamp - int(stamp)) * 1e9))).string("base").add("I", len(names))
    for name in names:
        cdr.string(name)
    return cdr.doubles(Q[k]).doubles(DQ[k]).doubles(TAU[k]).message()


def ros2_multi_array(values):
    return Cdr().add("I", 0).add("I", 0).doubles(values).message()


def mcap(path, chunked=True, names=NAMES):
    messages = []
    for k in range(len(T)):
        messages.append(("/commands", "std_msgs/msg/Float64MultiArray", T[k], ros2_multi_array(COMMAND[k])))
        messages.append(("/joint_states", "sensor_msgs/msg/JointState", T[k] + 1e-3, ros2_joint_state(k, names)))
    return mcap_of(path, messages, chunked)


def mcap_of(path, messages, chunked=True, packed="", pack=bytes):
    """A file of (topic, type, time after the start, data)."""
    def text(s):
        return struct.pack("<I", len(s)) + s.encode()

    def rec(kind, body):
        return struct.pack("<BQ", kind, len(body)) + body

    block, channels = b"", {}
    for k, (topic, kind, when, data) in enumerate(messages):
        if topic not in channels:
            i = channels[topic] = len(channels) + 1
            block += rec(3, struct.pack("<H", i) + text(kind) + text("ros2msg") + struct.pack("<I", 0))
            block += rec(4, struct.pack("<HH", i, i) + text(topic) + text("cdr") + struct.pack("<I", 0))
        at = int((1_700_000_000 + when) * 1e9)
        block += rec(5, struct.pack("<HIQQ", channels[topic], k, at, at) + data)
    if chunked:
        block = rec(6, struct.pack("<QQQI", 0, 0, len(block), zlib.crc32(block)) + text(packed) + struct.pack("<Q", len(pack(block))) + pack(block))
    magic = b"\x89MCAP0\r\n"
    path.write_bytes(magic + rec(1, text("ros2") + text("test")) + block + rec(15, b"\0" * 4) + rec(2, b"\0" * 20) + magic)
    return path


def rosbag(path, packed=True):
    def head(**fields):
        data = b"".join(struct.pack("<I", len(n) + 1 + len(v)) + n.encode() + b"=" + v for n, v in fields.items())
        return struct.pack("<I", len(data)) + data

    def rec(data, **fields):
        return head(**fields) + struct.pack("<I", len(data)) + data

    def text(s):
        return struct.pack("<I", len(s)) + s.encode()

    def connection(i, topic, kind):
        conn = struct.pack("<I", i)
        fields = b"".join(struct.pack("<I", len(n) + 1 + len(v)) + n + b"=" + v
                          for n, v in ((b"topic", topic.encode()), (b"type", kind.encode()), (b"md5sum", b"*")))
        return rec(fields, op=b"\x07", conn=conn, topic=topic.encode())

    block = connection(0, "/joint_states", "sensor_msgs/JointState") + connection(1, "/elbow/command", "std_msgs/Float64")
    for k in range(len(T)):
        now = struct.pack("<II", 100, int(round(T[k] * 1e9)))
        block += rec(struct.pack("<d", COMMAND[k, 1]), op=b"\x02", conn=struct.pack("<I", 1), time=now)
        state = struct.pack("<I", k) + now + text("base") + struct.pack("<I", 2) + text(NAMES[0]) + text(NAMES[1])
        for values in (Q[k], DQ[k], TAU[k]):
            state += struct.pack("<I", 2) + struct.pack("<2d", *values)
        block += rec(state, op=b"\x02", conn=struct.pack("<I", 0), time=now)
    body = bz2.compress(block) if packed else block
    chunk = rec(body, op=b"\x05", compression=b"bz2" if packed else b"none", size=struct.pack("<I", len(block)))
    path.write_bytes(b"#ROSBAG V2.0\n" + rec(b" " * 50, op=b"\x03", index_pos=b"\0" * 8) + chunk)
    return path


def sage(folder):
    folder.mkdir()
    (folder / "joint_list.txt").write_text("\n".join(NAMES) + "\n")
    cell = lambda values: '"[' + ", ".join(repr(float(v)) for v in values) + ']"'
    lines = ["type,timestamp,positions,velocities,torques"]
    lines += [f"STATE_MOTOR,{1000 + int(round(T[k] * 1e6))},{cell(Q[k])},{cell(DQ[k])},{cell(TAU[k])}" for k in range(len(T))]
    (folder / "state_motor.csv").write_text("\n".join(lines) + "\n")
    lines = ["type,timestamp,positions"] + [f"CONTROL,{900 + int(round(T[k] * 1e6))},{cell(COMMAND[k])}" for k in range(len(T))]
    (folder / "control.csv").write_text("\n".join(lines) + "\n")
    return folder


def bam(path):
    entries = [{"timestamp": float(T[k]), "position": float(Q[k, 1]), "speed": float(DQ[k, 1]), "load": 0.1, "input_volts": 7.4,
                "goal_position": float(COMMAND[k, 1]), "torque_enable": True} for k in range(len(T))]
    path.write_text(json.dumps({"mass": 0.5, "length": 0.1, "kp": 32, "vin": 7.4, "motor": "xl330", "trajectory": "sin", "entries": entries}))
    return path
