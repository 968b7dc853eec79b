"""The annotations are those of the code, and an editor sees wrong arguments; where mypy is installed."""
import importlib.util
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parents[2] / "python" / "stickslip"


def test_annotations_agree_with_the_code_and_wrong_arguments_are_seen(tmp_path):
    if not importlib.util.find_spec("mypy"):
        pytest.skip("mypy is not installed")
    user = tmp_path / "user.py"
    user.write_text("import stickslip\njoint = stickslip.Joint.example()\njoint.save(3)\nstickslip.evaluate(5)\n"
                    "stickslip.boundary(joint, along=3)\nstickslip.evaluate(joint).at('nonlinear.outcome')\n")
    words = ["--ignore-missing-imports", "--cache-dir", str(tmp_path / "cache"), str(PACKAGE), str(user)]
    run = subprocess.run([sys.executable, "-m", "mypy", *words], capture_output=True, text=True, cwd=PACKAGE.parent)
    errors = [line.split(":")[:2] for line in run.stdout.splitlines() if ": error: " in line]
    assert errors == [[str(user), line] for line in ("3", "4", "5")], run.stdout
