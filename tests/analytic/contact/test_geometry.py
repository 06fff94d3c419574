"""The geometry of ball on race against the rings' surfaces themselves."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.geometry import (
    USUAL_SHOULDERS,
    Race,
    known_half_widths,
    pocket_contact,
    race_contact,
    race_curvatures,
    shoulder_distances,
    with_shoulders,
)
from analytic.errors import InputError
from analytic.scene import Bearing, Ring
from tests.analytic.specimens import STAMPED_CAGE
from tests.refusals import refused

RACES: list[Race] = ["inner", "outer"]
ANGLE, LOAD = 0.31, 372.0  # rad, N


def torus(bearing: Bearing, race: Race, profile: float, turn: float) -> np.ndarray:
    """A point of the race's torus (radial, tangential, axial), at a profile angle and turned about the bearing's axis.

    The groove touches a ball on the pitch circle at ANGLE. The ring has moved in the axial direction only, so the
    profile's centre is off the pitch circle by (r_g - r) cos ANGLE.
    """
    sign = 1 if race == "inner" else -1
    groove = bearing.inner if race == "inner" else bearing.outer
    spare = groove.groove_radius - bearing.ball_radius
    centre = bearing.pitch_diameter / 2 + sign * spare * np.cos(ANGLE)
    radial = centre - sign * groove.groove_radius * np.cos(profile)
    return np.array([radial * np.cos(turn), radial * np.sin(turn), -sign * groove.groove_radius * np.sin(profile)])


@pytest.mark.parametrize("race", RACES)
def test_curvatures_are_those_of_the_torus(bearing_6205: Bearing, race: Race) -> None:
    """Twice the height over the tangent plane per squared distance, by small steps in both directions."""
    sign = 1 if race == "inner" else -1
    into_race = np.array([-sign * np.cos(ANGLE), 0.0, -sign * np.sin(ANGLE)])
    origin = torus(bearing_6205, race, ANGLE, 0.0)
    step = 1e-3  # rad: the next term of the height is 1e-6 of this one, round-off 1e-9

    def curvature(point: np.ndarray) -> float:
        step = point - origin
        return 2 * float(step @ into_race) / float(step @ step - (step @ into_race) ** 2)

    both_sides = [curvature(torus(bearing_6205, race, ANGLE + side * step, 0.0)) for side in (-1, 1)]
    ball = 1 / bearing_6205.ball_radius
    expected = ball + curvature(torus(bearing_6205, race, ANGLE, step)), ball + float(np.mean(both_sides))
    found = race_curvatures(bearing_6205, race, contact_angle=ANGLE)
    np.testing.assert_allclose(found, expected, rtol=2e-5)  # 1/r - 1/r_g magnifies the step's 1e-6 by up to 26


@pytest.mark.parametrize("race", RACES)
def test_the_shoulder_is_where_the_groove_ends(bearing_6205: Bearing, race: Race) -> None:
    contact = race_contact(bearing_6205, race, contact_angle=ANGLE, ball_load=LOAD)
    groove = bearing_6205.inner if race == "inner" else bearing_6205.outer
    axial = 3.1e-3  # of both grooves
    radial = np.sqrt(groove.groove_radius**2 - axial**2)
    tangent = np.array([np.cos(ANGLE), -np.sin(ANGLE)])  # in (axial, radial from the profile's centre)
    np.testing.assert_allclose(contact.shoulder, tangent @ (axial, radial), rtol=1e-12)  # round-off
    np.testing.assert_allclose(contact.far_shoulder, -tangent @ (-axial, radial), rtol=1e-12)


@pytest.mark.parametrize(
    ("race", "angle", "load", "words"),
    [
        ("outer", 0.83, LOAD, ("0.83 rad", "outer race's shoulder", "0.8276 rad")),
        ("inner", 18.0, LOAD, ("contact_angle", "18.0", "degrees")),
        ("inner", -0.86, LOAD, ("-0.86 rad", "inner race's shoulder")),
        ("inner", ANGLE, -5.0, ("ball_load", "-5.0")),
        ("pocket", ANGLE, LOAD, ("race", "pocket")),
    ],
)
def test_a_contact_off_the_groove_is_refused(bearing_6205: Bearing, race, angle, load, words) -> None:
    refused(lambda: race_contact(bearing_6205, race, contact_angle=angle, ball_load=load), *words)


def test_the_ring_behind_a_groove_is_known_with_its_seat_and_width(bearing_6205) -> None:
    sized = replace(bearing_6205, width=15e-3)
    inner, outer = (race_contact(sized, race, contact_angle=0.2, ball_load=55.0).ring for race in ("inner", "outer"))
    both = (3.1e-3, 3.1e-3)
    assert inner == Ring(bottom_radius=15.53e-3, seat_radius=12.5e-3, width=15e-3, shoulder_half_widths=both)
    assert outer == Ring(bottom_radius=23.48e-3, seat_radius=26e-3, width=15e-3, shoulder_half_widths=both)
    for lacking in (replace(sized, bore_diameter=None), replace(sized, width=None)):
        assert race_contact(lacking, "inner", contact_angle=0.2, ball_load=55.0).ring is None


def with_half_widths(bearing: Bearing, near: float | None, far: float | None) -> Bearing:
    inner, outer = (
        replace(groove, shoulder_half_width=near, far_shoulder_half_width=far)
        for groove in (bearing.inner, bearing.outer)
    )
    return replace(bearing, inner=inner, outer=outer)


@pytest.mark.parametrize("race", RACES)
def test_a_ball_pressed_to_the_far_side_has_the_far_shoulder_ahead(bearing_6205: Bearing, race: Race) -> None:
    """At a negative angle everything is that of the mirrored groove at the positive one."""
    plain, mirrored = with_half_widths(bearing_6205, 3.3e-3, 1.9e-3), with_half_widths(bearing_6205, 1.9e-3, 3.3e-3)
    ahead, behind = shoulder_distances(plain, race, contact_angle=np.array([-0.21, 0.13]))
    there, back = shoulder_distances(mirrored, race, contact_angle=np.array([0.21, -0.13]))
    np.testing.assert_allclose([ahead, behind], [there, back], rtol=1e-15)
    radius = bearing_6205.inner.groove_radius if race == "inner" else bearing_6205.outer.groove_radius
    tangent = np.array([np.cos(0.21), np.sin(0.21)])  # along the axis and towards the ball, at the far side's contact
    on_profile = radius * np.array([np.sin(0.21), -np.cos(0.21)])
    far_edge = np.array([1.9e-3, -np.sqrt(radius**2 - 1.9e-3**2)])
    assert ahead[0] == pytest.approx(tangent @ (far_edge - on_profile), rel=1e-12)  # round-off
    near_edge = np.array([-3.3e-3, -np.sqrt(radius**2 - 3.3e-3**2)])
    assert behind[0] == pytest.approx(-tangent @ (near_edge - on_profile), rel=1e-12)
    pressed = race_contact(replace(plain, width=15e-3), race, contact_angle=-0.21, ball_load=LOAD)
    assert pressed == race_contact(replace(mirrored, width=15e-3), race, contact_angle=0.21, ball_load=LOAD)
    assert pressed.ring is not None
    assert pressed.ring.shoulder_half_widths == (1.9e-3, 3.3e-3)
    assert pressed.contact_angle == 0.21


def test_a_counterbored_ring_ends_at_the_bottom_of_its_groove(bearing_6205: Bearing) -> None:
    bearing = with_half_widths(bearing_6205, 3.3e-3, 0.0)
    contact = race_contact(bearing, "outer", contact_angle=0.26, ball_load=LOAD)
    assert contact.far_shoulder == pytest.approx(4.21e-3 * np.sin(0.26), rel=1e-12)  # along the tangent to the bottom
    assert contact.nearer_shoulder == contact.far_shoulder < contact.shoulder
    with pytest.raises(InputError, match=r"contact_angle 0 deg \(0 rad\) is beyond the outer race's shoulder at 0 deg"):
        race_contact(bearing, "outer", contact_angle=0.0, ball_load=LOAD)


@pytest.mark.parametrize(
    ("near", "far", "wrong"), [(3.1e-3, -0.1e-3, "-0.1"), (3.1e-3, 4.3e-3, "4.3"), (4.5e-3, 3.1e-3, "4.5")]
)
def test_an_impossible_shoulder_is_refused_in_millimetres(bearing_6205: Bearing, near, far, wrong) -> None:
    odd = with_half_widths(bearing_6205, near, far)
    refused(lambda: race_contact(odd, "inner", contact_angle=0.1, ball_load=LOAD), f"{wrong} mm must")


def test_unknown_shoulders_are_asked_for_in_one_line(bearing_6205: Bearing) -> None:
    unknown = with_half_widths(bearing_6205, None, None)
    assert np.isnan(shoulder_distances(unknown, "outer", contact_angle=np.array([0.1, -0.3]))).all()
    with pytest.raises(InputError) as refusal:
        race_contact(unknown, "outer", contact_angle=0.1, ball_load=LOAD)
    words = str(refusal.value)
    assert "\n" not in words
    keys = "give bearing.inner.shoulder_height and bearing.outer.shoulder_height, usual are 0.15 to 0.25"
    assert f'{keys} of the ball diameter, "1.19 mm" to "1.98 mm"' in words  # both at once
    typical = with_shoulders(unknown, USUAL_SHOULDERS[1])
    near, far = known_half_widths(typical, "outer")
    rise = 4.21e-3 - np.sqrt(4.21e-3**2 - near**2)
    assert rise == pytest.approx(0.19 * 7.94e-3, rel=1e-12)
    assert near == far
    assert with_shoulders(bearing_6205, 0.19) == bearing_6205


@pytest.mark.parametrize("depth", [3.1e-3, 4.07e-3])
def test_the_rim_of_a_pocket_is_a_circle_of_its_sphere(bearing_6205: Bearing, depth: float) -> None:
    """Its plane lies `depth` above the pole: one of half the sphere's diameter has the widest rim."""
    found = pocket_contact(bearing_6205, replace(STAMPED_CAGE, pocket_diameter=8.14e-3, pocket_depth=depth), load=28.0)
    above_centre = depth - 4.07e-3
    assert np.hypot(found.shoulder, above_centre) == pytest.approx(4.07e-3, rel=1e-12)  # round-off
    assert found.far_shoulder == found.shoulder
