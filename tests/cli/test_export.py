"""`fembearing export`: ranges and single values as options, names of files, and one line for each mistake."""

from pathlib import Path

import numpy as np
import pytest

from tests.analytic.scenefile.scene_texts import MINE

FAST = ("--set", "friction.spin_rule=balanced")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.toml").write_text(MINE)
    return tmp_path


def test_a_bearing_of_the_catalogue_needs_no_file(command, place: Path) -> None:
    line = ("6206", "--to", "csv", "--radial-load", "500 N to 2 kN in 3", "--speed", "0 rpm to 900 rpm in 4", *FAST)
    ended = command("export", *line, "--temperature", "55C")
    assert (ended.status, ended.err) == (0, "")
    assert ended.out.splitlines()[0].startswith(
        "written: friction_6206.csv; speed 0 rpm to 900 rpm in 4, axial load 0 N in 1, "
    )
    numbers = np.genfromtxt(place / "friction_6206.csv", delimiter=",", skip_header=1)
    assert numbers.shape == (12, 7)
    assert np.isfinite(numbers).all()
    assert (np.diff(numbers[:, 4:], axis=1) > 0).all()  # low, torque, high
    again = command("export", *line)
    assert again.status == 2
    assert again.err.count("\n") == 1
    assert "friction_6206.csv" in again.err


def test_a_scene_file_takes_ranges_too(command, place: Path) -> None:
    ended = command("export", "scene.toml", "--to", "csv", "-o", "map.csv", "--speed", "0 rpm to 90 rpm in 3", *FAST)
    assert (ended.status, ended.err) == (0, "")
    assert (place / "map.csv").exists()


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (["--to", "xlsx"], ["--to", "xlsx", "netcdf"]),
        ([], ["--to"]),
        (["--to", "csv", "--speed", "0 rpm to 60 rpm in 1"], ["has 1 values"]),
        (["--to", "csv", "--out", "scene.toml"], ["scene.toml", ".csv"]),
        (["--to", "modelica", "--radial-load", "1 kN to 2 kN in 3"], ["radial_load has 3 values", "modelica"]),
        (["--to", "csv", "--axial-load", "3 mm to 5 mm in 3"], ["axial_load", "5 mm", "N"]),
    ],
)
def test_a_mistake_gets_one_line(command, place: Path, arguments: list[str], words: list[str]) -> None:
    ended = command("export", "6206", *arguments)
    assert ended.status == 2
    assert ended.err.count("\n") == 1
    assert all(word in ended.err for word in words), ended.err
    assert [path.name for path in place.iterdir()] == ["scene.toml"]
