"""One function a verb of the program. Each takes a Joint, a file, TOML text or a dict.

Numbers are SI: a revolute joint has rad, N·m, kg·m² where a prismatic one has m, N, kg. `settings` changes keys of the joint first,
{"control.k_p": 2e4} or {"control.V0": "10 deg/s"}. All of them raise StickslipError for input that the program refuses (file, line,
got, expected), TypeError for an argument of another kind, and Interrupted where the program was stopped.
"""
from __future__ import annotations

import json
import re
import tempfile
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, Iterator, Mapping, Sequence, Union

from . import program, toml_text
from .answers import Answer
from .joint import Joint

if TYPE_CHECKING:
    import pandas
    import xarray

JointLike = Union[Joint, str, Path, Mapping[str, Any]]
SpecLike = Union[str, Path, Mapping[str, Any]]


@contextmanager
def _called(file: Path, name: str) -> Iterator[Path]:
    """Errors about a file that was made for the program name what it was made of."""
    try:
        yield file
    except program.StickslipError as error:
        raise type(error)(str(error).replace(str(file), name)) from None


@contextmanager
def _input(given: JointLike | SpecLike) -> Iterator[Path]:
    """A file that the program can read. Text with a line break is TOML, other text a path."""
    if isinstance(given, Joint):
        with given.as_file() as file, _called(file, "joint"):
            yield file
    elif isinstance(given, Mapping) or (isinstance(given, str) and "\n" in given):
        with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
            file = Path(folder) / "input.toml"
            file.write_text(given if isinstance(given, str) else toml_text.dumps(_from_here(given)), encoding="utf-8")
            with _called(file, "input"):
                yield file
    elif isinstance(given, (str, Path)):
        yield Path(given)
    else:
        raise TypeError(f"joint: got {type(given).__name__}, expected a Joint, a file, TOML text or a dict")


def _from_here(tables: Mapping[str, Any]) -> Mapping[str, Any]:
    """Files that the tables name are looked up from the working directory: there is no file that they could be beside."""
    found = dict(tables)
    joint, friction, robot = tables.get("joint"), tables.get("friction"), tables.get("robot")
    if isinstance(joint, str):
        found["joint"] = str(Path(joint).absolute())
    if isinstance(friction, Mapping) and isinstance(friction.get("table"), str):
        found["friction"] = {**friction, "table": str(Path(friction["table"]).absolute())}
    if isinstance(robot, Mapping) and isinstance(robot.get("file"), (str, Path)):
        found["robot"] = {**robot, "file": str(Path(robot["file"]).absolute())}
    return found


def _mapping(name: str, given: Any, example: str) -> Mapping[str, Any]:
    if given is None:
        return {}
    if not isinstance(given, Mapping):
        raise TypeError(f"{name}: got {type(given).__name__}, expected a dict such as {example}")
    return given


def _options(options: Mapping[str, Any]) -> list[Any]:
    """Of the command line, named with underscores: True is a flag, a list several values, None and False leave the default."""
    words: list[Any] = []
    for name, value in options.items():
        if value is None or value is False:
            continue
        values = [] if value is True else list(value) if isinstance(value, (list, tuple)) else [value]
        words += ["--" + name.replace("_", "-"), *values]
    return words


def _records(given: Any) -> Mapping[str, Any]:
    """At least one."""
    if not isinstance(given, Mapping) or not given:
        got = "an empty dict" if isinstance(given, Mapping) else type(given).__name__
        raise TypeError(f"records: got {got}, expected a dict of at least one data frame, {{\"run1\": frame}}")
    return given


def _settings(settings: Mapping[str, Any] | None) -> list[str]:
    words: list[str] = []
    for path, value in _mapping("settings", settings, '{"control.k_p": 2e4}').items():
        words += ["--set", f"{path}={value if isinstance(value, str) else toml_text._value(value, path)}"]
    return words


def evaluate(joint: JointLike, settings: Mapping[str, Any] | None = None) -> Answer:
    """Both linear theories, critical gains, spectrum and the nonlinear outcome of one joint.

    evaluate(joint, {"control.k_p": 2e4}): answer.at("nonlinear.outcome") is "stable-sliding", "stick-slip", …;
    answer.at("linear.state_variable.k_cr") the critical gain [N/m or N·m/rad] or None; "….spectral_abscissa" in 1/s,
    "….eigenvalues" pairs of real and imaginary part [1/s]. Fields and units: docs/reference.md, `stickslip evaluate JOINT --json`.
    """
    with _input(joint) as file:
        return Answer(program.answer_of(["evaluate", file, *_settings(settings)]))


def sweep(spec: SpecLike, directory: str | Path | None = None, report: bool = False, threads: int = 0) -> "xarray.Dataset":
    """Computes every point of a sweep. The dataset has the axes of the spec as coordinates, and every variable (spectral_abscissa [1/s],
    k_cr, outcome, …) has their shape; dataset[name].attrs["units"] is its unit. `threads` 0 uses all cores.

    In a `directory` the results stay (results.nc; with `report` the page, too), and an interrupted sweep goes on when it
    is called again. Without one they live in memory alone.
    """
    import xarray

    with _input(spec) as file, tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        folder = Path(directory) if directory else Path(temporary) / "sweep"
        command: list[Any] = ["sweep", file, "-o", folder, "--threads", threads]
        answer = program.answer_of(command if report else [*command, "--no-report"])
        with xarray.open_dataset(answer["results"]) as dataset:
            loaded = dataset.load()
    loaded.attrs["undecided_points"] = answer["undecided"]
    if answer.get("report"):
        loaded.attrs["report"] = answer["report"]
    return loaded


def simulate(joint: JointLike, settings: Mapping[str, Any] | None = None, reference: Any = None, **options: Any) -> "pandas.DataFrame":
    """One motion from a disturbance on: a row each time step, columns time [s], excess_position [m or rad], velocity [m/s or rad/s],
    friction [N or N·m], stuck (0 or 1).

    With a `reference` (data frame or CSV with time and reference_position) the joint follows it in its sampled loop, and
    the frame is the record that its controller would have logged, ready for `diagnose`, in SI units and those of the drive. Options
    are those of the command line with underscores, in SI: simulate(joint, disturbance="velocity", size=1e-3, duration=2.0). Units of the columns
    stand in `frame.attrs["units"]`, how a motion ends in `frame.attrs["verdict"]`.
    """
    import pandas

    from .records import told_of_records, write_record

    words: list[Any] = []
    words += _options(options)
    with _input(joint) as file, tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        folder = Path(temporary) / "motion"
        if reference is not None:
            words += ["--reference", write_record("reference", reference, Path(temporary), {})]
        with told_of_records(temporary):
            run = program.run(["simulate", file, "-o", folder, *_settings(settings), *words])
        table = folder / ("record.csv" if reference is not None else "trajectory.csv")
        if not table.exists():
            raise program.StickslipError(run.stdout.strip() or run.stderr.strip())
        frame = pandas.read_csv(table)
        said = json.loads((folder / "motion.json").read_text(encoding="utf-8"))["units"]
    frame.columns = [column.partition(" [")[0] for column in frame.columns]
    frame.attrs["units"] = {column: said[_quantity(column)] for column in frame.columns if column != "stuck"}
    if reference is None:
        frame.attrs["verdict"] = run.stdout.splitlines()[0] if run.stdout else ""
    return frame


def _quantity(column: str) -> str:
    """What a column of a motion or record holds."""
    if column in ("effort_command", "feed_forward"):
        return "command"
    kind = column.rsplit("_", 1)[-1]
    return kind if kind in ("time", "position", "velocity") else "effort"


def boundary(joint: JointLike | SpecLike, along: str | Sequence[str] = (), over: Sequence[str] = (),
             kind: str | Sequence[str] = (), settings: Mapping[str, Any] | None = None, **options: Any) -> Answer:
    """Located boundaries along an axis ("control.k_p=1e3..1e6", numbers in SI or with a unit) or over two of them.

    `kind` is linear, velocity-only, fold, outcome, hunting, or several of them. Along an axis answer["lines"] has points, each with a
    value in the unit of the axis; over two, answer["curves"] has pieces of points {"x", "y"}, which plot_boundary draws. Options are those
    of the command line with underscores.
    """
    words: list[Any] = []
    for name, given in (("along", along), ("over", over), ("kind", kind)):
        values = [given] if isinstance(given, str) else list(given)
        if values:
            words += ["--" + name, *values]
    words += _options(options)
    with _input(joint) as file:
        return Answer(program.answer_of(["boundary", file, *words, *_settings(settings)]))


def margins(joint: JointLike, uncertain: Mapping[str, Any] | None = None, settings: Mapping[str, Any] | None = None,
            **options: Any) -> Answer:
    """How far a design is from its boundaries; `uncertain` gives shares: {"friction.L": "20%"} or {"friction.L": 0.2}.

    answer["alone"] lists every parameter with its boundary, in its SI unit, where it changes alone; answer["nearest"] is the nearest boundary
    where all change together, with moves as shares. Options are those of the command line: margins(joint, effort=0.3).
    """
    words: list[Any] = _options(options)
    for path, share in _mapping("uncertain", uncertain, '{"friction.L": "20%"}').items():
        words += ["--uncertain", f"{path}={share}"]
    with _input(joint) as file:
        return Answer(program.answer_of(["margins", file, *words, *_settings(settings)]))


def design(joint: JointLike | SpecLike, require: Mapping[str, Any] | None = None, settings: Mapping[str, Any] | None = None,
           **options: Any) -> Answer:
    """Best k_p and k_v under requirements: design(joint, {"position_noise": "1 um", "margin": 0.2}), numbers in SI or text with a unit.

    answer["feasible"] says whether any gains do; gains are in N/m and N·s/m, of a revolute joint in N·m/rad and N·m·s/rad.
    Options are those of the command line: design(joint, {…}, effort=0.3).
    """
    words: list[Any] = _options(options)
    for key, value in _mapping("require", require, '{"position_noise": "1 um"}').items():
        words += ["--require", f"{key}={value}"]
    with _input(joint) as file:
        return Answer(program.answer_of(["design", file, *words, *_settings(settings)]))


def diagnose(joint: JointLike, records: Mapping[str, Any], directory: str | Path | None = None, report: bool = False,
             threads: int = 0, log: Mapping[str, Any] | None = None) -> Answer:
    """Where the gap between a joint and its records lies and what causes it.

    `records` names them: pandas data frames, dicts of columns, CSV files or logs (`log` has the options of read_log:
    {"joint": "elbow"}). Columns are those of a record: time, reference_position,
    position, velocity, effort_command, effort_measured, …, in SI units unless the joint's [record] table gives others.
    With a `directory`, diagnosis.json, the page (`report`) and the next experiment stay there. answer["verdict"] is gap, no-gap, unknown or
    insufficient-data; answer["effects"] the causes, the likeliest first, each with names, probability and parameters (value, standard error
    and unit). Fields: docs/reference.md, `stickslip diagnose … --json`.
    """
    from .records import told_of_records, write_record

    records = _records(records)
    with _input(joint) as file, tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        files = [write_record(name, record, Path(temporary), log or {}) for name, record in records.items()]
        folder = Path(directory) if directory else Path(temporary) / "diagnosis"
        folder.mkdir(parents=True, exist_ok=True)
        command: list[Any] = ["diagnose", file, *files, "-o", folder, "--threads", threads]
        with told_of_records(temporary):
            return Answer(program.answer_of(command if report else [*command, "--no-report"]))


def diagnose_robot(robot: str | Path | Mapping[str, JointLike], logs: Any, directory: str | Path | None = None, report: bool = False,
                   threads: int = 0, joints: Sequence[str] = (), log: Mapping[str, Any] | None = None) -> Answer:
    """Every joint of a robot from the same logs: robot.json, with what each joint's gap comes from.

    `robot` is a robot.toml, a folder of joint files, or a dict from the joints' names in the logs to joints. `logs` is a file or
    a list of files: tables with columns such as elbow_position, or whatever read_log reads (`log` has its options: topic, command,
    time, episode); or a data frame of such columns. A joint that cannot be diagnosed does not stop the others:
    answer["joints"][i]["status"] is "refused" then, and its "problems" say why. With a `directory` the answers and, with `report`,
    the pages of robot and joints stay there.
    """
    import pandas

    from .records import as_frame, write_csv

    with tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        if isinstance(robot, Mapping):
            robot = _robot_file(robot, Path(temporary))
        given = [logs] if isinstance(logs, (str, Path, Mapping, pandas.DataFrame)) else list(logs)
        files: list[Any] = []
        for number, one in enumerate(given):
            if isinstance(one, (Mapping, pandas.DataFrame)):
                files.append(Path(temporary) / f"log-{number + 1}.csv")
                write_csv(as_frame(f"log {number + 1}", one), files[-1])
            else:
                files.append(one)
        folder = Path(directory) if directory else Path(temporary) / "diagnosis"
        command: list[Any] = ["diagnose", robot, *files, "--all-joints", "-o", folder, "--threads", threads]
        for name in joints:
            command += ["--joint", name]
        for key, value in (log or {}).items():
            command += ["--" + key.replace("_", "-"), value]
        if not report:
            command.append("--no-report")
        # 2 may mean that some joints were refused and the others answered; without an answer it is an error
        run = program.run([*command, "--json"], allowed=(program.DONE, program.BAD_INPUT, program.UNDECIDED))
        if not run.stdout.strip():
            raise program.StickslipError(run.stderr.strip().replace(temporary + "/", ""))
        return Answer(json.loads(run.stdout.replace(temporary + "/", "")))


def _robot_file(robot: Mapping[str, JointLike], folder: Path) -> Path:
    """robot.toml for joints of Python; a name that is no name of a folder is only the one in the logs."""
    table: dict[str, Any] = {}
    for number, (name, joint) in enumerate(robot.items()):
        with _input(joint) as file:
            own = folder / f"joint-{number + 1}.toml"
            own.write_text(Path(file).read_text(encoding="utf-8"), encoding="utf-8")
        table[re.sub(r"[^\w.+-]+", "-", name).lstrip(".")] = {"file": str(own), "name": name}
    path = folder / "robot.toml"
    path.write_text(toml_text.dumps({"joints": table}), encoding="utf-8")
    return path


def export(joint: JointLike, to: str, name: str = "joint", settings: Mapping[str, Any] | None = None,
           records: Mapping[str, Any] | None = None, log: Mapping[str, Any] | None = None, **options: Any) -> Answer:
    """Elements of a simulator (mjcf, urdf, sdf, isaaclab, ros2_control) as answer["text"], and what they cannot say.

    With held-out `records`, as `diagnose` takes them, answer["gap_left"] is what the text leaves of the gap there, in noise
    floors; answer["gap"] has it signal by signal, beside what the joint itself leaves. answer["numbers"] are the exported ones at the
    joint's side of the gear, in SI; answer["not_expressible"] lists the keys that the target cannot have. Options are those of the command
    line: timestep [s], link_inertia [kg·m² or kg], speed [rad/s or m/s].
    """
    from .records import told_of_records, write_record

    words: list[Any] = []
    words += _options(options)
    with _input(joint) as file, tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        files = [write_record(key, record, Path(temporary), log or {}) for key, record in (records or {}).items()]
        if files:
            words += ["--records", *files]
        with told_of_records(temporary):
            return Answer(program.answer_of(["export", file, "--to", to, "--name", name, *words, *_settings(settings)]))


def import_robot(robot: str | Path, joint: str, at: Mapping[str, float] | None = None,
                 settings: Mapping[str, Any] | None = None) -> Joint:
    """The joint of a URDF or MJCF at the pose `at` ({"shoulder": 0.5}, rad or m; other joints at zero), with reflected inertia
    [kg·m² or kg] and gravity [N·m or N]. Gains that the robot's description does not have come from `settings`, in N·m/rad or N/m:
    import_robot("arm.urdf", "elbow", settings={"control.k_p": 200}). Raises StickslipError where one is missing, with its name.
    """
    with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
        words: list[Any] = []
        if at:
            pose = Path(folder) / "pose.toml"
            pose.write_text(toml_text.dumps(dict(_mapping("at", at, '{"shoulder": 0.5}'))), encoding="utf-8")
            words = ["--at", pose]
        answer = program.answer_of(["import", robot, "--joint", joint, *words, *_settings(settings)])
    if answer["missing"]:
        wanted = ", ".join(f'"{path}": …' for path in answer["missing"])
        raise program.StickslipError(f"{robot}: says nothing of {', '.join(answer['missing'])} of joint {joint!r}; expected "
                                     f"settings={{{wanted}}}")
    return Joint(answer["text"])


def read_answer(file: str | Path) -> Answer:
    """An answer that the program wrote: diagnosis.json, boundary.json, … Raises StickslipError for a file that is no JSON answer."""
    path = Path(file)
    if not path.is_file():
        raise program.StickslipError(f"{path}: {'is a folder, expected a file such as diagnosis.json' if path.is_dir() else 'there is no such file'}")
    try:
        answer = json.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:
        raise program.StickslipError(f"{path}: is no JSON: {error}") from None
    if not isinstance(answer, dict):
        raise program.StickslipError(f"{path}: got a JSON {type(answer).__name__}, expected an answer of the program")
    return Answer(answer)


def check_gap(joint: JointLike, records: Mapping[str, Any], baseline: str | Path, update: bool = False, threads: int = 0,
              directory: str | Path | None = None, **tolerances: float) -> Answer:
    """Whether the gap of a joint to its records is worse than in a baseline: answer["passes"], answer["regressions"].

    `records` are those of `diagnose`. `update` writes the baseline instead and returns it. Tolerances are shares: gap_tolerance=0.1,
    number_tolerance=0.05.
    """
    from .records import told_of_records, write_record

    records = _records(records)
    words: list[Any] = ["--threads", threads, *_options(tolerances)]
    if directory:
        words += ["-o", directory]
    with _input(joint) as file, tempfile.TemporaryDirectory(prefix="stickslip-") as temporary:
        files = [write_record(name, record, Path(temporary), {}) for name, record in records.items()]
        with told_of_records(temporary):
            if update:
                program.run(["check", file, *files, baseline, "--update", *words])
                return read_answer(baseline)
            return Answer(program.answer_of(["check", file, *files, baseline, *words]))


def compare(before: str | Path, after: str | Path) -> Answer:
    """Two diagnoses (folders that diagnose wrote, or diagnosis.json): is the gap new, which parameter moved, and by how many standard errors."""
    return Answer(program.answer_of(["compare", before, after]))


def timeline(runs: str | Path | Sequence[str | Path], directory: str | Path, joint: str | None = None, report: bool = True) -> Answer:
    """The diagnoses of a joint in the order of the dates in their folders' names, with a page in `directory`."""
    given = [runs] if isinstance(runs, (str, Path)) else list(runs)
    words: list[Any] = ["--joint", joint] if joint else []
    return Answer(program.answer_of(["timeline", *given, "-o", directory, *words, *([] if report else ["--no-report"])]))
