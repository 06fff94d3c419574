"""Random balls that slide between their races: wider than the scenes of `random_scenes`, to the limits of the model.

Bearings of a third to five times the size of a 6205, tight to open grooves, loads from 0.1 N, 0.01 to 20 000 rpm at its
size, contact angles from near pure rolling to 41 degrees, oils up to 1 Pa s, smooth and rough, given coefficients.
"""

from dataclasses import replace
from typing import Any, Literal

import numpy as np

from analytic.effects.table import COMPUTED
from analytic.scene import Autocorrelation, Bearing, ContactAngle, Groove, Lubricant, Operation, Scene, Surface
from validation.benchmarks.random_scenes import BASE, SHOULDER

COULOMB, SMOOTH, INERT = 0.07, 0.2, 0.3  # shares of a given coefficient, of smooth surfaces, of balls with inertia
RULES = ("balanced", "balanced", "inner_control", "outer_control")


def sliding_balls(rng: np.random.Generator, points: int) -> Scene:
    """One bearing at random loads and speeds, in which nothing but sliding costs torque; its effects are on or off."""
    scale = 10 ** rng.uniform(-0.5, 0.7)
    load = 10 ** rng.uniform(-1, 3.5, points) * scale**2
    speed = 10 ** rng.uniform(-2, 4.3, points) * np.pi / 30 / scale
    angle = 10 ** rng.uniform(-3, -0.15) if rng.random() < 0.5 else rng.uniform(0.05, 0.7)
    solved = ContactAngle(rule="solved", free=max(angle, 0.01))
    return replace(
        BASE,
        bearing=_scaled(rng, BASE.bearing, scale),
        contact_angle=ContactAngle(rule="given", value=angle) if rng.random() < 0.5 else solved,
        operation=Operation(axial_load=load, inner_speed=speed),
        spin_rule=str(rng.choice(RULES)),  # pyright: ignore[reportArgumentType]
        effects=sliding_alone(centrifugal="on" if rng.random() < INERT else "off"),
        **_friction(rng),
    )


def sliding_alone(centrifugal: Literal["on", "off"] = "off") -> dict[str, Any]:
    """Effects of a scene in which nothing but sliding costs torque."""
    on = dict.fromkeys(("spin", "conformity", "asperities"), "on")
    return {**dict.fromkeys(COMPUTED, "off"), **on, "centrifugal": centrifugal}


def _friction(rng: np.random.Generator) -> dict[str, Any]:
    if rng.random() < COULOMB:
        return {"lubricant": None, "surface": None, "friction_coefficient": 10 ** rng.uniform(-2.3, -0.9)}
    return {"lubricant": _oil(rng), "surface": _surface(rng)}


def _scaled(rng: np.random.Generator, bearing: Bearing, scale: float) -> Bearing:
    diameter = scale * bearing.ball_diameter

    def groove(like: Groove) -> Groove:
        radius = rng.uniform(0.505, 0.56) * diameter
        return replace(
            like, bottom_radius=scale * like.bottom_radius, groove_radius=radius, shoulder_half_width=scale * SHOULDER
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
        rms_roughness=10 ** rng.uniform(-8, -6) if rng.random() > SMOOTH else 0.0,
        autocorrelation=Autocorrelation(kind="gaussian", length=length, spacing=length / 20),
        hardness=7.8e9,
        boundary_friction=rng.uniform(0.05, 0.15),
    )
