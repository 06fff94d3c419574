"""`fembearing creep`: friction of the heaviest ball by formula, production and reference."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from tests.conftest import Result

QUANTITIES = "spin_moment", "rolling_moment", "transverse_force", "slip_share"
Run = Callable[..., Result]


def test_every_number_of_both_races_and_the_torque(command: Run, tmp_path: Path) -> None:
    folder = tmp_path / "friction"
    ended = command("creep", "6205-dry", "--friction", "0.1", "--load", "370 N", "--json", "--out", str(folder))
    assert ended.status == 0
    found = json.loads(ended.out)
    for race in ("inner", "outer"):
        assert found["races"][race]["load"] == pytest.approx(370, rel=0.01)  # friction across moves the angles
        assert found["races"][race]["quantities"].keys() >= set(QUANTITIES)
    # The law of production is within 2.5 % of 72 references (docs/theory/creep.md).
    assert found["torque"]["production"] == pytest.approx(found["torque"]["reference"], rel=0.025)
    written = json.loads((folder / "creep.json").read_text())
    pictures = written.pop("pictures")
    assert written.keys() == found.keys()
    for picture in pictures:
        assert "stick" in picture["caption"]
        assert (folder / picture["file"]).read_bytes().startswith(b"\x89PNG")
    assert [picture["file"] for picture in pictures] == ["inner-creep.png", "outer-creep.png"]


def test_meshed_bodies_are_named_and_change_the_torque_a_little(command: Run) -> None:
    given = "creep", "6205-dry", "--friction", "0.1", "--tolerance", "2 %"
    plain, meshed = (
        json.loads(command(*given, "--json", "--compliance", kind).out) for kind in ("half-space", "meshed")
    )
    assert (plain["compliance"], meshed["compliance"]) == ("half-space", "meshed")
    # 0.4 % on fine grids, validation/ehl/true_shapes.csv; grids of 2 % change it by as much
    assert 0 < abs(meshed["torque"]["reference"] / plain["torque"]["reference"] - 1) < 0.02
    coarse = command(*given[:-1], "10 %", "--compliance", "meshed")
    assert "ball and race of true shape" in " ".join(coarse.out.split())


def test_a_ball_that_the_search_does_not_hold_is_not_solved(command: Run) -> None:
    ended = command("creep", "6205-dry", "--load", "1e-9 N", "--speed", "1e-7 rpm")
    assert (ended.status, ended.out) == (3, "")
    assert "rotation of the ball did not converge" in ended.err
    assert len(ended.err.splitlines()) == 1


def test_an_accuracy_that_no_grid_reaches_is_said(command: Run) -> None:
    ended = command("creep", "6205-dry", "--tolerance", "0.01 %")
    assert ended.status == 3
    assert "not solved to 0.01 %" in ended.err
