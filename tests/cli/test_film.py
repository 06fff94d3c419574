"""`fembearing film`: the solution of the given contact beside the formulas."""

import json
from pathlib import Path
from typing import Any

import pytest

from analytic.scenefile.read import load_scene
from fembearing.check.contact.scene_contact import contact_of

LOAD, SPEED = 83.0, 740.0  # N, rpm: a small contact, quick to solve


def solved(command: Any, *words: str) -> dict[str, Any]:
    ended = command("film", "paper_6205", "--tolerance", "10 %", "--json", *words)
    assert ended.status == 0
    return json.loads(ended.out)


@pytest.mark.slow
def test_film_and_force_of_the_load_and_speed_that_are_asked_for(command, tmp_path: Path) -> None:
    given = ("--load", f"{LOAD:g} N", "--speed", f"{SPEED:g} rpm")
    once = solved(command, *given, "--out", str(tmp_path / "film"))
    assert (once["pair"], once["load"]) == ("inner", LOAD)
    for name in ("central_film", "minimum_film", "rolling_force", "pressure_centre"):
        part = once["quantities"][name]
        assert part["discrepancy"] == pytest.approx(part["production"] / part["reference"] - 1, rel=1e-12)
        assert 0 < part["uncertainty"] < 0.1 * part["reference"]
    assert once["quantities"]["minimum_film"]["reference"] < once["quantities"]["central_film"]["reference"]
    # The moment of the pressure is Q x_p, and f = Q x_p/(2 R_x) for parabolas; circles differ by parts in a hundred.
    contact = contact_of(load_scene("paper_6205"), pair="inner")
    centre = once["quantities"]["pressure_centre"]["reference"]
    force = LOAD * centre / 2 * (1 / contact.ball_radius + 1 / contact.rolling_radius)
    assert once["quantities"]["rolling_force"]["reference"] == pytest.approx(force, rel=0.03)
    written = json.loads((tmp_path / "film/film.json").read_text())
    assert written.pop("picture")["file"] == "film.png"
    assert written.keys() == once.keys()
    assert (tmp_path / "film/film.png").read_bytes().startswith(b"\x89PNG")

    faster = solved(command, "--load", f"{LOAD:g} N", "--speed", f"{4 * SPEED:g} rpm")
    # Elastohydrodynamic films grow with speed to the power of 0.67 or so, rolling forces with 0.7 or so.
    for name, most in (("central_film", 0.75), ("rolling_force", 0.85)):
        slow, fast = (each["quantities"][name]["reference"] for each in (once, faster))
        assert 4**0.55 < fast / slow < 4**most


@pytest.mark.slow
def test_true_shapes_change_a_film_by_parts_in_a_thousand(command) -> None:
    given = ("--load", "372 N", "--speed", "500 rpm")
    plain, meshed = (solved(command, *given, "--compliance", kind) for kind in ("half-space", "meshed"))
    assert (plain["compliance"], meshed["compliance"]) == ("half-space", "meshed")
    # Of finer grids: +0.2 and +0.35 %, validation/ehl/true_shapes.csv. The errors of equal grids nearly cancel.
    for name, change in (("central_film", 2.05e-3), ("rolling_force", 3.5e-3)):
        true, half = (each["quantities"][name] for each in (meshed, plain))
        assert true["reference"] / half["reference"] - 1 == pytest.approx(change, abs=1.5e-3)
        assert true["production"] == half["production"]


@pytest.mark.parametrize(
    ("words", "key"),
    [
        (("6205-dry",), "[lubricant]"),
        (("paper_6205", "--speed", "0 rpm"), "--speed"),
        (("paper_6205", "--load", "90 kN"), "GPa"),
        (("paper_6205", "--pair", "pocket"), "pocket"),
        (("paper_6205", "--load", "5 kN", "--compliance", "meshed"), "too wide for a ball"),
    ],
)
def test_a_mistake_gives_one_line(command, words: tuple[str, ...], key: str) -> None:
    ended = command("film", *words)
    assert (ended.status, ended.out) == (2, "")
    assert key in ended.err
    assert "Traceback" not in ended.err
