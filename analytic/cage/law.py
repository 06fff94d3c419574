"""What both compiled loops of the cage's motion share: its constants, the forces on it, and its free flight.

`analytic.cage.kernel` moves the cage on balls whose motion is given, `analytic.cage.free_kernel` cage and balls
together. Both have the forces of a pocket, of a land and of drag from here. Everything is in the fixed frame, z is the
axis of the bearing.
"""

from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled

# NaN and infinity keep their meaning: the loops test for them.
FAST = frozenset(("contract", "reassoc", "arcp", "nsz", "afn"))
SATURATED = 20.0  # |v|/v0 from where tanh is 1 in double precision

Vector = tuple[float, float, float]


class Law(NamedTuple):
    """Constants of the cage, its balls and their contacts, SI."""

    mass: float
    axial_inertia: float
    transverse_inertia: float
    pitch_radius: float
    ball_radius: float
    half_clearance: float
    centre_offset: float
    axial_pockets: bool
    stiffness: float
    damping: float
    least_impact: float  # a slower impact is damped as if it had this speed
    friction: float
    smoothing: float
    gravity_x: float
    gravity_y: float
    gravity_z: float
    drag: float
    orbit_speed: float
    spin_axial: float  # of a ball relative to the orbit, along z
    spin_radial: float  # likewise, outward
    lead: float  # rad
    ramp: float  # time in which all speeds rise, s; 0: full speed at once
    land_radius: float  # 0: no land
    land_half_clearance: float
    land_side: float  # of the contact along the displacement of the cage: -1 at the bore of the cage, +1 outside
    land_speed: float
    land_half_width: float
    deepest: float  # penetration at which the motion has diverged, m


class Flight(NamedTuple):
    """Where the cage is and how it moves."""

    place: Vector
    velocity: Vector
    orientation: tuple[float, float, float, float]  # quaternion, scalar first
    momentum: Vector  # angular


class Body(NamedTuple):
    """The cage as its loads depend on it."""

    place: Vector
    velocity: Vector
    rotation: tuple[float, float, float, float, float, float, float, float, float]  # matrix by rows
    angular_velocity: Vector


class Ball(NamedTuple):
    """A ball as its pocket feels it."""

    offset: Vector  # from the centre of the pocket to that of the ball
    axis: Vector  # through the centres of both shells
    centre: Vector  # from the centre of the cage to that of the ball
    velocity: Vector  # of its centre
    rotation: Vector


class Push(NamedTuple):
    """What a ball does to its pocket; powers in W, forces in N."""

    force: Vector
    moment: Vector  # about the centre of the cage
    slip: float  # power lost by friction
    damping: float  # in impacts
    given: float  # power of the ball on the cage
    pressed: float  # sum of the normal forces on both shells
    largest: float  # of these forces
    deepest: float  # penetration, m


class Guidance(NamedTuple):
    """What drag and land do to the cage."""

    force: Vector
    moment: Vector
    drag: float  # power lost in the oil around the cage
    slip: float  # power lost at the land
    deepest: float  # penetration, m


@compiled(fastmath=FAST, inline=True)
def loose(law, offset, axis):
    """Whether a ball touches neither shell; offset, axis : as in Ball."""
    ux, uy, uz = offset
    along = ux * axis[0] + uy * axis[1] + uz * axis[2]
    reach = law.half_clearance * law.half_clearance
    return ux * ux + uy * uy + uz * uz + law.centre_offset * (2.0 * abs(along) + law.centre_offset) <= reach


@compiled(fastmath=FAST, inline=True)
def _against(law, ball, body, touch, row, shell):
    """Push of a Ball on one shell of its pocket."""
    ux, uy, uz = ball.offset
    ex, ey, ez = ball.axis
    cx, cy, cz = ball.centre
    bx, by, bz = ball.velocity
    tx, ty, tz = ball.rotation
    vx, vy, vz = body.velocity
    wx, wy, wz = body.angular_velocity
    clearance, radius = law.half_clearance, law.ball_radius
    aside = law.centre_offset if shell == 0 else -law.centre_offset
    nx, ny, nz = ux + aside * ex, uy + aside * ey, uz + aside * ez
    distance = np.sqrt(nx * nx + ny * ny + nz * nz)
    depth = distance - clearance
    # Each shell is a half sphere.
    facing = aside == 0.0 or aside * (ux * ex + uy * ey + uz * ez + aside) > 0.0
    if depth <= 0.0 or not facing:
        touch[row, shell] = 0.0
        return Push((0.0, 0.0, 0.0), (0.0, 0.0, 0.0), 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)
    nx, ny, nz = nx / distance, ny / distance, nz / distance
    # Velocity of the ball's surface: that of its centre, and its own rotation.
    sx, sy, sz = (
        bx + radius * (ty * nz - tz * ny),
        by + radius * (tz * nx - tx * nz),
        bz + radius * (tx * ny - ty * nx),
    )
    px, py, pz = cx + radius * nx, cy + radius * ny, cz + radius * nz
    gx, gy, gz = sx - vx - wy * pz + wz * py, sy - vy - wz * px + wx * pz, sz - vz - wx * py + wy * px
    closing = gx * nx + gy * ny + gz * nz
    touch[row, shell] = max(touch[row, shell], closing, law.least_impact)
    elastic = law.stiffness * depth * np.sqrt(depth)
    normal = max(elastic * (1.0 + law.damping * closing / touch[row, shell]), 0.0)
    gx, gy, gz = gx - closing * nx, gy - closing * ny, gz - closing * nz
    speed = np.sqrt(gx * gx + gy * gy + gz * gz)
    per_speed = law.friction * normal
    if speed < SATURATED * law.smoothing:
        ratio = speed / law.smoothing
        per_speed *= np.tanh(ratio) / speed if ratio > 1e-8 else 1.0 / law.smoothing
    else:
        per_speed /= speed
    qx, qy, qz = normal * nx + per_speed * gx, normal * ny + per_speed * gy, normal * nz + per_speed * gz
    return Push(
        (qx, qy, qz),
        (py * qz - pz * qy, pz * qx - px * qz, px * qy - py * qx),
        per_speed * speed * speed,
        (normal - elastic) * closing,
        qx * sx + qy * sy + qz * sz,
        normal,
        normal,
        depth,
    )


@compiled(fastmath=FAST, inline=True)
def pushed(law, ball, body, touch, row):
    """Push of a Ball that is not loose on both shells of its pocket; row : of `touch`, which `advance` describes."""
    one = _against(law, ball, body, touch, row, 0)
    if law.centre_offset == 0.0:  # both shells are one sphere
        return one
    two = _against(law, ball, body, touch, row, 1)
    return Push(
        (one.force[0] + two.force[0], one.force[1] + two.force[1], one.force[2] + two.force[2]),
        (one.moment[0] + two.moment[0], one.moment[1] + two.moment[1], one.moment[2] + two.moment[2]),
        one.slip + two.slip,
        one.damping + two.damping,
        one.given + two.given,
        one.pressed + two.pressed,
        max(one.largest, two.largest),
        max(one.deepest, two.deepest),
    )


@compiled(fastmath=FAST, inline=True)
def guided(law, body, scale):
    """Guidance of a Body; scale : share of all speeds that is reached, 0 to 1."""
    x, y, _ = body.place
    vx, vy, vz = body.velocity
    wx, wy, wz = body.angular_velocity
    xz, yz, zz = body.rotation[2], body.rotation[5], body.rotation[8]
    fx = fy = fz = mx = my = mz = rubbing = dragged = deepest = 0.0
    if law.drag != 0.0:
        along = law.drag / (law.pitch_radius * law.pitch_radius)
        fx, fy, fz, mz = -along * vx, -along * vy, -along * vz, -law.drag * wz
        dragged = along * (vx * vx + vy * vy + vz * vz) + law.drag * wz * wz
    if law.land_radius != 0.0:
        for rim in range(2):
            half = law.land_half_width if rim == 0 else -law.land_half_width
            hx, hy = x + half * xz, y + half * yz
            distance = np.sqrt(hx * hx + hy * hy)
            depth = distance - law.land_half_clearance
            if depth <= 0.0:
                continue
            nx, ny = hx / distance, hy / distance
            arm = law.land_side * law.land_radius
            px, py, pz = arm * nx - x, arm * ny - y, half * zz
            surface = law.land_speed * scale * arm
            gx, gy = -surface * ny - vx - wy * pz + wz * py, surface * nx - vy - wz * px + wx * pz
            gz = -vz - wx * py + wy * px
            closing = gx * nx + gy * ny
            gx, gy = gx - closing * nx, gy - closing * ny
            speed = np.sqrt(gx * gx + gy * gy + gz * gz)
            normal = law.stiffness * depth * np.sqrt(depth)
            per_speed = law.friction * normal * (np.tanh(speed / law.smoothing) / speed if speed > 0.0 else 0.0)
            qx, qy, qz = -normal * nx + per_speed * gx, -normal * ny + per_speed * gy, per_speed * gz
            fx, fy, fz = fx + qx, fy + qy, fz + qz
            mx, my, mz = mx + py * qz - pz * qy, my + pz * qx - px * qz, mz + px * qy - py * qx
            rubbing += per_speed * speed * speed
            deepest = max(deepest, depth)
    return Guidance((fx, fy, fz), (mx, my, mz), dragged, rubbing, deepest)


@compiled(fastmath=FAST, inline=True)
def rotation(orientation):
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
def kicked(law, flight, force, moment, time):
    """The Flight after loads that act for a time."""
    x, y, z = flight.velocity
    lx, ly, lz = flight.momentum
    each = time * (1.0 / law.mass)
    return Flight(
        flight.place,
        (x + each * force[0], y + each * force[1], z + each * force[2]),
        flight.orientation,
        (lx + time * moment[0], ly + time * moment[1], lz + time * moment[2]),
    )


@compiled(fastmath=FAST, inline=True)
def flown(law, flight, r, step):
    """The Flight after a step without loads; r : its rotation matrix at the beginning.

    A free ring rotates about its angular momentum and about its own axis: both by Cayley's map, whose error is the cube
    of an angle of some 1e-5.
    """
    x, y, z = flight.place
    vx, vy, vz = flight.velocity
    a, b, c, d = flight.orientation
    lx, ly, lz = flight.momentum
    soft = 1.0 / law.transverse_inertia
    half = 0.5 * step
    turn = half * (r[2] * lx + r[5] * ly + r[8] * lz) * (1.0 / law.axial_inertia - soft)
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
def body_of(law, flight, r):
    """The Body of a Flight; r : its rotation matrix."""
    lx, ly, lz = flight.momentum
    soft = 1.0 / law.transverse_inertia
    own = (r[2] * lx + r[5] * ly + r[8] * lz) * (1.0 / law.axial_inertia - soft)
    return Body(
        flight.place, flight.velocity, r, (lx * soft + own * r[2], ly * soft + own * r[5], lz * soft + own * r[8])
    )


@compiled(fastmath=FAST, inline=True)
def risen(time, ramp):
    """Share of all speeds that is reached, 0 to 1."""
    return time / ramp if time < ramp else 1.0
