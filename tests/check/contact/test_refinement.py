"""The level that an accuracy needs, and its time; the estimate from levels with a twin, and from plain levels."""

from collections.abc import Callable
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Contact
from analytic.words import about
from fembearing.check.contact.meshed_region import (
    FARTHER_LEFT,
    SIDES_LEFT,
    SIDES_LEFT_IN_OTHERS,
    STIFFNESS,
    has_sides,
    sides_farther,
)
from fembearing.check.contact.refinement import (
    COMPARED,
    CURVED,
    FORMAL_ORDERS,
    LEAST_WITH_TWIN,
    LEFT,
    ORDER,
    ORDERS,
    SHAPED,
    UNSTEADY_PRESSURE,
    Wanted,
    estimates_with_twin,
    predicted_seconds,
    solve_reference,
)
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.fem.solution import solve_on_mesh
from fembearing.grid_convergence import FINEST
from fembearing.mesh.recipe import Recipe, load_recipe


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


EXACT = {"semi_axis_rolling": 0.12e-3, "semi_axis_transverse": 0.7e-3, "peak_pressure": 2.1e9, "approach": 6.2e-6}
LEFT_BY_TWIN = {"semi_axis_rolling": 3e-3, "semi_axis_transverse": -7e-3, "peak_pressure": 2e-3, "approach": 11e-3}


def corrected(level: int) -> Any:
    """A level whose corrected values are off by a power of its cells; twins show an error of 0.7 % in the approach."""
    off = {name: share * (1 / level) ** ORDERS.get(name, ORDER) for name, share in LEFT_BY_TWIN.items()}
    values = {name: EXACT[name] * (1 + off[name]) for name in EXACT}
    plain = {name: EXACT[name] * (1 + 10 * off[name]) for name in EXACT}
    for each in (values, plain):
        each["stiffness"] = 372.0 / each["approach"] ** 1.5
    pair = SimpleNamespace(semi_axes=(0.12e-3, 0.7e-3))
    contact = SimpleNamespace(ball_radius=3.97e-3, load=372.0)
    mesh = SimpleNamespace(level=level, pair=pair, contact=contact, quantities=SimpleNamespace(**plain))
    factors = dict.fromkeys(EXACT, 0.998) | {"approach": 1.007}
    return SimpleNamespace(mesh=mesh, corrected=values, factors=SimpleNamespace(**factors))


@pytest.mark.parametrize("levels", [(1, 2), (1, 2, 3), (2, 3, 4)])
def test_what_twins_leave_is_extrapolated(levels: tuple[int, ...]) -> None:
    solutions = [corrected(level) for level in levels]
    found = estimates_with_twin(solutions)
    assert list(found) == list(FORMAL_ORDERS)
    shape = (0.7 / 3.97) ** 2
    for name, value in EXACT.items():
        shaped = 1 + SHAPED * shape * 0.007 if name == "approach" else 1.0
        # 1e-4: a sequence in powers of the cell size, but relative to the exact value and not to the finest
        assert found[name].value == pytest.approx(value * shaped, rel=1e-4), name
        assert found[name].values == tuple(getattr(each.mesh.quantities, name) for each in solutions)
        assert found[name].corrected == tuple(each.corrected[name] for each in solutions)
        assert (found[name].order is None) == (len(levels) == 2)
    before, last = levels[-2:]
    power = ORDERS["approach"]
    largest = 11e-3 * (before**-power - last**-power)  # of the approach, relative to its exact value
    expected = LEAST_WITH_TWIN + CURVED * shape * 0.007
    expected += LEFT * largest / ((last / before) ** ORDER - 1)
    for name in COMPARED:
        added = UNSTEADY_PRESSURE if name == "peak_pressure" else 0.0
        assert found[name].mesh == pytest.approx(expected + added, rel=2e-3), name
    assert found["stiffness"].value == pytest.approx(372.0 / found["approach"].value ** 1.5, rel=1e-12)
    assert found["stiffness"].mesh == pytest.approx(STIFFNESS * found["approach"].mesh, rel=1e-12)


def test_the_result_says_whether_meshes_had_a_twin(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe], cut_contact: ContactSolution
) -> None:
    """The idealisation would be its own twin, and a contact that its shoulder cuts off has none."""
    race, half_spaces = (
        compare_contact(contacts["inner"], recipe=shallow(recipe), tolerance=0.9) for recipe in ("race", "hertzian")
    )
    for solution, refinement in ((race, "twin"), (cut_contact, "levels"), (half_spaces, "levels")):
        found = solution.numbers
        assert found.refinement == refinement
        assert ("twin" in found.method) == (refinement == "twin")
        assert [bool(part.corrected) for part in found.estimates.values()] == [refinement == "twin"] * 5


@pytest.mark.nightly
def test_a_tighter_accuracy_takes_a_finer_level_with_its_twin(contacts: dict[str, Contact]) -> None:
    """Both agree within their intervals, which are as narrow as required."""
    contact, recipe = contacts["inner"], load_recipe("race")
    loose, tight = (solve_reference(contact, Wanted(recipe, accuracy=accuracy)) for accuracy in (1e-3, 5e-4))
    assert ([mesh.level for mesh in loose.meshes], [mesh.level for mesh in tight.meshes]) == ([1, 2], [1, 2, 3])
    for name in COMPARED:
        one, other = loose.estimates[name], tight.estimates[name]
        assert one.total <= 1e-3, name
        assert other.total <= 5e-4, name
        assert abs(one.value / other.value - 1) < one.mesh + other.mesh, name


def solved(unknowns: int, *, level: int = 2, seconds: float = 7.0) -> Any:
    return SimpleNamespace(unknowns=unknowns, level=level, seconds=seconds)


@pytest.mark.parametrize(("unknowns", "power", "tolerance"), [(1, 0, 1e-2), (10**9, 6, 1e-3)])
def test_few_unknowns_cost_the_set_up_and_many_the_square_of_their_number(
    unknowns: int, power: int, tolerance: float
) -> None:
    """They grow as the cube of the level; the tolerance is the share of the other parts."""
    assert predicted_seconds(3, known=solved(unknowns)) == pytest.approx(7.0 * 1.5**power, rel=tolerance)


def test_a_duration_has_one_digit_and_minutes_from_a_minute_and_a_half_on() -> None:
    for seconds, words in ((0.034, "0.03 s"), (7.4, "7 s"), (83.0, "80 s"), (89.9, "90 s"), (91.0, "2 min")):
        assert about(seconds) == f"about {words}"
    assert about(310.0) == "about 5 min"
