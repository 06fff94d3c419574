"""Named tuples of numbers as records: the same fields, in one block of memory, copied and given back."""

from typing import NamedTuple

import numpy as np
import pytest

from analytic.numerics.records import as_record, copied, dtype_of, record_in, record_of


class Point(NamedTuple):
    load: float
    number: int
    is_on: bool


class Ball(NamedTuple):
    pair: tuple[float, float]
    three: tuple[float, float, float]
    inner: Point


POINTS = Point(2.5, 7, True), Point(-3.25, -1, False), Point(0.5, 9, True)
BALL = Ball((4.5, -6.25), (1.5, 2.75, -8.0), Point(11.0, 3, False))


def test_a_record_has_the_fields_of_its_tuple() -> None:
    record = record_of(BALL)
    np.testing.assert_array_equal(record.pair, [4.5, -6.25])
    np.testing.assert_array_equal(record.three, [1.5, 2.75, -8.0])
    assert (record.inner.load, record.inner.number, bool(record.inner.is_on)) == (11.0, 3, False)


def test_pairs_have_as_many_numbers_as_they_say() -> None:
    kind = dtype_of(Ball)
    assert kind["pair"].shape == (2,)
    assert kind["three"].shape == (3,)
    assert kind["inner"].shape == ()
    assert [dtype_of(Point)[name] for name in Point._fields] == [np.float64, np.int64, np.bool_]


@pytest.mark.parametrize("count", [1, 4])
def test_a_copy_is_another_memory_with_the_same_numbers(count: int) -> None:
    records = np.array([tuple(POINTS[0])] * count, dtype=dtype_of(Point))
    copy = copied(records)
    assert copy.shape == (count,)
    np.testing.assert_array_equal(copy, records)
    copy["load"][0] = 17.0
    assert records["load"][0] == 2.5


def test_a_record_is_copied_as_an_array_of_one_and_given_back() -> None:
    record = record_of(BALL)
    copy = copied(record)
    assert copy.shape == (1,)
    copy["inner"]["load"] = 19.0
    back = record_in(copy)
    assert (back.inner.load, record.inner.load) == (19.0, 11.0)
    back.inner.load = 23.0
    assert copy["inner"]["load"][0] == 23.0  # the same memory


def test_an_element_of_an_array_is_a_record() -> None:
    records = np.array([tuple(each) for each in POINTS], dtype=dtype_of(Point))
    assert as_record(records[1]).number == -1
    record = record_of(POINTS[2])
    assert as_record(record) is record
