#!/bin/sh
# bundle.sh <program> <source folder>: the program with its libraries runs, and takes none from the machine but the C library's.
set -eu
command -v patchelf >/dev/null || { echo "skipped: patchelf is not installed"; exit 77; }
program=$1 source=$2
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
"$source/cmake/bundle.sh" "$program" "$room/stickslip"
ln -s "$room/stickslip/bin/stickslip" "$room/elsewhere"
test "$(env -i "$room/elsewhere" --version)" = "$("$program" --version)"
foreign=$(ldd "$room/stickslip/bin/stickslip" | awk '$3 ~ /^\// { print $3 }' |
  grep -v "^$room/" | grep -Ev '/(libc|libm|libdl|libpthread|librt|libresolv|libutil)\.so' || true)
test -z "$foreign" || { echo "taken from the machine: $foreign"; exit 1; }
# the machine's Python, which reads logs, sees none of them
printf '#!/bin/sh\necho "LD_LIBRARY_PATH is ${LD_LIBRARY_PATH-not set}" >&2; exit 2\n' >"$room/python"
chmod 755 "$room/python"
touch "$room/log.npz"
said=$(STICKSLIP_PYTHON="$room/python" env -u LD_LIBRARY_PATH "$room/elsewhere" convert "$room/log.npz" "$room/out.csv" 2>&1 || true)
case $said in *"LD_LIBRARY_PATH is not set"*) ;; *) echo "$said"; exit 1 ;; esac
