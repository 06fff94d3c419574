"""Chosen elements of contacts and laws, and formulas of each element."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.rolling_contact import RollingContact
from analytic.errors import InputError
from analytic.numerics.elements import elements_of, mapped
from analytic.oil.traction import MixedTraction
from tests.analytic.specimens import OIL

CONTACT = RollingContact(
    load=np.array([[3.0], [170.0]]),
    semi_axis_rolling=np.array([[2e-5], [9e-5]]),
    semi_axis_transverse=np.array([[2e-4], [8e-4]]),
    curvature_rolling=np.array([[310.0], [220.0]]),
    curvature_transverse=9.7,
    modulus=1.13e11,
    deformed_radius=4.1e-3,
    rolling_rate=np.array([[1.9], [2.3]]),
)


def test_chosen_elements_are_those_of_a_contact_that_is_made_anew() -> None:
    chosen = elements_of(CONTACT, lambda value: np.broadcast_to(value, (2, 1))[1])
    anew = RollingContact(**{name: np.broadcast_to(value, (2, 1))[1] for name, value in vars(CONTACT).items()})
    for name, value in vars(anew).items():
        np.testing.assert_array_equal(getattr(chosen, name), value)
    np.testing.assert_array_equal(chosen.mean_pressure, CONTACT.mean_pressure[1])
    with pytest.raises(InputError, match="load"):
        replace(chosen, load=-1.0)


def test_what_is_neither_array_nor_number_stays_and_nothing_known_of_the_whole_is_kept() -> None:
    shares = np.array([[0.2], [0.7]])
    law = MixedTraction(
        lubricant=OIL,
        boundary_friction=0.11,
        asperity_share=shares,
        boundary_share=1.1 * shares,
        oil_area=1 - shares,
        oil_thickness=3e-7 * shares,
    )
    whole = law.point_law  # remembered by the law
    chosen = elements_of(law, lambda value: np.broadcast_to(value, (2, 1))[0])
    assert chosen.lubricant is OIL
    for part, of_all in zip(chosen.point_law, whole, strict=True):
        np.testing.assert_array_equal(part, np.broadcast_to(of_all, (2, 1))[0])


def test_a_function_of_numbers_is_called_for_each_element() -> None:
    """Plain floats, so that a compiled function meets one type of them."""
    given = []

    def difference(a: float, b: float) -> float:
        given.append((a, b))
        return a - b

    found = mapped(difference, [[7], [9]], np.array([2.0, 3.0, 5.0], np.float32))
    np.testing.assert_array_equal(found, [[5, 4, 2], [7, 6, 4]])
    assert found.dtype == np.float64
    assert {type(number) for numbers in given for number in numbers} == {float}
    assert np.shape(mapped(difference, 7, 2)) == ()


def test_results_that_belong_together_are_the_first_axes() -> None:
    halves, roots = mapped(lambda x: (x / 2, x**0.5), [[4.0, 9.0, 25.0]])
    np.testing.assert_array_equal(halves, [[2.0, 4.5, 12.5]])
    np.testing.assert_array_equal(roots, [[2.0, 3.0, 5.0]])
    pairs = mapped(lambda x, y: ((x, 2 * x, 3 * x), (y, 2 * y, 3 * y)), [2.0, 7.0, 11.0, 13.0], 5.0)
    np.testing.assert_array_equal(pairs[0, 2], [6.0, 21.0, 33.0, 39.0])
    np.testing.assert_array_equal(pairs[1, 1], np.full(4, 10.0))


def test_no_elements_give_none_of_each_result() -> None:
    assert mapped(lambda x, y: x - y, np.empty((0, 3)), 2.0).shape == (0, 3)
    assert mapped(lambda x: (x, 2 * x), []).shape == (2, 0)


def test_shapes_that_do_not_fit_are_refused() -> None:
    with pytest.raises(ValueError, match="broadcast"):
        mapped(lambda x, y: x - y, [2.0, 3.0], [5.0, 7.0, 11.0])
