#!/bin/sh
# bundle.sh PROGRAM FOLDER: the program with every library that it links but those of the C library itself, to run on any Linux
# of this processor whose glibc is as new as this machine's, with no package installed:
#   cmake/bundle.sh build/sweep/stickslip stickslip && tar czf stickslip-linux.tar.gz stickslip
# Surfaces are drawn where the machine has EGL, letters where it has DejaVu Sans.
set -eu
program=$1 folder=$2
mkdir -p "$folder/bin" "$folder/lib" "$folder/libexec"
cp "$program" "$folder/libexec/stickslip"
strip "$folder/libexec/stickslip"
ldd "$program" | awk '$3 ~ /^\// { print $1, $3 }' | while read -r name path; do
  case $name in
    # these belong to the loader of the machine
    libc.so.*|libm.so.*|libdl.so.*|libpthread.so.*|librt.so.*|libresolv.so.*|libutil.so.*) ;;
    *) cp -L "$path" "$folder/lib/$name" ;;
  esac
done
cat >"$folder/bin/stickslip" <<'WRAPPER'
#!/bin/sh
case $0 in */*) here=${0%/*} ;; *) here=$(command -v "$0"); here=${here%/*} ;; esac
[ -L "$0" ] && { here=$(readlink -f "$0"); here=${here%/*}; }
LD_LIBRARY_PATH=$here/../lib${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH} exec "$here/../libexec/stickslip" "$@"
WRAPPER
chmod 755 "$folder/bin/stickslip"
