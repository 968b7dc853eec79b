#!/usr/bin/env python3
"""The house test complains where it should: small trees with one fault each. Run: house_test.py"""
import subprocess
import sys
import tempfile
from pathlib import Path

HOUSE = Path(__file__).parent / "house.py"
EXCEPTIONS = "tests/house_exceptions.toml"
POLICY = "analysis/diagnosis/policy/verdict.h"
GOOD = {"analysis/base/law.h": "// A law.\n#pragma once\n"}


def body(lines, name="walk"):
    """A function of that many lines from brace to brace."""
    return f"void {name}()\n{{\n" + "    step();\n" * (lines - 2) + "}\n"


RIGHTS = """version = 1
[[annotations]]
path = "**"
SPDX-FileCopyrightText = "us"
SPDX-License-Identifier = "MIT"
"""

# A name, the files that make the fault, and what the house says of it: nothing where it is none.
CASES = [
    ("nothing wrong", {}, None),
    ("a long file without a reason", {"analysis/base/law.cpp": "// x\n" * 251}, "law.cpp: has 251 lines; part it"),
    ("a long file with one", {"analysis/base/law.cpp": "// In one file: one law.\n" + "// x\n" * 250}, None),
    ("a reason that a short file does not need", {"analysis/base/law.cpp": "// In one file: one law.\n"}, "is not needed"),
    ("a tall file that is not listed", {"analysis/base/law.cpp": "// In one file: one law.\n" + "// x\n" * 400},
     "law.cpp: has 401 lines, above 400, and no reason"),
    ("a tall file that is listed", {"analysis/base/law.cpp": "// In one file: one law.\n" + "// x\n" * 400,
                                    EXCEPTIONS: '[tall_files]\n"analysis/base/law.cpp" = "one law"\n'}, None),
    ("one that is listed without a word", {"analysis/base/law.cpp": "// In one file: one law.\n" + "// x\n" * 400,
                                           EXCEPTIONS: '[tall_files]\n"analysis/base/law.cpp" = " "\n'}, "and no reason"),
    ("a tall script", {"tests/check.py": "x = 1\n" * 401}, "check.py: has 401 lines, above 400"),
    ("a file listed for nothing", {EXCEPTIONS: '[tall_files]\n"analysis/base/law.h" = "one law"\n'}, "no more than 400 lines"),
    ("a long function without a reason", {"analysis/base/law.cpp": body(61)}, "walk() has 61 lines; part it"),
    ("one of 60 lines", {"analysis/base/law.cpp": body(60)}, None),
    ("a long function with a reason, not listed", {"analysis/base/law.cpp": "// In one piece: a table.\n" + body(61)},
     "walk() has 61 lines and is not among the long functions"),
    ("a long function with a reason, listed",
     {"analysis/base/law.cpp": "// In one piece: a table.\n" + body(61),
      EXCEPTIONS: '[long_functions]\n"analysis/base/law.cpp" = ["walk"]\n'}, None),
    ("a function listed for nothing",
     {"analysis/base/law.cpp": body(10), EXCEPTIONS: '[long_functions]\n"analysis/base/law.cpp" = ["walk"]\n'},
     "lists walk() of analysis/base/law.cpp, which is not long"),
    ("functions listed of a file that is gone", {EXCEPTIONS: '[long_functions]\n"analysis/base/gone.cpp" = ["walk"]\n'},
     "lists functions of analysis/base/gone.cpp, which is not there"),
    ("a long function of a test", {"tests/analysis/law.h": body(61)}, "walk() has 61 lines; part it"),
    ("a test in another room", {"tests/analysis/joint/law_test.cpp": '#include "analysis/base/law.h"\n'},
     "includes nothing of analysis/joint"),
    ("a test in the room that it tests", {"tests/analysis/base/law_test.cpp": '#include "analysis/base/law.h"\n'}, None),
    ("an arrow upwards", {"analysis/base/law.cpp": '#include "sweep/study/spec.h"\n'}, "lies on a floor above"),
    ("a circle", {"analysis/base/law.cpp": '#include "analysis/joint/joint.h"\n',
                  "analysis/joint/joint.h": '#pragma once\n#include "analysis/base/law.h"\n'}, "in a circle"),
    ("a circle of two rooms, none of their folders",
     {"analysis/base/low/a.h": "#pragma once\n", "analysis/joint/low/a.h": "#pragma once\n",
      "analysis/base/high/b.cpp": '#include "analysis/joint/low/a.h"\n',
      "analysis/joint/high/b.cpp": '#include "analysis/base/low/a.h"\n'}, "in a circle"),
    ("a header that is no door of its folder",
     {"tests/house_doors.toml": '"analysis/joint" = ["joint.h"]\n', "analysis/joint/joint.h": "#pragma once\n",
      "analysis/joint/own.h": "#pragma once\n",
      "analysis/base/law.cpp": '#include "analysis/joint/joint.h"\n#include "analysis/joint/own.h"\n'},
     "which is no door of its folder"),
    ("a door that nobody uses", {"tests/house_doors.toml": '"analysis/joint" = ["joint.h"]\n',
                                 "analysis/joint/joint.h": "#pragma once\n"}, "a door that no other folder uses"),
    ("a header from inside another room", {"analysis/joint/own.h": "// Internal to analysis/joint.\n#pragma once\n",
                                           "analysis/base/law.cpp": '#include "analysis/joint/own.h"\n'},
     "which is internal to analysis/joint"),
    ("a verb that includes CLI11", {"sweep/program/verbs/list.cpp": "#include <CLI/CLI.hpp>\n"}, "by way of command_line.h"),
    ("one name for two types", {"analysis/base/law.cpp": "namespace stickslip {\n\nstruct Law {\n};\n\n}  // namespace stickslip\n",
                               "analysis/base/other.h": "#pragma once\nnamespace stickslip {\n\nclass Law : Base {\n};\n\n}  // namespace stickslip\n"},
     "defines stickslip::Law, as does analysis/base/law.cpp:3"),
    ("one name in two namespaces", {"analysis/base/law.cpp": "namespace stickslip {\nnamespace {\n\nstruct Law {\n};\n\n}  // namespace\n}  // namespace stickslip\n",
                                    "analysis/base/other.h": "#pragma once\nnamespace stickslip {\n\nstruct Law {\n};\n\n}  // namespace stickslip\n"},
     None),
    ("a comment that names a file that is gone", {"analysis/base/law.cpp": "// as in analysis/base/gone.h\n"}, "which is not there"),
    ("a comment that cites a paper of nobody", {"tests/analysis/law_test.cpp": "// as in PHYSICS §3\n"}, "cites PHYSICS"),
    ("a bare number in the diagnosis", {"analysis/diagnosis/fit/fit.cpp": "bool good = share > 0.35;\n"}, "compares with a bare number"),
    ("a whole factor in the diagnosis", {"analysis/diagnosis/fit/fit.cpp": "bool still = span <= 8 * resolution;\n"},
     "compares with a bare number"),
    ("a number that the diagnosis chooses", {"analysis/diagnosis/fit/fit.cpp": "double most = coarse ? 2 : 1.25;\n"},
     "chooses a bare number"),
    ("a threshold of a header", {"analysis/diagnosis/fit/fit.h": "#pragma once\ninline constexpr double most = 0.12;\n",
                                 "analysis/diagnosis/fit/fit.cpp": "if (share > most) d.verdict = Verdict::gap;\n"},
     "most decides an answer"),
    ("one that is numerical", {"analysis/diagnosis/fit/fit.h": "#pragma once\ninline constexpr double most = 0.12;  ///< numerical: a scan\n",
                               "analysis/diagnosis/fit/fit.cpp": "if (share > most) d.verdict = Verdict::gap;\n"}, None),
    ("a number of the diagnosis that is not in the policy", {"analysis/diagnosis/fit/fit.cpp": "constexpr double most = 0.12;\n"},
     "fit.cpp:1: a number beside the policy"),
    ("a list of them", {"analysis/diagnosis/fit/fit.cpp": "constexpr std::array<double, 2> most{0.1, 0.2};  // of the travel\n"},
     "fit.cpp:1: a number beside the policy"),
    ("one that is numerical and says no more", {"analysis/diagnosis/fit/fit.cpp": "constexpr double most = 0.12;  // numerical\n"},
     "a number beside the policy"),
    ("one whose comment above says why", {"analysis/diagnosis/fit/fit.cpp": "// numerical: of a scan,\n// in a logarithm\nconstexpr double most = 0.12;\n"},
     None),
    ("a comment that is not above it", {"analysis/diagnosis/fit/fit.cpp": "// numerical: of a scan\nint steps();\nconstexpr double most = 0.12;\n"},
     "fit.cpp:3: a number beside the policy"),
    ("two numbers of the policy with one comment",
     {POLICY: "/// Parts. Reason: so. Evidence: of ten none.\ninline constexpr double most = 0.1, least = 0.2;\n"}, "most and 1 more share a comment"),
    ("a number of the policy without a reason", {POLICY: "/// A part. Evidence: of ten none.\ninline constexpr double most = 0.1;\n"},
     "most is a threshold without a reason"),
    ("one with the evidence of another", {POLICY: "/// A part. Reason: so. Evidence: of ten none.\ninline constexpr double most = 0.1;\n"
                                                 "inline constexpr std::size_t least = 2;\n"}, "verdict.h:3: least is a threshold without a reason"),
    ("one without evidence", {POLICY: "/// A part. Reason: so. Evidence:\ninline constexpr double most = 0.1;\n"},
     "most is a threshold with neither evidence"),
    ("one that is a definition", {POLICY: "/// A part. Reason: so. Definition: most.\ninline constexpr double most = 0.1;\n"}, None),
    ("one that is numerical in the policy", {POLICY: "/// numerical: of a search.\ninline constexpr int most = 3;\n"}, None),
    ("a member of a struct with the evidence of the whole",
     {POLICY: "/// Parts. Reason: so. Evidence: of ten none.\ninline constexpr Rules rules{\n    .most = 0.1,  // a part\n};\n"},
     "verdict.h:3: most is a threshold without a reason"),
    ("a member with its own", {POLICY: "/// Parts.\ninline constexpr Rules rules{\n    /// A part. Reason: so. Evidence: of ten none.\n    .most = 0.1,\n"
                                       "    .others = other_rules,\n};\n"}, None),
    ("an entry of a list without evidence", {POLICY: 'inline constexpr std::array ranges{\n    Range{"play", "width", 0, 1, "so"},\n};\n'},
     "verdict.h:2: play.width is a threshold with neither evidence"),
    ("a page that reads the policy", {"sweep/words/text.cpp": '#include "analysis/diagnosis/policy/verdict.h"\n'}, None),
    ("licences with their texts", {"REUSE.toml": RIGHTS, "LICENSES/MIT.txt": "MIT\n"}, None),
    ("a licence without its text", {"REUSE.toml": RIGHTS}, "LICENSES/MIT.txt is not there"),
    ("the text of a licence that no file has", {"REUSE.toml": RIGHTS, "LICENSES/MIT.txt": "MIT\n", "LICENSES/ISC.txt": "ISC\n"}, "LICENSES/ISC.txt: is the licence of no file"),
    ("files without a licence", {"REUSE.toml": RIGHTS.replace("**", "analysis/**"), "LICENSES/MIT.txt": "MIT\n"}, "files have no licence"),
    ("a licence of a file that is gone", {"REUSE.toml": RIGHTS + RIGHTS.split("\n", 1)[1].replace("**", "gone.h"), "LICENSES/MIT.txt": "MIT\n"}, "names gone.h, which"),
    ("files without a holder", {"REUSE.toml": RIGHTS.replace('"us"', '""'), "LICENSES/MIT.txt": "MIT\n"}, "** has no SPDX-FileCopyrightText"),
    ("a version that was left behind", {"CITATION.cff": "version: 0.1.0\n", "CHANGELOG.md": "# Changelog\n\n## 0.2.0\n"}, "CITATION.cff has 0.1.0, CHANGELOG.md has 0.2.0"),
    ("words in a refusal of the diagnosis", {"analysis/diagnosis/fit/fit.cpp": 'throw std::runtime_error("no");\n'}, "refuses with words"),
]


def answer(files):
    with tempfile.TemporaryDirectory() as folder:
        for name, text in {**GOOD, **files}.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        run = subprocess.run([sys.executable, HOUSE, folder], capture_output=True, text=True)
        return run.returncode, run.stdout + run.stderr


wrong = 0
for name, files, expected in CASES:
    code, said = answer(files)
    if (code, "0 complaints" in said) != ((0, True) if expected is None else (1, False)) or (expected or "") not in said:
        wrong += 1
        print(f"{name}: expected {'no complaint' if expected is None else repr(expected)}, got exit code {code} and\n{said}")
print(f"{len(CASES)} trees, {wrong} judged wrongly")
sys.exit(1 if wrong else 0)
