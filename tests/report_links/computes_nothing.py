#!/usr/bin/env python3
"""Pages, sentences and JSON are made from answers: no object of these rooms calls what computes one.
Run: computes_nothing.py BUILD_FOLDER

What computes: the rooms of analysis/ below, and each file of sweep/study that calls them, or that calls such a file.
"""
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path

DRAWS = ("report/", "words/", "files/json/")
COMPUTES = ("boundary/", "design/", "diagnosis/", "loop/", "numerics/", "simulation/", "stability/", "friction/")
# Of these rooms, what reads a joint and solves nothing.
READS = {
    "boundary/trace/coordinates": "the value of a key, or of a group of keys",
    "loop/loop_use": "which loop a joint has, and which of its keys that loop uses",
    "stability/effort_limits": "a limit of the joint compared with its friction",
    "stability/warming": "what drift adds to the friction of a joint",
    "stability/linear_joint::chain_of": "which bodies and springs a joint has",
}


def symbols(build, floor):
    """For each object, by its path without folders of CMake: what it defines and what it takes from others."""
    for path in sorted((build / floor).rglob("*.o")):
        inside = re.search(r"\.dir/(.+)\.cpp\.o$", path.as_posix())
        if not inside or "/build-" in path.as_posix():
            continue
        said = subprocess.run(["nm", "-C", path], check=True, capture_output=True, text=True).stdout
        defined = set(re.findall(r"^[0-9a-f]+ [TVW] (stickslip::.+)$", said, re.MULTILINE))
        yield inside.group(1), defined, set(re.findall(r"^ +U (stickslip::.+)$", said, re.MULTILINE))


def reads(room, symbol):
    return room in READS or any(key.startswith(room + "::") and f"::{key.split('::')[1]}(" in symbol for key in READS)


def main():
    build = Path(sys.argv[1])
    home = {}
    for room, defined, _ in symbols(build, "analysis"):
        home.update((symbol, room) for symbol in defined if room.startswith(COMPUTES) and not reads(room, symbol))
    objects = list(symbols(build, "sweep"))
    of_study = {symbol: room for room, defined, _ in objects if room.startswith("study/") for symbol in defined}
    calls = defaultdict(set)
    computing = set()
    for room, defined, taken in objects:
        if room.startswith("study/"):
            calls[room] = {of_study[symbol] for symbol in taken if symbol in of_study}
            if taken & home.keys():
                computing.add(room)
    while more := {room for room in calls if room not in computing and calls[room] & computing}:
        computing |= more
    found, drawn = [], 0
    for room, _, taken in objects:
        if not room.startswith(DRAWS):
            continue
        drawn += 1
        found += [f"sweep/{room}: calls {symbol} of analysis/{home[symbol]}" for symbol in sorted(taken & home.keys())]
        found += [f"sweep/{room}: calls {symbol} of sweep/{of_study[symbol]}, which computes"
                  for symbol in sorted(taken) if of_study.get(symbol) in computing]
    for line in found:
        print(line)
    if drawn < 50 or not home or not computing:
        sys.exit("objects are missing: nothing was tested")
    return 1 if found else 0


sys.exit(main())
