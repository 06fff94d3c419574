"""Parts and words of the picture of friction, from a job typed in by hand: where each one is, and how large."""

from itertools import pairwise
from typing import Any

import numpy as np
import pytest

from fembearing.report.pictures.render_creep import ARROW, INK, PRESSURES, SLIPS, STUCK, creep_map
from tests.report.pictures.sketch import Sketch, sketched

MIDDLES = 612, 248  # pixels from below: of the ellipse of pressure and of that of slip
HALF_HEIGHT = 145  # pixels of an ellipse at most
ACROSS, ALONG = 200, 600  # pixels for 1 mm: three times as long along rolling
SIDES = np.array([[-1.2, -0.4, 0.11, 0.14, 0.17], [-0.4, 0.1, 0.13, 0.17, 0.21]])  # mm, of five strips
# mm: cells 9 pixels long on most strips, so that there is room for an arrow on every second one
EDGES = np.outer([0.9, 1.1, 1.0, 1.0, 1.0], [-0.04, -0.025, -0.01, 0.004, 0.02, 0.033])
# pixels of arrows, by strip and cell
DRAWN = {(0, 1): (12.0, 16.0), (1, 1): (-3.0, 4.0), (1, 3): (1.9, -2.4), (2, 3): (-8.0, -15.0), (4, 3): (20.0, -15.0)}
SHORT = {(0, 3): (1.7, -2.4), (2, 1): (0.0, 2.9)}  # less than 3 pixels
CROWDED = {(0, 0): (8.0, 9.0), (1, 2): (9.0, 8.0), (2, 4): (7.0, 8.0)}  # within 12 pixels of others along a strip
BETWEEN = {(3, 1): (30.0, 7.0)}  # likewise across
SINGLE = 1e-4  # pixels: single precision of VTK's points, at 1000


def job_of(*, sticks: list[tuple[int, int]], **other: object) -> dict[str, Any]:
    traction, stuck = np.zeros((2, 5, 5)), np.zeros((5, 5), dtype=bool)
    for (strip, cell), (across, along) in (DRAWN | SHORT | CROWDED | BETWEEN).items():
        traction[:, strip, cell] = along / 2e-7, across / 2e-7
    for place in sticks:
        stuck[place] = True
    values = np.arange(25.0).reshape(5, 5)
    return {
        "width": 1400,
        "height": 900,
        "scale": 1e3 * ACROSS,
        "stretch": 3,
        "semi_axes": [0.2e-3, 1.5e-3],
        "edges": (EDGES / 1e3).tolist(),
        "sides": (SIDES / 1e3).tolist(),
        "traction": traction.tolist(),
        "pressure": {"values": (values / 10).tolist(), "unit": "GPa", "most": 2.4, "ticks": [0.0, 1.0, 2.0]},
        "slip": {"values": (50 - values).tolist(), "unit": "mm/s", "most": 50.0, "ticks": [0.0, 20.0, 40.0]},
        "sticks": stuck.tolist(),
        "per_traction": 2e-7,
        "arrow": [1.7e8, "170 MPa"],
        "bars": [[0.9e-3, "0.9 mm across"], [0.08e-3, "0.08 mm along rolling"]],
        "title": "a contact",
    } | other


@pytest.fixture(scope="module")
def sketch() -> Sketch:
    return sketched(creep_map, job_of(sticks=[(0, 2), (3, 4)]))


def cell_box(strip: int, cell: int, middle: float) -> np.ndarray:
    """(2, 2) the corners of a rectangle in pixels."""
    return np.column_stack(
        [700 + ACROSS * SIDES[:, strip], middle + ALONG * EDGES[strip, cell : cell + 2]]
    )  # both increase


def test_each_rectangle_is_painted_in_its_place_with_its_value(sketch: Sketch) -> None:
    """Pressure above, slip below, each with a bar of colours under it."""
    window = sketch.window
    for name, colours, middle in zip(("pressure", "slip"), (PRESSURES, SLIPS), MIDDLES, strict=True):
        (part,) = (part for part in window.parts if part.look.get("cmap") == colours)
        shown = job_of(sticks=[])[name]
        places = [(strip, cell) for strip in range(5) for cell in range(5)]
        boxes = [cell_box(strip, cell, middle) for strip, cell in places]
        corners = window.pixels(part.mesh)[part.mesh.regular_faces][..., :2]
        np.testing.assert_allclose(corners.min(axis=1), [low for low, _ in boxes], atol=SINGLE)
        np.testing.assert_allclose(corners.max(axis=1), [high for _, high in boxes], atol=SINGLE)
        areas = part.mesh.compute_cell_sizes(length=False, volume=False).cell_data["Area"]
        np.testing.assert_allclose(areas, [np.prod(high - low) for low, high in boxes], rtol=1e-4)  # single precision
        np.testing.assert_array_equal(part.mesh.cell_data[name], np.ravel(shown["values"]))
        assert part.look["clim"] == [0, shown["most"]]
        bar = part.look["scalar_bar_args"]
        assert bar["title"].strip() == f"{'slip speed' if name == 'slip' else name}, {shown['unit']}"
        np.testing.assert_array_equal(sketch.scalar_bars[bar["title"]].values, shown["ticks"])
        low, high = 900 * bar["position_y"], 900 * (bar["position_y"] + bar["height"])
        assert max(0, middle - 2 * HALF_HEIGHT) < low < high < middle - HALF_HEIGHT
        assert 0.5 < bar["position_x"] < bar["position_x"] + bar["width"] < 1


def test_blue_are_the_rectangles_that_stick(sketch: Sketch) -> None:
    window = sketch.window
    corners = window.pixels(window.of(STUCK)[0]).reshape(2, 4, 3)[..., :2]
    for found, (strip, cell) in zip(corners, ((0, 2), (3, 4)), strict=True):
        low, high = cell_box(strip, cell, 248)
        np.testing.assert_allclose((found.min(axis=0), found.max(axis=0)), (low, high), atol=SINGLE)
    assert len(sketched(creep_map, job_of(sticks=[])).window.of(STUCK)) == 1  # in the legend


def test_both_ellipses_are_drawn_before_their_rectangles(sketch: Sketch) -> None:
    """1.5 mm across and 0.2 mm along rolling, which is drawn three times as long; tractions before everything."""
    window = sketch.window
    painted = [part.mesh for part in window.parts if "cmap" in part.look]
    layers = [painted, window.of(STUCK)[:1], window.of(INK)[:2], window.of(ARROW)[:-1]]
    depths = [[window.box(mesh)[:, 2] for mesh in layer] for layer in layers]
    for behind, before in pairwise(depths):
        assert np.max(behind) < np.min(before)
    for ring, middle in zip(layers[2], MIDDLES, strict=True):
        x, y = (window.pixels(ring)[:, :2] - (700, middle)).T
        np.testing.assert_allclose(
            (x / (1.5 * ACROSS)) ** 2 + (y / (0.2 * ALONG)) ** 2, 1, atol=1e-5
        )  # single precision
        np.testing.assert_allclose((np.ptp(x), np.ptp(y)), (2 * 1.5 * ACROSS, 2 * 0.2 * ALONG), rtol=1e-5)


def outline(tail: np.ndarray, arrow: np.ndarray) -> np.ndarray:
    """(7, 2): a shaft of 1.5 pixels; the head 5.2 wide and 6 long, but no longer than 0.6 of a short arrow."""
    length = float(np.hypot(*arrow))
    neck = length - min(6.0, 0.6 * length)
    along = np.array([0, 0, neck, neck, neck, neck, length])
    off = np.array([-0.75, 0.75, -0.75, 0.75, -2.6, 2.6, 0])
    return tail + np.outer(along, arrow / length) + np.outer(off, [-arrow[1] / length, arrow[0] / length])


def test_tractions_are_arrows_where_there_is_room_for_them(sketch: Sketch) -> None:
    """From the middle of their rectangles on the ellipse of pressure; on every second one, and on strips apart."""
    window = sketch.window
    for mesh, ((strip, cell), size) in zip(window.of(ARROW)[:-1], DRAWN.items(), strict=True):
        tail, arrow = cell_box(strip, cell, 612).mean(axis=0), np.array(size)
        found, expected = window.pixels(mesh)[:, :2], outline(tail, arrow)
        away = np.linalg.norm(found[:, None] - expected, axis=2)
        np.testing.assert_allclose(away.min(axis=0), 0, atol=SINGLE)  # each corner is there, and no other
        np.testing.assert_allclose(away.min(axis=1), 0, atol=SINGLE)
        head = min(6.0, 0.6 * np.hypot(*arrow))
        assert mesh.area == pytest.approx(1.5 * (np.hypot(*arrow) - head) + 2.6 * head, rel=1e-4)  # single precision
    wide = job_of(sticks=[], stretch=9)  # 27 pixels to a cell: room on each
    assert len(sketched(creep_map, wide).window.of(ARROW)) == len(DRAWN) + len(CROWDED) + 1  # and the legend's


def test_the_legend_says_what_arrows_blue_and_bars_are(sketch: Sketch) -> None:
    """Words beside what they explain, below the ellipse that it belongs to."""
    window = sketch.window
    arrow, square = window.box(window.of(ARROW)[-1]), window.box(window.of(STUCK)[-1])
    across, ahead = (window.box(line) for line in window.of(INK)[2:])
    np.testing.assert_allclose(np.ptp(arrow[:, 0]), 34, atol=SINGLE)
    np.testing.assert_allclose(np.ptp(across, axis=0)[:2], (0.9 * ACROSS, 0), atol=SINGLE)
    np.testing.assert_allclose(np.ptp(ahead, axis=0)[:2], (0, 0.08 * ALONG), atol=SINGLE)
    np.testing.assert_allclose(across[0], ahead[0], atol=SINGLE)  # from one corner to the right and up
    assert window.of(STUCK)[-1].area == pytest.approx(np.prod(np.ptp(square, axis=0)[:2]), rel=1e-6) != 0
    for begin, part, height, middle in (
        ("traction on the ball: 170 MPa", arrow, arrow[:, 1].mean(), 612),
        ("sticks", square, square[:, 1].mean(), 248),
        ("0.9 mm across", across, across[1, 1], 248),
        ("0.08 mm along rolling", ahead, ahead[1, 1], 248),
    ):
        word = window.word(begin)
        assert part[1, 0] < word.left < part[1, 0] + 60, begin
        assert word.bottom < height < word.top, begin
        assert max(0, middle - 2 * HALF_HEIGHT) < part[0, 1] <= part[1, 1] < middle - HALF_HEIGHT, begin


def test_the_title_stands_above_what_is_said_below_it(sketch: Sketch) -> None:
    title, entry = sketch.window.word("a contact"), sketch.window.word("surfaces enter")
    assert title.bottom > entry.top > entry.bottom > 612 + HALF_HEIGHT
    assert title.left == entry.left
    assert title.size > entry.size
