"""The ladder of a contact: run anew, taken from a solution, and what is told before a mesh is solved."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import pytest

from analytic.errors import InputError
from analytic.scene import Contact
from fembearing.compare.contact.discrepancy import ContactSolution, compare_contact
from fembearing.compare.contact.mesh_seconds import about, predicted_seconds
from fembearing.compare.cost import contact_ladder
from fembearing.compare.cost.contact_ladder import LEVEL_BOUNDS, contact_ladder_of
from fembearing.mesh.recipe import Recipe, load_recipe


@pytest.fixture(scope="module")
def coarse() -> Recipe:
    return replace(load_recipe("race"), levels=(1, 2, 3))


@pytest.fixture(scope="module")
def solved(contacts: dict[str, Contact], coarse: Recipe) -> ContactSolution:
    return compare_contact(contacts["inner"], recipe=coarse, tolerance=0.01)


@pytest.mark.usefixtures("timed_once")
def test_a_ladder_of_meshes_is_that_of_the_solution_at_hand(
    solved: ContactSolution, contacts: dict[str, Contact], coarse: Recipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The errors by hand from the solution; the same ladder run anew, and taken over without a solve."""
    steps: list[float] = []
    run = contact_ladder.measured_contact(
        contacts["inner"], recipe=coarse, tolerance=0.01, progress=lambda share, _: steps.append(share)
    )
    monkeypatch.setattr(contact_ladder, "solve_on_mesh", None)
    monkeypatch.setattr(contact_ladder, "fitted_solution", None)
    taken = contact_ladder_of(solved)
    assert [rung.name for rung in taken.rungs] == [
        "Hertz",
        "Hertz, corrected for finite geometry",
        *(f"finite elements, level {level}" for level in (1, 2, 3)),
        "finite elements, extrapolated",
    ]
    names = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
    assert solved.corrected is not None
    quantities = [solved.hertz, solved.corrected.quantities, *(mesh.quantities for mesh in solved.meshes)]
    for number, found in enumerate(quantities):
        expected = max(abs(getattr(found, name) / solved.estimates[name].limit - 1) for name in names)
        assert taken.rungs[number].error == pytest.approx(expected, rel=1e-12)  # round-off
        assert run.rungs[number].error == pytest.approx(expected, rel=1e-6)  # round-off of the factorisation
    assert taken.rungs[-1].error is None
    assert taken.quantity == run.quantity == "contact, inner"
    assert taken.reference == run.reference
    assert "extrapolated" in run.reference
    seconds = [mesh.seconds for mesh in solved.meshes]
    assert [rung.seconds for rung in taken.rungs[2:]] == [*seconds, sum(seconds)]
    assert [rung.unknowns for rung in run.rungs] == [None, None, *(mesh.unknowns for mesh in solved.meshes), None]
    assert [rung.repeats for rung in run.rungs[2:]] == [1, 1, 1, 1]
    assert steps == sorted(steps)
    assert 0 <= steps[0] < steps[-1] < 1


def test_what_is_told_is_the_time_of_all_runs_and_of_a_dear_mesh_there_are_two(
    contacts: dict[str, Contact], coarse: Recipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Meshes that fail end the run at once; what was told before stays."""

    def fail(*_: Any, **__: Any) -> Any:
        raise InputError("not solved")

    foretold = {1: 0.5, 2: 9.0, 3: 30.0}
    sized = SimpleNamespace(level=2, pair=SimpleNamespace(semi_axes=(1e-4, 1e-3)))
    monkeypatch.setattr(contact_ladder, "fitted_solution", lambda *_, **__: sized)
    monkeypatch.setattr(contact_ladder, "predicted_seconds", lambda level, **_: foretold[level])
    monkeypatch.setattr(contact_ladder, "solve_on_mesh", fail)
    steps: list[str] = []
    contact_ladder.measured_contact(
        contacts["inner"], recipe=coarse, tolerance=0.01, progress=lambda _, step: steps.append(step)
    )
    assert [step.partition(", ")[2] for step in steps] == ["about 2 s", "about 40 s", "about 60 s"]


def test_corrected_hertz_is_much_nearer_than_hertz(solved: ContactSolution) -> None:
    """On a contact that its fit has not seen, within what fit and meshes say of themselves; Hertz is far outside."""
    assert solved.corrected is not None
    for name, error in solved.interpolation_error.items():
        allowed = solved.corrected.uncertainty[name] + solved.estimates[name].total
        assert abs(error) < allowed < abs(solved.discrepancy[name]), name
    rungs = contact_ladder_of(solved).rungs
    assert rungs[0].error is not None
    assert rungs[1].error is not None
    assert rungs[1].error < rungs[0].error / 5


def test_the_reference_says_how_far_off_it_is_itself(solved: ContactSolution) -> None:
    names = ("semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach")
    off = max(solved.estimates[name].mesh for name in names)
    assert f"uncertain by {100 * off:.2g} %" in contact_ladder_of(solved).reference


@pytest.mark.usefixtures("timed_once")
def test_a_contact_that_cannot_be_meshed_has_no_reference(contacts: dict[str, Contact], coarse: Recipe) -> None:
    ladder = contact_ladder.measured_contact(replace(contacts["inner"], load=2e5), recipe=coarse, tolerance=0.9)
    assert len(ladder.rungs) == 5
    assert "outside 0 to 0.45 of the fit" in (ladder.rungs[1].failed or "")
    assert all("too wide" in (rung.failed or "") for rung in ladder.rungs[2:])
    assert ladder.rungs[0].error is None
    assert ladder.chosen is None
    assert ladder.reference.startswith("none")


def test_bounds_cover_the_errors_of_a_contact_that_they_were_not_chosen_on(solved: ContactSolution) -> None:
    rungs = contact_ladder_of(solved).rungs
    for rung in rungs[:-1]:
        assert rung.error is not None
        assert rung.bound is not None
        assert rung.error < rung.bound < 10 * rung.error, rung.name
    assert [rung.bound for rung in rungs[2:5]] == [LEVEL_BOUNDS[level] for level in (1, 2, 3)]


def test_a_contact_that_nothing_was_compared_on_has_no_bound(solved: ContactSolution) -> None:
    mesh = solved.meshes[0]
    cut = cast(Any, SimpleNamespace(level=1, shoulder="cut off"))
    assert contact_ladder.level_bound(solved.contact, mesh) == LEVEL_BOUNDS[1]
    assert contact_ladder.level_bound(replace(solved.contact, pair="pocket"), mesh) is None
    assert contact_ladder.level_bound(solved.contact, cut) is None


def mesh_of(level: int, unknowns: int, seconds: float) -> Any:
    return SimpleNamespace(level=level, unknowns=unknowns, seconds=seconds)


def test_seconds_are_foretold_from_the_mesh_before() -> None:
    """Two contacts, alone on a processor: unknowns and seconds of levels 1 to 4."""
    for measured in (
        ((1498, 0.095), (11156, 0.35), (36750, 1.604), (86056, 6.468)),
        ((1670, 0.100), (12420, 0.411), (40890, 2.000), (95720, 7.544)),
    ):
        for known, (level, (_, seconds)) in zip(measured, enumerate(measured[1:], start=2), strict=False):
            told = predicted_seconds(level, known=mesh_of(level - 1, *known))
            assert 1 / 1.5 < told / seconds < 1.5  # stricter than the factor of two that is promised on any machine
    assert predicted_seconds(3, known=mesh_of(3, 40000, 7.7)) == pytest.approx(7.7, rel=1e-12)  # itself
    twice = [predicted_seconds(4, known=mesh_of(2, 11000, seconds)) for seconds in (0.3, 0.6)]
    assert twice[1] == pytest.approx(2 * twice[0], rel=1e-12)  # a machine half as fast


@pytest.mark.parametrize(
    ("seconds", "words"),
    [(0.044, "about 0.04 s"), (2.3, "about 2 s"), (17.0, "about 20 s"), (89.0, "about 90 s"), (130.0, "about 2 min")],
)
def test_a_time_is_told_as_people_do(seconds: float, words: str) -> None:
    assert about(seconds) == words
