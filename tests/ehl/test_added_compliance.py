"""Bodies that yield more than half spaces: the added displacement in SI, and additions that are another shape."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact
from fembearing.ehl.shape import Paraboloid
from fembearing.ehl.solver import Discretised, Solution, solve_on_grids
from tests.ehl.contacts import moes

Places = tuple[Array, Array]


@dataclass(frozen=True, kw_only=True)
class Addition:
    """scale (constant + bend (x^2 + x'^2) + tilt y y' + twist x x' y^2 y'^2), m/N."""

    scale: float
    constant: float = 0.0
    bend: float = 0.0
    tilt: float = 0.0
    twist: float = 0.0

    def normal_influence(self, place: Places, loaded: Places) -> Array:
        (x, y), (at_x, at_y) = place, loaded
        bent = np.add.outer(x**2, at_x**2)
        twisted = np.multiply.outer(x * y**2, at_x * at_y**2)
        tilted = np.multiply.outer(y, at_y)
        return self.scale * (self.constant + self.bend * bent + self.tilt * tilted + self.twist * twisted)


def test_both_halves_of_the_pressure_move_each_cell() -> None:
    contact = moes(31.0, 6.0, 0.4)
    addition = Addition(scale=2.3e-10, constant=1.7, bend=4e6, tilt=9e6, twist=5e20)
    plain, added = (Discretised(contact=each, refinement=0.3) for each in (contact, replace(contact, added=addition)))
    grid, (a, _) = plain.grid, contact.semi_axes
    x, y = (a * part.ravel() for part in np.meshgrid(grid.x, grid.y, indexing="ij"))
    pressure = np.exp(-(((x - 0.3 * a) / a) ** 2) - (y / a) ** 2)
    moved = (added.elastic - plain.elastic) @ pressure * a**2 / contact.shape.radii[0]
    force = pressure * contact.peak_pressure * a**2 * grid.areas.ravel()
    whole = np.concatenate([x, x]), np.concatenate([y, -y])
    expected = addition.normal_influence((x, y), whole) @ np.concatenate([force, force])
    np.testing.assert_allclose(moved, expected, rtol=1e-9, atol=1e-9 * np.abs(expected).max())  # of a difference


def solved(contact: LubricatedContact) -> Solution:
    return next(solve_on_grids(contact, 0.9))


@pytest.mark.parametrize("share", [0.2, -0.3])
def test_an_addition_that_bends_both_surfaces_is_another_radius(share: float) -> None:
    """c (x^2 + x'^2) moves surfaces under the load Q by c Q x^2 and an approach: a curvature of 2 c Q."""
    contact = moes(12.0, 5.0, 0.3, ahead=4.0)
    rolling, across = contact.shape.radii
    curved = replace(contact, shape=Paraboloid(rolling_radius=rolling / (1 + share), transverse_radius=across))
    bent = replace(contact, added=Addition(scale=share / (2 * rolling * contact.load), bend=1.0))
    direct, by_addition, without = solved(curved), solved(bent), solved(contact)
    assert abs(direct.central_film / without.central_film - 1) > 0.03  # above what the grids leave
    assert abs(direct.pressure_centre / without.pressure_centre - 1) > 0.08
    # Each has a grid for the ellipse of its own radius, with an error of 1 to 2 %.
    assert by_addition.central_film == pytest.approx(direct.central_film, rel=0.02)
    assert by_addition.pressure_centre == pytest.approx(direct.pressure_centre, rel=0.03)
