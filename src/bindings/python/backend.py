"""Builds the wheel (PEP 517): compiles the shared library with CMake and packs it beside the Python files.

Written for this package because a wheel is only a zip file, and so nothing has to be downloaded to make one.
`--config-settings library=FILE` packs a library that is there already instead of compiling one.
"""

import base64
import csv
import hashlib
import io
import os
import platform
import re
import shutil
import subprocess
import sysconfig
import tempfile
import zipfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
SUMMARY = "Terrains without false pits, by higher-order Delaunay triangulations"


def version():
    """The project's version, which CMakeLists.txt alone says."""
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(thalweg\s+VERSION\s+([0-9.]+)", text).group(1)


def library_name():
    """What the shared library is called inside the package; the loader in thalweg/_abi.py looks for it."""
    return {"Windows": "thalweg_c.dll", "Darwin": "libthalweg_c.dylib"}.get(platform.system(), "libthalweg_c.so")


def metadata():
    readme = (HERE / "README.md").read_text(encoding="utf-8")
    return (
        "Metadata-Version: 2.1\nName: thalweg\n"
        f"Version: {version()}\nSummary: {SUMMARY}\nLicense: MIT\n"
        "Requires-Python: >=3.9\nRequires-Dist: numpy>=1.20\n"
        f"Description-Content-Type: text/markdown\n\n{readme}"
    )


def compile_library(folder):
    """Builds the shared library in `folder` and returns its path."""
    if shutil.which("cmake") is None:
        raise RuntimeError("thalweg: cmake is needed to build (Debian: apt-get install cmake g++)")
    subprocess.run(
        ["cmake", "-S", str(ROOT), "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DTHALWEG_BUILD_TESTS=OFF",
         "-DTHALWEG_BUILD_CLI=OFF", "-DTHALWEG_INSTALL=OFF"],
        check=True,
    )  # fmt: skip
    jobs = str(os.cpu_count() or 1)
    subprocess.run(
        ["cmake", "--build", folder, "--config", "Release", "--target", "thalweg_c", "--parallel", jobs], check=True
    )
    found = [path for path in Path(folder, "src").rglob(library_name()) if path.is_file()]
    if not found:
        raise RuntimeError(f"thalweg: CMake built no {library_name()}")
    return found[0].resolve()


def pack(wheel, files):
    """Writes {name in the archive: bytes} and the record of them. The same content gives the same bytes."""
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    info = f"thalweg-{version()}.dist-info"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            rows.writerow([name, f"sha256={digest}", len(content)])
            _add(archive, name, content)
        rows.writerow([f"{info}/RECORD", "", ""])
        _add(archive, f"{info}/RECORD", record.getvalue().encode())


def _add(archive, name, content):
    entry = zipfile.ZipInfo(name, date_time=(1980, 1, 1, 0, 0, 0))
    entry.compress_type = zipfile.ZIP_DEFLATED
    entry.external_attr = (0o755 if name.endswith((".so", ".dylib", ".dll")) else 0o644) << 16
    archive.writestr(entry, content)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    # One library serves every Python 3: it knows nothing of the interpreter.
    tag = "py3-none-" + re.sub(r"[-.]", "_", sysconfig.get_platform())
    name = f"thalweg-{version()}-{tag}.whl"
    info = f"thalweg-{version()}.dist-info"
    files = {
        f"thalweg/{path.name}": path.read_bytes()
        for path in sorted((HERE / "thalweg").iterdir())
        if path.suffix == ".py" or path.name == "py.typed"
    }
    with tempfile.TemporaryDirectory() as folder:
        given = (config_settings or {}).get("library")
        library = Path(given) if given else compile_library(folder)
        files[f"thalweg/{library_name()}"] = library.read_bytes()
    files[f"{info}/METADATA"] = metadata().encode()
    files[f"{info}/WHEEL"] = f"Wheel-Version: 1.0\nGenerator: thalweg\nRoot-Is-Purelib: false\nTag: {tag}\n".encode()
    files[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    pack(Path(wheel_directory, name), files)
    return name


class UnsupportedOperation(Exception):
    """What PEP 517 has a backend raise."""


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("thalweg is built from a checkout: the C++ sources are not below this folder")
