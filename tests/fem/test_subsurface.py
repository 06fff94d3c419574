"""Stresses under a computed contact against the closed form on the idealisation, and against the contact itself.

At nodes: exact for an even strain on curved cells.
"""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from analytic.contact.subsurface import axis_stress
from analytic.scene import Contact, Material, Wall
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.fem.condensation import condense
from fembearing.fem.elasticity import lame_parameters
from fembearing.fem.nodal_stress import stress_at_nodes
from fembearing.fem.solution import MeshSolution, solve_on_mesh
from fembearing.fem.subsurface import Side, SubsurfaceStress, body_displacement, subsurface_stress, von_mises
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests import contacts
from tests.contacts import NITRIDE, STEEL

INNER = replace(contacts.INNER, rolling_radius=15.85e-3, shoulder=2.6e-3, contact_angle=0.18, load=620.63)
SIDES = pytest.mark.parametrize("side", ["upper", "lower"])


def hertz(contact: Contact) -> dict[str, float]:
    """Peak pressure, Pa, and semi-axes, m, by the argument names of the closed form."""
    found = hertz_quantities(contact)
    axes = {"semi_axis_x": found.semi_axis_rolling, "semi_axis_y": found.semi_axis_transverse}
    return {"peak_pressure": found.peak_pressure, **axes}


@cache
def solve(contact: Contact, recipe: str = "hertzian", level: int = 3) -> MeshSolution:
    exact = hertz(contact)
    semi_axes = exact["semi_axis_x"], exact["semi_axis_y"]
    return solve_on_mesh(contact, recipe=load_recipe(recipe), level=level, semi_axes=semi_axes)


def material_of(contact: Contact, side: Side) -> Material:
    return contact.ball_material if side == "upper" else contact.race_material


def curve_error(found: SubsurfaceStress, contact: Contact, side: Side = "lower") -> float:
    """The largest error of the three stresses over all depths, in peak pressures."""
    exact, ratio = hertz(contact), material_of(contact, side).poisson_ratio
    right = axis_stress(
        depth=found.depth, poisson_ratio=np.asarray(ratio), **{name: np.asarray(value) for name, value in exact.items()}
    )
    return float(np.abs(found.stress - [right.sigma_x, right.sigma_y, right.sigma_z]).max()) / exact["peak_pressure"]


@pytest.fixture(scope="module")
def ideal() -> MeshSolution:
    return solve(INNER)


@pytest.fixture(scope="module")
def real() -> MeshSolution:
    return solve(INNER, "race", level=2)


def test_errors_fall_with_the_mesh() -> None:
    coarse, fine = (curve_error(subsurface_stress(solve(INNER, level=level)), INNER) for level in (1, 3))
    assert np.log(coarse / fine) / np.log(3) > 2  # the order of a quadratic cell's stress; at its Gauss points it is 3


@SIDES
def test_the_surface_carries_the_pressure(ideal: MeshSolution, real: MeshSolution, side: Side) -> None:
    for found, off in ((ideal, 2e-3), (real, 1.5e-2)):  # 5e-4 and 2e-3 of a level finer: the race is on the second
        top = subsurface_stress(found, side=side).stress[2, 0]
        np.testing.assert_allclose(top, -found.quantities.peak_pressure, rtol=off)


CERAMIC = replace(INNER, ball_material=NITRIDE)
CUT = replace(CERAMIC, shoulder=0.7e-3)  # of an ellipse 1.12 mm across


@SIDES
@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize("recipe", ["hertzian", "race"])
@pytest.mark.parametrize(
    "contact", [CERAMIC, CUT, replace(CUT, contact_angle=0.0)], ids=["whole", "cut", "cut on both sides"]
)
def test_touching_nodes_move_as_in_the_contact(contact: Contact, recipe: str, side: Side) -> None:
    """Against the condensed body, with the far field of the ellipse cut off at the shoulders."""
    found = solve(contact, recipe, level=1)
    body = getattr(found.pair, side)
    towards = -found.pair.normal if side == "upper" else found.pair.normal
    material = material_of(found.contact, side)
    shoulders = found.pair.footprint.shoulders
    condensed = condense(body, material=material, force=towards, semi_axes=found.pair.semi_axes, shoulders=shoulders)
    moved = body_displacement(found, side=side)
    expected = condensed.compliance @ found.force + condensed.drift * found.contact.load
    along = np.sum(moved[:, body.touching] * towards, axis=0)
    np.testing.assert_allclose(along, expected, rtol=1e-9)  # round-off times the condition, about 1e6
    for axis, plane in enumerate(body.planes):
        if not (body.pinned and axis == 1):  # the node that pins half a ball may move relative to its middle plane
            np.testing.assert_allclose(moved[axis, plane], 0.0, atol=1e-20)  # m; the far field's own round-off
    if body.far.size:  # held in the far field, which moves away from the load
        assert (moved[2, body.far] * towards[2, 0] > 0).all()


def test_the_maxima_are_those_of_the_curve(ideal: MeshSolution) -> None:
    found = subsurface_stress(ideal)
    step = found.depth[1]
    for curve, most, depth in (
        (found.max_shear, found.greatest_shear, found.greatest_shear_depth),
        (found.von_mises, found.greatest_von_mises, found.greatest_von_mises_depth),
    ):
        assert curve.max() <= most < 1.0001 * curve.max()  # a step of 1/100 of the semi-axis misses 1e-5
        assert abs(depth - found.depth[np.argmax(curve)]) < step
    assert found.depth[0] == 0
    np.testing.assert_allclose(found.depth[-1], 3 * min(ideal.pair.semi_axes), rtol=1e-12)
    x, y, z = found.stress
    np.testing.assert_allclose(found.max_shear, np.max(np.abs([x - y, y - z, z - x]), axis=0) / 2, rtol=1e-12)


def test_the_back_of_a_sheet_is_free_of_load() -> None:
    """The wall of a pocket ends before the curve would; bending causes tension there, and no pressure."""
    wall = Wall(thickness=0.8e-3, depth=2.5e-3)
    pocket = replace(INNER, pair="pocket", groove_radius=4.07e-3, rolling_radius=-4.07e-3, load=28.0, wall=wall)
    semi_axes = 0.315e-3, 0.315e-3
    found = subsurface_stress(solve_on_mesh(pocket, recipe=load_recipe("wall"), level=2, semi_axes=semi_axes))
    np.testing.assert_allclose(found.depth[-1], wall.thickness, rtol=1e-9)
    x, y, z = found.stress[:, -1] / -found.stress[2, 0]
    assert abs(z) < 5e-3  # 2e-3 measured on this level, 1e-3 on the next
    assert x > 0.2
    np.testing.assert_allclose(x, y, rtol=1e-6)  # it is round


# -- at nodes --------------------------------------------------------------------------------------------------------


SLOPE = 1e-4 * np.array([[3.0, -1.2, 0.7], [0.4, -2.0, 1.9], [2.3, 0.6, 0.8]])  # du_i/dx_j


def test_an_even_strain_has_its_stress_at_every_node() -> None:
    pair = pair_mesh(contacts.INNER, recipe=load_recipe("race"), level=1, semi_axes=(0.11e-3, 0.83e-3))
    lam, mu = lame_parameters(STEEL)
    strain = (SLOPE + SLOPE.T) / 2
    exact = 2 * mu * strain + lam * np.trace(strain) * np.eye(3)
    for body in (pair.upper, pair.lower):
        found = stress_at_nodes(body.mesh, SLOPE @ body.mesh.doflocs, STEEL)
        wanted = exact[[0, 1, 2, 0, 1, 0], [0, 1, 2, 1, 2, 2]]
        # rounding: positions of millimetres to 1e-16 m, differences over cells of micrometres
        np.testing.assert_allclose(found, np.broadcast_to(wanted[:, None], found.shape), rtol=0, atol=1e-6 * mu * 1e-4)


def test_a_strain_that_varies_evenly_is_exact_along_depth() -> None:
    """u_x = c x z: the stress is linear, as its extrapolation to the nodes is."""
    pair = pair_mesh(contacts.INNER, recipe=load_recipe("hertzian"), level=1, semi_axes=(0.11e-3, 0.83e-3))
    mesh, slope = pair.lower.mesh, 0.3  # 1/m
    x, _, z = mesh.doflocs
    lam, mu = lame_parameters(STEEL)
    found = stress_at_nodes(mesh, np.array([slope * x * z, 0 * x, 0 * x]), STEEL)
    nothing = 0 * x
    exact = np.array([(lam + 2 * mu) * z, lam * z, lam * z, nothing, nothing, mu * x]) * slope
    np.testing.assert_allclose(found[:5], exact[:5], rtol=0, atol=1e-12 * np.abs(exact).max())  # rounding
    # Around the ellipse x is no linear function within a cell.
    np.testing.assert_allclose(found[5], exact[5], rtol=0, atol=2e-3 * np.abs(exact).max())


def test_the_equivalent_stress_of_plain_states() -> None:
    tension, shear = np.array([5.0, 0, 0, 0, 0, 0]), np.array([0, 0, 0, 0, 3.0, 0])
    pressure = np.array([-7.0, -7.0, -7.0, 0, 0, 0])
    np.testing.assert_allclose(von_mises(np.stack([tension, shear, pressure], axis=1)), [5.0, 3.0 * 3**0.5, 0.0])
