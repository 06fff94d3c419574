"""The verdict by the position of the whole uncertainty interval."""

from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from fembearing.check.contact.verdict import Verdict, could_be_decided, judge, verdict_on, worst
from fembearing.grid_convergence import Estimate

TOLERANCE = 0.031


@pytest.mark.parametrize(
    ("discrepancy", "uncertainty", "more", "expected"),
    [
        (0.020, 0.007, {}, "pass"),
        (-0.020, 0.007, {}, "pass"),
        (0.029, 0.007, {}, "undecided"),  # the interval straddles the tolerance
        (-0.035, 0.007, {}, "undecided"),
        (0.052, 0.007, {}, "fail"),
        (-0.052, 0.007, {}, "fail"),
        (0.001, 0.04, {}, "undecided"),  # small but unknown
        (0.002, 0.003, {"settled": False, "spread": 0.02}, "undecided"),
        (0.002, 1e-4, {"settled": False, "spread": 1e-4}, "pass"),  # noise far below the tolerance
        (0.0, 0.0, {"valid": False}, "outside validity"),
    ],
)
def test_verdict_follows_the_interval(
    discrepancy: float, uncertainty: float, more: dict[str, Any], expected: Verdict
) -> None:
    given: dict[str, Any] = {"settled": True, "spread": 2 * uncertainty} | more
    assert judge(discrepancy=discrepancy, uncertainty=uncertainty, tolerance=TOLERANCE, **given) == expected


def test_meshes_that_neither_converge_nor_agree_leave_a_close_value_undecided() -> None:
    """5.0 against 4.9 is within the tolerance of 3.1 %; the meshes differ by 8 %, and by 0.2 %."""
    apart = Estimate(values=(5.3, 5.0, 4.9), order=None, richardson=None, mesh=0.001, settled=False)
    assert verdict_on(5.0, apart, tolerance=TOLERANCE, valid=True) == "undecided"
    alike = replace(apart, values=(4.91, 4.905, 4.9))
    assert verdict_on(5.0, alike, tolerance=TOLERANCE, valid=True) == "pass"


@given(st.floats(-0.2, 0.2), st.floats(0.0, 0.2))
def test_a_pass_stays_a_pass_at_any_truth_inside_the_interval(discrepancy: float, uncertainty: float) -> None:
    verdict = judge(
        discrepancy=discrepancy, uncertainty=uncertainty, tolerance=TOLERANCE, settled=True, spread=uncertainty
    )
    ends = [abs(discrepancy - uncertainty), abs(discrepancy + uncertainty)]
    if verdict == "pass":
        assert max(ends) <= TOLERANCE * (1 + 1e-12)  # round-off of the sum
    if verdict == "fail":
        assert min(ends) > TOLERANCE * (1 - 1e-12)


def test_the_worst_verdict_is_the_most_serious() -> None:
    assert worst(["pass", "undecided", "fail", "outside validity"]) == "fail"
    assert worst(["pass", "undecided", "pass"]) == "undecided"
    assert worst(["pass", "pass"]) == "pass"


@pytest.mark.parametrize(
    ("formula", "changed", "could"),
    [
        (5.15, {}, True),  # 3 % against 3.1 %, uncertain by 0.5 %: a finer mesh would pass it
        (5.17, {}, True),  # 3.4 %, which a finer mesh would fail
        (5.05, {}, False),  # 1 %: passed already
        (5.3, {}, False),  # 6 %: failed already
        (5.15, {"domain": 0.005}, False),  # the block alone leaves it open
        (5.05, {"settled": False, "values": (5.3, 4.9, 5.0)}, True),
    ],
)
def test_a_finer_mesh_decides_what_the_meshes_alone_leave_open(
    formula: float, changed: dict[str, Any], could: bool
) -> None:
    part = Estimate(values=(4.99, 5.0), order=None, richardson=None, mesh=0.005)
    assert could_be_decided(formula, replace(part, **changed), tolerance=TOLERANCE) == could
