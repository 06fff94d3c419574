"""The displacement of a half space against the equations of elasticity and against a fine sum."""

from collections.abc import Callable

import numpy as np
import pytest

from analytic.scene import Array, Material
from fembearing.fem.farfield import loaded_surface, point_load, pressed_ellipse, tangential_point_load

ALLOY = Material(name="alloy", youngs_modulus=71.0, poisson_ratio=0.34, density=2.7, source="test")
LAM = ALLOY.youngs_modulus * ALLOY.poisson_ratio / ((1 + ALLOY.poisson_ratio) * (1 - 2 * ALLOY.poisson_ratio))
MU = ALLOY.youngs_modulus / (2 * (1 + ALLOY.poisson_ratio))
STEP = 1e-3  # of central differences of order 4 at distances of about 1: their error is 1e-12, round-off 1e-10 twice

Field = Callable[[Array], Array]


def displacement(place: Array) -> Array:
    return point_load(*place, material=ALLOY)


def sideways(place: Array) -> Array:
    return tangential_point_load(*place, material=ALLOY)


POINT_LOADS = pytest.mark.parametrize("load", [displacement, sideways])


def derivative(field: Field, axis: int) -> Field:
    def along(place: Array) -> Array:
        step = np.zeros_like(place)
        step[axis] = STEP
        one, two = (field(place + n * step) - field(place - n * step) for n in (1, 2))
        return (8 * one - two) / (12 * STEP)

    return along


def stress(load: Field, place: Array) -> Array:
    """(3, 3, ...)"""
    gradient = np.array([derivative(load, axis)(place) for axis in range(3)])  # [j, i]: d_j u_i
    trace = np.einsum("ii...->...", gradient)
    return np.einsum("ij,...->ij...", np.eye(3), LAM * trace) + MU * (gradient + np.swapaxes(gradient, 0, 1))


@pytest.fixture(scope="module")
def inside() -> Array:
    place = np.random.default_rng(11).uniform(-1.4, 1.4, (3, 40))
    place[2] = np.abs(place[2]) + 0.3
    return place


@POINT_LOADS
def test_a_point_load_satisfies_naviers_equations(inside: Array, load: Field) -> None:
    """(lambda + mu) grad div u + mu laplace u = 0 inside; a wrong term or nu leaves a residual of its own size."""
    second = np.array([[derivative(derivative(load, i), j)(inside) for j in range(3)] for i in range(3)])
    grad_div = (LAM + MU) * np.einsum("ijj...->i...", second)
    laplace = MU * np.einsum("jji...->i...", second)
    size = np.abs(laplace).max()
    assert np.abs(grad_div).max() > 0.5 * size  # the terms cancel; they are not small
    assert np.abs(grad_div + laplace).max() < 1e-7 * size  # round-off of two differences at the nearest points


@POINT_LOADS
def test_a_point_load_leaves_the_surface_free(load: Field) -> None:
    place = np.random.default_rng(12).uniform(0.5, 1.5, (3, 25))
    place[2] = 0.0
    traction = stress(load, place)[2]
    assert np.abs(stress(load, place)[:2, :2]).max() > 1e-2  # the surface is stressed, but not loaded
    assert np.abs(traction).max() < 1e-10  # round-off of one difference


@pytest.mark.parametrize(("load", "force"), [(displacement, (0, 0, 1)), (sideways, (1, 0, 0))])
def test_a_point_load_carries_one_newton(load: Field, force: tuple[int, ...]) -> None:
    """Traction over a hemisphere about the load, pushing back; its other parts vanish."""
    points, weights = np.polynomial.legendre.leggauss(24)
    cosine, weights = (points + 1) / 2, weights / 2
    turn = (np.arange(16) + 0.5) * 2 * np.pi / 16
    sine = np.sqrt(1 - cosine**2)[:, None]
    normal = np.array([sine * np.cos(turn), sine * np.sin(turn), np.broadcast_to(cosine[:, None], (24, 16))])
    radius = 1.3
    traction = np.einsum("ij...,j...->i...", stress(load, radius * normal), normal)
    found = np.einsum("ipt,p->i", traction, weights) * (2 * np.pi / 16) * radius**2
    np.testing.assert_allclose(found, -np.array(force), atol=1e-9)  # round-off of the differences


def test_both_point_loads_do_the_same_work_on_each_other() -> None:
    """Betti on the surface, with a force along y as well: from each place the other one lies in the opposite way."""
    places = np.array([[0.31, -0.42], [-0.17, 0.93], [0.0, 0.0]])  # of two loads, the columns
    pushed = np.array([[[0.8, 0.0], [0.0, -0.3]], [[-0.5, 0.0], [0.0, 1.4]], [[0.9, 0.0], [0.0, 0.6]]])
    first, second = (
        loaded_surface(places[:, [1 - n]], places[:2, [n]], pushed[:, [n]], material=ALLOY)[:, 0, n] for n in (0, 1)
    )
    there, here = first @ pushed[:, 1, 1], second @ pushed[:, 0, 0]
    np.testing.assert_allclose(there, here, rtol=1e-14)  # round-off
    tangential = first[:2] @ pushed[:2, 1, 1]
    assert abs(tangential - there) > 0.01 * abs(there)  # normal forces take part


def test_a_load_across_is_the_one_along_turned() -> None:
    place = np.array([[0.6], [-0.35], [0.8]])
    force = np.array([0.0, 1.0, 0.0])[:, None, None]
    found = loaded_surface(place, np.zeros((2, 1)), force, material=ALLOY)[:, 0, 0]
    turned = sideways(np.array([place[1], -place[0], place[2]]))[:, 0]  # x' = y, y' = -x
    np.testing.assert_allclose(found, [-turned[1], turned[0], turned[2]], rtol=1e-14)  # round-off


SEMI_AXES = 0.11, 0.94


def by_brute_force(place: Array) -> Array:
    """The pressure 3/(2 pi a b) sqrt(1 - x^2/a^2 - y^2/b^2) summed over 60 by 120 points, evenly by angle."""
    points, weights = np.polynomial.legendre.leggauss(60)
    polar, weights = np.pi / 4 * (points + 1), np.pi / 4 * weights  # rho = sin(polar) takes the root off the edge
    turn = (np.arange(120) + 0.5) * 2 * np.pi / 120
    total = np.zeros_like(place)
    for angle, weight in zip(polar, weights, strict=True):
        share = 3 / (2 * np.pi) * np.cos(angle) ** 2 * np.sin(angle) * weight * 2 * np.pi / 120
        around = np.sin(angle) * np.array([SEMI_AXES[0] * np.cos(turn), SEMI_AXES[1] * np.sin(turn), np.zeros(120)])
        total += share * displacement(place[:, :, None] - around[:, None, :]).sum(axis=-1)
    return total


@pytest.mark.parametrize(("extent", "tolerance"), [(2.5, 2e-6), (6.0, 2e-9)])
def test_a_pressed_ellipse_is_right_on_the_far_boundary(extent: float, tolerance: float) -> None:
    """Blocks end 2.5 or 6 major semi-axes away; 32 points carry the moments of the pressure up to the sixth.

    The error falls as extent^-8: 8e-7 of the largest displacement at 2.5, a thousandth of that at 6.
    """
    place = np.random.default_rng(13).uniform(0.0, 1.0, (3, 60))
    place[np.arange(60) % 3, np.arange(60)] = 1.0  # on the three far faces of a box
    place = np.column_stack([place, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]) * extent * SEMI_AXES[1]
    found = pressed_ellipse(*place, semi_axes=SEMI_AXES, material=ALLOY)
    expected = by_brute_force(place)
    np.testing.assert_allclose(found, expected, atol=tolerance * np.abs(expected).max())
    point = point_load(*place, material=ALLOY)
    assert np.abs(point - expected).max() > 1e4 * np.abs(found - expected).max()  # the spread matters
    swapped = pressed_ellipse(*place, semi_axes=(SEMI_AXES[1], SEMI_AXES[0]), material=ALLOY)
    assert np.abs(swapped - expected).max() > 1e4 * np.abs(found - expected).max()
