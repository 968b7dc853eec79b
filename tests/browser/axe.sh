#!/bin/sh
# Runs the browser tests with the accessibility rules of axe-core (Deque Systems, MPL-2.0), fetched for this run: axe.sh STICKSLIP
set -eu
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" axe-core@4.10.2
AXE_CORE="$folder/node_modules/axe-core/axe.min.js" /usr/bin/python3 "$(dirname "$0")/report_test.py" "$1" Report.test_axe_core_finds_nothing
