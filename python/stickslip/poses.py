"""Maps of one joint over the angles of a robot's joints: where the arm stands decides whether the joint sticks."""
from __future__ import annotations

import itertools
import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import TYPE_CHECKING, Any, Mapping, Sequence

from . import program, toml_text
from .joint import Joint
from .program import StickslipError
from .verbs import JointLike, _input, evaluate

if TYPE_CHECKING:
    import xarray


def sweep_poses(robot: str | Path, name: str, over: Mapping[str, Sequence[float]], joint: JointLike, *, at: Mapping[str, float] | None = None,
                armature: float = 0.0, settings: Mapping[str, Any] | None = None, threads: int = 0) -> "xarray.Dataset":
    """The joint called `name` of a URDF or MJCF at every pose: inertia, gravity, both theories and the nonlinear outcome.

    `over` has the coordinates (rad or m) of one or several joints of the robot: the axes of the dataset; joints in neither `over` nor
    `at` stand at their zero. `joint` is the joint file: law of friction, gains and all else, whose inertia (of several masses: the link's)
    and gravity are those of the pose. `armature` (kg·m² or kg) is a rotor behind its gear that the description lacks; of several masses
    the joint file has the motor's. plot_map draws the dataset. Variables have one value for each pose: inertia [kg·m² or kg],
    gravity_effort [N·m or N], spectral_abscissa [1/s], k_cr, verdicts. Raises StickslipError for joints or coordinates that the robot has not.

    >>> maps = stickslip.sweep_poses("arm.urdf", "shoulder", {"elbow": numpy.linspace(0, 3, 16), "wrist": numpy.linspace(0, 2, 9)}, joint)
    >>> stickslip.plot_map(maps, "elbow", "wrist")
    """
    import numpy
    import xarray

    axes = {other: numpy.asarray(values, dtype=float) for other, values in over.items()}
    if not axes or any(values.ndim != 1 or not len(values) for values in axes.values()):
        raise StickslipError("over: expected at least one joint of the robot with a list of coordinates")
    both = sorted(set(axes) & set(at or {}))
    if both:
        raise StickslipError(f"over and at: both have {both[0]}, expected each joint in one of them")
    base = joint if isinstance(joint, Joint) else _read(joint)
    single = base["joint.model"] == "single-mass"

    def point(place: tuple[float, ...]) -> dict[str, Any]:
        found = _at_pose(robot, name, {**(at or {}), **dict(zip(axes, place))})
        inertia = found["inertia"] + (found["armature"] + armature if single else 0)
        gravity = found["gravity"]
        answer = evaluate(base, {"joint.inertia" if single else "joint.link_inertia": inertia, "load.gravity_amplitude": gravity["amplitude"],
                                 "load.gravity_phase": gravity["phase"], **(settings or {})})
        state = answer.at("linear.state_variable")
        return {"inertia": inertia, "gravity_effort": gravity["effort"], "spectral_abscissa": state["spectral_abscissa"],
                "k_cr": state["k_cr"], "state_variable_stable": state["stable"],
                "velocity_only_stable": answer.at("linear.velocity_only.stable"), "outcome": answer.at("nonlinear.outcome"),
                "region": answer.at("nonlinear.region")}

    places = list(itertools.product(*axes.values()))
    pool = ThreadPoolExecutor(threads or os.cpu_count())
    try:
        points = list(pool.map(point, places))
    finally:
        pool.shutdown(cancel_futures=True)
    shape = tuple(len(values) for values in axes.values())
    turns = base["joint.motion"] == "revolute"
    units = {"inertia": "kg·m²" if turns else "kg", "gravity_effort": "N·m" if turns else "N", "spectral_abscissa": "1/s",
             "k_cr": "N·m/rad" if turns else "N/m"}
    dataset = xarray.Dataset(coords=axes)
    for variable in points[0]:
        values = [p[variable] for p in points]
        if variable in units:
            values = [float("nan") if v is None else v for v in values]
        dataset[variable] = (tuple(axes), numpy.array(values, dtype=None if variable in units else object).reshape(shape))
        dataset[variable].attrs["units"] = units.get(variable, "")
    dataset.attrs.update(robot=str(robot), joint=name)
    return dataset


def _read(joint: JointLike) -> Joint:
    with _input(joint) as file:
        return Joint.from_file(file)


def _at_pose(robot: str | Path, name: str, pose: Mapping[str, float]) -> dict[str, Any]:
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        file = Path(folder) / "pose.toml"
        file.write_text(toml_text.dumps({other: float(value) for other, value in pose.items()}), encoding="utf-8")
        try:
            return program.answer_of(["import", robot, "--joint", name, "--at", file])
        except StickslipError as error:
            raise StickslipError(str(error).replace(str(file), "pose")) from None
