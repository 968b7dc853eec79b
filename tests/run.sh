#!/bin/sh
# Installs what is missing, builds everything, runs the tests. Arguments go to ctest.
set -eu
cd "$(dirname "$0")/.."
.ci/packages.sh test
mkdir -p build
cmake -S . -B build -G Ninja -DSTICKSLIP_TESTS=ON >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
ninja -C build
exec ctest --test-dir build --output-on-failure -j "$(nproc)" "$@"
