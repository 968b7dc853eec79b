#!/bin/sh
# The full blind protocol with fresh seeds: make blind test cases with both engines, let the program diagnose them without the
# answers, open the answers and score.
#   tests/blind/run.sh BUILD OUT [CASES]      CASES: how many of the own engine (default 60); MuJoCo makes half as many
# A run is repeated with the seeds it printed: SEED=… tests/blind/run.sh …
set -eu
build=$(cd "$1" && pwd)
out=$2
cases=${3:-60}
here=$(cd "$(dirname "$0")" && pwd)
seed=${SEED:-$(od -An -N4 -tu4 /dev/urandom | tr -d ' ')}
echo "SEED=$seed"
mkdir -p "$out"
(cd "$here/mujoco" && npm ci --no-audit --no-fund --loglevel=error && node check.mjs)

"$build/tests/blind/blind_generate" --match --cases 8 --seed "$seed" --mujoco "$here/mujoco"
make() { "$build/tests/blind/blind_generate" "$out/cases" --truth "$out/truth.json" --seed "$seed" "$@"; }
make --cases "$cases"
make --first "$cases" --cases $((cases / 2)) --engine mujoco --mujoco "$here/mujoco"
"$build/sweep/stickslip" blind "$out/cases"
"$build/tests/blind/blind_score" "$out/truth.json" "$out/cases/answers.json" --json "$out/score.json"
