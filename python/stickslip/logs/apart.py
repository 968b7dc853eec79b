"""A compiled reader in a process of its own: what a damaged file does to it does not end the caller's.

SciPy's reader of MATLAB 5 files, for one, dies of some damaged ones."""
from __future__ import annotations

import importlib
import pickle
import subprocess
import sys
from pathlib import Path
from typing import Any

from ..program import StickslipError


def read_apart(reader: str, path: Path, **options: Any) -> Any:
    """What `reader`, as "module:function", makes of the file. Throws StickslipError with what it says where it fails."""
    package = str(Path(__file__).resolve().parents[2])
    program = f"import sys; sys.path.insert(0, {package!r}); from stickslip.logs.apart import _answer; _answer()"
    done = subprocess.run([sys.executable, "-c", program], input=pickle.dumps((reader, str(path), options)), capture_output=True)
    if done.returncode < 0:
        raise StickslipError(f"{path}: is damaged: the reader of such files died of it")
    if done.returncode:
        raise StickslipError(f"{path}: is damaged or of another kind than its suffix says: "
                             f"{done.stderr.decode(errors='replace').strip().splitlines()[-1]}")
    return pickle.loads(done.stdout)


def _answer() -> None:
    reader, path, options = pickle.load(sys.stdin.buffer)
    module, _, function = reader.partition(":")
    value = getattr(importlib.import_module(module), function)(path, **options)
    sys.stdout.buffer.write(pickle.dumps(value))
