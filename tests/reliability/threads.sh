#!/bin/bash
# The parts that run in parallel, under ThreadSanitizer. It must see inside oneTBB too, or it misses the order between a task and
# whoever waits for it and calls every result a race; so oneTBB is built the same way from its sources (`apt-get source onetbb`).
# Run: threads.sh SOURCE_OF_ONETBB [BUILD]. STICKSLIP_DATA adds a diagnosis of measured records (minutes).
set -eu
root=$(realpath "$(dirname "$0")/../..") onetbb=$(realpath "$1") build=$(realpath -m "${2:-$root/build-threads}")
mkdir -p "$build"
{
    cmake -S "$onetbb" -B "$build/onetbb" -DTBB_TEST=OFF -DTBB_STRICT=OFF -DTBB_SANITIZE=thread -DCMAKE_BUILD_TYPE=RelWithDebInfo
    cmake --build "$build/onetbb" --target tbb -j2
    cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=RelWithDebInfo -DSTICKSLIP_SANITIZE_THREADS=ON
    cmake --build "$build" --target stickslip tests_sweep -j2
} >"$build/made.log" 2>&1 || { tail -20 "$build/made.log"; exit 1; }
LD_LIBRARY_PATH=$(dirname "$(find "$build/onetbb" -name libtbb.so.12)")
export LD_LIBRARY_PATH
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export TSAN_OPTIONS="log_path=$work/race second_deadlock_stack=1 suppressions=$root/tests/reliability/threads.supp"
program=$build/sweep/stickslip
watched=0 failed=0
watch() {
    echo "== ${*//$work\//}"
    code=0
    "$@" >"$work/said" 2>&1 || code=$?
    # 66 is the sanitizer's own; 1 and 4 are answers
    case $code in 0 | 1 | 4) ;; *) tail -5 "$work/said"; failed=$((failed + 1)) ;; esac
    watched=$((watched + 1))
}
cd "$root"
bistable=examples/03-bistable-strip/spec.toml
watch "$program" sweep -o "$work/linear" --threads 4
watch "$program" sweep $bistable -o "$work/nonlinear" --threads 4
watch "$program" report "$work/nonlinear"
watch "$program" boundary $bistable --along control.k_p=1e4..1e5 --kind linear fold outcome --threads 4
watch "$program" margins $bistable --threads 4
watch "$program" design $bistable --require sample_time=1e-3 --require position_noise=1e-6 --threads 4
watch "$program" simulate $bistable --disturbance start --size 1e-4 -o "$work/motion"
# where measured data are, a diagnosis too
[ -z "${STICKSLIP_DATA:-}" ] || watch "$program" diagnose examples/07-measured-machines/emps.toml "$STICKSLIP_DATA"/emps/*.csv* \
    -o "$work/diagnosis" --threads 4
watch "$build/tests/tests_sweep"
races=$(cat "$work"/race.* 2>/dev/null | grep -c "WARNING: ThreadSanitizer" || true)
cat "$work"/race.* 2>/dev/null | grep "SUMMARY" | sort | uniq -c | sort -rn | head -20 || true
echo "$watched runs under ThreadSanitizer, $races warnings, $failed other failures"
[ "$races" = 0 ] && [ $failed = 0 ]
