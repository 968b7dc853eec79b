#!/usr/bin/env python3
"""What thresholds were compared with, and whether answers changed, from the lines that `thresholds` prints.

    build/tests/evidence/thresholds CASES/* >lines                      every threshold as it is
    tests/evidence/thresholds.py lines                                  a table: the nearest values on either side
    build/tests/evidence/thresholds NAME=VALUE CASES/* >changed         the same cases with another value
    tests/evidence/thresholds.py changed --before lines                 the answers that differ
    build/tests/evidence/thresholds_of_tests "[gap]" 2>lines            the same of tests of the diagnosis
    tests/evidence/thresholds.py lines --truth truth.json               how often the first answer of each probability is right
"""
import argparse
import json
from collections import defaultdict

KEPT = 6  # traced.h


def lines_of(file):
    with open(file, encoding="utf-8") as text:
        return {line["case"]: line for line in map(json.loads, text)}


def table(cases):
    below, above, counts = defaultdict(list), defaultdict(list), defaultdict(int)
    for name, case in cases.items():
        for threshold, sides in case["thresholds"].items():
            for side, all_values in (("below", below), ("above", above)):
                counts[threshold] += sides[side]["count"]
                # what is not a number in JSON is infinite, and near nothing
                all_values[threshold] += [(value, name) for value in sides[side]["nearest"] if value is not None]
    print(f"{'threshold':36}{'compared':>9}  nearest below … nearest above")
    for threshold, count in counts.items():
        low = [f"{value:.4g} ({case})" for value, case in sorted(below[threshold])[-KEPT:]]
        high = [f"{value:.4g} ({case})" for value, case in sorted(above[threshold])[:KEPT]]
        print(f"{threshold:36}{count:9}  {', '.join(low[-3:])} … {', '.join(high[:3])}")


def answer(case):
    return case["verdict"], [(names, round(probability, 3)) for names, probability in case["effects"]]


def differences(cases, before):
    differ = [name for name in cases if name in before and answer(cases[name]) != answer(before[name])]
    for name in differ:
        print(f"{name}: {answer(before[name])}\n    now {answer(cases[name])}")
    print(f"{len(differ)} of {len(cases)} answers differ")


def right(case, truth):
    if case["verdict"] != "gap" or not case["effects"]:
        return case["verdict"] == truth["verdict"]
    return set(case["effects"][0][0]) == set(truth["effects"]) or case["effects"][0][0][0] in truth.get("equivalent", [])


def probabilities(cases, truth):
    counted = defaultdict(lambda: [0, 0])
    for name, case in cases.items():
        first = round(case["effects"][0][1], 3) if case["verdict"] == "gap" and case["effects"] else case["verdict"]
        counted[first][0] += right(case, truth[name])
        counted[first][1] += 1
    for first, (good, count) in sorted(counted.items(), key=str):
        print(f"{first}: {good} of {count} right")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lines")
    parser.add_argument("--before")
    parser.add_argument("--truth")
    given = parser.parse_args()
    cases = lines_of(given.lines)
    if given.before:
        differences(cases, lines_of(given.before))
    elif given.truth:
        with open(given.truth, encoding="utf-8") as text:
            probabilities(cases, json.load(text))
    else:
        table(cases)


main()
