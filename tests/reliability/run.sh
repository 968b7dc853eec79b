#!/bin/bash
# Every heavy check by one command, each printing its figures. Run: run.sh BUILD [scale], e.g. tests/reliability/run.sh build 10
set -u
here=$(realpath "$(dirname "$0")") build=$(realpath "$1") scale=${2:-1}
program=$build/sweep/stickslip mpi_program=$build/sweep/stickslip-mpi failed=0
check() {
    echo "== $1"
    shift
    "$@"
    code=$?
    [ $code -eq 0 ] || [ $code -eq 77 ] || failed=$((failed + 1))
}
check "faults" "$here/faults.sh" "$program" $((20 * scale))
check "power" "$here/power.sh" "$program" $((20 * scale))
check "memory" "$here/memory.sh" "$program" $((10000000 * scale))
check "extremes" "$here/extremes.py" "$program" $((300 * scale))
check "silence" "$here/silence.py" "$program" $((3 * scale))
check "points" "$build/tests/reliability/reliability_points" --points $((100000 * scale)) --nonlinear $((1000 * scale)) \
    "$here"/../fuzz/corpus/joint/*.toml
check "consistency" "$build/tests/reliability/reliability_consistency" --joints $((10000 * scale)) --log "$build/consistency.log"
check "verbs about loops" "$build/tests/reliability/reliability_consistency" --loops --joints $((500 * scale)) \
    --log "$build/consistency-loops.log"
check "roots of loops" "$build/tests/reliability/reliability_consistency" --roots --joints $((1000 * scale))
check "loops" "$here/loops.py" "$build/tests/reliability/reliability_loops" $((250 * scale)) 2
check "hunting" "$build/tests/reliability/reliability_hunting" --loops $((1000 * scale))
for target in "$here"/../fuzz/corpus/*; do
    target=$(basename "$target")
    check "inputs: $target" "$build/tests/fuzz/fuzz_$target" --inputs $((100000 * scale)) "$here/../fuzz/corpus/$target"
done
if [ -x "$mpi_program" ]; then
    check "engines" "$here/../cluster/engines.sh" "$program" "$mpi_program"
    check "slurm" "$here/slurm.sh" "$program" "$mpi_program"
fi
[ $failed -eq 0 ] && echo "all sound" || echo "$failed checks failed"
exit $failed
