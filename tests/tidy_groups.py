#!/usr/bin/env python3
"""clang-tidy over sources in groups: most of its time goes to the headers, which a group reads once.

    tests/tidy_groups.py COMMANDS FILE.cpp...      COMMANDS: a build folder with compile_commands.json

A group is the joined text of a few neighbours of one folder. Where their names clash, clang says so, and the group is
halved, down to single files. One thing can hide: a using-declaration that only a neighbour of the group needs.
"""
import concurrent.futures
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
AT_ONCE = 10  # sources a group: beyond it names clash more often than headers are spared


def flags_of(commands: pathlib.Path) -> dict[str, tuple[str, ...]]:
    """What each source is compiled with, without itself, its object and flags that only GCC knows."""
    flags = {}
    for entry in json.loads((commands / "compile_commands.json").read_text()):
        words = shlex.split(entry["command"])[1:]
        if "-o" in words:
            place = words.index("-o")
            del words[place : place + 2]
        flags.setdefault(entry["file"], tuple(w for w in words if w not in ("-c", "-Wno-restrict", entry["file"])))
    return flags


def joined(commands: pathlib.Path, group: list[str]) -> tuple[str, list[tuple[str, int]]]:
    """One source with the text of all, and for each of its lines the file and line that it came from."""
    text, places = "", []
    for f in group:
        lines = pathlib.Path(f).read_text().splitlines()
        text += "\n".join(lines) + "\n"
        places += [(f, number) for number in range(1, len(lines) + 1)]
    name = "_".join(os.path.relpath(f).replace("/", "_")[:-4] for f in (group[0], group[-1]))
    path = commands / f"{name}.cpp"
    path.write_text(text)
    return str(path), places


def tidy(commands: pathlib.Path, group: list[str], flags: tuple[str, ...]) -> str:
    """What is found in a group; empty where nothing is."""
    source, places = joined(commands, group)
    if len(group) > 1 and subprocess.run(["clang++-14", "-w", "-fsyntax-only", *flags, source], capture_output=True).returncode:
        half = len(group) // 2
        return tidy(commands, group[:half], flags) + tidy(commands, group[half:], flags)
    run = subprocess.run(["clang-tidy-14", "--quiet", f"--config-file={ROOT}/.clang-tidy", source, "--", *flags],
                         capture_output=True, text=True)
    if run.returncode == 0 and not run.stdout.strip():
        return ""
    here = re.compile(re.escape(source) + r":(\d+)")
    return here.sub(lambda m: "{}:{}".format(*places[int(m[1]) - 1]), run.stdout or run.stderr)


def main() -> int:
    commands = pathlib.Path(sys.argv[1]).resolve()
    files = [os.path.abspath(f) for f in sys.argv[2:]]
    flags = flags_of(commands)
    unknown = [f for f in files if f not in flags]
    if unknown:
        print(f"no compile command for {unknown[0]}", file=sys.stderr)
        return 2
    rooms: dict[tuple, list[str]] = {}
    for f in files:
        rooms.setdefault((os.path.dirname(f), flags[f]), []).append(f)
    groups = [(room[i : i + AT_ONCE], key[1]) for key, room in rooms.items() for i in range(0, len(room), AT_ONCE)]
    found = 0
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for done, text in enumerate(pool.map(lambda g: tidy(commands, *g), groups), 1):
            found += bool(text)
            print(text, end="" if text.endswith("\n") or not text else "\n", flush=True)
            if sys.stderr.isatty():
                print(f"\r{done} of {len(groups)} groups", end="", file=sys.stderr, flush=True)
    print(f"{len(files)} sources in {len(groups)} groups: " + (f"{found} with findings" if found else "nothing found"))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
