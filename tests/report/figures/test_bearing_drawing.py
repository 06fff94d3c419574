"""The drawing of a bearing: what is drawn has the dimensions of the scene, and words do not lie on each other."""

import re
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from matplotlib.figure import Figure

from analytic.scene import Arrangement, ContactAngle, Scene
from analytic.scenefile.read import load_scene
from fembearing.quantities import METRIC
from fembearing.report.drawing import draw_bearing
from fembearing.report.figures.bearing_drawing import NOT_DRAWABLE, bearing_plot, shown_bearing
from fembearing.report.figures.bearing_section import section_of, unloaded_angle
from fembearing.report.figures.style import RED
from fembearing.report.report import Report
from tests.report.figures.figure_reader import require_legible

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


def test_washers_reach_from_bore_to_outside_and_a_guess_holds_their_grooves() -> None:
    bearing = replace(load_scene(RIG).bearing, bore_diameter=0.0285, outside_diameter=0.0462, width=0.0093)
    for known, drawn in (
        (True, section_of(bearing)),
        (False, section_of(replace(bearing, bore_diameter=None, outside_diameter=None, width=None))),
    ):
        for ring, side in ((drawn.inner, -1), (drawn.outer, 1)):
            edges = [face.points[:, 1] for face in ring.faces]
            groove = ring.groove.points
            assert edges[0].max() < groove[:, 1].min()
            assert edges[1].min() > groove[:, 1].max()
            assert np.all(side * ring.seat.points[:, 0] > np.abs(groove[:, 0]).max())  # behind the groove
            assert {face.known for face in (*ring.faces, ring.seat)} == {known}
            if known:
                np.testing.assert_allclose(edges, [[0.0285 / 2] * 2, [0.0462 / 2] * 2], rtol=1e-12)
                np.testing.assert_allclose(ring.seat.points[:, 0], side * 0.0093 / 2, rtol=1e-12)
    near, far = (1.1e-3, 0.7e-3)  # the near shoulder of a washer is the outer one
    unlike = replace(bearing, inner=replace(bearing.inner, shoulder_half_width=near, far_shoulder_half_width=far))
    ends = section_of(unlike).inner.groove.points[[0, -1], 1]
    np.testing.assert_allclose(ends - bearing.inner.bottom_radius, [-far, near], rtol=1e-9)  # differences


@pytest.mark.parametrize("name", ["6205", "61820", "608", "7208B", "paper_6205", RIG, "6205, a pair", "7208B, a pair"])
def test_no_words_lie_on_others_or_leave_the_page(name: str) -> None:
    require_legible(draw_bearing(scene_of(name)))


def words_of(scene: Scene) -> list[str]:
    return [text.get_text() for text in draw_bearing(scene).texts]


def test_the_title_counts_the_balls_and_names_a_pair_and_is_the_largest_of_all_words() -> None:
    for name, words in (
        ("6205", "6205: 9 balls of 7.94 mm"),
        ("6205, a pair", "6205: two, arranged O; 9 balls of 7.94 mm"),
    ):
        figure = draw_bearing(scene_of(name))
        title, *others = figure.texts
        assert re.sub(r"\d\.\d+ mm", "7.94 mm", title.get_text()) == words
        assert float(title.get_fontsize()) > max(float(each.get_fontsize()) for each in others)


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
        assert ("Dashed: guess, as the scene has no such dimension." in words_of(guessed)[-1]) == dashed
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


def test_the_origin_of_the_angle_is_the_scene_the_clearance_or_the_kind_of_bearing() -> None:
    nominal, free, thrust = (load_scene(name).bearing for name in ("7208B", "6205", RIG))
    for bearing, angle, words in (
        (nominal, None, "given; nominal, sets the clearance"),
        (nominal, 0.2, "given; the scene"),
        (replace(nominal, origins={}), None, "derived; from clearance and grooves"),
        (free, None, "derived; from clearance and grooves"),
        (free, 0.2, "given; the scene"),
        (thrust, None, "derived; of every thrust bearing"),
    ):
        shown = shown_bearing(bearing, "solved", angle)
        assert shown.angle_origin == words
        expected = np.pi / 2 if bearing is thrust else section_of(bearing).angle if angle is None else angle
        assert shown.angle == pytest.approx(expected, rel=1e-12)


def test_a_clearance_that_can_be_seen_is_not_called_too_small() -> None:
    scene = load_scene("6205")
    bearing, ball = scene.bearing, scene.bearing.ball_diameter
    for share, small in ((0.019, True), (0.021, False)):
        outer = bearing.inner.bottom_radius + ball + share * ball / 2
        wide = replace(bearing, outer=replace(bearing.outer, bottom_radius=outer))
        texts = [text.get_text() for text in draw_bearing(replace(scene, bearing=wide)).axes[0].texts]
        (words,) = (each for each in texts if each.startswith("radial clearance"))
        assert ("too small to see" in words) == small


def test_rows_of_the_table_stand_one_below_the_other_in_three_columns() -> None:
    figure = draw_bearing(load_scene("6205"))
    texts = [text.get_text() for text in figure.texts]
    first, last = texts.index("dimension"), texts.index("unloaded contact angle") + 3
    places = np.array([text.get_position() for text in figure.texts[first:last]]).reshape(-1, 3, 2)
    np.testing.assert_allclose(np.ptp(places[..., 0], axis=0), 0, atol=1e-12)
    np.testing.assert_allclose(np.ptp(places[..., 1], axis=1), 0, atol=1e-12)
    steps = -np.diff(places[:, 0, 1])
    np.testing.assert_allclose(steps, steps[0], rtol=1e-9)  # even, downwards
    assert steps[0] > 0
    bottom = min(panel.get_position().y0 for panel in figure.axes)
    assert places[0, 0, 1] < bottom  # below the views
    assert places[-1, 0, 1] > figure.texts[-1].get_position()[1] > 0  # above the last line


def test_a_radial_bearing_without_dimensions_is_drawn_as_usual_ones_are() -> None:
    """Rings a third of a ball thick behind their grooves, shoulders as far from the middle, 1.9 balls wide."""
    usual = load_scene("6205").bearing
    grooves = {
        race: replace(getattr(usual, race), shoulder_half_width=None, far_shoulder_half_width=None)
        for race in ("inner", "outer")
    }
    bearing = replace(usual, bore_diameter=None, outside_diameter=None, width=None, **grooves)
    section, ball = section_of(bearing), bearing.ball_diameter
    for ring, side in ((section.inner, -1), (section.outer, 1)):
        groove, seat = ring.groove.points, ring.seat.points
        bottom = groove[:, 1].min() if side < 0 else groove[:, 1].max()
        assert 0.3 * ball < side * (seat[0, 1] - bottom) < 0.4 * ball
        assert 0.3 * ball < np.ptp(groove[:, 0]) / 2 < 0.4 * ball
        np.testing.assert_allclose(np.ptp(seat[:, 0]), 1.9 * ball, rtol=1e-9)
        assert not any(line.known for line in (*ring.lands, *ring.faces, ring.seat))
        assert ring.groove.known
    wide = replace(bearing, outer=replace(usual.outer, shoulder_half_width=1.1 * ball, groove_radius=1.3 * ball))
    assert np.ptp(section_of(wide).inner.seat.points[:, 0]) > 2 * 1.1 * ball  # wider than its groove


def test_a_bearing_without_play_touches_in_the_radial_plane() -> None:
    bearing = load_scene("6205").bearing
    ball = bearing.ball_diameter
    for play, touches in ((1e-6, False), (0.0, True), (-5e-6, True)):
        outer = replace(bearing.outer, bottom_radius=bearing.inner.bottom_radius + ball + play)
        tight = replace(bearing, outer=outer)
        assert (unloaded_angle(tight) == 0) == touches
    closed = replace(
        bearing,
        inner=replace(bearing.inner, groove_radius=0.49 * ball),
        outer=replace(bearing.outer, groove_radius=0.49 * ball),
    )
    assert unloaded_angle(closed) == 0  # grooves narrower than the ball have no angle
    wide = replace(bearing.outer, bottom_radius=bearing.outer.bottom_radius + 2 * bearing.groove_centre_distance)
    assert unloaded_angle(replace(bearing, outer=wide)) == pytest.approx(np.pi / 2, rel=1e-12)  # no farther


def test_an_outline_is_closed_and_every_part_of_it_follows_the_one_before() -> None:
    for name in ("6205", "7208B", RIG):
        section = section_of(load_scene(name).bearing)
        for ring in (section.inner, section.outer):
            outline = ring.outline
            steps = np.linalg.norm(np.diff(np.vstack([outline, outline[:1]]), axis=0), axis=1)
            groove = np.linalg.norm(np.diff(ring.groove.points, axis=0), axis=1)
            assert np.sum(steps > 1.5 * groove.max()) <= 5  # lands, faces and seat alone are longer
            low, high = ring.lands
            np.testing.assert_allclose(low.points[-1], ring.groove.points[0], rtol=1e-12)
            np.testing.assert_allclose(high.points[0], ring.groove.points[-1], rtol=1e-12)
            for face, land, end in zip(ring.faces, (low.points[0], high.points[-1]), ring.seat.points, strict=True):
                np.testing.assert_allclose(face.points, [end, land], rtol=1e-9, atol=1e-12)
