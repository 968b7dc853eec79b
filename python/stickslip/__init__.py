"""stickslip: stick-slip of robot joints.

>>> import stickslip
>>> joint = stickslip.Joint.example()
>>> stickslip.evaluate(joint).at("linear.state_variable.stable")
"""
from .answers import Answer
from .arm import with_arm_load
from .joint import Joint, Key
from .logs import read_log
from .plots import plot_boundary, plot_effects, plot_map, plot_motion
from .poses import sweep_poses
from .program import Interrupted, StickslipError, executable, version
from .verbs import (boundary, check_gap, compare, design, diagnose, diagnose_robot, evaluate, export, import_robot, margins,
                    read_answer, simulate, sweep, timeline)


def __getattr__(name: str):
    if name == "__version__":
        return version()
    raise AttributeError(f"module 'stickslip' has no attribute {name!r}")


__all__ = ["Answer", "Interrupted", "Joint", "Key", "StickslipError", "boundary", "check_gap", "compare",
           "design", "diagnose", "diagnose_robot",
           "evaluate", "executable", "export", "import_robot", "margins", "plot_boundary", "plot_effects", "plot_map", "plot_motion",
           "read_answer", "read_log", "simulate", "sweep", "sweep_poses", "timeline", "version", "with_arm_load"]
