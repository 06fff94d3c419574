"""The contacts of balls with both races: by Hertz under 1 N, and one ball's under its loads."""

from analytic.contact.factors import ContactFactors, corrected
from analytic.contact.geometry import RaceNumbers, rolling_curvature
from analytic.contact.hertz import HertzContact, loaded_hertz, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record


@compiled
def unit_contact_on(race: RaceNumbers, contact_angle: float, factors: ContactFactors) -> HertzContact:
    """A ball on a race under 1 N by Hertz, corrected; NaN where the ellipse does not settle.

    contact_angle : al, rad, in [-pi/2, pi/2]
    """
    curvature = rolling_curvature(race, contact_angle)
    return corrected(unit_hertz(curvature, race.curvature_transverse, race.modulus), factors)


@compiled
def put_unit(unit: Record, contact: HertzContact) -> None:
    """Write a contact under 1 N into a ball's state."""
    unit.semi_axis_x, unit.semi_axis_y = contact.semi_axis_x, contact.semi_axis_y
    unit.peak_pressure, unit.approach, unit.stiffness = contact.peak_pressure, contact.approach, contact.stiffness


@compiled
def contact_under(
    race: RaceNumbers,
    unit: HertzContact,
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
