"""What the project states about itself: licences (REUSE.toml, LICENSES) and version (version.h, CITATION.cff, CHANGELOG.md).

Debian's reuse 1.1 is older than REUSE.toml (REUSE 3.2), so that the rules that hold for this tree are checked here: every file has
a holder and a licence, every licence has its text, every text is of a licence that a file has, every path that is named is there.
"""
import re
import tomllib

RIGHTS = ("SPDX-FileCopyrightText", "SPDX-License-Identifier")
VERSIONS = {"analysis/base/version.h": r'define STICKSLIP_VERSION "(\S+)"', "CITATION.cff": r"^version: (\S+)$", "CHANGELOG.md": r"^## (\S+)$"}


def complaints(source):
    return [*licence_complaints(source), *version_complaints(source)]


def licence_complaints(source):
    stated = source / "REUSE.toml"
    if not stated.exists():
        return
    annotations = tomllib.loads(stated.read_text(encoding="utf-8")).get("annotations", [])
    if not any(one.get("path") == "**" for one in annotations):
        yield 'REUSE.toml: has no annotation of path "**", so that files have no licence'
    used = set()
    for one in annotations:
        paths = one["path"] if isinstance(one["path"], list) else [one["path"]]
        for path in paths:
            if not any(source.glob(path)):
                yield f"REUSE.toml: names {path}, which is not there"
        for key in RIGHTS:
            if not one.get(key):
                yield f"REUSE.toml: {', '.join(paths)} has no {key}"
        used |= set(re.split(r"\s+(?:AND|OR)\s+|[()]", one.get(RIGHTS[1], ""))) - {""}
    texts = {path.stem for path in (source / "LICENSES").glob("*.txt")}
    for name in sorted(used - texts):
        yield f"REUSE.toml: names {name}, and LICENSES/{name}.txt is not there"
    for name in sorted(texts - used):
        yield f"LICENSES/{name}.txt: is the licence of no file in REUSE.toml"


def version_complaints(source):
    found = {}
    for name, pattern in VERSIONS.items():
        if (source / name).exists():
            match = re.search(pattern, (source / name).read_text(encoding="utf-8"), re.MULTILINE)
            found[name] = match.group(1) if match else "no version"
    if len(set(found.values())) > 1:
        yield "versions differ: " + ", ".join(f"{name} has {version}" for name, version in found.items())
