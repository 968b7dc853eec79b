#!/bin/sh
# clang-format over every source of ours; with --check nothing is changed and the exit code tells.
set -eu
cd "$(dirname "$0")/.."
command -v clang-format-14 >/dev/null || { echo "skipped: clang-format-14 is not installed, others format otherwise"; exit 77; }
mode=-i
[ "${1:-}" = --check ] && mode='--dry-run --Werror'
# shellcheck disable=SC2086
git ls-files '*.cpp' '*.h' | xargs clang-format-14 $mode
