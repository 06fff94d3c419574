"""The torque of a bearing at operating points, compiled: every step by the formula of its own folder.

The balls are loaded, turn by rule or freely, lubricate, slide and roll; the cage rests on them. A point that does not
settle gets a status in place of a torque, and costs no other point.
"""

from typing import NamedTuple

import numpy as np

from analytic.cage.pocket import pocket_coefficient
from analytic.cage.steady import DrivingBalls, resting_load, resting_torque
from analytic.contact.factors import AS_HERTZ, ContactFactors, CorrectionNumbers
from analytic.contact.finite_geometry_fit import fit_record, geometry_of, shape_on, shoulders_of
from analytic.contact.geometry import USUAL_SHOULDERS, cut_off_share, distances_to_shoulders
from analytic.contact.hertz import HertzContact, loaded_hertz
from analytic.contact.rolling_contact import ContactNumbers
from analytic.free_ball.kernel import add_law_powers
from analytic.free_ball.passes import FreeAccuracy, FreeEnd, FreeModel, put_motion, settle_freely
from analytic.free_ball.rounds import SKIDS
from analytic.free_ball.state import CONTACT_STATE, QUADRATURE, SCRATCH
from analytic.loads.inertia import moment_of_turned_axis, outward_force
from analytic.loads.kinematics import BallMotion, ruled_motion
from analytic.loads.race_contacts import contact_under
from analytic.loads.ring_rounds import BY_LOAD, BY_POINT, Round, settle_ruled_ring
from analytic.loads.ring_rounds import SETTLED as ROUNDS_SETTLED
from analytic.loads.state import BALL_STATE, RING_STATE, TILTS
from analytic.loads.thrust_ball import first_contacts, settle_ruled_thrust, thrust_point
from analytic.loads.turning import TurningRule
from analytic.numerics.compilation import compiled
from analytic.numerics.machine_code import Layout, entry
from analytic.numerics.records import Record, Records, dtype_of
from analytic.oil.grease import axial_share_of
from analytic.oil.race_resistance import ResistedContact, resisted_contact
from analytic.oil.traction import PointLaw, mean_force
from analytic.oil.unloaded_ball import more_in_clearance
from analytic.oil.viscosity import OilNumbers, oil_at
from analytic.scene import STANDARD_GRAVITY, Array
from analytic.sliding.as_printed import as_printed_slip
from analytic.sliding.ball import NODES, missed_power, slips_over_contacts
from analytic.sliding.long_ellipse import Slip, line_slips
from analytic.solve.model import ModelNumbers, Tables, Workspace
from analytic.solve.records import (
    BALL,
    BEYOND_GROOVE,
    BEYOND_SHOULDER,
    LOOSE_BALL,
    LOOSE_RING,
    NO_CREEP_SPEED,
    NO_DISTRIBUTION,
    NO_SHARED_LOAD,
    NO_SPIN_BALANCE,
    NO_STEADY_ROTATION,
    NO_THRUST,
    OPEN_ANGLE,
    OPEN_FORCES,
    POINT,
    SETTLED,
    THROWN,
    THROWN_WASHERS,
)

# Centrifugal force over the ball load beyond which balls hang in the outer race and skid on the inner one. A bearing
# needs at least a hundredth of that to roll, and the equilibrium of the ring converges up to some 6000.
MOST_CENTRIFUGAL = 1000.0
# Heaviest ball of Z under a radial load Fr without clearance: 4.37 Fr/Z [Stribeck1907]: it is the load-distribution
# integral of point contacts, 1/J_r(0.5) = 4.37.
STRIBECK = 4.37
# Ball load over centrifugal force in a thrust bearing, below which balls leave the middle of their grooves.
PRESSED = 10.0
# Of the heaviest ball's load, a judgement: a lighter ball is at the edge of the loaded zone, and its slip costs little.
IN_LOADED_ZONE = 0.1
STATUS_OF_ROUND = (SETTLED, OPEN_FORCES, LOOSE_BALL, LOOSE_RING, BEYOND_GROOVE, NO_STEADY_ROTATION)


class Load(NamedTuple):
    """An operating point."""

    axial: float  # Fa, N
    radial: float  # Fr along x, N
    moment: float  # M about y, N m
    speed: float  # w of the inner ring, rad/s, of either sign


UNCORRECTED = CorrectionNumbers(AS_HERTZ, AS_HERTZ)


def _layout() -> dict[str, Layout]:
    tables = Tables._make((fit_record().dtype, 2, (NODES.dtype, 1), (QUADRATURE, 1), 2, 4))
    work = Workspace._make((RING_STATE, (BALL_STATE, 1), (CONTACT_STATE, 2), SCRATCH, 1))
    numbers = {"model": dtype_of(ModelNumbers), "tables": tables, "points": 2, "work": work}
    return numbers | {"balls": (BALL, 2), "out": (POINT, 1), "is_free": bool}


@entry(_layout)
def solve(
    model: ModelNumbers,
    tables: Tables,
    points: Array,
    work: Workspace,
    balls: Records,
    out: Records,
    is_free: bool,
) -> None:
    """Write the records of n operating points.

    points : (n, 5) of `Load`, and the temperature of the oil, K
    balls : (n, Z) of `records.BALL`, or (0, 0) where nobody reads them;  out : (n,) of `records.POINT`
    is_free : whether the balls turn freely, where each point begins where the last one has settled; else by rule
    """
    for i in range(points.shape[0]):
        load, of_point = begin(model, tables, points, i, work, out), out[i]
        count = load_balls(model, tables, load, work, of_point)
        if count == 0:
            work.ring.passes = 0
            continue
        written = balls[min(i, balls.shape[0] - 1)]
        if is_free:
            slide_freely(model, tables, load, work, count, written, of_point)
        else:
            slide_by_rule(model, tables, load, work.balls[:count], written, of_point)
        of_point.holding_moment = holding_moment(model, work.ring, count)
        if of_point.status == SETTLED or not is_free:
            finish(model, tables, load, count, written, of_point)
        else:
            spoil(of_point)


@compiled
def holding_moment(model: ModelNumbers, ring: Record, count: int) -> float:
    """About y, which holds a ring at its tilt, N m; 0 for a free one; count : balls that differ"""
    return model.arm * ring.gradient[4] if count > 1 and ring.held > 0 else 0.0


@compiled
def begin(model: ModelNumbers, tables: Tables, points: Array, i: int, work: Workspace, out: Records) -> Load:
    """Begin a point: its load, the oil at its temperature, the factors that are given on its contacts."""
    of_point, given = out[i], tables.factors
    reset(of_point)
    if model.has_oil and points[i, 4] != model.warm.temperature:
        put_oil(model.warm, oil_at(model.oil, points[i, 4]))
    put_law(model.warm, tables.law)
    share = axial_share_of(points[i, 0], points[i, 1], points[i, 2], model.ring.bearing.pitch_diameter)
    put_axial_share(model.resistance.inner.supply, share)
    put_axial_share(model.resistance.outer.supply, share)
    last = given.shape[3] - 1
    for j in range(len(work.balls)):
        for race in range(2):
            factors = work.balls[j].inner_factors if race == 0 else work.balls[j].outer_factors
            if given.shape[0] == 0:
                put_factors(factors, AS_HERTZ)
            else:
                f = given[min(i, given.shape[0] - 1), race]
                at = min(j, last)
                put_factors(factors, ContactFactors(f[0, at], f[1, at], f[2, at], f[3, at]))
    return Load(points[i, 0], points[i, 1], points[i, 2], points[i, 3])


@compiled
def put_factors(factors: Record, found: ContactFactors) -> None:
    """Write factors on a contact."""
    factors.semi_axis_rolling, factors.semi_axis_transverse = found.semi_axis_rolling, found.semi_axis_transverse
    factors.approach, factors.peak_pressure = found.approach, found.peak_pressure


@compiled
def put_oil(oil: Record, found: OilNumbers) -> None:
    """Write what of an oil changes with the temperature."""
    oil.temperature, oil.viscosity, oil.rise = found.temperature, found.viscosity, found.rise
    oil.pressure_viscosity, oil.viscosity_temperature = found.pressure_viscosity, found.viscosity_temperature


@compiled
def put_law(oil: Record, law: Array) -> None:
    """Write where a user's law is: in another place once a model has been copied or sent to another process."""
    oil.own = float(law.ctypes.data) if law.size > 0 else 0.0


@compiled
def put_axial_share(supply: Record, share: float) -> None:
    """Write what of the supply of oil belongs to the operating point."""
    supply.axial_share = share


@compiled
def reset(out: Record) -> None:
    """Begin the sums of a point."""
    out.total = out.spin = out.conformity = out.hysteresis = out.rolling = out.cage = out.sliding_error = 0.0
    out.orbit_rate = out.ball_rate = out.contact_angle = out.ball_lead = out.lead_across = out.slowness = 0.0
    out.holding_moment = 0.0
    out.residual, out.level, out.heaviest, out.gyroscopic_hold = 0.0, 0, 0, 0.0
    out.centrifugal_share = out.gyroscopic_share = out.weight_share = 0.0
    for race in range(2):
        out.peak_pressure[race] = out.cut_off[race] = out.rolling_force[race] = out.most_friction[race] = 0.0
        out.rolling_extrapolated[race] = False
    out.beyond_fit = out.fit_applied = False
    out.status, out.steps, out.left, out.tolerance, out.worst_ball = SETTLED, 0, 0.0, 0.0, 0


@compiled
def spoil(out: Record) -> None:
    """Take the torque of a point that has not settled."""
    out.total = out.spin = out.conformity = out.hysteresis = out.rolling = out.cage = np.nan


@compiled
def thrown(model: ModelNumbers, load: Load) -> float:
    """Centrifugal force of a ball over the load of the heaviest one, about; 0 where estimates say that it is small."""
    bearing = model.ring.bearing
    washers = bearing.inner.bottom_angle > 0.0
    if not (model.counted.centrifugal or washers):
        return 0.0
    most = 1 / PRESSED if washers else MOST_CENTRIFUGAL
    # A ball passes at half the ring's speed at most, and under unequal loads the heaviest one has this load at least.
    force = bearing.ball_mass * bearing.pitch_diameter / 2 * (load.speed / 2) ** 2
    thrust, unequal = abs(load.axial), STRIBECK * (abs(load.radial) + abs(load.moment) / bearing.pitch_diameter)
    if force * bearing.ball_count <= most * (thrust + unequal):
        return 0.0
    angle, pressing = model.ring.angle, thrust / bearing.ball_count
    if thrust > 0.0:
        rule = TurningRule(0.0, False, False)
        at_rest = thrust_point(bearing, first_contacts(bearing), thrust, rule, UNCORRECTED)
        angle, pressing = at_rest.ball.inner_angle, at_rest.ball.inner_load
    motion = ruled_motion(bearing, load.speed, angle, angle)
    force = bearing.ball_mass * bearing.pitch_diameter / 2 * motion.cage_speed**2
    pressing += unequal / bearing.ball_count
    return force / pressing if pressing > 0.0 else np.inf


@compiled
def load_balls(model: ModelNumbers, tables: Tables, load: Load, work: Workspace, out: Record) -> int:
    """Load the balls by rule, with their finite geometry; the number of balls that differ, 0 where they do not settle.

    Under thrust one ball stands for all.
    """
    if load.axial == 0.0 and load.radial == 0.0 and load.moment == 0.0:
        out.status = NO_THRUST
        spoil(out)
        return 0
    ratio, washers = thrown(model, load), model.ring.bearing.inner.bottom_angle > 0.0
    if ratio > (1 / PRESSED if washers else MOST_CENTRIFUGAL):
        out.status, out.left = THROWN_WASHERS if washers else THROWN, ratio
        spoil(out)
        return 0
    count, corrects = 0, model.counted.finite_geometry and tables.factors.shape[0] == 0
    for start in (BY_LOAD, BY_POINT):
        count = balance(model, load, work, start, model.counted.gyroscopic, out)
        if count == 0 or not corrects or start == BY_POINT:
            break
        correct(model, tables, work.balls[:count], work.powers, out)
    return count


@compiled
def correct(model: ModelNumbers, tables: Tables, balls: Records, powers: Array, out: Record) -> None:
    """Write the factors of the balls' finite geometry at their loads by Hertz; powers : of `geometry_of`"""
    bearing = model.ring.bearing
    for j in range(len(balls)):
        ball = balls[j]
        for race in range(2):
            numbers = bearing.inner if race == 0 else bearing.outer
            angle = abs(ball.angle[race]) if ball.load[race] > 0.0 else 0.0
            shoulders = shoulders_of(numbers, USUAL_SHOULDERS[1])
            found = geometry_of(tables.fit, shape_on(numbers, shoulders, angle, ball.load[race]), powers)
            put_factors(ball.inner_factors if race == 0 else ball.outer_factors, found.factors)
            if found.beyond > 0.0 or np.isnan(numbers.near_shoulder):
                out.beyond_fit = True
            if found.applied > 0.0:
                out.fit_applied = True


@compiled
def balance(
    model: ModelNumbers,
    load: Load,
    work: Workspace,
    start: int,
    gyroscopic: bool,
    out: Record,
) -> int:
    """The equilibrium of the balls by rule, with the factors that they have; returns as `load_balls`.

    start : of `settle_ruled_ring`
    """
    counted, ring = model.counted, work.ring
    unequal = load.radial != 0.0 or load.moment != 0.0 or abs(model.tilt) > 0.0
    is_ring = (unequal and counted.load_distribution) or (counted.weight and (unequal or model.weighs_alike))
    if not load.axial > 0.0 and (not is_ring or (unequal and not counted.load_distribution)):
        out.status = NO_DISTRIBUTION if unequal else NO_THRUST
        spoil(out)
        return 0
    for i in range(5):
        ring.load[i] = 0.0
    ring.load[0] = load.axial
    if counted.load_distribution:
        ring.load[1], ring.load[4] = load.radial, load.moment / model.arm
    ring.held = 0 if np.isnan(model.tilt) else TILTS
    if ring.held > 0:
        ring.place[3], ring.place[4] = 0.0, model.arm * model.tilt if counted.load_distribution else 0.0
    rule, count = TurningRule(load.speed, counted.centrifugal, gyroscopic), 1
    if is_ring:
        count = len(work.balls)
        end = settle_ruled_ring(model.ring, rule, ring, work.balls, start)
        out.status = STATUS_OF_ROUND[end.end]
    else:
        left = settle_ruled_thrust(model.ring.bearing, rule, load.axial, work.balls[0])
        end = Round(ROUNDS_SETTLED, 0, left, 0.0)
        out.status = SETTLED if left == 0.0 else OPEN_ANGLE
    if out.status != SETTLED:
        out.steps, out.left, out.tolerance = end.steps, end.left, end.tolerance
        spoil(out)
        return 0
    out.residual = end.left / (abs(load.axial) + abs(load.radial) + abs(load.moment) / model.arm)
    return count


class LoadedContact(NamedTuple):
    """A ball on a race as the kernel sums it up."""

    resisted: ResistedContact
    hertz: HertzContact  # under its load
    distance: float  # to the nearer shoulder, a low one where it is not known, m; infinite without load


@compiled
def contact_of_ball(
    model: ModelNumbers, tables: Tables, speed: float, race: int, ball: Record, motion: BallMotion
) -> LoadedContact:
    """A loaded ball on its inner (0) or outer race (1)."""
    numbers = model.ring.bearing.inner if race == 0 else model.ring.bearing.outer
    unit = ball.inner_unit if race == 0 else ball.outer_unit
    rate = motion.inner_rolling_rate if race == 0 else motion.outer_rolling_rate
    entrainment = motion.inner_entrainment if race == 0 else motion.outer_entrainment
    contact = contact_under(numbers, unit, abs(ball.angle[race]), ball.load[race], rate, entrainment)
    hertz = loaded_hertz(unit, ball.load[race])
    resistance, oil = model.resistance, model.warm
    resisted = resisted_contact(resistance, tables.cubics, oil, race, contact, hertz.peak_pressure, speed)
    distance = np.inf
    if contact.load > 0.0:
        near, far = distances_to_shoulders(numbers, shoulders_of(numbers, USUAL_SHOULDERS[0]), ball.angle[race])
        distance = min(near, far)
    return LoadedContact(resisted, hertz, distance)


@compiled
def note_limits(model: ModelNumbers, race: int, found: LoadedContact, j: int, out: Record) -> None:
    """Look after the limits of a contact of ball j."""
    numbers = model.ring.bearing.inner if race == 0 else model.ring.bearing.outer
    contact, is_known = found.resisted.contact, not np.isnan(numbers.near_shoulder)
    if contact.load > 0.0:
        b = contact.semi_axis_transverse
        if is_known and found.distance <= 0.0:
            out.status, out.worst_ball = BEYOND_SHOULDER, j
        out.cut_off[race] = max(out.cut_off[race], cut_off_share(max(found.distance, 0.0), b))
    out.peak_pressure[race] = max(out.peak_pressure[race], found.hertz.peak_pressure)
    if found.resisted.rolling_extrapolated:
        out.rolling_extrapolated[race] = True
    if model.has_oil and np.isnan(model.resistance.coefficient) and np.isnan(found.resisted.mixed.asperity_share):
        out.status = NO_SHARED_LOAD


@compiled
def friction_held(resisted: ResistedContact, ring_speed: float) -> float:
    """Friction of a contact that slides as fast as it rolls, N."""
    return mean_force(resisted.law, resisted.contact, abs(ring_speed) * resisted.contact.entrainment)


@compiled
def add_ball(
    model: ModelNumbers,
    load: Load,
    ball: Record,
    contacts: tuple[LoadedContact, LoadedContact],
    motion: BallMotion,
    place: tuple[int, int],
    out: Record,
) -> None:
    """Add what a ball loses besides sliding, how it drives the cage, and what its friction can hold.

    place : number of the ball, and of those that differ
    """
    j, count = place
    alike, slides = model.ring.bearing.ball_count / count, model.counted.spin or model.counted.conformity
    drives = max(ball.load[0], ball.load[1]) > 0.0
    # Nothing turns a ball without load; a cage that gives way takes it along as it would roll.
    out.orbit_rate += motion.cage_speed if drives or np.isinf(model.cage.room) else np.nan
    out.ball_rate += motion.ball_speed
    out.contact_angle += abs(ball.angle[0] + ball.angle[1]) / 2
    out.ball_lead += np.cos(2 * np.pi * j / count) / motion.cage_speed
    out.lead_across += np.sin(2 * np.pi * j / count) / motion.cage_speed
    out.slowness += 1 / motion.cage_speed
    note_own_forces(model, load.speed, min(ball.load[0], ball.load[1]), motion, out)
    for race in range(2):
        found = contacts[race]
        resisted = found.resisted
        note_limits(model, race, found, j, out)
        out.hysteresis += alike * resisted.hysteresis_torque
        out.rolling += alike * resisted.rolling_torque
        if resisted.contact.entrainment > 0.0:
            out.rolling_force[race] += alike * resisted.rolling_torque / (2 * resisted.contact.entrainment)
        if slides:
            out.most_friction[race] += alike * friction_held(resisted, load.speed)
    if model.resistance.rolls and model.counted.unloaded_balls and min(ball.load[0], ball.load[1]) == 0.0:
        resisted = contacts[0].resisted, contacts[1].resisted
        out.rolling += alike * more_in_clearance(model.ring, model.resistance, model.warm, load.speed, ball, resisted)


@compiled
def note_own_forces(model: ModelNumbers, ring_speed: float, least: float, motion: BallMotion, out: Record) -> None:
    """Note each force of a ball's own over its load on the race that presses less, with an upright axis."""
    bearing, orbit = model.ring.bearing, ring_speed * motion.cage_speed
    outward = outward_force(bearing.ball_mass, bearing.pitch_diameter, orbit)
    diameter = 2 * bearing.ball_radius
    moment = moment_of_turned_axis(bearing.ball_mass, diameter, ring_speed * motion.ball_speed, orbit, np.pi / 2)
    out.centrifugal_share = max(out.centrifugal_share, over_load(outward, least))
    weight, turning = bearing.ball_mass * STANDARD_GRAVITY, abs(moment) / bearing.ball_radius
    out.gyroscopic_share = max(out.gyroscopic_share, over_load(turning, least))
    out.weight_share = max(out.weight_share, over_load(weight, least))


@compiled
def over_load(force: float, load: float) -> float:
    """Their ratio: 0 without a force, infinite where there is a force alone."""
    if force == 0.0:
        return 0.0
    return force / load if load > 0.0 else np.inf


@compiled
def write_ball(
    model: ModelNumbers,
    load: Load,
    state: Record,
    contacts: tuple[LoadedContact, LoadedContact],
    coefficients: tuple[float, float],
    motion: BallMotion,
    ball: Record,
) -> None:
    """Write the record of a ball."""
    bearing, held = model.ring.bearing, 0.0
    for race in range(2):
        resisted, hertz = contacts[race].resisted, contacts[race].hertz
        mixed = resisted.mixed
        ball.load[race], ball.angle[race] = state.load[race], state.angle[race]
        ball.semi_axis_rolling[race], ball.semi_axis_transverse[race] = hertz.semi_axis_x, hertz.semi_axis_y
        ball.peak_pressure[race], ball.approach[race] = hertz.peak_pressure, hertz.approach
        ball.stiffness[race], ball.shoulder_distance[race] = hertz.stiffness, contacts[race].distance
        ball.friction_coefficient[race] = coefficients[race]
        ball.film[race], ball.asperity_share[race] = mixed.film_thickness, mixed.asperity_share
        ball.boundary_share[race], ball.film_capped[race] = mixed.boundary_share, mixed.capped
        ball.film_extrapolated[race] = resisted.film_extrapolated
        ball.starvation_degree[race] = resisted.starvation_degree
        held += friction_held(resisted, load.speed)
    turning = moment_of_turned_axis(
        bearing.ball_mass,
        2 * bearing.ball_radius,
        load.speed * motion.ball_speed,
        load.speed * motion.cage_speed,
        motion.pitch,
    )
    both = state.load[0] > 0.0 and state.load[1] > 0.0
    ball.gyroscopic_hold = 0.0
    if both and turning != 0.0:
        ball.gyroscopic_hold = abs(turning) / (bearing.ball_radius * held) if held > 0.0 else np.inf
    put_motion(ball, motion)


@compiled
def slide_by_rule(
    model: ModelNumbers, tables: Tables, load: Load, states: Records, balls: Records, out: Record
) -> None:
    """What the balls lose that turn by the spin rule; states : of the balls that differ

    Where the nodes of a level miss more than is allowed, the next one has twice as many.
    """
    counted, count = model.counted, len(states)
    alike, slides = model.ring.bearing.ball_count / count, counted.spin or counted.conformity
    first, last = model.level, len(tables.nodes) // 3 - 1
    for level in range(first, last + 1):
        out.spin = out.conformity = 0.0
        whole = most = missed = 0.0
        for j in range(count):
            state = states[j]
            motion = ruled_motion(model.ring.bearing, 1.0, state.angle[0], state.angle[1])
            inner = contact_of_ball(model, tables, load.speed, 0, state, motion)
            outer = contact_of_ball(model, tables, load.speed, 1, state, motion)
            if level == first:
                add_ball(model, load, state, (inner, outer), motion, (j, count), out)
            coefficients = (np.nan, np.nan)
            if slides:
                difference = abs(motion.spin_difference) if counted.spin else 0.0
                contacts = (inner.resisted.contact, outer.resisted.contact)
                laws = (inner.resisted.law, outer.resisted.law)
                slips = slips_of(model, tables, contacts, laws, abs(load.speed), difference, level, out)
                coefficients = (slips[0].coefficient, slips[1].coefficient)
                power = 0.0
                for race in range(2):
                    spin = slips[race].spin_moment * slips[race].spin_rate
                    conformity = slips[race].rolling_moment * contacts[race].rolling_rate
                    out.spin += alike * spin
                    out.conformity += alike * conformity
                    power += spin + conformity
                whole += alike * power
                if power > most and not model.as_printed:
                    most = power
                    missed = missed_power(contacts, laws, slips, abs(load.speed), tables.nodes, level) / power
            if j < len(balls):
                write_ball(model, load, state, (inner, outer), coefficients, motion, balls[j])
        out.level, out.sliding_error = level, missed * whole
        if missed * whole <= model.allowed * (whole + out.hysteresis + out.rolling):
            break


@compiled
def slips_of(
    model: ModelNumbers,
    tables: Tables,
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    ring_speed: float,
    spin_difference: float,
    level: int,
    out: Record,
) -> tuple[Slip, Slip]:
    """The slip of a ball on both races, over their ellipses or as [Paper] prints it; level : of nodes"""
    if model.as_printed:
        inner, outer = line_slips(contacts, laws, ring_speed, spin_difference, model.spin_rule)
        if np.isnan(inner.spin_rate):
            out.status = NO_SPIN_BALANCE
        radius = model.ring.bearing.ball_radius
        return as_printed_slip(contacts[0], inner, radius), as_printed_slip(contacts[1], outer, radius)
    nodes = tables.nodes[3 * level]
    inner, outer, number = slips_over_contacts(contacts, laws, ring_speed, spin_difference, model.spin_rule, nodes)
    if number == 0:
        out.status = NO_CREEP_SPEED
    return inner, outer


@compiled
def slide_freely(
    model: ModelNumbers,
    tables: Tables,
    load: Load,
    work: Workspace,
    count: int,
    balls: Records,
    out: Record,
) -> None:
    """What the balls lose that turn freely; count : balls that differ"""
    states, contacts = work.balls[:count], work.contacts[:count]
    rolls_off = model.resistance.rolls and model.counted.unloaded_balls
    free = FreeModel(
        model.ring, model.resistance, rolls_off, tables.cubics, model.free, tables.quadratures, work.scratch
    )
    wanted = FreeAccuracy(model.level, model.allowed)
    end = FreeEnd(Round(ROUNDS_SETTLED, 0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0)
    if model.cold:
        work.ring.passes = 0
    for _ in range(2):  # by rule, where the point does not settle from a start that is known
        known = work.ring.passes > 0
        if balance(model, load, work, BY_LOAD, False, out) == 0:
            work.ring.passes = 0
            return
        end = settle_freely(free, load.speed, model.warm, work.ring, states, contacts, wanted, count > 1)
        if end.round.end == ROUNDS_SETTLED or not known:
            break
    last = end.round
    out.steps, out.left, out.tolerance, out.level = last.steps, last.left, last.tolerance, work.ring.passes - 1
    if last.end != ROUNDS_SETTLED:
        out.status = STATUS_OF_ROUND[last.end]
        if count == 1 and out.status == OPEN_FORCES:
            out.status = OPEN_ANGLE
        for j in range(count):
            if last.end == SKIDS and not states[j].residual <= states[out.worst_ball].residual:
                out.worst_ball = j
        return
    out.spin, out.conformity = end.spin, end.torque - end.spin
    out.sliding_error, out.residual = end.error, end.residual
    quadrature = tables.quadratures[1 + 2 * out.level]
    for j in range(count):
        state, of_ball = states[j], contacts[j]
        motion = motion_of(state)
        inner = contact_of_ball(model, tables, load.speed, 0, state, motion)
        outer = contact_of_ball(model, tables, load.speed, 1, state, motion)
        add_ball(model, load, state, (inner, outer), motion, (j, count), out)
        if j < len(balls):
            add_law_powers(of_ball, state, quadrature, work.scratch)
            write_ball(model, load, state, (inner, outer), coefficients_of(of_ball), motion, balls[j])


@compiled
def motion_of(ball: Record) -> BallMotion:
    """How a ball moves, per unit ring speed."""
    m = ball.motion
    return BallMotion(
        m.inner_radius,
        m.outer_radius,
        m.cage_speed,
        m.ball_speed,
        m.inner_entrainment,
        m.outer_entrainment,
        m.inner_rolling_rate,
        m.outer_rolling_rate,
        m.spin_difference,
        m.pitch,
    )


@compiled
def coefficients_of(contacts: Records) -> tuple[float, float]:
    """Friction coefficients that lose the power of the law of traction at the slip without creep; 0 without load."""
    inner, outer = contacts[0], contacts[1]
    return (
        inner.law_power / inner.unit_power if inner.unit_power > 0.0 else 0.0,
        outer.law_power / outer.unit_power if outer.unit_power > 0.0 else 0.0,
    )


@compiled
def finish(model: ModelNumbers, tables: Tables, load: Load, count: int, balls: Records, out: Record) -> None:
    """Add the cage and sum up, once the balls of a point have their parts."""
    heaviest = 0.0
    for j in range(min(count, len(balls))):
        largest = max(balls[j].load[0], balls[j].load[1])
        if largest > heaviest:
            heaviest, out.heaviest = largest, j
    for j in range(min(count, len(balls))):
        if max(balls[j].load[0], balls[j].load[1]) >= IN_LOADED_ZONE * heaviest:
            out.gyroscopic_hold = max(out.gyroscopic_hold, balls[j].gyroscopic_hold)
    for j in range(count, len(balls)):
        balls[j] = balls[0]
    out.orbit_rate /= count
    out.ball_rate /= count
    out.contact_angle /= count
    # First harmonic of the slowness of the balls round their orbit, see `analytic.cage.drive.ball_lead`
    if count > 1:
        wave = np.copysign(np.hypot(out.ball_lead, out.lead_across), out.ball_lead)
        out.ball_lead = -model.ring.bearing.pitch_diameter * wave / out.slowness
    else:
        out.ball_lead = 0.0
    if model.counted.cage:
        out.cage = cage_torque(model, tables, load.speed, out)
    if not model.counted.spin:
        out.spin = 0.0
    if not model.counted.conformity:
        out.conformity = 0.0
    out.total = out.spin + out.conformity + out.hysteresis + out.rolling + out.cage + model.declared
    if out.status != SETTLED:
        spoil(out)


@compiled
def cage_torque(model: ModelNumbers, tables: Tables, ring_speed: float, out: Record) -> float:
    """Of a cage at rest on its balls, N m; NaN where balls that lead squeeze it, or nothing turns a ball."""
    cage, balls = model.cage, DrivingBalls(out.orbit_rate, out.ball_rate, out.contact_angle)
    if abs(out.ball_lead) >= cage.room or (ring_speed != 0.0 and np.isnan(out.orbit_rate)):
        return np.nan
    surface_speed = out.ball_rate * abs(ring_speed) * cage.ball_radius
    coefficient, _ = pocket_coefficient(model.pocket, tables.cubics, model.warm, resting_load(cage), surface_speed)
    return resting_torque(cage, balls, coefficient, ring_speed)[0]
