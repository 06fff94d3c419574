"""Parts and words of the picture of a cage, from a job typed in by hand: where each one is, and how large."""

from typing import Any

import numpy as np
import pytest

from fembearing.report.pictures.render_cage import BALL, CAGE, FORCE, INK, RING, arrow_along, cage_front, cage_parts
from tests.report.pictures.sketch import Sketch, sketched

# The axis leans by sides 3, 4, 5: what is long in y is 0.8 times as long in the picture. 9 pixels are 1 mm.
JOB: dict[str, Any] = {
    "width": 700,
    "height": 760,
    "scale": 9e3,
    "axes": [[1.0, 0.0, 0.0], [0.0, 0.8, 0.6], [0.0, -0.6, 0.8]],
    "ball_radius": 4e-3,
    "pitch_radius": 19e-3,
    "pocket_radius": 5e-3,
    "wall": 1.5e-3,
    "balls": [[19e-3, 0.0, 0.0], [0.0, 17e-3, 2e-3]],
    "pockets": [[19.3e-3, 0.2e-3, 0.0], [-0.4e-3, 18e-3, 0.0]],
    "centre": [0.7e-3, -1.2e-3, 0.0],
    "tails": [[15e-3, 0.0, 0.0], [3e-3, 17e-3, 0.0], [-3e-3, 12e-3, 0.0]],
    "arrows": [[-6e-3, 0.0, 0.0], [0.5e-3, 0.0, 0.0], [0.3e-3, 0.0, 0.0]],  # the least that is shown: 0.4 mm
    "force_scale": {"length": 5e-3, "label": "2 N", "left": 35},
    "length_scale": {"length": 8e-3, "label": "8 mm", "left": 370},
    "pull": {"length": 3e-3, "label": "gravity", "room": 90},
    "title": ["first line", "second line"],
    "lines": ["third line", "fourth line"],
}
SINGLE = 2e-3  # pixels: single precision of VTK's points


@pytest.fixture(scope="module")
def sketch() -> Sketch:
    return sketched(cage_front, JOB)


def test_grooves_and_balls_are_to_scale_in_their_places(sketch: Sketch) -> None:
    """Grooves 15 and 23 mm from the axis, balls with a radius of 4 mm."""
    window = sketch.window
    for ring, radius in zip(window.of(RING), (9 * 15, 9 * 23), strict=True):
        low, high = window.box(ring)[:, :2]
        np.testing.assert_allclose((low + high) / 2, (350, 380), atol=SINGLE)
        np.testing.assert_allclose((high - low) / 2, (radius, 0.8 * radius), atol=SINGLE)
    for ball, place in zip(window.of(BALL), ((350 + 9 * 19, 380), (350, 380 + 9 * (17 * 0.8 + 2 * 0.6))), strict=True):
        low, high = window.box(ball)[:, :2]
        # a ball of 60 by 60 facets is narrower by up to 1 - cos 3 degrees
        np.testing.assert_allclose((low + high) / 2, place, atol=0.1)
        np.testing.assert_allclose((high - low) / 2, 9 * 4, rtol=2e-3)


def test_each_arrow_but_the_shortest_is_drawn_from_its_tail(sketch: Sketch) -> None:
    """6 mm to the left and 0.5 mm to the right; 0.3 mm are less than a tenth of a ball's radius."""
    window = sketch.window
    for arrow, (left, right), height in zip(
        window.of(FORCE)[:-1], ((15 - 6, 15), (3, 3.5)), (380, 380 + 9 * 17 * 0.8), strict=True
    ):
        low, high = window.box(arrow)[:, :2]
        np.testing.assert_allclose((low[0], high[0]), (350 + 9 * left, 350 + 9 * right), atol=SINGLE)
        np.testing.assert_allclose((low[1] + high[1]) / 2, height, atol=SINGLE)


def test_dots_mark_the_axis_and_the_centre_of_the_cage(sketch: Sketch) -> None:
    window = sketch.window
    for dot, place in ((window.of(INK)[0], (350, 380)), (window.of(CAGE)[-1], (350 + 9 * 0.7, 380 - 9 * 1.2 * 0.8))):
        low, high = window.box(dot)[:, :2]
        np.testing.assert_allclose((low + high) / 2, place, atol=0.05)  # pixels: a ball of 30 by 30 facets
        np.testing.assert_allclose((high - low) / 2, 9 * 0.4, rtol=2e-2)  # a tenth of a ball's; facets


def test_scales_and_gravity_are_as_long_as_they_say_above_their_words(sketch: Sketch) -> None:
    window = sketch.window
    force, (length, gravity) = window.box(window.of(FORCE)[-1]), map(window.box, window.of(INK)[1:])
    np.testing.assert_allclose(force[:, 0], (35, 35 + 9 * 5), atol=SINGLE)
    np.testing.assert_allclose(length[:, 0], (370, 370 + 9 * 8), atol=SINGLE)
    np.testing.assert_allclose(length[0, 1], force[:, 1].mean(), atol=SINGLE)
    assert 700 - 90 < gravity[0, 0] < gravity[1, 0] < 700
    np.testing.assert_allclose(np.ptp(gravity[:, 1]), 9 * 3, atol=SINGLE)
    points = window.pixels(window.of(INK)[2])
    widths = [np.ptp(points[np.abs(points[:, 1] - end) < 1, 0]) for end in gravity[:, 1]]
    np.testing.assert_allclose(widths, (0, 9 * 2 * 0.2), atol=SINGLE)  # the tip is below, the shaft above
    for begin, scale, left in (("2 N", force, 35), ("8 mm", length, 370), ("gravity", gravity, 700 - 90)):
        word = window.word(begin)
        assert word.left == left
        assert word.top < scale[0, 1] < 190, begin  # pixels: a quarter of the picture
    still = sketched(cage_front, JOB | {"pull": {"length": 0.0, "label": "no gravity", "room": 110}}).window
    assert len(still.of(INK)) == 2
    assert still.word("no gravity").left == 700 - 110


def test_words_stand_one_below_the_other_and_the_title_in_larger_letters(sketch: Sketch) -> None:
    head = [word for word in sketch.window.words if word.text.endswith("line")]
    assert [word.text.partition(" ")[0] for word in head] == ["first", "second", "third", "fourth"]
    assert len({word.left for word in head}) == 1
    steps = -np.diff([word.bottom for word in head])
    assert steps.min() == steps.max() > 2 * max(word.size for word in head)  # pixels of letters
    assert head[0].size == head[1].size > head[2].size == head[3].size


def test_grooves_lie_behind_all_bodies_and_forces_before_them(sketch: Sketch) -> None:
    window, near = sketch.window, []
    for meshes in (window.of(RING), [*window.of(BALL), *window.of(CAGE)[:-1]], [*window.of(FORCE), *window.of(INK)]):
        depth = np.concatenate([window.pixels(mesh)[:, 2] for mesh in meshes])
        near += [depth.min(), depth.max()]
    assert near == sorted(near)
    assert window.box(window.of(CAGE)[-1])[0, 2] > near[3]


@pytest.mark.parametrize(("length", "head"), [(6.0, 1.6), (1.2, 0.6)])
def test_an_arrow_is_as_thick_whatever_its_length_and_half_of_a_short_one_is_head(length: float, head: float) -> None:
    """Of a ball with a radius of 4 mm: the shaft 0.2 mm, the head 0.6 mm wide on each side and 1.6 mm long."""
    direction = np.array([2.0, -3.0, 6.0]) / 7
    points = np.asarray(arrow_along(length * direction, 4.0).points, dtype=float)
    along = points @ direction
    off = np.linalg.norm(points - along[:, None] * direction, axis=1)
    tail, tip = along < 1e-5, along > length - 1e-5  # mm: single precision
    np.testing.assert_allclose(along[~tail & ~tip], length - head, atol=1e-5)
    np.testing.assert_allclose((off[tail].max(), off[tip].max()), (0.2, 0.0), atol=1e-5)
    np.testing.assert_allclose(np.unique(off[~tail & ~tip].round(4)), (0.2, 0.6))


def test_a_rim_is_as_thick_as_the_wall_and_pockets_that_touch_have_no_bar_between() -> None:
    """Pockets of 5 mm with walls of 1.5 mm: the middles of two walls meet where pockets are 11.5 mm apart."""
    places = [[0.0, 0.0, 0.0], [11.5, 0.0, 0.0], [11.5, 9.0, 0.0], [11.5, 39.0, 0.0]]
    parts = cage_parts(JOB | {"pockets": (np.array(places) / 1e3).tolist()})
    rims, bars = [parts[k] for k in (0, 1, 2, 4)], [parts[k] for k in (3, 5)]
    assert len(parts) == 6
    for rim, place in zip(rims, places, strict=True):
        off = np.linalg.norm(rim.points[:, :2] - place[:2], axis=1)
        np.testing.assert_allclose(np.unique(off.round(4)), (5.0, 6.5))
        np.testing.assert_allclose(np.unique(rim.points[:, 2].round(4)), (-0.4, 0.4))  # a tenth of a ball's radius
    for bar, ends in zip(bars, ((places[2], places[3]), (places[3], places[0])), strict=True):
        direction = np.subtract(ends[1], ends[0]) / np.linalg.norm(np.subtract(ends[1], ends[0]))
        away = bar.points - ends[0]
        off = np.linalg.norm(away - np.outer(away @ direction, direction), axis=1)
        np.testing.assert_allclose(off, 0.4, atol=1e-5)  # mm: single precision
