"""One ball on both races, compiled: tractions that grow with slip, and an implicit step of its four speeds.

The speeds are (r_m w_c, r w_phi, r w_rho, r w_z), m/s: along the orbit, and the ball's rotation in the directions of
the orbit, outward and along the bearing's axis; the rotation is absolute, the directions go round with the ball. A
contact with the normal n out of the ball and t x n along the orbit is divided into strips at y across the groove. With
the rotation W relative to the ring and h = r - y^2/2R a strip slides with
    s_phi = r_m (w_c - w_ring) + W_t h - W_n y,  s_t = -W_phi h
and carries mu times its share of the load times f(|s|/s_c) against the slip, with
    f(k) = (2/pi) (atan k + k/(1 + k^2)).
f is FASTSIM on a strip with Hertz's pressure, integrated in closed form: exact for slip that is uniform on the strip.
s_c is the creep of the race (`analytic.cage.races`). Slip by spin along a strip is left out.
Source: [Kalker1982], [Polach2005] for f; the balance of a ball is Euler's equation in directions that turn with w_c.
"""

from typing import NamedTuple

import numpy as np

from analytic.cage.law import FAST
from analytic.numerics.compilation import compiled
from analytic.numerics.root import cube_root

# In a 6205 under 1000 N: 4 give 2.5 times the torque of a whirling cage. 24 leave 0.2 % of it, 0.8 % of the torque of
# the races and 2 % of the lead of balls under radial load: slip changes its sign within a tenth of the width.
STRIPS = 24
# Gauss's rule in asin(y/b), in which a strip's share of the load, (3/4) cos^3, is smooth.
_places, _weights = np.polynomial.legendre.leggauss(STRIPS)
PLACE = np.sin(np.pi / 2 * _places)  # y/b
SHARE = 3 * np.pi / 8 * _weights * np.cos(np.pi / 2 * _places) ** 3
# atan(k)/k for k <= 1 as a polynomial in k^2: interpolated, with an error of 2e-13.
TERMS = 14
ARC = (
    np.polynomial.Chebyshev.interpolate(lambda u: np.arctan(np.sqrt(u)) / np.sqrt(u), TERMS, domain=[0, 1])
    .convert(kind=np.polynomial.Polynomial, domain=[-1, 1])
    .coef
)

LOAD, NORMAL_RHO, NORMAL_Z, WIDTH, CREEP, LOAD_BY_RHO, LOAD_BY_Z, ANGLE_BY_RHO, ANGLE_BY_Z, ALONE = range(10)
FIELDS = 10  # of a race at one azimuth, see `analytic.cage.races`
INNER, OUTER = 0, 1

MOST_ITERATIONS = 60
SETTLED = 0.02  # of s_c, Newton's last change: quadratic convergence leaves some 1e-4 of s_c
LARGEST_TURN = 0.1  # rad, of a contact's normal by the pocket's force

Four = tuple[float, float, float, float]


class RaceLaw(NamedTuple):
    """Constants of a ball and its races, SI."""

    ball_mass: float
    ball_radius: float
    pitch_radius: float
    ring_speed: float  # of the inner ring; the outer one stands still
    inner_friction: float
    outer_friction: float
    inner_hollow: float  # r/2R
    outer_hollow: float
    least_creep: float  # m/s, added to s_c: a ball that does not roll creeps too


class Seat(NamedTuple):
    """One ball on one race."""

    limit: float  # mu Q, N
    normal_rho: float  # out of the ball
    normal_z: float
    width: float  # b/r
    hollow: float  # r/2R
    creep: float  # s_c, m/s


class Traction(NamedTuple):
    """Of a race on a ball, by the speeds of the ball: force, N, and how it falls with them, N s/m (symmetric)."""

    force: Four
    fall: tuple[float, float, float, float, float, float, float, float, float, float]  # 00 01 02 03 11 12 13 22 23 33


class Roll(NamedTuple):
    """What a step does to a ball; energies in J."""

    speed: Four
    ring_work: float  # of the inner ring
    slip: float  # lost in both contacts
    numerical: float  # lost by the implicit method itself
    grip: float  # largest traction along the orbit over its limit, of both races
    settled: bool


@compiled(fastmath=FAST, inline=True)
def interpolated(table, angle, row):
    """Set the row, (2, FIELDS), to the table, (n, 2, FIELDS), at an azimuth."""
    points = table.shape[0]
    where = angle * (points / (2.0 * np.pi))
    floor = np.floor(where)
    part = where - floor
    first = int(floor) % points
    second = first + 1 if first + 1 < points else 0
    for race in range(2):
        for field in range(FIELDS):
            row[race, field] = (1.0 - part) * table[first, race, field] + part * table[second, race, field]


@compiled(fastmath=FAST, inline=True)
def _seat(friction, hollow, load, row, turn):
    """A Seat from its row, but for the least creep; turn : of the normal, rad."""
    rho, z = row[NORMAL_RHO], row[NORMAL_Z]
    turn = min(max(turn, -LARGEST_TURN), LARGEST_TURN)
    rho, z = rho - turn * z, z + turn * rho
    length = 1.0 / np.sqrt(rho * rho + z * z)
    size = cube_root(load)
    return Seat(friction * load, rho * length, z * length, row[WIDTH] * size, hollow, row[CREEP] * size)


@compiled(fastmath=FAST, inline=True)
def seats(races, row, radial, axial, scale):
    """Both seats of a ball under the force of its pocket, N.

    row : (2, FIELDS) at the azimuth of the ball;  scale : share of the ring's speed that is reached
    A race that the force unloads leaves its share to the other race.
    """
    inner, outer = row[INNER], row[OUTER]
    inner_load = inner[LOAD] + inner[LOAD_BY_RHO] * radial + inner[LOAD_BY_Z] * axial
    outer_load = outer[LOAD] + outer[LOAD_BY_RHO] * radial + outer[LOAD_BY_Z] * axial
    if inner_load < 0.0:
        inner_load, outer_load = 0.0, outer_load - inner_load
    elif outer_load < 0.0:
        inner_load, outer_load = inner_load - outer_load, 0.0
    outer_load = max(outer_load, 0.0)
    i = _seat(
        races.inner_friction,
        races.inner_hollow,
        inner_load,
        inner,
        inner[ANGLE_BY_RHO] * radial + inner[ANGLE_BY_Z] * axial,
    )
    o = _seat(
        races.outer_friction,
        races.outer_hollow,
        outer_load,
        outer,
        outer[ANGLE_BY_RHO] * radial + outer[ANGLE_BY_Z] * axial,
    )
    least = races.least_creep
    return (
        Seat(i.limit, i.normal_rho, i.normal_z, i.width, i.hollow, scale * i.creep + least),
        Seat(o.limit, o.normal_rho, o.normal_z, o.width, o.hollow, scale * o.creep + least),
    )


@compiled(fastmath=FAST)
def traction(seat, along, about, outward, axial):
    """Traction on a ball whose speeds relative to the ring are r_m (w_c - w_ring), r W_phi, r W_rho and r W_z."""
    n, m = seat.normal_rho, seat.normal_z
    turning, spinning = axial * n - outward * m, outward * n + axial * m  # r W_t, r W_n
    inverse = 1.0 / seat.creep
    f0 = f1 = ft = fn = 0.0
    d00 = d0t = d0n = dtt = dtn = dnn = d10 = d1t = d1n = d11 = 0.0
    for strip in range(STRIPS):
        y = seat.width * PLACE[strip]
        h = 1.0 - seat.hollow * y * y
        s, t = along + turning * h - spinning * y, -about * h
        u = (s * s + t * t) * inverse * inverse + 1e-24
        k = np.sqrt(u)
        steep = k > 1.0
        small = 1.0 / k if steep else k
        square = small * small
        arc = ARC[TERMS]
        for term in range(TERMS):
            arc = arc * square + ARC[TERMS - 1 - term]
        arc *= small
        arc = 0.5 * np.pi - arc if steep else arc
        rational = 1.0 / (1.0 + u)
        share = seat.limit * SHARE[strip] * (2.0 / np.pi) * inverse
        per_speed = share * (arc / k + rational)
        bend = (2.0 * share * rational * rational - per_speed) / u * inverse * inverse
        ss, st, tt = per_speed + bend * s * s, bend * s * t, per_speed + bend * t * t
        push, side = per_speed * s, per_speed * t
        f0 -= push
        ft -= push * h
        fn += push * y
        f1 += side * h
        d00 += ss
        d0t += ss * h
        d0n -= ss * y
        dtt += ss * h * h
        dtn -= ss * h * y
        dnn += ss * y * y
        d10 -= st * h
        d1t -= st * h * h
        d1n += st * h * y
        d11 += tt * h * h
    return Traction(
        (f0, f1, n * fn - m * ft, m * fn + n * ft),
        (
            d00,
            d10,
            n * d0n - m * d0t,
            m * d0n + n * d0t,
            d11,
            n * d1n - m * d1t,
            m * d1n + n * d1t,
            n * n * dnn - 2.0 * n * m * dtn + m * m * dtt,
            n * m * (dnn - dtt) + (n * n - m * m) * dtn,
            m * m * dnn + 2.0 * n * m * dtn + n * n * dtt,
        ),
    )


@compiled(fastmath=FAST, inline=True)
def _solved(a, b):
    """x of a x = b with four unknowns, by elimination without exchange: the symmetric part of a is positive."""
    (a00, a01, a02, a03), (a10, a11, a12, a13), (a20, a21, a22, a23), (a30, a31, a32, a33) = a
    b0, b1, b2, b3 = b
    p = 1.0 / a00
    q1, q2, q3 = a10 * p, a20 * p, a30 * p
    a11, a12, a13, b1 = a11 - q1 * a01, a12 - q1 * a02, a13 - q1 * a03, b1 - q1 * b0
    a21, a22, a23, b2 = a21 - q2 * a01, a22 - q2 * a02, a23 - q2 * a03, b2 - q2 * b0
    a31, a32, a33, b3 = a31 - q3 * a01, a32 - q3 * a02, a33 - q3 * a03, b3 - q3 * b0
    r = 1.0 / a11
    q2, q3 = a21 * r, a31 * r
    a22, a23, b2 = a22 - q2 * a12, a23 - q2 * a13, b2 - q2 * b1
    a32, a33, b3 = a32 - q3 * a12, a33 - q3 * a13, b3 - q3 * b1
    t = 1.0 / a22
    q3 = a32 * t
    x3 = (b3 - q3 * b2) / (a33 - q3 * a23)
    x2 = (b2 - a23 * x3) * t
    x1 = (b1 - a12 * x2 - a13 * x3) * r
    return (b0 - a01 * x1 - a02 * x2 - a03 * x3) * p, x1, x2, x3


@compiled(fastmath=FAST, inline=True)
def rolled(races, pair, begin, impulse, span, scale):
    """Roll of a ball over a time span, by the backward Euler method; m and J/r^2 = (2/5) m are the masses.

    pair : both seats;  begin : the ball's speeds;  impulse : of the pocket, N s, by these speeds
    """
    inner, outer = pair
    m, j = races.ball_mass, 0.4 * races.ball_mass
    ring, spin = races.ring_speed * scale * races.pitch_radius, races.ring_speed * scale * races.ball_radius
    b0, b1, b2, b3 = begin
    v0, v1, v2, v3 = begin
    o0, o1, o2, o3 = begin  # of the last iteration that came nearer
    c0 = c1 = c2 = c3 = 0.0
    nearest = np.inf
    work = grip = 0.0
    settled = False
    close = SETTLED * min(inner.creep, outer.creep)
    for _ in range(MOST_ITERATIONS):
        of_inner = traction(inner, v0 - ring, v1, v2, v3 - spin)
        of_outer = traction(outer, v0, v1, v2, v3)
        e, f, d, g = of_inner.force, of_outer.force, of_inner.fall, of_outer.fall
        turn = j * v0 / races.pitch_radius
        r0 = m * (v0 - b0) - span * (e[0] + f[0]) - impulse[0]
        r1 = j * (v1 - b1) - span * (e[1] + f[1] - turn * v2) - impulse[1]
        r2 = j * (v2 - b2) - span * (e[2] + f[2] + turn * v1) - impulse[2]
        r3 = j * (v3 - b3) - span * (e[3] + f[3]) - impulse[3]
        far = r0 * r0 / m + (r1 * r1 + r2 * r2 + r3 * r3) / j
        if far > nearest:  # too long a step
            c0, c1, c2, c3 = 0.5 * c0, 0.5 * c1, 0.5 * c2, 0.5 * c3
            v0, v1, v2, v3 = o0 + c0, o1 + c1, o2 + c2, o3 + c3
            continue
        nearest = far
        skew, whirl = span * turn, span * j / races.pitch_radius
        k01, k02, k03 = span * (d[1] + g[1]), span * (d[2] + g[2]), span * (d[3] + g[3])
        k12, k13, k23 = span * (d[5] + g[5]), span * (d[6] + g[6]), span * (d[8] + g[8])
        c0, c1, c2, c3 = _solved(
            (
                (m + span * (d[0] + g[0]), k01, k02, k03),
                (k01 + whirl * v2, j + span * (d[4] + g[4]), k12 + skew, k13),
                (k02 - whirl * v1, k12 - skew, j + span * (d[7] + g[7]), k23),
                (k03, k13, k23, j + span * (d[9] + g[9])),
            ),
            (-r0, -r1, -r2, -r3),
        )
        o0, o1, o2, o3 = v0, v1, v2, v3
        v0, v1, v2, v3 = v0 + c0, v1 + c1, v2 + c2, v3 + c3
        if max(abs(c0), abs(c1), abs(c2), abs(c3)) <= close:
            settled = True
            fall0 = d[0] * c0 + d[1] * c1 + d[2] * c2 + d[3] * c3
            fall3 = d[3] * c0 + d[6] * c1 + d[8] * c2 + d[9] * c3
            work = span * (ring * (e[0] - fall0) + spin * (e[3] - fall3))
            grip = max(
                abs(e[0]) / inner.limit if inner.limit > 0.0 else 0.0,
                abs(f[0]) / outer.limit if outer.limit > 0.0 else 0.0,
            )
            break
    g0, g1, g2, g3 = v0 - b0, v1 - b1, v2 - b2, v3 - b3
    received = (
        v0 * (m * g0 - impulse[0])
        + v1 * (j * g1 - impulse[1])
        + v2 * (j * g2 - impulse[2])
        + v3 * (j * g3 - impulse[3])
    )
    # The pocket's force acts along the whole step, that of the races as at its end: only this takes energy away.
    numerical = 0.5 * (
        g0 * (m * g0 - impulse[0])
        + g1 * (j * g1 - impulse[1])
        + g2 * (j * g2 - impulse[2])
        + g3 * (j * g3 - impulse[3])
    )
    return Roll((v0, v1, v2, v3), work, work - received, numerical, grip, settled)
