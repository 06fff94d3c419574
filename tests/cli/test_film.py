"""`fembearing film`: the solution of the given contact beside the formulas."""

import json
from pathlib import Path
from typing import Any

import pytest

from analytic.scenefile.read import load_scene
from fembearing import cli
from fembearing.check.contact.scene_contact import contact_of

LOAD, SPEED = 83.0, 740.0  # N, rpm: a small contact, quick to solve


def run(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, *words: str) -> tuple[int, str, str]:
    monkeypatch.setattr("sys.argv", ["fembearing", "film", *words])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    printed = capsys.readouterr()
    code = stop.value.code
    return (code if isinstance(code, int) else 0), printed.out, printed.err


def solved(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, *words: str) -> dict[str, Any]:
    code, out, _ = run(capsys, monkeypatch, "paper_6205", "--tolerance", "10 %", "--json", *words)
    assert code == 0
    return json.loads(out)


@pytest.mark.slow
def test_film_and_force_of_the_load_and_speed_that_are_asked_for(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    given = ("--load", f"{LOAD:g} N", "--speed", f"{SPEED:g} rpm")
    once = solved(capsys, monkeypatch, *given, "--out", str(tmp_path / "film"))
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

    faster = solved(capsys, monkeypatch, "--load", f"{LOAD:g} N", "--speed", f"{4 * SPEED:g} rpm")
    # Elastohydrodynamic films grow with speed to the power of 0.67 or so, rolling forces with 0.7 or so.
    for name, most in (("central_film", 0.75), ("rolling_force", 0.85)):
        slow, fast = (each["quantities"][name]["reference"] for each in (once, faster))
        assert 4**0.55 < fast / slow < 4**most


@pytest.mark.slow
def test_true_shapes_change_a_film_by_parts_in_a_thousand(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    given = ("--load", "372 N", "--speed", "500 rpm")
    plain, meshed = (solved(capsys, monkeypatch, *given, "--compliance", kind) for kind in ("half-space", "meshed"))
    assert (plain["compliance"], meshed["compliance"]) == ("half-space", "meshed")
    # Of finer grids: +0.2 and +0.35 %, validation/ehl/true_shapes.csv. The errors of equal grids nearly cancel.
    for name, change in (("central_film", 2.05e-3), ("rolling_force", 3.5e-3)):
        assert meshed[name]["numerical"] / plain[name]["numerical"] - 1 == pytest.approx(change, abs=1.5e-3)
        assert meshed[name]["production"] == plain[name]["production"]


@pytest.mark.parametrize(
    ("words", "key"),
    [
        (("6205-dry",), "[lubricant]"),
        (("paper_6205", "--speed", "0 rpm"), "--speed"),
        (("paper_6205", "--load", "-3 N"), "--load"),
        (("paper_6205", "--load", "90 kN"), "GPa"),
        (("paper_6205", "--speed", "3 mm"), "operation.inner_speed"),
        (("paper_6205", "--pair", "pocket"), "pocket"),
        (("paper_6205", "--out", "film.png"), "--out"),
        (("paper_6205", "--load", "5 kN", "--compliance", "meshed"), "too wide for a ball"),
    ],
)
def test_a_mistake_gives_one_line(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, words: tuple[str, ...], key: str
) -> None:
    code, out, err = run(capsys, monkeypatch, *words)
    assert (code, out) == (2, "")
    assert key in err
    assert "Traceback" not in err
