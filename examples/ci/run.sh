#!/bin/sh
# A pipeline step: exit code 1 if a stability boundary of the ball-screw drive has moved. STICKSLIP names the program,
# the first argument the folder for the report.
set -eu
cd "$(dirname "$0")/../.."
out=${1:-stability}
mkdir -p "$out"
exec "${STICKSLIP:-build/sweep/stickslip}" check examples/02-ball-screw/spec-with-memory.toml \
    examples/02-ball-screw/baseline.json --junit "$out/stability.xml" -o "$out"
