"""The estimate from levels with a twin: its order, its uncertainty, and where plain levels take its place."""

from collections.abc import Callable
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.scene import Contact
from fembearing.check.contact.meshed_region import STIFFNESS
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
    solve_reference,
)
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.mesh.recipe import Recipe, load_recipe

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
