#!/usr/bin/env python3
"""trace_policy.py SOURCE FOLDER: copies of analysis/diagnosis/policy/*.h whose numbers write down what they are compared with
(traced.h), and entries.h with all of them, for the program `thresholds`. Prints the sources that see these headers, separated by semicolons."""
import functools
import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
import house_policy  # noqa: E402

source, made = Path(sys.argv[1]), Path(sys.argv[2])
HOME = "analysis/diagnosis/policy"
INCLUDE = '#pragma once\n#include "tests/evidence/traced.h"\n'
registry = []


def of_rules(text):
    return re.sub(r"^( +)double ", r"\1evidence::Traced ", text, flags=re.MULTILINE).replace("#pragma once\n", INCLUDE)


rules = (source / HOME / "rules.h").read_text(encoding="utf-8")
doubles = {name for line in re.findall(r"^ +double ([\w, ]+);", rules, re.MULTILINE) for name in line.split(", ")}


def of_policy(text):
    """A header of the policy, and behind its numbers the counters that they write to."""
    counts = []

    def traced(name, value, place=None):
        """The braces of a Traced, and a Compared for it."""
        counter = "of_" + re.sub(r"\W", "_", name)
        if not any(counter == known for known, _ in counts):
            counts.append((counter, name))
        registry.append((name, counter, place))
        return f"{{{value}, &compared::{counter}}}"

    def of_struct(match):
        struct, name, body = match.groups()
        body = re.sub(r"\.(\w+) = ([^,\n]+),", lambda m: f".{m[1]} = {traced(f'{name}.{m[1]}', m[2], f'{name}.{m[1]}')},"
                      if m[1] in doubles else m[0], body)
        return f"inline {struct} {name}{{{body}\n}};"

    def of_range(match):
        effect, parameter, low, high = match.groups()
        ends = [traced(f"{effect}.{parameter}.{end}", value) for end, value in (("low", low), ("high", high))]
        return f'PhysicalRange{{"{effect}", "{parameter}", {", ".join(ends)}, '

    def of_numbers(match):
        found = re.findall(r"(\w+) = ([^,;]+)", match[1])
        return "inline constinit evidence::Traced " + ",\n    ".join(name + traced(name, value, name) for name, value in found) + ";"

    text = re.sub(r"inline constexpr (CorrectionPrior|LadderRules) (\w+)\{(.*?)\n\};", of_struct, text, flags=re.DOTALL)
    text = text.replace("inline constexpr std::array physical_ranges", "inline std::array physical_ranges")
    text = re.sub(r'PhysicalRange\{"([^"]+)", "([^"]+)", ([^,]+), ([^,]+), ', of_range, text)
    text = re.sub(r"inline constexpr double ([^;]+);", of_numbers, text)
    head, tail = text.replace("#pragma once\n", INCLUDE).split("namespace stickslip::gap::policy {\n", 1)
    counters = "".join(f'inline constinit evidence::Compared {counter}{{"{name}"}};\n' for counter, name in counts)
    return head + "namespace stickslip::gap::policy {\nnamespace compared {\n" + counters + "}\n" + tail


def entries(headers):
    places = "".join(f'    {{"{name}", &compared::{counter}, {"&" + place if place else "nullptr"}}},\n'
                     for name, counter, place in registry)
    return ("#pragma once\n" + "".join(f'#include "{HOME}/{name}"\n' for name in headers) +
            "namespace stickslip::gap::policy {\n"
            "struct Entry { const char* name; evidence::Compared* compared; evidence::Traced* number; };\n"
            "inline const Entry entries[] = {\n" + places + "};\n}  // namespace stickslip::gap::policy\n")


made_headers = {"rules.h": of_rules(rules)}
for path in house_policy.headers(source):
    made_headers[path.name] = of_policy(path.read_text(encoding="utf-8"))
made_headers["entries.h"] = entries(made_headers)
for name, text in made_headers.items():
    text = re.sub(r"\n+", "\n", re.sub(r" *//.*", "", text))  # reasons and evidence are rewritten more often than numbers
    target = made / HOME / name
    target.parent.mkdir(parents=True, exist_ok=True)
    if not target.exists() or target.read_text(encoding="utf-8") != text:
        target.write_text(text, encoding="utf-8")


@functools.cache
def included(path):
    names = {name for name in re.findall(r'^#include "([^"]+)"', (source / path).read_text(encoding="utf-8"), re.MULTILINE)
             if (source / name).exists()}
    return names.union(*map(included, names))


headers = {f"{HOME}/{name}" for name in made_headers}
sources = (path.relative_to(source).as_posix() for path in sorted((source / "analysis/diagnosis").rglob("*.cpp")))
print(";".join(str(source / path) for path in sources if included(path) & headers), end="")
