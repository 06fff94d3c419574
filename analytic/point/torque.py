"""The torque of a bearing at one operating point, compiled: every step by the formula of its own folder.

`analytic.torque.friction_torque` does the same for series, step by step, and decides which effects count. Here that is
settled. Whatever does not settle, or has no closed form, gives a status in place of a torque.
"""

from typing import NamedTuple

import numpy as np

from analytic.cage.pocket import pocket_coefficient
from analytic.cage.steady import DrivingBalls, resting_load, resting_torque
from analytic.contact.finite_geometry_fit import factors_on
from analytic.contact.geometry import distances_to_shoulders
from analytic.contact.hertz import HertzNumbers
from analytic.effects.loads import MOST_CENTRIFUGAL
from analytic.effects.table import PRESSED
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.race_contacts import contact_under
from analytic.loads.ring_balance import RingPoint
from analytic.loads.ring_rounds import BY_LOAD, BY_POINT, SETTLED, RingLoad
from analytic.loads.ruled_point import load_by_rule
from analytic.loads.shares import STRIBECK
from analytic.loads.turning import TurningRule
from analytic.numerics.compilation import compiled
from analytic.oil.race_resistance import ResistedContact, resisted_contact
from analytic.oil.viscosity import OilNumbers, oil_at
from analytic.point.numbers import ALONG_AXIS, SINGLE_COEFFICIENT, PointModel, Slipping, Workspace
from analytic.scene import Array
from analytic.sliding.ball import slips_over_contacts
from analytic.sliding.long_ellipse import Slip, line_slips


class PointTorque(NamedTuple):
    """Torques about the bearing axis, N m, magnitudes; NaN: this point has no closed form, or does not settle."""

    total: float
    spin: float
    conformity: float
    hysteresis: float
    rolling: float
    cage: float


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
    motion: BallMotion  # per unit ring speed


class Losses(NamedTuple):
    """What a point's balls lose besides sliding, N m about the bearing axis, and how they drive a cage; sums so far."""

    hysteresis: float
    rolling: float
    orbit: float  # w_c/w
    own: float  # w_b/w
    angles: float  # al, rad
    lead: float  # first harmonic of the slowness of the balls round their orbit
    slowness: float


NO_LOSS = Losses(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def point_torque(model: PointModel, load: Load, oil: OilNumbers, work: Workspace) -> PointTorque:
    """The torque at one operating point whose balls turn by rule; oil : at its temperature."""
    point, counted = work.point, model.counted
    balls = load_balls(model, load, work)
    if balls == 0:
        return NO_TORQUE
    losses, spin, conformity = NO_LOSS, 0.0, 0.0
    for j in range(balls):
        motion = ruled_motion(model.ring.bearing, 1.0, point.angle[0, j], point.angle[1, j])
        on_inner = race_of_ball(model, oil, load.speed, 0, point, Ball(j, motion))
        on_outer = race_of_ball(model, oil, load.speed, 1, point, Ball(j, motion))
        losses = with_ball(losses, on_inner, on_outer, point, j, motion)
        if counted.spin or counted.conformity:
            difference = abs(motion.spin_difference) if counted.spin else 0.0
            inner_slip, outer_slip = _slips(model.slipping, on_inner, on_outer, abs(load.speed), difference)
            spin += inner_slip.spin_moment * inner_slip.spin_rate + outer_slip.spin_moment * outer_slip.spin_rate
            conformity += inner_slip.rolling_moment * motion.inner_rolling_rate
            conformity += outer_slip.rolling_moment * motion.outer_rolling_rate
    alike = model.ring.bearing.ball_count / balls
    return whole_torque(model, oil, load, losses, (alike * spin, alike * conformity), balls)


@compiled
def with_ball(
    losses: Losses, inner: ResistedContact, outer: ResistedContact, point: RingPoint, j: int, motion: BallMotion
) -> Losses:
    """The sums with ball j; NaN where the cage turns with balls that nothing turns."""
    azimuth = 2 * np.pi * j / len(point.own)
    drives = max(point.load[0, j], point.load[1, j]) > 0.0
    turned = point.angle[0, j] + point.angle[1, j]
    return Losses(
        losses.hysteresis + inner.hysteresis_torque + outer.hysteresis_torque,
        losses.rolling + inner.rolling_torque + outer.rolling_torque,
        losses.orbit + motion.cage_speed if drives else np.nan,
        losses.own + motion.ball_speed,
        losses.angles + abs(turned) / 2,
        losses.lead + np.cos(azimuth) / motion.cage_speed,
        losses.slowness + 1 / motion.cage_speed,
    )


@compiled
def whole_torque(
    model: PointModel, oil: OilNumbers, load: Load, losses: Losses, slid: tuple[float, float], balls: int
) -> PointTorque:
    """The torque with that of the cage; slid : by spin and by conformity, N m, of all balls;  balls : in the sums."""
    bearing, counted = model.ring.bearing, model.counted
    alike = bearing.ball_count / balls
    cage = 0.0
    if counted.cage:
        # 2 r_m times the first harmonic, see `ball_lead`
        lead = bearing.pitch_diameter * losses.lead / losses.slowness if balls > 1 else 0.0
        drive = DrivingBalls(losses.orbit / balls, losses.own / balls, losses.angles / balls)
        if load.speed != 0.0 and np.isnan(drive.orbit_rate):
            return NO_TORQUE  # nothing turns a ball, and it cannot drive the cage
        cage = _cage_torque(model, oil, drive, lead, load.speed)
    spin, conformity = slid[0] * counted.spin, slid[1] * counted.conformity
    hysteresis, rolling = alike * losses.hysteresis, alike * losses.rolling
    total = spin + conformity + hysteresis + rolling + cage + model.declared
    return PointTorque(total, spin, conformity, hysteresis, rolling, cage)


@compiled
def _may_skid(model: PointModel, load: Load) -> bool:
    """Whether the balls may be pressed too little for their speed, which `friction_torque` then has to judge.

    By estimates from above of the centrifugal force of a ball, which passes at half the ring's speed at most, and from
    below of the load of the heaviest ball, see `analytic.loads.shares`.
    """
    bearing, washers = model.ring.bearing, model.ring.bearing.inner.bottom_angle > 0.0
    if not (model.counted.centrifugal or washers):
        return False
    most = 1 / PRESSED if washers else MOST_CENTRIFUGAL
    thrown = bearing.ball_mass * bearing.pitch_diameter / 2 * (load.speed / 2) ** 2
    pressing = load.axial + STRIBECK * (abs(load.radial) + abs(load.moment) / bearing.pitch_diameter)
    return not thrown * bearing.ball_count <= most * pressing


@compiled
def load_balls(model: PointModel, load: Load, work: Workspace) -> int:
    """Load the balls by rule, with their finite geometry; the number of balls that differ, 0 where they do not settle.

    Also 0 for a thrust the wrong way and balls that may skid. Writes loads, angles, contacts and the factors on these.
    """
    point, bearing = work.point, model.ring.bearing
    if not load.axial >= 0.0 or _may_skid(model, load):
        return 0
    work.factors[:, :3] = 1.0
    work.factors[:, 3] = np.nan
    balls = _load_balls(model, load, work, BY_LOAD)
    if balls == 0 or not model.counted.finite_geometry:
        return balls
    for race in range(2):
        numbers = bearing.inner if race == 0 else bearing.outer
        for j in range(balls):
            angle = abs(point.angle[race, j]) if point.load[race, j] > 0.0 else 0.0
            factors = factors_on(model.fit, numbers, angle, point.load[race, j])
            for k in range(4):
                work.factors[race, k, j] = factors[k]
    return _load_balls(model, load, work, BY_POINT)


@compiled
def _load_balls(model: PointModel, load: Load, work: Workspace, start: int) -> int:
    """`load_balls` with the factors in `work`;  start : of `settle_ruled_ring`"""
    counted = model.counted
    unequal = load.radial != 0.0 or load.moment != 0.0
    if unequal and not counted.load_distribution:
        return 0
    is_ring = unequal or counted.weight
    if not is_ring and not load.axial > 0.0:
        return 0
    rule = TurningRule(load.speed, counted.centrifugal, counted.gyroscopic)
    on_ring = ring_load(model, load, work, rule)
    if is_ring:
        end = load_by_rule(model.ring, on_ring, work.point, work.ring, start)
    else:
        end = load_by_rule(model.ring, on_ring, work.point, None, start)
    if end.end != SETTLED:
        return 0
    return len(work.point.own) if is_ring else 1


@compiled
def ring_load(model: PointModel, load: Load, work: Workspace, rule: TurningRule) -> RingLoad:
    """The load on the ring, with the factors in `work`."""
    work.force[:] = 0.0
    work.force[0], work.force[1], work.force[4] = load.axial, load.radial, load.moment / model.arm
    return RingLoad(work.force, rule, work.factors)


@compiled
def race_of_ball(
    model: PointModel, oil: OilNumbers, ring_speed: float, race: int, point: RingPoint, ball: Ball
) -> ResistedContact:
    """A loaded ball on its inner (0) or outer race (1)."""
    numbers, j, motion = model.ring.bearing.inner if race == 0 else model.ring.bearing.outer, ball.number, ball.motion
    load, fields, angle = point.load[race, j], point.unit[race], abs(point.angle[race, j])
    near, far = distances_to_shoulders(numbers, (numbers.near_shoulder, numbers.far_shoulder), angle)
    if load > 0.0 and min(near, far) <= 0.0:
        load = np.nan  # the contact is off its race
    unit = HertzNumbers(fields[0, j], fields[1, j], fields[2, j], fields[3, j], fields[4, j])
    rate = motion.inner_rolling_rate if race == 0 else motion.outer_rolling_rate
    entrainment = motion.inner_entrainment if race == 0 else motion.outer_entrainment
    contact = contact_under(numbers, unit, angle, load, rate, entrainment)
    return resisted_contact(model.resistance, oil, race, contact, unit.peak_pressure * np.cbrt(load), ring_speed)


@compiled
def _slips(
    slipping: Slipping, inner: ResistedContact, outer: ResistedContact, ring_speed: float, spin_difference: float
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
def _cage_torque(model: PointModel, oil: OilNumbers, balls: DrivingBalls, lead: float, ring_speed: float) -> float:
    """Of a cage at rest on its balls; NaN where balls that lead squeeze it. lead : A, m."""
    cage = model.cage
    if abs(lead) >= cage.room:
        return np.nan
    surface_speed = balls.ball_rate * abs(ring_speed) * cage.ball_radius
    coefficient, _ = pocket_coefficient(model.pocket, oil, resting_load(cage), surface_speed)
    return resting_torque(cage, balls, coefficient, ring_speed)[0]


@compiled
def load_of_point(points: Array, i: int) -> Load:
    """One of n points; points : as below."""
    return Load(points[0, i], points[1, i], points[2, i], points[3, i])


@compiled
def torques_of_points(model: PointModel, points: Array, work: Workspace, torques: Array) -> None:
    """Write (6, n) torques of `PointTorque`; points : (5, n) of `Load`, and the temperature of the oil, K."""
    for i in range(points.shape[1]):
        load, oil = load_of_point(points, i), model.oil
        if model.counted.oil:
            oil = oil_at(oil, points[4, i])
        torque = point_torque(model, load, oil, work)
        for k in range(6):
            torques[k, i] = torque[k]
