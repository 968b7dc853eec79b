"""Bags of ROS 2 as folders and databases, and times of arrays in other units."""
import contextlib
import os
import sqlite3
import struct
import subprocess
import sys
from pathlib import Path

import log_samples as sample
import numpy
import pandas
import pytest

import stickslip
from stickslip import StickslipError


def db3(path, messages):
    """What rosbag2's SQLite storage writes, of (topic, type, time after the start, data)."""
    with contextlib.closing(sqlite3.connect(path)) as base, base:
        base.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, serialization_format TEXT NOT NULL)")
        base.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL, data BLOB NOT NULL)")
        topics = {name: i for i, name in enumerate(dict.fromkeys(m[0] for m in messages), 1)}
        for name, i in topics.items():
            base.execute("INSERT INTO topics VALUES (?, ?, ?, 'cdr')", (i, name, next(m[1] for m in messages if m[0] == name)))
        for name, _, when, data in messages:
            base.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)", (topics[name], int((1_700_000_000 + when) * 1e9), data))
    return path


def ros2_messages(first=0, last=len(sample.T)):
    for k in range(first, last):
        yield "/commands", "std_msgs/msg/Float64MultiArray", sample.T[k], sample.ros2_multi_array(sample.COMMAND[k])
        yield "/joint_states", "sensor_msgs/msg/JointState", sample.T[k] + 1e-3, sample.ros2_joint_state(k)


def test_a_bag_of_ros2_is_a_folder_or_a_database(tmp_path):
    def checked(log):
        frame = stickslip.read_log(log, joint="elbow", command="/commands")
        assert numpy.allclose(frame["position"], sample.Q[:, 1]) and numpy.allclose(frame["reference_position"], sample.COMMAND[:, 1])
        assert numpy.allclose(frame["time"], sample.T, atol=1e-6)

    checked(db3(tmp_path / "run.db3", list(ros2_messages())))
    for name, write, ending in (("old", db3, ".db3"), ("new", sample.mcap_of, ".mcap")):
        bag = tmp_path / name
        bag.mkdir()
        (bag / "metadata.yaml").write_text("rosbag2_bagfile_information:\n  version: 5\n")
        with pytest.raises(StickslipError, match="has no .mcap and no .db3 file beside metadata.yaml"):
            stickslip.read_log(bag, joint="elbow")
        for part in range(11):  # split by size: _10 comes after _2
            write(bag / f"{name}_{part}{ending}", list(ros2_messages(part * 4, min(part * 4 + 4, len(sample.T)) if part < 10 else len(sample.T))) or
                  [("/other", "std_msgs/msg/Float64", 9.0, sample.Cdr().add("d", 1.0).message())])
        checked(bag)
    done = subprocess.run([stickslip.executable(), "convert", tmp_path / "old", tmp_path / "run.csv", "--joint", "elbow"],
                          capture_output=True, text=True, env={**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}",
                                                                "PYTHONPATH": str(Path(stickslip.__file__).parents[1])})
    assert done.returncode == 0 and len(pandas.read_csv(tmp_path / "run.csv")) == len(sample.T), done.stderr
    (tmp_path / "old" / "old_3.db3.zstd").write_bytes(b"")
    with pytest.raises(StickslipError, match="old_3.db3.zstd: is packed with zstd"):
        stickslip.read_log(tmp_path / "old", joint="elbow")


def test_damaged_databases_are_refused(tmp_path):
    whole = db3(tmp_path / "run.db3", list(ros2_messages())).read_bytes()
    for cut in range(0, len(whole), len(whole) // 40):
        for damaged in (whole[:cut], whole[:cut] + b"\xff" * 64 + whole[cut + 64:]):
            (tmp_path / "cut.db3").write_bytes(damaged)
            with contextlib.suppress(StickslipError):
                stickslip.read_log(tmp_path / "cut.db3", joint="elbow", command="/commands")
    with pytest.raises(StickslipError, match="does not begin as SQLite does"):
        (tmp_path / "cut.db3").write_bytes(whole[1:])
        stickslip.read_log(tmp_path / "cut.db3", joint="elbow")


def test_times_of_arrays_in_other_units(tmp_path):
    step = 1_700_000_000_000_000_000 + numpy.round(sample.T * 1e9).astype("int64")
    for time, told in ((step, "ns"), (step / 1e3, "µs"), (sample.T * 1e3, "ms"), (step.astype("datetime64[ns]"), ""), (sample.T + 5, "")):
        numpy.savez(tmp_path / "run.npz", timestamp=time, q=sample.Q[:, 0])
        frame = stickslip.read_log(tmp_path / "run.npz")
        assert numpy.allclose(frame["time"], sample.T, atol=1e-6)
        assert any(f"array timestamp read as {told}," in guess for guess in frame.attrs["guessed"]) == bool(told)


def big_endian(k):
    """The joint state as a middleware on a big-endian machine packs it: every value turned round."""
    class Turned(sample.Cdr):
        def add(self, kind, *values):
            for value in values:
                size = struct.calcsize(kind)
                self.body += b"\0" * (-len(self.body) % size) + struct.pack(">" + kind, value)
            return self

        def message(self):
            return b"\0\0\0\0" + self.body

    cdr = Turned().add("i", 100).add("I", int(round(sample.T[k] * 1e9))).string("base").add("I", 2)
    for name in sample.NAMES:
        cdr.string(name)
    return cdr.doubles(sample.Q[k]).doubles(sample.DQ[k]).doubles(sample.TAU[k]).message()


def test_messages_of_the_other_byte_order(tmp_path):
    states = [("/arm", "sensor_msgs/msg/JointState", t, big_endian(k)) for k, t in enumerate(sample.T)]
    frame = stickslip.read_log(sample.mcap_of(tmp_path / "run.mcap", states), joint="elbow")
    for column, values in (("position", sample.Q), ("velocity", sample.DQ), ("effort_measured", sample.TAU)):
        assert numpy.allclose(frame[column], values[:, 1])


@pytest.mark.parametrize("kind", ["zstd", "lz4"])
def test_packed_chunks(tmp_path, kind):
    pack = (pytest.importorskip("zstandard").ZstdCompressor().compress if kind == "zstd" else pytest.importorskip("lz4.frame").compress)
    file = sample.mcap_of(tmp_path / "run.mcap", list(ros2_messages()), packed=kind, pack=pack)
    assert numpy.allclose(stickslip.read_log(file, joint="elbow", command="/commands")["position"], sample.Q[:, 1])
    whole = file.read_bytes()
    file.write_bytes(whole[:len(whole) // 2] + b"\xff" * 8 + whole[len(whole) // 2 + 8:])
    with pytest.raises(StickslipError, match="run.mcap: is damaged"):
        stickslip.read_log(file, joint="elbow")


def test_joints_in_another_order_from_message_to_message_and_without_efforts(tmp_path):
    def state(k):
        turn = slice(None, None, -1 if k % 2 else 1)
        cdr = sample.Cdr().add("i", 100).add("I", int(round(sample.T[k] * 1e9))).string("").add("I", 2)
        for name in sample.NAMES[turn]:
            cdr.string(name)
        return cdr.doubles(sample.Q[k][turn]).doubles([]).doubles([]).message()

    states = [("/arm", "sensor_msgs/msg/JointState", t, state(k)) for k, t in enumerate(sample.T)]
    frame = stickslip.read_log(sample.mcap_of(tmp_path / "run.mcap", states), joint="elbow")
    assert list(frame.columns) == ["time", "position"] and numpy.allclose(frame["position"], sample.Q[:, 1])


def test_a_command_topic_of_another_kind_and_wrong_options_are_refused_as_what_they_are(tmp_path):
    messages = [*ros2_messages(), ("/plan", "trajectory_msgs/msg/JointTrajectory", 0.0, b"\0\1\0\0")]
    file = sample.mcap_of(tmp_path / "run.mcap", messages)
    with pytest.raises(StickslipError, match="command topic /plan has messages of trajectory_msgs/msg/JointTrajectory, expected"):
        stickslip.read_log(file, joint="elbow", command="/plan")
    with pytest.raises(StickslipError, match="take no option comand=, they take topic, command"):
        stickslip.read_log(file, joint="elbow", comand="/commands")


def test_arrays_that_one_name_stands_for_are_not_taken_for_each_other(tmp_path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "run.h5", "w") as file:
        for side, factor in (("left", 1), ("right", 2)):
            file[side + "/t"], file[side + "/q"] = sample.T, factor * sample.Q[:, 0]
    with pytest.raises(StickslipError, match="has left/q and right/q, expected one q; say which group with group="):
        stickslip.read_log(tmp_path / "run.h5")
    with pytest.raises(StickslipError, match="has no group 'centre', it has left, right"):
        stickslip.read_log(tmp_path / "run.h5", group="centre")
    assert numpy.allclose(stickslip.read_log(tmp_path / "run.h5", group="left")["position"], sample.Q[:, 0])
    done = subprocess.run([stickslip.executable(), "convert", tmp_path / "run.h5", tmp_path / "run.csv", "--group", "right"], capture_output=True, text=True,
                          env={**os.environ, "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}", "PYTHONPATH": str(Path(stickslip.__file__).parents[1])})
    assert done.returncode == 0 and numpy.allclose(pandas.read_csv(tmp_path / "run.csv")["position"], 2 * sample.Q[:, 0]), done.stderr
    io = pytest.importorskip("scipy.io")
    io.savemat(tmp_path / "run.mat", {side: {"t": sample.T, "q": sample.Q[:, 0]} for side in ("left", "right")})
    with pytest.raises(StickslipError, match="has left.t and right.t, expected one t; say which struct with group="):
        stickslip.read_log(tmp_path / "run.mat")
    assert len(stickslip.read_log(tmp_path / "run.mat", group="left")) == len(sample.T)


def test_arrays_that_are_not_read_are_told(tmp_path):
    numpy.savez(tmp_path / "run.npz", t=sample.T, q=sample.Q[:, 0], position=sample.Q[:, 1], tau=sample.T[1:])
    frame = stickslip.read_log(tmp_path / "run.npz")
    assert numpy.allclose(frame["position"], sample.Q[:, 1])
    assert {"array q left out: there is another position", "array tau has 39 rows, the time 40: left out"} <= set(frame.attrs["guessed"])
    for values, told in ((numpy.array(["a"] * 40), "text"), (numpy.array([None] * 40), "objects of Python")):
        numpy.savez(tmp_path / "run.npz", t=sample.T, position=values)
        with pytest.raises(StickslipError, match=f"run.npz: array position: got {told}, expected numbers"):
            stickslip.read_log(tmp_path / "run.npz")
