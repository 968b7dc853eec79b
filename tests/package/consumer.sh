#!/bin/sh
# Installs the library somewhere else and builds a program against it that knows nothing of this tree.
#   consumer.sh <build folder> <source folder>
set -eu
build=$1 source=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
cmake --install "$build" --prefix "$room/prefix" --component library >"$room/log"
cp -r "$source/examples/06-library" "$room/example"
{ cmake -S "$room/example" -B "$room/out" -DCMAKE_PREFIX_PATH="$room/prefix" && cmake --build "$room/out"; } >>"$room/log" 2>&1 || { cat "$room/log"; exit 1; }
"$room/out/gain_table" >"$room/table"
cat "$room/table"
# (36)-(37) by hand at V_0 = 1 mm/s: ((1.5 − 1 − 10·1e-3)/1e-5)·(1 + 1e-3/(1e-5·(10 + 1/1e-3))) = 53851.49 N/m
grep -q '^1e-03 *53851.5 *500$' "$room/table"
