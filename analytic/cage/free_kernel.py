"""The compiled loop of cage and balls in motion; `analytic.cage.free_motion` says what it solves.

Only `analytic.cage.free_motion` imports it, on demand, because LLVM is slow to import. Everything is in the fixed
frame, z is the axis of the bearing.
The cage moves as in `analytic.cage.kernel`: half a kick, free flight, half a kick. A ball goes on with its speed along
the orbit. Then the races and the force of its pocket change its four speeds by one implicit step
(`analytic.cage.race_law`): the races hold a ball so stiffly that an explicit step would have to be ten times shorter.
A ball that its pocket does not touch takes one implicit step for `PATIENCE` of the cage's. The forces on cage and ball
are the same, so the momentum of both together changes by the races' tractions, weight, drag and land alone.
"""

import numpy as np
from numpy.typing import NDArray

from analytic.cage.law import (
    FAST,
    Ball,
    Flight,
    Law,
    body_of,
    flown,
    guided,
    kicked,
    loose,
    pushed,
    risen,
    rotation,
)
from analytic.cage.race_law import ALONE, RaceLaw, interpolated, rolled, seats
from analytic.numerics.compilation import compiled

PATIENCE = 16  # steps of the cage for one of a ball that is not touched

# A ball: angle of its place, rad; four speeds, m/s; time since its last step, s
BALL = 6
ANGLE, SPEEDS, WAITED = 0, slice(1, 5), 5
# The sums of a call: those of `analytic.cage.kernel` but for the largest force; then work of the inner ring; energy
# lost in the races' contacts, lost there by the same balls without a cage, and lost by the implicit method; integral of
# the tilt squared; and, not integrals, steps of balls that did not converge, largest normal force of one contact, and
# largest share of the races' grip.
TALLY = 20
UNSETTLED, LARGEST, GRIP = TALLY - 3, TALLY - 2, TALLY - 1


@compiled(fastmath=FAST, inline=True)
def _stepped(races, row, ball, force, span, scale):
    """Roll of a ball; force : of its pocket, outward, along z, and the impulse by its four speeds."""
    begin = (ball[1], ball[2], ball[3], ball[4])
    return rolled(races, seats(races, row, force[0], force[1], scale), begin, force[2], span, scale)


@compiled(fastmath=FAST)
def go_round(
    races: RaceLaw,
    table: NDArray[np.float64],
    ball: NDArray[np.float64],
    path: NDArray[np.float64],
    step: float,
) -> int:
    """Roll one ball that nothing but its races touches, at full speed; returns the number of steps that converged.

    table : (n, 2, FIELDS) of the races over a turn;  ball : (BALL,)
    path : (steps, 8), set to angle and speeds at the end of each step, and to the ring's work, slip and grip in it
    """
    row = table[0].copy()
    for index in range(path.shape[0]):
        ball[ANGLE] += step * ball[1] / races.pitch_radius
        interpolated(table, ball[ANGLE], row)
        roll = _stepped(races, row, ball, (0.0, 0.0, (0.0, 0.0, 0.0, 0.0)), step, 1.0)
        if not roll.settled:
            return index
        for speed in range(4):
            ball[1 + speed] = roll.speed[speed]
        for speed in range(5):
            path[index, speed] = ball[speed]
        path[index, 5], path[index, 6], path[index, 7] = roll.ring_work, roll.slip, roll.grip
    return path.shape[0]


@compiled(fastmath=FAST)
def advance(
    laws: tuple[Law, RaceLaw],
    azimuth: NDArray[np.float64],
    table: NDArray[np.float64],
    state: NDArray[np.float64],
    balls: NDArray[np.float64],
    touch: NDArray[np.float64],
    now: NDArray[np.float64],
    tally: NDArray[np.float64],
    step: float,
    steps: int,
) -> int:
    """Advance state and balls in place by steps of `step` seconds; returns the number of steps done, as it diverges.

    azimuth, state, touch, now : as for `analytic.cage.kernel`; the angle of the orbit is the mean of the balls'
    table : (n, 2, FIELDS) of the races over a turn;  balls : (Z, BALL)
    tally : (TALLY,), to which the sums over the steps are added
    """
    law, races = laws
    x, y, z, vx, vy, vz, a, b, c, d, lx, ly, lz, time, angle = state
    flight = Flight((x, y, z), (vx, vy, vz), (a, b, c, d), (lx, ly, lz))
    half, pitch = 0.5 * step, law.pitch_radius
    moment = slip = land = damping = drag = given = pressed = winding = distance = square = place_x = place_y = 0.0
    worked = race = alone = numerical = tilted = unsettled = 0.0
    largest, grip = tally[LARGEST], tally[GRIP]
    fx = fy = fz = mx = my = mz = 0.0
    r = rotation(flight.orientation)
    row = table[0].copy()
    done = 0
    for done in range(steps + 1):
        if done > 0:
            flight = flown(law, kicked(law, flight, (fx, fy, fz), (mx, my, mz), half), r, step)
            time += step
            r = rotation(flight.orientation)
        scale = risen(time, law.ramp)
        # Friction and damping see the velocities that the previous loads would give. At first there are none.
        body = body_of(law, kicked(law, flight, (fx, fy, fz), (mx, my, mz), half), r)
        x, y, z = flight.place
        fx, fy, fz = law.mass * law.gravity_x, law.mass * law.gravity_y, law.mass * law.gravity_z
        mx = my = mz = deepest = 0.0
        for index in range(azimuth.shape[0]):
            ball = balls[index]
            if done > 0:
                ball[ANGLE] += step * ball[1] / pitch
                ball[WAITED] += step
            c, s = azimuth[index, 0], azimuth[index, 1]
            bc, bs = np.cos(ball[ANGLE]), np.sin(ball[ANGLE])
            px, py, pz = r[0] * c + r[1] * s, r[3] * c + r[4] * s, r[6] * c + r[7] * s
            offset = (pitch * (bc - px) - x, pitch * (bs - py) - y, -pitch * pz - z)
            axis = (r[2], r[5], r[8]) if law.axial_pockets else (px, py, pz)
            impulse = (0.0, 0.0, 0.0, 0.0)
            radial = axial = 0.0
            if loose(law, offset, axis):
                touch[index, 0] = touch[index, 1] = 0.0
                if done == 0 or (ball[WAITED] < (PATIENCE - 0.5) * step and done < steps):
                    continue
            else:
                about, outward, turning = (
                    ball[2] / law.ball_radius,
                    ball[3] / law.ball_radius,
                    ball[4] / law.ball_radius,
                )
                push = pushed(
                    law,
                    Ball(
                        offset,
                        axis,
                        (pitch * bc - x, pitch * bs - y, -z),
                        (-ball[1] * bs, ball[1] * bc, 0.0),
                        (outward * bc - about * bs, outward * bs + about * bc, turning),
                    ),
                    body,
                    touch,
                    index,
                )
                qx, qy, qz = push.force
                fx, fy, fz = fx + qx, fy + qy, fz + qz
                mx, my, mz = mx + push.moment[0], my + push.moment[1], mz + push.moment[2]
                deepest = max(deepest, push.deepest)
                if done == steps and now.shape[0] > 0:
                    now[index, 0] += qx
                    now[index, 1] += qy
                    now[index, 2] += qz
                if done == 0:
                    continue
                moment += push.moment[2]
                slip += push.slip
                damping += push.damping
                given += push.given
                pressed += push.pressed
                largest = max(largest, push.largest)
                # On the ball: the opposite force, and its moment about the centre of the ball.
                ex, ey, ez = pitch * bc - x, pitch * bs - y, -z
                tx, ty, tz = (
                    ey * qz - ez * qy - push.moment[0],
                    ez * qx - ex * qz - push.moment[1],
                    ex * qy - ey * qx - push.moment[2],
                )
                lever = step / law.ball_radius
                impulse = (
                    step * (qx * bs - qy * bc),
                    lever * (ty * bc - tx * bs),
                    lever * (tx * bc + ty * bs),
                    lever * tz,
                )
                radial, axial = -qx * bc - qy * bs, -qz
            if table.shape[0] > 1:
                interpolated(table, ball[ANGLE], row)
            roll = _stepped(races, row, ball, (radial, axial, impulse), ball[WAITED], scale)
            ball[1], ball[2], ball[3], ball[4] = roll.speed
            alone += row[0, ALONE] * ball[WAITED]
            ball[WAITED] = 0.0
            worked += roll.ring_work
            race += roll.slip
            numerical += roll.numerical
            grip = max(grip, roll.grip)
            if not roll.settled:
                unsettled += 1.0
        guide = guided(law, body, scale)
        fx, fy, fz = fx + guide.force[0], fy + guide.force[1], fz + guide.force[2]
        mx, my, mz = mx + guide.moment[0], my + guide.moment[1], mz + guide.moment[2]
        if done == 0:
            continue
        flight = kicked(law, flight, (fx, fy, fz), (mx, my, mz), half)
        (x, y, z), (vx, vy, vz) = flight.place, flight.velocity
        land += guide.slip
        drag += guide.drag
        tilted += r[2] * r[2] + r[5] * r[5]
        away = x * x + y * y
        if away > 0.0:
            winding += (x * vy - y * vx) / away
        distance += np.sqrt(away)
        square += away
        place_x += x
        place_y += y
        if not max(deepest, guide.deepest) < law.deepest or not vx * vx + vy * vy + vz * vz < np.inf:
            break
    sums = (moment, slip, land, damping, drag, given, pressed, winding, distance, square, place_x, place_y)
    for index in range(len(sums)):
        tally[index] += step * sums[index]
    tally[12] += worked
    tally[13] += race
    tally[14] += alone
    tally[15] += numerical
    tally[16] += step * tilted
    tally[UNSETTLED] += unsettled
    tally[LARGEST], tally[GRIP] = largest, grip
    angle = 0.0
    for index in range(azimuth.shape[0]):
        angle += (balls[index, ANGLE] - 2.0 * np.pi * index / azimuth.shape[0]) / azimuth.shape[0]
    ends = (*flight.place, *flight.velocity, *flight.orientation, *flight.momentum, time, angle)
    for index, value in enumerate(ends):
        state[index] = value
    return done
