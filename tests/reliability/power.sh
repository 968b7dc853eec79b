#!/bin/bash
# A power cut, as a disk sees it: a sweep runs on ext4 in a loop device, and the bytes that have reached the device by some
# instant are copied. The copy holds what a machine would find after losing power then: whatever the kernel had not written
# is gone. Each copy is mounted, the sweep goes on there and must end with the bytes of an undisturbed one. Prints figures.
# Run as root: power.sh STICKSLIP [CUTS] [SEED]
set -u
program=$(realpath "$1") cuts=${2:-20}
RANDOM=${3:-20261121}
work=$(mktemp -d)
clean() {
    for place in "$work"/disk "$work"/after; do mountpoint -q "$place" && umount -l "$place"; done
    rm -rf "$work"
}
trap clean EXIT
fail() { echo "FAILED: $*"; exit 1; }
spec=$(realpath "$(dirname "$0")/../../examples/05-cluster")/spec.toml
cd "$work"
mkdir disk after
sed 's/points = 500/points = 200/' "$spec" >spec.toml
truncate -s 64M image
mkfs.ext4 -q image 2>/dev/null && mount -o loop image disk 2>/dev/null || { echo "power cuts: skipped, no right to mount"; exit 77; }
run() { nice -n 0 "$program" sweep spec.toml -o "$1" --threads 1 --no-report; }
run one >/dev/null || fail "the undisturbed sweep"

healed=0 kept=0 empty=0 lost=0
while [ $healed -lt "$cuts" ]; do
    rm -rf disk/out
    run disk/out >/dev/null &
    sweep=$!
    while kill -0 $sweep 2>/dev/null && [ $healed -lt "$cuts" ]; do
        sleep "$(awk -v r=$RANDOM 'BEGIN { printf "%.3f", 0.1 + r / 10000 }')"
        # nothing asks the kernel to write here, and no sync runs before the copy
        cp --sparse=always image copy
        written=$(cat disk/out/journal/*.journal 2>/dev/null | wc -c)
        mount -o loop copy after || fail "the copy of the device does not mount"
        found=$(cat after/out/journal/*.journal 2>/dev/null | wc -c)
        [ "$found" -lt "$written" ] && lost=$((lost + 1))
        run after/out >said 2>&1 || fail "the run after the power came back: $(cat said)"
        cmp -s one/results.nc after/out/results.nc || fail "other bytes after a power cut"
        resumed=$(sed -n 's/.*"chunks_resumed": \([0-9]*\).*/\1/p' after/out/run.json)
        kept=$((kept + resumed))
        [ "$resumed" = 0 ] && empty=$((empty + 1))
        umount after
        healed=$((healed + 1))
    done
    wait $sweep || fail "the sweep itself"
done
echo "power cuts healed: $healed (in $lost the device lacked journal bytes that had been written; $kept chunks taken over," \
    "$empty times none), bytes equal each time"
