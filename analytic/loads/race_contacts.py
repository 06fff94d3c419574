"""The contacts of balls with both races: by Hertz under 1 N, and one ball's under its loads."""

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.factors import ContactCorrection, FactorNumbers, corrected, factor_fields
from analytic.contact.geometry import RaceNumbers, race_numbers, require_contact_angle, rolling_curvature
from analytic.contact.hertz import HertzContact, HertzNumbers, hertz_fields, loaded_hertz, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.loads.kinematics import BallMotion
from analytic.loads.numbers import BearingNumbers
from analytic.numerics.compilation import compiled, rows_of
from analytic.numerics.records import Record, record_of
from analytic.scene import Array, Bearing


@compiled
def unit_contact_on(race: RaceNumbers, contact_angle: float, factors: FactorNumbers) -> HertzNumbers:
    """A ball on a race under 1 N by Hertz, corrected; NaN where the ellipse does not settle.

    contact_angle : al, rad, in [-pi/2, pi/2]
    """
    curvature = rolling_curvature(race, contact_angle)
    return corrected(unit_hertz(curvature, race.curvature_transverse, race.modulus), factors)


@compiled
def put_unit(unit: Record, contact: HertzNumbers) -> None:
    """Write a contact under 1 N into a ball's state."""
    unit.semi_axis_x, unit.semi_axis_y = contact.semi_axis_x, contact.semi_axis_y
    unit.peak_pressure, unit.approach, unit.stiffness = contact.peak_pressure, contact.approach, contact.stiffness


@compiled
def contact_under(
    race: RaceNumbers,
    unit: HertzNumbers,
    contact_angle: float,
    load: float,
    rolling_rate: float,
    entrainment: float,
) -> ContactNumbers:
    """A ball on a race as film, rolling and sliding see it.

    unit : the contact under 1 N;  contact_angle : al, rad, in [-pi/2, pi/2];  load : Q, N
    rolling_rate, entrainment : w_roll, rad/s, and u, m/s, per unit ring speed
    """
    hertz = loaded_hertz(unit, load)
    return ContactNumbers(
        load,
        hertz.semi_axis_x,
        hertz.semi_axis_y,
        rolling_curvature(race, contact_angle),
        race.curvature_transverse,
        race.modulus,
        race.deformed_radius,
        rolling_rate,
        entrainment,
    )


@compiled
def contacts_of_ball(
    bearing: BearingNumbers,
    angles: tuple[float, float],
    loads: tuple[float, float],
    units: tuple[HertzNumbers, HertzNumbers],
    motion: BallMotion,
) -> tuple[ContactNumbers, ContactNumbers]:
    """A ball on its inner and on its outer race.

    angles : al_i, al_o, rad;  loads : Q_i, Q_o, N;  units : the contacts under 1 N;  motion : per unit ring speed
    """
    inner = contact_under(
        bearing.inner, units[0], angles[0], loads[0], motion.inner_rolling_rate, motion.inner_entrainment
    )
    outer = contact_under(
        bearing.outer, units[1], angles[1], loads[1], motion.outer_rolling_rate, motion.outer_entrainment
    )
    return inner, outer


def unit_contacts(
    bearing: Bearing, *, inner_angle: ArrayLike, outer_angle: ArrayLike, correction: ContactCorrection
) -> tuple[HertzContact, HertzContact]:
    """A ball on its inner and on its outer race under 1 N by Hertz, corrected; of the angles' shape, which is one.

    inner_angle, outer_angle : al_i, al_o, rad, in [0, pi/2]
    analytic.contact.hertz.loaded_contact gives the contacts under load. Raises InputError as race_curvatures does.
    """
    races = record_of(race_numbers(bearing, "inner")), record_of(race_numbers(bearing, "outer"))
    angles = require_contact_angle(inner_angle), require_contact_angle(outer_angle)
    inner, outer = (
        _on_race(race, *rows_of(angle, *factor_fields(factors)))
        for race, angle, factors in zip(races, angles, (correction.inner, correction.outer), strict=True)
    )
    return inner, outer


def _on_race(race: RaceNumbers, rows: Array, shape: tuple[int, ...]) -> HertzContact:
    return hertz_fields(_unit_contacts(race, rows), shape)


@compiled
def _unit_contacts(race: RaceNumbers, rows: Array) -> Array:
    fields = np.empty((5, rows.shape[1]))
    for i in range(rows.shape[1]):
        factors = FactorNumbers(rows[1, i], rows[2, i], rows[3, i], rows[4, i])
        unit = unit_contact_on(race, rows[0, i], factors)
        for k in range(5):
            fields[k, i] = unit[k]
    return fields
