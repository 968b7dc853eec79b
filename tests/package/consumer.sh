#!/bin/sh
# Installs the library somewhere else, builds the programs of examples/06-library against it, which know nothing of this tree,
# and compiles every public header alone.
#   consumer.sh <build folder> <source folder>
set -eu
build=$1 source=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
cmake --install "$build" --prefix "$room/prefix" --component library >"$room/log"
cp -r "$source/examples/06-library" "$room/example"
{ cmake -S "$room/example" -B "$room/out" -DCMAKE_PREFIX_PATH="$room/prefix" -DCMAKE_BUILD_TYPE=Release && cmake --build "$room/out" -j2; } \
  >>"$room/log" 2>&1 || { cat "$room/log"; exit 1; }

"$room/out/gain_table" >"$room/table"
cat "$room/table"
# (36)-(37) by hand at V_0 = 1 mm/s: ((1.5 − 1 − 10·1e-3)/1e-5)·(1 + 1e-3/(1e-5·(10 + 1/1e-3))) = 53851.49 N/m
grep -q '^1e-03 *53851.5 *500$' "$room/table"
"$room/out/boundary" | tee "$room/table"
grep -q '^53851.48[0-9.]* N/m, .* stable above$' "$room/table"
"$room/out/outcomes" | tee "$room/table"
# on either side of that gain
grep -q '^k_p =  50 kN/m  \(stick-slip\|limit-cycle\|reversal\)' "$room/table"
grep -q '^k_p =  60 kN/m  stable-sliding' "$room/table"
"$room/out/diagnosis" | tee "$room/table"
# the load of 0.2 N·m that the record was made with
head -1 "$room/table" | grep -q '^gap$'
sed -n 2p "$room/table" | grep -q '^constant-load .* = \(0\.2\|0\.19[5-9][0-9]*\|0\.20[0-4][0-9]*\) N·m'

# the same from files, and what is wrong with a file, with its place
(cd "$room" && "$room/out/from_files") | tee "$room/table"
head -1 "$room/table" | grep -q '^gap$'
sed -n 2p "$room/table" | grep -q '^constant-load '
sed -i 's/^coulomb = .*/coulomb = -1/' "$room/joint.toml"
if "$room/out/from_files" "$room/joint.toml" "$room/record.csv" 2>"$room/table"; then exit 1; fi
cat "$room/table"
grep -q '/joint.toml:[0-9]*:[0-9]*: friction.coulomb: ' "$room/table"

for header in "$room"/prefix/include/stickslip/*.h; do
  name=$(basename "$header" .h)
  echo "#include <stickslip/$name.h>" >"$room/$name-alone.cpp"
  echo "$room/$name-alone.cpp"
done | xargs -n 1 -P 2 "${CXX:-c++}" -std=c++20 -fsyntax-only -I"$room/prefix/include" -I/usr/include/eigen3
# what is not public is not reached by the name that it has in the sources
echo '#include "analysis/joint/joint.h"' >"$room/alone.cpp"
if "${CXX:-c++}" -std=c++20 -fsyntax-only -I"$room/prefix/include" "$room/alone.cpp" 2>/dev/null; then
  echo "analysis/joint/joint.h is reached from outside"
  exit 1
fi
