#!/bin/bash
# Memory does not grow with a sweep: a small and a large one, both where only 512 MiB of addresses are allowed, and one that
# nobody can compute, which must be refused in words. Prints figures.
# Run: memory.sh STICKSLIP [POINTS]; 10^7 by default, which need 0.7 GB of disk
set -u
program=$(realpath "$1") points=${2:-10000000}
limit=524288  # KiB
most_growth=24000  # KiB between the small and the large sweep: the index of chunks and the slots of the blocks
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*"; exit 1; }
spec=$(realpath "$(dirname "$0")/../../examples/05-cluster")/spec.toml
cd "$work"
spec_of() {
    sed -n '1,/^\[axes\]/p' "$spec"
    echo "\"control.V0\" = { from = 1e-5, to = 1e-1, points = $1, scale = \"log\" }"
    echo '"control.k_v" = { from = 1e-1, to = 1e4, points = 1000, scale = "log" }'
    echo '"control.k_p" = { from = 1e2, to = 1e6, points = 1000, scale = "log" }'
}
peak_of() {
    spec_of "$1" >spec.toml
    "$program" sweep spec.toml -o out --threads 2 --no-report --fresh >/dev/null &
    sweep=$!
    peak=0
    while now=$(awk '/VmHWM/ { print $2 }' /proc/$sweep/status 2>/dev/null); [ -n "$now" ]; do peak=$now; sleep 0.05; done
    wait $sweep || fail "a sweep over $1 × 10^6 points under $limit KiB: code $?"
}
ulimit -v $limit
peak_of 2
small=$peak
peak_of $((points / 1000000))
echo "memory: 2000000 points $small KiB, $points points $peak KiB resident at most (ulimit -v $limit KiB)"
[ $((peak - small)) -lt $most_growth ] || fail "memory grows with the sweep"
rm -rf out
spec_of 1000000 | sed 's/points = 1000,/points = 100000,/' >spec.toml
"$program" sweep spec.toml -o absurd 2>said
[ $? = 2 ] || fail "an absurd sweep was not refused"
[ ! -e absurd ] || fail "an absurd sweep left a directory"
grep -q "of results and .* years" said || fail "no estimate: $(cat said)"
echo "absurd: $(sed 's/^[^ ]* axes: //' said)"
