"""Mistakes on the command line: one line, a status, and nothing half-written."""

import subprocess
import sys
from pathlib import Path

import pytest

from tests.analytic.scenefile.scene_texts import MINE


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["validate", "nowhere.toml"], ["nowhere.toml"]),
        (["validate", "scene.toml", "--tolerance", "-1 %"], ["--tolerance", "-1 %", "0.0001 to 100 %"]),
        (["contact", "--load", "620"], ["--load", "620", "N"]),
        (["contact", "--load", "nan N"], ["--load", "nan N"]),
        (["contact", "--load", "3 mm"], ["--load", "3 mm", "N"]),
        (["contact", "--load", "3 N", "--load", "-5 N"], ["--load", "-5 N"]),
        (["contact", "--geometry", "wall", "--load", "3 N", "--load", "5 N"], ["geometry 'wall'", "pocket", "inner"]),
        (["mesh", "--geometry", "wall", "--out", "m"], ["geometry 'wall'", "pocket", "inner"]),
        (["contact", "--load", "3 N", "--load", "90 kN"], ["load = 90000 N", "inner", "groove_radius"]),
        (["contact", "--load", "90 kN"], ["load = 90000 N", "inner", "groove_radius"]),  # plastic long before: no mesh
        (["validate", "heavy.toml"], ["operation.axial_load = 700000 N", "shoulder"]),
        (["validate", "wide.toml"], ["operation.axial_load = 90000 N", "too wide"]),
        (["validate", "--out", "scene"], ["--out", "scene", "exists already"]),
        (["validate", "--out", "new.csv"], ["--out 'new.csv'", "writes a folder"]),
        (["cost", "--out", "new.HTML"], ["--out 'new.HTML'", "writes a folder"]),
        (["sweep", "grid.toml", "--out", "new.nc"], ["--out 'new.nc'", "writes a folder"]),
        (["sweep", "grid.toml", "--out", "o\udce9ut"], ["--out 'o\\udce9ut'", "not UTF-8"]),
        (["torque", "caged.toml", "--out", "o\udce9ut"], ["--out 'o\\udce9ut'", "not UTF-8"]),
        (["validate", "--out", "no/report"], ["--out", "no/report", "cannot be made"]),
        (["validate", "tight.toml"], ["cage.pocket_diameter", "7.9 mm", "7.94 mm"]),
        (["validate", "deep.toml"], ["cage.pocket_depth", "4.5 mm", "4.07 mm"]),
        (["mesh", "--out", "scene"], ["--out", "scene", "folder"]),
        (["mesh", "--out", "scene.toml"], ["--out", "scene.toml", "writes a folder"]),
        (["mesh", "--out", "new", "--level", "77"], ["--level", "77", "1, 2, 3, 4"]),
    ],
)
def test_a_mistake_gets_one_line_and_status_2(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, arguments: list[str], words: list[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.toml").write_text(MINE)
    (tmp_path / "heavy.toml").write_text(MINE.replace("700 N", "700000 N").replace('"given", value', '"solved", free'))
    (tmp_path / "wide.toml").write_text(MINE.replace("700 N", "90000 N"))
    (tmp_path / "tight.toml").write_text(MINE + '[cage]\npocket_diameter = "7.9 mm"')
    (tmp_path / "deep.toml").write_text(MINE + '[cage]\npocket_depth = "4.5 mm"')
    (tmp_path / "caged.toml").write_text(MINE + "[cage]")
    (tmp_path / "grid.toml").write_text('scene = "scene.toml"\n[axes]\noperation.axial_load = ["300 N", "500 N"]')
    (tmp_path / "scene").touch()
    before = sorted(tmp_path.iterdir())
    result = command(*arguments)
    assert result.status == 2
    assert result.out == ""
    assert result.err.count("\n") == 1
    assert all(word in result.err for word in words), result.err
    assert sorted(tmp_path.iterdir()) == before  # nothing half-written


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["contact", "--pair", "left"], ["--pair", "left", "inner", "outer"]),
        (["contact", "--frobnicate"], ["--frobnicate"]),
        (["mesh"], ["--out"]),
        (["judge"], ["judge"]),
        (["list", "foo"], ["TOPIC", "'foo' is not one of 'bearings', 'oils', 'materials', 'scenes', 'effects'"]),
        (["validate", "a.toml", "b.toml"], ["b.toml"]),
    ],
)
def test_a_mistyped_command_gets_one_line_too(command, arguments: list[str], words: list[str]) -> None:
    result = command(*arguments)
    assert (result.status, result.out, result.err.count("\n")) == (2, "", 1)
    assert all(word in result.err for word in words), result.err
    assert "Value error" not in result.err


@pytest.mark.parametrize(("target", "status"), [(">/dev/full", 74), ("| true", 141), (">&-", 74)])
def test_a_result_that_cannot_be_written_is_a_failure(tmp_path: Path, target: str, status: int) -> None:
    if not Path("/dev/full").exists():
        pytest.skip("this system has no /dev/full")
    line = f'"{sys.executable}" -m fembearing mesh --level 1 --out "{tmp_path}/made" --json {target}'
    script = f"{line}; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=False)
    assert done.returncode == status, done.stderr
    assert "Traceback" not in done.stderr
    assert done.stderr.count("\n") == (0 if status == 141 else 1)
