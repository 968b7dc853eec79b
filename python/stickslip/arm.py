"""What the rest of a moving arm does to each of its joints, as columns of the joints' records.

A joint of an arm feels the weight of the links, Coriolis and centrifugal forces and the accelerations of the other joints,
and its inertia changes with the pose. With these two columns the diagnosis of that one joint holds while the whole arm moves:
`load_effort`, what acts on it beside the drive and its friction, positive in the direction of motion, and `inertia`.
"""
from __future__ import annotations

import io
import tempfile
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Mapping

from . import program, toml_text
from .program import StickslipError

if TYPE_CHECKING:
    import numpy
    import pandas

    InverseDynamics = Callable[[numpy.ndarray, numpy.ndarray, numpy.ndarray], numpy.ndarray]


def with_arm_load(records: Mapping[str, Any], robot: str | Path | None = None, *,
                  inverse_dynamics: "InverseDynamics | None" = None, armature: Mapping[str, float] | None = None,
                  at: Mapping[str, float] | None = None, window: float | None = None) -> "dict[str, pandas.DataFrame]":
    """The records of the joints of one log, each with the columns `load_effort`, `load_error` (N·m or N) and
    `inertia` (kg·m² or kg). `load_error` is an example of what `load_effort` is wrong by, from noise and smoothing: it counts as noise.

    `records` has a data frame for each joint that moves (columns time [s] and position [rad or m], the same rows in all), under its
    name in `robot`: a URDF or MJCF, whose dynamics the program computes; joints without a record stand still at the coordinates `at` (rad or m), or at their zero.

    Or `inverse_dynamics(q, dq, ddq)` gives the efforts [N·m or N] that hold the frictionless arm on that motion, arrays of one number
    for each joint in the order of `records`: with Pinocchio `lambda q, v, a: pinocchio.rnea(model, data, q, v, a)`; with MuJoCo a function that sets
    data.qpos, data.qvel and data.qacc, calls mujoco.mj_inverse(model, data) and returns data.qfrc_inverse + data.qfrc_passive
    (armature and friction loss of the model set to zero first).

    `armature` (kg·m² or kg) is what the description lacks beside the links, such as a rotor behind its gear: {"elbow": 0.12}.
    Velocities and accelerations are those of a cubic through `window` seconds of positions round each row
    (default: 0.03 s, or six rows, 0.1 s at most). Gravity is in
    load_effort: the joint's own load.gravity_amplitude has to be zero then. For a joint with backlash or a soft transmission the
    link's motion counts; where the log has only the motor's, loads are as wrong as that difference.

    Raises StickslipError for records that do not fit each other or the robot, TypeError unless exactly one of `robot` and
    `inverse_dynamics` is given.

    >>> records = {name: stickslip.read_log("run.mcap", joint=name) for name in ("shoulder", "elbow")}
    >>> records = stickslip.with_arm_load(records, "arm.urdf", armature={"elbow": 0.12})
    """
    from .records import as_frame

    if (robot is None) == (inverse_dynamics is None):
        given = "neither robot nor inverse_dynamics" if robot is None else "both robot and inverse_dynamics"
        raise TypeError(f"got {given}, expected one of them: a robot's description, or a function that gives efforts")
    if not isinstance(records, Mapping):
        raise TypeError(f"records: got {type(records).__name__}, expected a dict of one data frame for each joint, {{\"elbow\": frame}}")
    frames = {name: as_frame(name, record) for name, record in records.items()}
    if not frames:
        raise StickslipError("records: expected one data frame for each joint of the arm")
    unknown = [name for name in armature or {} if name not in frames]
    if unknown:
        raise StickslipError(f"armature: there is no record of {', '.join(unknown)}; records are {', '.join(frames)}")
    if inverse_dynamics is None:
        words: list[Any] = ["--robot", robot]
        for name, inertia in (armature or {}).items():
            words += ["--armature", f"{name}={float(inertia)!r}"]
        table = _arm_load(frames, window, words, at)
        columns = {name: tuple(table[f"{name}_{what}"].to_numpy() for what in ("load_effort", "load_error", "inertia")) for name in frames}
    else:
        table = _arm_load(frames, window, [], None)
        columns = _loads(table, inverse_dynamics, list(frames), armature or {})
    return {name: frame.assign(load_effort=columns[name][0], load_error=columns[name][1], inertia=columns[name][2])
            for name, frame in frames.items()}


def _column(name: str, frame: "pandas.DataFrame", column: str) -> "numpy.ndarray":
    from .records import numbers_of

    return numbers_of(name, frame, column).to_numpy(dtype=float)


def _arm_load(frames: "Mapping[str, pandas.DataFrame]", window: float | None, words: list[Any], at: Mapping[str, float] | None):
    """What the program makes of the joints' positions."""
    import numpy
    import pandas

    (first, *others) = frames.items()
    time = _column(*first, "time")
    for name, frame in others:
        if len(frame) != len(time) or not numpy.allclose(_column(name, frame, "time"), time, rtol=0, atol=1e-9):
            raise StickslipError(f"{name}: its rows are at other times than those of {first[0]}; expected the joints of one log")
    positions = {"time": time, **{name + "_position": _column(name, frame, "position") for name, frame in frames.items()}}
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        file = Path(folder) / "positions.csv"
        pandas.DataFrame(positions).to_csv(file, index=False)
        if at:
            pose = Path(folder) / "pose.toml"
            pose.write_text(toml_text.dumps(dict(at)), encoding="utf-8")
            words = [*words, "--at", pose]
        try:
            text = program.run(["arm-load", file, *(["--window", window] if window is not None else []), *words]).stdout
        except StickslipError as error:
            raise StickslipError(str(error).replace(str(file), "records")) from None
    return pandas.read_csv(io.StringIO(text), float_precision="round_trip")


def _loads(table: "pandas.DataFrame", inverse_dynamics: "InverseDynamics", names: list[str], armature: Mapping[str, float]):
    """As the program does it: the effort without the joint's own acceleration, turned round; the mass matrix' diagonal."""
    import numpy

    def motion(ending: str) -> "list[numpy.ndarray]":
        return [numpy.stack([table[f"{name}_{what}{ending}"].to_numpy() for name in names], axis=1)
                for what in ("position", "velocity", "acceleration")]

    (q, dq, ddq), again = motion(""), motion("_again")
    load, error, inertia = numpy.empty_like(q), numpy.empty_like(q), numpy.empty_like(q)
    still = numpy.zeros(len(names))

    def efforts(*motion: "numpy.ndarray") -> "numpy.ndarray":
        given = numpy.asarray(inverse_dynamics(*motion), dtype=float)
        if given.shape != still.shape:
            raise StickslipError(f"inverse_dynamics: gave {given.shape}, expected one effort for each of {', '.join(names)}")
        return given.copy()  # engines hand out their own memory

    for row in range(len(q)):
        held = efforts(q[row], still, still)
        for i, name in enumerate(names):
            unit, others, again_others = still.copy(), ddq[row].copy(), again[2][row].copy()
            unit[i], others[i], again_others[i] = 1, 0, 0
            inertia[row, i] = efforts(q[row], still, unit)[i] - held[i] + armature.get(name, 0.0)
            load[row, i] = -efforts(q[row], dq[row], others)[i]
            error[row, i] = -efforts(again[0][row], again[1][row], again_others)[i] - load[row, i]
            if not (numpy.isfinite(load[row, i]) and inertia[row, i] > 0):
                raise StickslipError(f"{name}: inverse_dynamics gives inertia {inertia[row, i]:g} and load {load[row, i]:g} in "
                                     f"row {row}, expected an inertia above 0 and a finite load")
    return {name: (load[:, i], error[:, i], inertia[:, i]) for i, name in enumerate(names)}
