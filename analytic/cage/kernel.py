"""The compiled loop of the cage's motion. Compiled on first use and kept; `analytic.cage.motion` says what it solves.

Loaded on demand, for numba is: nothing else here imports it. Everything is in the fixed frame, z the bearing's axis.
One step is a kick by the loads, the exact motion of a free ring, and a kick by the loads at its end, whose friction and
damping take the speeds that the loads of before would give: second order, and without losses symplectic.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from numba import njit
from numpy.typing import NDArray

# NaN and infinity keep their meaning: the loop tests for them.
FAST = {"contract", "reassoc", "arcp", "nsz", "afn"}
SATURATED = 20.0  # |v|/v0 from where tanh is 1 in double precision

# The state: position, velocity, quaternion (scalar first), angular momentum, time and angle of the orbit.
STATE = 15
# What a call adds up: impulse of the moments about z, works by slip in pockets and at the land, of damping, of drag and
# of the balls on the cage, integral of the normal forces, angle about the axis that the centre went, integrals of its
# distance, of the distance squared, of x and of y; and the largest normal force of one contact in a pocket.
TALLY = 13
MOMENT, SLIP, LAND_SLIP, DAMPING, DRAG, BALLS, FORCE, WINDING, DISTANCE, SQUARE, PLACE_X, PLACE_Y, LARGEST = range(
    TALLY
)


class Law(NamedTuple):
    """Constants of the cage, its balls and their contacts, SI."""

    mass: float
    axial_inertia: float
    transverse_inertia: float
    pitch_radius: float
    ball_radius: float
    room: float
    centre_offset: float
    axial_pockets: bool
    stiffness: float
    damping: float
    least_impact: float  # v0 of the damping: an impact slower than this counts as so fast
    friction: float
    smoothing: float
    gravity_x: float
    gravity_y: float
    gravity_z: float
    drag: float
    orbit_speed: float
    spin_axial: float  # of a ball relative to the orbit: along z, and outward
    spin_radial: float
    lead: float  # rad
    ramp: float  # s; 0: full speed at once
    land_radius: float  # 0: no land
    land_room: float
    land_side: float  # of the contact, seen from the axis along the cage's displacement: -1 at the bore, +1 outside
    land_speed: float
    land_half_width: float
    deepest: float  # penetration at which the motion has come apart, m


def _kept(function: Callable[..., int]) -> Callable[..., int]:
    """Compiled for good; for this run alone where no folder takes it, as in a read-only installation without a home."""
    try:
        return njit(cache=True, fastmath=FAST)(function)
    except RuntimeError:
        return njit(fastmath=FAST)(function)


@njit(fastmath=FAST, inline="always")
def _loads(law, azimuth, touch, now, x, y, z, vx, vy, vz, r, wx, wy, wz, cosine, sine, scale):
    """Force and moment on the cage, and what they tell of; r: rotation matrix by rows."""
    xx, xy, xz, yx, yy, yz, zx, zy, zz = r
    fx, fy, fz = law.mass * law.gravity_x, law.mass * law.gravity_y, law.mass * law.gravity_z
    mx = my = mz = slip = damped = given = pressed = largest = deepest = 0.0
    orbit = law.orbit_speed * scale
    room, offset, radius, pitch = law.room, law.centre_offset, law.ball_radius, law.pitch_radius
    reach = room * room
    shells = 1 if offset == 0.0 else 2
    # Ball less pocket: both lie on circles of one radius, so that only the difference of two rotations is left.
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
            depth = distance - room
            facing = shells == 1 or side * place > 0.0
            if depth <= 0.0 or not facing:
                touch[ball, shell] = 0.0
                continue
            nx, ny, nz = nx / distance, ny / distance, nz / distance
            # Surface of the ball: centre on its orbit, and its own turning.
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
    turning = mz  # of the balls on the cage, about an axis through its centre
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
            depth = distance - law.land_room
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
    return fx, fy, fz, mx, my, mz, turning, slip, rubbing, damped, dragged, given, pressed, largest, deepest


@njit(fastmath=FAST, inline="always")
def _turned(a, b, c, d):
    """Rotation matrix of a quaternion of length 1, by rows."""
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
    """Of all speeds, as they rise."""
    return time / ramp if time < ramp else 1.0


@_kept
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
    """Go on by so many steps, in place; the number of steps done, fewer where the motion comes apart.

    azimuth : (Z, 2), cosine and sine of each pocket's place
    touch : (Z, 2), of each shell's contact the fastest at which it has closed since it began, m/s; 0 without
    now : (Z, 3), to which the forces of the balls at the end are added, or (0, 3) where nobody asks
    tally : (TALLY,), to which the step's share of each integral is added
    """
    x, y, z, vx, vy, vz, a, b, c, d, lx, ly, lz, time, angle = state
    none = now[:0]
    inverse, soft = 1.0 / law.mass, 1.0 / law.transverse_inertia
    excess = 1.0 / law.axial_inertia - soft
    half = 0.5 * step
    moment = slip = rubbing = damped = dragged = given = pressed = winding = far = square = place_x = place_y = 0.0
    largest = tally[LARGEST]
    fx = fy = fz = mx = my = mz = 0.0
    r = _turned(a, b, c, d)
    scale = _scale(time, law.ramp)
    done = 0
    for done in range(steps + 1):
        if done > 0:
            vx, vy, vz = vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz
            lx, ly, lz = lx + half * mx, ly + half * my, lz + half * mz
            x, y, z = x + step * vx, y + step * vy, z + step * vz
            # A free ring turns about its angular momentum, and about its own axis besides: both by Cayley's map, whose
            # error is the cube of an angle of some 1e-5.
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
            r = _turned(a, b, c, d)
        # Speeds that friction and damping see: those that the loads before would give. Nothing has loaded the first.
        kx, ky, kz = lx + half * mx, ly + half * my, lz + half * mz
        own = (r[2] * kx + r[5] * ky + r[8] * kz) * excess
        loads = _loads(
            law, azimuth, touch, now if done == steps else none, x, y, z,
            vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz, r,
            kx * soft + own * r[2], ky * soft + own * r[5], kz * soft + own * r[8],
            np.cos(angle), np.sin(angle), scale,
        )  # fmt: skip
        fx, fy, fz, mx, my, mz = loads[:6]
        if done == 0:
            continue
        vx, vy, vz = vx + half * inverse * fx, vy + half * inverse * fy, vz + half * inverse * fz
        lx, ly, lz = lx + half * mx, ly + half * my, lz + half * mz
        moment += loads[6]
        slip += loads[7]
        rubbing += loads[8]
        damped += loads[9]
        dragged += loads[10]
        given += loads[11]
        pressed += loads[12]
        largest = max(largest, loads[13])
        away = x * x + y * y
        if away > 0.0:
            winding += (x * vy - y * vx) / away
        far += np.sqrt(away)
        square += away
        place_x += x
        place_y += y
        if not loads[14] < law.deepest or not vx * vx + vy * vy + vz * vz < np.inf:
            break
    sums = (moment, slip, rubbing, damped, dragged, given, pressed, winding, far, square, place_x, place_y)
    for index in range(LARGEST):
        tally[index] += step * sums[index]
    tally[LARGEST] = largest
    for index, value in enumerate((x, y, z, vx, vy, vz, a, b, c, d, lx, ly, lz, time, angle)):
        state[index] = value
    return done
