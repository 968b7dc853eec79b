#!/bin/bash
# walks.sh DEB [ROOT]: a machine with nothing but Debian, from the package to the first report, and the walks of a Python user and of
# a ROS user, each step timed. Makes ROOT, a minimal Debian, with debootstrap where it is missing. As root, with a network; code 77 without.
set -eu
deb=$(realpath "$1") root=${2:-/var/tmp/stickslip-bare} here=$(realpath "$(dirname "$0")/..")
[ "$(id -u)" = 0 ] && command -v debootstrap >/dev/null || { echo "skipped: needs root and debootstrap"; exit 77; }
[ -x "$root/bin/sh" ] || debootstrap --variant=minbase bookworm "$root" http://deb.debian.org/debian >"$root.log" 2>&1
cp "$deb" "$root/tmp/stickslip.deb"
cp /etc/resolv.conf "$root/etc/resolv.conf"
[ -f /etc/apt/apt.conf.d/90proxy ] && cp /etc/apt/apt.conf.d/90proxy "$root/etc/apt/apt.conf.d/"
rm -rf "$root/walk" && mkdir "$root/walk"
cp "$here/fuzz/corpus/robot/arm.urdf" "$here/python/log_samples.py" "$here/package/walk_python.py" "$here/package/walk_ros.py" "$root/walk"

inside() {
    unshare -m bash -c 'mount --make-rprivate / && mount --bind /dev "$0/dev" && mount -t proc proc "$0/proc" &&
        exec chroot "$0" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
            sh -euc "cd /walk; $1"' "$root" "$1"
}
step() {
    local what=$1 begin
    begin=$(date +%s.%N)
    inside "$2" >"$root/walk/said" 2>&1 || { echo "FAILED: $what"; tail -20 "$root/walk/said"; exit 1; }
    awk -v w="$what" -v a="$begin" -v b="$(date +%s.%N)" 'BEGIN { printf "%-58s %6.1f s\n", w, b - a }'
}

step "apt-get update" "apt-get update -qq"
step "apt-get install --download-only" "apt-get install -y -qq --no-install-recommends --download-only /tmp/stickslip.deb"
step "apt-get install of what was downloaded" "apt-get install -y -qq --no-install-recommends /tmp/stickslip.deb"
step "first report" "stickslip sweep -o first && test -s first/report.html"
step "manual and completions" "test -s /usr/share/man/man1/stickslip.1.gz -o -s /usr/share/man/man1/stickslip.1 || test -e /etc/dpkg/dpkg.cfg.d/docker; ls /usr/share/bash-completion/completions/stickslip"
step "completion of zsh" "apt-get install -y -qq --no-install-recommends zsh; zsh -c 'autoload -Uz compinit && compinit -u && [[ \$_comps[stickslip] = _stickslip ]]'"
step "the packages that it recommends to Python users" "apt-get install -y -qq --no-install-recommends python3-numpy python3-pandas python3-xarray python3-netcdf4 python3-matplotlib"
step "Python user: map, boundary, record, diagnosis, chart" "python3 walk_python.py"
step "ROS user: the robot's joint from its URDF" "stickslip import arm.urdf --joint shoulder --set control.k_p=400 --set control.k_v=20 \
    --set control.period=2e-3 --set control.velocity_estimate.form=backward-difference -o shoulder.toml"
step "  (a log of the robot, with 60 % more Coulomb friction)" "python3 walk_ros.py"
step "ROS user: diagnosis of the MCAP" "stickslip diagnose shoulder.toml run.mcap --joint shoulder --command /commands -o diagnosis"
grep -q '"coulomb-level"' "$root/walk/diagnosis/diagnosis.json" || { echo "FAILED: the cause was not named"; head -40 "$root/walk/said"; exit 1; }
step "ROS user: what to paste into ros2_control, URDF, MJCF" "for to in ros2_control urdf mjcf; do stickslip export diagnosis/corrected-joint.toml --to \$to >pasted-\$to; done"
step "dpkg --remove" "dpkg --remove stickslip && ! command -v stickslip"
