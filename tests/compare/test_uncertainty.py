"""Observed order and grid-convergence index on sequences whose exact value is known."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fembearing.compare.uncertainty import CAUTIOUS, FORMAL_ORDER, SAFE, estimate, observed_order

LEVELS = (2, 3, 5)  # unequal ratios, 3/2 and 5/3
SIZES = tuple(1 / level for level in LEVELS)


def sequence(exact: float, slope: float, order: float) -> list[float]:
    return [exact + slope * size**order for size in SIZES]


@given(order=st.floats(0.6, 6.0), slope=st.floats(-3.0, 3.0).filter(lambda s: abs(s) > 0.01))
def test_observed_order_is_that_of_the_sequence(order: float, slope: float) -> None:
    found = observed_order(sequence(7.3, slope, order), SIZES)
    assert found is not None
    # 1e-5: at order 6 the last difference is 1e-4 of the value, so double round-off reaches the tenth digit of it
    np.testing.assert_allclose(found, order, rtol=1e-5)


def test_richardson_value_is_the_exact_one() -> None:
    found = estimate(sequence(7.3, 0.4, 2.7), SIZES).richardson
    assert found is not None
    np.testing.assert_allclose(found, 7.3, rtol=1e-12)  # round-off


@given(order=st.floats(0.6, 4.9), slope=st.floats(-1.0, 1.0).filter(lambda s: abs(s) > 1e-3))
def test_index_is_the_safety_factor_times_the_true_error(order: float, slope: float) -> None:
    values = sequence(7.3, slope, order)
    index, error = estimate(values, SIZES).mesh * abs(values[-1]), abs(values[-1] - 7.3)
    if order < FORMAL_ORDER:
        np.testing.assert_allclose(index, SAFE * error, rtol=1e-4)  # 1e-4: the order's root, raised to a power
    else:  # faster than the formal order is not relied on: wider, by the ratio of the two orders' factors
        ratio = SIZES[-2] / SIZES[-1]
        np.testing.assert_allclose(index, SAFE * error * (ratio**order - 1) / (ratio**FORMAL_ORDER - 1), rtol=1e-4)


@pytest.mark.parametrize(
    "values",
    [(1.3, 1.1, 1.2), (1.1, 1.3, 1.2), (1.3, 1.3, 1.3), (1.0, 1.1, 1.4)],
    ids=["down-up", "up-down", "flat", "grows"],
)
def test_sequences_without_order_have_none(values: tuple[float, float, float]) -> None:
    assert observed_order(values, SIZES) is None


def test_uncertainty_without_order_covers_every_mesh() -> None:
    values = (1.3, 1.1, 1.2)
    found = estimate(values, SIZES)
    assert found.order is None
    assert found.richardson is None
    assert found.mesh * values[-1] >= max(abs(value - values[-1]) for value in values)


def test_unreasonable_order_takes_the_cautious_factor_and_the_formal_order() -> None:
    values = sequence(7.3, 0.9, 7.5)
    found = estimate(values, SIZES)
    change, ratio = abs(values[-1] - values[-2]), SIZES[-2] / SIZES[-1]
    expected = CAUTIOUS * change / (ratio**FORMAL_ORDER - 1) / values[-1]  # Roache's definition
    np.testing.assert_allclose(found.mesh, expected, rtol=1e-12)  # round-off
    assert found.mesh * values[-1] > 10 * abs(values[-1] - 7.3)  # wide, as it should be


@pytest.mark.parametrize("order", [0.1, 0.2, 0.4])
def test_a_crawling_sequence_is_covered(order: float) -> None:
    values = sequence(7.3, 0.4, order)
    assert estimate(values, SIZES).mesh * values[-1] >= abs(values[-1] - 7.3)


def test_only_the_last_three_meshes_decide() -> None:
    fine = sequence(7.3, 0.4, 2.7)
    assert estimate([99.0, *fine], [1.0, *SIZES]).mesh == estimate(fine, SIZES).mesh
