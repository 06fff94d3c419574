"""Random balls between two races: scaled bearings, tight to open grooves, light to heavy loads, steel and ceramic."""

from dataclasses import replace

import numpy as np

from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, Groove, Material
from fembearing.creep.ball import TurningBall
from fembearing.creep.place import HeldBall, unit_under
from validation.benchmarks.random_scenes import BASE

CERAMIC, GIVEN, OILED, FAST = 0.25, 0.2, 0.2, 0.3  # shares of the balls
NITRIDE = Material(name="silicon nitride", youngs_modulus=310e9, poisson_ratio=0.26, density=3200.0, source="typical")


def random_ball(seed: int) -> TurningBall:
    """One ball; seed : of its numbers."""
    rng = np.random.default_rng(seed)
    bearing = _bearing(rng)
    angle, peak = rng.uniform(0.1, 0.8), 10 ** rng.uniform(8.7, 9.45)  # rad, Pa
    unit = unit_under(bearing, "inner", angle)
    load = (peak * np.pi * unit.semi_axis_rolling * unit.semi_axis_transverse / 1.5) ** 3
    radial = bearing.groove_centre_distance * np.cos(angle)
    thrust, centre = float(load * np.sin(angle)), bearing.outer.bottom_radius - bearing.outer.groove_radius
    if rng.random() < GIVEN:
        held = HeldBall(bearing=bearing, centre=centre, thrust=thrust, angle=angle)
    else:
        held = HeldBall(bearing=bearing, centre=centre, thrust=thrust, radial=float(radial))
    law = _law(rng)
    speed = 10 ** rng.uniform(0, 2) if rng.random() > FAST else 10 ** rng.uniform(2, 3)
    return TurningBall(held=held, laws=(law, law), speed=float(speed))


def _bearing(rng: np.random.Generator) -> Bearing:
    scale, like = 10 ** rng.uniform(-0.3, 0.6), BASE.bearing
    diameter = scale * like.ball_diameter
    ceramic = rng.random() < CERAMIC

    def groove(one: Groove) -> Groove:
        radius = float(rng.uniform(0.507, 0.55) * diameter)
        return replace(
            one,
            bottom_radius=scale * one.bottom_radius,
            groove_radius=radius,
            shoulder_half_width=None,
            far_shoulder_half_width=None,
        )

    material = NITRIDE if ceramic else like.ball_material
    mass = material.density * np.pi / 6 * diameter**3
    return replace(
        like,
        ball_diameter=diameter,
        ball_mass=float(mass),
        ball_material=material,
        inner=groove(like.inner),
        outer=groove(like.outer),
    )


def _law(rng: np.random.Generator) -> PointLaw:
    friction = float(10 ** rng.uniform(-2, -0.82))  # 0.01 to 0.15
    if rng.random() >= OILED:
        return PointLaw(boundary=friction)
    return PointLaw(
        boundary=0.3 * friction,
        limit=0.7 * friction,
        eyring=5e6,
        fluidity=float(10 ** rng.uniform(-3.5, -1.5)),  # s/m: 0.06 Pa s over 5 MPa and 40 nm is 0.3 s/m
        share=0.9,
        alpha=9.2 * 0.61 * 5.1e-9,
        exponent=0.61,
    )
