import os
import signal
import subprocess
import sys
import textwrap
import time
from pathlib import Path

import numpy
import pandas
import pytest

import stickslip
from stickslip import Joint, StickslipError

REFERENCE = {"joint": {"motion": "prismatic", "model": "single-mass", "inertia": 1.0},
             "control": {"kind": "position", "k_p": 6e4, "k_v": 10.0, "V0": 1e-3},
             "friction": {"law": "rate-and-state", "f0": 60.0, "A": 1.0, "B": 1.5, "L": 1e-5, "V_star": 1e-3}}


def critical_gain(k_v):
    """One mass, one state: k_cr = ((B − A − k_v V)/L)(1 + m V²/(L (A + k_v V))), by hand."""
    A, B, L, V, m = 1.0, 1.5, 1e-5, 1e-3, 1.0
    return (B - A - k_v * V) / L * (1 + m * V * V / (L * (A + k_v * V)))


def test_evaluate_against_the_closed_form():
    for k_v in (0.0, 10.0, 200.0):
        answer = stickslip.evaluate(REFERENCE, {"control.k_v": k_v})
        assert answer.at("linear.state_variable.k_cr") == pytest.approx(critical_gain(k_v), rel=1e-9)
    assert "k_cr" in answer._repr_html_()
    with pytest.raises(KeyError, match="linear"):
        answer.at("linaer.stable")


def test_a_sweep_is_a_dataset_whose_sign_is_that_of_the_closed_form():
    spec = {**REFERENCE, "axes": {"control.k_p": {"from": 1e4, "to": 2e5, "points": 9, "scale": "log"}, "control.k_v": [0.0, 10.0, 200.0]}}
    dataset = stickslip.sweep(spec)
    assert dataset.sizes["k_p"] == 9 and dataset.attrs["undecided_points"] == 0
    abscissa = dataset["spectral_abscissa"]
    for k_v in (0.0, 10.0, 200.0):
        stable = abscissa.sel(k_v=k_v) <= 0
        assert list(stable.values) == list(dataset["k_p"].values > critical_gain(k_v))


def test_simulate_is_a_data_frame():
    frame = stickslip.simulate(Joint.from_dict(REFERENCE), {"control.k_p": 2e4, "control.k_v": 0.0})
    assert {"time", "velocity", "friction"} <= set(frame.columns)
    assert frame["time"].is_monotonic_increasing and len(frame) > 100
    assert frame.attrs["units"]["velocity"] == "m/s"


def test_a_record_has_units_those_of_the_drive_too():
    joint = {
        "joint": {"motion": "revolute", "inertia": 0.01},
        "actuator": {"kind": "dc-motor", "k_t": 0.5, "k_e": 0.5, "resistance": 1.0},
        "control": {"k_p": 40.0, "k_v": 1.0, "period": 1e-3, "V0": 1.0, "velocity_estimate": {"form": "backward-difference"}},
        "friction": {"law": "coulomb-viscous", "coulomb": 0.1, "viscous": 0.01},
    }
    time = numpy.linspace(0, 1, 101)
    frame = stickslip.simulate(joint, reference={"time": time, "reference_position": 0.2 * time})
    units = frame.attrs["units"]
    assert (units["position"], units["velocity"]) == ("rad", "rad/s")
    assert (units["effort_command"], units["effort_measured"]) == ("V", "N·m")


def test_files_that_a_dict_names_are_those_of_the_working_directory(tmp_path, monkeypatch):
    (tmp_path / "joints").mkdir()
    Joint.from_dict(REFERENCE).save(tmp_path / "joints" / "slide.toml")
    monkeypatch.chdir(tmp_path)
    dataset = stickslip.sweep({"joint": "joints/slide.toml", "axes": {"control.k_p": {"from": 1e4, "to": 1e5, "points": 3}}})
    assert dataset.sizes == {"k_p": 3}


def test_boundary_and_margins():
    answer = stickslip.boundary(REFERENCE, along="control.k_p=1e4..1e6", kind="linear")
    found = [p["value"] for line in answer["lines"] for p in line["points"]]
    assert found and min(abs(k / critical_gain(10.0) - 1) for k in found) < 1e-9
    assert stickslip.margins(REFERENCE)


def test_text_beside_the_signals_of_a_record_is_nobodys_business():
    time = numpy.arange(0, 1, 1e-3)
    notes = ["a, b", 'the "good" run', "two\nlines", None]
    run = {"time": time, "position": 0 * time, "note": [notes[i % 4] for i in range(len(time))]}
    joint = {**REFERENCE, "control": {**REFERENCE["control"], "period": 1e-3, "velocity_estimate": {"form": "exact"}}}
    without = {name: column for name, column in run.items() if name != "note"}
    verdicts = [stickslip.diagnose(joint, {"run": given})["verdict"] for given in (run, without)]
    assert verdicts[0] == verdicts[1]


def test_bad_input_says_where():
    with pytest.raises(StickslipError, match="inertia"):
        stickslip.evaluate({**REFERENCE, "joint": {"motion": "prismatic", "model": "single-mass"}})
    with pytest.raises(StickslipError, match=r'run: row 2: position: is "x", expected a finite number'):
        stickslip.diagnose(REFERENCE, {"run": pandas.DataFrame({"time": [0, 1, 2], "position": [0, 1, "x"]})})
    with pytest.raises(StickslipError, match=r'^run: row 1: position: is "\[1 2\]", expected a finite number[^\n]*$'):
        stickslip.diagnose(REFERENCE, {"run": {"time": [0, 1, 2], "position": [0, [1, 2], 2]}})
    with pytest.raises(StickslipError, match="run: row 1: time: is missing"):
        stickslip.diagnose(REFERENCE, {"run": {"time": [0.0, numpy.nan], "position": [0.0, 0.0]}})
    with pytest.raises(StickslipError, match="run: got ndarray, expected a data frame, a dict of columns, an array with named fields"):
        stickslip.diagnose(REFERENCE, {"run": numpy.zeros((3, 2))})
    with pytest.raises(StickslipError, match="^joint: requirements.sample_time: is not set"):  # not a file that is gone
        stickslip.design(Joint.from_dict(REFERENCE), {"position_noise": "1 um"})
    with pytest.raises(StickslipError, match="^input:"):
        stickslip.evaluate({**REFERENCE, "friction": {"law": "nosuch"}})
    for given, got in (({}, "an empty dict"), ([1], "list"), (None, "NoneType")):
        for verb in (stickslip.diagnose, lambda joint, records: stickslip.check_gap(joint, records, "baseline.json")):
            with pytest.raises(TypeError, match=f"^records: got {got}, expected a dict of at least one data frame"):
                verb(REFERENCE, given)
    run = {"time": [0.0, 0.1], "position": [0.0, 0.0]}
    for verb in (stickslip.diagnose, lambda joint, records: stickslip.check_gap(joint, records, "baseline.json"),
                 lambda joint, records: stickslip.export(joint, "mjcf", records=records)):
        with pytest.raises(TypeError, match="^records: got 1 as the name of a record, expected text"):
            verb(REFERENCE, {1: run})
        with pytest.raises(StickslipError, match="^records: got a name of 300 characters, 'xxx.*may have 255 bytes"):
            verb(REFERENCE, {"x" * 300: run})
    with pytest.raises(TypeError, match="^settings: got list, expected a dict such as"):
        stickslip.evaluate(REFERENCE, ["control.k_p=1"])
    with pytest.raises(TypeError, match="^uncertain: got str, expected a dict"):
        stickslip.margins(REFERENCE, "friction.L")
    with pytest.raises(TypeError, match="^require: got str, expected a dict"):
        stickslip.design(REFERENCE, "margin")
    with pytest.raises(TypeError, match="^joint: got int, expected a Joint"):
        stickslip.evaluate(5)


def test_every_public_function_says_what_it_raises_or_its_module_does():
    for name in stickslip.__all__:
        thing = getattr(stickslip, name)
        assert thing.__doc__ and thing.__doc__.strip(), name
        if callable(thing) and not isinstance(thing, type) and thing.__module__ != "stickslip.verbs":
            assert "Raises" in thing.__doc__ or name == "version", name
    assert "raise StickslipError" in sys.modules["stickslip.verbs"].__doc__


def test_options_of_the_command_line_may_be_flags(capfd):
    delayed = {**REFERENCE, "control": {**REFERENCE["control"], "period": 1e-3, "velocity_estimate": {"form": "backward-difference"}}}
    real, ideal = (stickslip.boundary(delayed, along="control.k_p=1e4..1e6", kind="linear", ideal_loop=ideal) for ideal in (False, True))
    assert real.at("loop.kind") == "sampled" and ideal.at("loop.kind") == "ideal"
    assert stickslip.margins(REFERENCE, effort=0.1)


def test_answers_are_read_from_files_and_others_refused(tmp_path):
    file = tmp_path / "answer.json"
    for text, words in (("{", "is no JSON"), ("[1]", "got a JSON list, expected an answer"), (None, "there is no such file")):
        file.write_text(text) if text else file.unlink()
        with pytest.raises(StickslipError, match=words):
            stickslip.read_answer(file)
    with pytest.raises(StickslipError, match="is a folder"):
        stickslip.read_answer(tmp_path)


def test_export_and_import(tmp_path):
    text = stickslip.export(REFERENCE, "mjcf", name="elbow")["text"]
    robot = tmp_path / "elbow.xml"
    robot.write_text(text)
    joint = stickslip.import_robot(robot, "elbow", settings={"control.V0": 1e-3})
    assert joint["joint.inertia"] == pytest.approx(1.0) and joint["friction.coulomb"] == pytest.approx(60.0)
    assert joint["control.k_p"] == pytest.approx(6e4)


def test_a_robot_without_gains_is_refused_with_the_settings_that_it_lacks(tmp_path):
    robot = tmp_path / "arm.urdf"
    robot.write_text("""<robot name='p'><link name='ground'/><link name='rod'><inertial><mass value='1'/>
        <inertia ixx='0.2' iyy='0.2' izz='0.1' ixy='0' ixz='0' iyz='0'/></inertial></link><joint name='swing' type='continuous'>
        <parent link='ground'/><child link='rod'/><axis xyz='0 1 0'/></joint></robot>""")
    with pytest.raises(StickslipError, match=r"says nothing of control.k_p of joint 'swing'; expected settings=\{\"control.k_p\": …\}"):
        stickslip.import_robot(robot, "swing")
    with pytest.raises(TypeError, match="^at: got float, expected a dict"):
        stickslip.import_robot(robot, "swing", at=0.5, settings={"control.k_p": 200})


def test_an_interrupt_reaches_the_program(tmp_path):
    script = textwrap.dedent(f"""
        import sys; sys.path.insert(0, {str(Path(stickslip.__file__).parents[1])!r})
        import stickslip
        spec = {{**{REFERENCE!r}, "axes": {{"control.k_p": {{"from": 1e3, "to": 1e6, "points": 2000}}, "control.k_v": {{"from": 0, "to": 100, "points": 2000}}}}}}
        try:
            stickslip.sweep(spec, {str(tmp_path / 'out')!r})
        except KeyboardInterrupt:
            print("interrupted")
    """)
    process = subprocess.Popen([sys.executable, "-c", script], stdout=subprocess.PIPE, text=True, env=os.environ)
    for _ in range(600):  # the run's folder appears when it has begun
        if (tmp_path / "out" / "plan.json").exists() or process.poll() is not None:
            break
        time.sleep(0.1)
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate()
    assert out.strip() == "interrupted"


def test_plots(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    spec = {**REFERENCE, "axes": {"control.k_p": {"from": 1e4, "to": 2e5, "points": 9, "scale": "log"}, "control.k_v": [1.0, 10.0, 100.0]}}
    ax = stickslip.plot_map(stickslip.sweep(spec), "control.k_p", "control.k_v")
    assert ax.get_xscale() == "log"
    ax = stickslip.plot_motion(stickslip.simulate(REFERENCE))
    assert ax.get_ylabel() == "velocity [m/s]"
    ax.figure.savefig(tmp_path / "motion.png")
    answer = stickslip.boundary(REFERENCE, over=["control.k_p=1e4..1e6", "control.k_v=1..100"], kind="linear", guard=4)
    assert stickslip.plot_boundary(answer).lines


def test_maps_and_boundaries_are_drawn_as_the_report_draws_them():
    pytest.importorskip("matplotlib").use("Agg")
    spec = {**REFERENCE, "axes": {"control.k_p": {"from": 1e4, "to": 2e5, "points": 9, "scale": "log"},
                                  "control.k_v": {"from": 10.0, "to": 1000.0, "points": 9, "scale": "log"}}}
    dataset = stickslip.sweep(spec)
    told = [text.get_text() for text in stickslip.plot_map(dataset, "control.k_p", "control.k_v").get_legend().get_texts()]
    assert told == ["stick-slip in both models", "smooth with memory only",
                    "boundary, velocity-only model", "boundary, with frictional memory"]
    assert stickslip.plot_map(dataset, "control.k_p", "control.k_v", "k_cr").get_legend() is None
    with pytest.raises(ValueError, match="nosuch: is no variable of this sweep, variables are .*k_cr"):
        stickslip.plot_map(dataset, "control.k_p", "control.k_v", "nosuch")
    answer = stickslip.boundary(REFERENCE, over=["control.k_p=1e4..1e6", "control.k_v=1..1000"], guard=4)
    ax = stickslip.plot_boundary(answer)
    assert [line.get_linestyle() for line in ax.lines if "velocity-only" in line.get_label()] == ["--"]
    assert (ax.get_xlabel(), ax.get_xscale(), ax.get_ylabel()) == ("control.k_p [N/m]", "log", "control.k_v [N·s/m]")
    negative = stickslip.boundary(REFERENCE, over=["control.k_p=-1e5..1e6", "control.k_v=1..1000"], kind="linear", guard=4)
    assert stickslip.plot_boundary(negative).get_xscale() == "linear"
