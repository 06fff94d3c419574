"""The torque of a bearing at one operating point, compiled: every step by the formula of its own folder.

`analytic.torque.friction_torque` does the same for series, step by step, and decides which effects count. Here that is
settled. Whatever does not settle, or has no closed form, gives a status in place of a torque.
"""

from typing import NamedTuple

import numpy as np

from analytic.cage.steady import braking_torque, hanging_torque
from analytic.contact.factors import CorrectionNumbers, FactorNumbers
from analytic.contact.finite_geometry_fit import factors_on
from analytic.contact.geometry import distances_to_shoulders
from analytic.contact.hertz import HertzNumbers, loaded_hertz, unit_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.effects.loads import MOST_CENTRIFUGAL
from analytic.effects.table import PRESSED
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.numbers import BearingNumbers
from analytic.loads.race_contacts import contact_under
from analytic.loads.ring_rounds import BY_LOAD, BY_POINT, SETTLED, RingLoad, settle_ruled_ring
from analytic.loads.shares import STRIBECK
from analytic.loads.thrust_ball import thrust_point
from analytic.loads.turning import TurningRule
from analytic.numerics.compilation import compiled
from analytic.oil.asymptotes import Inflow, asymptotes_of
from analytic.oil.lubrication import lubricated_contact
from analytic.oil.mixed import mixed_of, oil_beside
from analytic.oil.traction import PointLaw, law_of_oil, stress_and_slope
from analytic.oil.viscosity import OilNumbers, oil_at
from analytic.point.numbers import ALONG_AXIS, SINGLE_COEFFICIENT, CageNumbers, PointModel, Slipping, Workspace
from analytic.scene import STANDARD_GRAVITY, Array
from analytic.sliding.ball import slips_over_contacts
from analytic.sliding.long_ellipse import Slip, line_slips

LEAST_GRAVITY = 1e-3 * STANDARD_GRAVITY  # m/s^2, of a cage without gravity: a film needs a load


class PointTorque(NamedTuple):
    """Torques about the bearing axis, N m, magnitudes; NaN: this point has no closed form, or does not settle."""

    total: float
    spin: float
    conformity: float
    hysteresis: float
    rolling: float
    cage: float


class CageDriveNumbers(NamedTuple):
    """How the balls drive a cage: means over balls and races."""

    orbit_rate: float  # w_c/w
    ball_rate: float  # w_b/w
    contact_angle: float  # al, rad
    lead: float  # A of the balls, m


NO_SLIP = Slip(np.nan, np.nan, np.nan, np.nan, np.nan, np.nan)
NO_TORQUE = PointTorque(np.nan, np.nan, np.nan, np.nan, np.nan, np.nan)


class Load(NamedTuple):
    """An operating point."""

    axial: float  # Fa, N
    radial: float  # Fr along x, N
    moment: float  # M about y, N m
    speed: float  # w of the inner ring, rad/s, of either sign


class Ball(NamedTuple):
    """One ball of a bearing."""

    number: int  # from 0
    side: float  # 1, or -1 where it is pressed the other way
    motion: BallMotion  # per unit ring speed


class OnRace(NamedTuple):
    """A ball on one race."""

    contact: ContactNumbers
    law: PointLaw
    rolling_torque: float  # hydrodynamic, N m


@compiled
def point_torque(model: PointModel, load: Load, oil: OilNumbers, work: Workspace) -> PointTorque:
    """The torque at one operating point; oil : at its temperature."""
    point, counted, bearing = work.point, model.counted, model.bearing
    if not load.axial >= 0.0 or _may_skid(model, load):
        return NO_TORQUE
    work.factors[:, :3] = 1.0
    work.factors[:, 3] = np.nan
    balls = _load_balls(model, load, work, BY_LOAD)
    if balls > 0 and counted.finite_geometry:
        for race in range(2):
            numbers = bearing.inner if race == 0 else bearing.outer
            for j in range(balls):
                angle = abs(point.angle[race, j]) if point.load[race, j] > 0.0 else 0.0
                factors = factors_on(model.fit, numbers, angle, point.load[race, j])
                for k in range(4):
                    work.factors[race, k, j] = factors[k]
        balls = _load_balls(model, load, work, BY_POINT)
    if balls == 0:
        return NO_TORQUE
    alike = bearing.ball_count if balls == 1 else 1.0
    spin = conformity = hysteresis = rolling = 0.0
    orbit = own = angles = lead = time = 0.0
    for j in range(balls):
        if counted.cage and load.speed != 0.0 and max(point.load[0, j], point.load[1, j]) == 0.0:
            return NO_TORQUE  # nothing turns this ball, and it cannot drive the cage
        inner, outer = point.angle[0, j], point.angle[1, j]
        motion = ruled_motion(bearing, 1.0, inner, outer)
        side = -1.0 if inner + outer < 0.0 else 1.0
        ball = Ball(j, side, motion)
        on_inner = _race(model, oil, load.speed, 0, work, ball)
        on_outer = _race(model, oil, load.speed, 1, work, ball)
        for each in (on_inner, on_outer):
            hysteresis += (
                3
                / 16
                * model.hysteresis_loss
                * each.contact.load
                * each.contact.semi_axis_rolling
                * (each.contact.rolling_rate)
            )
            rolling += each.rolling_torque
        if counted.spin or counted.conformity:
            difference = abs(motion.spin_difference) if counted.spin else 0.0
            inner_slip, outer_slip = _slips(model.slipping, on_inner, on_outer, abs(load.speed), difference)
            spin += inner_slip.spin_moment * inner_slip.spin_rate + outer_slip.spin_moment * outer_slip.spin_rate
            conformity += inner_slip.rolling_moment * motion.inner_rolling_rate
            conformity += outer_slip.rolling_moment * motion.outer_rolling_rate
        azimuth = 2 * np.pi * j / balls
        orbit, own = orbit + motion.cage_speed / balls, own + motion.ball_speed / balls
        angles += side * (inner + outer) / (2 * balls)
        lead, time = lead + np.cos(azimuth) / motion.cage_speed, time + 1 / motion.cage_speed
    lead = bearing.pitch_diameter * lead / time if balls > 1 else 0.0  # 2 r_m times the first harmonic, see `ball_lead`
    cage = 0.0
    if counted.cage:
        cage = _cage_torque(model.cage, oil, bearing, CageDriveNumbers(orbit, own, abs(angles), lead), load.speed)
    spin, conformity = alike * spin * counted.spin, alike * conformity * counted.conformity
    hysteresis, rolling = alike * hysteresis, alike * rolling
    total = spin + conformity + hysteresis + rolling + cage + model.declared
    return PointTorque(total, spin, conformity, hysteresis, rolling, cage)


@compiled
def _may_skid(model: PointModel, load: Load) -> bool:
    """Whether the balls may be pressed too little for their speed, which `friction_torque` then has to judge.

    By estimates from above of the centrifugal force of a ball, which passes at half the ring's speed at most, and from
    below of the load of the heaviest ball, see `analytic.loads.shares`.
    """
    bearing, washers = model.bearing, model.bearing.inner.bottom_angle > 0.0
    if not (model.counted.centrifugal or washers):
        return False
    most = 1 / PRESSED if washers else MOST_CENTRIFUGAL
    thrown = bearing.ball_mass * bearing.pitch_diameter / 2 * (load.speed / 2) ** 2
    pressing = load.axial + STRIBECK * (abs(load.radial) + abs(load.moment) / bearing.pitch_diameter)
    return not thrown * bearing.ball_count <= most * pressing


@compiled
def _load_balls(model: PointModel, load: Load, work: Workspace, start: int) -> int:
    """Load the balls with the factors in `work`, and write loads, angles and contacts; the number of balls that differ.

    0 where they do not settle, or one leaves its groove;  start : of `settle_ruled_ring`
    """
    point, counted, bearing = work.point, model.counted, model.bearing
    rule = TurningRule(load.speed, counted.centrifugal, counted.gyroscopic)
    unequal = load.radial != 0.0 or load.moment != 0.0
    if unequal and not counted.load_distribution:
        return 0
    if unequal or counted.weight:
        work.force[:] = 0.0
        work.force[0], work.force[1], work.force[4] = load.axial, load.radial, load.moment / model.arm
        end = settle_ruled_ring(model.ring, RingLoad(work.force, rule, work.factors), point, work.ring, start)
        return point.load.shape[1] if end.end == SETTLED else 0
    if not load.axial > 0.0:
        return 0
    found = thrust_point(bearing, load.axial, rule, _factors_of_ball(work.factors, 0))
    if found.change != 0.0:  # NaN too
        return 0
    point.load[0, 0], point.load[1, 0] = found.ball.inner_load, found.ball.outer_load
    point.angle[0, 0], point.angle[1, 0] = found.ball.inner_angle, found.ball.outer_angle
    for k in range(5):
        point.unit[0, k, 0], point.unit[1, k, 0] = found.inner[k], found.outer[k]
    return 1


@compiled
def _factors_of_ball(factors: Array, ball: int) -> CorrectionNumbers:
    return CorrectionNumbers(
        FactorNumbers(factors[0, 0, ball], factors[0, 1, ball], factors[0, 2, ball], factors[0, 3, ball]),
        FactorNumbers(factors[1, 0, ball], factors[1, 1, ball], factors[1, 2, ball], factors[1, 3, ball]),
    )


@compiled
def _race(model: PointModel, oil: OilNumbers, ring_speed: float, race: int, work: Workspace, ball: Ball) -> OnRace:
    """A loaded ball on its inner (0) or outer race (1)."""
    numbers, j, motion = model.bearing.inner if race == 0 else model.bearing.outer, ball.number, ball.motion
    load, fields, angle = work.point.load[race, j], work.point.unit[race], ball.side * work.point.angle[race, j]
    near, far = distances_to_shoulders(numbers, (numbers.near_shoulder, numbers.far_shoulder), abs(angle))
    if load > 0.0 and min(near, far) <= 0.0:
        load = np.nan  # the contact is off its race
    unit = HertzNumbers(fields[0, j], fields[1, j], fields[2, j], fields[3, j], fields[4, j])
    rate = motion.inner_rolling_rate if race == 0 else motion.outer_rolling_rate
    entrainment = motion.inner_entrainment if race == 0 else motion.outer_entrainment
    contact = contact_under(numbers, unit, abs(angle), load, rate, entrainment)
    law = PointLaw(model.slipping.coefficient, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    rolled = 0.0
    if model.counted.oil:
        alone = unit_hertz(contact.curvature_rolling, numbers.curvature_transverse, numbers.modulus)
        lubrication, peak = model.inner if race == 0 else model.outer, unit.peak_pressure * np.cbrt(load)
        oiled = lubricated_contact(contact, alone, peak, oil, lubrication, ring_speed)
        rolled = oiled.rolling_torque if model.counted.rolling else 0.0
        if np.isnan(model.slipping.coefficient):
            law = oiled.law
    return OnRace(contact, law, rolled)


@compiled
def _slips(
    slipping: Slipping, inner: OnRace, outer: OnRace, ring_speed: float, spin_difference: float
) -> tuple[Slip, Slip]:
    contacts, laws = (inner.contact, outer.contact), (inner.law, outer.law)
    if slipping.method == SINGLE_COEFFICIENT:
        return line_slips(contacts, laws, ring_speed, spin_difference, slipping.rule)
    sideways = slipping.method != ALONG_AXIS
    first, second, count = slips_over_contacts(
        contacts, laws, ring_speed, spin_difference, slipping.rule, slipping.quadrature, sideways
    )
    if count == 0:
        return NO_SLIP, NO_SLIP
    return first, second


@compiled
def _cage_torque(
    cage: CageNumbers, oil: OilNumbers, bearing: BearingNumbers, drive: CageDriveNumbers, ring_speed: float
) -> float:
    """Of a cage at rest on its balls; NaN where balls that lead squeeze it."""
    if abs(drive.lead) >= cage.room:
        return np.nan
    orbit_speed, ball_speed = drive.orbit_rate * abs(ring_speed), drive.ball_rate * abs(ring_speed)
    coefficient = cage.coefficient
    if np.isnan(coefficient):
        load = cage.mass * max(cage.gravity, LEAST_GRAVITY) / bearing.ball_count
        coefficient = _pocket_coefficient(cage, oil, load, ball_speed * bearing.ball_radius)
    weight, surface_rate = cage.mass * cage.gravity, drive.ball_rate * bearing.ball_radius
    if cage.lies_along:  # the cage lies on its balls where their surfaces are slowest
        torque = coefficient * weight * surface_rate * np.sin(drive.contact_angle)
    else:
        torque = hanging_torque(coefficient, weight, surface_rate, drive.contact_angle)
    surface_speed = ball_speed * bearing.ball_radius
    return torque + braking_torque(
        cage.drag, coefficient, drive.orbit_rate, orbit_speed, surface_speed, bearing.pitch_diameter / 2
    )


@compiled
def _pocket_coefficient(cage: CageNumbers, oil: OilNumbers, load: float, surface_speed: float) -> float:
    """Friction of a ball on its pocket by oil and surface, see `analytic.cage.pocket_friction`; load : N."""
    hertz = loaded_hertz(unit_hertz(cage.curvature, cage.curvature, cage.modulus), load)
    a = hertz.semi_axis_x
    contact = ContactNumbers(load, a, a, cage.curvature, cage.curvature, cage.modulus, np.nan, np.nan, np.nan)
    film = asymptotes_of(
        contact, Inflow(surface_speed / 2, oil.viscosity, oil.pressure_viscosity, oil.compressible, cage.largest_gap)
    )
    mixed = mixed_of(contact, film, cage.gap, 1.0, 1.0)
    area, thickness = oil_beside(mixed.area_fraction, mixed.film_thickness, mixed.without_film)
    law = law_of_oil(oil, cage.boundary_friction * mixed.boundary_share, 1.0 - mixed.asperity_share, area, thickness)
    pressure = load / (np.pi * a * a)
    return stress_and_slope(law, pressure, surface_speed)[0] / pressure


@compiled
def torques_of_points(model: PointModel, points: Array, work: Workspace, torques: Array) -> None:
    """Write (6, n) torques of `PointTorque`; points : (5, n) of `Load`, and the temperature of the oil, K."""
    for i in range(points.shape[1]):
        load, oil = Load(points[0, i], points[1, i], points[2, i], points[3, i]), model.oil
        if model.counted.oil:
            oil = oil_at(oil, points[4, i])
        torque = point_torque(model, load, oil, work)
        for k in range(6):
            torques[k, i] = torque[k]
