"""Numbers at an address: an array that is found again, in Python and in compiled formulas."""

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.memory import address_of, rows_at

ROWS = np.array([[2.5, -3.0, 7.25], [11.0, 0.125, -5.5]])


@compiled
def weighted_sum(address: float, rows: int, columns: int) -> float:
    """Each number times its place, so that none can stand for another."""
    table, total = rows_at(address, rows, columns), 0.0
    for i in range(rows):
        for j in range(columns):
            total += (10 * i + j + 1) * table[i, j]
    return total


def test_rows_at_an_address_are_those_of_the_array() -> None:
    address = address_of(ROWS)
    np.testing.assert_array_equal(rows_at(address, 2, 3), ROWS)
    places = 10 * np.arange(2)[:, None] + np.arange(3) + 1
    assert weighted_sum(address, 2, 3) == np.sum(places * ROWS)
    rows_at(address, 2, 3)[1, 2] = 4.5  # the same memory
    assert ROWS[1, 2] == 4.5
    ROWS[1, 2] = -5.5


def test_an_array_without_numbers_has_no_address() -> None:
    for shape in ((0, 0), (0, 7), (3, 0)):
        assert address_of(np.zeros(shape)) == 0.0
    assert address_of(ROWS) != 0.0
    assert address_of(np.ones((1, 1))) != 0.0
