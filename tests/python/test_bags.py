"""Bags of ROS 2 as folders and databases, and times of arrays in other units."""
import contextlib
import os
import sqlite3
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
