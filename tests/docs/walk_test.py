#!/usr/bin/env python3
"""A page of docs/ as a reader walks it: its files, its commands in order, its output. Run: walk_test.py STICKSLIP docs/PAGE.md

Every line of a block after <!-- output --> has to stand in what the commands above it printed.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).parent.parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import docs  # noqa: E402

def plain(text):
    """Without the difference between a space and one that no line breaks at."""
    return text.replace("\u00a0", " ").replace("\u202f", " ").replace("\u2009", " ").splitlines()


program = pathlib.Path(sys.argv[1]).resolve()
environment = {**os.environ, "PATH": f"{program.parent}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}
said, commands, lines, missing = "", 0, 0, []
with tempfile.TemporaryDirectory() as folder:
    for kind, name, text in docs.blocks(ROOT / sys.argv[2]):
        if kind == "file":
            pathlib.Path(folder, name).write_text(text, encoding="utf-8")
        elif kind == "sh":
            done = subprocess.run(["sh", "-euc", text], cwd=folder, env=environment, capture_output=True, text=True)
            assert done.returncode == 0, f"{text}\n{done.stdout}{done.stderr}"
            said += done.stdout + done.stderr
            commands += sum(line.startswith("stickslip ") for line in text.splitlines())
        elif kind == "output":
            lines += len(text.splitlines())
            missing += [line for line in plain(text) if line not in plain(said)]
for line in missing:
    print("nowhere in the output:", line)
print(f"{commands} commands, {lines} lines of output, {len(missing)} of them not printed")
sys.exit(1 if missing or commands == 0 or lines < 10 else 0)
