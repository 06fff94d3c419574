"""What a race of a scene resists, compiled: the law of traction of a ball on it, and the torque by its rolling."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from analytic.contact.geometry import RACES
from analytic.contact.hertz import contact_modulus
from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.numbers import play_and_free_angle
from analytic.numerics.compilation import compiled
from analytic.oil.ehl_fit import OilSupply, gap_force, gap_of_force
from analytic.oil.inlets import oil_supply
from analytic.oil.lubrication import Lubrication, lubricated_contact, lubrication_of
from analytic.oil.mixed import MixedContact
from analytic.oil.rolling import elastic_rolling, replenished
from analytic.oil.traction import PointLaw
from analytic.oil.variation import Variation
from analytic.oil.viscosity import OilNumbers
from analytic.scene import Array, Material, Scene
from analytic.surface.gap import SMOOTH_GAP, GapForm, GapNumbers, gap_forms, gap_law
from analytic.surface.roughness import gap_roughness

NO_OIL = OilNumbers(300.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, True, False, 0.0)
SMOOTH_FORM = gap_forms(SMOOTH_GAP)[0][0]
NO_SUPPLY = OilSupply(mean_diameter=1.0, degree=np.nan, rate=np.nan, ahead=1.0, behind=1.0, tension=0.0)
DRY = Lubrication(
    SMOOTH_FORM, 0.0, NO_SUPPLY, False, False, False, 1.0, 1.0, 1.0, 0.0, 1.0, 1.0, 1.0, False, False, False
)


class RaceResistance(NamedTuple):
    """What resists the balls on both races."""

    inner: Lubrication
    outer: Lubrication
    has_oil: bool
    rolls: bool  # the oil resists rolling
    coefficient: float  # of friction; NaN: by oil and surface
    elastic: bool  # elastic rolling loses energy
    by_houpert: bool  # by the law of slow rolling, else by hysteresis
    hysteresis_loss: float  # alpha'
    elastic_step: float  # of the way to the other law, see `rolling.elastic_rolling`
    unloaded: float  # factor on the rolling of balls without load


class ResistedContact(NamedTuple):
    """A ball on a race at its speed."""

    contact: ContactNumbers
    law: PointLaw
    mixed: MixedContact  # NaN without oil and surface
    rolling_torque: float  # hydrodynamic, about the bearing axis, N m
    hysteresis_torque: float  # likewise, by elastic rolling
    starvation_degree: float  # of the inlet
    film_extrapolated: bool  # as `LubricatedContact` has them
    rolling_extrapolated: bool


NOT_MIXED = MixedContact(np.nan, np.nan, np.nan, np.nan, False, False)


@compiled
def resisted_contact(
    resistance: RaceResistance,
    cubics: Array,
    oil: OilNumbers,
    race: int,
    contact: ContactNumbers,
    peak_pressure: float,
    ring_speed: float,
) -> ResistedContact:
    """A ball on its inner (0) or outer race (1).

    cubics : the splines of the gap laws
    oil : at its temperature;  peak_pressure : p0, Pa;  ring_speed : w, rad/s, of either sign
    """
    law, rolling, lost = PointLaw(resistance.coefficient, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0), 0.0, 0.0
    mixed, degree, thin, fast = NOT_MIXED, 1.0, False, False
    if resistance.has_oil:
        lubrication = resistance.inner if race == 0 else resistance.outer
        oiled = lubricated_contact(contact, peak_pressure, oil, lubrication, cubics, ring_speed)
        degree = oiled.inlet.starvation.degree
        if resistance.rolls:
            rolling, fast = oiled.rolling_torque, oiled.rolling_extrapolated
        if np.isnan(resistance.coefficient):
            law, mixed, thin = oiled.law, oiled.mixed, oiled.film_extrapolated
    if resistance.elastic:
        loss, step = resistance.hysteresis_loss, resistance.elastic_step
        lost = elastic_rolling(contact, loss, resistance.by_houpert, step) * contact.rolling_rate
    return ResistedContact(contact, law, mixed, rolling, lost, degree, thin, fast)


@compiled
def left_of_unloaded(resistance: RaceResistance, oil: OilNumbers, race: int, ring_speed: float) -> float:
    """Factor on the rolling of balls without load; the arguments are those of `torque_off_race`.

    They starve by the replenishment factor like the others. A degree of starvation is that of a contact with load.
    """
    lubrication = resistance.inner if race == 0 else resistance.outer
    supply = lubrication.supply
    if not lubrication.starves or supply.churned or np.isnan(supply.rate) or not np.isnan(supply.degree):
        return resistance.unloaded
    return resistance.unloaded * replenished(supply.rate, abs(ring_speed), oil.viscosity / oil.density)


@compiled
def torque_off_race(
    resistance: RaceResistance,
    oil: OilNumbers,
    race: int,
    contact: ContactNumbers,
    entrainment: float,
    gap: float,
    ring_speed: float,
) -> float:
    """Torque by the rolling of a ball that a gap keeps off its inner (0) or outer race (1), N m.

    contact : of the ball, without load;  entrainment : u over the ring speed, m;  gap : m;  the others as in
        `resisted_contact`
    """
    supply, radius = (resistance.inner if race == 0 else resistance.outer).supply, 1 / contact.curvature_rolling
    shear = oil.viscosity * abs(ring_speed) * entrainment
    force = gap_force(shear, radius, contact.curvature_transverse * radius, gap, supply.ahead)
    return left_of_unloaded(resistance, oil, race, ring_speed) * 2.0 * force * entrainment


@compiled
def gap_off_race(
    resistance: RaceResistance,
    oil: OilNumbers,
    race: int,
    contact: ContactNumbers,
    entrainment: float,
    torque: float,
    ring_speed: float,
) -> float:
    """The gap with the torque of `torque_off_race`, m; infinite without torque. The arguments are the same."""
    supply, radius = (resistance.inner if race == 0 else resistance.outer).supply, 1 / contact.curvature_rolling
    shear = oil.viscosity * abs(ring_speed) * entrainment
    left = left_of_unloaded(resistance, oil, race, ring_speed) * 2.0 * entrainment
    if torque == 0.0 or shear * left == 0.0:
        return np.inf
    force = torque / left
    return gap_of_force(shear, radius, contact.curvature_transverse * radius, force, supply.ahead)


def resistance_of(
    scene: Scene, forms: Sequence[GapForm], is_on: Callable[[str], bool], variation: Variation
) -> RaceResistance:
    """Of a scene; forms : the gap laws of inner and outer race;  is_on : whether an effect counts.

    variation : of the formulas. Raises InputError as these do.
    """
    given, inner, outer = scene.friction_coefficient, DRY, DRY
    if scene.lubricant is not None:
        rule = scene.contact_angle
        angle = rule.value or 0.0 if rule.rule == "given" else play_and_free_angle(scene.bearing, rule)[1] or 0.0
        inner, outer = (
            lubrication_of(
                form,
                oil_supply(scene.bearing, scene.lubricant, race, contact_angle=angle),
                scene.lubricant,
                boundary_friction=0.0 if scene.surface is None else scene.surface.boundary_friction,
                is_on=is_on,
                variation=variation,
            )
            for form, race in zip(forms, RACES, strict=True)
        )
    return RaceResistance(
        inner=inner,
        outer=outer,
        has_oil=scene.lubricant is not None,
        rolls=is_on("rolling"),
        coefficient=np.nan if given is None else float(given),
        elastic=is_on("hysteresis"),
        by_houpert=scene.elastic_rolling == "houpert",
        hysteresis_loss=float(scene.loss_factor),
        elastic_step=variation.elastic_rolling,
        unloaded=variation.unloaded_balls,
    )


def gap_law_of(scene: Scene, bodies: tuple[Material, Material]) -> GapNumbers:
    """The gap law of the scene's surfaces on two bodies; smooth too where its friction coefficient is given."""
    if scene.surface is None or scene.friction_coefficient is not None:
        return SMOOTH_GAP
    modulus = float(contact_modulus(*bodies))
    return gap_law(scene.surface, gap_roughness(scene.surface), modulus=modulus, bodies=bodies)
