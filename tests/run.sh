#!/bin/sh
# Installs what is missing, builds everything, runs the tests. Arguments go to ctest.
set -eu
cd "$(dirname "$0")/.."
.ci/packages.sh test
mkdir -p build
# MuJoCo for the test `simulators`; without the registry of npm that test is skipped, and says so
[ -d tests/simulators/node_modules ] ||
    timeout 300 npm ci --prefix tests/simulators --no-audit --no-fund --ignore-scripts --fetch-retries=1 >build/npm.log 2>&1 ||
    echo "npm ci failed in tests/simulators (build/npm.log): the test simulators will be skipped"
cmake -S . -B build -G Ninja -DSTICKSLIP_TESTS=ON >build/configure.log 2>&1 || { cat build/configure.log; exit 1; }
ninja -C build
exec ctest --test-dir build --output-on-failure -j "$(nproc)" "$@"
