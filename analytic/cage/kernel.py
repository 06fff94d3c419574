"""The compiled loop of the cage's motion; `analytic.cage.motion` says what it solves.

Only `analytic.cage.motion` imports it, on demand, because LLVM is slow to import. Everything is in the fixed frame, z
is the axis of the bearing.
One step is half a kick by the loads, the exact motion of a free ring, and half a kick by the loads at its end. There,
friction and damping take the velocities that the previous loads would give. The method is of second order, and
symplectic without losses.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.cage.law import (
    FAST,
    Ball,
    Flight,
    Law,
    Vector,
    body_of,
    flown,
    guided,
    kicked,
    loose,
    pushed,
    risen,
    rotation,
)
from analytic.numerics.compilation import compiled

# The state: place, velocity, quaternion (scalar first), angular momentum, time and angle of the orbit.
STATE = 15
# The sums of a call: impulse of the moments about z; energy lost by slip in pockets, by slip at the land, by damping
# and by drag; work of the balls on the cage; integral of the normal forces; angle through which the centre circled z;
# integrals of its distance, of its distance squared, of x and of y; and the largest normal force of one contact.
TALLY = 13
LARGEST = TALLY - 1


class Orbit(NamedTuple):
    """Where the balls are and how fast they move."""

    cosine: float  # of the angle of the orbit
    sine: float
    scale: float  # of all speeds, 0 to 1, as they rise


class Loads(NamedTuple):
    """What acts on the cage at one instant; powers in W, forces in N."""

    force: Vector
    moment: Vector
    ball_moment: float  # of the balls about z, through the centre of the cage
    slip: float  # power lost by friction in the pockets
    land_slip: float  # at the land
    damping: float  # in impacts
    drag: float  # in the oil around the cage
    given: float  # power of the balls on the cage
    pressed: float  # sum of the normal forces in the pockets
    largest: float  # of these forces
    deepest: float  # penetration, m


@compiled(fastmath=FAST, inline=True)
def _loads(law, azimuth, touch, now, body, drive):
    """Loads on the Body by balls that an Orbit describes; azimuth, touch and now as in `advance`."""
    x, y, z = body.place
    xx, xy, xz, yx, yy, yz, zx, zy, zz = body.rotation
    cosine, sine, scale = drive
    fx, fy, fz = law.mass * law.gravity_x, law.mass * law.gravity_y, law.mass * law.gravity_z
    mx = my = mz = slip = damped = given = pressed = largest = deepest = 0.0
    orbit, pitch = law.orbit_speed * scale, law.pitch_radius
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
        offset, axis = (ux, uy, uz), (ex, ey, ez)
        if loose(law, offset, axis):
            touch[ball, 0] = touch[ball, 1] = 0.0
            continue
        push = pushed(
            law,
            Ball(
                offset,
                axis,
                (pitch * bc - x, pitch * bs - y, -z),
                (-rate * pitch * bs, rate * pitch * bc, 0.0),
                (law.spin_radial * scale * bc, law.spin_radial * scale * bs, law.spin_axial * scale + rate),
            ),
            body,
            touch,
            ball,
        )
        fx, fy, fz = fx + push.force[0], fy + push.force[1], fz + push.force[2]
        mx, my, mz = mx + push.moment[0], my + push.moment[1], mz + push.moment[2]
        slip += push.slip
        damped += push.damping
        given += push.given
        pressed += push.pressed
        largest = max(largest, push.largest)
        deepest = max(deepest, push.deepest)
        if now.shape[0] > 0:
            now[ball, 0] += push.force[0]
            now[ball, 1] += push.force[1]
            now[ball, 2] += push.force[2]
    guide = guided(law, body, scale)
    return Loads(
        (fx + guide.force[0], fy + guide.force[1], fz + guide.force[2]),
        (mx + guide.moment[0], my + guide.moment[1], mz + guide.moment[2]),
        mz,
        slip,
        guide.slip,
        damped,
        guide.drag,
        given,
        pressed,
        largest,
        max(deepest, guide.deepest),
    )


@compiled(fastmath=FAST)
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
    flight = Flight((x, y, z), (vx, vy, vz), (a, b, c, d), (lx, ly, lz))
    none = now[:0]
    half = 0.5 * step
    moment = slip = land = damping = drag = given = pressed = winding = distance = square = place_x = place_y = 0.0
    largest = tally[LARGEST]
    force, twist = (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)
    r = rotation(flight.orientation)
    scale = risen(time, law.ramp)
    done = 0
    for done in range(steps + 1):
        if done > 0:
            flight = flown(law, kicked(law, flight, force, twist, half), r, step)
            time += step
            before, scale = scale, risen(time, law.ramp)
            angle += half * (before + scale) * law.orbit_speed
            r = rotation(flight.orientation)
        # Friction and damping see the velocities that the previous loads would give. At first there are none.
        body = body_of(law, kicked(law, flight, force, twist, half), r)
        orbit = Orbit(np.cos(angle), np.sin(angle), scale)
        loads = _loads(law, azimuth, touch, now if done == steps else none, body, orbit)
        force, twist = loads.force, loads.moment
        if done == 0:
            continue
        flight = kicked(law, flight, force, twist, half)
        (x, y, z), (vx, vy, vz) = flight.place, flight.velocity
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
    ends = (*flight.place, *flight.velocity, *flight.orientation, *flight.momentum, time, angle)
    for index, value in enumerate(ends):
        state[index] = value
    return done
