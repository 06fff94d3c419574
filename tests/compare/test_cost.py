"""Ladders: errors against what they are measured against, and which rung is taken. No test asserts a duration."""

import json
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.scene import Contact, ContactAngle, Scene
from analytic.scenefile import builtin_scene, load_scene
from fembearing.compare import cost
from fembearing.compare.cost import (
    Trial,
    angle_ladder,
    contact_ladder,
    contact_ladder_of,
    hertz_ladder,
    ladder_of,
    measure_cost,
    timed_formula,
)
from fembearing.compare.discrepancy import ContactSolution, compare_contact
from fembearing.mesh.recipe import Recipe, load_recipe


@pytest.fixture(scope="module")
def scene() -> Scene:
    return load_scene(builtin_scene("6205"))


@pytest.fixture(scope="module")
def coarse() -> Recipe:
    return replace(load_recipe("race"), levels=(1, 2, 3))


@pytest.fixture(scope="module")
def solved(contacts: dict[str, Contact], coarse: Recipe) -> ContactSolution:
    return compare_contact(contacts["inner"], recipe=coarse, tolerance=0.01)


@pytest.fixture
def once(monkeypatch: pytest.MonkeyPatch) -> None:
    """Formulas and meshes timed no more than they must be."""
    monkeypatch.setattr(cost, "MESH_REPEATS", 1)
    monkeypatch.setattr(cost, "FORMULA_REPEATS", 3)
    monkeypatch.setattr(cost, "SAMPLE", 0.0)


def trial(name: str, answer: list[float] | None, *seconds: float, may_refer: bool = False) -> Trial:
    found = None if answer is None else np.array(answer)
    failed = "no answer" if answer is None else None
    return Trial(name=name, answer=found, seconds=seconds, may_refer=may_refer, failed=failed)


ROUGH = trial("rough", [3.0, 4.2], 0.2, 0.3, 7.0)  # 50 % and 5 % off
NEAR = trial("near", [2.02, 4.0], 0.9)  # 1 % off
EXACT = trial("exact", [2.0, 4.0], 5.0, may_refer=True)


def test_an_error_is_the_worst_deviation_relative_to_the_reference() -> None:
    rough, near, exact = ladder_of("q", "r", (ROUGH, NEAR, EXACT), tolerance=0.1).rungs
    assert rough.error == pytest.approx(0.5, rel=1e-12)  # against the rough answer it would be a third
    assert near.error == pytest.approx(0.01, rel=1e-12)
    assert exact.error is None
    assert (rough.seconds, rough.repeats) == (0.3, 3)  # the median, not the mean
    assert rough.spread == pytest.approx(6.8, rel=1e-12)


@pytest.mark.parametrize(("tolerance", "name"), [(0.6, "rough"), (0.5 + 1e-9, "rough"), (0.4, "near"), (1e-3, "exact")])
def test_the_cheapest_within_the_tolerance_is_chosen(tolerance: float, name: str) -> None:
    ladder = ladder_of("q", "r", (ROUGH, NEAR, EXACT), tolerance=tolerance)
    assert [rung.name for rung in ladder.rungs if rung.chosen] == [name]
    assert ladder.chosen is not None
    assert ladder.chosen.name == name


def test_cheap_is_a_matter_of_seconds_and_not_of_place() -> None:
    slow = replace(ROUGH, seconds=(9.0,))
    chosen = ladder_of("q", "r", (slow, NEAR, EXACT), tolerance=0.6).chosen
    assert chosen is not None
    assert chosen.name == "near"


def test_the_reference_is_the_last_that_may_be_and_gave_an_answer() -> None:
    coarse, broken = trial("coarse", [2.5, 4.0], 1.0, may_refer=True), trial("finest", None, may_refer=True)
    rungs = ladder_of("q", "r", (NEAR, coarse, EXACT, broken), tolerance=0.1).rungs
    assert [rung.error for rung in rungs] == [pytest.approx(0.01), pytest.approx(0.25), None, None]
    assert (rungs[3].failed, rungs[3].seconds, rungs[3].chosen) == ("no answer", None, False)
    alone = ladder_of("q", "r", (NEAR, broken), tolerance=0.1)
    assert alone.rungs[0].error is None  # nothing to compare with is not the same as exact
    assert alone.chosen is None


def test_the_first_call_is_not_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a clock that only the formula moves: 10 s at first, then half a second."""
    now, calls = [0.0], [0]

    def formula() -> np.ndarray:
        now[0] += 0.5 if calls[0] else 10.0
        calls[0] += 1
        return np.ones(2)

    monkeypatch.setattr(cost, "time", SimpleNamespace(perf_counter=lambda: now[0]))
    found = timed_formula("f", formula)
    assert set(found.seconds) == {0.5}
    assert len(found.seconds) == cost.FORMULA_REPEATS


def test_a_refusal_is_a_line_and_a_bug_is_not_hidden() -> None:
    def refuse() -> np.ndarray:
        raise InputError("too steep")

    assert timed_formula("f", refuse).failed == "too steep"
    with pytest.raises(ZeroDivisionError):
        timed_formula("f", lambda: np.array(1 / 0))


@pytest.mark.usefixtures("once")
def test_fitted_hertz_is_a_few_per_cent_off_and_a_circle_exact(contacts: dict[str, Contact]) -> None:
    rungs = hertz_ladder((contacts["inner"], contacts["outer"]), tolerance=0.01).rungs
    assert [rung.name for rung in rungs] == ["fitted", "exact"]
    assert rungs[0].error is not None
    assert 0.01 < rungs[0].error < 0.042  # the fits' stated range to a ratio of 100; here 32 and 15
    assert rungs[1].chosen
    flat = replace(contacts["inner"], groove_radius=1e9, rolling_radius=1e9)
    assert hertz_ladder((flat,), tolerance=0.01).rungs[0].error == pytest.approx(0, abs=1e-8)  # 4 mm in 1e9 m


@pytest.mark.usefixtures("once")
def test_the_contact_angle_has_three_rungs(scene: Scene) -> None:
    free, frozen, solved = angle_ladder(scene, tolerance=0.01).rungs
    assert free.error == pytest.approx(1 - 0.18 / 0.3031, abs=1e-3)  # 0.3031: an independent calculation, four digits
    assert frozen.error is not None
    assert frozen.error < 1e-4
    assert solved.error is None
    assert not free.chosen


@pytest.mark.usefixtures("once")
def test_a_preload_leaves_only_the_solved_angle(scene: Scene) -> None:
    outer = replace(scene.bearing.outer, bottom_radius=scene.bearing.outer.bottom_radius - 20e-6)
    tight = replace(
        scene, bearing=replace(scene.bearing, outer=outer), contact_angle=ContactAngle(rule="solved", free=None)
    )
    free, frozen, solved = angle_ladder(tight, tolerance=0.01).rungs
    assert "preload" in (free.failed or "")
    assert "preload" in (frozen.failed or "")
    assert solved.chosen
    assert free.seconds is None


@pytest.mark.usefixtures("once")
def test_a_ladder_of_meshes_is_that_of_the_solution_at_hand(
    solved: ContactSolution, contacts: dict[str, Contact], coarse: Recipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The errors by hand from the solution; the same ladder run anew, and taken over without a solve."""
    steps: list[float] = []
    run = contact_ladder(
        contacts["inner"], recipe=coarse, tolerance=0.01, progress=lambda share, _: steps.append(share)
    )
    monkeypatch.setattr(cost, "solve_on_mesh", None)
    monkeypatch.setattr(cost, "fitted_solution", None)
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


@pytest.mark.usefixtures("once")
def test_a_contact_that_cannot_be_meshed_has_no_reference(contacts: dict[str, Contact], coarse: Recipe) -> None:
    ladder = contact_ladder(replace(contacts["inner"], load=2e5), recipe=coarse, tolerance=0.9)
    assert len(ladder.rungs) == 5
    assert "outside 0 to 0.45 of the fit" in (ladder.rungs[1].failed or "")
    assert all("too wide" in (rung.failed or "") for rung in ladder.rungs[2:])
    assert ladder.rungs[0].error is None
    assert ladder.chosen is None
    assert ladder.reference.startswith("none")


@pytest.mark.usefixtures("once")
def test_a_scene_of_given_angle_has_no_ladder_for_it(
    scene: Scene, coarse: Recipe, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(cost, "load_recipe", lambda _: coarse)
    given = replace(scene, contact_angle=ContactAngle(rule="given", value=0.21))
    found = measure_cost(given, tolerance=1e-12)
    assert [ladder.quantity for ladder in found.ladders] == ["Hertz contact", "contact, inner"]
    for ladder in found.ladders:
        assert ladder.chosen is ladder.rungs[-1]  # no other rung is that near
    told = json.loads(json.dumps(found.to_json(), allow_nan=False))
    assert {"ladders", "tolerance", "cost", "warnings", "provenance"} == told.keys()
    assert {"quantity", "reference", "rungs"} == told["ladders"][1].keys()
    assert {"name", "error", "seconds", "memory", "chosen", "spread", "repeats", "failed", "unknowns"} == told[
        "ladders"
    ][1]["rungs"][2].keys()
    assert told["provenance"]["scene"] == scene.name


def test_a_tolerance_must_be_positive(scene: Scene) -> None:
    with pytest.raises(InputError, match="tolerance must be positive"):
        measure_cost(scene, tolerance=0.0)
