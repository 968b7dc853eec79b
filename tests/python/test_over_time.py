"""A gap against a baseline, two diagnoses, many by date, and the way back from a joint's page to its robot's."""
import numpy
import pandas
import pytest

import stickslip
from stickslip import StickslipError

JOINT = {"joint": {"motion": "revolute", "inertia": 0.3},
         "control": {"k_p": 400.0, "k_v": 20.0, "period": 0.002, "velocity_estimate": {"form": "backward-difference"}},
         "friction": {"law": "coulomb-viscous", "coulomb": 1.0, "viscous": 0.3},
         "sensor": {"encoder_quantum": 1e-6, "position_noise": 2e-5}}
T = numpy.arange(0, 3, 2e-3)
MOTION = {"time": T, "reference_position": 0.5 * (1 - numpy.cos(3 * T))}


def measured(coulomb, seed):
    return {"run": stickslip.simulate(JOINT, {"friction.coulomb": coulomb}, reference=MOTION, seed=seed)}


def test_a_gap_is_new_has_another_size_or_is_as_it_was(tmp_path):
    clean, worn = tmp_path / "clean.json", tmp_path / "worn.json"
    assert stickslip.check_gap(JOINT, measured(1.0, 1), clean, update=True)["diagnosis"]["verdict"] == "no-gap"
    assert stickslip.check_gap(JOINT, measured(1.0, 2), clean)["passes"]
    new = stickslip.check_gap(JOINT, measured(1.1, 3), clean)
    assert [r["kind"] for r in new["regressions"]] == ["new-gap"]
    stickslip.check_gap(JOINT, measured(1.2, 4), worn, update=True)
    assert stickslip.check_gap(JOINT, measured(1.2, 5), worn)["passes"]
    moved = stickslip.check_gap(JOINT, measured(1.32, 6), worn)
    assert "number-moved" in [r["kind"] for r in moved["regressions"]]
    (level,) = (n for n in moved["comparison"]["numbers"] if n["name"] == "Coulomb level")
    assert level["change"] == pytest.approx(0.12, abs=4 * level["after"]["stderr"] + 4 * level["before"]["stderr"])
    assert stickslip.check_gap(JOINT, measured(1.0, 7), worn)["passes"]  # a gap that has gone


def test_baselines_that_are_none_are_refused(tmp_path):
    for text, told in (("{}", "is not a gap baseline"), ("{", "is not complete JSON"),
                       ('{"format": "stickslip-gap-baseline/1", "joint": "", "diagnosis": {}}', "is not a diagnosis"),
                       ('{"format": "stickslip-gap-baseline/1"}', "lacks joint or diagnosis")):
        (tmp_path / "b.json").write_text(text)
        with pytest.raises(StickslipError, match=told):
            stickslip.check_gap(JOINT, measured(1.0, 1), tmp_path / "b.json")
    with pytest.raises(StickslipError, match="write a first baseline with --update"):
        stickslip.check_gap(JOINT, measured(1.0, 1), tmp_path / "none.json")


def test_diagnoses_by_date(tmp_path):
    runs = tmp_path / "runs"
    for seed, (day, level) in enumerate((("2026-03-02", 1.1), ("2026-01-05", 1.0), ("2026-05-04T14-30", 1.25))):
        stickslip.diagnose(JOINT, measured(level, 10 + seed), directory=runs / day, report=True)
    two = stickslip.compare(runs / "2026-03-02", runs / "2026-05-04T14-30")
    assert two["gap"] == "grown" and two["causes"]["kept"] == ["coulomb-level"]
    level = next(n for n in two["numbers"] if n["name"] == "Coulomb level")
    assert level["moved"] and level["change"] == pytest.approx(0.15, abs=0.01)
    assert stickslip.compare(runs / "2026-01-05", runs / "2026-03-02")["gap"] == "appeared"
    line = stickslip.timeline(runs, tmp_path / "line")
    assert [r["date"] for r in line["runs"]] == ["2026-01-05", "2026-03-02", "2026-05-04 14:30"]
    assert [r["since_the_run_before"] and r["since_the_run_before"]["gap"] for r in line["runs"]] == [None, "appeared", "grown"]
    page = (tmp_path / "line" / "report.html").read_text(encoding="utf-8")
    assert 'href="../runs/2026-01-05/report.html"' in page and "Coulomb level" in page
    (tmp_path / "undated").mkdir()
    (runs / "2026-03-02" / "diagnosis.json").rename(tmp_path / "undated" / "diagnosis.json")
    with pytest.raises(StickslipError, match="no part of this path has a date"):
        stickslip.timeline(tmp_path / "undated", tmp_path / "line")
    with pytest.raises(StickslipError, match="holds no diagnosis.json"):
        stickslip.timeline(runs / "2026-03-02", tmp_path / "line")


def test_the_page_of_a_joint_leads_back_to_its_robot(tmp_path):
    record = measured(1.0, 1)["run"]
    log = {"time": record["time"], **{f"elbow_{c}": record[c] for c in record.columns if c != "time"}}
    stickslip.diagnose_robot({"elbow": JOINT}, log, directory=tmp_path, report=True)
    assert '<a href="../robot.html">All joints of the robot</a>' in (tmp_path / "elbow" / "report.html").read_text(encoding="utf-8")
    assert "elbow/report.html" in (tmp_path / "robot.html").read_text(encoding="utf-8")


def test_frames_that_are_no_record_are_refused_in_words():
    good = measured(1.0, 3)["run"]

    def with_column(**columns):
        return good.assign(**columns)

    twice = good.join(good[["position"]].rename(columns={"position": "again"})).rename(columns={"again": "position"})
    for frame, told in ((twice, "run: got 2 columns called 'position', expected one"),
                        (good.rename(columns={"position": 7}), "run: got 7 as the name of a column, expected text"),
                        (with_column(position=good["position"] + 1j), r"^run: row 0: position: is \"\(.*j\)\", expected a finite number"),
                        (with_column(position=good["position"].astype(object).where(good.index != 9, "abc")),
                         "^run: row 9: position: is \"abc\", expected a finite number"),
                        (with_column(position=good["position"].where(good.index != 9)), "^run: row 9: position: is missing, as in 1 of"),
                        (with_column(position=good["position"].convert_dtypes().where(good.index != 9)), "^run: row 9: position: is missing"),
                        (with_column(position=good["position"].where(good.index != 9, numpy.inf)), "^run: row 9: position: is \"inf\""),
                        (with_column(time=good["time"].where(good.index != 9, good["time"][8])), "^run: row 9: time: is 0.016, the same as"),
                        (with_column(time=(good["time"] * 1e9).astype("int64")), "^run.csv: suspected nanoseconds"),
                        (with_column(velocity=good["velocity"] * 60 / (2 * numpy.pi)), "suspected unit: velocity is 9.5 times the rate of position"),
                        (with_column(position=numpy.degrees(good["position"])), "^run.csv: suspected degrees: position moves 5[78].. times")):
        with pytest.raises(StickslipError, match=told):
            stickslip.diagnose(JOINT, {"run": frame})


def test_columns_of_any_kind_of_pandas_are_the_same_record():
    good = measured(1.3, 3)["run"]
    first = stickslip.diagnose(JOINT, {"run": good})
    other = good.convert_dtypes().assign(position=good["position"].astype("category"), velocity=good["velocity"].astype(str).astype("string"),
                                         reference_position=pandas.arrays.SparseArray(good["reference_position"]))
    dated = good.assign(time=pandas.to_datetime(good["time"], unit="s", utc=True))
    lasting = good.drop(columns="time").set_index(pandas.to_timedelta(good["time"], unit="s").rename("stamp"))
    noted = good.assign(state="running", note=[None] * len(good), seen=pandas.to_datetime("2026-01-01"))
    for frame in (other, good.set_index("time"), good[good.columns[::-1]].astype(object), noted, good.to_records(index=False),
                  good.set_index("time").to_xarray()):
        assert stickslip.diagnose(JOINT, {"run": frame})["effects"] == first["effects"]
    level = first["effects"][0]["values"]["Coulomb level"]["value"]
    for frame in (dated, dated.set_index("time"), lasting):  # whole nanoseconds
        found = stickslip.diagnose(JOINT, {"run": frame})["effects"][0]
        assert found["names"] == ["coulomb-level"] and found["values"]["Coulomb level"]["value"] == pytest.approx(level, rel=1e-6)
