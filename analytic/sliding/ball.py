"""Friction of one ball that rolls and spins between its races, by three rungs from cheap to accurate.

`single_coefficient`: each contact slides with one coefficient, that of its mean pressure and mean sliding speed, and
its moments are the closed forms of `analytic.sliding.long_ellipse`. `along_axis`: the stress follows pressure and sliding from point to
point, the sliding across the major axis left out. `over_ellipse`: that sliding too. Leaving it out costs 1 % of the
torque by slip of a 6205. The single coefficient costs 0.4 to 5 % where the stress follows the pressure, up to 16 %
where the oil's stress is the same everywhere and asperities carry little (`validation/benchmarks/friction.py`).
Rates are per unit ring speed difference w and torques are slip power / w, as in `analytic.sliding.long_ellipse`; the law of traction
sees sliding speeds of |w| times as much.
"""

from collections.abc import Callable
from dataclasses import dataclass, fields, is_dataclass, replace
from functools import partial
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.root import bracketed_root, with_secant_slopes
from analytic.oil.traction import Traction
from analytic.scene import Array, Lubricant, SpinRule
from analytic.sliding.ellipse import NODES, SlipMoments, slip_along_axis, slip_over_ellipse
from analytic.sliding.long_ellipse import MicroslipTorque, SlidingContact, contact_moments, microslip_torque

Rung = Literal["single_coefficient", "along_axis", "over_ellipse"]
SLIP = {"along_axis": slip_along_axis, "over_ellipse": slip_over_ellipse}
ROUND_OFF = 4 * np.finfo(np.float64).eps  # of a spin moment, and of the share of spin that balances it
LAST_STEP = 1e-6  # of the share of spin: power is least at the balance, and so is wrong by the square of what is left
BLOCK = 32  # points at a time: a contact has 768 nodes


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceContact:
    """A ball on one race and what resists its sliding; one entry a ball or an operating point; the fields broadcast."""

    traction: Traction
    load: Array | float  # F, N, >= 0
    semi_axis_rolling: Array | float  # a, along rolling, m, >= 0, and not 0 under load
    semi_axis_transverse: Array | float  # b, across rolling, m, likewise
    deformed_radius: Array | float  # R, of the contact surface across rolling, m, > 0
    rolling_rate: Array | float  # w_roll/w, > 0

    def __post_init__(self) -> None:
        require_non_negative(
            load=self.load,
            semi_axis_rolling=self.semi_axis_rolling,
            semi_axis_transverse=self.semi_axis_transverse,
        )
        require_positive(deformed_radius=self.deformed_radius, rolling_rate=self.rolling_rate)

    @property
    def area(self) -> Array:
        """A_H = pi a b, m^2."""
        return np.pi * np.asarray(self.semi_axis_rolling) * np.asarray(self.semi_axis_transverse)

    def at(self, points: NDArray[np.intp] | slice, shape: tuple[int, ...]) -> "RaceContact":
        """Those of the contacts, of the given shape, that the first index chooses."""
        return _mapped(self, lambda value: np.broadcast_to(value, shape)[points])


@dataclass(frozen=True, kw_only=True, eq=False)
class SlipFriction:
    """Friction of one ball by slip on both races; arrays of one shape."""

    torque: MicroslipTorque  # with moments and spin rates
    inner_coefficient: Array  # of the Coulomb friction that would lose the same power at the same sliding; 0 unloaded
    outer_coefficient: Array
    inner_slip_speed: Array  # m/s, the mean that the pressure weighs
    outer_slip_speed: Array


def slip_friction(
    inner: RaceContact,
    outer: RaceContact,
    *,
    ring_speed: ArrayLike,
    spin_difference: ArrayLike,
    spin_rule: SpinRule,
    rung: Rung,
    nodes: tuple[int, int] = NODES,
) -> SlipFriction:
    """Torque of one ball from its slip on both races; all fields, ring_speed and spin_difference broadcast.

    ring_speed : w, inner less outer, rad/s, any sign; at 0 the law of traction is asked for its limit
    spin_difference : (w_s,i - w_s,o)/w, >= 0; sin(al) where the contact angles are equal
    spin_rule : as `race.microslip_torque`;  nodes : of a contact that is integrated, as `ellipse_slip`
    On the first rung each contact has the force of its law at the mean speed
        |v| = |w| [w_roll M_roll + w_s M_spin]/(mu Q)
    that goes with its share of spin. Its moment grows with that share on every rung, so that there is one balance.
    Repeating forces and shares in turn would find it too, but not where oil is viscous and both contacts spin in full.
    """
    require_finite(ring_speed=ring_speed)
    require_non_negative(spin_difference=spin_difference)
    given = [np.asarray(value, dtype=np.float64) for value in (ring_speed, spin_difference)]
    try:
        shape = np.broadcast_shapes(*(value.shape for value in given), _shape(inner), _shape(outer))
    except ValueError as problem:
        raise InputError("both contacts and their speeds have shapes that do not fit: give equal lengths") from problem
    speed, difference = (np.broadcast_to(value, shape) for value in (np.abs(given[0]), given[1]))
    if rung == "single_coefficient":
        columns = _single_coefficient(inner, outer, speed, difference, spin_rule)
    elif rung in SLIP:
        inner_race, outer_race = (
            _mapped(race, lambda value: np.broadcast_to(value, shape).ravel()) for race in (inner, outer)
        )
        slip = partial(SLIP[rung], nodes=nodes)
        speed, difference = speed.ravel(), difference.ravel()
        blocks = [
            _integrated(
                (inner_race.at(part, speed.shape), outer_race.at(part, speed.shape)),
                speed[part],
                difference[part],
                spin_rule,
                slip,
            )
            for part in np.array_split(np.arange(speed.size), max(1, -(-speed.size // BLOCK)))
        ]
        columns = tuple(np.concatenate(rows).reshape(shape) for rows in zip(*blocks, strict=True))
    else:
        raise InputError(f'rung must be "single_coefficient", "along_axis" or "over_ellipse", got {rung!r}')
    inner_rate, inner_spin, inner_roll, inner_coefficient, inner_slip = columns[:5]
    outer_rate, outer_spin, outer_roll, outer_coefficient, outer_slip = columns[5:]
    return SlipFriction(
        torque=MicroslipTorque(
            spin=inner_spin * inner_rate + outer_spin * outer_rate,
            conformity=inner_roll * inner.rolling_rate + outer_roll * outer.rolling_rate,
            inner_spin_rate=inner_rate,
            outer_spin_rate=outer_rate,
            inner_spin_moment=inner_spin,
            outer_spin_moment=outer_spin,
            inner_rolling_moment=inner_roll,
            outer_rolling_moment=outer_roll,
        ),
        inner_coefficient=inner_coefficient,
        outer_coefficient=outer_coefficient,
        inner_slip_speed=inner_slip,
        outer_slip_speed=outer_slip,
    )


# Of both ways to the result: for the inner and then the outer contact spin rate, spin moment, rolling moment,
# coefficient, slip speed.
Columns = tuple[Array, ...]


def _single_coefficient(
    inner: RaceContact, outer: RaceContact, speed: Array, difference: Array, spin_rule: SpinRule
) -> Columns:
    races = (inner, outer)
    laws = [race.traction.force(load=race.load, area=race.area) for race in races]
    if not (inner.traction.asks_speed or outer.traction.asks_speed):  # the forces are known: Coulomb's closed form
        forces = [np.broadcast_to(law(speed), speed.shape) for law in laws]
        torque = microslip_torque(
            _sliding(inner, forces[0]), _sliding(outer, forces[1]), spin_difference=difference, spin_rule=spin_rule
        )
        columns = (
            (torque.inner_spin_rate, torque.inner_spin_moment, torque.inner_rolling_moment),
            (torque.outer_spin_rate, torque.outer_spin_moment, torque.outer_rolling_moment),
        )
        return tuple(
            column
            for race, force, (rate, spin, roll) in zip(races, forces, columns, strict=True)
            for column in (
                *(rate, spin, roll, _over(force, race.load)),
                speed * _over(spin * rate + roll * race.rolling_rate, force),
            )
        )
    units = [_sliding(race, 1.0) for race in races]  # N of friction force

    def column(which: int, rate: Array) -> Columns:
        spin, roll = contact_moments(units[which], spin_rate=rate)
        slip = speed * (spin * rate + roll * races[which].rolling_rate)
        force = np.broadcast_to(laws[which](slip), speed.shape)
        return rate, force * spin, force * roll, _over(force, races[which].load), slip

    share = _inner_share(
        spin_rule, lambda x: (column(0, x * difference)[1], column(1, (x - 1) * difference)[1]), speed.shape
    )
    return *column(0, share * difference), *column(1, (share - 1) * difference)


def _inner_share(
    spin_rule: SpinRule, spin_moments: Callable[[Array], tuple[Array, Array]], shape: tuple[int, ...]
) -> Array:
    """Of the spin difference, what the inner contact takes; spin_moments: those of inner and outer at such a share."""
    none, whole = np.zeros(shape), np.ones(shape)
    if spin_rule == "inner_control":
        return none
    if spin_rule == "outer_control":
        return whole
    if spin_rule != "balanced":
        raise InputError(f'spin_rule must be "balanced", "inner_control" or "outer_control", got {spin_rule!r}')

    def excess(share: Array) -> Array:
        moment, other = spin_moments(share)
        return np.where(np.abs(moment + other) <= ROUND_OFF * moment, 0.0, moment + other)

    return bracketed_root(
        with_secant_slopes(excess, first_slope=2 * spin_moments(whole / 2)[0]),  # as if the moment grew evenly
        start=whole / 2,
        low=none,
        high=whole,
        relative=ROUND_OFF,
        absolute=LAST_STEP,
        unit="of the spin",
        problem="the balance of spin between both races",
        remedy="Check that loads, semi-axes, films and speeds of both contacts are of ordinary size.",
    )


def _sliding(race: RaceContact, force: ArrayLike) -> SlidingContact:
    """The contact whose mu Q is the force."""
    return SlidingContact(
        friction_coefficient=1.0,
        load=np.asarray(force),
        semi_axis_rolling=race.semi_axis_rolling,
        semi_axis_transverse=race.semi_axis_transverse,
        deformed_radius=race.deformed_radius,
        rolling_rate=race.rolling_rate,
    )


def _integrated(
    races: tuple[RaceContact, RaceContact],
    speed: Array,
    difference: Array,
    spin_rule: SpinRule,
    slip: Callable[..., SlipMoments],
) -> Columns:
    """By nodes of every contact; all numbers (n,). Both races go in one call: most callers have few points."""
    n = speed.size

    def both(name: str) -> Array:
        return np.concatenate([getattr(race, name) for race in races])

    loaded, load = both("load") > 0, both("load")  # a contact without load is a point and has no friction
    along, across = (np.where(loaded, both(f"semi_axis_{name}"), 1.0) for name in ("rolling", "transverse"))
    laws = [_mapped(race.traction, lambda value: np.asarray(value)[..., None]) for race in races]
    fast = speed[:, None]

    def traction(pressure: Array, slide: Array) -> Array:
        halves = zip(laws, (slice(n), slice(n, None)), strict=True)
        return np.concatenate([law.stress(pressure[half], fast * slide[half]) for law, half in halves])

    def moments(share: Array) -> SlipMoments:
        found = slip(
            traction=traction,
            peak_pressure=1.5 * load / (np.pi * along * across),
            semi_axis_rolling=along,
            semi_axis_transverse=across,
            deformed_radius=both("deformed_radius"),
            rolling_rate=both("rolling_rate"),
            spin_rate=np.concatenate([share * difference, (share - 1) * difference]),
        )
        return SlipMoments(**{name: loaded * value for name, value in vars(found).items()})

    def spin_moments(share: Array) -> tuple[Array, Array]:
        spin = moments(share).spin_moment
        return spin[:n], spin[n:]

    share = _inner_share(spin_rule, spin_moments, speed.shape)
    found = moments(share)
    rate = np.concatenate([share * difference, (share - 1) * difference])
    columns = (
        *(rate, found.spin_moment, found.rolling_moment, _over(found.slip_power, found.unit_power)),
        np.concatenate([speed, speed]) * _over(found.unit_power, load),
    )
    return *(column[:n] for column in columns), *(column[n:] for column in columns)


def _over(numerator: Array, denominator: ArrayLike) -> Array:
    """The quotient, and 0 where the denominator is."""
    top, bottom = np.broadcast_arrays(numerator, denominator)
    return np.divide(top, bottom, out=np.zeros(top.shape), where=bottom > 0)


def _shape(noun: Any) -> tuple[int, ...]:
    """The broadcast shape of all numbers in a contact or a law of traction."""
    values = [getattr(noun, field.name) for field in fields(noun)]
    return np.broadcast_shapes(
        *(
            _shape(value) if is_dataclass(value) else np.shape(value)
            for value in values
            if not isinstance(value, Lubricant)
        )
    )


def _mapped(noun: Any, change: Callable[[Any], Array]) -> Any:
    """A contact or a law of traction with every number of it changed."""
    values = {field.name: getattr(noun, field.name) for field in fields(noun)}
    return replace(
        noun,
        **{
            name: _mapped(value, change) if is_dataclass(value) else change(value)
            for name, value in values.items()
            if not isinstance(value, Lubricant)
        },
    )
