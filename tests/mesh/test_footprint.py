"""Meshes of a contact cut off at a shoulder: half of it is meshed, with a line of the mesh on the shoulder."""

import math
from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.mesh.footprint import Footprint, footprint_of, is_symmetric
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, INNER

SEMI_AXES = {"inner": (0.100e-3, 0.936e-3), "outer": (0.135e-3, 0.771e-3)}  # m, about those of 372 N


@pytest.mark.parametrize("level", [1, 2])
@pytest.mark.parametrize("overrun", [1.0001, 1.004, 1.02, 1.1, 1.41, 2.0, 2.9])  # semi-axis over shoulder distance
@pytest.mark.parametrize("recipe", ["race", "hertzian"])
@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_no_cell_is_inside_out(pair: str, recipe: str, overrun: float, level: int) -> None:
    contact = replace(CONTACTS[pair], shoulder=SEMI_AXES[pair][1] / overrun)
    bodies = pair_mesh(contact, recipe=load_recipe(recipe), level=level, semi_axes=SEMI_AXES[pair])
    assert bodies.footprint.half
    for body in (bodies.upper, bodies.lower):
        assert mesh_quality(body.mesh).least_determinant > 0.05, body.name  # the quarter's worst is 0.1


@pytest.mark.parametrize("overrun", [1.004, 1.3, 2.2])
@pytest.mark.parametrize("reached", ["near", "both", "far"])  # where both are at one distance a quarter is enough
@pytest.mark.parametrize("recipe", ["race", "hertzian"])
def test_a_line_of_the_mesh_is_the_shoulder(recipe: str, reached: str, overrun: float) -> None:
    shoulder = SEMI_AXES["inner"][1] / overrun
    distances = {"near": (shoulder, 3.3e-3), "both": (shoulder, shoulder), "far": (3.3e-3, shoulder)}[reached]
    contact = replace(INNER, shoulder=distances[0], far_shoulder=distances[1])
    bodies = pair_mesh(contact, recipe=load_recipe(recipe), level=2, semi_axes=SEMI_AXES["inner"])
    assert bodies.footprint.half == (reached != "both")
    side = -1 if reached == "far" else 1
    race = bodies.lower.mesh
    x, y, _ = race.doflocs * np.array([[1.0], [side], [1.0]])
    on_line = np.intersect1d(np.flatnonzero(np.abs(y - shoulder) < 1e-12 * shoulder), bodies.lower.surface)
    assert on_line.size == 2 * 2 + 1  # corners and middle nodes of two cells
    # from the middle to where the ellipse crosses the shoulder, or to 0.995 where it only just reaches it
    reach = SEMI_AXES["inner"][0] * math.sqrt(1 - min(1 / overrun, 0.995) ** 2)
    assert x[on_line].max() == pytest.approx(reach, rel=1e-9)
    facets = race.facets[:, np.isin(race.facets, bodies.lower.surface).all(axis=0)]
    near = (x[facets] < 0.999 * reach).all(axis=0)
    across = (y[facets] < (1 - 1e-9) * shoulder).any(axis=0) & (y[facets] > (1 + 1e-9) * shoulder).any(axis=0)
    assert not (near & across).any()


def test_a_shoulder_cuts_off_an_ellipse_that_reaches_it() -> None:
    contact = replace(INNER, shoulder=0.8e-3)
    assert footprint_of(contact, (0.1e-3, 0.8e-3)) == Footprint(semi_axes=(0.1e-3, 0.8e-3))
    over = footprint_of(contact, (0.1e-3, 0.81e-3))
    assert (over.half, over.parts, over.shoulders) == (True, 2, (math.inf, 0.8e-3))
    slight = replace(contact, far_shoulder=0.87e-3)  # both shoulders reached, at unequal distances
    assert footprint_of(slight, (0.1e-3, 0.9e-3)).shoulders == (0.87e-3, 0.8e-3)
    far = footprint_of(replace(contact, shoulder=1.9e-3, far_shoulder=0.8e-3), (0.1e-3, 0.81e-3))
    assert (far.half, far.parts, far.shoulders) == (True, 2, (0.8e-3, math.inf))
    both = footprint_of(replace(contact, far_shoulder=0.8e-3), (0.1e-3, 0.81e-3))
    assert (both.half, both.parts, both.shoulders) == (False, 4, (0.8e-3, 0.8e-3))


@pytest.mark.parametrize("pair", ["inner", "outer"])
def test_each_side_of_a_whole_contact_has_its_own_shoulder_and_land(pair: str) -> None:
    """In cylinder coordinates about the bearing's axis: a torus, and lands of constant radius on both sides."""
    contact = replace(CONTACTS[pair], shoulder=1.3e-3, far_shoulder=2.2e-3, contact_angle=0.41)
    plain = pair_mesh(contact, recipe=load_recipe("race"), level=2, semi_axes=SEMI_AXES[pair])
    bodies = pair_mesh(contact, recipe=load_recipe("race"), level=2, semi_axes=SEMI_AXES[pair], sides="both")
    assert (plain.footprint.half, bodies.footprint.half) == (False, True)
    x, y, z = bodies.lower.mesh.doflocs[:, bodies.lower.surface]
    side, groove = (1 if pair == "inner" else -1), contact.groove_radius
    # The axis lies in the plane x = 0, tilted by the contact angle against y, at the distance R along the load.
    along = y * np.cos(0.41) - (z + contact.rolling_radius) * np.sin(0.41)
    across = y * np.sin(0.41) + (z + contact.rolling_radius) * np.cos(0.41)
    from_axis = np.hypot(across, x)
    profile = contact.rolling_radius * np.cos(0.41) * side + side * groove * np.cos(0.41)  # centre of the profile
    middle = -contact.rolling_radius * np.sin(0.41) - groove * np.sin(0.41)  # of the groove, along the axis
    axial = along - middle
    ends = [groove * np.sin(0.41 + turn) for turn in (-np.arcsin(2.2e-3 / groove), np.arcsin(1.3e-3 / groove))]
    inside = (axial > ends[0] + 1e-9) & (axial < ends[1] - 1e-9)
    on_torus = np.hypot(from_axis - profile, axial)
    np.testing.assert_allclose(on_torus[inside], groove, rtol=1e-10)  # round-off of radii four times as large
    for land in (axial < ends[0] - 1e-9, axial > ends[1] + 1e-9):
        assert land.sum() > 3
        np.testing.assert_allclose(from_axis[land], from_axis[land][0], rtol=1e-11)


def test_a_quarter_stands_for_a_contact_with_its_nearer_shoulder() -> None:
    for near, far in ((1.3e-3, 2.2e-3), (2.2e-3, 1.3e-3)):
        contact = replace(INNER, shoulder=near, far_shoulder=far, contact_angle=0.41)
        even = replace(contact, shoulder=1.3e-3, far_shoulder=1.3e-3, contact_angle=0.0)
        found, expected = (
            pair_mesh(each, recipe=load_recipe("race"), level=1, semi_axes=SEMI_AXES["inner"])
            for each in (contact, even)
        )
        np.testing.assert_array_equal(found.lower.mesh.doflocs, expected.lower.mesh.doflocs)
        np.testing.assert_array_equal(found.gap, expected.gap)


def test_an_ellipse_is_meshed_up_to_three_times_the_nearer_shoulder() -> None:
    for near, far in ((0.3e-3, 3e-3), (3e-3, 0.3e-3)):
        contact = replace(INNER, shoulder=near, far_shoulder=far)
        assert footprint_of(contact, (0.1e-3, 0.899e-3)).cut
        with pytest.raises(InputError, match="holds up to 3 times"):
            footprint_of(contact, (0.1e-3, 0.901e-3))


def test_contact_is_possible_up_to_both_shoulders_and_on_them() -> None:
    held = Footprint(semi_axes=(0.1e-3, 0.9e-3), shoulders=(0.6e-3, 0.8e-3))
    y = np.array([-0.6001e-3, -0.6e-3 * (1 + 1e-12), -0.1e-3, 0.7e-3, 0.8e-3 * (1 + 1e-12), 0.8001e-3])
    assert held.holds(y).tolist() == [False, True, True, True, True, False]


def test_sides_are_alike_with_equal_shoulders_and_no_tilt() -> None:
    alike = replace(INNER, shoulder=1.3e-3, far_shoulder=1.3e-3, contact_angle=0.0)
    assert is_symmetric(alike)
    assert not is_symmetric(replace(alike, contact_angle=0.2))
    assert not is_symmetric(replace(alike, far_shoulder=1.4e-3))
