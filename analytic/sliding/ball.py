"""Friction of one ball that rolls and spins between its races, by three methods from cheap to accurate.

- `single_coefficient`: each contact slides with one coefficient, that of its mean pressure and mean sliding speed. Its
  moments are the closed forms of `analytic.sliding.long_ellipse`. The error is 0.4 to 5 % where the stress follows the
  pressure, and up to 16 % where the oil's stress is the same everywhere and asperities carry little
  (`validation/benchmarks/friction.py`).
- `along_axis`: the stress follows pressure and sliding from point to point, without the sliding transverse to the
  direction of rolling. The error is 1 % of the torque by slip of a 6205.
- `over_ellipse`: with sliding in both directions.
Rates are per unit ring speed difference w and torques are slip power over w, as in `analytic.sliding.long_ellipse`. The
law of traction takes the true sliding speeds, which are |w| times as large.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.rolling_contact import Pair, RollingContact
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.root import SecantSlopes, Sought, bracketed_root
from analytic.oil.traction import Traction
from analytic.scene import Array, Lubricant, SlidingMethod, SpinRule
from analytic.sliding.ellipse import NODES, SlipMoments, power_of_panels, slip_along_axis, slip_over_ellipse
from analytic.sliding.long_ellipse import MicroslipTorque, contact_moments, long_ellipse_creep, microslip_torque

SLIP = {"along_axis": slip_along_axis, "over_ellipse": slip_over_ellipse}
ROUND_OFF = 4 * np.finfo(np.float64).eps  # of a spin moment, and of the share of spin that balances it
LAST_STEP = 1e-6  # of the share of spin: the power is least at the balance, so its error is the square of this step
EDGE = 1e-3  # a share of spin at which the search may begin
BLOCK = 32  # points at a time: a contact has 768 nodes

Tractions = tuple[Traction, Traction]  # on the inner and on the outer race


@dataclass(frozen=True, kw_only=True, eq=False)
class SlipFriction:
    """Friction of one ball by slip on both races; arrays of one shape."""

    torque: MicroslipTorque  # with moments and spin rates
    inner_coefficient: Array  # of the Coulomb friction that loses the same power at the same sliding; 0 without load
    outer_coefficient: Array
    inner_slip_speed: Array  # m/s, mean weighted by the pressure
    outer_slip_speed: Array
    inner_creep: Array  # c over the ring speed, m, as in `analytic.sliding.ellipse`
    outer_creep: Array


class SlipRule(NamedTuple):
    """How slip is integrated over a contact."""

    method: SlidingMethod
    nodes: tuple[int, int] = NODES  # of the quadrature, transverse and rolling, as in `ellipse`


def slip_friction(
    contacts: Pair,
    traction: Tractions,
    *,
    ring_speed: ArrayLike,
    spin_difference: ArrayLike,
    spin_rule: SpinRule,
    rule: SlipRule,
    near: SlipFriction | None = None,
) -> SlipFriction:
    """Torque of one ball from its slip on both races; all fields, ring_speed and spin_difference broadcast.

    contacts, traction : on the inner and the outer race
    ring_speed : w, inner less outer, rad/s, any sign; at 0 the law of traction gives its limit
    spin_difference : (w_s,i - w_s,o)/w, >= 0; sin(al) if the contact angles are equal
    spin_rule : as in `long_ellipse.microslip_torque`
    near : a result by another method; an integral begins the search of the spin there
    With `single_coefficient` each contact has the force of its law at the mean sliding speed
        |v| = |w| [w_roll M_roll + w_s M_spin]/(mu Q)
    of its share of the spin. With every method the moment of a contact grows with this share, so there is one balance.
    A fixed-point iteration between forces and shares would fail where the oil is viscous and both contacts spin in
    full.
    Raises InputError for arguments that do not broadcast, a negative spin_difference, a contact that does not roll, an
    unknown rule or method.
    """
    require_finite(ring_speed=ring_speed)
    require_non_negative(spin_difference=spin_difference)
    for contact in contacts:
        require_positive(rolling_rate=contact.rolling_rate)
    speed, difference = np.abs(np.asarray(ring_speed, dtype=np.float64)), np.asarray(spin_difference, dtype=np.float64)
    numbers = (value for each in (*contacts, *traction) for value in _numbers(each).values())
    try:
        shape = np.broadcast_shapes(speed.shape, difference.shape, *map(np.shape, numbers))
    except ValueError as problem:
        raise InputError("both contacts and their speeds have shapes that do not fit: give equal lengths") from problem
    speed, difference = (np.broadcast_to(value, shape) for value in (speed, difference))
    if rule.method == "single_coefficient":
        columns = _single_coefficient(contacts, traction, speed, difference, spin_rule)
    elif rule.method in SLIP:
        slip = partial(SLIP[rule.method], nodes=rule.nodes)
        start = np.full(shape, 0.5)
        if near is not None:
            rate = np.broadcast_to(near.torque.inner_spin_rate, shape)
            start = np.divide(rate, difference, out=start, where=difference > 0)
        columns = _in_blocks(
            lambda pair, laws, *speeds: _integrated(pair, laws, speeds, spin_rule, slip),
            *(contacts, traction, speed, difference, start),
        )
    else:
        raise InputError(f'method must be "single_coefficient", "along_axis" or "over_ellipse", got {rule.method!r}')
    inner_rate, inner_spin, inner_roll, inner_coefficient, inner_slip, inner_creep = columns[:6]
    outer_rate, outer_spin, outer_roll, outer_coefficient, outer_slip, outer_creep = columns[6:]
    return SlipFriction(
        torque=MicroslipTorque.of(
            contacts,
            spin_rates=(inner_rate, outer_rate),
            spin_moments=(inner_spin, outer_spin),
            rolling_moments=(inner_roll, outer_roll),
        ),
        inner_coefficient=inner_coefficient,
        outer_coefficient=outer_coefficient,
        inner_slip_speed=inner_slip,
        outer_slip_speed=outer_slip,
        inner_creep=inner_creep,
        outer_creep=outer_creep,
    )


def slip_power(
    contacts: Pair,
    traction: Tractions,
    sliding: SlipFriction,
    *,
    ring_speed: ArrayLike,
    nodes: tuple[int, int],
    sideways: bool,
) -> Array:
    """Powers over w of each race and panel, N m, at spin and creep that are known; (2, 2, 3, *shape of sliding).

    Races, then slip and net force, then panels; see `ellipse.power_of_panels`.

    sliding : by any method and nodes; its creep and spin rates count. Panels as in `ellipse.slip_power`
    nodes, sideways : of the one evaluation of the integrals
    """
    torque = sliding.torque
    rates = (torque.inner_spin_rate, torque.outer_spin_rate)
    fields = (np.abs(np.asarray(ring_speed, dtype=np.float64)), *rates, sliding.inner_creep, sliding.outer_creep)
    shape = sliding.inner_creep.shape

    def panels(pair: Pair, laws: Tractions, fast: Array, *known: Array) -> Columns:
        both = _Stacked.of(pair, laws, fast)
        power = power_of_panels(
            both.contact,
            traction=both.stress,
            spin_rate=np.concatenate(known[:2]),
            creep_speed=np.concatenate(known[2:]),
            nodes=nodes,
            sideways=sideways,
        )
        power = both.loaded[:, None] * power
        return *power[: fast.size].T, *power[fast.size :].T

    columns = _in_blocks(panels, contacts, traction, *(np.broadcast_to(field, shape) for field in fields))
    return np.stack(columns).reshape(2, 2, 3, *shape)


def _in_blocks(evaluate: Callable[..., "Columns"], contacts: Pair, traction: Tractions, *fields: Array) -> "Columns":
    """Columns of evaluate(contacts, traction, *fields) of one shape, a block of points at a time."""
    shape = fields[0].shape
    flat = with_numbers(contacts, traction, lambda value: np.broadcast_to(value, shape).ravel())
    numbers = [field.ravel() for field in fields]
    blocks = []
    for part in np.array_split(np.arange(numbers[0].size), max(1, -(-numbers[0].size // BLOCK))):
        block = with_numbers(*flat, lambda value, part=part: value[part])
        blocks.append(evaluate(*block, *(number[part] for number in numbers)))
    return tuple(np.concatenate(rows).reshape(shape) for rows in zip(*blocks, strict=True))


# For the inner and then the outer contact: spin rate, spin moment, rolling moment, coefficient, slip speed, creep.
Columns = tuple[Array, ...]


def _single_coefficient(
    contacts: Pair, traction: Tractions, speed: Array, difference: Array, spin_rule: SpinRule
) -> Columns:
    laws = [law.force(contact) for law, contact in zip(traction, contacts, strict=True)]
    if not any(law.depends_on_speed for law in traction):  # the forces are known: Coulomb's closed form
        forces = tuple(np.broadcast_to(law(speed), speed.shape) for law in laws)
        torque = microslip_torque(
            contacts, friction_force=(forces[0], forces[1]), spin_difference=difference, spin_rule=spin_rule
        )
        moments = (
            (torque.inner_spin_rate, torque.inner_spin_moment, torque.inner_rolling_moment),
            (torque.outer_spin_rate, torque.outer_spin_moment, torque.outer_rolling_moment),
        )
        return tuple(
            column
            for contact, force, (rate, spin, roll) in zip(contacts, forces, moments, strict=True)
            for column in (
                *(rate, spin, roll, _over(force, contact.load)),
                speed * _over(spin * rate + roll * contact.rolling_rate, force),
                long_ellipse_creep(contact, spin_rate=rate),
            )
        )

    def columns(race: int, rate: Array) -> Columns:
        spin, roll = contact_moments(contacts[race], friction_force=1.0, spin_rate=rate)  # per N of friction
        slip = speed * (spin * rate + roll * contacts[race].rolling_rate)
        force = np.broadcast_to(laws[race](slip), speed.shape)
        creep = long_ellipse_creep(contacts[race], spin_rate=rate)
        return rate, force * spin, force * roll, _over(force, contacts[race].load), slip, creep

    share = _inner_share(
        spin_rule,
        lambda x: (columns(0, x * difference)[1], columns(1, (x - 1) * difference)[1]),
        np.full(speed.shape, 0.5),
    )
    return *columns(0, share * difference), *columns(1, (share - 1) * difference)


def _inner_share(spin_rule: SpinRule, spin_moments: Callable[[Array], tuple[Array, Array]], start: Array) -> Array:
    """Share of the spin difference on the inner race; spin_moments: share -> moments on inner and outer race.

    start : a guess, above 0 and below 1
    """
    none, whole = np.zeros_like(start), np.ones_like(start)
    if spin_rule == "inner_control":
        return none
    if spin_rule == "outer_control":
        return whole
    if spin_rule != "balanced":
        raise InputError(f'spin_rule must be "balanced", "inner_control" or "outer_control", got {spin_rule!r}')

    def excess(share: Array) -> Array:
        moment, other = spin_moments(share)
        return np.where(np.abs(moment + other) <= ROUND_OFF * moment, 0.0, moment + other)

    start = np.clip(start, EDGE, 1 - EDGE)
    moment, other = spin_moments(start)
    slope = moment / start - other / (1 - start)  # as if the moments grew evenly: the step ends between 0 and 1
    step = np.divide(moment + other, slope, out=np.zeros_like(start), where=slope > 0)
    return bracketed_root(
        SecantSlopes(excess, slope),
        start=np.clip(start - step, none, whole),
        low=none,
        high=whole,
        relative=ROUND_OFF,
        absolute=LAST_STEP,
        sought=Sought(
            unit="of the spin",
            problem="the balance of spin between both races",
            remedy="Check that loads, semi-axes, films and speeds of both contacts are of ordinary size.",
        ),
    )


def _integrated(
    contacts: Pair,
    traction: Tractions,
    speeds: tuple[Array, ...],
    spin_rule: SpinRule,
    slip: Callable[..., SlipMoments],
) -> Columns:
    """Integrals over every contact; all numbers (n,).

    speeds : ring speed, spin difference, and a guess of its share on the inner race
    One call integrates both races, because most callers have few points.
    """
    speed, difference, start = speeds
    n = speed.size
    both = _Stacked.of(contacts, traction, speed)
    last: SlipMoments | None = None

    def moments(share: Array) -> SlipMoments:
        nonlocal last
        rate = np.concatenate([share * difference, (share - 1) * difference])
        last = slip(both.contact, traction=both.stress, spin_rate=rate, near=last)
        return SlipMoments(**{name: both.loaded * value for name, value in vars(last).items()})

    def spin_moments(share: Array) -> tuple[Array, Array]:
        spin = moments(share).spin_moment
        return spin[:n], spin[n:]

    share = _inner_share(spin_rule, spin_moments, start)
    result = moments(share)
    columns = (
        *(np.concatenate([share * difference, (share - 1) * difference]), result.spin_moment, result.rolling_moment),
        *(
            _over(result.slip_power, result.unit_power),
            np.concatenate([speed, speed]) * _over(result.unit_power, both.load),
        ),
        result.creep_speed,
    )
    return *(column[:n] for column in columns), *(column[n:] for column in columns)


@dataclass(frozen=True, kw_only=True, eq=False)
class _Stacked:
    """Both races of n points as one array of 2 n contacts. One without load is a point, and gets semi-axes of 1."""

    contact: RollingContact
    load: Array
    loaded: NDArray[np.bool_]
    stress: Callable[[Array, Array], Array]  # of pressure and speed over the ring speed

    @classmethod
    def of(cls, contacts: Pair, traction: Tractions, ring_speed: Array) -> "_Stacked":
        n = ring_speed.size
        both = {name: np.concatenate([getattr(contact, name) for contact in contacts]) for name in vars(contacts[0])}
        loaded = both["load"] > 0
        for name in ("semi_axis_rolling", "semi_axis_transverse"):
            both[name] = np.where(loaded, both[name], 1.0)
        laws = [_changed(law, lambda value: np.asarray(value)[..., None]) for law in traction]
        fast = ring_speed[:, None]

        def stress(pressure: Array, slide: Array) -> Array:
            halves = zip(laws, (slice(n), slice(n, None)), strict=True)
            return np.concatenate([law.stress(pressure[half], fast * slide[half]) for law, half in halves])

        return cls(contact=RollingContact(**both), load=both["load"], loaded=loaded, stress=stress)


def _over(numerator: Array, denominator: ArrayLike) -> Array:
    """The quotient, and 0 where the denominator is 0."""
    top, bottom = np.broadcast_arrays(numerator, denominator)
    return np.divide(top, bottom, out=np.zeros(top.shape), where=bottom > 0)


def with_numbers(contacts: Pair, traction: Tractions, change: Callable[[Any], Any]) -> tuple[Pair, Tractions]:
    """Both contacts and both laws of traction, with `change` applied to every number in them."""
    (inner, outer), (inner_law, outer_law) = contacts, traction
    pair = _changed(inner, change), _changed(outer, change)
    return pair, (_changed(inner_law, change), _changed(outer_law, change))


ContactOrLaw = TypeVar("ContactOrLaw", RollingContact, Traction)


def _changed(each: ContactOrLaw, change: Callable[[Any], Any]) -> ContactOrLaw:
    return replace(each, **{name: change(value) for name, value in _numbers(each).items()})


def _numbers(each: RollingContact | Traction) -> dict[str, Any]:
    return {name: value for name, value in vars(each).items() if not isinstance(value, Lubricant)}
