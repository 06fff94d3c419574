"""Both raceways as free balls feel them: loads and directions of the contacts over a turn, creep, and a ball's steps.

Loads. The rings hold the balls as in `analytic.loads`, and the motion of balls and cage does not move the rings. A ball
that its pocket presses moves between its raceways at once until all forces balance. Across the raceways that is true:
it takes sqrt(m/k), some 5 us with their stiffness k. Along the grooves a ball moves more slowly, so the turn of a
contact's normal is limited (`LARGEST_TURN`).

Traction. The speeds of a ball are (r_m w_c, r w_phi, r w_rho, r w_z), m/s: along the orbit, and its rotation about the
direction of the orbit, outward and about the bearing's axis. The rotation is absolute; the directions turn with w_c. A
contact with the normal n out of the ball and t x n along the orbit is divided into strips at y across the groove. With
the rotation W relative to the ring and h = r - y^2/2R a strip slides with
    s_phi = r_m (w_c - w_ring) + W_t h - W_n y,  s_t = -W_phi h
and carries mu times its share of the load times f(|s|/s_c) against the slip, with
    f(k) = (2/pi) (atan k + k/(1 + k^2)).
f is FASTSIM on a strip with Hertz's pressure, integrated in closed form: exact for slip that is uniform on the strip.
Slip by spin along a strip is left out. The creep is that of a long ellipse, the same along the groove and across it:
    s_c = u 8 mu p0/(3 C11 G) = u (32/(3 pi^2)) mu p0/E*,  C11 = pi^2/(4 (1 - nu)),
with the rolling speed u and the peak pressure p0.
Source: [Kalker1982] and [Polach2005] for f and s_c; the balance of a ball is Euler's equation in directions that turn
with w_c; the derivatives by the pocket's force are derived here.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.cage.pocket import FAST
from analytic.contact.geometry import RACES, race_curvatures
from analytic.contact.hertz import HertzContact, contact_modulus, hertz_contact, loaded_contact
from analytic.contact.rolling_contact import deformed_radius
from analytic.errors import InputError, SingularError, require_finite, require_non_negative
from analytic.loads.kinematics import BallMotion, ball_kinematics
from analytic.loads.ring import ring_equilibrium
from analytic.loads.turning import WHOLE_INERTIA, Inertia
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import mapped
from analytic.numerics.machine_code import entry
from analytic.numerics.records import Records
from analytic.scene import Array, Bearing, ContactAngle, Operation

# In a 6205 under 1000 N: 4 give 2.5 times the torque of a whirling cage. 24 leave 0.2 % of it, 0.8 % of the torque of
# the raceways and 2 % of the lead of balls under radial load: slip changes its sign within a tenth of the width.
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

MOST_ITERATIONS = 60
LAST_CHANGE = 0.02  # of s_c, Newton's last: quadratic convergence leaves some 1e-4 of s_c
LARGEST_TURN = 0.1  # rad, of a contact's normal by the pocket's force
LEAST_CREEP = 1e-4  # m/s, added to s_c: without it a ball at standstill would meet dry friction with a jump
AZIMUTHS = 144  # at least, of a turn: straight lines between them are within 1e-3 of the loads
STEPS = 2880  # of a ball's turn without a cage
STARTING = tuple(10.0**power for power in range(-6, 1))  # s: steps of a ball that comes to a steady speed
STARTING_STEPS = 20  # of each length

SPEEDS = ("along", "about", "outward", "axial")  # of a ball: r_m w_c, r w_phi, r w_rho, r w_z


def numbers(*names: str) -> list[tuple[str, type[np.float64]]]:
    """Fields of a record that are numbers."""
    return [(name, np.float64) for name in names]


# A ball on its raceways. friction : mu;  curvature_ratio : r/2R
BALL_ON_RACEWAYS = np.dtype(
    numbers("ball_mass", "ball_radius", "pitch_radius", "ring_speed")
    + [(name, np.dtype(numbers("friction", "curvature_ratio"))) for name in RACES]
)
# One contact at an azimuth, SI. The semi-axis across the groove over r, and the creep, are those under 1 N: both grow
# with the cube root of the load. Radial and axial forces on the ball change the load, N/N, and turn the normal, rad/N.
CONTACT = np.dtype(
    numbers("load", "normal_radial", "normal_axial", "width", "creep")
    + numbers("load_by_radial", "load_by_axial", "turn_by_radial", "turn_by_axial")
)
# Both contacts at an azimuth; slip_without_cage : power of slip in both of a ball without a cage, W
AZIMUTH = np.dtype([*((name, CONTACT) for name in RACES), *numbers("slip_without_cage")])
# A ball: cosine and sine of the place of its pocket in the cage; the fastest closing speed of the present contact with
# each shell, m/s, 0 without contact; its force on the cage at the end of the last call, N. Of a free ball also its
# azimuth, rad; speeds, m/s; time since its last step, s; and its contacts.
BALL = np.dtype(
    [
        *numbers("pocket_cosine", "pocket_sine"),
        ("impact_speed", np.float64, 2),
        ("force", np.float64, 3),
        *numbers("azimuth", *SPEEDS, "since_step"),
        ("contacts", AZIMUTH),
    ]
)
PATH = np.dtype(numbers("azimuth", *SPEEDS, "ring_work", "slip", "grip"))  # of a ball, at the end of each step


class Contact(NamedTuple):
    """One ball on one raceway."""

    limit: float  # mu Q, N
    normal_radial: float  # out of the ball
    normal_axial: float
    width: float  # b/r
    curvature_ratio: float  # r/2R
    creep: float  # s_c, m/s


class Traction(NamedTuple):
    """Of a raceway on a ball, by its four speeds: force, N, and how that falls with them, N s/m, symmetric."""

    along: float
    about: float
    outward: float
    axial: float
    along_along: float
    along_about: float
    along_outward: float
    along_axial: float
    about_about: float
    about_outward: float
    about_axial: float
    outward_outward: float
    outward_axial: float
    axial_axial: float


class BallStep(NamedTuple):
    """What a step does besides changing the speeds of the ball; energies in J."""

    ring_work: float  # of the inner ring
    slip: float  # lost in both contacts
    numerical: float  # lost by the implicit method itself
    grip: float  # largest traction along the orbit over its limit, of both raceways
    settled: bool


class PocketPush(NamedTuple):
    """A pocket on its ball."""

    radial: float  # force, N
    axial: float
    impulses: tuple[float, float, float, float]  # by the four speeds, N s


NO_PUSH = PocketPush(0.0, 0.0, (0.0, 0.0, 0.0, 0.0))


@compiled(fastmath=FAST)
def _interpolate_contact(first: Any, second: Any, part: float, at: Any) -> None:
    rest = 1.0 - part
    at.load = rest * first.load + part * second.load
    at.normal_radial = rest * first.normal_radial + part * second.normal_radial
    at.normal_axial = rest * first.normal_axial + part * second.normal_axial
    at.width = rest * first.width + part * second.width
    at.creep = rest * first.creep + part * second.creep
    at.load_by_radial = rest * first.load_by_radial + part * second.load_by_radial
    at.load_by_axial = rest * first.load_by_axial + part * second.load_by_axial
    at.turn_by_radial = rest * first.turn_by_radial + part * second.turn_by_radial
    at.turn_by_axial = rest * first.turn_by_axial + part * second.turn_by_axial


@compiled(fastmath=FAST)
def interpolate(table: Any, ball: Any) -> None:
    """Set the contacts of a BALL to the table, (n,) of AZIMUTH over a turn, at the azimuth of the ball."""
    points = table.shape[0]
    if points == 1:
        return  # they are those of the table from the beginning
    where = ball.azimuth * (points / (2.0 * np.pi))
    floor = np.floor(where)
    part, number = where - floor, int(floor) % points
    first, second, contacts = table[number], table[(number + 1) % points], ball.contacts
    _interpolate_contact(first.inner, second.inner, part, contacts.inner)
    _interpolate_contact(first.outer, second.outer, part, contacts.outer)
    contacts.slip_without_cage = (1.0 - part) * first.slip_without_cage + part * second.slip_without_cage


@compiled(fastmath=FAST, inline=True)
def _contact(race: Any, at: Any, load: float, turn: float, speed_share: float) -> Contact:
    """The Contact under a load, N; race : friction and curvature ratio;  turn : of the normal, rad."""
    turn = min(max(turn, -LARGEST_TURN), LARGEST_TURN)
    radial, axial = at.normal_radial - turn * at.normal_axial, at.normal_axial + turn * at.normal_radial
    length = 1.0 / np.sqrt(radial * radial + axial * axial)
    size = np.cbrt(load)
    return Contact(
        race.friction * load,
        radial * length,
        axial * length,
        at.width * size,
        race.curvature_ratio,
        speed_share * at.creep * size + LEAST_CREEP,
    )


@compiled(fastmath=FAST, inline=True)
def pressed_contacts(
    raceways: Any, contacts: Any, radial: float, axial: float, speed_share: float
) -> tuple[Contact, Contact]:
    """Inner and outer Contact of a ball under the force of its pocket, N.

    raceways : BALL_ON_RACEWAYS;  contacts : AZIMUTH of the ball;  speed_share : of the ring's speed that is reached
    A raceway that the force unloads leaves its share to the other.
    """
    inner, outer = contacts.inner, contacts.outer
    inner_load = inner.load + inner.load_by_radial * radial + inner.load_by_axial * axial
    outer_load = outer.load + outer.load_by_radial * radial + outer.load_by_axial * axial
    if inner_load < 0.0:
        inner_load, outer_load = 0.0, outer_load - inner_load
    elif outer_load < 0.0:
        inner_load, outer_load = inner_load - outer_load, 0.0
    outer_load = max(outer_load, 0.0)
    inner_turn = inner.turn_by_radial * radial + inner.turn_by_axial * axial
    outer_turn = outer.turn_by_radial * radial + outer.turn_by_axial * axial
    return (
        _contact(raceways.inner, inner, inner_load, inner_turn, speed_share),
        _contact(raceways.outer, outer, outer_load, outer_turn, speed_share),
    )


@compiled(fastmath=FAST)
def traction(contact: Contact, along: float, about: float, outward: float, axial: float) -> Traction:
    """Traction on a ball whose speeds relative to the ring are r_m (w_c - w_ring), r W_phi, r W_rho and r W_z."""
    n, m = contact.normal_radial, contact.normal_axial
    turning, spinning = axial * n - outward * m, outward * n + axial * m  # r W_t, r W_n
    inverse = 1.0 / contact.creep
    f0 = f1 = ft = fn = 0.0
    d00 = d0t = d0n = dtt = dtn = dnn = d10 = d1t = d1n = d11 = 0.0
    for strip in range(STRIPS):
        y = contact.width * PLACE[strip]
        h = 1.0 - contact.curvature_ratio * y * y
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
        share = contact.limit * SHARE[strip] * (2.0 / np.pi) * inverse
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
        f0,
        f1,
        n * fn - m * ft,
        m * fn + n * ft,
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
def _newton_change(e, f, masses, gyroscopic, turning, span, missing):
    """Newton's change of the four speeds; e, f : Traction of both raceways;  missing : momentum by the speeds, N s.

    gyroscopic : J w_c/r^2 and its change with r_m w_c;  turning : r w_phi, r w_rho
    """
    m, j = masses
    skew, whirl = span * gyroscopic[0], span * gyroscopic[1]
    k01 = span * (e.along_about + f.along_about)
    k02 = span * (e.along_outward + f.along_outward)
    k03 = span * (e.along_axial + f.along_axial)
    k12 = span * (e.about_outward + f.about_outward)
    k13 = span * (e.about_axial + f.about_axial)
    k23 = span * (e.outward_axial + f.outward_axial)
    return _solved(
        (
            (m + span * (e.along_along + f.along_along), k01, k02, k03),
            (k01 + whirl * turning[1], j + span * (e.about_about + f.about_about), k12 + skew, k13),
            (k02 - whirl * turning[0], k12 - skew, j + span * (e.outward_outward + f.outward_outward), k23),
            (k03, k13, k23, j + span * (e.axial_axial + f.axial_axial)),
        ),
        missing,
    )


@compiled(fastmath=FAST)
def step_ball(raceways: Any, ball: Any, push: PocketPush, span: float, speed_share: float) -> BallStep:
    """Change the speeds of a ball over a time span, s, by the backward Euler method.

    raceways : BALL_ON_RACEWAYS;  ball : BALL;  speed_share : of the ring's speed that is reached
    m and J/r^2 = (2/5) m are the masses that belong to the speeds.
    """
    inner, outer = pressed_contacts(raceways, ball.contacts, push.radial, push.axial, speed_share)
    m, j = raceways.ball_mass, 0.4 * raceways.ball_mass
    pitch_radius = raceways.pitch_radius
    ring_speed = raceways.ring_speed * speed_share
    ring, spin = ring_speed * pitch_radius, ring_speed * raceways.ball_radius
    impulse = push.impulses
    b0, b1, b2, b3 = ball.along, ball.about, ball.outward, ball.axial
    v0, v1, v2, v3 = b0, b1, b2, b3
    o0, o1, o2, o3 = b0, b1, b2, b3  # of the last iteration that came nearer
    c0 = c1 = c2 = c3 = 0.0
    nearest = np.inf
    work = grip = 0.0
    settled = False
    close = LAST_CHANGE * min(inner.creep, outer.creep)
    for _ in range(MOST_ITERATIONS):
        e = traction(inner, v0 - ring, v1, v2, v3 - spin)
        f = traction(outer, v0, v1, v2, v3)
        turn = j * v0 / pitch_radius
        r0 = m * (v0 - b0) - span * (e.along + f.along) - impulse[0]
        r1 = j * (v1 - b1) - span * (e.about + f.about - turn * v2) - impulse[1]
        r2 = j * (v2 - b2) - span * (e.outward + f.outward + turn * v1) - impulse[2]
        r3 = j * (v3 - b3) - span * (e.axial + f.axial) - impulse[3]
        far = r0 * r0 / m + (r1 * r1 + r2 * r2 + r3 * r3) / j
        if far > nearest:  # too long a step
            c0, c1, c2, c3 = 0.5 * c0, 0.5 * c1, 0.5 * c2, 0.5 * c3
            v0, v1, v2, v3 = o0 + c0, o1 + c1, o2 + c2, o3 + c3
            continue
        nearest = far
        c0, c1, c2, c3 = _newton_change(e, f, (m, j), (turn, j / pitch_radius), (v1, v2), span, (-r0, -r1, -r2, -r3))
        o0, o1, o2, o3 = v0, v1, v2, v3
        v0, v1, v2, v3 = v0 + c0, v1 + c1, v2 + c2, v3 + c3
        if max(abs(c0), abs(c1), abs(c2), abs(c3)) <= close:
            settled = True
            fall0 = e.along_along * c0 + e.along_about * c1 + e.along_outward * c2 + e.along_axial * c3
            fall3 = e.along_axial * c0 + e.about_axial * c1 + e.outward_axial * c2 + e.axial_axial * c3
            work = span * (ring * (e.along - fall0) + spin * (e.axial - fall3))
            grip = max(
                abs(e.along) / inner.limit if inner.limit > 0.0 else 0.0,
                abs(f.along) / outer.limit if outer.limit > 0.0 else 0.0,
            )
            break
    # Momentum that the raceways give
    p0, p1 = m * (v0 - b0) - impulse[0], j * (v1 - b1) - impulse[1]
    p2, p3 = j * (v2 - b2) - impulse[2], j * (v3 - b3) - impulse[3]
    received = v0 * p0 + v1 * p1 + v2 * p2 + v3 * p3
    # The pocket's force acts along the whole step, that of the raceways as at its end: only this takes energy away.
    numerical = 0.5 * ((v0 - b0) * p0 + (v1 - b1) * p1 + (v2 - b2) * p2 + (v3 - b3) * p3)
    ball.along, ball.about, ball.outward, ball.axial = v0, v1, v2, v3
    return BallStep(work, work - received, numerical, grip, settled)


@entry(
    lambda: {"raceways": BALL_ON_RACEWAYS, "table": (AZIMUTH, 1), "ball": BALL, "path": (PATH, 1), "step": float},
    fastmath=FAST,
)
def roll_without_cage(raceways: Any, table: Any, ball: Any, path: Any, step: float) -> int:
    """Roll one ball at full speed of the ring; returns the number of steps that converged.

    raceways : BALL_ON_RACEWAYS;  table : (n,) of AZIMUTH over a turn;  ball : BALL;  path : (steps,) of PATH, to be set
    """
    for number in range(path.shape[0]):
        ball.azimuth += step * ball.along / raceways.pitch_radius
        interpolate(table, ball)
        done = step_ball(raceways, ball, NO_PUSH, step, 1.0)
        if not done.settled:
            return number
        end = path[number]
        end.azimuth, end.along, end.about = ball.azimuth, ball.along, ball.about
        end.outward, end.axial = ball.outward, ball.axial
        end.ring_work, end.slip, end.grip = done.ring_work, done.slip, done.grip
    return path.shape[0]


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceContacts:
    """A ball on both races, inner and outer in front, at n azimuths from the x axis on, evenly over a turn."""

    load: Array  # (2, n) Q, N, >= 0
    contact_angle: Array  # (2, n) al, rad, with its sign
    contact: HertzContact  # (2, n)


@dataclass(frozen=True, kw_only=True, eq=False)
class UncagedBall:
    """A ball on its races without a cage, over a turn; n azimuths."""

    orbit_speed: float  # mean over time, rad/s
    lead: float  # amplitude A of a lead A sin(psi) over a steady orbit, m
    speeds: Array  # (n, 4) at the azimuths: r_m w_c, r w_phi, r w_rho, r w_z, m/s
    slip_power: Array  # (n,) lost in both contacts, W
    grip: float  # largest traction along the orbit over its limit


@dataclass(frozen=True, kw_only=True, eq=False)
class Raceways:
    """Both raceways of a bearing at one operating point; the outer ring stands still.

    Raises InputError if neither raceway has friction, or if a ball is pressed on neither.
    """

    bearing: Bearing
    contacts: RaceContacts
    friction: tuple[float, float]  # mu, coefficient of the inner and of the outer race
    inner_speed: float  # w, rad/s

    def __post_init__(self) -> None:
        require_finite(inner_speed=self.inner_speed)
        require_non_negative(friction=self.friction)
        if not max(self.friction) > 0:
            raise InputError(
                f"friction of the races {self.friction!r} drives no ball, and so no cage: give a coefficient above 0 "
                "at one race at least"
            )
        pressed = self.contacts.load.max(axis=0)
        if not pressed.min() > 0:
            azimuth = 360 * int(pressed.argmin()) / pressed.size
            raise InputError(
                f"a ball at {azimuth:.0f} degrees from the radial load is pressed by {pressed.min():.3g} N: it needs "
                "more than 0 N on one race to follow it; raise the axial load, or include the centrifugal force"
            )

    @cached_property
    def table(self) -> NDArray[np.void]:
        """(n,) records of AZIMUTH over a turn, SI, with a slip power of 0 W."""
        bearing, contacts = self.bearing, self.contacts
        load, angle = contacts.load, contacts.contact_angle
        grooves = (bearing.inner, bearing.outer)
        modulus = np.reshape([contact_modulus(bearing.ball_material, groove.material) for groove in grooves], (2, 1))
        unit = _under_unit_load(bearing, contacts, modulus)
        moving = self._moving(*angle)
        speed = np.abs([moving.inner_entrainment, moving.outer_entrainment])
        friction = np.reshape(self.friction, (2, 1))
        by_force = _by_force(bearing, contacts)
        outward = (-1.0, 1.0)  # the inner raceway is on the inside of the ball
        table = np.zeros(load.shape[1], AZIMUTH)
        for race, name in enumerate(RACES):
            contact = table[name]
            contact["load"] = load[race]
            contact["normal_radial"] = outward[race] * np.cos(angle[race])
            contact["normal_axial"] = outward[race] * np.sin(angle[race])
            contact["width"] = unit.semi_axis_y[race] / bearing.ball_radius
            contact["creep"] = (32 / (3 * np.pi**2) * friction * unit.peak_pressure / modulus * speed)[race]
            for number, column in enumerate(("load_by_radial", "load_by_axial", "turn_by_radial", "turn_by_axial")):
                contact[column] = by_force[race, :, number]
        return table

    @property
    def limits(self) -> Array:
        """(2, n) N: mu Q, the largest traction."""
        return np.reshape(self.friction, (2, 1)) * self.contacts.load

    @cached_property
    def constants(self) -> np.void:
        """BALL_ON_RACEWAYS."""
        bearing, constants = self.bearing, np.zeros(1, BALL_ON_RACEWAYS)[0]
        constants["ball_mass"], constants["ball_radius"] = bearing.ball_mass, bearing.ball_radius
        constants["pitch_radius"], constants["ring_speed"] = bearing.pitch_diameter / 2, self.inner_speed
        for name, groove, friction in zip(RACES, (bearing.inner, bearing.outer), self.friction, strict=True):
            deformed = deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter)
            constants[name] = friction, bearing.ball_radius / (2 * float(deformed))
        return constants

    @cached_property
    def alone(self) -> UncagedBall:
        """A ball without a cage; raises SingularError if its speeds do not settle."""
        points, radius = self.contacts.load.shape[1], self.bearing.pitch_diameter / 2
        ball = self._rolling_ball()
        if points == 1:
            last = [self._rolled(ball, STARTING_STEPS, step)[-1:] for step in STARTING][-1]
            return UncagedBall(
                orbit_speed=float(last["along"][0]) / radius,
                lead=0.0,
                speeds=np.stack([last[name] for name in SPEEDS], axis=1),
                slip_power=last["slip"] / STARTING[-1],
                grip=float(last["grip"][0]),
            )
        step = 2 * np.pi * radius / abs(ball["along"]) / STEPS
        self._rolled(ball, STEPS, step)  # from rolling to what the loads make of it
        begin, sign = float(ball["azimuth"]), np.sign(self.inner_speed)
        path = self._rolled(ball, STEPS + STEPS // 10, step)
        angle, time = sign * (path["azimuth"] - begin), step * np.arange(1, len(path) + 1)
        period = float(np.interp(2 * np.pi, angle, time))
        turn = path[time <= period]
        azimuth = 2 * np.pi * np.arange(points) / points

        def at(name: str) -> Array:
            return np.interp(azimuth, turn["azimuth"] % (2 * np.pi), turn[name], period=2 * np.pi)

        even = 2 * np.pi * np.arange(1, STEPS) / STEPS  # of a ball at the mean speed
        ahead = np.interp(even / (2 * np.pi) * period, time, angle) - even
        return UncagedBall(
            orbit_speed=float(sign * 2 * np.pi / period),
            lead=float(2 * np.mean(ahead * np.sin(even + sign * begin)) * radius),
            speeds=np.stack([at(name) for name in SPEEDS], axis=1),
            slip_power=at("slip") / step,
            grip=float(turn["grip"].max()),
        )

    def _rolling_ball(self) -> np.void:
        """A BALL at the azimuth 0 that rolls."""
        bearing, ball = self.bearing, np.zeros(1, BALL)[0]
        ball["contacts"] = self.table[0]
        moving = self._moving(*self.contacts.contact_angle[:, 0])
        ball["along"] = bearing.pitch_diameter / 2 * moving.cage_speed
        ball["outward"] = bearing.ball_radius * moving.ball_speed * np.sin(moving.pitch)
        ball["axial"] = bearing.ball_radius * (moving.cage_speed - moving.ball_speed * np.cos(moving.pitch))
        return ball

    def _moving(self, inner_angle: ArrayLike, outer_angle: ArrayLike) -> BallMotion:
        """Arrays of the motion by outer control."""
        sizes = self.bearing.pitch_diameter, self.bearing.ball_diameter
        return BallMotion._make(mapped(ball_kinematics, self.inner_speed, inner_angle, outer_angle, *sizes))

    def _rolled(self, ball: np.void, steps: int, step: float) -> NDArray[np.void]:
        """(steps,) of PATH."""
        path = np.zeros(steps, PATH)
        done = roll_without_cage(self.constants, self.table, ball, path, step)
        if done < steps:
            raise SingularError(
                problem=f"the speeds of a ball on its races did not converge at step {done} of {steps} without a cage",
                remedy="Check the friction coefficients of the races, the loads and the speed for a slipped unit",
            )
        return path


def thrust_raceways(bearing: Bearing, balls: Records, *, inner_speed: float, friction: tuple[float, float]) -> Raceways:
    """Races under balls that are all alike.

    balls : (1,) of `analytic.solve.records.BALL`, which stands for all;  inner_speed : w, rad/s
    friction : mu of inner and outer race
    """
    names = {"semi_axis_x": "semi_axis_rolling", "semi_axis_y": "semi_axis_transverse"}
    contact = {name: balls[names.get(name, name)].T for name in HertzContact._fields}
    side = np.where(balls["angle"].sum(axis=1) < 0, -1.0, 1.0)
    contacts = RaceContacts(
        load=balls["load"].T, contact_angle=side * balls["angle"].T, contact=HertzContact(**contact)
    )
    return Raceways(bearing=bearing, contacts=contacts, friction=friction, inner_speed=inner_speed)


def ring_raceways(
    bearing: Bearing,
    contact_angle: ContactAngle,
    operation: Operation,
    *,
    friction: tuple[float, float],
    inertia: Inertia = WHOLE_INERTIA,
) -> Raceways:
    """Races under balls that differ over a turn, by `ring_equilibrium`; its errors.

    operation : one operating point
    The balls go round evenly spaced, so that a ball at one azimuth always finds the others at the same places: the ring
    is solved at several places of the set within its spacing.
    """
    count = bearing.ball_count
    turns = -(-AZIMUTHS // count)
    ahead = 2 * np.pi * np.arange(turns) / (turns * count)
    force, moment, speed = (
        float(np.squeeze(value)) for value in (operation.radial_load, operation.moment, operation.inner_speed)
    )
    tilt = operation.held_tilt
    ring = ring_equilibrium(  # in directions that turn with the balls
        bearing,
        contact_angle,
        axial_load=float(np.squeeze(operation.axial_load)),
        radial_load_x=force * np.cos(ahead),
        radial_load_y=-force * np.sin(ahead),
        moment_x=moment * np.sin(ahead),
        moment_y=moment * np.cos(ahead),
        tilts=None if np.isnan(tilt) else (tilt * np.sin(ahead), tilt * np.cos(ahead)),
        inner_speed=speed,
        inertia=inertia,
    )
    balls = ring.balls.T.ravel()  # over a turn
    load = np.ascontiguousarray(balls["load"].T)
    units = [balls[f"{race}_unit"] for race in RACES]
    unit = HertzContact(**{name: np.stack([each[name] for each in units]) for name in HertzContact._fields})
    return Raceways(
        bearing=bearing,
        contacts=RaceContacts(
            load=load,
            contact_angle=np.ascontiguousarray(balls["angle"].T),
            contact=loaded_contact(unit, load=load),
        ),
        friction=friction,
        inner_speed=speed,
    )


def _under_unit_load(bearing: Bearing, contacts: RaceContacts, modulus: Array) -> HertzContact:
    """Contacts under 1 N, (2, n): semi-axes and pressure go with the cube root of the load."""
    curvatures = [
        race_curvatures(bearing, race, contact_angle=np.abs(angle))
        for race, angle in zip(RACES, contacts.contact_angle, strict=True)
    ]
    rolling, transverse = (np.stack(values) for values in zip(*curvatures, strict=True))
    free = hertz_contact(curvature_x=rolling, curvature_y=transverse, load=1.0, modulus=modulus)
    root = np.cbrt(contacts.load)
    both = zip(contacts.contact, free, strict=True)
    return HertzContact(*(np.divide(each, root, out=bare.copy(), where=root > 0) for each, bare in both))


def _by_force(bearing: Bearing, contacts: RaceContacts) -> Array:
    """(2, n, 4): how a radial and an axial force on the ball change the load, N/N, and turn the normal, rad/N.

    The ball sits between two springs whose far ends, the centres of the grooves, stand still; V = al or Q/(length) are
    those of `analytic.loads.ball_balance`.
    """
    load, angle, contact = contacts.load, contacts.contact_angle, contacts.contact
    free = np.reshape([groove.groove_radius - bearing.ball_radius for groove in (bearing.inner, bearing.outer)], (2, 1))
    length = free + contact.approach
    stiffness = 1.5 * np.divide(load, contact.approach, out=np.zeros_like(load), where=load > 0)
    normal = np.stack([np.cos(angle), np.sin(angle)], axis=-1)
    across = np.stack([-np.sin(angle), np.cos(angle)], axis=-1)
    springs = (
        stiffness[..., None, None] * normal[..., :, None] * normal[..., None, :]
        + (load / length)[..., None, None] * across[..., :, None] * across[..., None, :]
    )
    moved = np.linalg.inv(springs.sum(axis=0))  # (n, 2, 2): of the ball by a force
    away = np.array([-1.0, 1.0])[:, None, None]  # the ball moves away from the inner groove's contact
    by_load = away * stiffness[..., None] * np.einsum("rni,nij->rnj", normal, moved)
    by_angle = away / length[..., None] * np.einsum("rni,nij->rnj", across, moved)
    return np.concatenate([by_load, by_angle], axis=-1)
