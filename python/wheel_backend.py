"""Builds wheel and sdist (PEP 517). The wheel holds the Python package and the program, which CMake builds.

STICKSLIP_PROGRAM=path takes a program that is built already. STICKSLIP_MANYLINUX=1 puts the libraries that it links into the
wheel, too, which then runs on every Linux of this processor whose glibc is as new as this machine's (PEP 600).
"""
import base64
import hashlib
import os
import platform
import re
import subprocess
import sysconfig
import tarfile
import tempfile
import zipfile
from io import BytesIO
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = Path(__file__).resolve().parent / "stickslip"


def version():
    """The one of the program: a header says it once."""
    text = (ROOT / "analysis" / "base" / "version.h").read_text(encoding="utf-8")
    return re.search(r'STICKSLIP_VERSION "([0-9.]+)"', text).group(1)


def program():
    built = os.environ.get("STICKSLIP_PROGRAM")
    if built:
        return Path(built)
    folder = ROOT / "build" / "wheel"
    subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", "-DSTICKSLIP_TESTS=OFF", "-DCMAKE_BUILD_TYPE=Release"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "stickslip"], check=True)
    return folder / "sweep" / "stickslip"


def metadata():
    lines = ["Metadata-Version: 2.1", "Name: stickslip", f"Version: {version()}",
             "Summary: Stick-slip of robot joints: stability maps and sim-to-real diagnosis", "Requires-Python: >=3.9"]
    lines += [f"Requires-Dist: {name}" for name in ("numpy", "pandas", "xarray", "netCDF4")]
    lines += ["Provides-Extra: plots", 'Requires-Dist: matplotlib; extra == "plots"', "Provides-Extra: logs",
              'Requires-Dist: h5py; extra == "logs"', 'Requires-Dist: scipy; extra == "logs"']
    readme = (ROOT / "docs" / "python.md").read_text(encoding="utf-8")
    return "\n".join(lines) + "\nDescription-Content-Type: text/markdown\n\n" + readme


MANYLINUX = os.environ.get("STICKSLIP_MANYLINUX") == "1"


def tag():
    if MANYLINUX:
        return f"py3-none-manylinux_{platform.libc_ver()[1].replace('.', '_')}_{platform.machine()}"
    return "py3-none-" + sysconfig.get_platform().replace("-", "_").replace(".", "_")


def binaries():
    """(path in the package, data, mode) of the program and, on request, of what it links."""
    if not MANYLINUX:
        yield "bin/stickslip", program().read_bytes(), 0o755
        return
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([ROOT / "cmake" / "bundle.sh", program(), folder], check=True)
        for file in sorted(p for p in Path(folder).rglob("*") if p.is_file()):
            yield file.relative_to(folder).as_posix(), file.read_bytes(), 0o644 if file.parent.name == "lib" else 0o755


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    name = f"stickslip-{version()}-{tag()}.whl"
    info = f"stickslip-{version()}.dist-info"
    record = []
    with zipfile.ZipFile(Path(wheel_directory) / name, "w", zipfile.ZIP_DEFLATED) as wheel:

        def add(path, data, mode=0o644):
            entry = zipfile.ZipInfo(path, date_time=(2020, 1, 1, 0, 0, 0))
            entry.external_attr = (0o100000 | mode) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            wheel.writestr(entry, data)
            digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
            record.append(f"{path},sha256={digest},{len(data)}")

        for file in sorted(PACKAGE.rglob("*")):
            if file.suffix == ".py" or file.name == "py.typed":
                add("stickslip/" + file.relative_to(PACKAGE).as_posix(), file.read_bytes())
        for path, data, mode in binaries():
            add("stickslip/" + path, data, mode)
        add(f"{info}/METADATA", metadata().encode())
        add(f"{info}/entry_points.txt", b"[console_scripts]\nstickslip = stickslip.__main__:main\n")
        add(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: stickslip\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode())
        record.append(f"{info}/RECORD,,")
        wheel.writestr(f"{info}/RECORD", "\n".join(record) + "\n")
    return name


def build_sdist(sdist_directory, config_settings=None):
    name = f"stickslip-{version()}"
    listed = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, capture_output=True)
    files = listed.stdout.decode().split("\0")[:-1] if listed.returncode == 0 else [
        p.relative_to(ROOT).as_posix() for p in ROOT.rglob("*") if p.is_file() and p.relative_to(ROOT).parts[0] != "build"]
    with tarfile.open(Path(sdist_directory) / f"{name}.tar.gz", "w:gz", format=tarfile.PAX_FORMAT) as archive:
        for file in sorted(files):
            archive.add(ROOT / file, f"{name}/{file}", recursive=False)
        data = metadata().encode()
        entry = tarfile.TarInfo(f"{name}/PKG-INFO")
        entry.size = len(data)
        archive.addfile(entry, BytesIO(data))
    return f"{name}.tar.gz"
