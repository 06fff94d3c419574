"""A quantity beside its reference, and the verdict by the position of the whole uncertainty interval."""

import math
from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from analytic.errors import InputError
from fembearing.check.comparison import Verdict, compared, compared_with, could_be_decided, verdict_on, worst
from fembearing.grid_convergence import Estimate

TOLERANCE = 0.031
REFERENCE = 6.4


def study(uncertainty: float, **changed: Any) -> Estimate:
    """Meshes that agree on the reference; uncertainty : of the meshes, relative"""
    known = Estimate(values=(REFERENCE, REFERENCE), order=None, richardson=None, mesh=uncertainty)
    return replace(known, **changed)


@pytest.mark.parametrize(
    ("discrepancy", "uncertainty", "changed", "expected"),
    [
        (0.020, 0.007, {}, "pass"),
        (-0.020, 0.007, {}, "pass"),
        (0.029, 0.007, {}, "undecided"),  # the interval straddles the tolerance
        (-0.035, 0.007, {}, "undecided"),
        (0.052, 0.007, {}, "fail"),
        (-0.052, 0.007, {}, "fail"),
        (0.001, 0.04, {}, "undecided"),  # small but unknown
        (0.002, 0.003, {"settled": False, "values": (6.6, 6.5, 6.4)}, "undecided"),  # neither converge nor agree
        (0.002, 1e-4, {"settled": False, "values": (6.401, 6.4005, 6.4)}, "pass"),  # noise far below the tolerance
    ],
)
def test_verdict_follows_the_interval(
    discrepancy: float, uncertainty: float, changed: dict[str, Any], expected: Verdict
) -> None:
    production, part = REFERENCE * (1 + discrepancy), study(uncertainty, **changed)
    assert verdict_on(production, part, tolerance=TOLERANCE) == expected
    assert verdict_on(production, part, tolerance=TOLERANCE, valid=False) == "outside validity"


@given(st.floats(-0.2, 0.2), st.floats(0.0, 0.2))
def test_a_pass_stays_a_pass_at_any_truth_inside_the_interval(discrepancy: float, uncertainty: float) -> None:
    verdict = verdict_on(REFERENCE * (1 + discrepancy), study(uncertainty), tolerance=TOLERANCE)
    ends = [abs(discrepancy - uncertainty), abs(discrepancy + uncertainty)]
    if verdict == "pass":
        assert max(ends) <= TOLERANCE * (1 + 1e-12)  # round-off of the sum
    if verdict == "fail":
        assert min(ends) > TOLERANCE * (1 - 1e-12)


@pytest.mark.parametrize("numbers", [(math.nan, 6.4, 0.3), (6.2, math.inf, 0.3), (6.2, 6.4, math.nan)])
def test_numbers_that_are_not_finite_are_no_result(numbers: tuple[float, float, float]) -> None:
    with pytest.raises(InputError, match="outside the computable range"):
        compared(*numbers)


def test_the_worst_verdict_is_the_most_serious() -> None:
    assert worst(["pass", "undecided", "fail", "outside validity"]) == "fail"
    assert worst(["pass", "undecided", "shown"]) == "undecided"
    assert worst(["shown", "pass"]) == "pass"


@pytest.mark.parametrize(
    ("discrepancy", "changed", "could"),
    [
        (0.030, {}, True),  # against 3.1 %, uncertain by 0.5 %: a finer mesh would pass it
        (0.034, {}, True),  # a finer mesh would fail it
        (0.010, {}, False),  # passed already
        (0.060, {}, False),  # failed already
        (0.030, {"domain": 0.005}, False),  # the block alone leaves it open
        (0.010, {"settled": False, "values": (6.8, 6.3, 6.4)}, True),
    ],
)
def test_a_finer_mesh_decides_what_the_meshes_alone_leave_open(
    discrepancy: float, changed: dict[str, Any], could: bool
) -> None:
    part = study(0.005, **changed)
    assert could_be_decided(REFERENCE * (1 + discrepancy), part, tolerance=TOLERANCE) == could


def test_the_uncertainty_is_that_of_meshes_and_far_boundary() -> None:
    part = study(0.008, beyond=0.25, domain=0.015)  # the value is a quarter more
    found = compared_with(part, 7.6, formula=7.3, verdict="pass")
    assert (found.production, found.formula, found.verdict, found.study) == (7.6, 7.3, "pass", part)
    assert found.reference == pytest.approx(8.0, rel=1e-12)  # round-off
    assert found.uncertainty == pytest.approx(0.017 * 8.0, rel=1e-12)
    assert found.relative_uncertainty == pytest.approx(0.017, rel=1e-12)
    assert found.discrepancy == pytest.approx(-0.05, rel=1e-9)  # a difference of near values


@pytest.mark.parametrize(("production", "resolved"), [(2.31, False), (2.29, True), (-3.7, True), (2.69, False)])
def test_a_difference_is_resolved_beyond_the_uncertainty(production: float, resolved: bool) -> None:
    assert compared(production, 2.5, 0.2).resolved == resolved


def test_of_a_reference_that_may_be_0_nothing_relative_is_known() -> None:
    found = compared(3.0, -0.1, 0.2)
    assert (found.discrepancy, found.relative_uncertainty, found.resolved) == (None, None, True)
