"""Sealed cases as peers see them: the joint file and the records of a folder, and answers.json as `stickslip blind` writes it."""
import csv
import gzip
import json
import pathlib
import tomllib

import numpy as np


class Record:
    """Columns of one record as arrays; a column that was not logged is None."""

    def __init__(self, path):
        opened = gzip.open if path.suffix == ".gz" else open
        with opened(path, "rt", encoding="utf-8") as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))
        table = np.array([[float(cell) if cell else np.nan for cell in row] for row in rows[1:]])
        self.columns = {name.split("[")[0].strip(): table[:, i] for i, name in enumerate(rows[0])}
        self.time = self.columns["time"]

    def __getattr__(self, name):
        return self.__dict__.get("columns", {}).get(name)


class Joint:
    """The numbers of joint.toml that a plain model of one mass uses."""

    def __init__(self, path):
        text = tomllib.loads(path.read_text(encoding="utf-8"))
        joint, control, friction = text["joint"], text.get("control", {}), text.get("friction", {})
        actuator, sensor = text.get("actuator", {}), text.get("sensor", {})
        self.single = joint.get("model", "single-mass") == "single-mass" and actuator.get("kind", "effort") == "effort"
        self.inertia = joint.get("inertia", np.nan)
        self.gravity = text.get("load", {}).get("gravity_amplitude", 0.0)
        self.phase = text.get("load", {}).get("gravity_phase", 0.0)
        self.load = text.get("load", {}).get("constant", 0.0)
        self.coulomb = friction.get("coulomb", friction.get("c0", 0.0))
        self.viscous = friction.get("viscous", friction.get("c1", 0.0))
        self.k_p, self.k_v = control.get("k_p", np.nan), control.get("k_v", 0.0)
        self.period = control.get("period")
        self.tau = control.get("velocity_estimate", {}).get("tau", 0.0)
        self.with_rate = control.get("reference_velocity", False)
        self.limit = control.get("effort_limit", np.inf)
        self.gain = actuator.get("effort_gain", 1.0)
        self.noise = np.hypot(sensor.get("position_noise", 0.0), sensor.get("encoder_quantum", 0.0) / np.sqrt(12))
        self.effort_noise = sensor.get("effort_noise", 0.0)


def cases_of(folder):
    return sorted(p for p in pathlib.Path(folder).iterdir() if (p / "joint.toml").exists())


def read_case(folder):
    files = sorted(p for p in folder.iterdir() if p.name.endswith((".csv", ".csv.gz")))
    return Joint(folder / "joint.toml"), [Record(path) for path in files]


def answer(verdict, ranked=(), probabilities=(), before=None, after=None):
    return {"verdict": verdict, "effects": [list(names) for names in ranked], "probabilities": list(probabilities),
            "ambiguous_with": [], "gap_before": before, "gap_after": after}


def answer_all(folder, file, answer_case):
    """Answers every case of a folder; what cannot be answered says why."""
    answers = {}
    for case in cases_of(folder):
        try:
            answers[case.name] = answer_case(*read_case(case))
        except (ValueError, KeyError, TypeError, np.linalg.LinAlgError) as error:
            answers[case.name] = {**answer("failed"), "log": str(error)}
        first = answers[case.name]["effects"][:1]
        print(case.name, answers[case.name]["verdict"], *first, flush=True)
    pathlib.Path(file).write_text(json.dumps(answers, indent=2) + "\n", encoding="utf-8")
