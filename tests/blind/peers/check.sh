#!/bin/sh
# The rivals still answer what a plain model can: a wrong inertia. Run: check.sh BUILD
set -eu
here=$(cd "$(dirname "$0")" && pwd)
generate=$(cd "$1" && pwd)/tests/blind/blind_generate
/usr/bin/python3 -c "import numpy, tomllib" 2>/dev/null || { echo "skipped: python3-numpy is not there"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
"$generate" "$folder/cases" --cases 2 --effect inertia --kind single --strength strong --joint revolute --columns full --state clean \
    --controller pd --seed 11
for rival in regression parameter_fit; do
    /usr/bin/python3 "$here/$rival.py" "$folder/cases" "$folder/$rival.json"
    named=$(grep -c '"inertia"' "$folder/$rival.json") || true
    [ "$named" -ge 2 ] || { echo "$rival names no inertia"; exit 1; }
done
