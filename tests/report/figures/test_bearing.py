"""The drawing of a bearing: lines are as long as their numbers, leaders end at what they name, words are legible."""

import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle
from matplotlib.text import Annotation, Text

from analytic.errors import InputError
from analytic.figures.style import BLUE, RED
from analytic.scene import Arrangement, ArrangementKind, Array, Bearing, ContactAngle, Groove, Scene
from analytic.scenefile.read import load_scene
from analytic.units import METRIC
from fembearing.report.figures.bearing import NOT_DRAWABLE, bearing_plot, dimensions_of, draw_bearing, shown_bearing
from fembearing.report.figures.bearing_section import Section, section_of
from fembearing.report.report import Report
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import points_of, require_legible

RIG = str(Path(__file__).resolve().parents[3] / "examples/thrust_rig_3mm.toml")
PAIRS: dict[str, tuple[ArrangementKind, float | None]] = {
    "6205, X": ("X", 0.031),
    "7208B, O": ("O", 0.023),
    "7208B, tandem": ("tandem", None),
}  # m apart
EVERY = ["6205", "61820", "7208B", "paper_6205", RIG, *PAIRS]


def scene_of(name: str) -> Scene:
    scene = load_scene(name.partition(",")[0])
    if name not in PAIRS:
        return scene
    kind, distance = PAIRS[name]
    preload = None if kind == "tandem" else 130.0
    return replace(scene, arrangement=Arrangement(kind=kind, preload=preload, distance=distance))


def section(scene: Scene) -> Section:
    """At the unloaded angle of the scene, else of the clearance."""
    return section_of(scene.bearing, angle=scene.contact_angle.free)


def section_panel(scene: Scene) -> Axes:
    return draw_bearing(scene).axes[0]


def millimetres(words: str) -> float:
    """The last length in them."""
    return float(re.findall(r"([\d.]+) mm", words)[-1])


def outlines(panel: Axes) -> list[Array]:
    """Corners of each hatched ring."""
    return [np.asarray(patch.get_path().vertices) for patch in panel.patches if patch.get_hatch()]


def arrows(panel: Axes) -> list[Array]:
    """Head and tail of each."""
    every = [each for each in panel.texts if isinstance(each, Annotation)]
    return [np.array([each.xy, each.xyann], dtype=float) for each in every]


def circles(panel: Axes, *, filled: bool) -> list[Circle]:
    """The balls, or what has no face."""
    return [patch for patch in panel.patches if isinstance(patch, Circle) and patch.get_fill() == filled]


def centres(balls: list[Circle]) -> Array:
    return np.array([ball.center for ball in balls], dtype=float)


def lines_of(panel: Axes, points: int, colour: str | None = None) -> list[tuple[Line2D, Array]]:
    """The lines of so many points, each with these."""
    every = [(line, points_of(line)) for line in panel.get_lines()]
    return [each for each in every if len(each[1]) == points and colour in (None, each[0].get_color())]


def leaders(panel: Axes) -> list[tuple[Text, Line2D, Array]]:
    """Words with the line to what they name."""
    every = lines_of(panel, 3)
    found = [
        (text, line, points)
        for text in panel.texts
        for line, points in every
        if points[-1, 1] == text.get_position()[1] and points[-1, 0] < text.get_position()[0]
    ]
    assert len(found) == len(every)
    return found


@pytest.mark.parametrize("name", EVERY)
def test_half_diameters_go_from_below_to_their_circle(name: str) -> None:
    scene = scene_of(name)
    panel, bearing = section_panel(scene), scene.bearing
    left, low = (min(corners[:, axis].min() for corners in outlines(panel)) for axis in (0, 1))
    play = bearing.diametral_clearance if bearing.kind == "radial" else 0.0  # in which the drawn ball lies
    pitch = 2 * float(section(scene).ball[1])
    sizes = {"outside": bearing.outside_diameter, "pitch circle": pitch, "bore": bearing.bore_diameter}
    known = {words: size for words, size in sizes.items() if size is not None}
    texts = [text for text in panel.texts if text.get_text().partition(" \u2300")[0].strip() in sizes]
    assert [text.get_text().partition(" \u2300")[0].strip() for text in texts] == list(known)
    for text, size in zip(texts, known.values(), strict=True):
        assert millimetres(text.get_text()) == pytest.approx(1e3 * size, rel=1e-4, abs=1e3 * play)  # five digits
        x, foot = text.get_position()
        ((head, tail),) = (ends for ends in arrows(panel) if ends[0, 0] == x)
        np.testing.assert_allclose([head, tail], [[x, size / 2], [x, foot]], rtol=1e-12)
        assert foot == panel.get_ylim()[0] < low
        (line,) = (points for _, points in lines_of(panel, 2) if points[0, 0] == x)
        np.testing.assert_allclose(line, [[x, size / 2], [left, size / 2]], rtol=1e-12)
        assert panel.get_xlim()[0] < x < left
    places = [text.get_position()[0] for text in texts]
    assert places == sorted(places)  # the shorter one is nearer to the rings: no line crosses another


@pytest.mark.parametrize("name", ["6205", "7208B", *PAIRS])
def test_the_width_is_measured_above_the_rings_from_face_to_face_of_one_bearing(name: str) -> None:
    scene = scene_of(name)
    panel, width = section_panel(scene), present(scene.bearing.width)
    (text,) = (text for text in panel.texts if text.get_text().startswith("width"))
    ((start, end),) = (ends for ends in arrows(panel) if ends[0, 1] == ends[1, 1])
    assert millimetres(text.get_text()) == pytest.approx(1e3 * width, rel=1e-12)
    first = outlines(panel)[0]
    np.testing.assert_allclose([start[0], end[0]], [first[:, 0].min(), first[:, 0].max()], rtol=1e-12)
    assert end[0] - start[0] == pytest.approx(width, rel=1e-12)
    assert text.get_position()[0] == pytest.approx((start[0] + end[0]) / 2, abs=1e-12 * width)
    top = max(corners[:, 1].max() for corners in outlines(panel))
    assert top < start[1] < text.get_position()[1] < panel.get_ylim()[1]
    above = [points for _, points in lines_of(panel, 2) if points[0, 1] > top]
    for (x, level), points in zip((start, end), above, strict=True):  # from the face past the arrow's end
        np.testing.assert_array_equal(points[:, 0], x)
        assert points[0, 1] < level < points[1, 1]


def named_distance(words: str, place: Array, scene: Scene) -> float:
    """How far a leader ends from what its words name, over the ball's radius; place : from the ball's centre, m."""
    radius, own = scene.bearing.ball_diameter / 2, section(scene)
    if "contact angle" in words:  # on the line of contact, beyond the ball
        assert np.hypot(*place) > radius
        along = own.across
        assert place @ along > 0
        return abs(float(place @ [along[1], -along[0]])) / radius
    if "groove" in words:
        ring = own.inner if words.startswith("inner") else own.outer
        return float(np.hypot(*(ring.groove.points - own.ball - place).T).min()) / radius
    if "pocket" in words:
        return abs(float(np.hypot(*place)) - millimetres(words) / 2e3) / radius
    assert "ball" in words or "clearance" in words  # the gap is at the ball's surface
    return abs(float(np.hypot(*place)) / radius - 1)


@pytest.mark.parametrize("name", EVERY)
def test_leaders_end_at_what_they_name_in_its_order(name: str) -> None:
    scene = scene_of(name)
    panel = section_panel(scene)
    ball = centres(circles(panel, filled=True))[-1]
    flip = -1 if name.endswith("O") else 1  # of the bearing at the right
    found = leaders(panel)
    named = "\n".join(text.get_text() for text, *_ in found)
    assert [word in named for word in ("outer groove", "inner groove", "contact angle", "ball")] == [True] * 4
    assert ("radial clearance" in named) == (scene.bearing.kind == "radial")
    assert ("cage pocket" in named) == (scene.cage is not None)
    for text, line, points in found:
        (mark,) = (each for each, place in lines_of(panel, 1) if np.all(place == points[0]))
        assert mark.get_color() == line.get_color() == text.get_color()
        # 0.1 % of the radius: the place of the clearance has two digits.
        assert named_distance(text.get_text(), (points[0] - ball) * [flip, 1], scene) < 1e-3
        assert points[0, 0] < points[1, 0] < points[2, 0]
        assert points[1, 1] == points[2, 1]
    heights = sorted([(points[0, 1], points[2, 1]) for *_, points in found], reverse=True)
    apart = -np.diff([end for _, end in heights])  # in the order of what they name: none crosses another
    np.testing.assert_allclose(apart, apart[0], rtol=1e-9)
    assert apart[0] > 0
    top = max(corners[:, 1].max() for corners in outlines(panel))
    assert name in PAIRS or heights[0][1] < top  # beside the rings; those of a pair are flat


@pytest.mark.parametrize("name", EVERY)
def test_all_lines_are_inside_their_panels(name: str) -> None:
    for panel in draw_bearing(scene_of(name)).axes:
        low, high = np.array([panel.get_xlim(), panel.get_ylim()]).T
        reached = [patch.get_extents().transformed(panel.transData.inverted()).get_points() for patch in panel.patches]
        points = np.concatenate([*(points_of(line) for line in panel.get_lines()), *reached])
        assert np.all((points >= low) & (points <= high))
        # Words take less than half of a panel: rings and their dimensions fill the rest.
        assert np.all(np.ptp(points, axis=0) > 0.45 * (high - low))


@pytest.mark.parametrize("name", PAIRS)
def test_a_pair_is_the_same_bearing_twice_turned_round_by_its_arrangement(name: str) -> None:
    scene = scene_of(name)
    bearing, (kind, distance) = scene.bearing, PAIRS[name]
    panel, own = section_panel(scene), section(scene)
    half = (present(bearing.width) if distance is None else distance) / 2
    balls = centres(circles(panel, filled=True))
    np.testing.assert_allclose(balls, [[-half, own.ball[1]], [half, own.ball[1]]], rtol=1e-12)
    flips = {"O": (1, -1), "X": (-1, 1), "tandem": (1, 1)}[kind]
    expected = [
        ring.outline * [flip, 1] + [place, 0]
        for place, flip in zip((-half, half), flips, strict=True)
        for ring in (own.inner, own.outer)
    ]
    for corners, each in zip(outlines(panel), expected, strict=True):
        np.testing.assert_allclose(corners[:-1], each, rtol=1e-12, atol=1e-15)  # closed: the first one is repeated
    contacts = [points for line, points in lines_of(panel, 2, BLUE) if line.get_linestyle() == "--"]
    for ends, ball, flip in zip(contacts, balls, flips, strict=True):
        np.testing.assert_allclose(ends.mean(axis=0), ball, rtol=1e-9)  # through the ball's centre
        along = ends[1] - ends[0]
        np.testing.assert_allclose(along / np.hypot(*along), own.across * [flip, 1], rtol=1e-9)
        assert np.hypot(*along) > 1.2 * bearing.ball_diameter  # past both contacts


def rise(groove: Groove, half_width: float | None) -> float:
    """Height of a shoulder, m."""
    return groove.groove_radius - float(np.sqrt(groove.groove_radius**2 - present(half_width) ** 2))


@pytest.mark.parametrize("name", ["6205", "7208B"])
def test_the_view_along_the_axis_has_the_edges_of_the_rings(name: str) -> None:
    bearing = scene_of(name).bearing
    side = draw_bearing(scene_of(name)).axes[1]
    edges = sorted(each.radius for each in circles(side, filled=False) if each.get_linestyle() == "solid")
    inner, outer = bearing.inner, bearing.outer
    expected = [  # the shoulders at the left
        present(bearing.bore_diameter) / 2,
        inner.bottom_radius + rise(inner, inner.half_widths[0]),
        outer.bottom_radius - rise(outer, outer.half_widths[1]),
        present(bearing.outside_diameter) / 2,
    ]
    # The drawn ball touches both races: their grooves lie apart by the play.
    np.testing.assert_allclose(edges, expected, atol=bearing.diametral_clearance)
    np.testing.assert_allclose(edges[::3], expected[::3], rtol=1e-12)


@pytest.mark.parametrize("name", ["6205", RIG])
def test_the_view_along_the_axis_counts_its_balls(name: str) -> None:
    bearing = scene_of(name).bearing
    side = draw_bearing(scene_of(name)).axes[1]
    pitch = bearing.inner.bottom_radius + bearing.outer.bottom_radius
    angles = 2 * np.pi * np.arange(bearing.ball_count) / bearing.ball_count
    expected = pitch / 2 * np.column_stack([np.sin(angles), np.cos(angles)])  # the first one at the top
    np.testing.assert_allclose(centres(circles(side, filled=True)), expected, rtol=1e-9, atol=1e-15)
    assert [each.radius for each in circles(side, filled=False)][-1] == pytest.approx(pitch / 2, rel=1e-12)
    (words,) = side.texts
    assert words.get_text().startswith(f"{bearing.ball_count} balls")
    assert millimetres(words.get_text()) == pytest.approx(1e3 * pitch, rel=1e-4)  # five digits
    assert words.get_position()[1] < -(pitch + bearing.ball_diameter) / 2  # below the balls


def table_of(bearing: Bearing, rule: str, angle: float | None) -> dict[str, list[str]]:
    return {name: rest for name, *rest in dimensions_of(shown_bearing(bearing, rule, angle), METRIC)}


def test_the_table_has_every_dimension_with_its_value_and_origin() -> None:
    usual = load_scene("6205").bearing
    bearing = replace(usual, ball_count=7, outer=replace(usual.outer, far_shoulder_half_width=2.2e-3))
    found = table_of(bearing, "solved", None)
    gap = bearing.pitch_diameter * np.sin(np.pi / 7) - bearing.ball_diameter
    assert millimetres(found["gap between balls"][0]) == pytest.approx(1e3 * gap, rel=1e-4)  # five digits
    assert millimetres(found["pitch diameter"][0]) == pytest.approx(1e3 * bearing.pitch_diameter, rel=1e-4)
    heights = [float(each) for each in re.findall(r"([\d.]+) mm", found["outer shoulder height"][0])]
    expected = [1e3 * rise(bearing.outer, each) for each in bearing.outer.half_widths]
    np.testing.assert_allclose(heights, expected, rtol=1e-4)
    assert found["radial clearance"][0] == "12.5 um"
    play = bearing.diametral_clearance / (2 * bearing.groove_centre_distance)
    words = f"{np.degrees(np.arccos(1 - play)):.4g} deg"
    assert found["unloaded contact angle"] == [words, "derived; from clearance and grooves"]
    rows = table_of(replace(bearing, width=None, origins={}), "given", 0.31)
    assert rows["width"] == ["not given", "-"]
    assert rows["bore"][1] == "origin not known"
    assert rows["contact angle, loaded, given"] == ["17.76 deg", "given; the scene"]


def test_balls_that_would_overlap_have_a_gap_in_red() -> None:
    scene = load_scene("6205")
    for count, is_red in ((15, False), (16, True)):
        figure = draw_bearing(replace(scene, bearing=replace(scene.bearing, ball_count=count)))
        texts = [text.get_text() for text in figure.texts]
        value = figure.texts[texts.index("gap between balls") + 1]
        assert (value.get_color() == RED) == value.get_text().startswith("-") == is_red


def test_a_guess_is_dashed_and_said_to_be_one() -> None:
    scene = load_scene("7208B")
    bearing = scene.bearing
    for unknown, dashed in (
        ({}, False),
        ({"width": None}, True),
        ({"inner": replace(bearing.inner, shoulder_half_width=None)}, True),
    ):
        guessed = replace(scene, bearing=replace(bearing, **unknown))  # pyright: ignore[reportArgumentType]
        section = draw_bearing(guessed).axes[0]
        assert (
            "Dashed: guess, as the scene has no such dimension." in draw_bearing(guessed).texts[-1].get_text()
        ) == dashed
        assert any(line.get_color() == RED for line in section.get_lines()) == dashed


def test_a_page_has_the_drawing_without_its_table_or_says_that_there_is_none() -> None:
    scene = load_scene("6205-dry")
    table, angle = draw_bearing(scene), scene.contact_angle

    def drawn(**changed: Any) -> tuple[Figure | None, str]:
        known = {"bearing": scene.bearing, "cage": scene.cage, "contact_angle": angle} | changed
        return bearing_plot(cast(Report, SimpleNamespace(scene=SimpleNamespace(**known), units=METRIC)))

    figure, caption = drawn()
    assert figure is not None
    assert "Without load" in caption
    for one, other in zip(figure.axes, table.axes, strict=True):
        assert [text.get_text() for text in one.texts] == [text.get_text() for text in other.texts]
        np.testing.assert_allclose([one.get_xlim(), one.get_ylim()], [other.get_xlim(), other.get_ylim()], rtol=1e-12)
    assert "gap between balls" in [text.get_text() for text in table.texts]
    assert "gap between balls" not in [text.get_text() for text in figure.texts]
    assert figure.get_figheight() < table.get_figheight()
    require_legible(figure)
    bare, _ = drawn(cage=None)
    assert bare is not None
    assert not any("cage pocket" in text.get_text() for text in bare.axes[0].texts)
    assert any("cage pocket" in text.get_text() for text in figure.axes[0].texts)
    loaded, _ = drawn(contact_angle=ContactAngle(rule="given", value=0.31))
    assert loaded is not None
    assert any("contact angle, loaded, given\n17.76 deg" in text.get_text() for text in loaded.axes[0].texts)
    assert drawn(bearing=replace(scene.bearing, width=-1e-3)) == (None, NOT_DRAWABLE)


@pytest.mark.parametrize("name", [*EVERY, "608"])
def test_no_words_lie_on_others_or_leave_the_page(name: str) -> None:
    require_legible(draw_bearing(scene_of(name)))


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


def test_more_balls_than_are_drawn_are_refused() -> None:
    scene = load_scene("6205")
    with pytest.raises(InputError, match=r"6205: .*at most 500 balls"):
        draw_bearing(replace(scene, bearing=replace(scene.bearing, ball_count=501)))


def test_a_clearance_that_can_be_seen_is_not_called_too_small() -> None:
    scene = load_scene("6205")
    bearing, ball = scene.bearing, scene.bearing.ball_diameter
    for share, small in ((0.019, True), (0.021, False)):
        outer = bearing.inner.bottom_radius + ball + share * ball / 2
        wide = replace(bearing, outer=replace(bearing.outer, bottom_radius=outer))
        texts = [text.get_text() for text in draw_bearing(replace(scene, bearing=wide)).axes[0].texts]
        (words,) = (each for each in texts if each.startswith("radial clearance"))
        assert ("too small to see" in words) == small
