import importlib.util
import os
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

import log_samples as sample
import numpy
import pytest

import stickslip
from stickslip import StickslipError


def check(frame, torque=True):
    assert numpy.allclose(frame["time"], sample.T, atol=1e-6)
    assert numpy.allclose(frame["position"], sample.Q[:, 1], atol=1e-12)
    assert numpy.allclose(frame["velocity"], sample.DQ[:, 1], atol=1e-12)
    assert numpy.allclose(frame["reference_position"], sample.COMMAND[:, 1], atol=1e-12)
    if torque:
        assert numpy.allclose(frame["effort_measured"], sample.TAU[:, 1], atol=1e-12)


@pytest.mark.parametrize("chunked", [True, False])
def test_mcap(tmp_path, chunked):
    frame = stickslip.read_log(sample.mcap(tmp_path / "run.mcap", chunked), joint="elbow", command="/commands")
    check(frame)
    assert any("REP 103" in g for g in frame.attrs["guessed"])


@pytest.mark.parametrize("packed", [True, False])
def test_rosbag(tmp_path, packed):
    check(stickslip.read_log(sample.rosbag(tmp_path / "run.bag", packed), joint="elbow", command="/elbow/command"))


def test_sage(tmp_path):
    check(stickslip.read_log(sample.sage(tmp_path / "run"), joint="elbow"))


def test_bam(tmp_path):
    frame = stickslip.read_log(sample.bam(tmp_path / "run.json"))
    check(frame, torque=False)
    assert frame.attrs["log"]["kp"] == 32


def test_arrays(tmp_path):
    columns = {"t": sample.T, "joint_names": numpy.array(sample.NAMES), "position": sample.Q, "velocity": sample.DQ,
               "reference": sample.COMMAND, "tau": sample.TAU}
    numpy.savez(tmp_path / "run.npz", **columns)
    check(stickslip.read_log(tmp_path / "run.npz", joint="elbow"))
    h5py = pytest.importorskip("h5py")
    with h5py.File(tmp_path / "run.h5", "w") as file:
        for name, values in columns.items():
            file.create_dataset("log/" + name, data=values.astype("S") if values.dtype.kind == "U" else values)
    with pytest.raises(StickslipError, match="has the joints"):
        stickslip.read_log(tmp_path / "run.h5")
    io = pytest.importorskip("scipy.io")
    io.savemat(tmp_path / "run.mat", {"log": {k: v for k, v in columns.items() if k != "joint_names"}})
    check(stickslip.read_log(tmp_path / "run.mat", joint="1"))


def test_netcdf(tmp_path):
    import xarray
    one = {name: ("row", values[:, 1]) for name, values in (("position", sample.Q), ("velocity", sample.DQ), ("reference", sample.COMMAND), ("tau", sample.TAU))}
    xarray.Dataset({"time": ("row", sample.T), **one}).to_netcdf(tmp_path / "run.nc")
    check(stickslip.read_log(tmp_path / "run.nc"))


def test_wrong_joints_are_told_with_the_right_ones(tmp_path):
    bag = sample.mcap(tmp_path / "run.mcap")
    with pytest.raises(StickslipError, match="no joint 'elbwo', it has shoulder, elbow; did you mean 'elbow'"):
        stickslip.read_log(bag, joint="elbwo")
    with pytest.raises(StickslipError, match="2 joints called 'elbow', expected one"):
        stickslip.read_log(sample.mcap(tmp_path / "twice.mcap", names=["elbow", "elbow"]), joint="elbow")
    with pytest.raises(StickslipError, match="say which with joint="):
        stickslip.read_log(bag)
    with pytest.raises(StickslipError, match="topics are /commands"):
        stickslip.read_log(bag, joint="elbow", topic="/other")
    with pytest.raises(StickslipError, match="expected .mcap"):
        (tmp_path / "run.xyz").write_text("")
        stickslip.read_log(tmp_path / "run.xyz")


@pytest.mark.parametrize("make, name", [(sample.mcap, "run.mcap"), (sample.rosbag, "run.bag"), (sample.bam, "run.json")])
def test_damaged_logs_are_refused_in_words(tmp_path, make, name):
    whole = make(tmp_path / name).read_bytes()
    random = numpy.random.default_rng(1)
    for _ in range(60):
        cut = tmp_path / ("cut-" + name)
        cut.write_bytes(whole[:int(random.integers(0, len(whole) - 1))])
        with pytest.raises(StickslipError, match="cut-run"):
            stickslip.read_log(cut, joint="elbow")
    for _ in range(60):  # a flipped byte may leave a readable log, never another exception
        data = bytearray(whole)
        data[int(random.integers(0, len(data)))] ^= int(random.integers(1, 256))
        cut.write_bytes(bytes(data))
        try:
            stickslip.read_log(cut, joint="elbow")
        except StickslipError as error:
            assert "cut-run" in str(error) or "chunks" in str(error)


def test_a_damaged_container_is_refused_with_the_place(tmp_path):
    file = sample.mcap(tmp_path / "run.mcap")
    data = bytearray(file.read_bytes())
    data[len(data) // 2] ^= 0xff
    file.write_bytes(bytes(data))
    with pytest.raises(StickslipError, match=r"the chunk at byte \d+: its checksum is [0-9a-f]{8}, it says [0-9a-f]{8}"):
        stickslip.read_log(file, joint="elbow")
    bag = sample.rosbag(tmp_path / "run.bag")
    data = bag.read_bytes()
    bag.write_bytes(data[:len(data) // 2])
    with pytest.raises(StickslipError, match=r"the record at byte \d+ of the file is cut off: \d+ bytes are said, \d+ are there; `rosbag reindex`"):
        stickslip.read_log(bag, joint="elbow")


def one_joint_files(folder):
    """One joint's arrays in every format of arrays that this Python can write."""
    import xarray
    one = {"t": sample.T, "position": sample.Q[:, 1], "velocity": sample.DQ[:, 1], "tau": sample.TAU[:, 1]}
    numpy.savez_compressed(folder / "run.npz", **one)
    rows = xarray.Dataset({"time": ("row", one["t"]), **{name: ("row", one[name]) for name in ("position", "velocity", "tau")}})
    rows.to_netcdf(folder / "four.nc")
    files = ["run.npz", "four.nc"]
    if importlib.util.find_spec("scipy"):
        import scipy.io
        rows.to_netcdf(folder / "classic.nc", format="NETCDF3_CLASSIC", engine="scipy")
        scipy.io.savemat(folder / "five.mat", one)
        files += ["classic.nc", "five.mat"]
    if importlib.util.find_spec("h5py"):
        import h5py
        with h5py.File(folder / "run.h5", "w") as file:
            for name, values in one.items():
                file.create_dataset(name, data=values)
        (folder / "seven.mat").write_bytes(b"MATLAB 7.3 MAT-file".ljust(512) + (folder / "run.h5").read_bytes())
        files += ["run.h5", "seven.mat"]
    return [folder / name for name in files]


def test_damaged_files_of_arrays_are_refused_in_words(tmp_path):
    random = numpy.random.default_rng(1)
    for file in one_joint_files(tmp_path):
        assert len(stickslip.read_log(file)) == len(sample.T)
        whole = file.read_bytes()
        for k in range(60):  # cut off: refused; a flipped byte may leave a readable file, never another exception
            data = bytearray(whole[:int(random.integers(0, len(whole) - 1))] if k < 30 else whole)
            if k >= 30:
                data[int(random.integers(0, min(len(data), 2000)))] ^= int(random.integers(1, 256))
            file.write_bytes(bytes(data))
            try:
                stickslip.read_log(file)
                assert k >= 30, f"{file.name}, cut to {len(data)} of {len(whole)} bytes, was read"
            except StickslipError as error:
                assert file.name in str(error)


def test_a_reader_that_dies_of_a_damaged_file_does_not_end_the_program(tmp_path):
    io = pytest.importorskip("scipy.io")
    file = tmp_path / "run.mat"
    io.savemat(file, {"t": sample.T, "position": sample.Q[:, 1]})
    data = bytearray(file.read_bytes())
    data[176] ^= 0xff  # the kind of the first array's elements; SciPy 1.10 dies of it
    file.write_bytes(bytes(data))
    with pytest.raises(StickslipError, match="run.mat: is damaged"):
        stickslip.read_log(file)


def test_times_far_from_zero_ascend_or_are_refused(tmp_path):
    def log(times):
        numpy.savez(tmp_path / "run.npz", t=numpy.array(times), position=numpy.arange(len(times), dtype=float))
        return tmp_path / "run.npz"
    frame = stickslip.read_log(log([-1e20, 0.1, 0.2, 0.3]))  # three that are one, seen from the first
    assert list(frame["time"]) == [0, 1e20]
    assert any("time of the one before" in guess for guess in frame.attrs["guessed"])
    with pytest.raises(StickslipError, match="its times reach from -1.7e[+]308 to 1.7e[+]308"):
        stickslip.read_log(log([-1.7e308, 0.0, 1.7e308]))
    with pytest.raises(StickslipError, match="no complete row"):
        stickslip.read_log(log([numpy.inf, -numpy.inf]))


def test_damaged_folders_of_sage(tmp_path):
    folder = sample.sage(tmp_path / "run")
    text = (folder / "state_motor.csv").read_text()
    (folder / "state_motor.csv").write_text(text.replace("]", "", 1).replace("STATE_MOTOR,1000,\"[", "STATE_MOTOR,1000,\"[x", 1))
    with pytest.raises(StickslipError, match="state_motor.csv: row 1"):
        stickslip.read_log(folder, joint="elbow")
    lines = text.splitlines()
    whole = lines[5].split('"')
    for cell, said in ((whole[1][:-3], "row 5: positions: got .*, expected a list in brackets"), (whole[1].replace(",", ", x"), "row 5: positions: got .*, expected numbers")):
        # a list that is cut off within its last number would be another number
        (folder / "state_motor.csv").write_text("\n".join([*lines[:5], '"'.join([whole[0], cell, *whole[2:]]), *lines[6:]]))
        with pytest.raises(StickslipError, match=said):
            stickslip.read_log(folder, joint="elbow")
    for end, said in ((text[:-7], "torques: got .*, expected a list in brackets"), (text[:text.rindex('"[') - 1], "torques: got nothing"),
                      (text.replace("velocities", "speeds", 1), "has the columns type, timestamp, positions, speeds, torques, expected .*velocities")):
        (folder / "state_motor.csv").write_text(end)
        with pytest.raises(StickslipError, match=said):
            stickslip.read_log(folder, joint="elbow")
    (folder / "joint_list.txt").write_text("a\nelbow\nc\n")
    (folder / "state_motor.csv").write_text(text)
    with pytest.raises(StickslipError, match="2 values, joint_list.txt has 3"):
        stickslip.read_log(folder, joint="elbow")
    shutil.rmtree(folder)
    folder.mkdir()
    with pytest.raises(StickslipError, match="joint_list.txt"):
        stickslip.read_log(folder)


def test_convert_is_a_verb_of_the_program(tmp_path):
    import os
    import subprocess
    import sys
    from pathlib import Path

    bag = sample.mcap(tmp_path / "run.mcap")
    paths = os.environ | {"PYTHONPATH": str(Path(stickslip.__file__).parents[1]),
                          "PATH": f"{Path(sys.executable).parent}:{os.environ['PATH']}"}
    words = [stickslip.executable(), "convert", str(bag), str(tmp_path / "run.csv"), "--joint", "elbow", "--command", "/commands"]
    done = subprocess.run(words, capture_output=True, text=True, env=paths)
    assert done.returncode == 0 and "40 rows" in done.stdout and "REP 103" in done.stderr
    check(stickslip.read_log(tmp_path / "run.csv"))
    done = subprocess.run([*words[:3], str(tmp_path / "run.txt")], capture_output=True, text=True, env=paths)
    assert done.returncode == 2 and "expected a name that ends in .csv" in done.stderr


LOOP = {"joint": {"motion": "revolute", "inertia": 0.3}, "control": {"k_p": 400.0, "k_v": 20.0, "period": 0.002, "velocity_estimate": {"form": "backward-difference"}},
        "friction": {"law": "coulomb-viscous", "coulomb": 1.0, "viscous": 0.3}, "sensor": {"position_noise": 1e-6}}


def test_a_robot_from_a_folder_of_sage_and_from_a_frame(tmp_path):
    """The readers run below the program, in this Python; a joint that the log lacks is named with those it has."""
    sample.sage(tmp_path / "run")
    names = sample.NAMES
    answer = stickslip.diagnose_robot({names[0]: LOOP, "knee": LOOP}, tmp_path / "run", directory=tmp_path / "arm")
    first, absent = answer["joints"]
    assert first["status"] == "diagnosed" and first["reasons"], "a short log says too little, and why"
    own = stickslip.read_answer(tmp_path / "arm" / names[0] / "diagnosis.json")
    assert own["verdict"] == first["verdict"] and any("angles read as rad" in note for note in own["notes"])
    assert absent["status"] == "refused" and all(name in absent["problems"][0] for name in names)
    frame = stickslip.read_log(tmp_path / "run", joint=names[0])
    frame.columns = [c if c == "time" else f"{names[0]}.{c}" for c in frame.columns]
    same = stickslip.diagnose_robot({names[0]: LOOP}, frame)
    assert same["joints"][0]["gap"] == first["gap"]
    with pytest.raises(StickslipError, match="no joint elbw"):
        stickslip.diagnose_robot({names[0]: LOOP}, frame, joints=["elbw"])


def test_two_drivers_on_one_topic(tmp_path):
    """The hand's driver and the arm's publish joint states of their own by turns; commands meet the arm's rows in time."""
    states = "sensor_msgs/msg/JointState"
    messages = []
    for k, t in enumerate(sample.T):
        messages.append(("/joint_states", states, t - 0.004, sample.ros2_joint_state(k, ["finger", "thumb"])))
        messages.append(("/joint_states", states, t, sample.ros2_joint_state(k)))
        messages.append(("/command", "std_msgs/msg/Float64MultiArray", t + 0.001, sample.ros2_multi_array(sample.Q[k] + k)))
    file = sample.mcap_of(tmp_path / "two.mcap", messages)
    frame = stickslip.read_log(file, joint="elbow", command="/command")
    assert len(frame) == len(sample.T) - 1  # before the first command there is no reference
    assert numpy.allclose(frame["position"], sample.Q[1:, 1])
    assert numpy.allclose(frame["reference_position"], sample.Q[:-1, 1] + numpy.arange(len(sample.T) - 1))
    with pytest.raises(StickslipError, match="finger, thumb, " + ", ".join(sample.NAMES)):
        stickslip.read_log(file, joint="knee")
    with pytest.raises(StickslipError, match="command topic /comand; topics are /command"):
        stickslip.read_log(file, joint="elbow", command="/comand")


def test_a_topic_is_chosen_by_the_joint_that_only_it_has(tmp_path):
    """An arm and its gripper with a topic each; topics of other kinds do not matter."""
    states = "sensor_msgs/msg/JointState"
    messages = []
    for k, t in enumerate(sample.T):
        messages.append(("/gripper/joint_states", states, t, sample.ros2_joint_state(k, ["finger", "thumb"])))
        messages.append(("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray", t, b"\0\1\0\0abc"))
        messages.append(("/arm/joint_states", states, t, sample.ros2_joint_state(k)))
    frame = stickslip.read_log(sample.mcap_of(tmp_path / "run.mcap", messages), joint="elbow")
    assert numpy.allclose(frame["position"], sample.Q[:, 1])
    assert any("/arm/joint_states, the only topic that has elbow" in guess for guess in frame.attrs["guessed"])
    messages.append(("/gripper/joint_states", states, sample.T[-1] + 0.01, sample.ros2_joint_state(0)))
    with pytest.raises(StickslipError, match="has 2 topics of sensor_msgs/JointState, expected one; say which with topic="):
        stickslip.read_log(sample.mcap_of(tmp_path / "both.mcap", messages), joint="elbow")


def test_a_packing_that_cannot_be_read_is_told_with_the_file(tmp_path):
    if importlib.util.find_spec("zstandard"):
        pytest.skip("zstandard is installed")
    file = sample.mcap_of(tmp_path / "packed.mcap", [("/a", "std_msgs/msg/Float64", 0, sample.Cdr().add("d", 1.0).message())], packed="zstd")
    with pytest.raises(StickslipError, match="packed.mcap: chunks are packed with zstd: install python3-zstandard"):
        stickslip.read_log(file, joint="elbow")


def test_the_version_is_that_of_the_program():
    assert stickslip.__version__ == stickslip.version()
    with pytest.raises(AttributeError):
        stickslip.nothing_of_this_name


def test_commands_that_are_joint_states_give_the_velocity_of_the_reference(tmp_path):
    states, messages = "sensor_msgs/msg/JointState", []
    for k, t in enumerate(sample.T):
        messages.append(("/goal", states, t, sample.ros2_joint_state(k)))
        messages.append(("/joint_states", states, t + 0.001, sample.ros2_joint_state(k)))
    frame = stickslip.read_log(sample.mcap_of(tmp_path / "run.mcap", messages), joint="elbow", topic="/joint_states", command="/goal")
    assert numpy.allclose(frame["reference_position"], sample.Q[:, 1])
    assert numpy.allclose(frame["reference_velocity"], sample.DQ[:, 1])


def convert(log, table, **how):
    words = [sys.executable, "-m", "stickslip.convert", log, table, "--joint", "elbow", "--command", "/commands"]
    return subprocess.run(words, capture_output=True, text=True, env={**os.environ, "PYTHONPATH": str(Path(stickslip.__file__).parents[1])}, **how)


@pytest.mark.parametrize("name", ["run.csv", "run.csv.gz"])
def test_convert_leaves_no_half_of_a_record(tmp_path, name):
    log, table = sample.mcap(tmp_path / "run.mcap"), tmp_path / "made" / name
    full = convert(log, table, preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (500, 500)))  # stands for a full disk
    assert full.returncode == 2 and full.stderr.splitlines()[-1].endswith("File too large") and "Traceback" not in full.stderr
    assert not list(table.parent.iterdir())
    done = convert(log, table)
    assert done.returncode == 0 and [file.name for file in table.parent.iterdir()] == [name]
    check(stickslip.read_log(table))


def test_convert_that_is_interrupted_says_so(tmp_path):
    log = tmp_path / "pipe.mcap"
    os.mkfifo(log)
    words = [sys.executable, "-m", "stickslip.convert", log, tmp_path / "run.csv"]
    run = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                           env={**os.environ, "PYTHONPATH": str(Path(stickslip.__file__).parents[1])})
    with open(log, "wb"):  # it has begun to read when the other end can be opened
        for _ in range(20):  # a terminal and the program above both send it
            run.send_signal(signal.SIGINT)
            time.sleep(1e-3)
        said = run.communicate()[1]
    assert run.returncode == 3 and said == "interrupted before the record was complete: nothing is written\n"
    assert not (tmp_path / "run.csv").exists()
