"""The compiled loop of the cage's motion; `analytic.cage.motion` says what it solves.

Compiled on first use and cached. Only `analytic.cage.motion` imports it, on demand, because numba is slow to import.
Everything is in the fixed frame, z is the axis of the bearing.
One step is half a kick by the loads, the exact motion of a free ring, and half a kick by the loads at its end. There,
friction and damping take the velocities that the previous loads would give. The method is of second order, and
symplectic without losses.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

# NaN and infinity keep their meaning: the loop tests for them.
FAST = {"contract", "reassoc", "arcp", "nsz", "afn"}
SATURATED = 20.0  # |v|/v0 from where tanh is 1 in double precision

# The state: place, velocity, quaternion (scalar first), angular momentum, time and angle of the orbit.
STATE = 15
# The sums of a call: impulse of the moments about z; energy lost by slip in pockets, by slip at the land, by damping
# and by drag; work of the balls on the cage; integral of the normal forces; angle through which the centre circled z;
# integrals of its distance, of its distance squared, of x and of y; and the largest normal force of one contact.
TALLY = 13
LARGEST = TALLY - 1


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


class Body(NamedTuple):
    """The cage as its loads depend on it."""

    place: tuple[float, float, float]
    velocity: tuple[float, float, float]
    rotation: tuple[float, float, float, float, float, float, float, float, float]  # matrix by rows
    angular_velocity: tuple[float, float, float]


class Orbit(NamedTuple):
    """Where the balls are and how fast they move."""

    cosine: float  # of the angle of the orbit
    sine: float
    scale: float  # of all speeds, 0 to 1, as they rise


class Loads(NamedTuple):
    """What acts on the cage at one instant; powers in W, forces in N."""

    force: tuple[float, float, float]
    moment: tuple[float, float, float]
    ball_moment: float  # of the balls about z, through the centre of the cage
    slip: float  # power lost by friction in the pockets
    land_slip: float  # at the land
    damping: float  # in impacts
    drag: float  # in the oil around the cage
    given: float  # power of the balls on the cage
    pressed: float  # sum of the normal forces in the pockets
    largest: float  # of these forces
    deepest: float  # penetration, m


def _compiled(function: Callable[..., int]) -> Callable[..., int]:
    """Compile and cache; without a cache where no folder is writable (a read-only installation without a home)."""
    try:
        return njit(cache=True, fastmath=FAST)(function)
    except RuntimeError:
        return njit(fastmath=FAST)(function)


@njit(fastmath=FAST, inline="always")
def _loads(law, azimuth, touch, now, body, drive):
    """Loads on the Body by balls that an Orbit describes; azimuth, touch and now as in `advance`."""
    x, y, z = body.place
    vx, vy, vz = body.velocity
    wx, wy, wz = body.angular_velocity
    xx, xy, xz, yx, yy, yz, zx, zy, zz = body.rotation
    cosine, sine, scale = drive
    fx, fy, fz = law.mass * law.gravity_x, law.mass * law.gravity_y, law.mass * law.gravity_z
    mx = my = mz = slip = damped = given = pressed = largest = deepest = 0.0
    orbit = law.orbit_speed * scale
    clearance, offset, radius, pitch = law.half_clearance, law.centre_offset, law.ball_radius, law.pitch_radius
    reach = clearance * clearance
    shells = 1 if offset == 0.0 else 2
    # Ball minus pocket: both lie on circles of one radius, so only the difference of two rotations remains.
    ax, ay, bx, by = pitch * (cosine - xx), pitch * (sine - yx), pitch * (-sine - xy), pitch * (cosine - yy)
    az, bz = -pitch * zx, -pitch * zy
    for ball in range(azimuth.shape[0]):
        c, s = azimuth[ball, 0], azimuth[ball, 1]
        ux, uy, uz = ax * c + bx * s - x, ay * c + by * s - y, az * c + bz * s - z
        rate = orbit
        bc, bs = cosine * c - sine * s, sine * c + cosine * s
        if law.lead != 0.0:
            ahead = law.lead * bs
            rate = orbit * (1.0 + law.lead * bc)
            turn_c, turn_s = np.cos(ahead), np.sin(ahead)
            led_c, led_s = bc * turn_c - bs * turn_s, bs * turn_c + bc * turn_s
            ux, uy = ux + pitch * (led_c - bc), uy + pitch * (led_s - bs)
            bc, bs = led_c, led_s
        if law.axial_pockets:
            ex, ey, ez = xz, yz, zz
        else:
            ex, ey, ez = xx * c + xy * s, yx * c + yy * s, zx * c + zy * s
        along = ux * ex + uy * ey + uz * ez
        if ux * ux + uy * uy + uz * uz + offset * (2.0 * abs(along) + offset) <= reach:
            touch[ball, 0] = touch[ball, 1] = 0.0
            continue
        for shell in range(shells):
            side = 1.0 if shell == 0 else -1.0
            place = along + side * offset
            nx, ny, nz = ux + side * offset * ex, uy + side * offset * ey, uz + side * offset * ez
            distance = np.sqrt(nx * nx + ny * ny + nz * nz)
            depth = distance - clearance
            facing = shells == 1 or side * place > 0.0
            if depth <= 0.0 or not facing:
                touch[ball, shell] = 0.0
                continue
            nx, ny, nz = nx / distance, ny / distance, nz / distance
            # Velocity of the ball's surface: that of its centre on the orbit, and its own rotation.
            tx, ty, tz = law.spin_radial * scale * bc, law.spin_radial * scale * bs, law.spin_axial * scale + rate
            sx = -rate * pitch * bs + radius * (ty * nz - tz * ny)
            sy = rate * pitch * bc + radius * (tz * nx - tx * nz)
            sz = radius * (tx * ny - ty * nx)
            px, py, pz = pitch * bc + radius * nx - x, pitch * bs + radius * ny - y, radius * nz - z
            gx, gy, gz = sx - vx - wy * pz + wz * py, sy - vy - wz * px + wx * pz, sz - vz - wx * py + wy * px
            closing = gx * nx + gy * ny + gz * nz
            touch[ball, shell] = max(touch[ball, shell], closing, law.least_impact)
            elastic = law.stiffness * depth * np.sqrt(depth)
            normal = max(elastic * (1.0 + law.damping * closing / touch[ball, shell]), 0.0)
            gx, gy, gz = gx - closing * nx, gy - closing * ny, gz - closing * nz
            speed = np.sqrt(gx * gx + gy * gy + gz * gz)
            per_speed = law.friction * normal
            if speed < SATURATED * law.smoothing:
                ratio = speed / law.smoothing
                per_speed *= np.tanh(ratio) / speed if ratio > 1e-8 else 1.0 / law.smoothing
            else:
                per_speed /= speed
            qx, qy, qz = normal * nx + per_speed * gx, normal * ny + per_speed * gy, normal * nz + per_speed * gz
            fx, fy, fz = fx + qx, fy + qy, fz + qz
            mx, my, mz = mx + py * qz - pz * qy, my + pz * qx - px * qz, mz + px * qy - py * qx
            slip += per_speed * speed * speed
            damped += (normal - elastic) * closing
            given += qx * sx + qy * sy + qz * sz
            pressed += normal
            largest = max(largest, normal)
            deepest = max(deepest, depth)
            if now.shape[0] > 0:
                now[ball, 0] += qx
                now[ball, 1] += qy
                now[ball, 2] += qz
    ball_moment = mz
    rubbing = dragged = 0.0
    if law.drag != 0.0:
        along = law.drag / (pitch * pitch)
        fx, fy, fz, mz = fx - along * vx, fy - along * vy, fz - along * vz, mz - law.drag * wz
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
    return Loads(
        (fx, fy, fz), (mx, my, mz), ball_moment, slip, rubbing, damped, dragged, given, pressed, largest, deepest
    )


@njit(fastmath=FAST, inline="always")
def _rotation(a, b, c, d):
    """Matrix of a quaternion of length 1, by rows."""
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


@njit(fastmath=FAST, inline="always")
def _scale(time, ramp):
    """Share of all speeds that is reached, 0 to 1."""
    return time / ramp if time < ramp else 1.0


@_compiled
def advance(
    law: Law,
    azimuth: NDArray[np.float64],
    state: NDArray[np.float64],
    touch: NDArray[np.float64],
    now: NDArray[np.float64],
    tally: NDArray[np.float64],
    step: float,
    steps: int,
) -> int:
    """Advance the state in place by steps of `step` seconds; returns the number of steps done, less if it diverges.

    azimuth : (Z, 2), cosine and sine of the place of each pocket
    touch : (Z, 2), for each shell the fastest closing speed of its contact since it began, m/s; 0 without contact
    now : (Z, 3), to which the forces of the balls at the end are added; (0, 3) where these are not needed
    tally : (TALLY,), to which the integrals over the steps are added
    """
    x, y, z, vx, vy, vz, a, b, c, d, lx, ly, lz, time, angle = state
    none = now[:0]
    inverse, soft = 1.0 / law.mass, 1.0 / law.transverse_inertia
    excess = 1.0 / law.axial_inertia - soft
    half = 0.5 * step
    moment = slip = land = damping = drag = given = pressed = winding = distance = square = place_x = place_y = 0.0
    largest = tally[LARGEST]
    fx = fy = fz = mx = my = mz = 0.0
    r = _rotation(a, b, c, d)
    scale = _scale(time, law.ramp)
    done = 0
    for done in range(steps + 1):
        if done > 0:
            vx, vy, vz = vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz
            lx, ly, lz = lx + half * mx, ly + half * my, lz + half * mz
            x, y, z = x + step * vx, y + step * vy, z + step * vz
            # A free ring rotates about its angular momentum and about its own axis: both by Cayley's map, whose error
            # is the cube of an angle of some 1e-5.
            turn = half * (r[2] * lx + r[5] * ly + r[8] * lz) * excess
            a, b, c, d = a - turn * d, b + turn * c, c - turn * b, d + turn * a
            px, py, pz = half * soft * lx, half * soft * ly, half * soft * lz
            a, b, c, d = (
                a - px * b - py * c - pz * d,
                b + px * a + py * d - pz * c,
                c + py * a + pz * b - px * d,
                d + pz * a + px * c - py * b,
            )
            length = 1.0 / np.sqrt(a * a + b * b + c * c + d * d)
            a, b, c, d = a * length, b * length, c * length, d * length
            time += step
            before, scale = scale, _scale(time, law.ramp)
            angle += half * (before + scale) * law.orbit_speed
            r = _rotation(a, b, c, d)
        # Friction and damping see the velocities that the previous loads would give. At first there are none.
        kx, ky, kz = lx + half * mx, ly + half * my, lz + half * mz
        own = (r[2] * kx + r[5] * ky + r[8] * kz) * excess
        body = Body(
            (x, y, z),
            (vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz),
            r,
            (kx * soft + own * r[2], ky * soft + own * r[5], kz * soft + own * r[8]),
        )
        orbit = Orbit(np.cos(angle), np.sin(angle), scale)
        loads = _loads(law, azimuth, touch, now if done == steps else none, body, orbit)
        fx, fy, fz = loads.force
        mx, my, mz = loads.moment
        if done == 0:
            continue
        vx, vy, vz = vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz
        lx, ly, lz = lx + half * mx, ly + half * my, lz + half * mz
        moment += loads.ball_moment
        slip += loads.slip
        land += loads.land_slip
        damping += loads.damping
        drag += loads.drag
        given += loads.given
        pressed += loads.pressed
        largest = max(largest, loads.largest)
        away = x * x + y * y
        if away > 0.0:
            winding += (x * vy - y * vx) / away
        distance += np.sqrt(away)
        square += away
        place_x += x
        place_y += y
        if not loads.deepest < law.deepest or not vx * vx + vy * vy + vz * vz < np.inf:
            break
    sums = (moment, slip, land, damping, drag, given, pressed, winding, distance, square, place_x, place_y)
    for index in range(LARGEST):
        tally[index] += step * sums[index]
    tally[LARGEST] = largest
    for index, value in enumerate((x, y, z, vx, vy, vz, a, b, c, d, lx, ly, lz, time, angle)):
        state[index] = value
    return done
