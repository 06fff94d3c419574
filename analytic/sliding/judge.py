"""How wrong a method of sliding is at one ball, by other nodes over the whole ellipse.

The power by the method's own nodes is compared with that by other nodes at the spin and the creep that the method
found. This sees the error of the nodes and what the method leaves out. Spin and creep matter in second order with
Coulomb friction; else the net force by the other nodes shows them. Without conformity they matter in first order, and
the other nodes find their own (`judged_spin`). Differences add up with their magnitudes over races and panels, so that
they do not cancel by chance. Where a kink of the stress is all that the nodes miss, two sets of nodes may agree by
chance: three rarely do.
The estimate is the difference times a safety factor. It is no bound. The random balls of
`validation/benchmarks/friction.py --nodes` needed a factor of at most 1.9 for `single_coefficient` and `along_axis`,
and 2.4 for `over_ellipse`.
"""

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Records
from analytic.oil.traction import PointLaw
from analytic.scene import SlidingMethod
from analytic.sliding.ball import at_ring_speed, slips_over_contacts
from analytic.sliding.ellipse import quadrature_of, slider_of, slip_sums
from analytic.sliding.long_ellipse import Slip

SINGLE_COEFFICIENT, ALONG_AXIS, OVER_ELLIPSE, FINE, AS_PRINTED = range(5)
METHODS: tuple[SlidingMethod, ...] = ("single_coefficient", "along_axis", "over_ellipse", "over_ellipse")
# Nodes over a contact: first those of a method over the ellipse, then those that judge them and are nobody's own.
NODES = np.stack([quadrature_of(nodes) for nodes in ((12, 8), (24, 24), (17, 13), (37, 41), (48, 48))])
OWN_NODES = (0, 0, 0, 1)  # of each method in NODES; a single coefficient is judged by them
JUDGES = ((0, 0), (1, 1), (2, 1), (3, 4))  # in NODES
SAFETY = 2.0  # times the difference of two sets of nodes
SAFETY_OF_THREE = 3.0  # times the larger difference of three, over the whole ellipse
# Times the change from coarser nodes: the error was 0.06 of it where finer nodes agreed by chance.
LEFT_OF_COARSER = 0.25
LEAST = 1e-6  # the estimate of an error that is smaller: of creep and spin, and of the judging nodes: 6e-7 at most


@compiled
def judged(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    slips: tuple[Slip, Slip],
    ring_speed: float,
    method: int,
    nodes: Records,
) -> tuple[float, float]:
    """What a method misses of a ball's power over the ring speed, and that power, N m.

    contacts, laws, slips : on inner and outer race, as the method found them;  ring_speed : |w|, rad/s
    method : SINGLE_COEFFICIENT to FINE;  nodes : NODES
    """
    missed = whole = slipped = first_force = second_force = 0.0
    for race in range(2):
        contact, slip, law = contacts[race], slips[race], at_ring_speed(laws[race], ring_speed)
        slider = slider_of(contact)
        own = slip.spin_moment * slip.spin_rate + slip.rolling_moment * contact.rolling_rate
        powers = np.zeros((3, 4))  # by the own nodes, and by both judges: of three panels, and of the net force
        for which in range(3):
            if which == 2 and JUDGES[method][0] == JUDGES[method][1]:
                for k in range(4):
                    powers[2, k] = powers[1, k]
                continue
            number = OWN_NODES[method] if which == 0 else JUDGES[method][which - 1]
            sideways = which > 0 or method != ALONG_AXIS
            spin = abs(slip.spin_rate) * slider.transverse
            sums = slip_sums(slider, law, slip.creep, spin, nodes[number], sideways)
            powers[which, 0], powers[which, 1] = sums.far_power, sums.middle_power
            powers[which, 2], powers[which, 3] = sums.near_power, slip.creep * sums.force
            if method == SINGLE_COEFFICIENT:
                break
        if method == SINGLE_COEFFICIENT:
            missed += SAFETY * max(abs(powers[0, 0] + powers[0, 1] + powers[0, 2] - own), abs(powers[0, 3]))
            whole += own
            continue
        for k in range(3):
            whole += powers[0, k]
            slipped += max(abs(powers[1, k] - powers[0, k]), abs(powers[2, k] - powers[0, k]))
        first_force += abs(powers[1, 3] - powers[0, 3])
        second_force += abs(powers[2, 3] - powers[0, 3])
    safety = SAFETY if method == ALONG_AXIS else SAFETY_OF_THREE
    return missed + safety * max(slipped, first_force, second_force), whole


@compiled
def judged_spin(
    contacts: tuple[ContactNumbers, ContactNumbers],
    laws: tuple[PointLaw, PointLaw],
    slips: tuple[Slip, Slip],
    ring_speed: float,
    rule: int,
    method: int,
    nodes: Records,
) -> tuple[float, float]:
    """As `judged`, of the power by spin alone; infinite where no creep is found.

    The power by spin and conformity together is least at the creep that is found, that by spin alone is not: an error
    of the creep counts in first order. Other nodes therefore find their own creep and their own share of the spin.
    rule : as `analytic.sliding.long_ellipse.line_slips`
    """
    whole = missed = 0.0
    difference = abs(slips[0].spin_rate - slips[1].spin_rate)
    first, last = (1, 2) if method < FINE else (2, 4)  # in NODES
    for number in range(first, last + 1):
        others = slips_over_contacts(contacts, laws, ring_speed, difference, rule, nodes[number], True)
        if others[2] == 0:
            return np.inf, 0.0
        change = whole = 0.0
        for race in range(2):
            own = slips[race].spin_moment * slips[race].spin_rate
            other = others[0] if race == 0 else others[1]
            change += abs(other.spin_moment * other.spin_rate - own)
            whole += own
        safety = SAFETY if method <= ALONG_AXIS else SAFETY_OF_THREE
        missed = max(missed, (LEFT_OF_COARSER if method == FINE and number == first else safety) * change)
    return missed, whole


@compiled
def error_of(missed: float, whole: float) -> float:
    """The estimate for sums over the balls of both numbers of `judged`, N m."""
    return missed + LEAST * whole if whole > 0.0 else 0.0
