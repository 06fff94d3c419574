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
    assert ended.status == 0
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


def test_the_verdict_is_that_of_the_torque(command, place: Path) -> None:
    """As `torque` has it at the last speed."""
    options = ("--axial-load", "5 N", "--speed", "3000 rpm to 10000 rpm in 3")
    line = "fail at 3 of 3 points: the rolling force of the oil exceeds the driving friction (inner race)"
    common = ("--radial-load", "0 N", "--temperature", "60C", "--oil", "ISO VG 68")
    ended = command("export", "6206", "--to", "csv", "--out", "map.csv", *common, *options)
    assert (ended.status, ended.out.splitlines()[-1][: len(line)]) == (1, line)
    assert len((place / "map.csv").read_text("utf-8").splitlines()) == 1 + int(options[3][-1])
    last = options[3].split(" to ")[1].split(" in ")[0]
    alone = command("torque", "6206", *common, *options[:2], "--speed", last, *options[4:])
    assert alone.status == 1
    assert line.split(": ")[1] in " ".join(alone.out.split())
    warned = {each.split(",")[0] for each in alone.err.splitlines()}  # before a share
    assert warned <= {each.split(",")[0] for each in ended.err.splitlines()}


def test_a_cage_of_a_table_rests_and_a_warning_says_so(command, place: Path) -> None:
    line = ("export", "paper_6205", "--to", "csv", "--axial-load", "900 N", "--temperature", "40C", *FAST)
    line = (*line, "--speed", "100 rpm to 300 rpm in 2")
    moving = command(*line, "--out", "moving.csv", "--set", "cage.start=ramp")
    resting = command(*line, "--out", "rest.csv", "--set", "effects.cage_dynamics=off")
    assert "cage.start" in moving.err
    assert "cage.start" not in resting.err
    assert (place / "moving.csv").read_bytes() == (place / "rest.csv").read_bytes()
