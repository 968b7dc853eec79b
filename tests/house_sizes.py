"""Sizes of files and functions: the part of house.py that counts lines.

Code is read in files of up to 250 lines and functions of up to 60. A file that is longer says why in the comment at its
head, a function in the comment above it. Beyond that, house_exceptions.toml lists in one place which functions are long,
and which files of any kind, tests and scripts among them, have more than 400 lines: a new exception is a line there.
"""
import re
import tomllib

LONGEST_FILE, LONGEST_FUNCTION, TALLEST_FILE = 250, 60, 400
EXCEPTIONS = "tests/house_exceptions.toml"
IN_ONE_FILE = re.compile(r"^// In one file: (.+)\.$", re.MULTILINE)
IN_ONE_PIECE = re.compile(r"// In one piece: (.+)\.$")
# Of any kind: what is written by hand, in the folders that hold it.
WRITTEN = ("analysis", "cmake", "examples", "include", "python", "render", "sweep", "tests")
KINDS = {".h", ".cpp", ".py", ".sh", ".js", ".mjs", ".cmake"}
NOT_OURS = {"node_modules", "__pycache__", "build"}


def functions(lines):
    """Name, lines from brace to brace, and the reason to stay whole. A body opens and closes with a brace of its own line;
    a lambda with a name, outside functions, opens at the end of its line."""
    at = 0
    while at < len(lines):
        if "auto " in lines[at] and (lambda_named := re.match(r"(?:\w+ )*auto (\w+) = \[.*\{$", lines[at])):
            end = next((i for i in range(at, len(lines)) if lines[i] == "};"), at)
            why = IN_ONE_PIECE.search(lines[at - 1]) if at else None
            yield lambda_named.group(1), end - at + 1, why.group(1) if why else ""
            at = end
        if not lines[at].endswith("{") or not (opens := re.fullmatch(r"( *)\{", lines[at])):
            at += 1
            continue
        start = at
        while start > 0 and lines[start - 1].strip():
            start -= 1
        head = " ".join(line.strip() for line in lines[start:at] if not line.lstrip().startswith("//"))
        named = re.search(r"(\w+|operator\S+)\(.*\)(?: const| override| noexcept)*(?: -> .+?)?(?: requires .+?)?(?: : .*)?$", head)
        if named:
            end = next((i for i in range(at, len(lines)) if lines[i] == opens.group(1) + "}"), at)
            why = next((found.group(1) for line in lines[start:at] if (found := IN_ONE_PIECE.search(line))), "")
            yield head[:head.find("(")].split(" ")[-1], end - at + 1, why
            at = end
        at += 1


def sizes(source, files):
    """Files and functions of the code beyond the limits."""
    for path in files:
        text = (source / path).read_text(encoding="utf-8")
        if text.count("\n") > LONGEST_FILE:
            why = IN_ONE_FILE.search(text)
            yield text.count("\n"), f"{path}: {why.group(1) if why else 'no reason given'}"
        for name, count, why in functions(text.split("\n")):
            if count > LONGEST_FUNCTION:
                yield count, f"{path} {name}(): {why or 'no reason given'}"


def file_complaints(path, text):
    count, whys = text.count("\n"), IN_ONE_FILE.findall(text)
    if count > LONGEST_FILE and not whys:
        yield (f"{path}: has {count} lines; part it where it holds two things, or say at its head "
               f"\"// In one file: WHY.\"")
    if whys and (count <= LONGEST_FILE or len(whys) > 1 or not IN_ONE_FILE.search(text.split("#include")[0])):
        yield f"{path}: a reason to stay in one file is not needed, stands twice or not at its head"


def function_complaints(path, text, listed):
    reasons, long = 0, set()
    for name, count, why in functions(text.split("\n")):
        reasons += bool(why)
        if count > LONGEST_FUNCTION:
            long.add(name)
            if not why:
                yield (f"{path}: {name}() has {count} lines; part it where a part has a name, or say above it "
                       f"\"// In one piece: WHY.\"")
            elif name not in listed:
                yield f"{path}: {name}() has {count} lines and is not among the long functions of {EXCEPTIONS}"
        elif why:
            yield f"{path}: {name}() has {count} lines and needs no reason to stay in one piece"
    if text.count("// In one piece:") != reasons:
        yield f"{path}: a reason to stay in one piece stands above no function"
    for name in sorted(set(listed) - long):
        yield f"{EXCEPTIONS}: lists {name}() of {path}, which is not long"


def test_complaints(source):
    """Functions of tests that are no case: a case may be as long as what it tells."""
    for path in sorted(p for p in (source / "tests").rglob("*") if p.suffix in (".h", ".cpp") and not NOT_OURS & set(p.parts)):
        own = path.relative_to(source).as_posix()
        for name, count, why in functions(path.read_text(encoding="utf-8").split("\n")):
            if count > LONGEST_FUNCTION and "TEST_CASE" not in name and not why:
                yield f"{own}: {name}() has {count} lines; part it where a part has a name, or say above it \"// In one piece: WHY.\""


def tall_complaints(source, listed):
    """Files of any kind above TALLEST_FILE lines, and files listed for nothing."""
    tall = set()
    for folder in WRITTEN:
        for path in sorted((source / folder).rglob("*")):
            own = path.relative_to(source)
            if path.suffix not in KINDS or NOT_OURS & set(own.parts) or not path.is_file():
                continue
            count = path.read_text(encoding="utf-8").count("\n")
            if count > TALLEST_FILE:
                tall.add(own.as_posix())
                if not listed.get(own.as_posix(), "").strip():
                    yield f"{own}: has {count} lines, above {TALLEST_FILE}, and no reason in {EXCEPTIONS}"
    for path in sorted(set(listed) - tall):
        yield f"{EXCEPTIONS}: lists {path}, which has no more than {TALLEST_FILE} lines"


def complaints(source, files):
    place = source / EXCEPTIONS
    exceptions = tomllib.loads(place.read_text(encoding="utf-8")) if place.exists() else {}
    long = exceptions.get("long_functions", {})
    found = []
    for path in (path.as_posix() for path in files):
        text = (source / path).read_text(encoding="utf-8")
        found += file_complaints(path, text)
        found += function_complaints(path, text, long.pop(path, []))
    found += [f"{EXCEPTIONS}: lists functions of {path}, which is not there" for path in sorted(long)]
    return found + list(test_complaints(source)) + list(tall_complaints(source, exceptions.get("tall_files", {})))
