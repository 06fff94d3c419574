"""Influence of rectangles against integrals of point forces, and what adds up."""

import numpy as np
import pytest
from scipy.integrate import dblquad

from analytic.errors import InputError
from fembearing.creep.half_space import HalfSpaces
from fembearing.creep.strips import Strips
from tests.contacts import STEEL
from tests.creep.bodies import HYBRID, of_modulus

ONE = Strips(
    middle=np.array([0.3e-4]), width=np.array([5e-4]), rear=np.array([-0.7e-4]), front=np.array([1.1e-4]), cells=1
)
POINTS = np.array([[2.1e-4, 3.7e-4], [-3.3e-4, 0.9e-4], [1.6e-4, -7e-4]])  # outside, where a point force is smooth


def integrated(point, kernel) -> float:
    """Over the rectangle; kernel : of the distance x, y."""
    (left, right), half = ONE.edges[0], ONE.width[0] / 2

    def at(x: float, y: float) -> float:
        return kernel(point[0] - x, point[1] - y)

    low, high = ONE.middle[0] - half, ONE.middle[0] + half
    return dblquad(at, low, high, left, right, epsrel=1e-9)[0]


def shear_modulus(material) -> float:
    return material.youngs_modulus / 2 / (1 + material.poisson_ratio)


def test_tractions_move_the_surface_as_point_forces_do() -> None:
    """Cerruti: u_x = [(1 - nu)/r + nu x^2/r^3]/(2 pi G), u_y = nu x y/r^3/(2 pi G) [Johnson1985]."""
    found = HYBRID.by_traction(ONE, POINTS[:, 0], POINTS[:, 1])[..., 0]
    bodies = [(body.poisson_ratio, 2 * np.pi * shear_modulus(body)) for body in (HYBRID.ball, HYBRID.race)]
    for number, point in enumerate(POINTS):

        def along(x: float, y: float) -> float:
            r = np.hypot(x, y)
            return sum(((1 - nu) / r + nu * x * x / r**3) / g for nu, g in bodies)

        def mixed(x: float, y: float) -> float:
            return sum(nu * x * y / np.hypot(x, y) ** 3 / g for nu, g in bodies)

        expected = [
            [integrated(point, along), integrated(point, mixed)],
            [integrated(point, mixed), integrated(point, lambda x, y: along(y, x))],
        ]
        np.testing.assert_allclose(found[:, :, number], expected, rtol=1e-8)  # of the quadrature


def test_pressure_moves_unlike_surfaces_along_each_other() -> None:
    """Boussinesq: u_r = -(1 - 2 nu)/(4 pi G r), towards the force, on each body."""
    found = HYBRID.by_pressure(ONE, np.array([[1.7e9]]), POINTS[:, 0], POINTS[:, 1])
    ball, race = ((1 - 2 * b.poisson_ratio) / 4 / np.pi / shear_modulus(b) for b in (HYBRID.ball, HYBRID.race))
    for number, point in enumerate(POINTS):
        pull = [
            integrated(point, lambda x, y: x / (x * x + y * y)),
            integrated(point, lambda x, y: y / (x * x + y * y)),
        ]
        np.testing.assert_allclose(found[:, number], -1.7e9 * (ball - race) * np.array(pull), rtol=1e-7)  # quadrature
    like = HalfSpaces(ball=STEEL, race=STEEL).by_pressure(ONE, np.array([[1.7e9]]), POINTS[:, 0], POINTS[:, 1])
    np.testing.assert_array_equal(like, 0.0)


def test_an_impossible_material_is_refused() -> None:
    with pytest.raises(InputError, match=r"poisson_ratio of test must lie in \(-1, 0.5\], got 0.6"):
        HalfSpaces(ball=of_modulus(0.6, 1e9), race=STEEL).by_traction(ONE, POINTS[:, 0], POINTS[:, 1])
