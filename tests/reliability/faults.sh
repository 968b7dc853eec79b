#!/bin/bash
# Faults on the program as a user runs it: kill -9 at random instants, journals that are torn or have flipped bits, a disk that
# fills up. Every sweep must end with the bytes of an undisturbed one. Prints figures.
# Run: faults.sh STICKSLIP [KILLS] [SEED] [TORN]. With TORN, a number of damaged journals, kills and damages are all that is tried.
set -u
program=$(realpath "$1") kills=${2:-50} torn=${4:-20}
RANDOM=$((${3:-20261121} % 32768))
work=$(mktemp -d)
trap 'mountpoint -q "$work/disk" && umount "$work/disk"; rm -rf "$work"' EXIT
spec=$(realpath "$(dirname "$0")/../../examples/05-cluster")/spec.toml
sed 's/points = 500/points = 100/' "$spec" >"$work/spec.toml"
cd "$work"
fail() { echo "FAILED: $*"; exit 1; }
run() { "$program" sweep spec.toml -o "$1" --threads 2 --no-report --keep-journal; }
same() { cmp -s one/results.nc "$1/results.nc" || fail "other bytes after $2"; }

begin=$(date +%s%N)
run one >/dev/null || fail "the undisturbed sweep"
whole=$(($(date +%s%N) - begin))

survived=0 finished=0
while [ $survived -lt "$kills" ]; do
    "$program" sweep spec.toml -o killed --threads 2 --no-report >/dev/null 2>&1 &
    victim=$!
    sleep "$(awk -v r=$RANDOM -v w=$whole 'BEGIN { printf "%.4f", r / 32768 * w / 2e9 }')"
    kill -9 $victim 2>/dev/null
    wait $victim 2>/dev/null
    [ $? = 137 ] && survived=$((survived + 1))  # and not one that had ended already
    if [ -f killed/results.nc ]; then
        same killed "a kill"
        finished=$((finished + 1))
        rm -rf killed
    fi
done
run killed >/dev/null || fail "the run after the last kill"
same killed "the last kill"
echo "kills survived: $survived (kill -9 at random instants; $((finished + 1)) sweeps ended with equal bytes)"

damaged=0 healed=0
run torn >/dev/null
while [ $damaged -lt "$torn" ]; do
    journal=$(find torn/journal -name '*.journal' -size +0c | sort | shuf -n 1 --random-source=<(yes $RANDOM))
    size=$(stat -c %s "$journal")
    place=$(((RANDOM * 32768 + RANDOM) % size))
    if [ $((RANDOM % 2)) = 0 ]; then
        truncate -s $place "$journal"
    else
        printf '\377\0\377' | dd of="$journal" bs=1 seek=$place conv=notrunc status=none
    fi
    rm -f torn/results.nc
    damaged=$((damaged + 1))
    run torn >/dev/null || fail "a damaged journal was not healed"
    same torn "a torn record"
    healed=$((healed + $(sed -n 's/.*"chunks_computed": \([0-9]*\).*/\1/p' torn/run.json)))
done
echo "torn records healed: $healed chunks computed again after $damaged damages, bytes equal each time"

[ -n "${4:-}" ] && exit 0

# two runs in one directory, another sweep, another kind of CPU: refused in words, and nothing is touched
refused() {
    what=$1 words=$2
    shift 2
    "$@" >said 2>&1
    code=$?
    [ $code = 2 ] || fail "$what: code $code, $(cat said)"
    grep -q -- "$words" said || fail "$what is refused without \"$words\": $(cat said)"
    refusals=$((refusals + 1))
}
refusals=0
"$program" sweep spec.toml -o busy --threads 1 --no-report >/dev/null &
sweep=$!
while [ ! -d busy/journal ]; do sleep 0.01; done
refused "a second run" "another run is working" "$program" sweep spec.toml -o busy --no-report
refused "a merge meanwhile" "another run is working" "$program" merge busy
wait $sweep || fail "the run that was disturbed"
same busy "a second run"
sed 's/inertia = 1.0/inertia = 1.5/' spec.toml >other.toml
refused "another joint" "another joint; .* --fresh" "$program" sweep other.toml -o one --no-report
sed 's/points = 400/points = 401/' spec.toml >other.toml
refused "another axis" "another axis .* --fresh" "$program" sweep other.toml -o one --no-report
sed 's/"build": "stickslip/"build": "stuckslop/' one/plan.json >changed.json
cp -r one edited && cp changed.json edited/plan.json
refused "an edited plan" "--fresh" "$program" sweep spec.toml -o edited --no-report
other_cpu=GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-FMA4
if ! env $other_cpu "$program" sweep spec.toml -o cpu --no-report >/dev/null || ! cmp -s one/results.nc cpu/results.nc; then
    refused "another kind of CPU" "kind of CPU" env $other_cpu "$program" sweep spec.toml -o one --no-report
    refused "shards of two kinds of CPU" "different sweeps" "$program" merge one cpu -o both.nc
fi
run one >/dev/null && same torn "the refusals"
echo "refusals in words: $refusals, results untouched each time"

mkdir disk
if ! mount -t tmpfs -o size=24m tmpfs disk 2>/dev/null; then
    echo "disk full: skipped, no right to mount a small disk"
    exit 0
fi
run disk/out >/dev/null 2>said &
while [ ! -f disk/out/plan.json ]; do sleep 0.01; done
dd if=/dev/zero of=disk/filler bs=64k 2>/dev/null
wait $!
code=$?
[ $code -ne 0 ] || fail "a sweep on a full disk claims success"
grep -qi "space" said || fail "a full disk is not named: $(cat said)"
left=$(ls disk/out/results.nc 2>/dev/null)
[ -z "$left" ] || fail "a results.nc on a full disk"
rm disk/filler
run disk/out >/dev/null || fail "the run after the disk has room again"
same disk/out "a full disk"
echo "disk full: ended with code $code in words, went on when there was room, bytes equal"
