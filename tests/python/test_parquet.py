"""Data sets of LeRobot: in Parquet where this Python has pyarrow, and as pyarrow gives them where it has not."""
import json
import sys

import log_samples as sample
import numpy
import pytest

import stickslip
from stickslip import StickslipError


def test_parquet_is_refused_in_words_without_pyarrow(tmp_path):
    try:
        import pyarrow  # noqa: F401
    except ImportError:
        (tmp_path / "run.parquet").write_bytes(b"PAR1")
        with pytest.raises(StickslipError, match="pyarrow"):
            stickslip.read_log(tmp_path / "run.parquet")


def lerobot(folder, names=sample.NAMES):
    """A data set of two episodes in the folders of LeRobot, without its file: that is what the next two make of the columns."""
    (folder / "meta").mkdir(parents=True)
    (folder / "data" / "chunk-000").mkdir(parents=True)
    (folder / "meta" / "info.json").write_text(json.dumps({"features": {"observation.state": {"names": names}}}))
    columns = {"observation.state": list(sample.Q.astype("float32")) * 2, "action": list(sample.COMMAND.astype("float32")) * 2,
               "timestamp": list(sample.T) * 2, "episode_index": [3] * len(sample.T) + [4] * len(sample.T)}
    return folder / "data" / "chunk-000" / "file-000.parquet", columns


def as_pyarrow_gives_it(file, columns, monkeypatch):
    """Without pyarrow: the frame alone, behind a stand-in for the container."""
    import types

    import pandas

    table = types.SimpleNamespace(to_pandas=lambda: pandas.DataFrame(columns))
    parquet = types.SimpleNamespace(read_table=lambda path: table)
    monkeypatch.setitem(sys.modules, "pyarrow", types.SimpleNamespace(parquet=parquet))
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", parquet)
    file.write_bytes(b"PAR1")


def of_lists(file, columns, monkeypatch, length=-1):
    pyarrow = pytest.importorskip("pyarrow", reason="skipped: this Python has no pyarrow")
    from pyarrow import parquet

    kind = pyarrow.list_(pyarrow.float32(), length)
    parquet.write_table(pyarrow.table({name: pyarrow.array(values, type=kind) if name in ("observation.state", "action") else values
                                       for name, values in columns.items()}), file)


def of_arrays(file, columns, monkeypatch):
    """Version 3 of LeRobot says how long its lists are."""
    of_lists(file, columns, monkeypatch, len(sample.NAMES))


@pytest.mark.parametrize("write", [as_pyarrow_gives_it, of_lists, of_arrays])
@pytest.mark.parametrize("names", [sample.NAMES, {"motors": sample.NAMES}])
def test_a_lerobot_data_set(tmp_path, monkeypatch, names, write):
    file, columns = lerobot(tmp_path, names)
    write(file, columns, monkeypatch)
    frame = stickslip.read_log(file, joint="elbow", episode=4)
    assert numpy.allclose(frame["time"], sample.T) and numpy.allclose(frame["position"], sample.Q[:, 1], atol=1e-6)
    assert numpy.allclose(frame["reference_position"], sample.COMMAND[:, 1], atol=1e-6)
    assert any("degrees or per cent" in guess for guess in frame.attrs["guessed"])
    with pytest.raises(StickslipError, match="holds the episodes 3 to 4; say which with episode="):
        stickslip.read_log(file, joint="elbow")
    with pytest.raises(StickslipError, match="has no episode 5, it has 3 to 4"):
        stickslip.read_log(file, joint="elbow", episode=5)
    with pytest.raises(StickslipError, match="has no joint 'knee', it has shoulder, elbow"):
        stickslip.read_log(file, joint="knee", episode=3)


@pytest.mark.parametrize("write", [as_pyarrow_gives_it, of_lists])
def test_a_lerobot_data_set_of_unequal_rows_is_told(tmp_path, monkeypatch, write):
    for name, change, words in (("ragged", lambda c: c["action"].__setitem__(47, c["action"][47][:1]), "action has 1 to 2 joints a row, expected as many"),
                                ("fewer", lambda c: c.update(action=[row[:1] for row in c["action"]]), "observation.state has 2 joints, action has 1")):
        file, columns = lerobot(tmp_path / name)
        change(columns)
        write(file, columns, monkeypatch)
        with pytest.raises(StickslipError, match=words):
            stickslip.read_log(file, joint="elbow", episode=4)


def test_damaged_parquet_is_refused_in_words(tmp_path, monkeypatch):
    file, columns = lerobot(tmp_path)
    of_lists(file, columns, monkeypatch)
    whole = file.read_bytes()
    random = numpy.random.default_rng(1)
    cut = file.with_name("cut-run.parquet")
    for _ in range(60):
        cut.write_bytes(whole[:int(random.integers(0, len(whole) - 1))])
        with pytest.raises(StickslipError, match="cut-run"):
            stickslip.read_log(cut, joint="elbow", episode=4)
    for _ in range(60):  # a flipped byte may leave a readable log, never another exception
        data = bytearray(whole)
        data[int(random.integers(0, len(data)))] ^= int(random.integers(1, 256))
        cut.write_bytes(bytes(data))
        try:
            stickslip.read_log(cut, joint="elbow", episode=4)
        except StickslipError as error:
            assert "cut-run" in str(error)
