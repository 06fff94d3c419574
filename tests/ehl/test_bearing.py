"""Contacts of a 6205 against a numerical solution by another code."""

from dataclasses import dataclass

import numpy as np
import pytest

from analytic.contact.rolling_contact import elliptic_contact
from analytic.oil.film import central_film
from analytic.scene import Array
from fembearing.ehl.contact import LubricatedContact, Reach
from fembearing.ehl.film import NumericalFilm, numerical_film
from fembearing.ehl.oil import Oil
from fembearing.ehl.shape import BallOnRace

BALL, MODULUS = 3.97e-3, 113.187e9  # radius, m; E*, Pa
RACES = {"inner": (15.8553e-3, 4.13e-3), "outer": (-23.7953e-3, 4.21e-3)}  # radii along and across, m
SPEED = 9.36143e-3 * np.pi / 30  # entrainment, m/s, per rpm of the inner ring


@dataclass(frozen=True, kw_only=True)
class CircleAlong(BallOnRace):
    """What the other code took: the ball's circle along rolling, and parabolas for the race and across."""

    def gap(self, x: Array, y: Array) -> Array:
        ball = self.ball_radius - np.sqrt(self.ball_radius**2 - x**2)
        return ball + x**2 / (2 * self.race_radius) + y**2 / (2 * self.radii[1])

    def slope(self, x: Array, y: Array) -> Array:
        return x / np.sqrt(self.ball_radius**2 - x**2) + x / self.race_radius + 0 * y


def solved(race: str, load: float, speed: float, viscosity: float) -> NumericalFilm:
    along, across = RACES[race]
    contact = LubricatedContact(
        load=load,
        modulus=MODULUS,
        shape=CircleAlong(ball_radius=BALL, race_radius=along, groove_radius=across),
        speed=SPEED * speed,
        oil=Oil(viscosity=viscosity, pressure_viscosity=2e-8),
        reach=Reach(ahead=0.9 * BALL, behind=0.9 * BALL, side=2.8e-3),
    )
    return numerical_film(contact)


@pytest.mark.parametrize(
    ("race", "load", "speed", "viscosity", "force", "uncertainty", "film"),
    [
        pytest.param("inner", 30.0, 500.0, 0.0125, 10.8e-3, 0.012, 0.89, marks=pytest.mark.nightly),
        pytest.param("inner", 372.0, 3000.0, 0.0125, 78.2e-3, 0.007, 0.81, marks=pytest.mark.nightly),
        pytest.param("outer", 372.0, 500.0, 0.059, 60.5e-3, 0.007, 0.81, marks=pytest.mark.nightly),
        pytest.param("inner", 1000.0, 500.0, 0.059, 84.5e-3, 0.018, 0.79, marks=pytest.mark.nightly),
    ],
)
def test_film_and_force_are_those_of_another_code(
    race: str, load: float, speed: float, viscosity: float, force: float, uncertainty: float, film: float
) -> None:
    """Within 2 % or both uncertainties; the film is given as its ratio to the formula without compression, +-0.005."""
    found = solved(race, load, speed, viscosity)
    allowed = max(0.02, found.rolling_force.total + uncertainty)
    assert found.rolling_force.value == pytest.approx(force, rel=allowed)
    rolling, across = found.contact.shape.radii
    formula = central_film(
        elliptic_contact(curvature_rolling=1 / rolling, curvature_transverse=1 / across, load=load, modulus=MODULUS),
        entrainment_speed=found.contact.speed,
        viscosity=viscosity,
        pressure_viscosity=2e-8,
    )
    assert found.central_film.value / float(formula.thickness) == pytest.approx(film, rel=0.02)
