"""The drawing of a bearing: what is drawn has the dimensions of the scene, and words do not lie on each other."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Arrangement, Scene
from analytic.scenefile.read import load_scene
from fembearing.report.drawing import draw_bearing
from fembearing.report.figures.bearing_section import section_of
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
