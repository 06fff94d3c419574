"""Clearances and pairs as `fembearing torque` shows them, in the document, and where a pair is refused."""

from io import StringIO

import pytest
from rich.console import Console

from analytic.errors import InputError
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import parse_scene
from fembearing.check.contact.solution import solve_contact
from fembearing.report.terminal.torque import print_details
from fembearing.report.torque import torque_record

SCENE = """\
name = "installed"
tolerance = "5 %"
[bearing]
catalog = "6205"
[mounting]
shaft_interference = "{tight} um"
[operation]
axial_load = ["300 N", "2500 N"]
inner_speed = "1000 rpm"
[friction]
coefficient = 0.1
spin_rule = "balanced"  # free balls of a pair take seconds
[effects]
weight = "off"
creep = "off"
"""
PAIR = '[arrangement]\nkind = "O"\npreload = "250 N"\n'


def found(more: str = "", *, tight: int = 12) -> SceneTorque:
    return torque_of_scene(parse_scene(SCENE.format(tight=tight) + more, origin="here"))


def printed(result: SceneTorque) -> str:
    out = StringIO()
    print_details(Console(file=out, width=80), result)
    return out.getvalue()


def test_clearances_are_shown_and_kept() -> None:
    result = found(tight=25)
    clearances = result.friction.clearances
    assert clearances is not None
    words = " ".join(printed(result).split())
    assert f"{clearances.unmounted * 1e6:.3g} um unmounted" in words
    assert f"{clearances.operating * 1e6:.3g} um operating; every ball is preloaded" in words
    assert "shaft seat 25 um tight" in words
    assert "housing seat loose" in words
    assert any("no clearance in operation" in each for each in result.friction.warnings)
    document = torque_record(result).clearances
    assert document is not None
    assert document.ball_load == clearances.ball_load > 0
    assert not any("no clearance in operation" in each for each in found(tight=5).friction.warnings)


def test_both_bearings_have_their_rows() -> None:
    result = found(PAIR)
    pair = result.friction.pair
    assert pair is not None
    said = printed(result)
    assert max(map(len, said.splitlines())) <= 80
    rows = [line.split() for line in said.splitlines()]
    for point in range(2):
        first = next(row for row in rows if row[:2] == [str(point + 1), "first"])
        assert first[2] == f"{pair.equilibrium.axial_load[0, point]:.4g}"
        assert first[-2:] == [f"{pair.total[0, point] * 1e3:.4g}", f"{pair.equilibrium.stiffness[point] / 1e6:.4g}"]
    assert ["2", "second,", "relieved"] in [row[:3] for row in rows]
    words = " ".join(said.split())
    assert "Friction torque of two 6205" in words
    assert "Preload 250 N at standstill, by closing" in words
    assert "no lubricant is given" in words  # so that no maker's formula holds


def test_contacts_of_a_pair_are_refused() -> None:
    with pytest.raises(InputError, match=r"\[arrangement\] has two bearings"):
        solve_contact(parse_scene(SCENE.format(tight=5) + PAIR, origin="here"), pair="inner")
