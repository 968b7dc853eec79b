#!/bin/sh
# clang-tidy over the sources that differ from a branch, or over those that are named; --all over every one.
#   tests/tidy.sh [--all | --since BRANCH | FILE.cpp...]      default: --since main
set -eu
cd "$(dirname "$0")/.."
command -v clang-tidy-14 >/dev/null || { echo "skipped: clang-tidy-14 is not installed"; exit 77; }
case "${1:-}" in
  --all) files=$(git ls-files 'analysis/*.cpp' 'render/*.cpp' 'sweep/*.cpp') ;;
  --since | '') files=$(git diff --name-only --diff-filter=d "${2:-main}" -- 'analysis/*.cpp' 'render/*.cpp' 'sweep/*.cpp') ;;
  *) files=$* ;;
esac
[ -n "$files" ] || { echo "no source differs"; exit 0; }
# commands without precompiled headers and without ccache, which only GCC reads
commands=build/tidy
mkdir -p "$commands"
cmake -S . -B "$commands" -G Ninja -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DSTICKSLIP_TESTS=OFF \
  -DCMAKE_CXX_COMPILER_LAUNCHER= -DCCACHE= >"$commands/configure.log" 2>&1 || { cat "$commands/configure.log"; exit 1; }
# headers that the build makes, without the rest that their rules wait for
make_header() { # folder, list, settings, header
  cmake -DLIST="$commands/$1/made/$2.txt" -DSETTINGS="$commands/$1/made/$3.txt" -DOUT="$PWD/$commands/$1/made/$4.h" \
    -DNAMESPACE="stickslip::$4" -P cmake/hash_of_sources.cmake
}
make_header sweep numeric_sources settings build_info
make_header render drawing_sources drawing_settings drawing_build
# shellcheck disable=SC2086  # a list of names without blanks
exec python3 tests/tidy_groups.py "$commands" $files
