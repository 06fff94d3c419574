"""Half spaces in contact: against the surface displacement under the pressure, and against the production model."""

import numpy as np
import pytest

from analytic.contact.hertz import hertz_contact
from fembearing.fem.half_space import approach_under, curvatures_under, hertz_ellipse

LOAD, MODULUS = 630.0, 1.13e11  # N, Pa


def sunk(x: float, y: float, semi_axes: tuple[float, float]) -> float:
    """Displacement of both surfaces at a point within the ellipse, m: point loads p dA/(pi E* distance), summed.

    In polar coordinates about the point the distance cancels. Along each ray p is sqrt(c0 + c1 s - c2 s^2), an arc of a
    circle, so that Gauss points of that weight integrate it exactly from end to end.
    """
    a, b = semi_axes
    peak = 1.5 * LOAD / (np.pi * a * b)
    angle = (np.arange(4000) + 0.5) * np.pi / 4000  # whole chords through the point
    dx, dy = np.cos(angle) / a, np.sin(angle) / b
    square, slope, rest = dx**2 + dy**2, dx * x / a + dy * y / b, 1 - (x / a) ** 2 - (y / b) ** 2
    chord = np.sqrt(slope**2 + square * rest) / square  # half its length
    arc = np.pi / 2 * chord * np.sqrt(square) * chord  # of sqrt(square) sqrt(chord^2 - t^2) over the chord
    return peak / (np.pi * MODULUS) * float(arc.mean()) * np.pi


@pytest.mark.parametrize("semi_axes", [(0.13e-3, 0.77e-3), (0.52e-3, 0.52e-3), (0.8e-3, 0.35e-3)])
def test_the_pressure_closes_the_gap(semi_axes: tuple[float, float]) -> None:
    """Everywhere in the ellipse the surfaces sink by the approach less the gap."""
    curvature_x, curvature_y = curvatures_under(semi_axes, load=LOAD, modulus=MODULUS)
    approach = approach_under(semi_axes, load=LOAD, modulus=MODULUS)
    for share_x, share_y in ((0.0, 0.0), (0.7, 0.0), (0.0, 0.6), (0.3, -0.8)):
        x, y = share_x * semi_axes[0], share_y * semi_axes[1]
        closed = approach - (curvature_x * x**2 + curvature_y * y**2) / 2
        # A periodic sum of 4000 smooth values: round-off
        np.testing.assert_allclose(sunk(x, y, semi_axes), closed, rtol=1e-12)


@pytest.mark.parametrize("ratio", [1e-6, 0.03, 1 - 1e-9, 1.0, 1 + 1e-9, 3.7, 1e6])
def test_the_ellipse_is_hertzs(ratio: float) -> None:
    curvature = 57.0  # 1/m
    exact = hertz_contact(curvature_x=ratio * curvature, curvature_y=curvature, load=LOAD, modulus=MODULUS)
    found = hertz_ellipse((ratio * curvature, curvature), load=LOAD, modulus=MODULUS)
    np.testing.assert_allclose(found, (float(exact.semi_axis_x), float(exact.semi_axis_y)), rtol=1e-13)  # round-off
    np.testing.assert_allclose(curvatures_under(found, load=LOAD, modulus=MODULUS), (ratio * curvature, curvature))
    approach = approach_under(found, load=LOAD, modulus=MODULUS)
    np.testing.assert_allclose(approach, exact.approach, rtol=1e-13)
