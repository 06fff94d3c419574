"""The ball in its cage pocket: a thick seat against Hertz, a sheet against the theory of shells."""

from dataclasses import replace

import numpy as np

from analytic.contact.geometry import pocket_contact
from analytic.scene import Contact
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.fem.condensation import held_stiffness
from fembearing.fem.solution import MeshSolution, fitted_solution, solve_on_mesh
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.analytic.specimens import BEARING_6205, STAMPED_CAGE
from tests.contacts import STEEL

CAGE = replace(STAMPED_CAGE, pocket_depth=3.9e-3)


def pocket(load: float = 28.0, **changed: object) -> Contact:
    return pocket_contact(BEARING_6205, replace(CAGE, **changed), load=load)


def solve(contact: Contact, recipe: str, level: int = 2) -> MeshSolution:
    made = load_recipe(recipe)
    fitted = fitted_solution(contact, recipe=made)
    if fitted.level == level:
        return fitted
    return solve_on_mesh(contact, recipe=made, level=level, semi_axes=fitted.pair.semi_axes)


def test_no_node_of_the_rim_can_move() -> None:
    body = pair_mesh(pocket(), recipe=load_recipe("wall"), level=1, semi_axes=(0.31e-3, 0.31e-3)).lower
    held = held_stiffness(body, material=STEEL, semi_axes=(0.31e-3, 0.31e-3))
    components = np.concatenate([body.clamped + axis * held.nodes for axis in range(3)])
    assert not np.isin(components, held.free).any()
    assert not held.far_force.any()  # and nothing but the ball pushes


def test_a_thick_seat_deviates_from_hertz_in_proportion_to_the_contact() -> None:
    """The first correction to a half space is of the order of contact over ball, so it goes as the load's cube root."""
    departures = []
    for load in (28.0, 2.0):
        contact = pocket(load)
        hertz = hertz_quantities(contact)
        axes = hertz.semi_axis_rolling, hertz.semi_axis_transverse  # within 1 % of its own, which changes no approach
        found = solve_on_mesh(contact, recipe=load_recipe("race"), level=3, semi_axes=axes)
        departures.append(found.quantities.approach / hertz.approach - 1)
    assert departures[0] < -0.01
    # Tolerance: a mesh error of 1e-3 in 7e-3
    np.testing.assert_allclose(departures[1] / departures[0], (2 / 28) ** (1 / 3), rtol=0.1)


def test_a_sheet_deflects_as_a_shell() -> None:
    """Beyond the local contact: Reissner's deflection of a shallow spherical cap under a point load,
    w = sqrt(3 (1 - nu^2)) P R/(4 E t^2) [Timoshenko1959].
    """
    sheet = 0.45e-3
    contact = pocket(load=2.0, wall_thickness=sheet)
    bending = solve(contact, "wall").quantities.approach - solve(contact, "race").quantities.approach
    middle = 4.07e-3 + sheet / 2
    expected = np.sqrt(3 * (1 - 0.3**2)) / 4 * 2.0 * middle / (206e9 * sheet**2)
    np.testing.assert_allclose(bending, expected, rtol=0.1)  # the shell is a tenth of its radius thick, not thin
