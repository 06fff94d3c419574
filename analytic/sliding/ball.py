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
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.contact.rolling_contact import ContactNumbers, Pair, contact_at
from analytic.errors import InputError, require_finite, require_non_negative, require_positive
from analytic.numerics.compilation import compiled, rows_of
from analytic.numerics.records import Record
from analytic.oil.traction import PointLaw, Traction, law_at
from analytic.scene import Array, SlidingMethod, SpinRule
from analytic.sliding.ellipse import (
    BALANCED,
    NO_SUMS,
    NODES,
    Slider,
    SlipSums,
    forceless_slip,
    quadrature_of,
    require_forceless,
    slider_of,
)
from analytic.sliding.long_ellipse import (
    MicroslipTorque,
    Slip,
    balanced_line,
    code_of,
    line_laws,
    line_slip,
    require_balance,
    slip_along_lines,
)

INTEGRATED = {"along_axis": False, "over_ellipse": True}  # whether sideways
NEARLY_BALANCED = 1e-7  # net force over all friction while the share of spin is sought; the last search is exact
LAST_STEP = 1e-6  # of the share of spin: the power is least at the balance, so its error is the square of this step
MOST_STEPS = 100  # of the share of spin; 3 to 6 are usual
BLOCK = 1 << 14  # points at a time: each has 36 numbers

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
) -> SlipFriction:
    """Torque of one ball from its slip on both races; all fields, ring_speed and spin_difference broadcast.

    contacts, traction : on the inner and the outer race
    ring_speed : w, inner less outer, rad/s, any sign; at 0 the law of traction gives its limit
    spin_difference : (w_s,i - w_s,o)/w, >= 0; sin(al) if the contact angles are equal
    spin_rule : as in `long_ellipse.microslip_torque`
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
    laws = traction[0].point_law, traction[1].point_law
    numbers = (*contacts[0].fields, *contacts[1].fields, *laws[0], *laws[1], speed, difference)
    try:
        shape = np.broadcast_shapes(*map(np.shape, numbers))
    except ValueError as problem:
        raise InputError("both contacts and their speeds have shapes that do not fit: give equal lengths") from problem
    if rule.method == "single_coefficient":
        fields = slip_along_lines(contacts, laws, ring_speed=speed, spin_difference=difference, spin_rule=spin_rule)
    elif rule.method in INTEGRATED:
        code, quadrature = code_of(spin_rule), quadrature_of(rule.nodes)
        fields = _in_blocks(numbers, shape, lambda rows: _integrated(rows, code, quadrature, INTEGRATED[rule.method]))
    else:
        raise InputError(f'method must be "single_coefficient", "along_axis" or "over_ellipse", got {rule.method!r}')
    inner, outer = (dict(zip(Slip._fields, fields[first : first + 6], strict=True)) for first in (0, 6))
    return SlipFriction(
        torque=MicroslipTorque.of(
            contacts,
            spin_rates=(inner["spin_rate"], outer["spin_rate"]),
            spin_moments=(inner["spin_moment"], outer["spin_moment"]),
            rolling_moments=(inner["rolling_moment"], outer["rolling_moment"]),
        ),
        inner_coefficient=inner["coefficient"],
        outer_coefficient=outer["coefficient"],
        inner_slip_speed=inner["slip_speed"],
        outer_slip_speed=outer["slip_speed"],
        inner_creep=inner["creep"],
        outer_creep=outer["creep"],
    )


@compiled
def at_ring_speed(law: PointLaw, ring_speed: float) -> PointLaw:
    """The law over slip per unit ring speed; ring_speed : |w|, rad/s. At standstill it is that of slow sliding."""
    fluidity = law.fluidity if law.fluidity == np.inf else law.fluidity * ring_speed
    return PointLaw(law.boundary, law.plain, law.limit, law.eyring, fluidity, law.share, law.growth, law.exponent)


@compiled
def _moment_and_slope(slider: Slider, sums: SlipSums) -> tuple[float, float]:
    """|M_spin|, N m, and its slope over |w_s|, N m s, along the c of no net force."""
    follows = sums.mixed**2 / sums.by_creep if sums.by_creep > 0.0 else 0.0
    return slider.transverse * sums.spin, slider.transverse**2 * max(sums.by_spin - follows, 0.0)


@compiled
def slips_over_contacts(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    ring_speed: float,
    spin_difference: float,
    rule: int,
    quadrature: Record,
    sideways: bool,
) -> tuple[Slip, Slip, int]:
    """The slip of a ball on both races by integrals; arguments as `long_ellipse.line_slips`, and `ellipse.slip_sums`.

    The last is the number of integrals, 0 where one has no c. Newton's method in a bracket finds the share of the spin
    on the inner race. It begins at that of `long_ellipse.balanced_line`.
    """
    inner, outer = slider_of(contacts[0]), slider_of(contacts[1])
    inner_law, outer_law = at_ring_speed(laws[0], ring_speed), at_ring_speed(laws[1], ring_speed)
    share, rest, lines = float(rule - 1), float(2 - rule), line_laws(contacts, laws)
    if rule == 0:
        share, rest = balanced_line(contacts, lines, ring_speed, spin_difference)
    creep = line_slip(contacts[0], lines[0], ring_speed, share * spin_difference)[0].creep
    other_creep = line_slip(contacts[1], lines[1], ring_speed, rest * spin_difference)[0].creep
    low, high, step, before, count = 0.0, 1.0, 1.0, 1.0, 0
    sums = other = NO_SUMS
    for _ in range(MOST_STEPS):
        nearly = NEARLY_BALANCED if rule == 0 and abs(step) > LAST_STEP else BALANCED
        spin, other_spin = share * spin_difference * inner.transverse, rest * spin_difference * outer.transverse
        creep, sums, number = forceless_slip(inner, inner_law, creep, spin, quadrature, sideways, nearly)
        other_creep, other, more = forceless_slip(
            outer, outer_law, other_creep, other_spin, quadrature, sideways, nearly
        )
        count += number + more
        if number == 0 or more == 0:
            count = 0
            break
        moment, slope = _moment_and_slope(inner, sums)
        other_moment, other_slope = _moment_and_slope(outer, other)
        left = moment - other_moment
        if rule != 0 or abs(step) <= LAST_STEP or left == 0.0:
            break
        if left < 0.0:
            low = share
        else:
            high = share
        slopes = spin_difference * (slope + other_slope)
        last = step
        step = -left / slopes if slopes > 0.0 else np.inf
        if not (low <= share + step <= high and abs(step) <= abs(before) / 2):
            step = (low + high) / 2 - share
        before = last
        if sums.by_creep > 0.0:
            creep += sums.mixed / sums.by_creep * step * spin_difference * inner.transverse
        if other.by_creep > 0.0:
            other_creep -= other.mixed / other.by_creep * step * spin_difference * outer.transverse
        share, rest = share + step, rest - step
    return (
        _slip(contacts[0], inner, sums, share * spin_difference, ring_speed, creep),
        _slip(contacts[1], outer, other, -rest * spin_difference, ring_speed, other_creep),
        count,
    )


@compiled
def _slip(
    contact: ContactNumbers, slider: Slider, sums: SlipSums, rate: float, ring_speed: float, creep: float
) -> Slip:
    return Slip(
        rate,
        np.sign(rate) * slider.transverse * sums.spin,
        sums.rolling * slider.transverse**2 / (2 * contact.deformed_radius),
        sums.power / sums.unit if sums.unit > 0.0 else 0.0,
        ring_speed * sums.unit / contact.load if contact.load > 0.0 else 0.0,
        creep if contact.load > 0.0 else 0.0,
    )


@compiled
def _slips_of_each(rows: Array, rule: int, quadrature: Record, sideways: bool) -> Array:
    fields = np.empty((13, rows.shape[1]))
    for i in range(rows.shape[1]):
        contacts, laws = (contact_at(rows, 0, i), contact_at(rows, 9, i)), (law_at(rows, 18, i), law_at(rows, 26, i))
        inner, outer, count = slips_over_contacts(contacts, laws, rows[34, i], rows[35, i], rule, quadrature, sideways)
        for k in range(6):
            fields[k, i], fields[6 + k, i] = inner[k], outer[k]
        fields[12, i] = count
    return fields


def _integrated(rows: Array, rule: int, quadrature: Record, sideways: bool) -> Array:
    fields = _slips_of_each(rows, rule, quadrature, sideways)
    require_balance(fields)
    require_forceless(fields[12])
    return fields


def _in_blocks(numbers: tuple[Any, ...], shape: tuple[int, ...], evaluate: Callable[[Array], Array]) -> Array:
    """(k, *shape) of compiled loops over numbers that broadcast to this shape, some points at a time."""
    flat = [np.broadcast_to(number, shape).reshape(-1) for number in numbers]
    size = flat[0].size
    blocks = [
        evaluate(rows_of(*(number[start : start + BLOCK] for number in flat))[0])
        for start in range(0, max(size, 1), BLOCK)
    ]
    return np.concatenate(blocks, axis=1).reshape(-1, *shape)
