#!/bin/sh
# check.sh STICKSLIP NODE: needs MuJoCo's WebAssembly build, which `npm ci` fetches.
cd "$(dirname "$0")" || exit 1
[ -d node_modules/@mujoco/mujoco ] || { echo "skipped: MuJoCo is not there; run npm ci in tests/simulators, which needs the registry of npm"; exit 77; }
"$2" check.mjs "$1" && "$2" check_arms.mjs "$1" && "$2" check_import.mjs "$1" && "$2" check_gap.mjs "$1"
