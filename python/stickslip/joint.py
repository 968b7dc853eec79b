"""A joint: what `joint.toml` describes. SI units; revolute joints read rad, N·m, kg·m² where prismatic ones read m, N, kg."""
from __future__ import annotations

import tempfile
from contextlib import contextmanager
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any, Iterator, Mapping

from . import program, toml_text


@dataclass(frozen=True)
class Key:
    """One key of a joint, as `Joint.keys()` lists it.

    path     as in the file: "control.k_p"
    value    number in `unit`, word, true or false, list of numbers (friction.B of several states); None: not stated
    unit     SI, of this joint's motion: "N·m/rad" of a revolute joint where a prismatic one has "N/m"; "1" for plain numbers and words
    default  as text, in `unit`; "required" where the joint must state it, "-" where there is none
    allowed  permitted values as text: "at least 0", "true, false", …
    help     meaning
    """

    path: str
    value: float | str | bool | list[float] | None
    unit: str
    default: str
    allowed: str
    help: str


def _typed(entry: Mapping[str, str]) -> float | str | bool | list[float] | None:
    text = entry["value"]
    if text in ("true", "false") and entry["allowed"] == "true, false":
        return text == "true"
    if text.startswith("["):
        return [float(v) for v in text[1:-1].split(",")]
    try:
        return float(text)
    except ValueError:
        return text or None


class Joint:
    """A joint that the program has read and found complete.

    >>> joint = Joint.example("two-mass", law="stribeck", motion="revolute")
    >>> joint["control.k_p"] = 300
    >>> joint["control.V0"] = "10 deg/s"

    A path is that of the file: "control.k_p", "friction.motor.c0", "friction.B.1". Values are SI numbers, text with a
    unit, words or lists. What does not fit raises StickslipError and leaves the joint as it was.

    The keys that most joints have, with units of a prismatic and of a revolute joint (`keys()` has all, docs/reference.md explains them):

    joint.inertia                     kg       kg·m²      one mass
    joint.motor_inertia               kg       kg·m²      two masses; at the motor's shaft
    joint.link_inertia                kg       kg·m²      two masses
    joint.transmission.stiffness      N/m      N·m/rad    two masses; at the joint's side of the gear, as damping and backlash
    joint.transmission.damping        N·s/m    N·m·s/rad
    joint.transmission.backlash       m        rad
    joint.transmission.ratio          1        1          motor motion per joint motion
    load.constant                     N        N·m
    load.gravity_amplitude            N        N·m        m g l of a pendulum
    load.gravity_phase                rad      rad
    control.k_p                       N/m      N·m/rad    drive signal per position error
    control.k_v                       N·s/m    N·m·s/rad  drive signal per velocity error
    control.k_i                       N/(m·s)  N·m/(rad·s)
    control.V0                        m/s      rad/s      commanded velocity
    control.period                    s        s          of a sampled loop
    control.delay                     s        s          dead time behind the command
    control.effort_limit              N        N·m
    actuator.effort_gain              N        N·m        per unit of the drive signal
    actuator.lag                      s        s
    sensor.encoder_quantum            m        rad
    sensor.position_noise             m        rad        standard deviation
    friction.law                      1        1          its numbers, here of coulomb-viscous; of two masses friction.motor, friction.link
    friction.coulomb                  N        N·m
    friction.viscous                  N·s/m    N·m·s/rad
    """

    def __init__(self, text: str, folder: str | Path | None = None):
        """From the TOML text of a joint file; files that it names (a kernel table) are looked up from `folder`.

        Raises StickslipError, with line, what it got and what it expected, for a text that is no complete joint.
        """
        if not isinstance(text, str):
            raise TypeError(f"text: got {type(text).__name__}, expected the TOML text of a joint; Joint.from_dict takes a dict, "
                            "Joint.from_file a path")
        self._folder = Path(folder) if folder else None
        self._text = self._normal(text, {})
        self._keys: list[Key] | None = None

    @classmethod
    def from_file(cls, file: str | Path) -> Joint:
        """Reads joint.toml, or the design point of a sweep's spec. Raises StickslipError with file, line, got and expected."""
        path = Path(file)
        if not path.exists():
            raise program.StickslipError(f"{path}: there is no such file")
        plain = program.run(["new", "joint", "--from", path, "--plain"]).stdout
        return cls(plain, path.parent)

    @classmethod
    def from_dict(cls, tables: Mapping[str, Any]) -> Joint:
        """{"joint": {"inertia": 1.0, …}, "control": {…}, "friction": {…}}: the tables of the file, numbers in SI or text with a unit.

        Raises StickslipError for what is no complete joint, TypeError for a value that TOML has not.
        """
        if not isinstance(tables, Mapping):
            raise TypeError(f"tables: got {type(tables).__name__}, expected a dict such as {{\"joint\": {{\"inertia\": 1.0}}, …}}")
        return cls(toml_text.dumps(tables))

    @classmethod
    def example(cls, model: str = "single-mass", law: str = "rate-and-state", motion: str = "prismatic") -> Joint:
        """A joint to begin with, as `stickslip new joint` writes it.

        `model` is single-mass, two-mass, three-mass or lever; `law` one of `stickslip list laws`; `motion` prismatic (m, N, kg)
        or revolute (rad, N·m, kg·m²). Raises StickslipError for another word, with those that it takes.
        """
        return cls(program.run(["new", "joint", "--model", model, "--law", law, "--motion", motion, "--plain"]).stdout)

    def to_toml(self) -> str:
        """The joint as joint.toml: what differs from its default, with units in comments."""
        return self._text

    def save(self, file: str | Path) -> None:
        """Writes `to_toml()` to a file. Raises OSError where it cannot be written."""
        Path(file).write_text(self._text, encoding="utf-8")

    def keys(self) -> list[Key]:
        """Every key with value, unit, default, what it takes and what it means."""
        if self._keys is None:
            with self.as_file() as file:
                listed = program.answer_of(["list", "keys", "--joint", file])["entries"]
            self._keys = [Key(e["path"], _typed(e), e["unit"], e["default"], e["allowed"], e["help"]) for e in listed]
        return list(self._keys)

    def __getitem__(self, path: str) -> float | str | bool | list[float] | None:
        """The value of a key, a number in the unit that `keys()` lists (SI); None: not stated. Raises KeyError for an unknown key."""
        for key in self.keys():
            if key.path == path:
                return key.value
        raise KeyError(f"{path}: there is no such key; keys are {', '.join(k.path for k in self.keys())}")

    def __setitem__(self, path: str, value: Any) -> None:
        """Sets a key to an SI number, text with a unit ("10 deg/s"), a word or a list. Raises StickslipError for what does not fit."""
        self._text, self._keys = self._normal(self._text, {path: value}), None

    def changed(self, settings: Mapping[str, Any] | None = None, **by_name: Any) -> Joint:
        """A copy with some keys changed together: joint.changed({"control.k_p": 2e4, "control.k_v": 30}), in N/m and N·s/m (SI).

        Raises StickslipError for what does not fit.
        """
        other = object.__new__(Joint)
        other._folder, other._keys = self._folder, None
        other._text = self._normal(self._text, {**(settings or {}), **by_name})
        return other

    @contextmanager
    def as_file(self) -> Iterator[Path]:
        """joint.toml for as long as the block lasts, beside the files that the joint names."""
        with self._temporary(self._text) as file:
            yield file

    @contextmanager
    def _temporary(self, text: str) -> Iterator[Path]:
        with tempfile.TemporaryDirectory(prefix="stickslip-") as folder:
            if self._folder:
                for other in self._folder.glob("*.csv"):
                    (Path(folder) / other.name).symlink_to(other.resolve())
            file = Path(folder) / "joint.toml"
            file.write_text(text, encoding="utf-8")
            yield file

    def _normal(self, text: str, settings: Mapping[str, Any]) -> str:
        command: list[Any] = ["new", "joint", "--plain"]
        for path, value in settings.items():
            command += ["--set", f"{path}={value if isinstance(value, str) else toml_text._value(value, path)}"]
        with self._temporary(text) as file:
            try:
                return program.run([*command, "--from", file]).stdout
            except program.StickslipError as error:
                raise program.StickslipError(str(error).replace(str(file), "joint")) from None

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Joint) and self._text == other._text

    def __repr__(self) -> str:
        return f"Joint({self._text!r})"

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td style='text-align:left'>{escape(k.path)}</td><td>{escape(str(k.value))}</td>"
                       f"<td>{'' if k.unit == '1' else escape(k.unit)}</td><td style='text-align:left'>{escape(k.help)}</td></tr>"
                       for k in self.keys()
                       if k.value is not None and k.value != _typed({"value": k.default, "allowed": k.allowed}))
        return f"<table><tr><th>key</th><th>value</th><th>unit</th><th>meaning</th></tr>{rows}</table>"
