"""The printed equations against the corrected ones: which names are exchanged, and what the torque loses."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import InputError
from analytic.oil.traction import PointLaw
from analytic.scene import Scene, SpinRule
from analytic.scenefile.read import load_scene
from analytic.sliding.as_printed import as_printed_moments
from analytic.sliding.long_ellipse import microslip_moments, microslip_torque
from analytic.torque import friction_torque
from tests.analytic.sliding.slips import BallSlip, ball_slip
from tests.analytic.specimens import rolling_contact

MU, Q, B, R = 0.083, 470.0, 1.27e-3, 4.05e-3
LAST = np.nextafter(0.5, 0)
SCENE = Path(__file__).parents[3] / "validation" / "scenes" / "6205_paper_as_printed.toml"


@pytest.fixture
def scene() -> Scene:
    return load_scene(SCENE)


def printed(eps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    return as_printed_moments(friction_force=MU * Q, semi_axis_transverse=B, ball_radius=R, spin_to_roll=eps)


def corrected(eps: ArrayLike) -> tuple[np.ndarray, np.ndarray]:
    return microslip_moments(friction_force=MU * Q, semi_axis_transverse=B, deformed_radius=R, spin_to_roll=eps)


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


FRICTION = 0.09, 0.07


def races(radius: float) -> tuple[ContactNumbers, ContactNumbers]:
    inner = rolling_contact(load=Q, semi_axis_transverse=1.02e-3, deformed_radius=radius, rolling_rate=2.9)
    return inner, inner._replace(semi_axis_transverse=0.85e-3, rolling_rate=1.9)


def printed_slip(spin_rule: SpinRule) -> BallSlip:
    laws = PointLaw(boundary=FRICTION[0]), PointLaw(boundary=FRICTION[1])
    given = {"ring_speed": 31.0, "spin_difference": 0.17, "spin_rule": spin_rule, "printed_radius": R}
    return ball_slip(races(R), laws, line=True, **given)  # pyright: ignore[reportArgumentType]


def test_where_both_contacts_spin_a_little_the_torque_is_the_derived_one() -> None:
    """With one radius for ball and contact surface, which is the only difference then; signs included."""
    forces = FRICTION[0] * Q, FRICTION[1] * Q
    derived = microslip_torque(races(R), friction_force=forces, spin_difference=0.17, spin_rule="balanced")
    found = printed_slip("balanced")
    close = 1e-11  # brackets near 1 cancel
    for race in ("inner", "outer"):
        slip = getattr(found, race)
        for name in ("spin_rate", "spin_moment", "rolling_moment"):
            np.testing.assert_allclose(getattr(slip, name), getattr(derived, f"{race}_{name}"), rtol=close)
    np.testing.assert_allclose([found.spin, found.conformity], [derived.spin, derived.conformity], rtol=close)


def test_with_a_race_in_control_the_other_one_alone_resists() -> None:
    """Equations 10 and 11 with 2 and 3 for the contact without spin; M_z and M_r of the other one as derived."""
    found = printed_slip("outer_control")
    spin, roll = microslip_moments(
        friction_force=FRICTION[0] * Q, semi_axis_transverse=1.02e-3, deformed_radius=R,
        spin_to_roll=0.17 / 2.9 * R / 1.02e-3,
    )  # fmt: skip
    np.testing.assert_allclose(found.spin, spin * 0.17, rtol=1e-12)  # round-off
    np.testing.assert_allclose(found.conformity, roll * 2.9, rtol=1e-12)
    np.testing.assert_allclose(abs(found.outer.spin_moment), 0.07 * 470.0 * 0.85e-3**2 / (4 * R), rtol=1e-14)
    assert found.outer.rolling_moment == 0


def test_only_the_printed_variant_is_warned_of(scene: Scene) -> None:
    assert any("as_printed" in text for text in friction_torque(scene).warnings)
    assert not any("as_printed" in text for text in friction_torque(replace(scene, microslip="derived")).warnings)
    with pytest.raises(InputError, match="microslip must be"):
        friction_torque(replace(scene, microslip="printed"))  # pyright: ignore[reportArgumentType]
