#!/usr/bin/env python3
"""What thresholds were compared with, and whether answers changed, from the lines that `thresholds` prints.

    build/tests/evidence/thresholds CASES/* >lines                      every threshold as it is
    tests/evidence/thresholds.py lines                                  a table: values on either side, within a factor
                                                                        of two, the nearest and the furthest
    build/tests/evidence/thresholds NAME=VALUE CASES/* >changed         the same cases with another value
    tests/evidence/thresholds.py changed --before lines                 the answers that differ
    build/tests/evidence/thresholds_of_tests "[gap]" 2>lines            the same of tests of the diagnosis
    tests/evidence/thresholds.py lines --truth truth.json               how often the first answer of each probability is right
"""
import argparse
import json
from collections import defaultdict


def lines_of(file):
    with open(file, encoding="utf-8") as text:
        return {line["case"]: line for line in map(json.loads, text)}


def table(cases):
    sides = ("below", "above")
    counts, close, furthest = [defaultdict(lambda: dict.fromkeys(sides, 0)) for _ in range(3)]
    nearest = defaultdict(lambda: {side: [] for side in sides})
    for name, case in cases.items():
        for threshold, of in case["thresholds"].items():
            for side, pick in zip(sides, (min, max)):
                counts[threshold][side] += of[side]["count"]
                close[threshold][side] += of[side]["close"]
                # what is not a number in JSON is infinite, and near nothing
                nearest[threshold][side] += [(value, name) for value in of[side]["nearest"] if value is not None]
                if of[side]["count"] and of[side]["furthest"] is not None:
                    furthest[threshold][side] = pick(furthest[threshold][side] or of[side]["furthest"], of[side]["furthest"])
    print(f"{'threshold':36}{'below':>9}{'above':>9}{'close':>7}  least, nearest below … nearest above, largest")
    for threshold, count in counts.items():
        low = [f"{value:.4g} ({case})" for value, case in sorted(nearest[threshold]["below"])[-3:]]
        high = [f"{value:.4g} ({case})" for value, case in sorted(nearest[threshold]["above"])[:3]]
        print(f"{threshold:36}{count['below']:9}{count['above']:9}{sum(close[threshold].values()):7}  "
              f"{furthest[threshold]['below']:.4g}, {', '.join(low)} … {', '.join(high)}, {furthest[threshold]['above']:.4g}")


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
