"""What a race of a scene resists, compiled: the law of traction of a ball on it, and the torque by its rolling."""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from analytic.contact.hertz import contact_modulus, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.oil.inlets import OilSupply, oil_supply
from analytic.oil.lubrication import Lubrication, lubricated_contact, lubrication_of
from analytic.oil.rolling import hysteresis
from analytic.oil.traction import PointLaw
from analytic.oil.variation import Variation
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Material, Scene
from analytic.surface.gap import GapNumbers, gap_law, gap_numbers
from analytic.surface.roughness import gap_roughness

NO_OIL = OilNumbers(300.0, 1.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 1.0, 0.0, True, False)
DRY = Lubrication(gap_numbers(None), 0.0, OilSupply(1.0, np.nan, np.nan), False, False, False, 1.0, 1.0, 1.0, False)


class RaceResistance(NamedTuple):
    """What resists the balls on both races."""

    inner: Lubrication
    outer: Lubrication
    has_oil: bool
    rolls: bool  # the oil resists rolling
    coefficient: float  # of friction; NaN: by oil and surface
    hysteresis_loss: float  # alpha'; 0: none counts


class ResistedContact(NamedTuple):
    """A ball on a race at its speed."""

    contact: ContactNumbers
    law: PointLaw
    rolling_torque: float  # hydrodynamic, about the bearing axis, N m
    hysteresis_torque: float  # likewise


@compiled
def resisted_contact(
    resistance: RaceResistance,
    oil: OilNumbers,
    race: int,
    contact: ContactNumbers,
    peak_pressure: float,
    ring_speed: float,
) -> ResistedContact:
    """A ball on its inner (0) or outer race (1).

    oil : at its temperature;  peak_pressure : p0, Pa;  ring_speed : w, rad/s, of either sign
    """
    law, rolling = PointLaw(resistance.coefficient, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0
    if resistance.has_oil:
        alone = unit_hertz(contact.curvature_rolling, contact.curvature_transverse, contact.modulus)
        lubrication = resistance.inner if race == 0 else resistance.outer
        oiled = lubricated_contact(contact, alone, peak_pressure, oil, lubrication, ring_speed)
        rolling = oiled.rolling_torque if resistance.rolls else 0.0
        if np.isnan(resistance.coefficient):
            law = oiled.law
    lost = hysteresis(contact, resistance.hysteresis_loss) * contact.rolling_rate
    return ResistedContact(contact, law, rolling, lost)


def resistance_of(scene: Scene, is_on: Callable[[str], bool], variation: Variation) -> RaceResistance:
    """Of a scene; is_on : whether an effect counts;  variation : of the formulas. Raises InputError as these do."""
    given = scene.friction_coefficient
    inner, outer = (
        _lubrication(scene, groove.material, is_on, variation) for groove in (scene.bearing.inner, scene.bearing.outer)
    )
    return RaceResistance(
        inner=inner,
        outer=outer,
        has_oil=scene.lubricant is not None,
        rolls=is_on("rolling"),
        coefficient=np.nan if given is None else float(given),
        hysteresis_loss=float(scene.hysteresis_loss or 0.0) * is_on("hysteresis"),
    )


def _lubrication(scene: Scene, race: Material, is_on: Callable[[str], bool], variation: Variation) -> Lubrication:
    """Of the balls on a race of this material."""
    if scene.lubricant is None:
        return DRY
    return lubrication_of(
        gap_numbers_of(scene, (scene.bearing.ball_material, race)),
        oil_supply(scene.bearing, scene.lubricant),
        boundary_friction=0.0 if scene.surface is None else scene.surface.boundary_friction,
        asperities=is_on("asperities"),
        heats=is_on("inlet_heating"),
        starves=is_on("starvation"),
        variation=variation,
    )


def gap_numbers_of(scene: Scene, bodies: tuple[Material, Material]) -> GapNumbers:
    """The gap law of the scene's surfaces on two bodies; smooth where its friction coefficient is given."""
    if scene.surface is None or scene.friction_coefficient is not None:
        return gap_numbers(None)
    modulus = float(contact_modulus(*bodies))
    return gap_numbers(gap_law(scene.surface, gap_roughness(scene.surface), modulus=modulus, bodies=bodies))
