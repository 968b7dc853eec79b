#!/usr/bin/env python3
"""The stub of the room of words stands in for every sentence that an answer can hold. Run: stub_test.py BUILD

What JSON, questions and studies call of sweep/words is a sentence, and has a stub in words.cpp beside this file; else
the test schemas would compare a sentence with itself and notice nothing. The exceptions are told below.
"""
import pathlib
import re
import subprocess
import sys

# What is no sentence: each with the reason.
NO_SENTENCE = {
    "plain_text(std::string const&)": "takes the mark-up off a sentence",
    "symbol_of(std::string_view, stickslip::Units)": "axes of charts: letters",
    "name_of(std::string_view)": "axes of charts: the parameter at a path",
}
ANSWERS = ("files", "study", "engine")


def plain(name):
    """As a header writes it."""
    for kind in ("string", "string_view"):
        name = re.sub(rf"std::(__cxx11::)?basic_{kind}<char(, std::\w+<char> ?)*>", f"std::{kind}", name)
    return name.replace("[abi:cxx11]", "").removeprefix("stickslip::")


def symbols(objects, which):
    """Functions of ours that the objects define or ask for, each with the objects."""
    found = {}
    for part in (objects[i:i + 200] for i in range(0, len(objects), 200)):
        out = subprocess.run(["nm", "-A", "-C", which, *part], check=True, capture_output=True, text=True).stdout
        for line in out.splitlines():
            if hit := re.search(r"^(\S+?):.* [TU] (stickslip::.*)$", line):
                found.setdefault(plain(hit.group(2)), set()).add(hit.group(1))
    return found


def objects(build, below):
    return [str(path) for path in sorted(build.glob(f"sweep/CMakeFiles/*.dir/{below}/**/*.o"))]


def main():
    build = pathlib.Path(sys.argv[1])
    sentences = symbols(objects(build, "words"), "--defined-only")
    stubs = symbols([str(path) for path in build.glob("tests/CMakeFiles/stickslip_of_codes.dir/codes/*.o")], "--defined-only")
    used = symbols([path for room in ANSWERS for path in objects(build, room)], "--undefined-only")
    if len(sentences) < 50 or len(stubs) < 30 or not used:
        sys.exit(f"{len(sentences)} sentences, {len(stubs)} stubs: the objects are not where this test looks for them")
    wrong = []
    for name in sorted(sentences.keys() & used.keys() - stubs.keys()):
        if name not in NO_SENTENCE:
            wrong.append(f"{name}: goes into answers and has no stub; asked for by {', '.join(sorted(used[name]))}")
    for line in wrong:
        print(line)
    print(f"{len(stubs)} stubs for {len(sentences.keys() & used.keys())} functions of sweep/words that answers ask for")
    return 1 if wrong else 0


sys.exit(main())
