"""Extrapolation and its uncertainty on sequences with a known exact value."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fembearing.grid_convergence import estimate, grid_convergence_index, mesh_allowed, observed_order
from tests.analytic.specimens import present

LEVELS = (2, 3, 5)  # unequal ratios, 3/2 and 5/3
SIZES = tuple(1 / level for level in LEVELS)
NOTHING_CLOSER = 8e-5  # added to every uncertainty
NOT_BY_CHANCE = 3e-4  # added for a quantity without order


def sequence(exact: float, slope: float, order: float) -> list[float]:
    return [exact + slope * size**order for size in SIZES]


@given(order=st.floats(0.6, 6.0), slope=st.floats(-3.0, 3.0).filter(lambda s: abs(s) > 0.01))
def test_observed_order_is_that_of_the_sequence(order: float, slope: float) -> None:
    observed = observed_order(sequence(7.3, slope, order), SIZES)
    # 1e-5: at order 6 the last difference is 1e-4 of the value, so double round-off reaches the tenth digit of it
    np.testing.assert_allclose(present(observed), order, rtol=1e-5)


@pytest.mark.parametrize("order", [3.0, 4.0])
def test_a_sequence_of_the_formal_order_is_extrapolated_to_its_limit(order: float) -> None:
    values = sequence(7.3, 0.4, order)
    part = estimate(values, SIZES, formal_order=order)
    assert part.settled
    np.testing.assert_allclose(part.value, 7.3, rtol=1e-12)  # round-off
    step = abs(7.3 - values[-1])  # by definition: from the finest value to the extrapolated one
    np.testing.assert_allclose(part.mesh, 0.5 * step / values[-1] + NOTHING_CLOSER, rtol=1e-9)  # round-off of a change


@given(
    formal=st.sampled_from([3.0, 4.0]),
    off=st.floats(-0.5, 1.0),
    slope=st.floats(-1.0, 1.0).filter(lambda s: abs(s) > 1e-3),
)
def test_an_order_near_the_formal_one_is_covered(formal: float, off: float, slope: float) -> None:
    """Half the step allows for a true error of 0.5 to 1.5 times the step: orders of 2.5 to 4 where 3 is formal."""
    part = estimate(sequence(7.3, slope, formal + off), SIZES, formal_order=formal)
    assert abs(part.value - 7.3) <= part.mesh * abs(part.values[-1])


@pytest.mark.parametrize(
    "values",
    [(1.3, 1.1, 1.2), (1.1, 1.3, 1.2), (1.3, 1.3, 1.3), (1.0, 1.1, 1.4)],
    ids=["down-up", "up-down", "flat", "grows"],
)
def test_non_monotonic_and_diverging_sequences_have_no_order(values: tuple[float, float, float]) -> None:
    assert observed_order(values, SIZES) is None


@pytest.mark.parametrize(
    ("values", "widest"), [((1.3, 1.1, 1.25), 0.2), ((1.0, 1.1, 1.4), 0.4), ((1.0, 1.3, 1.1), 0.3)]
)
def test_meshes_that_do_not_converge_are_not_extrapolated(values: tuple[float, ...], widest: float) -> None:
    part = estimate(values, SIZES, formal_order=4.0)
    assert not part.settled
    assert part.value == values[-1]
    np.testing.assert_allclose(part.mesh, 3 * widest / values[-1] + NOTHING_CLOSER, rtol=1e-12)  # round-off


@pytest.mark.parametrize("order", [0.1, 0.2, 0.4])
def test_a_slowly_converging_sequence_is_covered(order: float) -> None:
    part = estimate(sequence(7.3, 0.4, order), SIZES, formal_order=3.0)
    assert part.mesh * part.value >= abs(part.value - 7.3)


@pytest.mark.parametrize(("formal", "order"), [(3.0, 1.7), (4.0, 2.9), (None, 2.2)])
def test_below_the_formal_order_roaches_index_is_three_times_the_error(formal: float | None, order: float) -> None:
    """The sequence has one order, so its error is known."""
    part = estimate(sequence(7.3, 0.4, order), SIZES, formal_order=formal)
    # Tolerance: the order comes from a root search
    np.testing.assert_allclose(present(part.grid_convergence_index), 3 * abs(7.3 / part.values[-1] - 1), rtol=1e-5)


def test_the_mesh_may_err_by_what_the_domain_leaves_of_the_accuracy() -> None:
    allowed = mesh_allowed(0.025, domain=0.007)
    np.testing.assert_allclose(allowed, 0.024, rtol=1e-12)  # round-off
    assert mesh_allowed(0.025, domain=0.06) == 0.03  # half of what no mesh lowers


@pytest.mark.parametrize(("formal", "singular"), [(4.0, False), (3.0, False), (None, False), (None, True)])
def test_two_meshes_give_the_same_as_the_last_two_of_a_converging_sequence(
    formal: float | None, singular: bool
) -> None:
    values = sequence(7.3, -0.4, 3.3)
    three = estimate(values, SIZES, formal_order=formal, singular=singular)
    two = estimate(values[1:], SIZES[1:], formal_order=formal, singular=singular)
    assert three.settled
    assert two.settled
    assert two.order is None
    assert (two.value, two.mesh) == (three.value, three.mesh)


@pytest.mark.parametrize(
    ("order", "expected"),
    [
        (3.7, 1.25 * 0.02 / (1.7**4 - 1)),  # within a tenth of the formal order of 4, which is taken
        (3.4, 3 * 0.02 / (1.7**3.4 - 1)),  # farther from it than a tenth: the cautious factor, with the lower order
        (4.9, 3 * 0.02 / (1.7**4 - 1)),  # the same above it
        (0.6, 3 * 0.02 / (1.7**0.6 - 1)),
        (0.2, 3 * 0.02 / (1.7**0.5 - 1)),  # no lower than a half
    ],
)
def test_factor_and_order_of_the_grid_convergence_index_change_at_their_limits(order: float, expected: float) -> None:
    index = grid_convergence_index(-0.02, 1.7, order=order, formal=4.0)
    assert index == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(("formal", "singular"), [(4.0, False), (None, False), (None, True)])
def test_a_quantity_below_0_is_as_uncertain_as_its_mirror_image(formal: float | None, singular: bool) -> None:
    values = sequence(7.3, 0.4, 3.1)
    above, below = (
        estimate([sign * value for value in values], SIZES, formal_order=formal, singular=singular) for sign in (1, -1)
    )
    assert below.mesh == pytest.approx(above.mesh, rel=1e-12)
    assert below.value == pytest.approx(-above.value, rel=1e-12)
    assert below.spread == pytest.approx(above.spread, rel=1e-12)
    assert below.uncertainty == pytest.approx(above.uncertainty, rel=1e-12)
    assert above.uncertainty == pytest.approx(above.total * above.value, rel=1e-12)


def test_meshes_converge_where_the_last_change_is_below_half_of_the_one_before() -> None:
    for ratio, settled in ((0.49, True), (0.51, False), (-0.49, True), (-0.51, False), (0.0, True)):
        assert estimate((7.0, 7.2, 7.2 + 0.2 * ratio), SIZES, formal_order=3.0).settled == settled
    assert estimate((7.3, 7.3, 7.3), SIZES, formal_order=3.0).settled


def test_a_singular_quantity_has_three_times_its_last_change() -> None:
    part = estimate((7.0, 7.2, 7.23), SIZES, formal_order=None, singular=True)
    assert part.mesh == pytest.approx(3 * 0.03 / 7.23 + NOT_BY_CHANCE + NOTHING_CLOSER, rel=1e-9)
    assert part.value == 7.23


def test_what_lies_outside_raises_the_value_and_not_the_last_mesh() -> None:
    part = replace(estimate((6.0, 7.1, 7.2, 7.25), (1.0, *SIZES), formal_order=None), beyond=0.02)
    assert part.limit == 7.25
    assert part.value == pytest.approx(7.25 * 1.02, rel=1e-12)
    assert part.spread == pytest.approx(0.15 / part.value, rel=1e-9)  # of the last three
