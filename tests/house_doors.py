"""The doors of the house: headers that other folders may include. Every other header is its folder's own.

tests/house_doors.toml lists the doors folder by folder; `python3 tests/house.py --doors` prints what it says today. A
header that another folder includes for the first time becomes a door there, or is not included.
"""
import tomllib
from collections import defaultdict

LIST = "tests/house_doors.toml"
HEAD = """# Headers that other folders include, by the folder they lie in: its doors. All others are the folder's own (house_doors.py).
"""


def used_from_outside(files, includes):
    """Every header that a file outside its folder and the folders within includes, with one such file."""
    headers = {path.as_posix(): path for path in files if path.suffix == ".h"}
    used = {}
    for path in files:
        for name in includes(path):
            if name in headers and not path.is_relative_to(headers[name].parent):
                used.setdefault(name, path)
    return used


def text(used):
    doors = defaultdict(list)
    for name in used:
        folder, _, header = name.rpartition("/")
        doors[folder].append(header)
    lines = [HEAD]
    for folder in sorted(doors):
        lines.append(f'"{folder}" = [')
        lines += [f'  "{header}",' for header in sorted(doors[folder])]
        lines.append("]")
    return "\n".join(lines)


def complaints(source, files, includes):
    """Of headers that are included and no doors, and of doors that nobody uses any more. None without a list."""
    if not (source / LIST).exists():
        return
    listed = tomllib.loads((source / LIST).read_text(encoding="utf-8"))
    doors = {f"{folder}/{header}" for folder, headers in listed.items() for header in headers}
    used = used_from_outside(files, includes)
    for name in sorted(set(used) - doors):
        yield f"{used[name]}: includes {name}, which is no door of its folder ({LIST})"
    for name in sorted(doors - set(used)):
        yield f"{LIST}: {name} is a door that no other folder uses"
