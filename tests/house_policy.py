"""Numbers of the diagnosis: in the policy each says what supports it, beside the policy each says that it is numerical.

A comment /// above a number of the policy gives its reason and, after "Evidence:", what was seen, or after "Definition:" the
word whose meaning it fixes, or begins with "numerical:" and why it only costs or saves time. A member of a struct has a
comment of its own; an entry of a list gives its reason in a string.
"""
import re
from pathlib import Path

POLICY = "analysis/diagnosis/policy"
SINGLE = re.compile(r"inline constexpr (?:double|int|std::size_t) ")
MEMBER = re.compile(r"\.(\w+) = [-+]?[\d.]")
ENTRY = re.compile(r'\w+\{"([^"]+)", "([^"]+)", ')
SUPPORTED = re.compile(r"(Evidence|Definition): *\S")
NUMERICAL = re.compile(r"^ *numerical: *\S")
NONE_YET = "Evidence: none yet"


def headers(source):
    """The files of the policy, in which thresholds stand; rules.h names the numbers of the ladder only."""
    return sorted(path for path in (Path(source) / POLICY).glob("*.h") if path.name != "rules.h")


def numbers(lines):
    """(line, name, comment, how many share that comment, whether its reason stands there) of every number of the policy."""
    comment = ""
    for place, line in enumerate(lines, 1):
        text = line.strip()
        if text.startswith("///"):
            comment += text[3:]
            continue
        if SINGLE.match(text):
            names = re.findall(r"(\w+) =", text.split("//")[0])
            yield place, names[0] if names else text, comment, max(1, len(names)), True
        elif member := MEMBER.match(text):
            yield place, member.group(1), comment, len(re.findall(r"\.\w+ =", text)), True
        elif entry := ENTRY.match(text):
            yield place, ".".join(entry.groups()), comment, 1, False
        comment = ""


def complaints(path, lines):
    for place, name, comment, count, reasoned in numbers(lines):
        where = f"{path}:{place}: {name}"
        if count > 1:
            yield f"{where} and {count - 1} more share a comment; each number has its own"
        elif NUMERICAL.match(comment):
            continue
        elif reasoned and "Reason:" not in comment:
            yield f"{where} is a threshold without a reason"
        elif not SUPPORTED.search(comment):
            yield f"{where} is a threshold with neither evidence nor the word that it defines"


def kinds(lines):
    """How many numbers of the policy there are of each kind, and the names of those without evidence."""
    counts, without = {"evidence": 0, "definition": 0, "numerical": 0, "none yet": 0}, []
    for _, name, comment, _, _ in numbers(lines):
        if NUMERICAL.match(comment):
            counts["numerical"] += 1
        elif NONE_YET in comment:
            counts["none yet"] += 1
            without.append(name)
        else:
            counts["evidence" if "Evidence:" in comment else "definition"] += 1
    return counts, without


OWN = re.compile(r"constexpr (?:double|std::array<double, [^>]+>) ")
SAID = re.compile(r"numerical: *\S")


def beside(path, lines):
    """A number of the diagnosis outside the policy that does not say, on its line or in the comment above it, that it is
    numerical and why."""
    said = False
    for place, line in enumerate(lines, 1):
        code, _, comment = line.partition("//")
        if not code.strip():
            said = said or bool(SAID.search(comment)) if comment else False
            continue
        if OWN.search(code) and not said and not SAID.search(comment):
            yield f"{path}:{place}: a number beside the policy; thresholds stand in {POLICY}, others say \"// numerical: WHY\""
        said = False
