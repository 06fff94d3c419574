"""A bearing cut through a ball: its outlines have the dimensions of the scene, and guesses where it has none."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic.scenefile.read import load_scene
from fembearing.report.figures.bearing import shown_bearing
from fembearing.report.figures.bearing_section import is_drawable, section_of, unloaded_angle

ROOT = Path(__file__).resolve().parents[3]
RIG = str(ROOT / "examples/thrust_rig_3mm.toml")


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


def test_lengths_far_from_the_ball_are_not_drawn() -> None:
    bearing = load_scene("6205").bearing
    size = bearing.ball_diameter
    assert is_drawable(bearing)
    for known, changed in (
        (True, {"width": 9.9e3 * size}),
        (False, {"width": 1.01e4 * size}),
        (False, {"width": -1e-3}),
        (True, {"ball_count": 500}),
        (False, {"ball_count": 501}),
        (False, {"ball_count": 0}),
        (False, {"inner": replace(bearing.inner, bottom_radius=0.0)}),
        (False, {"outer": replace(bearing.outer, groove_radius=0.0)}),
    ):
        assert is_drawable(replace(bearing, **changed)) == known  # pyright: ignore[reportArgumentType]
