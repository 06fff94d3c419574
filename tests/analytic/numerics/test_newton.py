"""Newton's step against the linear system that it solves, freedoms that nothing holds, and steps that are too long."""

import numpy as np
import pytest

from analytic.numerics.newton import LEAST_TANGENT, is_too_long, newton_step, plane_step

FAR = 1e3  # m: a length that limits no step here


def stepped(tangent: np.ndarray, gradient: np.ndarray, longest: float = FAR) -> tuple[np.ndarray, float]:
    step = np.full(len(gradient), np.nan)
    promised = newton_step(tangent, gradient, longest, np.full_like(tangent, np.nan), step)
    return step, promised


def stiff(seed: int, freedoms: int) -> tuple[np.ndarray, np.ndarray]:
    """A positive definite tangent with stiffnesses from 1e3 to 1e8 N/m, and a gradient."""
    random = np.random.default_rng(seed)
    directions, _ = np.linalg.qr(random.normal(size=(freedoms, freedoms)))
    tangent = directions * np.geomspace(1e3, 1e8, freedoms) @ directions.T
    return (tangent + tangent.T) / 2, random.normal(size=freedoms)


@pytest.mark.parametrize("freedoms", [2, 5])
def test_a_step_leaves_no_gradient_of_a_quadratic_energy(freedoms: int) -> None:
    tangent, gradient = stiff(7, freedoms)
    step, promised = stepped(tangent, gradient)
    left = 2 * freedoms * LEAST_TANGENT * 1e8 / 1e3  # the trace's share over the softest freedom
    np.testing.assert_allclose(tangent @ step, -gradient, atol=left * float(np.linalg.norm(gradient)))
    np.testing.assert_allclose(promised, gradient @ step, rtol=1e-12)
    assert promised < 0


def test_both_forms_of_a_step_agree_in_a_plane() -> None:
    tangent, gradient = stiff(8, 2)
    for longest in (FAR, 2e-4):
        step, _ = stepped(tangent, gradient, longest)
        plane = plane_step((tangent[0, 0], tangent[0, 1], tangent[1, 1]), (gradient[0], gradient[1]), longest)
        np.testing.assert_allclose(plane, step, rtol=1e-10)  # round-off times a condition of 1e5
    np.testing.assert_allclose(np.abs(step).max(), 2e-4, rtol=1e-12)  # the last one was limited


@pytest.mark.parametrize("freedoms", [2, 5])
def test_a_freedom_that_nothing_holds_stays_where_it_is(freedoms: int) -> None:
    tangent, gradient = np.zeros((freedoms, freedoms)), np.zeros(freedoms)
    tangent[0, 0], gradient[0] = 3e7, -21.0
    step, _ = stepped(tangent, gradient)
    np.testing.assert_allclose(step[0], 21.0 / 3e7, rtol=1e-12)
    assert not step[1:].any()


def test_where_nothing_holds_at_all_the_gradient_leads_as_far_as_is_allowed() -> None:
    step, _ = stepped(np.zeros((5, 5)), np.array([0.0, -3.0, 0.0, 1.5, 0.0]), 4e-4)
    np.testing.assert_allclose(step, [0, 4e-4, 0, -2e-4, 0], rtol=1e-12)
    np.testing.assert_allclose(plane_step((0.0, 0.0, 0.0), (-3.0, 1.5), 4e-4), [4e-4, -2e-4], rtol=1e-12)
    np.testing.assert_allclose(plane_step((0.0, 0.0, 0.0), (0.0, 1.5), 4e-4), [0.0, -4e-4], rtol=1e-12)


def test_a_step_is_too_long_where_it_lowers_the_energy_too_little() -> None:
    """From 7 J with a slope that promises 3 J less: at least the customary 1e-4 of that, less the rounding."""
    assert not is_too_long(7.0, 7.0 - 4e-4, -3.0, 0.0)
    assert is_too_long(7.0, 7.0 - 2e-4, -3.0, 0.0)
    assert not is_too_long(7.0, 7.0 - 2e-4, -3.0, 2e-4)
