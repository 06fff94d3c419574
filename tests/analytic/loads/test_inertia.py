"""Inertia of a ball against what defines it: its orbit, and its angular momentum."""

import numpy as np
from scipy.integrate import quad

from analytic.loads.inertia import moment_of_turned_axis, outward_force


def test_the_centrifugal_force_is_that_of_a_circle() -> None:
    """Mass times the second difference of a point on its orbit."""
    step, speed, orbit = 1e-4, 37.0, 19.5e-3
    places = orbit * np.exp(1j * speed * step * np.array([-1, 0, 1]))
    force = 2.04e-3 * abs(places[0] - 2 * places[1] + places[2]) / step**2
    np.testing.assert_allclose(
        outward_force(2.04e-3, 2 * orbit, speed), force, rtol=1e-5
    )  # (w dt)^2/12 of the second difference


def test_the_gyroscopic_moment_is_the_change_of_angular_momentum() -> None:
    """An angular momentum at the angle al to the axis, carried round by the cage; J by discs of a solid sphere."""
    spin, orbit, angle, step = 123.0, 21.0, 0.37, 1e-5
    radius, mass = 3.97e-3, 2.04e-3
    discs, _ = quad(lambda z: np.pi / 2 * (radius**2 - z**2) ** 2, -radius, radius, epsabs=0)  # discs across the axis
    inertia = mass / (4 / 3 * np.pi * radius**3) * discs
    turned = np.exp(1j * orbit * step * np.array([-0.5, 0.5])) * inertia * spin * np.sin(angle)  # the part across
    moment = abs(turned[1] - turned[0]) / step
    found = moment_of_turned_axis(mass, 2 * radius, spin, orbit, angle)
    np.testing.assert_allclose(found, moment, rtol=1e-8)  # round-off of the difference
