"""The programs that users are shown."""

import os
import re
import runpy
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[3]


def program_of(readme):
    return re.search(r"\n```python\n(.*?)\n```", readme.read_text(encoding="utf-8"), re.DOTALL).group(1)


def test_the_readmes_program_runs(capsys):
    exec(compile(program_of(ROOT / "README.md"), "README.md", "exec"), {})
    assert "True" in capsys.readouterr().out


def test_the_packages_program_runs(tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "survey.xyz").write_text((ROOT / "tests/data/jacksboro_1.xyz").read_text())
    exec(compile(program_of(ROOT / "src/bindings/python/README.md"), "README.md", "exec"), {})


def test_the_picture_is_drawn(tmp_path, monkeypatch, capsys):
    pytest.importorskip("matplotlib")
    picture = tmp_path / "picture.png"
    monkeypatch.setattr(sys, "argv", ["compare.py", str(ROOT / "tests/data/jacksboro_1.xyz"), str(picture)])
    runpy.run_path(str(ROOT / "tests/examples/python/compare.py"), run_name="__main__")
    assert capsys.readouterr().out.endswith("168 -> 66 pits\n")
    assert picture.read_bytes().startswith(b"\x89PNG") and os.path.getsize(picture) > 50_000
