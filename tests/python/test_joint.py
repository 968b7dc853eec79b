import re

import pytest

import stickslip
from stickslip import Joint, StickslipError


def test_a_joint_goes_through_text_and_dict():
    joint = Joint.example("two-mass", law="stribeck", motion="revolute")
    assert Joint(joint.to_toml()) == joint
    same = Joint.from_dict({"joint": {"motion": "prismatic", "model": "single-mass", "inertia": 1.0},
                            "control": {"kind": "position", "k_p": 6e4, "V0": 1e-3},
                            "friction": {"law": "coulomb-viscous", "coulomb": 60, "viscous": 0}})
    assert same["joint.inertia"] == 1.0 and same["friction.law"] == "coulomb-viscous"


def test_keys_have_units_and_meaning():
    keys = {k.path: k for k in Joint.example(motion="revolute").keys()}
    assert keys["control.k_p"].unit == "N·m/rad" and keys["control.k_p"].default == "required"
    assert keys["control.reference_velocity"].value is True
    assert "position gain" in keys["control.k_p"].help


def test_the_units_in_the_docstring_of_joint_are_those_of_its_keys():
    listed = [line.split() for line in Joint.__doc__.splitlines() if re.match(r"    [a-z]+\.", line)]
    assert len(listed) > 20
    for motion, column in (("prismatic", 1), ("revolute", 2)):
        units = {k.path: k.unit for model in ("single-mass", "two-mass")
                 for k in Joint.example(model, law="coulomb-viscous", motion=motion).keys()}
        for words in listed:
            assert units[words[0]] == words[column], words


def test_what_is_no_joint_is_refused_with_what_was_given():
    with pytest.raises(TypeError, match="text: got dict, expected the TOML text of a joint; Joint.from_dict"):
        Joint({"joint": {"inertia": 1.0}})
    with pytest.raises(TypeError, match="tables: got str, expected a dict"):
        Joint.from_dict("joint = 1")


def test_setting_takes_units_and_refuses_what_does_not_fit():
    joint = Joint.example()
    joint["control.V0"] = "2 mm/s"
    assert joint["control.V0"] == pytest.approx(2e-3)
    before = joint.to_toml()
    with pytest.raises(StickslipError, match="friction.L"):
        joint["friction.L"] = -1
    with pytest.raises(StickslipError, match="k_q"):
        joint["control.k_q"] = 1
    assert joint.to_toml() == before
    assert joint.changed({"control.k_p": 2e4})["control.k_p"] == 2e4 and joint["control.k_p"] == 6e4


def test_files(tmp_path, examples):
    joint = Joint.from_file(examples / "02-ball-screw" / "joint-with-memory.toml")
    joint.save(tmp_path / "joint.toml")
    assert Joint.from_file(tmp_path / "joint.toml") == joint
    shown = Joint.example()._repr_html_()
    assert "joint.inertia" in shown and "load.constant" not in shown and "control.reference_velocity" not in shown  # at their defaults
    with pytest.raises(StickslipError, match="no such file"):
        Joint.from_file(tmp_path / "other.toml")


def test_version_is_that_of_the_program():
    from pathlib import Path
    text = (Path(__file__).resolve().parents[2] / "analysis" / "base" / "version.h").read_text()
    assert f'STICKSLIP_VERSION "{stickslip.version()}"' in text
