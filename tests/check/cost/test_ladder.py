"""Errors of methods against the reference, and the choice for a tolerance. No test asserts a duration."""

import time
from functools import partial

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.check.cost.ladder import Candidate, Ladder, deviation, measured
from tests.analytic.specimens import present


def candidate(
    name: str, answer: list[float], spent: float, bound: float | None = None, may_refer: bool = False
) -> Candidate:
    run = partial(np.array, answer)
    return Candidate(name, run, bound=bound, may_refer=may_refer, once=True, spent=spent)


def refuse() -> None:
    raise InputError("too steep")


ROUGH = candidate("rough", [3.0, 4.2], 0.3)  # 50 % and 5 % off
NEAR = candidate("near", [2.02, 4.0], 0.9)  # 1 % off
EXACT = candidate("exact", [2.0, 4.0], 5.0, 1e-6, may_refer=True)
BROKEN = Candidate("broken", refuse, may_refer=True)


def ladder_of(*candidates: Candidate, tolerance: float = 0.1) -> Ladder:
    return measured("the quantity", "the exact one", candidates, tolerance=tolerance)


@pytest.mark.parametrize(("tolerance", "name"), [(0.6, "rough"), (0.5 + 1e-5, "rough"), (0.4, "near"), (1e-3, "exact")])
def test_the_cheapest_within_the_tolerance_is_chosen_by_the_worst_deviation(tolerance: float, name: str) -> None:
    ladder = ladder_of(ROUGH, NEAR, EXACT, tolerance=tolerance)
    assert [method.error for method in ladder.methods] == [pytest.approx(0.5), pytest.approx(0.01), None]
    assert [method.name for method in ladder.methods if method.chosen] == [name]
    assert (present(ladder.cheapest(tolerance)).name, ladder.cheapest(1e-7)) == (name, None)


def test_the_reference_is_the_last_that_may_be_it_and_has_an_answer() -> None:
    ladder = ladder_of(NEAR, candidate("coarse", [2.5, 4.0], 1.0, may_refer=True), EXACT, BROKEN)
    assert [method.error for method in ladder.methods] == [pytest.approx(0.01), pytest.approx(0.25), None, None]
    assert (ladder.methods[3].failed, ladder.methods[3].seconds) == ("too steep", None)
    assert (ladder.reference, ladder_of(NEAR, EXACT).reference) == ("exact: broken failed", "the exact one")
    alone = ladder_of(NEAR, BROKEN)
    assert alone.methods[0].error is None  # no reference does not mean no error
    assert (alone.cheapest(0.1), alone.reference) == (None, "none: broken failed")
    with pytest.raises(ZeroDivisionError):  # a bug
        ladder_of(NEAR, Candidate("f", lambda: 1 / 0, may_refer=True))


@pytest.mark.parametrize(
    ("bound", "of_reference", "known"),
    [
        (0.2, 1e-6, 0.2),  # 1 % off by luck, but only known to be within 20 %
        (0.001, 1e-6, 0.01),  # a bound that the error breaks does not count
        (None, 0.03, 0.04),  # the reference may be off to the other side
        (None, None, None),
        (None, np.inf, None),
    ],
)
def test_a_method_is_chosen_by_what_is_known_of_its_error(
    bound: float | None, of_reference: float | None, known: float | None
) -> None:
    near, exact = NEAR._replace(bound=bound), EXACT._replace(bound=of_reference)
    for tolerance in (0.005, 0.039, 0.041, 0.19, 0.21):
        method = ladder_of(near, exact, tolerance=tolerance).methods[0]
        assert method.known_error == (None if known is None else pytest.approx(known, rel=1e-9))
        assert method.chosen is (known is not None and known <= tolerance)


def test_a_method_costs_what_was_spent_before_and_the_methods_that_it_takes() -> None:
    both = EXACT._replace(after=("rough", "near", "broken"), spent=0.0)
    assert present(ladder_of(ROUGH, NEAR, BROKEN, both).methods[-1].seconds) == pytest.approx(1.2, abs=0.05)


@pytest.mark.parametrize(
    ("durations", "seconds", "spread"),
    [([10.0, 0.5, 0.7, 9.0], 0.7, 8.5), ([10.0, 12.0], 12.0, 0.0)],  # the median; too dear for a second time
)
def test_a_method_is_timed_without_its_first_call(
    monkeypatch: pytest.MonkeyPatch, durations: list[float], seconds: float, spread: float
) -> None:
    """On a clock that only the formula advances."""
    now, left = [0.0], list(durations)
    monkeypatch.setattr(time, "perf_counter", lambda: now[0])

    def formula() -> np.ndarray:
        now[0] += left.pop(0)
        return np.ones(2)

    (found,) = ladder_of(Candidate("f", formula, may_refer=True)).methods
    assert (found.warm_up, found.repeats, left) == (10.0, len(durations) - 1, [])
    assert (found.seconds, found.spread) == (pytest.approx(seconds), pytest.approx(spread))


def test_a_deviation_from_zero_is_infinite_unless_both_are_zero() -> None:
    assert deviation(np.array([0.0, 3.0]), np.array([0.0, 2.0])) == 0.5
    assert deviation(np.array([0.1, 2.0]), np.array([0.0, 2.0])) == np.inf
