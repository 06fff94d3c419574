"""Least convex energy: known minima, freedoms that nothing holds, problems that do not disturb each other."""

from dataclasses import dataclass

import numpy as np
import pytest

from analytic.errors import ConvergenceError
from analytic.numerics.newton import ConvexState, least_energy
from analytic.scene import Array

WORDS = {"problem": "the test", "remedy": "Give a number."}
ROUND_OFF = 1e-15


@dataclass(frozen=True, kw_only=True, eq=False)
class Springs(ConvexState):
    """Each component of the place stretches a spring of energy (2/5) k |x - centre|^2.5, where the spring has one."""

    centre: Array  # (n, d)
    stiffness: Array  # (n, d); 0: nothing holds this freedom


def springs(place: Array, centre: Array, stiffness: Array) -> Springs:
    stretch = place - centre
    root = np.sqrt(np.abs(stretch))
    return Springs(
        place=place,
        energy=np.sum(0.4 * stiffness * root**5, axis=-1),
        gradient=stiffness * np.sign(stretch) * root**3,
        tangent=(1.5 * stiffness * root)[..., None] * np.eye(place.shape[-1]),
        tolerance=np.full(len(place), 1e-12),
        energy_rounding=np.full(len(place), ROUND_OFF),
        longest_step=np.full(len(place), 3.0),
        centre=centre,
        stiffness=stiffness,
    )


def evaluate(place: Array, state: Springs) -> Springs:
    return springs(place, state.centre, state.stiffness)


CENTRES = np.array([[0.3, -2.0], [70.0, 1.0], [0.0, 0.0]])
STIFFNESS = np.array([[5.0, 0.2], [3.0, 40.0], [1.0, 1.0]])


def test_the_place_is_the_minimum_however_far() -> None:
    """A gradient of 1e-12 leaves a stretch of (1e-12/k)^(2/3)."""
    least, steps = least_energy(evaluate, springs(np.zeros((3, 2)), CENTRES, STIFFNESS), **WORDS)
    np.testing.assert_allclose(least.place, CENTRES, atol=1e-7)
    assert np.all(least.residual <= least.tolerance)
    assert steps[2] == 0  # starts in its minimum
    assert steps[1] > 70 / 3  # no step is longer than 3


def test_each_problem_has_the_result_that_it_has_alone() -> None:
    together, steps = least_energy(evaluate, springs(np.ones((3, 2)), CENTRES, STIFFNESS), **WORDS)
    for row in range(3):
        alone, count = least_energy(evaluate, springs(np.ones((1, 2)), CENTRES[[row]], STIFFNESS[[row]]), **WORDS)
        np.testing.assert_array_equal(alone.place[0], together.place[row])
        assert count[0] == steps[row]


def test_a_freedom_that_nothing_holds_stays_where_it_is() -> None:
    least, _ = least_energy(evaluate, springs(np.full((1, 2), 7.0), np.zeros((1, 2)), np.array([[2.0, 0.0]])), **WORDS)
    assert least.place[0, 1] == 7.0
    np.testing.assert_allclose(least.place[0, 0], 0, atol=1e-7)


def test_a_step_that_overshoots_is_halved() -> None:
    """A power of 1.1: Newton's full step goes to ten times the other side, and would never come back."""

    def steep(place: Array, state: Springs) -> Springs:
        size = np.abs(place)
        return Springs(
            place=place,
            energy=size[:, 0] ** 1.1,
            gradient=1.1 * np.sign(place) * size**0.1,
            tangent=(0.11 * np.maximum(size, 1e-300) ** -0.9)[..., None],
            tolerance=np.full(1, 0.12),
            energy_rounding=np.zeros(1),
            longest_step=np.full(1, 1e6),
            centre=state.centre,
            stiffness=state.stiffness,
        )

    one = np.ones((1, 1))
    least, steps = least_energy(steep, steep(one, springs(one, one, one)), **WORDS)
    assert abs(least.place[0, 0]) < 3e-10  # 1.1 x^0.1 is 0.12 at 2.4e-10
    assert steps[0] < 40


def test_an_energy_that_is_not_a_number_is_reported() -> None:
    start = springs(np.array([[np.nan]]), np.zeros((1, 1)), np.ones((1, 1)))
    with pytest.raises(ConvergenceError, match=r"the test did not settle in 1000 iterations.*Give a number"):
        least_energy(evaluate, start, **WORDS)
