#!/usr/bin/env python3
"""Pages of docs/ that are made from the code: reference.md, method.md, gallery.md and library.md; and the site with its pictures.
Run: docs.py write|check PROGRAM, docs.py site PROGRAM FOLDER

reference.md: what the program says of its keys (stickslip list keys --markdown), then every field of its JSON answers from
docs/schema. method.md: every threshold of analysis/diagnosis/policy/ with the comment that gives its reason. site: a copy of docs/ in FOLDER/docs with the
pictures that the program draws for it and the notebooks as pages, and FOLDER/site where mkdocs is installed.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import library
import notebooks

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "tests"))
import house_policy

ROOT = pathlib.Path(__file__).parent.parent
MADE = "<!-- Made by `cmake --build build --target docs_text`; a change here is overwritten. -->\n\n"
LIMITS = "analysis/base/work_limits.h"
SCHEMAS = ("evaluate", "sweep-run", "boundary", "margins", "design", "baseline", "diagnosis", "robot-diagnosis",
           "gap-baseline", "gap-check", "comparison", "timeline", "set-point-design", "plan", "motion", "import", "export",
           "list", "figures", "answers", "score", "calibration", "sweep-plan", "run")
DRAWN_AGAIN = ("sweep-answer", "drawn-charts")  # long, and for the program alone
REFERENCE = """# Reference

Every key of a joint file, a spec and a `[record]` table, every column and every field of the JSON answers. Units are SI, those of
a revolute joint in brackets. Text with a unit (`V0 = "1 mm/s"`) is converted where a number is expected. A default of – means: not
set. On the terminal, for one joint: `stickslip list keys --model two-mass --law stribeck`, or `--joint joint.toml`.

"""
JSON_HEAD = """
## Fields of the JSON answers

A number that does not exist is `null`. `[]` stands for the entries of a list, `*` for a name. The schemas are in `docs/schema`, including
`sweep-answer.schema.json` for `answer.json` (the input of `stickslip report`) and `drawn-charts.schema.json` for `charts/drawn.json`. Every answer has a
`format` with a version, except `answers.json`, whose names are those of the cases.
"""
METHOD = """# Thresholds of the diagnosis

[How the diagnosis works](how-the-diagnosis-works.md) describes the method. This page lists every threshold that decides an answer, from
`{policy}`, with its unit, its reason and its evidence. What a threshold is compared with in blind cases is measured again by
`tests/evidence`. A definition has no evidence and needs none: it says what a word of the answer means, and another number would give the word
another meaning.

Of {all} numbers {evidence} have evidence of their own, {definition} are definitions and {numerical} numerical. {missing}
"""
LIMITS_HEAD = """
## Limits of work

Searches and simulations stop at these limits (`{limits}`) and are then reported as undecided. They decide no other answer, so that a larger one
changes only how long it takes until that is said.

"""


def row(*cells):
    return "| " + " | ".join(cell.replace("|", "\\|") for cell in cells) + " |\n"


def type_of(schema):
    if "const" in schema:
        return f"`{schema['const']}`"
    kind = schema.get("type", "value")
    return " or ".join(kind) if isinstance(kind, list) else kind


def fields_of(schema, path=""):
    """(path, schema) of every field below, in order."""
    for name, below in schema.get("properties", {}).items():
        yield from field(f"{path}.{name}" if path else name, below)
    if isinstance(schema.get("additionalProperties"), dict):
        yield from field(f"{path}.*", schema["additionalProperties"])
    if isinstance(schema.get("items"), dict):
        yield from fields_of(schema["items"], path + "[]")


def field(path, schema):
    yield path, schema
    yield from fields_of(schema, path)


def json_section():
    text = JSON_HEAD
    for name in SCHEMAS:
        schema = json.loads((ROOT / "docs/schema" / f"{name}.schema.json").read_text(encoding="utf-8"))
        text += f"\n### {schema['title']}\n\n" + row("Field", "Type", "Unit", "Meaning") + row("---", "---", "---", "---")
        for path, below in fields_of(schema):
            text += row(f"`{path}`", type_of(below), below.get("unit", "–"), below["description"])
    return text


def reference(program):
    keys = subprocess.run([program, "list", "keys", "--markdown"], capture_output=True, text=True, check=True).stdout
    return MADE + REFERENCE + keys + json_section()


def declarations(source):
    """(comment, statement) of every constant; the statement keeps the comments of its lines."""
    comment, lines, statement = [], source.splitlines(), None
    for line in lines:
        stripped = line.strip()
        if statement is None:
            if stripped.startswith("///"):
                comment.append(stripped[3:].strip())
                continue
            if not stripped.startswith("inline constexpr"):
                comment = []
                continue
            statement = []
        statement.append(line)
        if stripped.split("//")[0].rstrip().endswith(";"):
            yield " ".join(comment), "\n".join(statement)
            comment, statement = [], None


def entries(statement):
    """(comment, text) of every member of a struct and every entry of a list: `.name = value` or `Type{...}`."""
    comment, text = [], ""
    for line in map(str.strip, statement.splitlines()[1:-1]):
        if line.startswith("///"):
            comment.append(line[3:].strip())
            continue
        text += line
        if text.endswith((",", "},")) and text.count("{") == text.count("}"):
            yield " ".join(comment), text.rstrip(",")
            comment, text = [], ""


def rows_of_fields(statement):
    for comment, text in entries(statement):
        if member := re.match(r"\.(\w+) = ([^{]+)$", text):
            yield [(member[1], member[2])], comment


def rows_of_ranges(statement):
    pattern = r'\w+\{"([^"]+)", "([^"]+)", ([^,]+), ([^,]+), Per::(\w+),\s*((?:"[^"]*"\s*)+)\}'
    for comment, text in entries(statement):
        if found := re.match(pattern, text):
            effect, parameter, low, high, per, reason = found.groups()
            top = "–" if float(high) >= 1e9 else high
            yield (f"`{effect}.{parameter}`", low, top, per.replace("_", " "), "".join(re.findall(r'"([^"]*)"', reason)),
                   reasoned(comment)[2])


def constants(statement):
    """Names and values of `double a = 1, b = 2;`."""
    body = re.sub(r"//.*", "", statement).split("=", 1)
    head = body[0].split()[-1] + " =" + body[1].rstrip().rstrip(";")
    return re.findall(r"(\w+)\s*=\s*([^,]+)", " ".join(head.split()))


def reasoned(comment):
    """What a threshold is, its reason and its evidence, apart."""
    if comment.startswith("numerical: "):
        what, _, why = comment.removeprefix("numerical: ").partition(". ")
        return what[:1].upper() + what[1:] + ".", why, "**numerical**"
    what, _, rest = f" {comment}".partition(" Reason: ")
    why, kind, said = re.match(r"(.*?)(?: ?(Evidence|Definition): (.*))?$", rest or what).groups("")
    if kind == "Definition":
        said = "**definition**: " + said
    elif said.startswith("none yet"):
        said = "**none yet**" + said.removeprefix("none yet")
    return what.strip() if rest else "", why[:1].upper() + why[1:], said[:1].upper() + said[1:]


def tables_of(header):
    """What a header of the policy decides, and a table of its single thresholds before those of its lists."""
    source = header.read_text(encoding="utf-8")
    what = " ".join(line[3:] for line in source.split("#pragma")[0].splitlines())
    lists, single = "", []
    for comment, statement in declarations(source):
        name = re.search(r"(\w+)\s*(?:=|\{)", re.sub(r"inline constexpr (?:std::)?", "", statement, count=1)).group(1)
        ranges, fields = list(rows_of_ranges(statement)), list(rows_of_fields(statement))
        title = f"\n### {name.replace('_', ' ').capitalize()}\n\n" + (comment + "\n\n" if comment else "")
        if ranges:
            lists += title + row("Parameter", "Least", "Most", "Counted in", "Reason", "Evidence") + row(*["---"] * 6)
            lists += "".join(row(*entry) for entry in ranges)
        elif fields:
            lists += title + table_of((values, words) for values, words in fields if words)
        else:
            single.append((constants(statement), comment))
    return f"\n## {header.stem.replace('_', ' ').capitalize()}\n\n{what}\n\n" + table_of(single) + lists


def method():
    headers = house_policy.headers(ROOT)
    counts, without = house_policy.kinds([line for path in headers for line in path.read_text(encoding="utf-8").splitlines()])
    missing = "Of some the evidence is a few cases: each row tells how many."
    if without:
        missing = (f"Evidence is missing for {len(without)}: no case on\nthe other side has been seen, or too few. Chosen so far: "
                   + ", ".join(f"`{name}`" for name in without) + ".")
    text = MADE + METHOD.format(policy=house_policy.POLICY + "/", all=sum(counts.values()), evidence=counts["evidence"],
                                definition=counts["definition"], numerical=counts["numerical"], missing=missing)
    text += "".join(map(tables_of, headers))
    limits = declarations((ROOT / LIMITS).read_text(encoding="utf-8"))
    return text + LIMITS_HEAD.format(limits=LIMITS) + table_of(((constants(s), comment) for comment, s in limits), "decides no answer")


def table_of(constants_with_comments, without="–"):
    text = row("Name", "Value", "What it is", "Reason", "Evidence") + row(*["---"] * 5)
    for values, comment in constants_with_comments:
        text += row("<br>".join(f"`{n}`" for n, _ in values), "<br>".join(v.strip() for _, v in values),
                    *(cell or without for cell in reasoned(comment)))
    return text


def blocks(page):
    """What a reader does with a page, in order: (file, name, text), (sh, "", text), (output, "", text)."""
    text = page.read_text(encoding="utf-8")
    fence = re.compile(r"(?:<!-- (file|output)(?:: (\S+))? -->\n)?```(\w+)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
    for kind, name, language, body in fence.findall(text):
        if kind or language == "sh":
            yield kind or language, name, body


# picture in docs/pictures: the spec that is swept, and which of its charts it is
PICTURES = {
    "tutorial-map.svg": ("tutorial.md: spec.toml", "map-k-p-k-v.svg"),
    "reference-map.svg": ("examples/01-reference-joint/spec.toml", "map-k-p-k-v.svg"),
}


# the gallery: commands (the last one writes a page into the folder OUT), and charts of that page with their captions
REAL_LOOP = ("--set control.period=1e-3 --set control.delay=1e-3 "
             "--set 'control.velocity_estimate.form=\"backward-difference\"'")
MOTION = ("awk 'BEGIN { print \"time,reference_position\"; "
          "for (i = 0; i < 8000; ++i) print i / 1000 \",\" 0.1 * (1 - cos(1.5e-3 * i)) }' > motion.csv")
GALLERY = [
    (["stickslip sweep -o OUT"], [
        ("map-k-p-k-v", "Stability over two gains, with frictional memory and by the velocity-only model"),
        ("panels-k-p-k-v", "The same map at six velocities"),
        ("root-locus", "Root locus over the position gain; on the page each point shows its gain"),
        ("k-v-demanded", "The velocity gain that each model requires"),
    ]),
    ([f"stickslip evaluate examples/01-reference-joint/spec.toml {REAL_LOOP} -o OUT"], [
        ("map-k-p-k-v", "The same joint in a loop of 1 kHz with one tick of dead time, compared with the "
                        "ideal loop of the paper"),
    ]),
    (["stickslip sweep examples/03-bistable-strip/spec.toml -o OUT"], [
        ("map-k-p-k-v", "Between the two boundaries small disturbances decay and larger ones end in stick-slip"),
        ("amplitude-k-p-k-v", "Amplitude of the stick-slip motion"),
    ]),
    (["stickslip simulate examples/03-bistable-strip/spec.toml --set control.k_p=15e3 --set control.k_v=45 -o OUT"], [
        ("path", "Position and reference of a joint that sticks and slips, and the control force"),
        ("loop", "Friction over velocity: the simulated motion, and the steady curve"),
    ]),
    (["stickslip boundary examples/03-bistable-strip/spec.toml --kind linear fold --over control.k_p control.k_v -o OUT"], [
        ("boundaries-k-p-k-v", "Located boundaries: loss of stability, and onset of limit cycles"),
    ]),
    (["stickslip boundary examples/08-hunting-arm/joint.toml --set control.V0=0 --set control.k_i=900 --kind hunting "
      "--over control.k_p=10..1e4 control.k_i=10..1e5 -o OUT"], [
        ("hunting-k-p-k-i", "Hunting at a set point over two gains"),
        ("hunting-amplitude-k-p-k-i", "Distance of the stops from the set point"),
    ]),
    (["stickslip design examples/04-design/spec.toml -o OUT"], [
        ("map-k-p-k-v", "The best gains on the stability map"),
        ("noise-against-margin", "Sensor noise against stability margin"),
    ]),
    (["stickslip margins examples/04-design/spec.toml -o OUT"], [
        ("growth-by-parameter", "Growth rate against the change of each parameter"),
    ]),
    ([MOTION,
      "stickslip simulate examples/07-measured-machines/emps.toml --set friction.coulomb=26 "
      "--set load.cogging.amplitude=4 --set load.cogging.periods=100 --reference motion.csv -o robot",
      "stickslip diagnose examples/07-measured-machines/emps.toml robot/record.csv -o OUT"], [
        ("where-drawn", "Where along the control chain a gap lies"),
        ("ladder", "The ladder of causes: share of each, and the remainder"),
        ("record-1-effort", "The largest error of the documented joint, before and after the cause is added"),
    ]),
]


def gallery_pictures():
    """(commands, [(name of the picture, chart, words)]) of every entry; the name distinguishes two pages of one verb."""
    for number, (commands, charts) in enumerate(GALLERY, 1):
        verb = commands[-1].split()[1]
        yield commands, [(f"gallery-{number}-{verb}-{chart}.svg", chart, words) for chart, words in charts]


def drawn():
    """Names of all pictures that the site draws."""
    return {*PICTURES, *(name for _, charts in gallery_pictures() for name, _, _ in charts)}


def gallery():
    text = MADE + "# Gallery\n\nCharts of the examples. The commands above each chart draw it, run from the project folder.\n"
    for commands, charts in gallery_pictures():
        text += "\n```sh\n" + "\n".join(commands).replace("OUT", "out") + "\n```\n"
        for name, _, words in charts:
            text += f"\n![{words}](pictures/{name})\n\n{words}.\n"
    return text


def draw_gallery(program, folder):
    """Every entry in a folder of its own from which the examples can be read and in which its commands write."""
    environment = {**os.environ, "PATH": f"{pathlib.Path(program).parent}:{os.environ['PATH']}"}
    for commands, charts in gallery_pictures():
        with tempfile.TemporaryDirectory() as room:
            pathlib.Path(room, "examples").symlink_to(ROOT / "examples")
            subprocess.run(["sh", "-euc", "\n".join(commands).replace("OUT", "out")], cwd=room, env=environment,
                           stdout=subprocess.DEVNULL, check=True)
            for name, chart, _ in charts:
                shutil.copy(f"{room}/out/charts/{chart}.svg", folder / name)


def draw(program, folder):
    folder.mkdir(parents=True, exist_ok=True)
    draw_gallery(program, folder)
    for picture, (spec, chart) in PICTURES.items():
        with tempfile.TemporaryDirectory() as room:
            if ": " in spec:
                page, spec = spec.split(": ")
                for kind, name, text in blocks(ROOT / "docs" / page):
                    if kind == "file":
                        pathlib.Path(room, name).write_text(text, encoding="utf-8")
                spec = pathlib.Path(room, spec)
            subprocess.run([program, "sweep", str(spec), "-o", f"{room}/out"], cwd=ROOT, stdout=subprocess.DEVNULL, check=True)
            shutil.copy(f"{room}/out/charts/{chart}", folder / picture)


def site(program, folder):
    copy = folder / "docs"
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(ROOT / "docs", copy)
    for page in copy.rglob("*.md"):  # the sources that a page names are not on the site
        text = page.read_text(encoding="utf-8")
        page.write_text(re.sub(r"\[([^\]]+)\]\((?:\.\./)+(?:analysis|sweep|render|tests)/[^)]*\)", r"\1", text), encoding="utf-8")
    draw(program, copy / "pictures")
    notebooks.write_pages(program, copy)
    settings = (ROOT / "mkdocs.yml").read_text(encoding="utf-8")
    settings = settings.replace("site_dir: build/site", "site_dir: site")
    (folder / "mkdocs.yml").write_text(settings, encoding="utf-8")
    if shutil.which("mkdocs"):
        subprocess.run(["mkdocs", "build", "--strict", "--quiet", "-f", str(folder / "mkdocs.yml")], check=True)
        print(f"{folder}/site/index.html")
    else:
        print(f"mkdocs is not installed (apt-get install mkdocs): the pages with their pictures are in {copy}")


def main():
    what, program = sys.argv[1], str(pathlib.Path(sys.argv[2]).resolve())
    if what == "site":
        return site(program, pathlib.Path(sys.argv[3]).resolve())
    pages = {"docs/reference.md": reference(program), "docs/method.md": method(), "docs/gallery.md": gallery(),
             "docs/library.md": MADE + library.library(ROOT)}
    stale = []
    for name, text in pages.items():
        path = ROOT / name
        if what == "write":
            path.write_text(text, encoding="utf-8")
        elif not path.exists() or path.read_text(encoding="utf-8") != text:
            stale.append(name)
    if stale:
        sys.exit(f"{', '.join(stale)}: not what the code says; cmake --build build --target docs_text")


if __name__ == "__main__":
    main()
