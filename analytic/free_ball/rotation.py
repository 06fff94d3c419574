"""How a free ball turns between its races: its axis, its orbital speed and its slip follow from the tractions.

A ball at its place between the grooves has four freedoms: v = (r_m w_c, r w_phi, r w_rho, r w_z), the speed along its
orbit of radius r_m and its absolute rotation along the orbit, outward and along the bearing axis. At a point of a
contact, y across the groove and x along rolling, with the normal n out of the ball, t across the groove and t x n along
the orbit, the ball slides against its race by
    s_phi = r_m (w_c - w_ring) + W_t (r - y^2/2R) - W_n y,  s_t = W_n x - W_phi (r - y^2/2R),  W = w_ball - w_ring z
This is linear in v, s = A v - const, so one map gives force, spin, conformity and the moments: the ball feels
-int A^T stress dA. It turns steadily where
    F_phi = 0,  M_rho = -J w_c w_phi,  M_phi = J w_c w_rho,  M_z = 0,  J = (2/5) m r^2
The terms of balls that come round to another load are left out; the cage carries what is along the orbit.

The stress is that of the law of traction at the slip that the elasticity of the surfaces leaves. Both have the
flexibility L = 32 a/(3 pi^2 E*), that of a long ellipse in steady rolling at the speed u.
- `marched`: along rolling, from the leading edge, L u d stress/d xi = s - g, and g slides against the law. With Coulomb
  friction this is FASTSIM [Kalker1982] on strips, with one flexibility. Spin then pushes the ball across the groove.
- `closed`: stress = T f(k), k = s p/(T p0 u L/a), f(k) = (2/pi)[atan k + k/(1 + k^2)] with the law's T(p, s). With
  Coulomb friction this is Polach's law [Polach2005], exact for the force of an even slip on a strip. It has no memory:
  the lateral push of spin is missing, which is 1 to 33 % of the torque.
- `none`: the closed law with surfaces STIFFER times as stiff.
Rates are per unit ring speed w, so slip is a length and all exists at standstill. Source: derived here.
"""

from dataclasses import dataclass
from functools import cache
from typing import Literal, NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic.contact.hertz import contact_modulus, loaded_contact
from analytic.contact.rolling_contact import deformed_radius
from analytic.errors import ConvergenceError
from analytic.free_ball.layout import (
    ACROSS,
    BALL,
    BALL_RADIUS,
    BOUNDARY,
    CONTACT,
    FLEXIBILITY,
    INERTIA,
    LAW_POWER,
    LOAD,
    MOST_STEPS,
    NORMAL_R,
    NORMAL_Z,
    ORBIT_RADIUS,
    OUTCOME,
    POWER,
    RADIUS,
    RING,
    ROLLING,
    SHARE,
    SPIN_POWER,
    TRANSVERSE,
    UNIT_POWER,
)
from analytic.loads.kinematics import BallKinematics, ball_kinematics
from analytic.loads.turning import PlacedBalls, TurningForces
from analytic.oil.traction import PointLaw, Traction, log_thickenings
from analytic.scene import Array, Bearing

Creep = Literal["none", "closed", "marched"]
STIFFER = 1e3  # times: surfaces without creep, for a force that must not jump
ACCURACY = 1e-10  # of the residual force, over all friction of the ball
ENOUGH = 1e-7  # likewise, where round-off of stiff surfaces leaves no better
STEADY = 1e-6  # relative, of the forces on a ball from one round to the next: a torque needs three digits
MOST_MIXED, LEAST_MIXED = 0.9, 0.2  # of a secant's step, and of the error that a step has to remove at least
PRESSURES = 400  # in a table of the viscosity under pressure: between them it is within 3e-4 up to 3 GPa


class Nodes(NamedTuple):
    """Of a quadrature, across and along rolling."""

    across: int
    along: int


class Surfaces(NamedTuple):
    """How the surfaces of balls and races creep, and by which quadrature."""

    creep: Creep
    nodes: Nodes


@dataclass(frozen=True, kw_only=True, eq=False)
class FreeBalls:
    """Balls that turn steadily, of shape (n,) or (n, m); contacts (2, ...), inner and outer race."""

    rotation: Array  # (..., 3) absolute, along the orbit, outward and along the axis, over w
    torque: Array  # (2, ...) slip power over w, N m
    spin_torque: Array  # (2, ...) the part of it by spin, N m
    coefficient: Array  # (2, ...) of Coulomb friction that loses what the law does at this slip without creep; or 0


class FreeTurning:
    """Free balls of n operating points in the rounds of an equilibrium (`analytic.loads.turning.Turning`)."""

    accuracy = STEADY

    def __init__(
        self,
        bearing: Bearing,
        tractions: tuple[Traction, Traction],
        *,
        inner_speed: Array,
        balls: int | None,
        surfaces: Surfaces,
        inertia: tuple[bool, bool] = (True, True),
    ) -> None:
        """tractions : of inner and outer race, with numbers that broadcast to (n, m)

        inner_speed : w, (n,), rad/s;  balls : m; None: all alike, arrays of balls are then (n,)
        inertia : whether centrifugal force and gyroscopic moment act
        """
        self.bearing, (self.creep, self.nodes) = bearing, surfaces
        self.speed, self.inertia = inner_speed, inertia
        self.shape = inner_speed.shape if balls is None else (*inner_speed.shape, balls)
        self.laws = tuple(_numbers(law.point_law, inner_speed, self.shape) for law in tractions)
        law = tractions[0].point_law
        self.thickening = float(law.growth), float(law.exponent)
        grooves = (bearing.inner, bearing.outer)
        self.flexibility = [
            32 / (3 * np.pi**2 * float(contact_modulus(bearing.ball_material, groove.material))) for groove in grooves
        ]
        self.radius = [
            float(deformed_radius(groove_radius=groove.groove_radius, ball_diameter=bearing.ball_diameter))
            for groove in grooves
        ]
        count = int(np.prod(self.shape))
        self.velocity = np.full((count, 4), np.nan)  # of the last round, a start for the next
        self.contacts = np.zeros((count, 2, CONTACT))
        self.bodies = np.zeros((count, BALL))
        self.outcomes = np.zeros((count, 2, OUTCOME))
        # Friction across the grooves, N: what the last round was given, what it gave back, and the difference
        self.given, self.gave, self.left = (np.full((count, 2), np.nan) for _ in range(3))

    def forces(self, balls: PlacedBalls) -> TurningForces:
        """What acts on the balls once they turn steadily, from where they turned last.

        Raises ConvergenceError with ball, load and residual where they find no steady rotation.
        """
        rows, shape = self._rows(balls.points), balls.inner_angle.shape
        self.bodies[rows] = self._bodies(balls)
        self.contacts[rows] = self._contacts(balls)
        start = self.velocity[rows]
        unknown = np.isnan(start[:, 0])
        if unknown.any():
            start[unknown] = self._rolling(balls, self.bodies[rows, ORBIT_RADIUS])[unknown]
        self.velocity[rows], self.outcomes[rows] = self._turned(rows, start)
        mass, radius, speed = self.bearing.ball_mass, self.bearing.ball_radius, self._speed(balls.points, shape)
        orbit, velocity = self.bodies[rows, ORBIT_RADIUS].reshape(shape), self.velocity[rows].reshape(*shape, 4)
        rate = velocity[..., 0] / orbit
        across = self._mixed(rows).reshape(*shape, 2)
        return TurningForces(
            centrifugal=self.inertia[0] * mass * orbit * (rate * speed) ** 2,
            inner_friction=across[..., 0],
            outer_friction=across[..., 1],
            gyroscopic=self.inertia[1] * 0.4 * mass * radius * speed**2 * rate * velocity[..., 2],
        )

    def motion(self, inner_angle: Array, outer_angle: Array) -> BallKinematics:
        """Speeds per unit ring speed of the last round."""
        radius, orbit = self.bearing.ball_radius, self.bodies[:, ORBIT_RADIUS].reshape(self.shape)
        velocity = self.velocity.reshape(*self.shape, 4)
        orbit_rate = velocity[..., 0] / orbit
        outward, axial = velocity[..., 2] / radius, velocity[..., 3] / radius - orbit_rate  # relative to the orbit
        rates, spins, entrainment = [], [], []
        for angle, side, ring in ((inner_angle, -1.0, 1.0), (outer_angle, 1.0, 0.0)):
            normal_r, normal_z = side * np.cos(angle), side * np.sin(angle)
            turn, spin = axial * normal_r - outward * normal_z, outward * normal_r + axial * normal_z
            passes = ring - orbit_rate
            rates.append(np.abs(turn - passes * normal_r))
            spins.append(spin - passes * normal_z)
            entrainment.append(np.abs(radius * turn + passes * (orbit + radius * normal_r)) / 2)
        return BallKinematics(
            inner_radius=orbit - radius * np.cos(inner_angle),
            outer_radius=orbit + radius * np.cos(outer_angle),
            cage_speed=orbit_rate,
            ball_speed=np.sqrt((velocity[..., 1] / radius) ** 2 + outward**2 + axial**2),
            inner_entrainment=entrainment[0],
            outer_entrainment=entrainment[1],
            inner_rolling_rate=rates[0],
            outer_rolling_rate=rates[1],
            spin_difference=np.abs(spins[0] + spins[1]),
            pitch=np.arctan2(outward, -axial),
        )

    def balls(self) -> FreeBalls:
        """The balls of the last round."""
        races = np.moveaxis(self.outcomes, 1, 0).reshape(2, *self.shape, OUTCOME)
        law, unit = races[..., LAW_POWER], races[..., UNIT_POWER]
        return FreeBalls(
            rotation=(self.velocity[:, 1:] / self.bearing.ball_radius).reshape(*self.shape, 3),
            torque=races[..., POWER],
            spin_torque=races[..., SPIN_POWER],
            coefficient=np.divide(law, unit, out=np.zeros_like(law), where=unit > 0),
        )

    def _turned(self, rows: NDArray[np.intp], start: Array) -> tuple[Array, Array]:
        """Velocities and outcomes of the balls in these rows."""
        from analytic.free_ball.kernel import rotate

        contacts, outcomes = self.contacts[rows], np.zeros((len(rows), *self.outcomes.shape[1:]))
        quadrature = (*_nodes(self.nodes, marched=self.creep == "marched"), *self._thickening(contacts))
        left = rotate(contacts, self.bodies[rows], start, quadrature, ACCURACY, outcomes)
        if not np.all(left <= ENOUGH):
            worst = int(np.argmax(np.where(np.isnan(left), np.inf, left)))
            inner, outer = contacts[worst, :, LOAD]
            raise ConvergenceError(
                iterations=MOST_STEPS,
                residual=float(left[worst]),
                tolerance=ENOUGH,
                unit="of its friction",
                problem=f"the rotation of ball {int(rows[worst]) % max(1, int(np.prod(self.shape[1:])))} under "
                f"{inner:.4g} N on the inner and {outer:.4g} N on the outer race",
                remedy='Raise the load or lower the speed, or give friction.spin_rule = "outer_control".',
            )
        return start, outcomes

    def _mixed(self, rows: NDArray[np.intp]) -> Array:
        """(k, 2) the friction across the grooves for the next round, N.

        Friction moves the contact angles, and these the friction. Rounds alone converge slowly; the errors of the last
        two give each ball a secant [Anderson1965].
        """
        now = self.outcomes[rows, :, ACROSS]
        left, left_before = now - self.given[rows], self.left[rows]
        change = left - left_before
        size = np.sum(change**2, axis=1)
        share = np.divide(np.sum(left * change, axis=1), size, out=np.zeros_like(size), where=size > 0)
        share = np.clip(share, -MOST_MIXED, MOST_MIXED)[:, None]
        mixed = now - share * (now - self.gave[rows])
        # A step far shorter than the error would pass for the end of the rounds.
        stands = ~(np.linalg.norm(mixed - self.given[rows], axis=1) > LEAST_MIXED * np.linalg.norm(left, axis=1))
        mixed[stands] = now[stands]
        self.given[rows], self.gave[rows], self.left[rows] = mixed, now, left
        return mixed

    def _rows(self, points: NDArray[np.intp]) -> NDArray[np.intp]:
        each = int(np.prod(self.shape[1:]))
        return (points[:, None] * each + np.arange(each)).ravel()

    def _speed(self, points: NDArray[np.intp], shape: tuple[int, ...]) -> Array:
        return np.broadcast_to(self.speed[points].reshape(-1, *(1,) * (len(shape) - 1)), shape)

    def _contacts(self, balls: PlacedBalls) -> Array:
        """(k, 2, CONTACT) for the compiled loop."""
        contacts = np.zeros((balls.inner_angle.size, 2, CONTACT))
        softer = 1 / STIFFER if self.creep == "none" else 1.0
        sides = (
            (balls.inner, balls.inner_load, balls.inner_angle, -1.0, 1.0),
            (balls.outer, balls.outer_load, balls.outer_angle, 1.0, 0.0),
        )
        for race, (unit, load, angle, side, ring) in enumerate(sides):
            of_race, contact = contacts[:, race], loaded_contact(unit, load=load)
            of_race[:, LOAD] = load.ravel()
            of_race[:, ROLLING] = contact.semi_axis_x.ravel()
            of_race[:, TRANSVERSE] = contact.semi_axis_y.ravel()
            of_race[:, RADIUS] = self.radius[race]
            of_race[:, NORMAL_R], of_race[:, NORMAL_Z] = (
                side * np.cos(angle).ravel(),
                side * np.sin(angle).ravel(),
            )
            of_race[:, RING] = ring
            of_race[:, FLEXIBILITY] = softer * self.flexibility[race]
            of_race[:, BOUNDARY:] = self.laws[race][balls.points].reshape(len(contacts), -1)
        return contacts

    def _bodies(self, balls: PlacedBalls) -> Array:
        """(k, BALL) for the compiled loop."""
        outer, radius = self.bearing.outer, self.bearing.ball_radius
        approach = balls.outer.approach * np.cbrt(balls.outer_load) ** 2
        reach = (outer.groove_radius - radius + approach) * np.cos(balls.outer_angle)
        bodies = np.zeros((balls.inner_angle.size, BALL))
        bodies[:, BALL_RADIUS] = radius
        above = 0.0 if self.bearing.kind == "thrust" else outer.groove_radius  # the profile's centre over the bottom
        bodies[:, ORBIT_RADIUS] = (outer.bottom_radius - above + reach).ravel()
        speed = self._speed(balls.points, balls.inner_angle.shape).ravel()
        bodies[:, INERTIA] = 0.4 * self.bearing.ball_mass * self.inertia[1] * speed**2
        return bodies

    def _rolling(self, balls: PlacedBalls, orbit: Array) -> Array:
        """(k, 4) velocities of balls that roll under outer control; orbit : radius, (k,)."""
        motion = ball_kinematics(
            inner_speed=1.0,
            inner_angle=balls.inner_angle.ravel(),
            outer_angle=balls.outer_angle.ravel(),
            pitch_diameter=self.bearing.pitch_diameter,
            ball_diameter=self.bearing.ball_diameter,
        )
        outward, axial = motion.ball_speed * np.sin(motion.pitch), motion.ball_speed * np.cos(motion.pitch)
        rotation = self.bearing.ball_radius * np.stack([np.zeros_like(orbit), outward, motion.cage_speed - axial])
        return np.concatenate([[orbit * motion.cage_speed], rotation]).T

    def _thickening(self, contacts: Array) -> tuple[Array, float]:
        """ln of the oil's viscosity over that at pressure 0, at equal steps of the pressure in Pa."""
        area = contacts[..., ROLLING] * contacts[..., TRANSVERSE]
        peak = np.divide(1.5 * contacts[..., LOAD], np.pi * area, out=np.zeros_like(area), where=area > 0)
        highest = 1.01 * float(np.max(peak * contacts[..., SHARE], initial=1.0))
        pressures = np.linspace(0.0, highest, PRESSURES)
        return log_thickenings(*self.thickening, pressures), float(pressures[1])


def _numbers(law: PointLaw, speed: Array, shape: tuple[int, ...]) -> Array:
    """(*shape, 6) in the order of the compiled loop; speeds of slip per unit ring speed."""
    column = np.abs(speed)[:, None]
    with np.errstate(invalid="ignore"):  # at standstill the film is 0 too, and the oil shears at its limit
        fluidity = np.where(np.isinf(law.fluidity), np.inf, np.asarray(law.fluidity) * column)
    fields = (law.boundary, law.plain, law.limit, law.eyring, fluidity, law.share)
    whole = (*speed.shape, shape[1] if len(shape) > 1 else 1)
    return np.stack([np.broadcast_to(np.asarray(field, dtype=np.float64), whole) for field in fields], axis=-1).reshape(
        *shape, len(fields)
    )


@cache
def _nodes(nodes: Nodes, *, marched: bool) -> tuple[tuple[Array, ...], tuple[Array, ...], bool]:
    """Sines, cosines and weights of the angles of strips and nodes, and whether traction is marched.

    Marched nodes lie at equal steps of the angle, without the ends; they march from the leading edge.
    """
    if not marched:
        return _gauss(nodes.across), _gauss(nodes.along), False
    angle = np.pi * (np.arange(1, nodes.along) / nodes.along - 0.5)
    return _gauss(nodes.across), (np.sin(angle), np.cos(angle), np.full(angle.size, np.pi / nodes.along)), True


def _gauss(nodes: int) -> tuple[Array, Array, Array]:
    x, weight = np.polynomial.legendre.leggauss(nodes)
    return np.sin(np.pi / 2 * x), np.cos(np.pi / 2 * x), np.pi / 2 * weight
