"""The motion of the cage, on balls whose motion is prescribed, or together with balls that move freely.

Each ball acts on the cage by equations 13 to 17 of [Paper] (`analytic.cage.pocket`); equations 18 and 19 sum the
forces and the moments about the centre of the cage, which has six degrees of freedom. Everything is in the fixed frame,
z is the axis of the bearing, and ball i starts at the azimuth 2 pi i/Z.

A prescribed ball goes along the pitch circle and turns as `DrivenCage` says. A free ball has a speed along its orbit
and a rotation about three axes. The tractions of both raceways (`analytic.cage.raceways`), the gyroscopic moment and
the push and friction of its pocket change them. So a cage can press a ball no harder than the raceways hold it, but for
impacts, which the inertia of the ball carries. Balls that run at different speeds over a turn lead and lag by
themselves. Left out: weight and oil drag of the balls, motion of the rings, the ball's inertia across its raceways, and
what the orbit speed changes in the centrifugal force.

One step of the cage is half a kick by the loads, the exact motion of a free ring, and half a kick by the loads at its
end. There, friction and damping take the velocities that the previous loads would give. The method is of second order,
and symplectic without losses. A free ball goes on with its speed along the orbit. Then the raceways and the force of
its pocket change its four speeds by one implicit step: the raceways hold a ball so stiffly that an explicit step would
have to be ten times shorter. A ball that its pocket does not touch takes one implicit step for `STEPS_UNTOUCHED` of the
cage's. The forces on cage and ball are the same, so the momentum of both together changes by the tractions of the
raceways, weight, drag and land alone.
"""

from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np

from analytic.cage.pocket import FAST, BallInPocket, Body, Vector, impact, impact_damping, is_clear, pushed, rubbing
from analytic.cage.raceways import (
    AZIMUTH,
    BALL,
    BALL_ON_RACEWAYS,
    SPEEDS,
    PocketPush,
    Raceways,
    interpolate,
    numbers,
    step_ball,
)
from analytic.cage.steady import DrivenCage, lead_room, whirl_speed
from analytic.errors import (
    ConvergenceError,
    FembearingError,
    InputError,
    SingularError,
    require_non_negative,
    require_positive,
)
from analytic.numerics.compilation import compiled
from analytic.numerics.machine_code import entry
from analytic.scene import Array, Cage, CageStart

LEAST_IMPACT = 1e-3  # m/s: a contact that begins to close more slowly is damped as if it had closed with this speed
DISTURBANCE = 1e-3  # of the half clearance and of the impact speed: by which seeds change the beginning of a motion
DEEPEST = 0.5  # of the ball radius: no elastic contact is so deep
LONGEST_STEP = 1e-4  # s: no impact limits the step of a cage at rest
SHARPEST = 1 / 400  # largest v0 of the friction over the speed of the ball surfaces; with more, slow balls would creep
STEPS_UNTOUCHED = 16  # of the cage for one of a free ball that its pocket does not touch
LEAST_STEPS = 10  # in an impact on free balls: fewer do not follow its force
LEAST_STEPS_SEEN = 5  # in the hardest impact that came, which may be harder than the one expected
NARROW = 0.9  # of the room that free balls may lead and lag by at the beginning: the cage still moves between them

# The cage, its prescribed balls and their contacts, SI. damping : `impact_damping`;  spin_axial, spin_radial : rotation
# of a ball relative to the orbit, along z and outward, rad/s;  lead : rad;  ramp : time in which all speeds rise, s, 0:
# full speed at once;  land_radius : 0: no land;  land_side : of the contact along the displacement of the cage, -1 at
# the bore of the cage, +1 outside;  deepest : penetration at which the motion has diverged, m
CAGE = np.dtype(
    numbers(
        "mass",
        "inverse_mass",
        "inverse_axial_inertia",
        "inverse_transverse_inertia",
        "pitch_radius",
        "ball_radius",
        "drag",
    )
    + numbers("half_clearance", "centre_offset", "stiffness", "sheet_softness", "damping", "least_impact")
    + numbers("friction", "smoothing")
    + numbers("orbit_speed", "spin_axial", "spin_radial", "lead", "ramp", "deepest")
    + numbers("land_radius", "land_half_clearance", "land_side", "land_speed", "land_half_width")
    + [("gravity", np.float64, 3), ("axial_pockets", np.bool_)],
    align=True,
)
# orientation : quaternion, scalar first;  momentum : angular;  orbit_angle : of prescribed balls, rad
STATE = np.dtype(
    [
        *numbers("time", "orbit_angle"),
        *((name, np.float64, 3) for name in ("place", "velocity", "momentum")),
        ("orientation", np.float64, 4),
    ]
)
# Integrals over the time of a call. Powers in J: of friction in the pockets, of friction at the land, of damping, of
# drag, of the balls on the cage, of the inner ring, of slip in the raceways, of that without a cage, and of the
# implicit method. Moment of the balls on the cage about z, N m s. Sum of the normal forces, N s. Angle through which
# the centre went round z, rad. Of its place x, y, its distance from z, that squared, and the tilt of the cage squared.
INTEGRALS = numbers("slip_power", "land_power", "damping_power", "drag_power", "ball_power") + numbers(
    "ring_power", "race_power", "alone_power", "numerical_power", "moment", "force", "circling"
)
# max_force : largest normal force of one contact, N;  grip : largest share of the raceways' grip that was used;
# unsettled : steps of balls that did not converge
TOTALS = np.dtype(
    INTEGRALS + numbers("x", "y", "distance", "distance_square", "tilt_square", "max_force", "grip", "unsettled")
)


class Flight(NamedTuple):
    """Where the cage is and how it moves."""

    place: Vector
    velocity: Vector
    orientation: tuple[float, float, float, float]  # quaternion, scalar first
    momentum: Vector  # angular


class Orbit(NamedTuple):
    """Of prescribed balls."""

    cosine: float  # of the angle of the orbit
    sine: float
    speed_share: float  # that is reached, 0 to 1


class BallMotion(NamedTuple):
    """Where a ball is on the pitch circle, and how it moves."""

    cosine: float  # of its azimuth
    sine: float
    along: float  # speed along the orbit, m/s
    about: float  # absolute rotation about the direction of the orbit, rad/s
    outward: float
    axial: float


class Loads(NamedTuple):
    """What acts on the cage at one instant."""

    force: Vector
    moment: Vector
    deepest: float  # penetration, m


@compiled(fastmath=FAST, inline=True)
def _three(values):
    return values[0], values[1], values[2]


@compiled(fastmath=FAST, inline=True)
def _rotation(orientation):
    """Matrix of a quaternion of length 1, by rows."""
    a, b, c, d = orientation
    return (
        1.0 - 2.0 * (c * c + d * d),
        2.0 * (b * c - a * d),
        2.0 * (b * d + a * c),
        2.0 * (b * c + a * d),
        1.0 - 2.0 * (b * b + d * d),
        2.0 * (c * d - a * b),
        2.0 * (b * d - a * c),
        2.0 * (c * d + a * b),
        1.0 - 2.0 * (b * b + c * c),
    )


@compiled(fastmath=FAST, inline=True)
def _kicked(cage, flight, loads, time):
    """The Flight after Loads that act for a time."""
    x, y, z = flight.velocity
    lx, ly, lz = flight.momentum
    force, moment, each = loads.force, loads.moment, time * cage.inverse_mass
    return Flight(
        flight.place,
        (x + each * force[0], y + each * force[1], z + each * force[2]),
        flight.orientation,
        (lx + time * moment[0], ly + time * moment[1], lz + time * moment[2]),
    )


@compiled(fastmath=FAST, inline=True)
def _flown(cage, flight, r, step):
    """The Flight after a step without loads; r : its rotation matrix at the beginning.

    A free ring rotates about its angular momentum and about its own axis: both by Cayley's map, whose error is the cube
    of an angle of some 1e-5.
    """
    x, y, z = flight.place
    vx, vy, vz = flight.velocity
    a, b, c, d = flight.orientation
    lx, ly, lz = flight.momentum
    soft = cage.inverse_transverse_inertia
    half = 0.5 * step
    turn = half * (r[2] * lx + r[5] * ly + r[8] * lz) * (cage.inverse_axial_inertia - soft)
    a, b, c, d = a - turn * d, b + turn * c, c - turn * b, d + turn * a
    px, py, pz = half * soft * lx, half * soft * ly, half * soft * lz
    a, b, c, d = (
        a - px * b - py * c - pz * d,
        b + px * a + py * d - pz * c,
        c + py * a + pz * b - px * d,
        d + pz * a + px * c - py * b,
    )
    length = 1.0 / np.sqrt(a * a + b * b + c * c + d * d)
    return Flight(
        (x + step * vx, y + step * vy, z + step * vz),
        flight.velocity,
        (a * length, b * length, c * length, d * length),
        flight.momentum,
    )


@compiled(fastmath=FAST, inline=True)
def _body(cage, flight, r):
    """The Body of a Flight; r : its rotation matrix."""
    lx, ly, lz = flight.momentum
    soft = cage.inverse_transverse_inertia
    own = (r[2] * lx + r[5] * ly + r[8] * lz) * (cage.inverse_axial_inertia - soft)
    return Body(
        flight.place, flight.velocity, r, (lx * soft + own * r[2], ly * soft + own * r[5], lz * soft + own * r[8])
    )


@compiled(fastmath=FAST, inline=True)
def _speed_share(cage, time):
    """Share of all speeds that is reached, 0 to 1."""
    return time / cage.ramp if time < cage.ramp else 1.0


@compiled(fastmath=FAST, inline=True)
def _loads_beside_balls(cage, body, speed_share, span, totals):
    """Loads of weight, drag and land; span : s, for which their powers are added to the totals."""
    x, y, _ = body.place
    vx, vy, vz = body.velocity
    wx, wy, wz = body.angular_velocity
    xz, yz, zz = body.rotation[2], body.rotation[5], body.rotation[8]
    gravity = cage.gravity
    fx, fy, fz = cage.mass * gravity[0], cage.mass * gravity[1], cage.mass * gravity[2]
    mx = my = mz = deepest = 0.0
    if cage.drag != 0.0:
        along = cage.drag / (cage.pitch_radius * cage.pitch_radius)
        fx, fy, fz, mz = fx - along * vx, fy - along * vy, fz - along * vz, -cage.drag * wz
        totals.drag_power += span * (along * (vx * vx + vy * vy + vz * vz) + cage.drag * wz * wz)
    if cage.land_radius != 0.0:
        for rim in range(2):
            half = cage.land_half_width if rim == 0 else -cage.land_half_width
            hx, hy = x + half * xz, y + half * yz
            distance = np.sqrt(hx * hx + hy * hy)
            depth = distance - cage.land_half_clearance
            if depth <= 0.0:
                continue
            nx, ny = hx / distance, hy / distance
            arm = cage.land_side * cage.land_radius
            px, py, pz = arm * nx - x, arm * ny - y, half * zz
            surface = cage.land_speed * speed_share * arm
            gx, gy = -surface * ny - vx - wy * pz + wz * py, surface * nx - vy - wz * px + wx * pz
            gz = -vz - wx * py + wy * px
            closing = gx * nx + gy * ny
            gx, gy = gx - closing * nx, gy - closing * ny
            speed = np.sqrt(gx * gx + gy * gy + gz * gz)
            normal = cage.stiffness * depth * np.sqrt(depth)
            per_speed = rubbing(cage, normal, speed)
            qx, qy, qz = -normal * nx + per_speed * gx, -normal * ny + per_speed * gy, per_speed * gz
            fx, fy, fz = fx + qx, fy + qy, fz + qz
            mx, my, mz = mx + py * qz - pz * qy, my + pz * qx - px * qz, mz + px * qy - py * qx
            totals.land_power += span * per_speed * speed * speed
            deepest = max(deepest, depth)
    return Loads((fx, fy, fz), (mx, my, mz), deepest)


@compiled(fastmath=FAST, inline=True)
def _prescribed_ball(cage, orbit, ball):
    """BallMotion on an Orbit."""
    c, s, share = ball.pocket_cosine, ball.pocket_sine, orbit.speed_share
    cosine, sine = orbit.cosine * c - orbit.sine * s, orbit.sine * c + orbit.cosine * s
    rate = cage.orbit_speed * share
    if cage.lead != 0.0:
        rate *= 1.0 + cage.lead * cosine
        turn_c, turn_s = np.cos(cage.lead * sine), np.sin(cage.lead * sine)
        cosine, sine = cosine * turn_c - sine * turn_s, sine * turn_c + cosine * turn_s
    return BallMotion(
        cosine, sine, cage.pitch_radius * rate, 0.0, cage.spin_radial * share, cage.spin_axial * share + rate
    )


@compiled(fastmath=FAST, inline=True)
def _free_ball(cage, ball, span):
    """BallMotion of a ball that has gone on with its speed for a time span."""
    ball.azimuth += span * ball.along / cage.pitch_radius
    ball.since_step += span
    radius = cage.ball_radius
    return BallMotion(
        np.cos(ball.azimuth),
        np.sin(ball.azimuth),
        ball.along,
        ball.about / radius,
        ball.outward / radius,
        ball.axial / radius,
    )


@compiled(fastmath=FAST, inline=True)
def _offset(cage, body, ball, motion):
    """From the centre of the pocket to that of its ball, m, and the axis of the pocket."""
    x, y, z = body.place
    xx, xy, xz, yx, yy, yz, zx, zy, zz = body.rotation
    c, s, pitch = ball.pocket_cosine, ball.pocket_sine, cage.pitch_radius
    px, py, pz = xx * c + xy * s, yx * c + yy * s, zx * c + zy * s
    offset = (pitch * (motion.cosine - px) - x, pitch * (motion.sine - py) - y, -pitch * pz - z)
    return offset, (xz, yz, zz) if cage.axial_pockets else (px, py, pz)


@compiled(fastmath=FAST, inline=True)
def _ball_in_pocket(cage, body, motion, offset, axis):
    (x, y, z), pitch, c, s = body.place, cage.pitch_radius, motion.cosine, motion.sine
    return BallInPocket(
        offset,
        axis,
        (pitch * c - x, pitch * s - y, -z),
        (-motion.along * s, motion.along * c, 0.0),
        (motion.outward * c - motion.about * s, motion.outward * s + motion.about * c, motion.axial),
    )


@compiled(fastmath=FAST)
def _step_free_ball(cage, raceways, table, ball, body, push, step, speed_share, totals):
    """One implicit step of a ball over the time since its last.

    push : of the ball on the cage, force, N, and moment about the cage's centre, N m
    """
    (qx, qy, qz), (mx, my, mz), (x, y, z) = *push, body.place
    cosine, sine, lever = np.cos(ball.azimuth), np.sin(ball.azimuth), step / cage.ball_radius
    cx, cy, cz = cage.pitch_radius * cosine - x, cage.pitch_radius * sine - y, -z
    tx, ty, tz = mx - cy * qz + cz * qy, my - cz * qx + cx * qz, mz - cx * qy + cy * qx  # about the ball's centre
    interpolate(table, ball)
    impulses = (
        step * (qx * sine - qy * cosine),
        lever * (tx * sine - ty * cosine),
        -lever * (tx * cosine + ty * sine),
        -lever * tz,
    )
    on_ball = PocketPush(-qx * cosine - qy * sine, -qz, impulses)
    done = step_ball(raceways, ball, on_ball, ball.since_step, speed_share)
    totals.alone_power += ball.contacts.slip_without_cage * ball.since_step
    totals.ring_power += done.ring_work
    totals.race_power += done.slip
    totals.numerical_power += done.numerical
    totals.grip = max(totals.grip, done.grip)
    if not done.settled:
        totals.unsettled += 1.0
    ball.since_step = 0.0


@compiled(fastmath=FAST, inline=True)
def _loads(cage, raceways, table, balls, body, orbit, step, is_first, is_last, totals):
    """All Loads on the Body; moves free balls, and adds to the totals, but for the first of a call."""
    span = 0.0 if is_first else step
    beside = _loads_beside_balls(cage, body, orbit.speed_share, span, totals)
    (fx, fy, fz), (mx, my, mz), deepest = beside.force, beside.moment, beside.deepest
    slip = damping = work = normal = turning = largest = 0.0
    for number in range(balls.shape[0]):
        ball = balls[number]
        motion = _prescribed_ball(cage, orbit, ball) if table.size == 0 else _free_ball(cage, ball, span)
        offset, axis = _offset(cage, body, ball, motion)
        force, moment = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
        if is_clear(cage, offset, axis):
            ball.impact_speed[0] = ball.impact_speed[1] = 0.0
            if not is_last and ball.since_step < (STEPS_UNTOUCHED - 0.5) * step:
                continue
        else:
            push = pushed(cage, _ball_in_pocket(cage, body, motion, offset, axis), body, ball.impact_speed)
            force, moment = push.force, push.moment
            fx, fy, fz = fx + force[0], fy + force[1], fz + force[2]
            mx, my, mz = mx + moment[0], my + moment[1], mz + moment[2]
            slip += push.slip
            damping += push.damping
            work += push.work
            normal += push.normal
            turning += moment[2]
            largest = max(largest, push.largest)
            deepest = max(deepest, push.deepest)
        if is_last:
            ball.force[0], ball.force[1], ball.force[2] = force
        if table.size > 0 and not is_first:
            _step_free_ball(cage, raceways, table, ball, body, (force, moment), step, orbit.speed_share, totals)
    if not is_first:
        totals.slip_power += step * slip
        totals.damping_power += step * damping
        totals.ball_power += step * work
        totals.force += step * normal
        totals.moment += step * turning
        totals.max_force = max(totals.max_force, largest)
    return Loads((fx, fy, fz), (mx, my, mz), deepest)


@compiled(fastmath=FAST, inline=True)
def _add_place(flight, body, step, totals):
    (x, y, _), (vx, vy, _), r = flight.place, flight.velocity, body.rotation
    away = x * x + y * y
    if away > 0.0:
        totals.circling += step * (x * vy - y * vx) / away
    totals.x += step * x
    totals.y += step * y
    totals.distance += step * np.sqrt(away)
    totals.distance_square += step * away
    totals.tilt_square += step * (r[2] * r[2] + r[5] * r[5])


@entry(
    lambda: {
        "cage": CAGE,
        "raceways": BALL_ON_RACEWAYS,
        "table": (AZIMUTH, 1),
        "balls": (BALL, 1),
        "state": STATE,
        "totals": TOTALS,
        "step": float,
        "steps": int,
    },
    fastmath=FAST,
)
def advance(cage: Any, raceways: Any, table: Any, balls: Any, state: Any, totals: Any, step: float, steps: int) -> int:
    """Advance state and balls in place by steps of `step` seconds; returns the number of steps done, less if diverging.

    cage : CAGE;  raceways : BALL_ON_RACEWAYS;  table : (n,) of AZIMUTH over a turn, (0,) for prescribed balls
    balls : (Z,) of BALL;  state : STATE;  totals : TOTALS, to which those of the steps are added
    """
    turned, time, angle = state.orientation, state.time, state.orbit_angle
    orientation = turned[0], turned[1], turned[2], turned[3]
    flight = Flight(_three(state.place), _three(state.velocity), orientation, _three(state.momentum))
    loads = Loads((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0)
    r = _rotation(flight.orientation)
    half, share = 0.5 * step, _speed_share(cage, time)
    done = 0
    for done in range(steps + 1):
        if done > 0:
            flight = _flown(cage, _kicked(cage, flight, loads, half), r, step)
            time += step
            before, share = share, _speed_share(cage, time)
            angle += half * (before + share) * cage.orbit_speed
            r = _rotation(flight.orientation)
        # Friction and damping see the velocities that the previous loads would give. At first there are none.
        body = _body(cage, _kicked(cage, flight, loads, half), r)
        orbit = Orbit(np.cos(angle), np.sin(angle), share)
        loads = _loads(cage, raceways, table, balls, body, orbit, step, done == 0, done == steps, totals)
        if done == 0:
            continue
        flight = _kicked(cage, flight, loads, half)
        _add_place(flight, body, step, totals)
        vx, vy, vz = flight.velocity
        if not loads.deepest < cage.deepest or not vx * vx + vy * vy + vz * vz < np.inf:
            break
    state.time, state.orbit_angle = time, angle
    for axis in range(3):
        state.place[axis], state.velocity[axis] = flight.place[axis], flight.velocity[axis]
        state.momentum[axis] = flight.momentum[axis]
    for part in range(4):
        state.orientation[part] = flight.orientation[part]
    return done


class MotionError(ConvergenceError):
    """A motion that diverged; nothing of it is a result."""

    def __init__(self, *, time: float, place: Array, speed: float, step: float) -> None:
        self.time, self.place, self.speed, self.step = time, place, speed, step
        self.iterations, self.residual, self.tolerance = 0, np.inf, 0.0  # no iteration converged
        FembearingError.__init__(
            self,
            f"the cage's motion came apart at {time:.6g} s: centre at ({', '.join(f'{p:.3g}' for p in place)}) m, "
            f"speed {speed:.3g} m/s, with a step of {step:.3g} s. Raise cage.steps_per_contact, or check stiffness, "
            "mass and speed of the cage",
        )


@dataclass(frozen=True, kw_only=True)
class MeanMotion:
    """A part of a motion: means over its time, and the largest force of one contact.

    Of free balls, ball_power and ring_power less all losses become kinetic energy; of prescribed balls nothing about
    the raceways is known, and what says it is 0.
    """

    duration: float  # s
    slip_power: float  # of friction in the pockets, W
    land_power: float  # of friction at the land, W
    damping_power: float  # lost in impacts, W
    drag_power: float  # of the oil around the cage, W
    ball_power: float  # from the balls to the cage, W
    ring_power: float  # from the inner ring to the balls, W
    race_power: float  # of slip in the contacts with both raceways, W
    alone_power: float  # the same of these balls without a cage, at full speed, W
    numerical_power: float  # lost by the implicit steps of the balls, W
    force: float  # sum of the normal forces in the pockets, N
    moment: float  # of the balls on the cage about z, N m
    circling: float  # angular speed of the cage centre about z, rad/s
    place: tuple[float, float]  # x and y of the cage centre, m
    distance: float  # of the cage centre from z, m
    place_deviation: float  # root mean square distance of the cage centre from its mean place, m
    distance_deviation: float  # root mean square deviation of the distance from z, m
    tilt: float  # root mean square angle between the axes of cage and bearing, rad
    max_force: float  # largest normal force of one ball on one shell, N
    grip: float  # largest traction along the orbit over its limit, of one ball on one raceway


def _cage_constants(cage: DrivenCage, ramp: float) -> np.void:
    """CAGE; ramp : time in which all speeds rise, s, 0: full speed at once."""
    axial, transverse = cage.inertia
    land, surface = cage.land, abs(cage.ball_speed) * cage.ball_radius
    values: dict[str, Any] = {
        "mass": cage.mass,
        "inverse_mass": 1 / cage.mass,
        "inverse_axial_inertia": 1 / axial,
        "inverse_transverse_inertia": 1 / transverse,
        "pitch_radius": cage.pitch_radius,
        "ball_radius": cage.ball_radius,
        "drag": cage.drag,
        "half_clearance": cage.half_clearance,
        "centre_offset": cage.centre_offset,
        "stiffness": cage.stiffness,
        "sheet_softness": cage.sheet_softness,
        "damping": impact_damping(cage.restitution),
        "least_impact": LEAST_IMPACT,
        "friction": cage.friction_coefficient,
        "smoothing": min(cage.smoothing, SHARPEST * surface) if surface > 0 else cage.smoothing,
        "orbit_speed": cage.orbit_speed,
        # Against the orbit, about an axis that leans inward: the ball rolls on the outer race.
        "spin_axial": -cage.ball_speed * np.cos(cage.contact_angle),
        "spin_radial": cage.ball_speed * np.sin(cage.contact_angle),
        "lead": cage.ball_lead / cage.pitch_radius,
        "ramp": ramp,
        "deepest": DEEPEST * cage.ball_radius,
        "gravity": cage.gravity,
        "axial_pockets": cage.pocket_axis == "axial",
    }
    if land is not None:
        values["land_radius"], values["land_half_clearance"] = land.radius, land.half_clearance
        values["land_side"], values["land_speed"] = 1.0 if land.outside else -1.0, land.speed
        values["land_half_width"] = land.half_width
    return _record(CAGE, **values)


def _record(dtype: np.dtype[np.void], **values: Any) -> np.void:
    """One record; fields that are not given are 0."""
    made = np.zeros(1, dtype)
    for name, value in values.items():
        made[name] = value
    return made[0]


class CageMotion:
    """A motion that `advance` continues.

    cage : what moves
    raceways : on which the balls move freely; None: their motion is prescribed. `orbit_speed` and `ball_lead` of the
        cage then follow from the raceways
    begin : `rest`: the cage hangs on its balls and turns with them. `ramp`: it hangs on its balls at standstill, and
        all speeds rise evenly over the time `ramp`. `sudden`: it is at standstill in the middle of its clearance, and
        the balls run at full speed. `whirl`: it rolls in its pockets. But for `ramp` free balls begin as they run
        without a cage
    seed : of a small disturbance of the beginning; None: undisturbed
    ramp : s;  steps_per_contact : steps in the shortest impact to expect, which set the accuracy in time
    Raises InputError for impossible arguments; with free balls also for a cage and raceways of different speed, for a
    given lead of the balls, and for fewer than LEAST_STEPS steps per contact, and SingularError if a ball alone on its
    raceways does not settle.
    """

    def __init__(
        self,
        cage: DrivenCage,
        raceways: Raceways | None = None,
        *,
        begin: CageStart,
        seed: int | None = None,
        ramp: float = 0.0,
        steps_per_contact: float = Cage.steps_per_contact,
    ) -> None:
        require_positive(steps_per_contact=steps_per_contact)
        require_non_negative(ramp=ramp)
        if begin not in ("rest", "ramp", "sudden", "whirl"):
            raise InputError(f'start must be "rest", "ramp", "sudden" or "whirl", got {begin!r}')
        if begin == "ramp" and not ramp > 0:
            raise InputError('start "ramp" needs the time over which the speeds rise, above 0')
        self.cage, self.raceways = cage, raceways
        self._balls = np.zeros(cage.ball_count, BALL)
        azimuth = 2 * np.pi * np.arange(cage.ball_count) / cage.ball_count
        self._balls["pocket_cosine"], self._balls["pocket_sine"] = np.cos(azimuth), np.sin(azimuth)
        self._on_raceways, self._table = _record(BALL_ON_RACEWAYS), np.zeros(0, AZIMUTH)
        beginning = cage
        if raceways is not None:
            _require_free_balls(cage, raceways, steps_per_contact)
            self.cage = replace(cage, orbit_speed=raceways.alone.orbit_speed)
            beginning = self._free_the_balls(raceways, at_full_speed=begin != "ramp")
        self._first_azimuth = self._balls["azimuth"].copy()
        self.step = min(self._contact_time / steps_per_contact, LONGEST_STEP)
        self._constants = _cage_constants(self.cage, ramp if begin == "ramp" else 0.0)
        self._state = _record(STATE, orientation=[1.0, 0.0, 0.0, 0.0])
        self._place(beginning, begin)
        if seed is not None:
            random = np.random.default_rng(seed)
            self._state["place"] += DISTURBANCE * cage.half_clearance * random.uniform(-1, 1, 3)
            self._state["velocity"] += DISTURBANCE * cage.impact_speed * random.uniform(-1, 1, 3)

    def advance(self, duration: float) -> MeanMotion:
        """Continue the motion for the duration, at least by one step.

        duration : s, > 0
        Raises MotionError if the motion diverges; with free balls also InputError if an impact was too hard for the
        steps, and SingularError if the speeds of a ball did not settle in a step.
        """
        require_positive(duration=duration)
        steps = max(1, round(duration / self.step))
        totals, time = self._go(steps), steps * self.step
        if totals["unsettled"]:
            raise SingularError(
                problem=f"the speeds of balls between races and cage did not converge {totals['unsettled']:.0f} times "
                f"in {time:.3g} s",
                remedy="Raise cage.steps_per_contact, or the friction of the races",
            )
        if self.raceways is not None:
            self._require_fine_steps(self.raceways, float(totals["max_force"]))
        x, y, distance, distance_square, tilt_square = (
            totals[name] / time for name in ("x", "y", "distance", "distance_square", "tilt_square")
        )
        return MeanMotion(
            duration=time,
            place=(x, y),
            distance=distance,
            place_deviation=float(np.sqrt(max(distance_square - x**2 - y**2, 0.0))),
            distance_deviation=float(np.sqrt(max(distance_square - distance**2, 0.0))),
            tilt=float(np.sqrt(tilt_square)),
            max_force=totals["max_force"],
            grip=totals["grip"],
            **{name: totals[name] / time for name, _ in INTEGRALS},
        )

    def forces(self) -> Array:
        """(Z, 3) N: the present force of each ball on the cage."""
        self._go(0)
        return self._balls["force"].copy()

    @property
    def time(self) -> float:
        return float(self._state["time"])

    @property
    def centre(self) -> Array:
        """(3,) m: from the centre of the bearing to that of the cage."""
        return self._state["place"].copy()

    @property
    def velocity(self) -> Array:
        """(3,) m/s: of the cage centre."""
        return self._state["velocity"].copy()

    @property
    def orientation(self) -> Array:
        """(3, 3): the columns are the axes of the cage in the fixed frame."""
        from scipy.spatial.transform import Rotation  # a tenth of a second to import

        return Rotation.from_quat(self._state["orientation"], scalar_first=True).as_matrix()

    @property
    def angular_velocity(self) -> Array:
        """(3,) rad/s, in the fixed frame."""
        axial, transverse = self.cage.inertia
        axis, momentum = self.orientation[:, 2], self._state["momentum"]
        return momentum / transverse + axis * (axis @ momentum) * (1 / axial - 1 / transverse)

    @property
    def ball_angle(self) -> float:
        """Mean angle through which the balls have orbited, rad."""
        if self.raceways is None:
            return float(self._state["orbit_angle"])
        return float(np.mean(self._balls["azimuth"] - self._first_azimuth))

    @property
    def ball_angles(self) -> Array:
        """(Z,) rad: azimuths of free balls, which go on growing."""
        return self._balls["azimuth"].copy()

    @property
    def ball_speeds(self) -> Array:
        """(Z, 4) m/s of free balls: r_m w_c, r w_phi, r w_rho and r w_z, see `analytic.cage.raceways`."""
        return np.stack([self._balls[name] for name in SPEEDS], axis=1)

    @property
    def offsets(self) -> Array:
        """(Z, 3) m: from the centre of each pocket to that of its ball, in the fixed frame."""
        if self.raceways is None:
            places = self.cage.ball_places(self.ball_angle)
        else:
            angle = self._balls["azimuth"]
            places = self.cage.pitch_radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
        return places - (self.centre + self.cage.pocket_places @ self.orientation.T)

    @property
    def kinetic_energy(self) -> float:
        """Of the cage, and of free balls, J."""
        turning = self._state["momentum"] @ self.angular_velocity
        of_cage = float(self.cage.mass * self.velocity @ self.velocity + turning) / 2
        if self.raceways is None:
            return of_cage
        squares = np.sum(self.ball_speeds**2, axis=0)
        return of_cage + self.raceways.bearing.ball_mass / 2 * float(squares @ [1.0, 0.4, 0.4, 0.4])

    def launch(self, *, velocity: Array, angular_velocity: Array) -> None:
        """Give the cage another velocity, (3,) m/s, and angular velocity, (3,) rad/s."""
        axial, transverse = self.cage.inertia
        axis = self.orientation[:, 2]
        self._state["velocity"] = velocity
        about_axis = axis * (axis @ angular_velocity)
        self._state["momentum"] = axial * about_axis + transverse * (np.asarray(angular_velocity) - about_axis)

    def _free_the_balls(self, raceways: Raceways, *, at_full_speed: bool) -> DrivenCage:
        """Give the balls the places, and speeds, that they have without a cage; returns the cage with their lead."""
        cage, alone = self.cage, raceways.alone
        self._on_raceways, self._table = raceways.constants, raceways.table.copy()
        self._table["slip_without_cage"] = alone.slip_power
        # Half the clearance is the cage's to give way, so balls that lead by more than a whole one start with that.
        room = NARROW * lead_room(
            half_clearance=cage.half_clearance,
            centre_offset=cage.centre_offset,
            land_half_clearance=np.inf if cage.land is None else cage.land.half_clearance,
        )
        leading = replace(cage, ball_lead=float(np.clip(alone.lead, -room, room)))
        places = leading.ball_places(0.0)
        azimuth = np.arctan2(places[:, 1], places[:, 0]) % (2 * np.pi)
        self._balls["azimuth"], self._balls["contacts"] = azimuth, self._table[0]
        if at_full_speed:
            grid = 2 * np.pi * np.arange(len(alone.speeds)) / len(alone.speeds)
            for name, speed in zip(SPEEDS, alone.speeds.T, strict=True):
                self._balls[name] = np.interp(azimuth, grid, speed, period=2 * np.pi)
        return leading

    def _place(self, cage: DrivenCage, begin: CageStart) -> None:
        """Set the place and the velocities with which the motion begins; cage : with the lead of its balls."""
        from scipy.spatial.transform import Rotation

        turning = np.array([0.0, 0.0, cage.orbit_speed])
        pull = np.linalg.norm(cage.gravity)
        self._state["place"] = cage.middle
        if begin == "whirl":
            outward = np.array([1.0, 0.0, 0.0])
            distance = cage.free_path(outward)
            self._state["place"] += distance * outward
            circling = cage.orbit_speed + whirl_speed(
                ball_speed=cage.ball_speed,
                ball_radius=cage.ball_radius,
                contact_angle=cage.contact_angle,
                half_clearance=distance,
            )
            self.launch(velocity=np.array([0.0, circling * distance, 0.0]), angular_velocity=turning)
        elif begin != "sudden":
            if pull > 0:
                # Friction of the rotating balls holds the cage off the vertical; at standstill it swings from there.
                leaning = np.arctan(cage.friction_coefficient) * np.sign(cage.ball_speed)
                down = Rotation.from_rotvec([0.0, 0.0, leaning]).apply(np.array(cage.gravity) / pull)
                load = cage.mass * pull / cage.ball_count
                sag = (load / cage.stiffness) ** (2 / 3) + load * cage.sheet_softness
                self._state["place"] += down * (cage.free_path(down) + sag)
            if begin == "rest":
                self.launch(velocity=np.zeros(3), angular_velocity=turning)

    @property
    def _contact_time(self) -> float:
        """Duration of the shortest impact to expect; a free ball can give way, but counts as if it could not, s."""
        cage = self.cage
        if self.raceways is None or not cage.impact_speed > 0:
            return cage.contact_time
        mass = _impact_mass(cage, self.raceways)
        return impact(mass=mass, speed=cage.impact_speed, stiffness=cage.stiffness).duration

    def _require_fine_steps(self, raceways: Raceways, force: float) -> None:
        """Raise InputError if the hardest impact, with this force, N, had too few steps."""
        contact = 1.5 * np.cbrt(self.cage.stiffness**2 * max(force, 1e-300))
        softness = 1 / contact + self.cage.sheet_softness
        steps = float(np.pi * np.sqrt(_impact_mass(self.cage, raceways) * softness)) / self.step
        if steps < LEAST_STEPS_SEEN:
            raise InputError(
                f"an impact of {force:.3g} N had {steps:.2g} steps: the stiffness of the pocket needs "
                f"{LEAST_STEPS_SEEN} or more; raise cage.steps_per_contact {LEAST_STEPS_SEEN / steps:.2g} times"
            )

    def _go(self, steps: int) -> np.void:
        """The TOTALS of some steps."""
        totals = _record(TOTALS)
        done = advance(
            self._constants, self._on_raceways, self._table, self._balls, self._state, totals, self.step, steps
        )
        ends = [self._state[name] for name in STATE.names or ()] + [totals[name] for name in TOTALS.names or ()]
        if done < steps or not all(np.all(np.isfinite(end)) for end in ends):
            raise MotionError(
                time=self.time, place=self.centre, speed=float(np.linalg.norm(self.velocity)), step=self.step
            )
        return totals


def _impact_mass(cage: DrivenCage, raceways: Raceways) -> float:
    """Of an impact between the cage and a free ball, kg."""
    return 1 / (max(cage.ball_count, 3) / cage.mass + 1 / raceways.bearing.ball_mass)


def _require_free_balls(cage: DrivenCage, raceways: Raceways, steps_per_contact: float) -> None:
    if not np.isclose(cage.ring_speed, raceways.inner_speed, rtol=1e-9):
        raise InputError(
            f"the cage belongs to a ring at {cage.ring_speed!r} rad/s and the races to one at "
            f"{raceways.inner_speed!r} rad/s: take both at one operating point"
        )
    if cage.ball_lead != 0:
        raise InputError(
            f"ball_lead = {cage.ball_lead!r} m says where the balls run, and free balls lead and lag by what their "
            "races do: give 0"
        )
    if steps_per_contact < LEAST_STEPS:
        raise InputError(
            f"steps_per_contact = {steps_per_contact!r} is too coarse for the stiffness of the pocket: free balls "
            f"need {LEAST_STEPS} or more, {Cage.steps_per_contact} are usual"
        )
