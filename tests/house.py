#!/usr/bin/env python3
"""The rooms of the house: which folder may include which. Run: tests/house.py [source folder], with --sizes for the files
and functions that are longer than a reader likes.

Checks that arrows between floors go down only, that no folders include each other in a circle (a pair is the smallest
circle), that the headers of heavy libraries stay behind ours, that a header which says "Internal to FOLDER" is included
from there only, that a folder includes only what another one lists as a door (house_doors.py), that programs outside
see public headers only, that a file of more than 250 lines and a function of more than 60 say why, that thresholds of
the diagnosis stand in its policy, that the diagnosis refuses with codes and not with sentences, that tests mirror the
rooms, that no two types of one namespace have one name, that comments name no file or document that is not there, and
that licences and versions are stated (house_public.py).
"""
import re
import sys
from collections import defaultdict
from pathlib import Path

sys.dont_write_bytecode = True
import house_doors  # beside this file
import house_policy
import house_public
import house_sizes

GIVEN = [given for given in sys.argv[1:] if not given.startswith("--")]
SOURCE = Path(GIVEN[0] if GIVEN else Path(__file__).parent.parent)
ROOMS = ("analysis", "render", "sweep")

# What a floor may not include: the first folder that a file lies in decides.
FORBIDDEN = {
    "analysis/results": r"analysis/(?!results/)|render/|sweep/|tests/",
    "analysis": r"render/|sweep/|tests/|fmt/|nlohmann/|toml|CLI/|tbb/|netcdf|vtk|fstream|iostream|thread",
    "render": r"analysis/(?!results/)|sweep/|tests/|nlohmann/|toml|netcdf|tbb/",
    "sweep": r"vtk|sundials|nlopt|tests/",
}
HEAVY = re.compile(r"sundials|cvode|nvector|nlopt")
# The headers of CLI11 take ten seconds to compile: verbs declare their options by way of command_line.h.
READS_CLI = re.compile(r"sweep/program/(program|verbs/(command_line|usage|completion|man_page))\.(cpp|h)")
# Pages and words are drawn from answers and compute nothing: these rooms include no room that computes. Headers of answers
# in sweep/study may, for the structs, and so may the thresholds of the policy, which sentences state; the test report_links holds the program part against what it links.
COMPUTES = re.compile(r"analysis/(boundary|simulation|design|diagnosis/(?!policy/)|numerics)/|tbb/")
DRAWS = ("sweep/report/figures", "sweep/report/pages", "sweep/words")
INCLUDE = re.compile(r'^\s*#include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


# What a program outside sees: headers that stand for one question each, forwarding to ours that ask it and hold its answer, and an
# umbrella over them all.
PUBLIC = "include/stickslip"
OUTSIDE = ("examples", "tests/package")


def public_complaints():
    public = {path.name: INCLUDE.findall(path.read_text(encoding="utf-8")) for path in (SOURCE / PUBLIC).glob("*.h")}
    umbrella = public.pop("stickslip.h", [])
    for name, includes in sorted(public.items()):
        if f"stickslip/{name}" not in umbrella:
            yield f"{PUBLIC}/{name}: is missing in stickslip.h"
        if not 1 <= len(includes) <= 3:
            yield f"{PUBLIC}/{name}: includes {includes}, a public header stands for one question and its answer"
        for target in includes:
            if not (SOURCE / target).exists() or not target.startswith(("analysis/", "sweep/files/")):
                yield f"{PUBLIC}/{name}: includes {target}, which is no header of analysis or of sweep/files"
            elif "Internal to" in (SOURCE / target).read_text(encoding="utf-8").split("#pragma once")[0]:
                yield f"{PUBLIC}/{name}: makes {target} public, which says that it is internal"
    for name in umbrella:
        if name.removeprefix("stickslip/") not in public:
            yield f"{PUBLIC}/stickslip.h: includes {name}, which is no public header"
    for path in sorted(p for room in OUTSIDE for p in (SOURCE / room).rglob("*") if p.suffix in (".h", ".cpp")):
        for name in INCLUDE.findall(path.read_text(encoding="utf-8")):
            inside = name.split("/")[0] in ROOMS or name.startswith("stickslip/") and name.split("/")[1] not in public
            if inside and name != "stickslip/stickslip.h":
                yield f"{path.relative_to(SOURCE)}: includes {name}, which is not public"


# What a header is for inside its room only: "Internal to FOLDER." in the words above its #pragma once.
INTERNAL = re.compile(r"Internal to (\S+?)[.:,]?(?=\s|$)")


def internal_complaints():
    rooms = {}
    for path in (p for p in files() if p.suffix == ".h"):
        words = re.sub(r"\n// ?", " ", (SOURCE / path).read_text(encoding="utf-8").split("#pragma once")[0])
        if found := INTERNAL.search(words):
            room = found.group(1)
            if (SOURCE / room).is_dir() and path.is_relative_to(room):
                rooms[path.as_posix()] = room
            else:
                yield f"{path}: is internal to {room}, which is no folder that it lies in"
    for path in files():
        for name in INCLUDE.findall((SOURCE / path).read_text(encoding="utf-8")):
            if name in rooms and not path.is_relative_to(rooms[name]):
                yield f"{path}: includes {name}, which is internal to {rooms[name]}"


NAMED_FILE = re.compile(r"\b(?:" + "|".join(ROOMS) + r")/[\w/.-]+\.(?:h|cpp)\b")


NAMED_PAGE = re.compile(r"\b[\w/-]+\.md\b")
# A paper by a name in capitals, as "PAPER §3": of the documents of a design, which no reader has.
NAMED_PAPER = re.compile(r"\b(?:[A-Z]{3,}(?:\.md)?(?= §)|INTERFACE\b|PHYSICS\b)")


def comment_complaints():
    """A comment that sends its reader to a file or a page names one that is there."""
    for path in [*files(), *files(("tests",))]:
        for number, line in enumerate((SOURCE / path).read_text(encoding="utf-8").splitlines(), 1):
            if "#include" in line or "//" not in line:
                continue
            comment = line[line.index("//"):]
            for name in NAMED_FILE.findall(comment) + NAMED_PAGE.findall(comment):
                if not (SOURCE / name).exists() and not (SOURCE / path.parent / name).exists():
                    yield f"{path}:{number}: names {name}, which is not there"
            for name in NAMED_PAPER.findall(comment):
                yield f"{path}:{number}: cites {name}, which is no document of this repository"


# What decides an answer of the diagnosis has a name, a reason and its evidence in one room.
POLICY = house_policy.POLICY
DECIMAL = r"\d+(?:\.\d+(?:e[-+]?\d+)?|e[-+]?\d+)"
COMPARED = re.compile(rf"(?:[<>]=?|[!=]=)\s*-?(?:[\w.:\[\]()]+ \* )?{DECIMAL}\b|\b{DECIMAL}(?: \* [\w.:\[\]()]+)?\s*(?:[<>]=?|[!=]=)")
# A whole number as a factor of what is compared, from 3 on; and a bare number that a condition chooses.
WHOLE_FACTOR = re.compile(r"[<>]=?\s*-?(?:[3-9]|\d{2,}) \* |(?<![\w.])(?:[3-9]|\d{2,}) \* [\w.:\[\]()]+\s*[<>]=?[^<>]")
CHOSEN = re.compile(rf"\? (?:{DECIMAL} : -?[\d.]+|-?[\d.]+ : {DECIMAL})\b")


# A file that writes verdicts, reasons or findings compares data with the policy. A number of its own that is compared is
# numerical: of a scan, of logged digits, of what is left out; the comment beside it says so.
WRITES_ANSWER = re.compile(r"\.verdict = |reasons(?:\.push_back|\.insert| = )|findings\.push_back|shortages\.push_back|refuse\(")
OWN_NUMBERS = re.compile(r"\s*(?:inline |static )*constexpr (?:double|int|std::size_t|auto) (.+);")


def compared_with(name, code):
    factor = r"[\w.:\[\]()]+"
    return re.search(rf"(?:[<>]=?|[!=]=) -?(?:{factor} \* )*{name}\b|\b{name}(?: \* {factor})* (?:[<>]=?|[!=]=) ", code)


def shared_threshold_complaints():
    """The same of a number that a header of the diagnosis defines and a file that writes answers compares with."""
    shared = {}
    for path in (p for p in files() if p.is_relative_to("analysis/diagnosis") and p.suffix == ".h" and p.parent.as_posix() != POLICY):
        for number, line in enumerate((SOURCE / path).read_text(encoding="utf-8").splitlines(), 1):
            if line.startswith("inline constexpr double") and "numerical: " not in line and (own := OWN_NUMBERS.match(line.split("//")[0])):
                shared |= {name: f"{path}:{number}" for name in re.findall(r"(\w+) = [^,]*\d", own.group(1))}
    for path in (p for p in files() if p.is_relative_to("analysis/diagnosis") and p.suffix == ".cpp"):
        text = (SOURCE / path).read_text(encoding="utf-8")
        code = re.sub(r"//.*", "", text)
        for name, place in shared.items():
            if WRITES_ANSWER.search(text) and compared_with(name, code):
                yield f"{place}: {name} decides an answer in {path}, beside the policy"


def own_threshold_complaints():
    for path in (p for p in files() if p.is_relative_to("analysis/diagnosis") and p.parent.as_posix() != POLICY):
        text = (SOURCE / path).read_text(encoding="utf-8")
        if not WRITES_ANSWER.search(text):
            continue
        code = re.sub(r"//.*", "", text)
        for number, line in enumerate(text.splitlines(), 1):
            own = OWN_NUMBERS.match(line.split("//")[0])
            names = re.findall(r"(\w+) = [^,]*\d", own.group(1)) if own else []
            if any(compared_with(name, code) for name in names) and "// numerical: " not in line:
                yield (f"{path}:{number}: decides an answer beside the policy; thresholds stand in {POLICY}, "
                       f"numerical limits say \"// numerical: WHAT\"")


def policy_complaints():
    """In the diagnosis no decimal number is compared with but by a name;
    every number of the policy says what supports it, and every other one that it is numerical."""
    for path in (p for p in files() if p.is_relative_to("analysis/diagnosis") and p.parent.as_posix() != POLICY):
        for number, line in enumerate((SOURCE / path).read_text(encoding="utf-8").splitlines(), 1):
            code = re.sub(r'"[^"]*"', "", line.split("//")[0])
            scan = code.lstrip().startswith("for (") or "// numerical: " in line
            if (COMPARED.search(code) or not scan and WHOLE_FACTOR.search(code)) and "constexpr" not in code:
                yield f"{path}:{number}: compares with a bare number; name it here (numerical limit) or in {POLICY} (threshold)"
            if CHOSEN.search(code) and not scan:
                yield f"{path}:{number}: chooses a bare number; thresholds stand in {POLICY}, numerical limits say \"// numerical: WHAT\""
        yield from house_policy.beside(path, (SOURCE / path).read_text(encoding="utf-8").splitlines())
    for path in house_policy.headers(SOURCE):
        yield from house_policy.complaints(path.relative_to(SOURCE), path.read_text(encoding="utf-8").splitlines())


# The diagnosis refuses with codes (CannotAnswer, NotFitted); their sentences are composed in sweep/words.
WORDED = re.compile(r"throw std::\w+\(")


def refusal_complaints():
    for path in (p for p in files() if p.is_relative_to("analysis/diagnosis")):
        for number, line in enumerate((SOURCE / path).read_text(encoding="utf-8").splitlines(), 1):
            if WORDED.search(line.split("//")[0]):
                yield f"{path}:{number}: refuses with words; give CannotAnswer a code for it, and sweep/words its sentence"


# Tests of no room: each with its reason.
OF_NO_ROOM = {
    "tests/sweep/found": "joints that an answer was wrong for",
    "tests/sweep/engine/kill_test.cpp": "a sweep that is killed, as a program",
}


def mirror_complaints():
    """A test lies in the folder of tests/ that mirrors what it tests: it, or a header of tests beside it, includes something of
    that room, or it bears the name of one of its files."""
    for path in files(("tests",)):
        if path.parts[1] not in ROOMS or not path.name.endswith("_test.cpp"):
            continue
        if any(path.is_relative_to(place) for place in OF_NO_ROOM):
            continue
        room = Path(*path.parts[1:-1])
        names = INCLUDE.findall((SOURCE / path).read_text(encoding="utf-8"))
        for name in [name for name in names if Path(name).parent == path.parent and (SOURCE / name).exists()]:
            names += INCLUDE.findall((SOURCE / name).read_text(encoding="utf-8"))
        same_name = (SOURCE / room / path.name.replace("_test.cpp", ".cpp")).exists()
        if not same_name and not any(Path(name).is_relative_to(room) for name in names):
            yield f"{path}: includes nothing of {room}; a test lies where what it tests lies"


def files(rooms=ROOMS):
    for room in rooms:
        for path in sorted((SOURCE / room).rglob("*")):
            if path.suffix in (".h", ".cpp") and "node_modules" not in path.parts:
                yield path.relative_to(SOURCE)


OPENS = re.compile(r"(?:inline )?namespace ?([\w:]*) ?\{$")
TYPE = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?: :[^{;]*)?(?:\s*\{.*)?$")


def name_complaints():
    """Two types of one full name in two files: the linker takes one of their functions for both, and says nothing."""
    places = defaultdict(list)
    for path in files():
        inside = []
        for number, line in enumerate((SOURCE / path).read_text(encoding="utf-8").splitlines(), 1):
            if opened := OPENS.match(line):
                inside.append(opened.group(1))
            elif line.startswith("}  // namespace") and inside:
                inside.pop()
            elif inside and "" not in inside and (named := TYPE.match(line)):
                places["::".join([*inside, named.group(1)])].append((path, number))
    for name, found in sorted(places.items()):
        for path, number in found[1:]:
            if path != found[0][0]:
                yield f"{path}:{number}: defines {name}, as does {found[0][0]}:{found[0][1]}"


def circles(arrows):
    """Strongly connected sets of more than one folder (Tarjan)."""
    index, low, stack, on_stack, found = {}, {}, [], set(), []

    def visit(folder):
        index[folder] = low[folder] = len(index)
        stack.append(folder)
        on_stack.add(folder)
        for other in arrows[folder]:
            if other not in index:
                visit(other)
                low[folder] = min(low[folder], low[other])
            elif other in on_stack:
                low[folder] = min(low[folder], index[other])
        if low[folder] == index[folder]:
            members = []
            while not members or members[-1] != folder:
                members.append(stack.pop())
                on_stack.discard(members[-1])
            if len(members) > 1:
                found.append(sorted(members))

    for folder in list(arrows):
        if folder not in index:
            visit(folder)
    return found


def includes_of(path):
    return INCLUDE.findall((SOURCE / path).read_text(encoding="utf-8"))


def rooms_between(one, other):
    """The two folders of an include, and the two rooms around them where their ways part."""
    same = 0
    while same < min(len(one), len(other)) and one[same] == other[same]:
        same += 1
    if one != other:
        yield "/".join(one), "/".join(other)
    if same < min(len(one), len(other)):
        yield "/".join(one[: same + 1]), "/".join(other[: same + 1])


def main():
    if "--sizes" in sys.argv:
        for count, what in sorted(house_sizes.sizes(SOURCE, files()), reverse=True):
            print(f"{count:4} {what}")
        return 0
    if "--doors" in sys.argv:
        print(house_doors.text(house_doors.used_from_outside(list(files()), includes_of)))
        return 0
    wrong, arrows, because, counted = [], defaultdict(set), {}, defaultdict(int)
    for path in files():
        folder = path.parent.as_posix()
        counted[folder] += 1
        floor = "analysis/results" if folder.startswith("analysis/results") else path.parts[0]
        for name in INCLUDE.findall((SOURCE / path).read_text(encoding="utf-8")):
            if re.match(FORBIDDEN[floor], name):
                wrong.append(f"{path}: includes {name}, which lies on a floor above or is not for this floor")
            if path.suffix == ".h" and floor != "sweep" and HEAVY.match(name):
                wrong.append(f"{path}: a header of ours includes {name}; keep it in a .cpp")
            if floor == "sweep" and name.startswith("CLI/") and not READS_CLI.fullmatch(str(path)):
                wrong.append(f"{path}: includes {name}, ten seconds to compile; declare options by way of command_line.h")
            if folder in DRAWS and COMPUTES.match(name):
                wrong.append(f"{path}: includes {name}; what is computed belongs into sweep/study, pages draw answers")
            if not (SOURCE / name).exists():
                continue
            for one, other in rooms_between(path.parent.parts, Path(name).parent.parts):
                arrows[one].add(other)
                because[one, other] = f"{path} includes {name}"
    for members in circles(arrows):
        wrong.append("folders that include each other in a circle: " + ", ".join(members))
        wrong += [f"    {text}" for (a, b), text in sorted(because.items()) if a in members and b in members]
    wrong += internal_complaints()
    wrong += house_doors.complaints(SOURCE, list(files()), includes_of)
    wrong += public_complaints()
    wrong += house_sizes.complaints(SOURCE, files())
    wrong += house_public.complaints(SOURCE)
    wrong += name_complaints()
    wrong += comment_complaints()
    wrong += mirror_complaints()
    wrong += policy_complaints()
    wrong += own_threshold_complaints()
    wrong += shared_threshold_complaints()
    wrong += refusal_complaints()
    for line in wrong:
        print(line)
    print(f"{sum(counted.values())} files in {len(counted)} folders, {sum(map(len, arrows.values()))} arrows, {len(wrong)} complaints")
    return 1 if wrong or not counted else 0


sys.exit(main())
