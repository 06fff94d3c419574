"""The drawing of a bearing: what is drawn has the dimensions of the scene, and words do not lie on each other."""

from dataclasses import replace
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.transforms import Bbox

from analytic.errors import InputError
from analytic.scene import Arrangement, Scene
from analytic.scenefile.read import load_scene
from fembearing.report.drawing import draw_bearing
from fembearing.report.figures.bearing_section import section_of

ROOT = Path(__file__).resolve().parents[3]
RIG = str(ROOT / "examples/thrust_rig_3mm.toml")


def scene_of(name: str) -> Scene:
    scene = load_scene(name.removesuffix(", a pair"))
    if not name.endswith("pair"):
        return scene
    return replace(scene, arrangement=Arrangement(kind="O", preload=130.0, distance=0.031))


@pytest.mark.parametrize("name", ["6205", "7208B", "paper_6205", RIG])
def test_the_ball_touches_both_grooves_at_the_contact_angle_and_goes_through_neither(name: str) -> None:
    bearing = load_scene(name).bearing
    section, radius = section_of(bearing), bearing.ball_diameter / 2
    for ring, sign in ((section.inner, -1), (section.outer, 1)):
        points = ring.groove.points - section.ball
        distance = np.hypot(*points.T)
        assert distance.min() == pytest.approx(radius, rel=2e-4)  # the arc has 61 points
        nearest = sign * points[np.argmin(distance)] / distance.min()
        apart = np.degrees(np.arccos(min(1.0, nearest @ section.across)))
        assert apart < 2  # degrees: half the distance of two points of the arc
    if bearing.kind == "radial":
        play = 1 - bearing.diametral_clearance / (2 * bearing.groove_centre_distance)
        assert np.cos(section.angle) == pytest.approx(play, rel=1e-12)


def test_seats_faces_and_shoulders_are_those_of_the_scene() -> None:
    bearing = load_scene("7208B").bearing
    section = section_of(bearing)
    assert bearing.bore_diameter is not None
    assert bearing.outside_diameter is not None
    assert bearing.width is not None
    np.testing.assert_allclose(section.inner.seat.points[:, 1], bearing.bore_diameter / 2, rtol=1e-12)
    np.testing.assert_allclose(section.outer.seat.points[:, 1], bearing.outside_diameter / 2, rtol=1e-12)
    np.testing.assert_allclose(np.ptp(section.outer.seat.points[:, 0]), bearing.width, rtol=1e-12)
    near, far = bearing.outer.half_widths
    assert near is not None
    assert far is not None
    groove = section.outer.groove.points[:, 0]
    middle = -(bearing.outer.groove_radius - bearing.ball_diameter / 2) * np.sin(section.angle)
    np.testing.assert_allclose(groove[[0, -1]] - middle, [-far, near], rtol=1e-9, atol=1e-9)
    assert all(line.known for ring in (section.inner, section.outer) for line in ring.lines)


def words_of(figure: Figure) -> list[tuple[str, Bbox]]:
    """Every text with the box that it takes, pixels."""
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    texts = [*figure.texts, *(text for panel in figure.axes for text in panel.texts)]
    shown = [text for text in texts if text.get_text().strip()]
    return [(text.get_text(), text.get_window_extent(canvas.get_renderer())) for text in shown]


@pytest.mark.parametrize("name", ["6205", "61820", "608", "7208B", "paper_6205", RIG, "6205, a pair", "7208B, a pair"])
def test_no_words_lie_on_others_or_leave_the_page(name: str) -> None:
    figure = draw_bearing(scene_of(name))
    words = words_of(figure)
    assert len(words) > 20
    width, height = figure.get_size_inches() * figure.dpi
    for text, box in words:
        assert box.x0 >= 0, text
        assert box.y0 >= 0, text
        assert box.x1 <= width, text
        assert box.y1 <= height, text
    for (first, one), (second, other) in combinations(words, 2):
        assert not one.overlaps(other), f"{first!r} lies on {second!r}"


def test_the_file_is_the_same_in_every_run_and_replaces_nothing(tmp_path: Path) -> None:
    scene = load_scene("6205")
    for name in ("one.svg", "two.svg", "three.png", "four.pdf"):
        draw_bearing(scene, out=tmp_path / name)
    first = (tmp_path / "one.svg").read_bytes()
    assert first == (tmp_path / "two.svg").read_bytes()
    assert b"<svg" in first
    assert (tmp_path / "three.png").read_bytes().startswith(b"\x89PNG")
    assert (tmp_path / "four.pdf").read_bytes().startswith(b"%PDF-")
    with pytest.raises(InputError, match="exists"):
        draw_bearing(scene, out=tmp_path / "one.svg")
    with pytest.raises(InputError, match=r"ends with '\.docx': give a file that ends with \.svg, \.png, \.pdf"):
        draw_bearing(scene, out=tmp_path / "my.docx")
