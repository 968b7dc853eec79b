"""docs/library.md from the public headers: what a program outside can call, with the words above each declaration.

Every header of include/stickslip forwards to the headers of ours that ask a question and hold its answer. Its page section has the
words at their heads, and every struct, enum, function, constant and alias of its namespace with the comment above it. Bodies of functions and the
self-description of structs (`fields`) are left out.
"""
import re

HEAD = """# C++ library

The analysis of one joint as a library, installed by the `.deb` or by `cmake --install build --component library`:

```cmake
find_package(stickslip 0.2 REQUIRED COMPONENTS files)
target_link_libraries(mine PRIVATE stickslip::analysis stickslip::files)   # files: joint files and records, optional
```

`#include <stickslip/stickslip.h>` includes every header below. Values are SI. A value that does not exist is NaN, with a reason where there is one.
The library starts no threads: functions that can work in parallel take a `ParallelFor`.
The examples in `examples/06-library` are built against an installed library in CI: `gain_table.cpp` (verdicts), `outcomes.cpp` (nonlinear outcomes
in parallel), `boundary.cpp`, `diagnosis.cpp` and `from_files.cpp`.
"""
INCLUDE = re.compile(r'^#include "(.+)"', re.MULTILINE)
SKIPPED = re.compile(r"^(?:#|//(?!/)|namespace\b|}\s*//|using namespace\b|$)")


def head_words(text):
    """The comment above #pragma once as one paragraph, without notes to those who maintain the file."""
    lines = [line[2:].strip() for line in text.split("#pragma once")[0].splitlines() if line.startswith("//")]
    words = " ".join(lines)
    return re.sub(r"\s*In one file:.*", "", words)


def without_strings(line):
    return re.sub(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)\'', '""', line.split("//")[0])


def declarations(text):
    """(comment, lines) of everything at the level of a namespace."""
    comment, lines, depth, namespaces = [], [], 0, 0
    for line in text.split("#pragma once")[1].splitlines():
        code = without_strings(line)
        if not lines:
            if line.startswith("///"):
                comment.append(line[3:].strip())
                continue
            if SKIPPED.match(line):
                comment = []
                continue
        lines.append(line)
        depth += code.count("{") - code.count("}")
        parens = sum(l.count("(") - l.count(")") for l in map(without_strings, lines))
        ends = depth == 0 and parens == 0 and re.search(r"[;}]\s*$", code)
        if ends:
            yield " ".join(comment), lines
            comment, lines = [], []


def body_starts(line):
    return re.match(r"\s*\{", line) or re.search(r"\)\s*(?:const\s*)?(?:noexcept\s*)?(?:override\s*)?\{", without_strings(line))


def without_bodies(lines):
    """A struct without the bodies of its functions; a function without its own."""
    kept, inside, depth = [], 0, 0
    is_type = re.match(r"(?:template.*)?\s*(?:struct|class|enum|union)\b", " ".join(l.strip() for l in lines[:2]))
    for line in lines:
        code = without_strings(line)
        change = code.count("{") - code.count("}")
        if inside:
            inside += change
            continue
        own = depth == 0 and is_type
        if not own and body_starts(line) and (depth > 0 or not is_type) and "=" not in code.split("(")[0]:
            signature = re.sub(r"\s*(?::[^:{]*)?\{.*", "", line)
            if signature.strip():
                kept.append(signature + ";")
            elif kept:
                kept[-1] += ";"
            inside = max(0, change)
            continue
        kept.append(line)
        depth += change
    text = "\n".join(kept)
    # the description that readers and checkers walk, and what is private, are no business of a caller
    text = re.sub(r"\n\s*template <class Self, class Visitor>\n[^;]*;", "", text)
    text = re.sub(r"\n\s*(?:private|protected):.*?(?=\n};)", "", text, flags=re.DOTALL)
    return re.sub(r"\n\s*\n(?=\s*\n|};)", "\n", text)


def headers(root):
    """Name of each public header, texts of those that it forwards to."""
    for header in sorted((root / "include/stickslip").glob("*.h")):
        if found := INCLUDE.findall(header.read_text(encoding="utf-8")):
            yield header.name, [(root / target).read_text(encoding="utf-8") for target in found]


def library(root):
    text = HEAD
    for name, targets in headers(root):
        text += f"\n## `<stickslip/{name}>`\n\n" + " ".join(head_words(target) for target in targets) + "\n"
        for comment, lines in (d for target in targets for d in declarations(target)):
            shown = without_bodies(lines)
            if re.match(r"(?:struct|class|enum class) \w+;$", shown):
                continue
            text += f"\n```cpp\n{shown}\n```\n"
            if comment:
                text += f"\n{comment}\n"
    return text


def members(lines):
    """(declaration, whether a /// describes it) of every member of a struct but constructors, operators and begin() and end()."""
    statement, depth, commented, above = "", 0, False, False
    text = "\n".join(lines)
    head = re.match(r"(?:template\s*<[^>]*>\s*)?(?:struct|class)\s+\w+[^;{]*\{", text)
    if not head:
        return
    for line in text[head.end():].splitlines():
        code = without_strings(line)
        if depth == 0 and re.match(r"\s*(?:private|protected):", line):
            return
        if not statement and line.strip().startswith("///"):
            above = True
            continue
        if not statement and not code.strip():
            above = above and bool(line.strip())
            continue
        statement += " " + code.strip()
        commented = commented or above or "///" in line
        depth += code.count("{") - code.count("}")
        parens = statement.count("(") - statement.count(")")
        if depth < 0:
            return
        if depth == 0 and parens == 0 and re.search(r"[;}]\s*$", code):
            usual = re.search(r"\bfields\(|\boperator|\b(?:begin|end)\(|= default;|^ (?:static |explicit |constexpr )*[A-Z]\w*\(|^ enum\b", statement)
            if not usual:
                yield statement.strip(), commented
            statement, commented, above = "", False, False


def undocumented_in(text):
    """Declarations at the level of a namespace, and members of structs, that no `///` describes."""
    found = []
    for comment, lines in declarations("#pragma once\n" + text.split("#pragma once")[-1]):
        first = " ".join(line.strip() for line in lines)
        if re.match(r"(?:template\s*<[^>]*>\s*)?(?:struct|class|enum class) \w+;$", first):
            continue
        if not comment and "///" not in lines[0]:
            found.append(first.split("{")[0].strip())
        found += [f"{first.split('{')[0].strip()}: {what}" for what, described in members(lines) if not described]
    return found


def undocumented(root):
    """(public header, declaration) of what a caller can use and no `///` describes."""
    return [(header, what) for header, targets in headers(root) for target in targets for what in undocumented_in(target)]
