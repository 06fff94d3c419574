"""The ladder of a contact: measured, taken from a solution, and predicted times of meshes."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.scene import Contact
from fembearing.check.contact import refinement
from fembearing.check.contact.mesh_seconds import about, predicted_seconds
from fembearing.check.contact.solution import ContactSolution, compare_contact
from fembearing.check.cost import contact_ladder
from fembearing.check.cost.contact_ladder import LEVEL_BOUNDS, contact_ladder_of
from fembearing.mesh.recipe import Recipe, load_recipe
from tests.analytic.specimens import present


@pytest.fixture(scope="module")
def coarse() -> Recipe:
    return replace(load_recipe("race"), levels=(1, 2, 3))


@pytest.fixture(scope="module")
def solved(contacts: dict[str, Contact], coarse: Recipe) -> ContactSolution:
    """On plain levels."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(refinement, "solve_by_twin", lambda *_, **__: None)
        return compare_contact(contacts["inner"], recipe=coarse, tolerance=0.01)


@pytest.mark.usefixtures("timed_once")
def test_a_measured_ladder_agrees_with_that_of_a_solution(
    solved: ContactSolution, contacts: dict[str, Contact], coarse: Recipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The errors computed here from the solution; the ladder measured, and taken from the solution without a solve."""
    known: list[int] = []

    def noted(level: int, *, known: Any, levels: list[int] = known) -> float:
        levels.append(known.level)
        return predicted_seconds(level, known=known)

    monkeypatch.setattr(contact_ladder, "predicted_seconds", noted)
    run = contact_ladder.measured_contact(contacts["inner"], recipe=coarse, tolerance=0.01)
    assert known == [2, 2, 2]  # of the meshes before, the largest is that of level 2, which sized the contact
    monkeypatch.setattr(contact_ladder, "solve_on_mesh", None)
    monkeypatch.setattr(contact_ladder, "fitted_solution", None)
    taken = contact_ladder_of(solved)
    names = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
    numbers = solved.numbers
    quantities = [numbers.hertz, present(numbers.corrected).quantities, *(mesh.quantities for mesh in solved.meshes)]
    for number, found in enumerate(quantities):
        expected = max(abs(getattr(found, name) / numbers.estimates[name].limit - 1) for name in names)
        assert taken.methods[number].error == pytest.approx(expected, rel=1e-12)  # round-off
        assert run.methods[number].error == pytest.approx(expected, rel=1e-6)  # round-off of the factorisation
    assert taken.methods[-1].error is None
    assert taken.quantity == run.quantity == "contact, inner"
    assert taken.reference == run.reference
    assert "extrapolated" in run.reference
    seconds = [mesh.seconds for mesh in solved.meshes]
    assert [method.seconds for method in taken.methods[2:]] == [*seconds, sum(seconds)]
    *levels, first, second, twin, extrapolated = run.methods
    assert [method.unknowns for method in levels] == [None, None, *(mesh.unknowns for mesh in solved.meshes)]
    assert [each.name for each in (first, second)] == [f"compliance of the pair, level {level}" for level in (1, 2)]
    for each, level in ((first, 1), (second, 2)):  # a compliance of one level is far better than its mesh
        assert present(each.error) < present(each.bound) < LEVEL_BOUNDS[level] / 5
    assert (twin.name, extrapolated.error) == ("finite elements, twin, to level 2", None)
    # The plain levels are themselves uncertain by 0.02 %; those with a twin claim less than a third level alone
    assert present(twin.error) < present(twin.bound) + 2e-4 < present(levels[-1].bound)


def test_corrected_hertz_is_much_closer_than_hertz(solved: ContactSolution) -> None:
    """On a contact outside the fit, within the uncertainties of fit and meshes; Hertz is far outside of them."""
    numbers = solved.numbers
    corrected = present(numbers.corrected)
    for name, error in numbers.interpolation_error.items():
        allowed = corrected.uncertainty[name] + numbers.estimates[name].total
        assert abs(error) < allowed < abs(numbers.quantities[name].difference), name
    methods = contact_ladder_of(solved).methods
    assert methods[0].error is not None
    assert methods[1].error is not None
    assert methods[1].error < methods[0].error / 5


@pytest.mark.usefixtures("timed_once")
def test_a_contact_that_cannot_be_meshed_has_no_reference(contacts: dict[str, Contact], coarse: Recipe) -> None:
    ladder = contact_ladder.measured_contact(replace(contacts["inner"], load=2e5), recipe=coarse, tolerance=0.9)
    assert len(ladder.methods) == 5
    assert "outside 0 to 0.45 of the fit" in (ladder.methods[1].failed or "")
    assert all("the mesh holds up to 3 times that" in (method.failed or "") for method in ladder.methods[2:])
    assert ladder.methods[0].error is None
    assert ladder.chosen is None
    assert ladder.reference.startswith("none")


def test_bounds_cover_the_errors_of_a_new_contact(solved: ContactSolution) -> None:
    methods = contact_ladder_of(solved).methods
    for method in methods[:-1]:
        assert method.error is not None
        assert method.error < present(method.bound) < 10 * method.error, method.name
    assert [method.bound for method in methods[2:5]] == [LEVEL_BOUNDS[level] for level in (1, 2, 3)]


def mesh_of(level: int, unknowns: int, seconds: float) -> Any:
    return SimpleNamespace(level=level, unknowns=unknowns, seconds=seconds)


def test_seconds_are_predicted_from_the_previous_mesh() -> None:
    """Unknowns and seconds of levels 1 to 4 of two contacts on an idle processor."""
    for measured in (
        ((1498, 0.095), (11156, 0.35), (36750, 1.604), (86056, 6.468)),
        ((1670, 0.100), (12420, 0.411), (40890, 2.000), (95720, 7.544)),
    ):
        for known, (level, (_, seconds)) in zip(measured, enumerate(measured[1:], start=2), strict=False):
            expected = predicted_seconds(level, known=mesh_of(level - 1, *known))
            assert 1 / 1.5 < expected / seconds < 1.5  # stricter than the factor of two that is promised on any machine
    assert predicted_seconds(3, known=mesh_of(3, 40000, 7.7)) == pytest.approx(7.7, rel=1e-12)  # the same mesh
    twice = [predicted_seconds(4, known=mesh_of(2, 11000, seconds)) for seconds in (0.3, 0.6)]
    assert twice[1] == pytest.approx(2 * twice[0], rel=1e-12)  # a machine half as fast


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.044, "about 0.04 s"), (2.3, "about 2 s"), (17.0, "about 20 s"), (89.0, "about 90 s"), (130.0, "about 2 min")],
)
def test_a_time_has_one_digit(seconds: float, words: str) -> None:
    assert about(seconds) == words
