#!/bin/bash
# Which law does `diagnose` name for tables of outcomes made by another simulation? Prints truth, answer and rows of each.
# Run: run.sh BUILD [OUT]
set -eu
here=$(realpath "$(dirname "$0")") program=$(realpath "$1")/sweep/stickslip out=${2:-$1/outcomes}
mkdir -p "$out"
cat >"$out/joint.toml" <<'J'
[joint]
motion = "prismatic"
inertia = 1.0
[control]
k_p = 2e4
k_v = 0.0
V0 = 1e-3
[friction]
law = "coulomb-viscous"
coulomb = 60.0
viscous = 5.0
J
wrong=0
while read -r law effect; do
    "$here/generate.py" "$law" >"$out/$law.csv"
    "$program" diagnose "$out/joint.toml" "$out/$law.csv" -o "$out/$law" >"$out/$law.txt"
    named=$(/usr/bin/python3 -c "import json,sys; d = json.load(open(sys.argv[1])); print(d['verdict'], *d['effects'][0]['names'], d['effects'][0]['form'], round(d['effects'][0]['probability'], 3))" "$out/$law/diagnosis.json")
    echo "$law: $(grep -c stick-slip "$out/$law.csv") of $(grep -cE 'stable|stick' "$out/$law.csv") rows stick and slip; named: $named"
    case "$named" in "gap $effect "*) ;; *) wrong=$((wrong + 1)) ;; esac
done <<'T'
slip frictional-memory
ageing frictional-memory
kinetic-static coulomb-level
stribeck stribeck
T
echo "$wrong of 4 tables explained by another kind of friction"
exit $((wrong > 0))
