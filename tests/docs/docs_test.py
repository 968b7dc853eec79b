#!/usr/bin/env python3
"""The pages that are made from the code: current, and with nothing missing. Run: docs_test.py STICKSLIP

What must be there is found by other means than the pages are made by: the names in the sources' own declarations.
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).parent.parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import docs  # noqa: E402
import library  # noqa: E402

wrong = []


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def declared_keys():
    """The first word in quotes of every visit.…(…): what reading, checking and listing walk, too."""
    visit = re.compile(r'visit\.(?:number|numbers|flag|choice|text|table|rows|samples)\(\s*(?:Field)?\{?\s*"(\w+)"')
    sources = [*ROOT.glob("analysis/joint/*.h"), *ROOT.glob("analysis/friction/*.h"), ROOT / "sweep/study/spec.h",
               ROOT / "sweep/files/toml/requirements_file.cpp"]
    return {key for source in sources for key in visit.findall(source.read_text(encoding="utf-8"))}


def listed_keys(page):
    """Every part of every path that stands in code quotes."""
    return {part for path in re.findall(r"`([^`\n]+)`", page) for part in re.split(r"[.\[\]]+", path)}


def undescribed(schema, path):
    if path and path[-1] != "]" and not schema.get("description"):
        yield path
    for name, below in schema.get("properties", {}).items():
        yield from undescribed(below, f"{path}.{name}")
    for key, name in (("items", "[]"), ("additionalProperties", ".*")):
        if isinstance(schema.get(key), dict):
            yield from undescribed(schema[key], path + name)


subprocess.run([sys.executable, str(ROOT / "cmake/docs.py"), "check", sys.argv[1]], check=True)
reference, method = text_of("docs/reference.md"), text_of("docs/method.md")

keys = declared_keys()
assert len(keys) > 100, keys
wrong += [f"docs/reference.md: {key} is missing" for key in sorted(keys - listed_keys(reference))]
for column in re.findall(r'^    \{"(\w+)", &Record', text_of("sweep/files/records/signals.cpp"), re.MULTILINE):
    if f"| `{column}` |" not in reference:
        wrong.append(f"docs/reference.md: the column {column} is missing")
for column in re.findall(r'^    (?:coded|numbered)<?[^(]*\("(\w+)"', text_of("analysis/results/point.cpp"), re.MULTILINE):
    if f"| `{column}` |" not in reference:
        wrong.append(f"docs/reference.md: results.nc's {column} is missing")

for name in docs.SCHEMAS:
    schema = json.loads(text_of(f"docs/schema/{name}.schema.json"))
    wrong += [f"{name}.schema.json: {path} has no description" for path in undescribed(schema, "")]

policy = re.sub(r"//.*", "", "".join(path.read_text(encoding="utf-8") for path in docs.house_policy.headers(ROOT)))
numbers = re.findall(r"\.?(\w+) = [-+]?\d[\d.e]*", policy)
assert len(numbers) > 15, numbers
wrong += [f"docs/method.md: {name} is missing" for name in numbers if f"`{name}`" not in method]
wrong += [f"docs/method.md: {name} has no reason" for name in re.findall(r"^\| `([^`]+)` \| [^|]* \|\s*\|$", method, re.MULTILINE)]
wrong += [f"docs/method.md: {name} has no reason" for name in re.findall(r"^\| (`[^|]+) \| [^|]* \| [^|]+ \|\s*\| [^|]+ \|$", method, re.MULTILINE)]
without = len(re.findall(r"\| – \|$", method, re.MULTILINE))

page = text_of("docs/library.md")
for header in sorted((ROOT / "include/stickslip").glob("*.h")):
    if header.name != "stickslip.h" and f"\n## `<stickslip/{header.name}>`\n" not in page:
        wrong.append(f"docs/library.md: {header.name} is missing")
for name in ("linear_verdict", "simulate", "locate_boundaries", "diagnose", "read_joint", "ParallelFor"):  # one of each room
    if not re.search(rf"```cpp\n[^`]*\b{name}\b", page):
        wrong.append(f"docs/library.md: {name} is missing")

wrong += [f"<stickslip/{header}>: no /// describes {what}" for header, what in library.undocumented(ROOT)]
assert library.undocumented_in("struct Two {\n    int one = 1;  ///< said\n    int other = 2;\n};\n\nint three();\n") == [
    "struct Two", "struct Two: int other = 2;", "int three();"]

site = text_of("mkdocs.yml")
for page in sorted((ROOT / "docs").rglob("*.md")):
    name = page.relative_to(ROOT / "docs").as_posix()
    if f": {name}\n" not in site + "\n":
        wrong.append(f"mkdocs.yml: {name} stands nowhere in nav")
    words = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", words):
        if not (page.parent / target).exists() and target.removeprefix("pictures/") not in docs.drawn():
            wrong.append(f"docs/{name}: leads to {target}, which does not exist")

# what the troubleshooting page quotes is what the program says
literals = "".join(re.sub(r'"\s*\n\s*"', "", path.read_text(encoding="utf-8"))
                   for room in ("analysis", "sweep") for path in sorted((ROOT / room).rglob("*.cpp")))
quoted = [phrase for row in re.findall(r"^\| ([^|]*) \|", text_of("docs/troubleshooting.md"), re.MULTILINE)
          for phrase in re.findall(r'"([^"]+)"', row)]
assert len(quoted) > 5, quoted
wrong += [f"docs/troubleshooting.md: \"{part.strip()}\" is not what the program says" for phrase in quoted
          for part in phrase.split("…") if part.strip(" :;?") and part.strip(" ;?") not in literals]

print("\n".join(wrong))
print(f"{len(keys)} keys, {len(numbers)} thresholds, {without} rows without evidence of their own, {len(wrong)} complaints")
sys.exit(1 if wrong else 0)
