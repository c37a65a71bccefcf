"""The package as pip installs it into a new environment, without a network."""

import os
import subprocess
import sys
from pathlib import Path

import pytest
import thalweg

PACKAGE = Path(__file__).resolve().parents[3] / "src" / "bindings" / "python"


@pytest.fixture(scope="module")
def environment(tmp_path_factory):
    """A new virtual environment that has numpy from the system. Takes the library that is under test, so that it
    need not be compiled again."""
    library = os.environ.get("THALWEG_LIBRARY")
    if library is None:
        pytest.skip("THALWEG_LIBRARY does not say which library to pack")
    pytest.importorskip("pip")
    folder = tmp_path_factory.mktemp("environment")
    subprocess.run([sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", folder], check=True)
    python = folder / "bin" / "python"
    pip = [sys.executable, "-m", "pip", "--python", python, "--disable-pip-version-check", "--quiet"]
    subprocess.run([*pip, "install", "--no-index", "--config-settings", f"library={library}", PACKAGE], check=True)
    return python


def run(python, code, folder):
    clean = {k: v for k, v in os.environ.items() if k not in ("PYTHONPATH", "THALWEG_LIBRARY")}
    return subprocess.run([python, "-c", code], check=True, cwd=folder, env=clean, stdout=subprocess.PIPE, text=True)


def test_an_installed_package_works(environment, tmp_path):
    code = """
import importlib.metadata, pathlib, thalweg
terrain = thalweg.build([[0, 0, 9], [10, 0, 8], [10, 8, 7], [0, 9, 3], [4, 4, 5], [7, 4, 1]], order=4)
assert (pathlib.Path(thalweg.__file__).parent / "py.typed").exists()
assert importlib.metadata.version("thalweg") == thalweg.__version__
print(thalweg.__version__, len(terrain.triangles), terrain.certified)
"""
    assert run(environment, code, tmp_path).stdout.split() == [thalweg.__version__, "6", "True"]


def test_docstrings_are_true(environment, tmp_path):
    code = "import doctest, thalweg; r = doctest.testmod(thalweg); assert r.attempted >= 3 and r.failed == 0, r"
    run(environment, code, tmp_path)


def test_the_wheel_is_reproducible(tmp_path):
    library = os.environ.get("THALWEG_LIBRARY")
    if library is None:
        pytest.skip("THALWEG_LIBRARY does not say which library to pack")
    wheels = []
    for name in ("first", "second"):
        (tmp_path / name).mkdir()
        code = f"import backend; print(backend.build_wheel({str(tmp_path / name)!r}, {{'library': {library!r}}}))"
        made = subprocess.run(
            [sys.executable, "-B", "-c", code], check=True, cwd=PACKAGE, stdout=subprocess.PIPE, text=True
        )
        wheels.append((tmp_path / name / made.stdout.strip()).read_bytes())
    assert wheels[0] == wheels[1] and made.stdout.startswith("thalweg-" + thalweg.__version__ + "-py3-none-")
