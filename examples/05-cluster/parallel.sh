#!/bin/sh
# The same shards without a batch system: GNU parallel on this machine, or on others with --sshloginfile.
#   SPEC=spec.toml OUT=out SHARDS=8 ./parallel.sh
set -eu
program=${STICKSLIP:-stickslip} shards=${SHARDS:-8}
seq "$shards" | parallel --retries 5 --halt soon,fail=1 \
    "$program" sweep "${SPEC:-spec.toml}" -o "${OUT:-out}" --shard "{}/$shards" --threads 1 --no-report
"$program" merge "${OUT:-out}"
"$program" report "${OUT:-out}"
