"""Formulas of each element: broadcasting, named tuples, ranges, and what refuses; and results of plain functions."""

from typing import NamedTuple

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.numerics.elements import Finite, NotNegative, Positive, formula, mapped
from analytic.scene import Array, SpinRule
from tests.refusals import refused


class Inner(NamedTuple):
    a: Positive
    flag: bool = False


class Outer(NamedTuple):
    b: float
    inner: Inner


@formula
def whole(outer: Outer, table: Array, x: NotNegative = 2.0, rule: SpinRule = "balanced") -> tuple[Outer, float, bool]:
    """The fields again, changed, a sum and a comparison."""
    total = outer.b * table[1] + x * outer.inner.a
    again = Outer(2 * outer.b, Inner(outer.inner.a / 5, not outer.inner.flag))
    return again, total if rule == "balanced" else -total, outer.b > x


@formula
def inverse(x: Finite) -> float:
    return 1 / x


OUTER = Outer(np.array([[3.0], [5.0]]), Inner(np.array([7.0, 11.0, 13.0]), True))  # pyright: ignore[reportArgumentType]
TABLE = np.array([0.0, 100.0])


def test_a_formula_is_taken_of_each_element_of_arrays_in_named_tuples() -> None:
    again, total, larger = whole(OUTER, TABLE, x=[4.0, 2.0, 3.0])
    np.testing.assert_array_equal(total, [[328, 322, 339], [528, 522, 539]])
    np.testing.assert_array_equal(larger, [[False, True, False], [True, True, True]])
    np.testing.assert_array_equal(again.b, [[6.0] * 3, [10.0] * 3])
    np.testing.assert_array_equal(again.inner.a, [[1.4, 2.2, 2.6]] * 2)
    assert not again.inner.flag.any()
    assert (total.dtype, larger.dtype, type(again.inner)) == (np.float64, np.bool_, Inner)


def test_numbers_give_numbers_and_defaults_count() -> None:
    one = Outer(3.0, Inner(7.0))
    again, total, larger = whole(one, TABLE)
    assert (total, larger, again) == (314.0, True, Outer(6.0, Inner(1.4, True)))
    assert whole(outer=one, table=TABLE, rule="inner_control")[1] == -314.0
    assert np.shape(total) == ()
    assert inverse(0) == np.inf  # as compiled formulas divide


def test_no_elements_give_none_of_each_result() -> None:
    again, total, larger = whole(OUTER, TABLE, x=np.empty((0, 2, 3)))
    assert again.inner.a.shape == total.shape == larger.shape == (0, 2, 3)


def test_what_is_out_of_its_range_or_does_not_fit_is_named() -> None:
    refused(lambda: whole(OUTER._replace(inner=Inner(-7.0)), TABLE), "a must be positive", "-7")
    refused(lambda: whole(OUTER, TABLE, x=[2.0, -1.0, 3.0]), "x must be at least 0", "-1")
    refused(lambda: inverse(np.nan), "x must be finite")
    refused(lambda: whole(OUTER, TABLE, rule="either"), "rule must be one of", "balanced", "'either'")
    with pytest.raises(InputError, match=r"b, a, x have shapes \(2, 1\), \(3,\), \(4,\): give equal lengths"):
        whole(OUTER, TABLE, x=np.full(4, 2.0))


def test_results_of_a_plain_function_that_belong_together_are_the_first_axes() -> None:
    found = mapped(lambda a, b: a - b, [[7], [9]], np.array([2.0, 3.0, 5.0], np.float32))
    np.testing.assert_array_equal(found, [[5, 4, 2], [7, 6, 4]])
    pairs = mapped(lambda x, y: ((x, 2 * x, 3 * x), (y, 2 * y, 3 * y)), [2.0, 7.0, 11.0, 13.0], 5.0)
    np.testing.assert_array_equal(pairs[0, 2], [6.0, 21.0, 33.0, 39.0])
    assert mapped(lambda x: (x, 2 * x), []).shape == (2, 0)
    with pytest.raises(ValueError, match="broadcast"):
        mapped(lambda x, y: x - y, [2.0, 3.0], [5.0, 7.0, 11.0])
