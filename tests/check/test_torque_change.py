"""What contact discrepancies do to the race torque, against how each part scales."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.loads.finite_geometry import corrections_of
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.comparison import compared
from fembearing.check.torque_change import TorqueChange, change_of_torque
from fembearing.report.report import change_record
from tests.analytic.scenefile.scene_texts import LUBRICANT, SURFACE
from tests.analytic.specimens import present

SCENE = """
name = "held angle"
tolerance = "5 %"
[bearing]
catalog = "paper_6205"
contact_angle = { rule = "RULE", VALUE = "0.21 rad" }
[operation]
axial_load = ["700 N", "900 N"]
inner_speed = "90 rpm"
[friction]
coefficient = 0.07
hysteresis_loss = 0.006
[effects]
spin = "off"
finite_geometry = "off"
"""
FIXED = parse_scene(SCENE.replace("RULE", "given").replace("VALUE", "value"), origin="test")
SOLVED = parse_scene(SCENE.replace("RULE", "solved").replace("VALUE", "free"), origin="test")
NAMES = ("semi_axis_rolling", "semi_axis_transverse", "approach")


def solution(uncertainty: float = 0.0, **ratios: float) -> Any:
    """All that is read of a solved contact; `ratios` are finite elements over Hertz."""
    found = {name: compared(1.3, 1.3 * ratios.get(name, 1.0), 1.3 * uncertainty) for name in NAMES}
    return SimpleNamespace(numbers=SimpleNamespace(verdict="pass", quantities=found))


def change_in(scene: Scene, **contacts: Any) -> TorqueChange:
    return change_of_torque(scene, friction_torque(scene), **contacts)


def relative(found: TorqueChange, part: str) -> NDArray[np.float64]:
    change = present(found.relative(part))
    return change[found.is_solved]


def test_no_discrepancy_changes_nothing() -> None:
    found = change_in(SOLVED, inner=solution(), outer=solution())
    np.testing.assert_array_equal(relative(found, "total"), 0.0)
    assert found.uncertainty == 0.0


def test_conformity_goes_with_the_square_of_the_major_axis_and_hysteresis_with_the_minor() -> None:
    both = solution(semi_axis_rolling=1.03, semi_axis_transverse=0.98)
    found = change_in(FIXED, inner=both, outer=both)
    # Slip across the rolling direction goes with a and counts for less than a tenth.
    np.testing.assert_allclose(relative(found, "conformity"), 0.98**2 - 1, atol=0.1 * (1.03 / 0.98 - 1))
    np.testing.assert_allclose(relative(found, "hysteresis"), 1.03 - 1, rtol=1e-9)  # round-off
    assert found.relative("spin") is None


def test_uncertainty_adds_what_each_input_does_alone() -> None:
    sure, unsure = solution(), solution(uncertainty=0.01)
    alone = [
        change_in(FIXED, inner=unsure, outer=sure).uncertainty,
        change_in(FIXED, inner=sure, outer=unsure).uncertainty,
    ]
    both = change_in(FIXED, inner=unsure, outer=unsure).uncertainty
    np.testing.assert_allclose(both, sum(alone), rtol=1e-9)  # round-off
    assert 0.01 < both < 0.05  # b counts twice, a once for its share, the approach not at a held angle


def test_each_race_gets_the_factors_of_its_own_contact() -> None:
    """At a held angle the balls' load stays, so that a contact changes by its factors and by nothing else."""
    inner = solution(semi_axis_rolling=1.02, semi_axis_transverse=0.97, approach=0.95)
    outer = solution(semi_axis_rolling=0.99, semi_axis_transverse=1.04, approach=1.06)
    found = change_in(FIXED, inner=inner, outer=outer)
    for race, expected in (("inner", (1.02, 0.97, 0.95)), ("outer", (0.99, 1.04, 1.06))):
        before, after = getattr(found.own, race), getattr(found.corrected, race)
        for name, factor in zip(NAMES, expected, strict=True):
            np.testing.assert_allclose(getattr(after, name) / getattr(before, name), factor, rtol=1e-9)  # round-off


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_an_uncertain_input_counts_as_much_as_that_change_of_it(race: str) -> None:
    """One race uncertain by 1 % in all: as if its contact were 1 % larger, one input at a time."""
    sure, other = solution(), "outer" if race == "inner" else "inner"
    uncertainty = change_in(SOLVED, **{race: solution(uncertainty=0.01), other: sure}).uncertainty
    moved = [change_in(SOLVED, **{race: solution(**{name: 1.01}), other: sure}) for name in NAMES]
    # Tolerance: that of the angle's root
    np.testing.assert_allclose(uncertainty, sum(abs(relative(each, "total")[-1]) for each in moved), rtol=1e-6)


def test_each_part_and_the_angle_are_as_uncertain_as_their_own_change() -> None:
    unsure = solution(uncertainty=0.01)
    held = change_in(FIXED, inner=unsure, outer=unsure).uncertainties
    assert held.keys() == {"total", "race", "conformity", "hysteresis", "contact_angle"}  # spin is off
    # At a held angle hysteresis goes with the minor axis of each race and conformity with the square of the major one:
    # the shares of both races add up to one.
    np.testing.assert_allclose(held["hysteresis"], 0.01, rtol=1e-9)  # round-off
    np.testing.assert_allclose(held["conformity"], 1.01**2 - 1, rtol=1e-3)  # slip across moves it between the two axes
    assert held["contact_angle"] == 0.0
    free = change_in(SOLVED, inner=unsure, outer=unsure).uncertainties
    moved = [
        change_in(SOLVED, inner=inner, outer=outer).corrected.contact_angle[-1]
        for inner, outer in ((solution(approach=1.01), solution()), (solution(), solution(approach=1.01)))
    ]
    angle = change_in(SOLVED, inner=solution(), outer=solution()).corrected.contact_angle[-1]
    np.testing.assert_allclose(free["contact_angle"], sum(abs(each / angle - 1) for each in moved), rtol=1e-6)


def test_nothing_is_claimed_at_loads_that_were_not_solved() -> None:
    """700 N and 900 N: the contacts are those of the heavier ball, and their ratios to Hertz fade with the load."""
    change = present(change_in(SOLVED, inner=solution(approach=0.97), outer=solution()).relative("total"))
    assert np.isnan(change[0])
    assert np.isfinite(change[1])


def test_the_change_carries_the_worse_verdict_of_its_contacts() -> None:
    sound, bad = solution(), solution()
    bad.numbers.verdict = "outside validity"
    for inner, outer in ((sound, bad), (bad, sound)):
        assert change_record(change_in(FIXED, inner=inner, outer=outer)).verdict == "outside validity"


def test_the_correction_for_finite_geometry_knows_every_load() -> None:
    """Its own factors at each load, whatever was solved; at a held angle without spin they act as b^2 and a."""
    change = change_in(FIXED, inner=solution(), outer=solution())
    found = present(change.fitted)
    low, high = found.relative
    assert high < low < 0  # the contact is shorter across, the more so the larger it is
    bearing, load = FIXED.bearing, FIXED.operation.axial_load
    factors = corrections_of(bearing, thrust_equilibrium(bearing, FIXED.contact_angle, axial_load=load))
    squares = [np.asarray(side.factors.semi_axis_transverse) ** 2 for side in (factors.inner, factors.outer)]
    own, changed = change.own.torque, found.torque.torque
    ratio = present(changed.conformity) / present(own.conformity)
    assert (np.minimum(*squares) < ratio).all()
    assert (ratio < np.maximum(*squares)).all()
    assert (found.uncertainty > 0).all()
    assert (found.uncertainty < np.abs(found.relative)).all()
    assert np.isfinite(found.relative).all()


def test_a_lubricated_scene_changes_by_angle_and_contacts() -> None:
    """Rolling has no contact of its own to correct: at a held angle it stays, and what slides moves."""
    text = SCENE.replace("coefficient = 0.07\n", "").replace("RULE", "given").replace("VALUE", "value")
    wide = solution(semi_axis_transverse=1.04)
    found = change_in(parse_scene(text + LUBRICANT + SURFACE, origin="test"), inner=wide, outer=wide)
    np.testing.assert_array_equal(relative(found, "rolling"), 0.0)
    assert (relative(found, "conformity") > 0).all()
    assert (relative(found, "total") > 0).all()
    assert np.isfinite(found.uncertainty)
    assert present(change_record(found).change.rolling)[-1] == 0.0


def test_the_total_is_that_of_the_production_with_what_the_races_change() -> None:
    """A cage and declared seals are in the total; a contact larger by a factor moves the races' part alone."""
    scene = parse_scene(
        SCENE.replace("RULE", "given").replace("VALUE", "value") + '[cage]\n[losses]\nseals = "7 N mm"\n', origin="test"
    )
    production = friction_torque(scene)
    both = solution(semi_axis_rolling=0.98**2, semi_axis_transverse=0.98)  # so that both parts go with 0.98^2
    found = change_of_torque(scene, production, inner=both, outer=both)
    assert present(production.torque.cage)[-1] > 0
    expected = production.torque.total - (1 - 0.98**2) * production.torque.race
    # The part of the slip across, a tenth of what slides, goes with a: 2 % more of it at most.
    np.testing.assert_allclose(found.total[-1], expected[-1], rtol=2e-3)
    np.testing.assert_allclose(change_record(found).torque.production, production.torque.total, rtol=0)
    np.testing.assert_allclose(
        present(found.relative("total"))[-1], (expected / production.torque.total)[-1] - 1, atol=2e-3
    )


def test_contacts_that_are_those_of_the_fit_change_nothing_where_the_production_has_it() -> None:
    """At one load, so that the fit has one factor for each race; without the fit they change what it does."""
    one = replace(FIXED, operation=replace(FIXED.operation, axial_load=np.array([900.0]), inner_speed=np.array([9.4])))
    fit = corrections_of(one.bearing, thrust_equilibrium(one.bearing, one.contact_angle, axial_load=np.array([900.0])))
    contacts = {
        race: solution(**{name: float(np.asarray(getattr(side.factors, name))[0]) for name in NAMES})
        for race, side in (("inner", fit.inner), ("outer", fit.outer))
    }
    on = change_in(replace(one, effects={**one.effects, "finite_geometry": "on"}), **contacts)
    np.testing.assert_allclose(present(on.relative("total")), 0.0, atol=1e-9)  # round-off of the factors
    assert on.fitted is None
    assert change_record(on).finite_geometry is None
    assert "the error of that fit" in on.note
    off = change_in(one, **contacts)
    assert off.fitted is not None
    np.testing.assert_allclose(present(off.relative("total")), off.fitted.relative, rtol=1e-9)  # likewise
    assert np.all(np.abs(off.fitted.relative) > 1e-3)
    assert "without the fit" in off.note


def test_every_other_effect_is_as_the_production_decided_it() -> None:
    """The cage alone is left out of both: it moves no contact of the races."""
    production = friction_torque(SOLVED)
    found = change_of_torque(SOLVED, production, inner=solution(approach=0.97), outer=solution())
    assert found.own.sliding == found.corrected.sliding == production.sliding
    decisions = [
        {e.name: e.decision for e in torque.effects if e.name not in ("cage", "finite_geometry")}
        for torque in (production, found.own, found.corrected)
    ]
    assert decisions[0] == decisions[1] == decisions[2]
    assert not found.own.is_on("cage")
