#!/bin/sh
# bundle.sh <program> <source folder>: the program with its libraries runs, and takes none from the machine but the C library's.
set -eu
program=$1 source=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
"$source/cmake/bundle.sh" "$program" "$room/stickslip"
ln -s "$room/stickslip/bin/stickslip" "$room/elsewhere"
test "$(env -i "$room/elsewhere" --version)" = "$("$program" --version)"
foreign=$(LD_LIBRARY_PATH="$room/stickslip/lib" ldd "$room/stickslip/libexec/stickslip" | awk '$3 ~ /^\// { print $3 }' |
  grep -v "^$room/" | grep -Ev '/(libc|libm|libdl|libpthread|librt|libresolv|libutil)\.so' || true)
test -z "$foreign" || { echo "taken from the machine: $foreign"; exit 1; }
