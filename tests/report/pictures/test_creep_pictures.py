"""The pictures of friction, read back: what is blue sticks, and lengths are those of the scale; and their jobs."""

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.image import imread

from fembearing.check.validation import Validation
from fembearing.creep.strips import Strips
from fembearing.report.pictures import creep as module
from fembearing.report.pictures.creep import WIDTH, CreepPicture, creep_pictures
from fembearing.report.pictures.draw import Picture

BLUE, CLOSE = np.array([65, 105, 225]) / 255, 0.12  # royal blue, but for lines between rectangles and smoothed edges
LEGEND = 60  # pixels from the left, with a blue square of its own


def test_blue_is_as_large_as_what_sticks_and_the_ellipse_as_long_as_its_scale(
    checked: Validation, slipping: dict[Path, CreepPicture], pictures: list[Picture]
) -> None:
    assert pictures  # VTK has drawn all of them
    for (file, picture), race in zip(slipping.items(), checked.creep[0].numbers.races.values(), strict=True):
        job, seen = picture.job, imread(file)[..., :3]
        blue = np.sqrt(np.sum((seen - BLUE) ** 2, axis=2)) < CLOSE
        edges, (left, right) = np.array(job["edges"]), np.array(job["sides"])
        areas = np.diff(edges, axis=1) * (right - left)[:, None]
        expected = np.sum(areas[np.array(job["sticks"])]) * job["scale"] ** 2 * job["stretch"]
        assert expected > 0
        # Edges of rectangles, a pixel wide, are smoothed.
        np.testing.assert_allclose(np.count_nonzero(blue[:, LEGEND:]), expected, rtol=0.1, atol=40)
        painted = np.flatnonzero((seen[job["height"] - 248] < 0.99).any(axis=1))  # across the middle of the lower one
        length = 2 * race.semi_axis_transverse * job["scale"]
        np.testing.assert_allclose(np.ptp(painted), length, atol=4)  # the ellipse of another grid, and its line
        np.testing.assert_allclose((painted[0] + painted[-1]) / 2, WIDTH / 2, atol=4)
        assert picture.listed.kind == "creep"


# Rectangles of three strips with two cells: what sticks slips by less than 1e-9 of the fastest, 0.06 m/s.
SLIP = np.array([[[0.0, 3e-11], [0.036, 1e-8], [0.01, 0.02]], [[0.0, 4e-11], [0.048, 0.0], [0.02, 0.01]]])  # m/s
TRACTION = 1e6 * np.array([[[1.0, 2.0], [48.0, 3.0], [4.0, 5.0]], [[2.0, 3.0], [-55.0, 1.0], [6.0, 7.0]]])  # Pa
SPEED, ROLLING = 200.0, 0.013  # rad/s and m


def contact_of(a: float, b: float, *, slip: np.ndarray = SLIP) -> Any:
    """A contact of these semi-axes, m, whose slip is given in m/s."""
    middle, width = b * np.array([-0.6, 0.1, 0.7]), b * np.array([0.8, 0.6, 0.4])
    strips = Strips(middle=middle, width=width, rear=-a * np.ones(3), front=a * np.ones(3), cells=2)
    friction = SimpleNamespace(
        strips=strips,
        pressure=1e9 * np.array([[2e-4, 0.3], [1.3, 1.2], [0.5, 0.4]]),
        traction=TRACTION,
        slip=slip / (SPEED * ROLLING),
        slip_share=0.62,
    )
    return SimpleNamespace(
        semi_axis_rolling=a, semi_axis_transverse=b, rolling_speed=ROLLING, angle=-0.3, load=40.0, friction=friction
    )


def creep_of(*races: Any, strips: int = 28, coefficient: float | None = None) -> Any:
    """What `creep_pictures` reads of a checked scene."""
    return SimpleNamespace(
        reference=SimpleNamespace(finest=SimpleNamespace(races=races), grids=[SimpleNamespace(strips=strips)]),
        ball=SimpleNamespace(speed=SPEED),
        numbers=SimpleNamespace(friction_coefficient=coefficient, bearing=None),
    )


LONG, ROUND = contact_of(0.1e-3, 1e-3), contact_of(0.5e-3, 0.6e-3, slip=0 * SLIP)


def test_a_job_has_the_contact_as_large_as_there_is_room(tmp_path: Path) -> None:
    """1160 by 290 pixels at most: 2 mm across fill the width, and 0.2 mm along rolling, 116 pixels, the height twice.

    The round one, 1.2 mm by 1 mm, fills the height and nothing is stretched.
    """
    long, round_ = creep_pictures(creep_of(LONG, ROUND), tmp_path)
    job = long.job
    assert job["file"] == str(tmp_path / "inner-creep.png")
    assert (job["scale"], job["stretch"]) == (pytest.approx(580e3), 2)
    assert (round_.job["scale"], round_.job["stretch"]) == (pytest.approx(290e3), 1)
    assert job["semi_axes"] == [0.1e-3, 1e-3]
    np.testing.assert_allclose(job["sides"], 1e-3 * np.array([[-1.0, -0.2, 0.5], [-0.2, 0.4, 0.9]]), rtol=1e-12)
    np.testing.assert_allclose([size for size, _ in job["bars"]], (0.2e-3, 0.02e-3))  # within 220 and 55 pixels
    assert [words for _, words in job["bars"]] == ["0.2 mm across", "0.02 mm along rolling"]
    assert "drawn 2 times as long along rolling as across" in long.caption
    assert "drawn to scale" in round_.caption
    assert "40 N, oil and surfaces" in job["title"]


def test_a_job_has_pressure_slip_and_tractions_in_their_units(tmp_path: Path) -> None:
    """The greatest traction, 73 MPa of 48 and 55 MPa, is an arrow of 44 pixels; where nothing slips a scale remains."""
    long, round_ = creep_pictures(creep_of(LONG, ROUND), tmp_path)
    job = long.job
    assert job["per_traction"] * 73e6 == pytest.approx(44)
    assert job["arrow"] == [pytest.approx(50e6), "50 MPa"]
    np.testing.assert_array_equal(job["traction"], TRACTION)
    np.testing.assert_allclose(job["pressure"]["values"], [[2e-4, 0.3], [1.3, 1.2], [0.5, 0.4]], rtol=1e-12)
    assert (job["pressure"]["unit"], job["pressure"]["most"]) == ("GPa", pytest.approx(1.3))
    np.testing.assert_allclose(job["slip"]["values"], 1e3 * np.hypot(*SLIP), rtol=1e-12)  # mm/s
    assert (job["slip"]["unit"], job["slip"]["most"]) == ("mm/s", pytest.approx(60))
    assert job["sticks"] == [[True, True], [False, False], [False, False]]
    for ticks, most in ((job["pressure"]["ticks"], 1.3), (job["slip"]["ticks"], 60)):
        assert ticks[0] == 0
        assert 0.7 * most < ticks[-1] <= most
    assert np.all(round_.job["sticks"])
    assert round_.job["slip"]["most"] == 1


@pytest.mark.parametrize(("strips", "finer"), [(27, True), (28, False)])
def test_a_coarse_reference_is_solved_on_a_finer_grid_for_its_picture(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, strips: int, finer: bool
) -> None:
    other = SimpleNamespace(races=(contact_of(0.2e-3, 1.7e-3), contact_of(0.3e-3, 1.9e-3)))
    monkeypatch.setattr(module, "turn_ball", lambda *_: other)
    creep = creep_of(LONG, ROUND, strips=strips, coefficient=0.07)
    inner, outer = creep_pictures(creep, tmp_path)
    assert [each.job["semi_axes"][0] for each in (inner, outer)] == ([0.2e-3, 0.3e-3] if finer else [0.1e-3, 0.5e-3])
    assert "friction coefficient 0.07" in inner.job["title"]
