#!/bin/sh
# From a bare Debian 12 to the first report: installs what is missing, builds, and sweeps the joint that is embedded in the
# program. Arguments go to `stickslip sweep`.
set -eu
cd "$(dirname "$0")/.."
.ci/packages.sh build
mkdir -p build
cmake -S . -B build -G Ninja -DSTICKSLIP_TESTS=OFF >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
ninja -C build stickslip
exec build/sweep/stickslip sweep -o out "$@"
