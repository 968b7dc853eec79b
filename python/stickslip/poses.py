"""Maps of one joint over the angles of a robot's joints: where the arm stands decides whether the joint sticks."""
from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, Sequence

from .joint import Joint
from .program import StickslipError
from .verbs import JointLike, _input, sweep

if TYPE_CHECKING:
    import xarray


def sweep_poses(robot: str | Path, name: str, over: Mapping[str, Sequence[float]], joint: JointLike, *, at: Mapping[str, float] | None = None,
                armature: float = 0.0, settings: Mapping[str, Any] | None = None, nonlinear: bool = False,
                directory: str | Path | None = None, report: bool = False, threads: int = 0) -> "xarray.Dataset":
    """`sweep` of the joint called `name` of a URDF or MJCF over poses, for a joint that is no file: its spec has a [robot] table.

    `over` has the coordinates (rad or m) of one or several other joints of the robot: the axes of the dataset; joints in neither `over` nor
    `at` stand at their zero. `joint` is the joint: law of friction, gains and all else, whose inertia (of several masses: the link's)
    and gravity are those of the pose. `armature` (kg·m² or kg) is a rotor behind its gear that the description lacks; of several masses
    the joint has the motor's. `nonlinear` simulates each pose, too, which gravity along the motion may leave undecided. plot_map draws the dataset. Raises StickslipError for joints or
    coordinates that the robot has not.

    >>> maps = stickslip.sweep_poses("arm.urdf", "shoulder", {"elbow": numpy.linspace(0, 3, 16), "wrist": numpy.linspace(0, 2, 9)}, joint)
    >>> stickslip.plot_map(maps, "elbow", "wrist")
    """
    both = sorted(set(over) & set(at or {}))
    if both:
        raise StickslipError(f"over and at: both have {both[0]}, expected each joint in one of them")
    with _input(joint) as file:
        base = Joint.from_file(file).changed(settings)
    tables: dict[str, Any] = {
        "robot": {"file": str(robot), "joint": name, "armature": float(armature)},
        "axes": {f"pose.{other}": [float(value) for value in values] for other, values in over.items()},
        "design": {f"pose.{other}": float(value) for other, value in (at or {}).items()}, "nonlinear": {"enabled": nonlinear}}
    with _input(base) as file:
        return sweep({"joint": str(file), **tables}, directory, report, threads)
