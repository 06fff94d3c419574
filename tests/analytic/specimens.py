"""Specimens of the tests: the bearing 6205 with its cage, an oil, a finish, contacts, operating points and scenes."""

from dataclasses import replace
from typing import Any, TypeVar

import numpy as np

from analytic.contact.geometry import RACES
from analytic.contact.hertz import HertzContact, loaded_contact
from analytic.contact.rolling_contact import ContactNumbers, elliptic_contact
from analytic.effects import Effect
from analytic.loads.kinematics import ruled_motion
from analytic.loads.numbers import bearing_numbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.thrust import thrust_equilibrium
from analytic.numerics.records import Records
from analytic.result import FrictionTorque, TorqueParts
from analytic.scene import (
    Autocorrelation,
    Bearing,
    Cage,
    ContactAngle,
    Decision,
    Groove,
    Lubricant,
    Material,
    Operation,
    Scene,
    Surface,
)
from analytic.torque import loaded_balls_of
from tests.contacts import STEEL

# Table 1 of the paper, typed in a second time, so that an error in the catalog shows.
BEARING_6205 = Bearing(
    name="6205",
    ball_count=9,
    ball_diameter=7.94e-3,
    ball_mass=2.04e-3,
    ball_material=STEEL,
    inner=Groove(bottom_radius=15.53e-3, groove_radius=4.13e-3, shoulder_half_width=3.1e-3, material=STEEL),
    outer=Groove(bottom_radius=23.48e-3, groove_radius=4.21e-3, shoulder_half_width=3.1e-3, material=STEEL),
    bore_diameter=25e-3,
    outside_diameter=52e-3,
)
STAMPED_CAGE = Cage(  # with 0.2 mm of pocket clearance
    pocket_diameter=8.14e-3, pocket_depth=4.07e-3, wall_thickness=0.9e-3, mass=6.58e-3, material=STEEL
)
OIL = Lubricant(
    viscosity=0.043,
    pressure_viscosity=1.9e-8,
    viscosity_temperature=0.04,
    reference_temperature=313.15,
    temperature=313.15,
    thermal_conductivity=0.13,
    density=865.0,
    eyring_stress=4.7e6,
    limiting_shear=0.06,
    traction="eyring_sinh",
)
FINISH = Surface(
    rms_roughness=0.21e-6,
    autocorrelation=Autocorrelation(kind="gaussian", length=43e-6, spacing=2e-6),
    hardness=7.3e9,
    boundary_friction=0.11,
)
Value = TypeVar("Value")
DRY_PARTS = ("spin", "conformity", "hysteresis")  # of the torque without oil
# The closed forms of textbooks at any tolerance
AS_HERTZ: dict[str, Decision] = {"finite_geometry": "off", "spin": "on"}


def made(
    *,
    ball: float,
    pitch: float,
    count: int,
    grooves: tuple[float, float],
    clearance: float,
    shoulder: float | None = 0.4,
    material: Material = STEEL,
) -> Bearing:
    """A bearing from its ball and pitch diameter, m; radii of the grooves and shoulders over the ball's diameter."""
    inner, outer = (
        Groove(
            bottom_radius=pitch / 2 + side * (ball / 2 + clearance / 4),
            groove_radius=groove * ball,
            shoulder_half_width=None if shoulder is None else shoulder * ball,
            material=material,
        )
        for side, groove in zip((-1, 1), grooves, strict=True)
    )
    return Bearing(
        name="made",
        ball_count=count,
        ball_diameter=ball,
        ball_mass=material.density * np.pi / 6 * ball**3,
        ball_material=material,
        inner=inner,
        outer=outer,
    )


def rolling_contact(**changed: Any) -> ContactNumbers:
    """A ball that rolls on a race like the inner one of a 6205, with some fields changed."""
    values = {
        "load": 613.0,
        "semi_axis_rolling": 0.12e-3,
        "semi_axis_transverse": 1.1e-3,
        "curvature_rolling": 310.0,
        "curvature_transverse": 14.7,
        "modulus": 1.13e11,
        "deformed_radius": 4.05e-3,
        "rolling_rate": 2.45,
    }
    return ContactNumbers(**(values | changed))


def hertzian(values: dict[str, Any]) -> tuple[ContactNumbers, dict[str, Any]]:
    """The contact that some of the values describe, and the others; Hertz gives semi-axes that are not among them."""
    names = ContactNumbers._fields
    given = {name: value for name, value in values.items() if name in names}
    axes = {name: given.pop(name) for name in ("semi_axis_rolling", "semi_axis_transverse") if name in given}
    rest = {name: value for name, value in values.items() if name not in names}
    return elliptic_contact(**given)._replace(**axes), rest


def loaded_contacts(balls: Records) -> tuple[HertzContact, HertzContact]:
    """Of both races under the loads of the balls, (...) of `analytic.loads.state.BALL_STATE`."""
    units = (balls["inner_unit"], balls["outer_unit"])
    each = (HertzContact(**{name: unit[name] for name in HertzContact._fields}) for unit in units)
    inner, outer = (loaded_contact(unit, load=balls["load"][..., side]) for side, unit in enumerate(each))
    return inner, outer


def contacts_under_thrust(bearing: Bearing, angle: ContactAngle, axial: float) -> tuple[ContactNumbers, ContactNumbers]:
    """Of a ball on inner and outer race at rest; rates per unit ring speed."""
    numbers, ball = bearing_numbers(bearing), thrust_equilibrium(bearing, angle, axial_load=axial)
    motion = ruled_motion(numbers, 1.0, *ball["angle"].tolist())
    rates = motion.inner_rolling_rate, motion.outer_rolling_rate
    speeds = motion.inner_entrainment, motion.outer_entrainment
    inner, outer = (
        contact_under(race, ball[f"{name}_unit"][()], *(float(ball[of][side]) for of in ("angle", "load")), *rolls)
        for side, (name, race, *rolls) in enumerate(
            zip(RACES, (numbers.inner, numbers.outer), rates, speeds, strict=True)
        )
    )
    return inner, outer


def balls_of(scene: Scene, **effects: Decision) -> Records:
    """(n, m) `analytic.solve.records.BALL` by Hertz and without weight but by these effects."""
    plain: dict[str, Decision] = {"finite_geometry": "off", "weight": "off", **effects}
    return loaded_balls_of(replace(scene, effects={**scene.effects, **plain}))


def with_clearance(bearing: Bearing, clearance: float, *, ball_count: int = 9) -> Bearing:
    """The bearing with its outer ring opened to this diametral clearance, m; negative is preload."""
    touching = bearing.inner.bottom_radius + bearing.ball_diameter
    outer = replace(bearing.outer, bottom_radius=touching + clearance / 2)
    return replace(bearing, outer=outer, ball_count=ball_count)


def thrust(*loads: float, speed: float | list[float] = 31.0) -> Operation:
    """Axial loads, N, and one speed for each or for all, rad/s."""
    load, speeds = np.broadcast_arrays(np.array(loads), np.array(speed, dtype=float))
    return Operation(axial_load=load, inner_speed=speeds)


def without(scene: Scene, *names: str) -> Scene:
    """The scene with these effects off."""
    return replace(scene, effects={**scene.effects, **dict.fromkeys(names, "off")})


def dry(bearing: Bearing) -> Scene:
    """1000 N, a given contact angle of 0.18 rad, mu = 0.1, alpha' = 0.007."""
    return Scene(
        bearing=bearing,
        contact_angle=ContactAngle(rule="given", value=0.18),
        operation=thrust(1000.0),
        friction_coefficient=0.1,
        hysteresis_loss=0.007,
        effects=AS_HERTZ,
    )


def present(value: Value | None) -> Value:
    """The value, which must not be None."""
    assert value is not None
    return value


def part(torque: TorqueParts, name: str) -> np.ndarray:
    return present(getattr(torque, name))


def effect_of(result: FrictionTorque, name: str) -> Effect:
    return next(effect for effect in result.effects if effect.name == name)
