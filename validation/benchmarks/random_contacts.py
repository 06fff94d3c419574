"""Random balls that slide between their races: wider than the scenes of `random_scenes`, to the limits of the model.

Bearings of a third to five times the size of a 6205, tight to open grooves, loads from 0.1 N, 0.01 to 20 000 rpm at its
size, contact angles from near pure rolling to 41 degrees, oils up to 1 Pa s, smooth and rough, given coefficients.
"""

from dataclasses import replace

import numpy as np

from analytic.errors import FembearingError
from analytic.loads.balls import LoadedBalls, LoadEffects, thrust_balls
from analytic.oil.lubricated_races import lubricate_races
from analytic.oil.traction import CoulombTraction
from analytic.oil.variation import Variation
from analytic.scene import Array, Autocorrelation, Bearing, ContactAngle, Groove, Lubricant, Operation, Surface
from analytic.sliding.ball import Tractions
from random_scenes import BASE, SHOULDER

COULOMB, SMOOTH, INERT = 0.07, 0.2, 0.3  # shares of a given coefficient, of smooth surfaces, of balls with inertia


def sliding_balls(rng: np.random.Generator, points: int) -> tuple[LoadedBalls, Tractions, Array, str]:
    """Balls of one bearing at random loads and speeds, what resists sliding, ring speeds in rad/s, name of the law."""
    scale = 10 ** rng.uniform(-0.5, 0.7)
    bearing = _scaled(rng, BASE.bearing, scale)
    load = 10 ** rng.uniform(-1, 3.5, points) * scale**2
    speed = 10 ** rng.uniform(-2, 4.3, points) * np.pi / 30 / scale
    angle = 10 ** rng.uniform(-3, -0.15) if rng.random() < 0.5 else rng.uniform(0.05, 0.7)
    rule = (
        ContactAngle(rule="given", value=angle)
        if rng.random() < 0.5
        else ContactAngle(rule="solved", free=max(angle, 0.01))
    )
    operation = Operation(axial_load=load, inner_speed=speed)
    still = LoadEffects(load_distribution=False, centrifugal=False, gyroscopic=False)
    try:
        balls = thrust_balls(bearing, rule, operation, replace(still, centrifugal=bool(rng.random() < INERT)))
    except FembearingError:  # too fast for the load
        balls = thrust_balls(bearing, rule, operation, still)
    if rng.random() < COULOMB:
        law = CoulombTraction(friction_coefficient=10 ** rng.uniform(-2.3, -0.9))
        return balls, (law, law), speed, "coulomb"
    oil, surface = _oil(rng), _surface(rng)
    races = lubricate_races(bearing, balls, lubricant=oil, surface=surface, ring_speed=speed, variation=Variation())
    mixed = races.mixed(asperities=bool(rng.random() > SMOOTH), film_factor=10 ** rng.uniform(-1, 0))
    return balls, (races.traction(mixed.race(0)), races.traction(mixed.race(1))), speed, oil.traction


def _scaled(rng: np.random.Generator, bearing: Bearing, scale: float) -> Bearing:
    diameter = scale * bearing.ball_diameter

    def groove(like: Groove) -> Groove:
        radius = rng.uniform(0.505, 0.56) * diameter
        return replace(
            like,
            bottom_radius=scale * like.bottom_radius,
            groove_radius=radius,
            shoulder_half_width=scale * SHOULDER,
        )

    return replace(bearing, ball_diameter=diameter, inner=groove(bearing.inner), outer=groove(bearing.outer))


def _oil(rng: np.random.Generator) -> Lubricant:
    assert BASE.lubricant is not None
    return replace(
        BASE.lubricant,
        viscosity=10 ** rng.uniform(-2.5, 0),
        pressure_viscosity=rng.uniform(1e-8, 3e-8),
        eyring_stress=10 ** rng.uniform(6, 7.2),
        limiting_shear=rng.uniform(0.03, 0.1),
        traction="eyring_sinh" if rng.random() < 0.7 else "eyring_constant",
    )


def _surface(rng: np.random.Generator) -> Surface:
    length = 10 ** rng.uniform(-4.7, -3.7)
    return Surface(
        rms_roughness=10 ** rng.uniform(-8, -6),
        autocorrelation=Autocorrelation(kind="gaussian", length=length, spacing=length / 20),
        hardness=7.8e9,
        boundary_friction=rng.uniform(0.05, 0.15),
    )
