"""The printed equations beside the corrected ones: which moment has whose name, and by how much both jump."""

import numpy as np
import pytest
from numpy.typing import ArrayLike

from analytic.as_printed import as_printed_moments
from analytic.errors import InputError
from analytic.race import microslip_moments

MU, Q, B, R = 0.083, 470.0, 1.27e-3, 4.05e-3
LAST = np.nextafter(0.5, 0)


def printed(eps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    return as_printed_moments(friction_coefficient=MU, load=Q, semi_axis_transverse=B, ball_radius=R, spin_to_roll=eps)


def corrected(eps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    return microslip_moments(
        friction_coefficient=MU, load=Q, semi_axis_transverse=B, deformed_radius=R, spin_to_roll=eps
    )


def test_between_the_ends_the_paper_is_right() -> None:
    eps = np.linspace(1e-3, LAST, 57)
    # atol: round-off of a difference of two brackets near 1, which the corrected form has in factors
    for found, expected, scale in zip(printed(eps), corrected(eps), (MU * Q * B, MU * Q * B**2 / R), strict=True):
        np.testing.assert_allclose(found, expected, rtol=1e-12, atol=1e-15 * scale)


def test_at_no_spin_the_moments_are_exchanged_and_the_rolling_one_is_three_times_too_large() -> None:
    spin, rolling = corrected(0.0)
    printed_z, printed_r = printed(0.0)
    assert printed_r == spin == 0
    # The bracket that equation 2 lacks, from the root of 3 g - g^3 = 1 alone: 2/5 - 2 g^3 (1 - 3 g^2/5).
    g = max(root.real for root in np.roots([-1.0, 0.0, 3.0, -1.0]) if abs(root) < 1)
    missing = 2 / 5 - 2 * g**3 * (1 - 3 * g**2 / 5)
    np.testing.assert_allclose(missing, 0.322285, atol=0.5e-6)  # six digits of an independent calculation
    np.testing.assert_allclose(printed_z / rolling, 1 / missing, rtol=1e-12)  # round-off; 3.10
    np.testing.assert_allclose(printed_z / rolling, 3.10, atol=0.005)


def test_both_moments_jump_at_no_spin() -> None:
    """M_z falls from the whole mu F b^2/(4 r) to nothing, M_r rises from nothing to 0.322 of it."""
    at, after = printed(0.0), printed(1e-9)
    whole = MU * Q * B**2 / (4 * R)
    np.testing.assert_allclose(np.divide(at, whole), [1.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(np.divide(after, whole), [0.0, 0.322285], atol=1e-6)  # eps b/R of spin is left
    smooth = np.subtract(corrected(1e-9), corrected(0.0))
    assert np.all(np.abs(smooth) < 1e-6 * whole)


def test_both_moments_jump_at_full_spin() -> None:
    before, at = printed(LAST), printed(0.5)
    np.testing.assert_allclose(np.divide(before, MU * Q * B), [0.375, 0.0], atol=1e-15)
    np.testing.assert_array_equal(at, np.multiply([0.0, 0.375], MU * Q * B))
    np.testing.assert_allclose(at[::-1], corrected(0.5), rtol=1e-14)  # exchanged, round-off
    np.testing.assert_array_equal(printed(7.0), at)


def test_arguments_broadcast_and_nonsense_is_refused() -> None:
    moments = as_printed_moments(
        friction_coefficient=[[0.03], [0.11]], load=Q, semi_axis_transverse=B, ball_radius=R,
        spin_to_roll=[0.0, 0.2, 0.5],
    )  # fmt: skip
    for moment in moments:
        assert moment.shape == (2, 3)
        np.testing.assert_allclose(moment[1] * 3, moment[0] * 11, rtol=1e-14)  # round-off
    with pytest.raises(InputError, match="spin_to_roll must be at least 0"):
        printed(-0.1)
    with pytest.raises(InputError, match="ball_radius must be positive"):
        as_printed_moments(friction_coefficient=MU, load=Q, semi_axis_transverse=B, ball_radius=0.0, spin_to_roll=0.1)
