#!/bin/sh
# The small fixed set for CI: ten cases that never change, diagnosed without the answers and scored. Seconds to make.
#   tests/blind/fixed.sh BUILD OUT
# With GENERATE_ONLY=1 it stops before the diagnosis.
set -eu
build=$1
out=$2
rm -rf "$out"
mkdir -p "$out"
make() { "$build/tests/blind/blind_generate" "$out/cases" --state clean --seed 1991 --truth "$out/truth.json" --first "$1" --cases "$2" --kind "$3"; }
make 0 5 single
make 5 2 pair
make 7 2 none
make 9 1 outside
[ -n "${GENERATE_ONLY:-}" ] && exit 0
"$build/sweep/stickslip" blind "$out/cases"
"$build/tests/blind/blind_score" "$out/truth.json" "$out/cases/answers.json" --json "$out/score.json"
