"""Errors of methods against the reference, and the choice for a tolerance. No test asserts a duration."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.check.cost import ladder
from fembearing.check.cost.ladder import Choice, TimedMethod, UntimedMethod, deviation, ladder_of, timed
from tests.analytic.specimens import present


def ran(name: str, answer: list[float] | None, *seconds: float, may_refer: bool = False) -> TimedMethod:
    numbers = None if answer is None else np.array(answer)
    failed = "no answer" if answer is None else None
    return TimedMethod(name=name, answer=numbers, seconds=seconds, may_refer=may_refer, failed=failed)


ROUGH = ran("rough", [3.0, 4.2], 0.2, 0.3, 7.0)  # 50 % and 5 % off
NEAR = ran("near", [2.02, 4.0], 0.9)  # 1 % off
EXACT = replace(ran("exact", [2.0, 4.0], 5.0, may_refer=True), bound=1e-6)


def test_an_error_is_the_worst_deviation_relative_to_the_reference() -> None:
    rough, near, exact = ladder_of("q", "r", (ROUGH, NEAR, EXACT), tolerance=0.1).methods
    assert rough.error == pytest.approx(0.5, rel=1e-12)  # against the rough answer it would be a third
    assert near.error == pytest.approx(0.01, rel=1e-12)
    assert exact.error is None
    assert (rough.seconds, rough.repeats) == (0.3, 3)  # the median, not the mean
    assert rough.spread == pytest.approx(6.8, rel=1e-12)


@pytest.mark.parametrize(("tolerance", "name"), [(0.6, "rough"), (0.5 + 1e-5, "rough"), (0.4, "near"), (1e-3, "exact")])
def test_the_cheapest_within_the_tolerance_is_chosen(tolerance: float, name: str) -> None:
    ladder = ladder_of("q", "r", (ROUGH, NEAR, EXACT), tolerance=tolerance)
    assert [method.name for method in ladder.methods if method.chosen] == [name]
    assert present(ladder.chosen).name == name


def test_the_reference_is_the_last_eligible_method_with_an_answer() -> None:
    coarse, broken = ran("coarse", [2.5, 4.0], 1.0, may_refer=True), ran("finest", None, may_refer=True)
    methods = ladder_of("q", "r", (NEAR, coarse, EXACT, broken), tolerance=0.1).methods
    assert [method.error for method in methods] == [pytest.approx(0.01), pytest.approx(0.25), None, None]
    assert (methods[3].failed, methods[3].seconds, methods[3].chosen) == ("no answer", None, False)
    alone = ladder_of("q", "r", (NEAR, broken), tolerance=0.1)
    assert alone.methods[0].error is None  # no reference does not mean no error
    assert alone.chosen is None


def test_the_first_call_is_not_timed(monkeypatch: pytest.MonkeyPatch) -> None:
    """On a clock that only the formula advances: by 10 s at first, then by half a second."""
    now, calls = [0.0], [0]

    def formula() -> np.ndarray:
        now[0] += 0.5 if calls[0] else 10.0
        calls[0] += 1
        return np.ones(2)

    monkeypatch.setattr(ladder, "time", SimpleNamespace(perf_counter=lambda: now[0]))
    found = timed(UntimedMethod(name="f", run=formula, bound=lambda: 0.25))
    assert found.warm_up == 10.0
    assert set(found.seconds) == {0.5}
    assert len(found.seconds) == ladder.FEWEST_REPEATS  # as it is so slow
    assert found.bound == 0.25


def test_an_input_error_is_kept_as_a_line_and_a_bug_is_raised() -> None:
    def refuse() -> np.ndarray:
        raise InputError("too steep")

    assert timed(UntimedMethod(name="f", run=refuse, bound=lambda: 0.1)).failed == "too steep"
    with pytest.raises(ZeroDivisionError):
        timed(UntimedMethod(name="f", run=lambda: np.array(1 / 0), bound=lambda: 0.1))


def test_a_method_is_chosen_by_its_bound_and_not_by_a_lucky_error() -> None:
    lucky = replace(NEAR, bound=0.2)  # 1 % off, but only known to be within 20 %
    assert [ladder_of("q", "r", (lucky, EXACT), tolerance=limit).methods[0].chosen for limit in (0.21, 0.19)] == [
        True,
        False,
    ]
    wrong = replace(NEAR, bound=0.001)  # a bound that the error breaks does not count
    assert not ladder_of("q", "r", (wrong, EXACT), tolerance=0.005).methods[0].chosen


def test_without_a_bound_the_uncertainty_of_the_reference_is_added_to_the_error() -> None:
    """The motion of a tumbling cage may agree with the reference by luck."""
    for unsure, chosen in ((0.03, True), (0.05, False), (None, False)):  # of 1 % and so much, within 5 %
        method = ladder_of("q", "r", (NEAR, replace(EXACT, bound=unsure)), tolerance=0.05).methods[0]
        assert method.chosen is chosen
        assert method.known_error == (None if unsure is None else pytest.approx(0.01 + unsure, rel=1e-12))


def test_each_digit_has_a_method_and_a_price() -> None:
    sure = replace(NEAR, bound=0.03, seconds=(0.25,))
    near, again, exact, best = ladder_of("q", "r", (sure, EXACT), tolerance=0.1).choices
    assert [choice.tolerance for choice in (near, again, exact, best)] == [0.1, 0.01, 0.001, 0.0001]
    assert [choice.method for choice in (near, again, exact, best)] == ["near", *["exact"] * 3]
    assert [choice.price for choice in (near, again, exact, best)] == [None, 20.0, 1.0, 1.0]  # 5 s over 0.25 s
    unknown = ladder_of("q", "r", (replace(EXACT, bound=0.005),), tolerance=0.1).choices
    assert [choice.method is None for choice in unknown] == [False, False, True, True]
    assert unknown[2] == Choice(tolerance=0.001, method=None, seconds=None, price=None)
    with pytest.raises(ValueError, match="a method without seconds"):
        replace(near, seconds=None)


def test_a_deviation_from_zero_is_infinite_unless_both_are_zero() -> None:
    assert deviation(np.array([0.0, 3.0]), np.array([0.0, 2.0])) == 0.5
    assert deviation(np.array([0.1, 2.0]), np.array([0.0, 2.0])) == np.inf
