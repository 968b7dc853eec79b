#!/bin/sh
# The same sweep by one thread, seven shards and four ranks, and by four ranks of which one is killed: equal bytes.
# Run: engines.sh STICKSLIP STICKSLIP-MPI
set -eu
program=$1 mpi_program=$2
command -v mpirun >/dev/null || { echo "no mpirun: skipped"; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
ranks() { mpirun -np 4 --oversubscribe --bind-to none "$@"; }
same() { cmp "$work/one/results.nc" "$1" && echo "equal bytes: $2"; }

cat > "$work/spec.toml" <<'SPEC'
[joint]
motion = "prismatic"
model = "single-mass"
inertia = 1.0
[control]
kind = "position"
k_p = 2.0e4
k_v = 10.0
V0 = 1.0e-3
[friction]
law = "rate-and-state"
f0 = 60.0
A = 1.0
B = 1.5
L = 1.0e-5
V_star = 1.0e-3
[axes]
"control.V0" = { from = 1e-5, to = 1e-1, points = 40, scale = "log" }
"control.k_v" = { from = 1e-1, to = 1e4, points = 200, scale = "log" }
"control.k_p" = { from = 1e2, to = 1e6, points = 200, scale = "log" }
SPEC
sweep="sweep $work/spec.toml --no-report"

$program $sweep -o "$work/one" --threads 1 >/dev/null

shards=
for i in 1 2 3 4 5 6 7; do
    $program $sweep -o "$work/shard$i" --shard $i/7 --threads 1 >/dev/null
    shards="$shards $work/shard$i"
done
$program merge $shards -o "$work/shards.nc" >/dev/null
same "$work/shards.nc" "7 shards"

ranks "$mpi_program" $sweep -o "$work/ranks" --threads 2 --keep-journal >/dev/null
same "$work/ranks/results.nc" "4 ranks of 2 threads"
test "$(ls "$work/ranks/journal" | wc -l)" -gt 1

# A rank dies: the job ends, and the next job, of another size, computes only what is missing.
ranks "$mpi_program" $sweep -o "$work/killed" --threads 1 >/dev/null 2>&1 &
job=$!
while [ "$(ls "$work/killed/journal" 2>/dev/null | wc -l)" -lt 3 ] && kill -0 $job 2>/dev/null; do sleep 0.01; done
victim=$(ls "$work/killed/journal" | tail -1 | sed 's/.*-\([0-9]*\)-[0-9]*\.journal/\1/')
kill -9 "$victim" 2>/dev/null && killed=yes || killed="no, it had ended"
wait $job && echo "the job ended well" || echo "the job ended with its rank (killed: $killed)"
mpirun -np 2 --oversubscribe --bind-to none "$mpi_program" $sweep -o "$work/killed" --threads 1 >/dev/null
same "$work/killed/results.nc" "a killed rank and 2 more ranks"
grep -E "chunks_(computed|resumed)" "$work/killed/run.json"

# A refusal reaches every rank: the job ends, says why and touches nothing.
sed 's/points = 40/points = 41/' "$work/spec.toml" >"$work/other.toml"
if ranks "$mpi_program" sweep "$work/other.toml" -o "$work/ranks" >/dev/null 2>"$work/said"; then
    echo "another sweep was taken"
    exit 1
fi
grep -q "another axis" "$work/said" && echo "another sweep is refused"
same "$work/ranks/results.nc" "after the refusal"

# Ranks whose C library computes otherwise, as on another kind of CPU, are found before anything is computed. Where the
# machine has one kind of code only, the tunable changes nothing and the sweep is the same.
other_cpu=GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-FMA4
code=0
ranks "$mpi_program" $sweep -o "$work/mixed" : -np 1 --bind-to none env "$other_cpu" \
    "$mpi_program" $sweep -o "$work/mixed" >/dev/null 2>"$work/said" || code=$?
if grep -q "kind of CPU" "$work/said"; then
    echo "a rank on another kind of CPU is refused (code $code)"
    test ! -e "$work/mixed/journal"
else
    same "$work/mixed/results.nc" "another kind of CPU that computes the same"
fi
