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
