"""Micro-slip with any law of traction, integrated over the contact ellipse.

x is the direction of rolling, y is transverse, both from the contact's centre. The pressure is
p0 sqrt(1 - x^2/a^2 - y^2/b^2). A ball that rolls with w_roll and spins with w_s over a surface of radius R slides by
    v_x = w_roll y^2/(2 R) + w_s y - c,  v_y = -w_s x
Every point resists with a stress against v, which is a function of pressure and speed. c leaves no net force.
`slip_over_ellipse` has both components. `slip_along_axis` leaves out v_y: this is the limit of a long ellipse, and with
Coulomb friction its moments are those of `analytic.sliding.long_ellipse.microslip_moments`. Elastic creep is left out
(`analytic.sliding.levers.creep_numbers` says when it matters, `analytic.free_ball` has it).
Source: derived here.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cache

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import RollingContact
from analytic.errors import InputError, require_finite, require_positive
from analytic.numerics.root import SecantSlopes, Sought, bracketed_root
from analytic.scene import Array
from analytic.sliding.long_ellipse import pure_rolling_lines

Traction = Callable[[Array, Array], Array]  # (pressure, speed) -> stress, Pa; all (*points, nodes)
# Net force that counts as none, relative to the sum of all friction: round-off of the sum over a thousand nodes.
BALANCED = 1e-14
LAST_STEP = 1e-9  # of c, relative: secant steps converge so fast that the next one would be round-off
ROLLS_NOT = 1e9  # eps from which a contact only spins
NODES = (16, 16)  # transverse and rolling: Coulomb's moments to 1e-5 of mu Q b at any spin and shape, see the tests


@dataclass(frozen=True, kw_only=True, eq=False)
class SlipMoments:
    """Friction of one or many contacts; every field has the broadcast shape of the arguments."""

    spin_moment: Array  # N m, with the sign of the spin
    rolling_moment: Array  # N m
    slip_power: Array  # W: spin moment times w_s + rolling moment times w_roll
    unit_power: Array  # W: what a friction coefficient of 1 would lose at the same sliding of every point
    creep_speed: Array  # c, m/s
    creep_stiffness: Array  # s/m: by how much the net force over all friction falls as c grows; about right


def slip_over_ellipse(
    contact: RollingContact,
    *,
    traction: Traction,
    spin_rate: ArrayLike,
    nodes: tuple[int, int] = NODES,
    near: SlipMoments | None = None,
) -> SlipMoments:
    """Moments of one contact by sliding in both directions at every point; fields and spin_rate broadcast.

    contact : with semi-axes > 0; its pressure has the peak p0 = 3 Q/(2 pi a b), and its curvatures are not used
    traction : (pressure, speed) -> stress, Pa, >= 0, each of shape (*points, nodes), with pressure >= 0 in Pa and speed
        |v| in m/s. Coulomb friction is `lambda pressure, speed: 0.08 * pressure`. The stress must not fall as the speed
        grows, or more than one c may leave no force. A law with a kink, such as a cap, needs more nodes
    spin_rate : w_s, any sign, in the unit of the contact's rolling_rate: rad/s, or per unit ring speed w. With rates
        per unit w, speeds, creep speed and slip power are per unit w too
    nodes : in the transverse direction for each of three panels that meet where v_x = 0, and in that of rolling
    near : the same contacts at another spin; the search of c begins at theirs
        M_spin = int tau (v_x y - v_y x)/|v| dA,  M_roll = int tau v_x y^2/(2 R |v|) dA,  0 = int tau v_x/|v| dA
    Raises InputError if an argument has the wrong sign or is not finite, ConvergenceError if no c is found.
    """
    return _slip(contact, traction, spin_rate, nodes=nodes, sideways=True, near=near)


def slip_along_axis(
    contact: RollingContact,
    *,
    traction: Traction,
    spin_rate: ArrayLike,
    nodes: tuple[int, int] = NODES,
    near: SlipMoments | None = None,
) -> SlipMoments:
    """The same with v_y = 0, for a contact much longer transverse to rolling; arguments as in `slip_over_ellipse`.

    The traction still follows the pressure at each point in the direction of rolling.
    """
    return _slip(contact, traction, spin_rate, nodes=nodes, sideways=False, near=near)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Sliding:
    """A contact at one c; arrays (*points, transverse nodes, rolling nodes), where either of the last two may be 1.

    x and y are in units of a and b. The fields are even in x, so weights for x > 0 cover both halves.
    """

    x: Array
    y: Array
    slide: Array  # v_x, m/s
    turn: Array  # |v_y| at x = a, m/s
    speed: Array  # |v|, m/s
    unit: Array  # p dA, N
    friction: Array  # tau dA, N

    @property
    def pull(self) -> Array:
        """tau v_x/|v| dA over v_x, N s/m."""
        return np.divide(self.friction, self.speed, out=np.zeros_like(self.friction), where=self.speed > 0)


def _sum(of_nodes: Array) -> Array:
    return np.sum(of_nodes, axis=(-2, -1))


@dataclass(frozen=True, kw_only=True, eq=False)
class _Integrand:
    """Numbers of shape (*points, 1), and the quadrature; spin is a magnitude, because y may point either way."""

    traction: Traction
    pressure: Array  # p0
    rolling: Array  # a
    transverse: Array  # b
    roll: Array  # w_roll b^2/(2 R), m/s
    spin: Array  # |w_s| b, m/s
    sideways: bool
    nodes: tuple[int, int]

    def at(self, creep: Array) -> _Sliding:
        """Sliding and friction at every node; creep (*points, 1)."""
        y, y_weight = self._transverse_nodes(creep)
        slide = ((self.roll * y + self.spin) * y - creep)[..., None]
        half = np.sqrt((1 - y) * (1 + y))[..., None]  # half-length in the direction of rolling, in units of a
        turn = (self.spin * self.rolling / self.transverse)[..., None] * self.sideways
        tau, weight = _unit_gauss(self.nodes[1])
        x, x_weight = tau * (2 - tau), 2 * (1 - tau) * weight  # makes the root of the pressure at the rim smooth
        if self.sideways:
            # |v| = sqrt(slide^2 + (turn x)^2) has a near kink at x = 0 where slide is small; x ~ sinh(z t) removes it.
            least = 1e-200 * np.where(self.roll + self.spin > 0, self.roll + self.spin, 1.0)[..., None]
            steep = np.maximum(turn * half / np.maximum(np.abs(slide), least), 1e-8)  # at 1e-8 sinh is its argument
            z = np.arcsinh(steep)
            x, t = np.exp(z * (x - 1)) * np.expm1(-2 * z * x) / np.expm1(-2 * z), x_weight
            x_weight = z * np.hypot(1 / steep, x) * t
        area = 2 * (y_weight * self.rolling * self.transverse)[..., None] * half * x_weight
        speed = np.hypot(slide, turn * half * x)
        pressure = self.pressure[..., None] * half * np.sqrt((1 - x) * (1 + x))
        flat = (*speed.shape[:-2], -1)
        stress = self.traction(pressure.reshape(flat), speed.reshape(flat)).reshape(speed.shape)
        return _Sliding(
            x=x * half,
            y=y[..., None],
            slide=slide,
            turn=turn,
            speed=speed,
            unit=pressure * area,
            friction=stress * area,
        )

    def _transverse_nodes(self, creep: Array) -> tuple[Array, Array]:
        """y/b and weights of three panels that meet where v_x = 0, denser at their ends; (*points, 3 nodes)."""
        root = np.sqrt(np.maximum(self.spin**2 + 4 * self.roll * creep, 0.0))
        near = np.divide(2 * creep, self.spin + root, out=np.zeros_like(root), where=self.spin + root > 0)
        far = np.divide(-(self.spin + root), 2 * self.roll, out=np.full_like(root, -1.0), where=self.roll > 0)
        one = np.ones_like(root)
        edges = np.clip(np.concatenate([-one, far, near, one], axis=-1), -1, 1)
        t, weight = _unit_gauss(self.nodes[0])
        step, slope = t**3 * (10 - 15 * t + 6 * t**2), 30 * t**2 * (1 - t) ** 2
        length = np.diff(edges, axis=-1)[..., None]
        flat = (*root.shape[:-1], -1)
        return (edges[..., :-1, None] + length * step).reshape(flat), (length * slope * weight).reshape(flat)


def power_of_panels(
    contact: RollingContact,
    *,
    traction: Traction,
    spin_rate: ArrayLike,
    creep_speed: ArrayLike,
    nodes: tuple[int, int],
    sideways: bool,
) -> Array:
    """What each of the three transverse panels adds to two powers at a given c, (*points, 6), W: one evaluation.

    creep_speed : c, m/s, of a solution, perhaps with other nodes;  sideways : with v_y;  others as `slip_over_ellipse`
    The powers are those of slip, int tau |v| dA, and of the net force, c int tau v_x/|v| dA.
    """
    integrand = _integrand(contact, traction, spin_rate, nodes=nodes, sideways=sideways)
    creep = np.broadcast_to(creep_speed, integrand.roll.shape[:-1])[..., None, None]
    at = integrand.at(creep[..., 0])
    powers = (at.friction * at.speed, creep * at.pull * at.slide)
    panels = [each.reshape(*each.shape[:-2], 3, -1).sum(axis=-1) for each in powers]
    return np.concatenate(panels, axis=-1)


def _integrand(
    contact: RollingContact, traction: Traction, spin_rate: ArrayLike, *, nodes: tuple[int, int], sideways: bool
) -> _Integrand:
    require_positive(
        semi_axis_rolling=contact.semi_axis_rolling, semi_axis_transverse=contact.semi_axis_transverse, nodes=nodes
    )
    require_finite(spin_rate=spin_rate)
    names = ("load", "semi_axis_rolling", "semi_axis_transverse", "deformed_radius", "rolling_rate")
    try:
        arrays = np.broadcast_arrays(
            *(np.asarray(value, dtype=np.float64) for value in (*(getattr(contact, name) for name in names), spin_rate))
        )
    except ValueError as problem:
        raise InputError(
            "the arguments of a slip have shapes that do not fit together: give equal lengths"
        ) from problem
    load, rolling, transverse, radius, roll, spin = (array[..., None] for array in arrays)
    return _Integrand(
        traction=traction,
        pressure=1.5 * load / (np.pi * rolling * transverse),
        rolling=rolling,
        transverse=transverse,
        roll=roll * transverse**2 / (2 * radius),
        spin=np.abs(spin) * transverse,
        sideways=sideways,
        nodes=nodes,
    )


def _slip(
    contact: RollingContact,
    traction: Traction,
    spin_rate: ArrayLike,
    *,
    nodes: tuple[int, int],
    sideways: bool,
    near: SlipMoments | None,
) -> SlipMoments:
    integrand = _integrand(contact, traction, spin_rate, nodes=nodes, sideways=sideways)
    creep, stiffness = _forceless_creep(integrand, near)
    at = integrand.at(creep)
    pull, rolling, transverse = at.pull, integrand.rolling[..., None], integrand.transverse[..., None]
    return SlipMoments(
        spin_moment=np.sign(spin_rate) * _sum(pull * (at.slide * at.y * transverse + at.turn * at.x**2 * rolling)),
        rolling_moment=_sum(pull * at.slide * at.y**2)
        * np.asarray(contact.semi_axis_transverse) ** 2
        / (2 * np.asarray(contact.deformed_radius)),
        slip_power=_sum(at.friction * at.speed),
        unit_power=_sum(at.unit * at.speed),
        creep_speed=creep[..., 0],
        creep_stiffness=stiffness[..., 0],
    )


def _forceless_creep(integrand: _Integrand, near: SlipMoments | None) -> tuple[Array, Array]:
    """c of no net force and its stiffness, (*points, 1).

    Its bracket: at one end all friction points forwards, at the other backwards.
    """
    roll, spin = integrand.roll, integrand.spin
    vertex = -np.divide(spin, 2 * roll, out=np.ones_like(spin), where=spin < 2 * roll)
    low, high = (roll * vertex + spin) * vertex, roll + spin

    def rising(creep: Array) -> Array:
        at = integrand.at(creep)
        force, friction = _sum(at.pull * at.slide), _sum(at.friction)
        share = np.divide(force, friction, out=np.zeros_like(force), where=friction != 0)  # nan stays
        return np.where(np.abs(share) <= BALANCED, 0.0, -share)[..., None]

    if near is None:
        start, stiffness = _coulomb_creep(integrand)
    else:
        start, stiffness = near.creep_speed[..., None], near.creep_stiffness[..., None]
    secant = SecantSlopes(rising, stiffness)
    creep = bracketed_root(
        secant,
        start=np.clip(start, low, high),
        low=low,
        high=high,
        relative=LAST_STEP,
        sought=Sought(
            unit="of the slip speed",
            problem="the balance of friction in the direction of rolling",
            remedy="Check that the traction is finite, not negative and does not fall where the speed grows.",
        ),
    )
    return creep, secant.slopes


def _coulomb_creep(integrand: _Integrand) -> tuple[Array, Array]:
    """c and its stiffness by Coulomb friction on a long ellipse: where a search may begin."""
    roll, spin = integrand.roll, integrand.spin
    eps = np.divide(spin, 2 * roll, out=np.full_like(spin, ROLLS_NOT), where=spin < 2 * ROLLS_NOT * roll)
    lines = pure_rolling_lines(eps)
    width, slope = np.zeros_like(roll), np.hypot(spin, roll)
    for line in lines:
        width = width + np.maximum(1 - line**2, 0.0)
    stiffness = 1.5 * np.divide(width, slope, out=np.zeros_like(slope), where=slope > 0)
    return -roll * lines[0] * lines[1], stiffness


@cache
def _unit_gauss(nodes: int) -> tuple[Array, Array]:
    """Gauss-Legendre nodes and weights on 0 to 1."""
    x, weight = np.polynomial.legendre.leggauss(nodes)
    return (1 + x) / 2, weight / 2
