"""Plot and picture of a cage in motion: drawn from a record whose forces and places are known, and read back."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from fembearing.check.cage_record import CageRecord
from fembearing.report.pictures.cage import cage_job, view_of
from fembearing.report.pictures.draw import RENDERER, rendered
from fembearing.report.pictures.render_cage import cage_parts
from tests.report.pictures.picture_reader import Pixels, half_sizes, is_red, longest_run, pixels_of

FORCES = {1: (0.0, 3.0, 0.0), 6: (-1.5, 0.0, 0.0)}  # N, of two balls at the instant that is drawn
FOOT = 100  # pixels with the scales


@pytest.fixture(scope="module")
def known(record: CageRecord) -> CageRecord:
    """At one instant known forces, and the cage moved without turning by 80 um to the right and 40 um down."""
    force, offset, centre = (np.array(getattr(record.series, name)) for name in ("force", "offset", "centre"))
    at = -7
    force[:] = 0.001
    force[at] = 0.0
    for ball, values in FORCES.items():
        force[at, ball] = values
    force[3, 0] = 9.0  # in the start-up: not to be drawn
    centre[at] = [80e-6, -40e-6, 0.0]
    offset[at] = -centre[at]
    return replace(record, series=replace(record.series, force=force, offset=offset, centre=centre))


def place_in(job: dict, x: float, y: float) -> tuple[float, float]:
    """Pixels from left and top of a place in the plane of the balls, m: the lean of 20 degrees foreshortens y."""
    return job["width"] / 2 + job["scale"] * x, job["height"] / 2 - job["scale"] * y * np.cos(np.radians(20))


@pytest.fixture(scope="module")
def drawn(known: CageRecord, tmp_path_factory: pytest.TempPathFactory) -> tuple[dict, Pixels]:
    job = cage_job(known, tmp_path_factory.mktemp("cage") / "cage.png")
    assert rendered([job], RENDERER) is None
    return job, pixels_of(Path(job["file"]))


def test_each_force_is_an_arrow_from_its_ball(known: CageRecord, drawn: tuple[dict, Pixels]) -> None:
    """Two forces: one up, 3 N, and one to the left, half as long; nothing of the other balls, nor of the start-up."""
    job, pixels = drawn
    angle = known.series.ball_angle[-7] + 2 * np.pi * np.array([1, 6]) / 9
    up, left = (19.505e-3 * np.array([np.cos(a), np.sin(a)]) for a in angle)
    radius, length = 3.97e-3, 1.8 * 3.97e-3  # the longest arrow is 1.8 radii long
    red = is_red(pixels)
    red[-FOOT:] = False
    columns = np.arange(red.shape[1])
    x, bottom = place_in(job, up[0], up[1] + radius)
    _, top = place_in(job, up[0], up[1] + radius + length)
    near = red & (np.abs(columns - x) < 30)
    rows = np.nonzero(near)[0]
    np.testing.assert_allclose((rows.min(), rows.max()), (top, bottom), atol=4)  # pixels: a shaft has thickness
    tail, y = place_in(job, left[0] - radius, left[1])
    tip, _ = place_in(job, left[0] - radius - length / 2, left[1])
    other = red & ~near
    across, _, middle, height = half_sizes(other)
    np.testing.assert_allclose((middle - across, middle + across), (tip, tail), atol=4)
    np.testing.assert_allclose(height, y, atol=3)


def test_the_outer_groove_is_a_circle_around_the_balls(known: CageRecord, drawn: tuple[dict, Pixels]) -> None:
    """A grey line, one ball radius outside the circle of the ball centres; looked for between balls."""
    job, pixels = drawn
    for angle in known.series.ball_angle[-7] + 2 * np.pi * (np.array([2, 3, 4, 8]) + 0.5) / 9:
        x, y = (round(each) for each in place_in(job, *(23.475e-3 * np.array([np.cos(angle), np.sin(angle)]))))
        near = pixels[y - 4 : y + 5, x - 4 : x + 5]  # pixels: the line is 3 wide
        grey = (np.abs(near.mean(axis=-1) - 0.75) < 0.1) & (np.ptp(near, axis=-1) < 0.05)
        assert np.count_nonzero(grey) >= 6, angle


def test_the_scale_of_forces_is_that_of_the_arrows(drawn: tuple[dict, Pixels]) -> None:
    """2 N where the longest arrow, 1.8 ball radii, is 3 N; 10 mm as long as balls are wide."""
    job, pixels = drawn
    assert job["force_scale"]["label"] == "2 N, ball on cage"
    assert job["length_scale"]["label"] == "10 mm, balls and grooves"
    foot = pixels[-FOOT:]
    expected = job["scale"] * 1.8 * 3.97e-3 * 2 / 3
    np.testing.assert_allclose(longest_run(is_red(foot)), expected, atol=3)  # pixels
    black = foot[:, : job["width"] - 100].max(axis=-1) < 0.35  # without the arrow of gravity
    np.testing.assert_allclose(longest_run(black), job["scale"] * 10e-3, atol=5)


def test_the_cage_is_drawn_where_it_is_ten_times_exaggerated(known: CageRecord, drawn: tuple[dict, Pixels]) -> None:
    """Balls on their circle; the dot of the cage's centre 0.8 mm to the right of the axis and 0.4 mm below it."""
    job, pixels = drawn
    assert view_of(known).exaggeration == 10
    red, green, blue = np.moveaxis(pixels, -1, 0)
    near = np.s_[job["height"] // 2 - 60 : job["height"] // 2 + 60, job["width"] // 2 - 60 : job["width"] // 2 + 60]
    brown = ((red > 0.7) & (green > 0.4) & (green < 0.65) & (blue < 0.4))[near]
    black = (pixels.max(axis=-1) < 0.2)[near]
    _, _, x, y = half_sizes(brown)
    _, _, x0, y0 = half_sizes(black)
    np.testing.assert_allclose((x0, y0), 60, atol=1.5)
    # Half a dot hides behind the other: from the middle of what is seen to the edge.
    edge = np.array(place_in(job, 0.8e-3, -0.4e-3)) - place_in(job, 0.0, 0.0)
    np.testing.assert_allclose((x - x0, y - y0), edge, atol=3)
    ball = (blue > red + 0.05)[110:-FOOT]
    across, *_ = half_sizes(ball)
    angle = known.series.ball_angle[-7] + 2 * np.pi * np.arange(9) / 9
    widest = np.ptp(np.cos(angle)) * 19.505e-3 + 2 * 3.97e-3
    np.testing.assert_allclose(2 * across, job["scale"] * widest, atol=4)
    assert brown_share(pixels) > 0.02


def brown_share(pixels: Pixels) -> float:
    """Of the picture: the cage."""
    red, green, blue = np.moveaxis(pixels, -1, 0)
    return float(np.mean((red > green + 0.1) & (green > blue + 0.1) & ~is_red(pixels)))


def test_a_pocket_is_pressed_where_its_ball_is(known: CageRecord) -> None:
    """Exaggerated or not, the ball is as near to the pocket's wall in shares of the room."""
    job, view = cage_job(known, Path("nowhere.png")), view_of(known)
    gap = np.linalg.norm(np.array(job["pockets"]) - view.balls, axis=1)
    room = job["pocket_radius"] - job["ball_radius"]
    np.testing.assert_allclose(gap / room, np.hypot(80, 40) / 100, rtol=1e-9)


def test_a_bar_of_the_cage_begins_and_ends_in_the_middle_of_a_pockets_wall() -> None:
    """In unequal steps, in mm: bars join pockets 30, 40 and 50 mm apart."""
    job = {
        "pocket_radius": 6e-3,
        "wall": 1.4e-3,
        "ball_radius": 5e-3,
        "pockets": [[0.0, 0.0, 0.0], [30e-3, 0.0, 0.0], [30e-3, 40e-3, 0.0]],
    }
    parts = cage_parts(job)
    places, bars = 1e3 * np.array(job["pockets"]), parts[1::2]
    assert len(parts) == 6
    for place, following, bar in zip(places, np.roll(places, -1, axis=0), bars, strict=True):
        length = float(np.linalg.norm(following - place))
        along = (bar.points - place) @ (following - place) / length
        # single precision of the points
        np.testing.assert_allclose((along.min(), along.max()), (6.7, length - 6.7), rtol=1e-5)


def test_a_cage_that_nothing_touches_has_arrows_without_a_length(known: CageRecord) -> None:
    job = cage_job(replace(known, series=replace(known.series, force=0 * known.series.force)), Path("nowhere.png"))
    np.testing.assert_array_equal(job["arrows"], np.zeros((9, 3)))
    np.testing.assert_array_equal(job["tails"], job["balls"])


def test_a_wide_pocket_is_drawn_to_scale(known: CageRecord) -> None:
    """A clearance of 2 mm needs no exaggeration, and is not drawn narrower: 0.3 of a ball's radius are 1.2 mm."""
    wide = replace(known, cage=replace(known.cage, half_clearance=2e-3))
    assert view_of(wide).exaggeration == 1
    assert cage_job(wide, Path("nowhere.png"))["pocket_radius"] == pytest.approx(5.97e-3)
