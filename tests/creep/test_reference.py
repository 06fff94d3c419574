"""Value and uncertainty of a ball's friction from three grids."""

import numpy as np
import pytest

from analytic.errors import InputError
from fembearing.creep.reference import GRIDS, creep_reference, estimate
from tests.creep.test_ball import thrust_ball


def test_a_sequence_of_second_order_has_its_limit_inside_and_half_of_the_error_left() -> None:
    sizes = 1 / 8, 1 / 12, 1 / 16
    first, middle, fine = (7.3 + 0.9 * size**2 for size in sizes)
    found = estimate((first, middle, fine), sizes)
    np.testing.assert_allclose(found.value - 7.3, 0.9 / 16**2 / 2, rtol=1e-9)  # round-off of 7.3
    np.testing.assert_allclose(found.uncertainty, 3 * 0.9 / 16**2 + 1e-4 * fine, rtol=1e-9)
    assert found.order == pytest.approx(2, rel=1e-9)


def test_two_grids_that_agree_by_chance_do_not_hide_the_change_before() -> None:
    found = estimate((7.1, 7.3, 7.3), (1 / 8, 1 / 12, 1 / 16))
    assert found.value == 7.3
    assert found.uncertainty > 0.1


def test_a_quantity_that_is_0_by_symmetry_is_known_to_be_so() -> None:
    found = estimate((0.0, 0.0, 0.0), (1 / 8, 1 / 12, 1 / 16))
    assert (found.value, found.uncertainty) == (0.0, 0.0)


def test_grids_become_finer_until_the_torque_is_certain() -> None:
    ball = thrust_ball(0.08, 250.0)
    rough, fine = creep_reference(ball, tolerance=0.05), creep_reference(ball, tolerance=1e-6)
    assert rough.grids == GRIDS[:3]
    assert fine.grids == GRIDS[-3:]  # the last grid ends it in any case
    assert rough.torque.uncertainty <= 0.05 * rough.torque.value
    truth = fine.finest  # two levels finer than the rough one
    assert abs(rough.torque.value - truth.torque) <= rough.torque.uncertainty
    assert abs(rough.inner.spin_moment.value - truth.races[0].spin_moment) <= rough.inner.spin_moment.uncertainty


def test_a_tolerance_of_nothing_is_refused() -> None:
    with pytest.raises(InputError, match="tolerance must be positive"):
        creep_reference(thrust_ball(0.08, 250.0), tolerance=0.0)
