#!/bin/sh
# bundle.sh PROGRAM FOLDER: the program with every library that it links but those of the C library itself, to run on any Linux
# of this processor whose glibc is as new as this machine's, with no package installed:
#   cmake/bundle.sh build/sweep/stickslip stickslip && tar czf stickslip-linux.tar.gz stickslip
# Needs patchelf. Surfaces are drawn where the machine has EGL, letters where it has DejaVu Sans.
set -eu
program=$1 folder=$2
command -v patchelf >/dev/null || { echo "bundle.sh needs patchelf (.ci/packages.sh test installs it)" >&2; exit 1; }
mkdir -p "$folder/bin" "$folder/lib"
cp "$program" "$folder/bin/stickslip"
strip "$folder/bin/stickslip"
# The path of its libraries is the program's own: in LD_LIBRARY_PATH the Python that reads logs would load them, too. As RPATH,
# not RUNPATH, it holds for what those libraries need.
patchelf --force-rpath --set-rpath '$ORIGIN/../lib' "$folder/bin/stickslip"
ldd "$program" | awk '$3 ~ /^\// { print $1, $3 }' | while read -r name path; do
  case $name in
    # these belong to the loader of the machine
    libc.so.*|libm.so.*|libdl.so.*|libpthread.so.*|librt.so.*|libresolv.so.*|libutil.so.*) ;;
    *) cp -L "$path" "$folder/lib/$name" ;;
  esac
done
# a library with a path of its own would not be looked for along the program's
for library in "$folder"/lib/*; do patchelf --remove-rpath "$library"; done
