"""The level that an accuracy needs."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact
from fembearing.check.contact.meshed_region import (
    FARTHER_LEFT,
    SIDES_LEFT,
    SIDES_LEFT_IN_OTHERS,
    has_sides,
    sides_farther,
)
from fembearing.check.contact.refinement import Wanted, solve_reference
from fembearing.fem.solution import solve_on_mesh
from fembearing.grid_convergence import FINEST
from fembearing.mesh.recipe import load_recipe


@pytest.mark.parametrize(
    ("change", "half", "geometry", "needed"),
    [
        ({}, False, "real", True),
        ({}, True, "real", False),  # both sides are meshed already
        ({}, False, "wall", False),
        ({"shoulder": 2.9e-3}, False, "real", True),
        ({"shoulder": 3.77e-3}, False, "real", True),  # equal shoulders, whose lands are tilted
        ({"shoulder": 3.77e-3, "contact_angle": 0.0}, False, "real", False),
    ],
)
def test_both_sides_are_meshed_where_they_differ(
    contacts: dict[str, Contact], change: dict[str, float], half: bool, geometry: Any, needed: bool
) -> None:
    contact = replace(contacts["inner"], **change)
    footprint = SimpleNamespace(half=half)
    for transverse, matters in ((0.93e-3, True), (0.03e-3, False)):  # a small contact has no sides to speak of
        pair = SimpleNamespace(footprint=footprint, semi_axes=(0.1 * transverse, transverse))
        mesh: Any = SimpleNamespace(contact=contact, pair=pair)
        assert has_sides(mesh, recipe=replace(load_recipe("race"), geometry=geometry)) == (needed and matters)


@pytest.mark.nightly
def test_the_sides_of_a_steep_contact_are_those_of_a_finer_mesh(contacts: dict[str, Contact]) -> None:
    """An outer ring counterbored, at 40 degrees: half of it on the third level, within the stated share."""
    far = 4.21e-3 * np.sin(0.7)  # the bottom of the groove
    contact = replace(contacts["outer"], shoulder=1.5e-3, far_shoulder=far, contact_angle=0.7, load=200.0)
    recipe = load_recipe("race")
    found = solve_reference(contact, Wanted(recipe, accuracy=0.9))
    axes = found.meshes[1].pair.semi_axes
    thirds = [
        solve_on_mesh(contact, recipe=recipe, level=3, semi_axes=axes, sides=sides).quantities
        for sides in ("even", "both")
    ]
    largest = max(abs(getattr(thirds[1], name) / getattr(thirds[0], name) - 1) for name in SIDES_LEFT)
    left = SIDES_LEFT | {"stiffness": SIDES_LEFT_IN_OTHERS}
    assert largest > 1e-5
    # Lands beyond the block change the approach alone, and the stiffness by it. Finer levels cannot mesh them here.
    lands = sides_farther(contact, recipe=recipe, level=1, semi_axes=axes)
    assert lands is not None
    powers = {"approach": 1.0, "stiffness": -1.5}
    for name, part in found.estimates.items():
        quarter, half = (getattr(third, name) for third in thirds)
        power = powers.get(name, 0.0)
        sides = half / quarter * (1 + lands) ** power - 1
        # Half differs from the mean of its quarters by 1.5e-5, in the stiffness by more; intervals hold FINEST besides.
        allowed = left[name] * largest + FINEST / 2 + abs(power) * FARTHER_LEFT * abs(lands)
        assert abs(part.sides - sides) < allowed, name
