#!/bin/sh
# Installs the Debian packages that stickslip needs and that are not there yet: `packages.sh build` for the program,
# `packages.sh test` for the tests as well. The list stands here once.
set -eu
build='g++ cmake ninja-build ccache pkg-config libeigen3-dev libtbb-dev libsundials-dev libnlopt-dev libnlopt-cxx-dev
libvtk9-dev libegl-dev libglew-dev libegl1 libegl-mesa0 libgl1-mesa-dri libcli11-dev libtomlplusplus-dev
nlohmann-json3-dev libnetcdf-dev libfmt-dev libxxhash-dev zlib1g-dev libpng-dev libfreetype-dev libpugixml-dev libjs-dygraphs librsvg2-dev fonts-dejavu-core
file dpkg-dev'  # these two for the .deb
tests='catch2 python3 python3-xarray python3-netcdf4 python3-pandas python3-pytest python3-matplotlib
python3-scipy python3-h5py python3-lz4 python3-zstandard mypy python3-selenium python3-jsonschema python3-pil chromium chromium-driver parallel mkdocs patchelf'
# npm for tests/simulators, which run MuJoCo's WebAssembly build: with Debian's 400 small packages of it where there is none
command -v npm >/dev/null || tests="$tests nodejs npm"
style='clang-format-14 clang-tidy-14'  # Debian 12 has them, Debian 13 has not: tests that need them are skipped there
case "${1:-}" in
    build) wanted=$build ;;
    test) wanted="$build $tests $style" ;;
    *) echo "usage: $0 build|test" >&2; exit 2 ;;
esac
missing=
for package in $wanted; do
    dpkg-query -W -f '${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
done
[ -z "$missing" ] && exit 0
as_root=
[ "$(id -u)" = 0 ] || as_root=sudo
echo "installing:$missing"
export DEBIAN_FRONTEND=noninteractive
$as_root apt-get update -qq
for package in $style; do
    case " $missing " in *" $package "*) ;; *) continue ;; esac
    apt-cache show "$package" >/dev/null 2>&1 && continue
    echo "this distribution has no $package"
    missing=$(echo " $missing " | sed "s/ $package / /")
done
[ -z "$(echo $missing)" ] && exit 0
# shellcheck disable=SC2086
$as_root apt-get install -y -qq --no-install-recommends $missing >/dev/null
