"""Micro-slip with any law of traction, integrated over the contact ellipse.

x is the direction of rolling, y is transverse, both from the contact's centre. The pressure is
p0 sqrt(1 - x^2/a^2 - y^2/b^2). A ball that rolls with w_roll and spins with w_s over a surface of radius R slides by
    v_x = w_roll y^2/(2 R) + w_s y - c,  v_y = -x (w_s + w_roll y/R)
as it turns about the normal of the curved surface by w_s + w_roll y/R.
Every point resists with a stress against v, which is a function of pressure and speed. c leaves no net force:
    M_spin = int tau (v_x y - v_y x)/|v| dA,  M_roll = int tau (v_x y^2/2 - v_y x y)/(R |v|) dA,  0 = int tau v_x/|v| dA
Without v_y this is the limit of a long ellipse, and with Coulomb friction its moments are those of
`analytic.sliding.long_ellipse.microslip_moments`; the stress still follows the pressure along rolling. Elastic creep is
left out; `analytic.free_ball` has it. A law with a kink, such as a cap, needs more nodes.
Source: derived here.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from analytic.contact.rolling_contact import ContactNumbers
from analytic.errors import ConvergenceError
from analytic.numerics.compilation import compiled
from analytic.numerics.records import Record
from analytic.oil.traction import PointLaw, eyring_stress, own_stress
from analytic.scene import Array

BALANCED = 1e-8  # net force that counts as none, over all friction: the power errs by about its square
LAST_STEP = 1e-9  # of c, relative: where a law with a kink leaves no better balance
LEAST_GAIN = 0.5  # of a step: where the net force falls by less, the next one halves the bracket
RESOLVED = 1e-5  # a/b, from which nodes at the end of a panel see v_y
MOST_STEPS = 200  # 4 to 8 are usual; halving the bracket alone takes 60
MOST_NODES = 96  # in either direction

QUADRATURE = np.dtype(
    [
        ("across", "i8"),  # nodes of a transverse panel
        ("along", "i8"),  # nodes along rolling, from the middle to the end
        ("places", "f8", MOST_NODES),  # in a panel, from 0 to 1
        ("widths", "f8", MOST_NODES),  # their weights
        ("reaches", "f8", MOST_NODES),  # along rolling, from 0 to 1
        ("lengths", "f8", MOST_NODES),  # their weights
    ],
    align=True,
)


class Slider(NamedTuple):
    """A contact as its slip sees it. Rates per unit ring speed w make every speed a length."""

    peak: float  # p0, Pa
    rolling: float  # a, m
    transverse: float  # b, m
    roll: float  # w_roll b^2/(2 R), m/s


class SlipSums(NamedTuple):
    """Integrals over a contact at a creep speed c and a spin w_s b, and slopes by both."""

    force: float  # int tau v_x/|v| dA, N
    spin: float  # M_spin/b, N
    rolling: float  # M_roll 2 R/b^2, N
    power: float  # int tau |v| dA, W
    unit: float  # int p |v| dA, W
    friction: float  # int tau dA, N
    by_creep: float  # -d force/dc, N s/m, >= 0
    mixed: float  # d force/d spin = -d(spin moment)/dc
    by_spin: float  # d(spin moment)/d spin, >= 0


NO_SUMS = SlipSums(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


@compiled
def slider_of(contact: ContactNumbers) -> Slider:
    """A contact with semi-axes above 0; one without load is a point, gets semi-axes of 1 m, and has no pressure."""
    a, b = contact.semi_axis_rolling, contact.semi_axis_transverse
    if contact.load == 0.0:
        a, b = 1.0, 1.0
    roll = contact.rolling_rate * b**2 / (2 * contact.deformed_radius)
    return Slider(1.5 * contact.load / (np.pi * a * b), a, b, roll)


@compiled
def _edges(slider: Slider, creep: float, spin: float) -> tuple[float, float, float, float]:
    """y/b of the edges of the three panels: both ends, and where v_x = 0 between them."""
    root = np.sqrt(max(spin * spin + 4.0 * slider.roll * creep, 0.0))
    near = 2.0 * creep / (spin + root) if spin + root > 0.0 else 0.0
    far = -(spin + root) / (2.0 * slider.roll) if slider.roll > 0.0 else -1.0
    return -1.0, min(max(far, -1.0), 1.0), min(max(near, -1.0), 1.0), 1.0


@compiled
def slip_sums(slider: Slider, law: PointLaw, creep: float, spin: float, quadrature: Record) -> SlipSums:
    """The sums over three transverse panels, which meet where v_x = 0 on the axis.

    creep : c, m/s;  spin : |w_s| b, m/s;  quadrature : `quadrature_of`
    """
    places, widths, along, lengths = quadrature.places, quadrature.widths, quadrature.reaches, quadrature.lengths
    if slider.peak == 0.0:
        return NO_SUMS
    edges = _edges(slider, creep, spin)
    arm, own = slider.rolling / slider.transverse, law.own != 0.0
    turns = arm > RESOLVED
    force = moment = rolling = power = unit = friction = by_creep = mixed = by_spin = 0.0
    least = 1e-200 * (slider.roll + spin if slider.roll + spin > 0.0 else 1.0)
    for panel in range(3):
        low, length = edges[panel], edges[panel + 1] - edges[panel]
        if length <= 0.0:
            continue
        for j in range(quadrature.across):
            y = low + length * places[j]
            slide = (slider.roll * y + spin) * y - creep
            turn_at_rim = arm * (2.0 * slider.roll * y + spin) if turns else 0.0  # -v_y at x = a
            half = np.sqrt((1.0 - y) * (1.0 + y))  # half-length in the direction of rolling, in units of a
            strip = 2.0 * length * widths[j] * slider.rolling * slider.transverse * half
            # |v| = sqrt(slide^2 + (turn x)^2) has a near kink at x = 0 where slide is small; x ~ sinh(z t) removes it.
            steep = max(abs(turn_at_rim) * half / max(abs(slide), least), 1e-8)  # at 1e-8 sinh is its argument
            z = np.arcsinh(steep) if turns else 0.0
            for k in range(quadrature.along):
                x, weight = along[k], lengths[k]
                if turns:
                    x = np.sinh(z * x) / steep
                    weight *= z * np.sqrt(1.0 / (steep * steep) + x * x)
                turn, lever = turn_at_rim * half * x, arm * half * x
                speed = np.sqrt(slide * slide + turn * turn)
                pressure = slider.peak * half * np.sqrt(max((1.0 - x) * (1.0 + x), 0.0))
                stress, slope = own_stress(law, pressure, speed) if own else eyring_stress(law, pressure, speed)
                area = strip * weight
                unit += area * pressure * speed
                power += area * stress * speed
                friction += area * stress
                if speed == 0.0:
                    continue
                e_x, e_y, over = slide / speed, turn / speed, stress / speed
                force += area * stress * e_x
                moment += area * stress * (e_x * y + e_y * lever)
                rolling += area * stress * (e_x * y + 2.0 * e_y * lever) * y
                # How stress changes with slip: by its size along it, by its direction across it. One component has one.
                across = over if turns else 0.0
                t_xx, t_yy = slope * e_x * e_x + across * e_y * e_y, slope * e_y * e_y + across * e_x * e_x
                t_xy = (slope - across) * e_x * e_y
                by_creep += area * t_xx
                mixed += area * (t_xx * y + t_xy * lever)
                by_spin += area * (t_xx * y * y + 2.0 * t_xy * y * lever + t_yy * lever * lever)
    for line in edges[1:3]:
        steepness = abs(2.0 * slider.roll * line + spin)
        if turns or abs(line) == 1.0 or steepness == 0.0:
            continue
        # Without v_y the stress jumps where the slip turns round: a slope too.
        jump = _jump_at(slider, law, line, quadrature) / steepness
        by_creep += jump
        mixed += jump * line
        by_spin += jump * line * line
    return SlipSums(force, moment, rolling, power, unit, friction, by_creep, mixed, by_spin)


@compiled
def _jump_at(slider: Slider, law: PointLaw, line: float, quadrature: Record) -> float:
    """By how much the force changes across the line y/b where the slip turns round, per slope of the slip, N m/s."""
    half, jump = np.sqrt((1.0 - line) * (1.0 + line)), 0.0
    for k in range(quadrature.along):
        x = quadrature.reaches[k]
        pressure = slider.peak * half * np.sqrt((1.0 - x) * (1.0 + x))
        stress = eyring_stress(law, pressure, 0.0)[0] if law.own == 0.0 else own_stress(law, pressure, 0.0)[0]
        jump += quadrature.lengths[k] * stress
    return jump * 4.0 * slider.rolling * slider.transverse * half


@compiled
def forceless_slip(
    slider: Slider,
    law: PointLaw,
    start: float,
    spin: float,
    quadrature: Record,
    balanced: float,
) -> tuple[float, SlipSums, int]:
    """c that leaves no net force, the sums there, and the number of sums; 0 where none is found.

    start : a guess of c, m/s;  balanced : net force that counts as none, over all friction; others as `slip_sums`
    Secants in a bracket, at whose one end all friction points forwards and at the other backwards: with few nodes the
    sums have another slope than `by_creep`, which begins.
    """
    roll = slider.roll
    vertex = -spin / (2.0 * roll) if spin < 2.0 * roll else -1.0
    low, high = (roll * vertex + spin) * vertex, roll + spin
    creep, step, older, older_force = min(max(start, low), high), high - low, np.nan, np.inf
    found, ends, halved = 0, False, False
    sums = NO_SUMS
    for number in range(1, MOST_STEPS + 1):
        sums = slip_sums(slider, law, creep, spin, quadrature)
        if ends or abs(sums.force) <= balanced * sums.friction:
            found = number
            break
        if sums.force > 0.0:
            low = creep
        elif sums.force < 0.0:
            high = creep
        else:
            break
        slope = sums.by_creep if np.isnan(older) else (older_force - sums.force) / (creep - older)
        stalls = abs(sums.force) > LEAST_GAIN * abs(older_force)
        older, older_force = creep, sums.force
        step = sums.force / slope if slope > 0.0 else np.inf
        halved = (stalls and not halved) or not low <= creep + step <= high
        if halved:
            step = (low + high) / 2.0 - creep
        creep += step
        ends = abs(step) <= LAST_STEP * abs(creep)  # one more evaluation, of the sums there
    return creep, sums, found


def no_creep_speed() -> ConvergenceError:
    """Of a contact without a speed at which its friction along rolling vanishes."""
    return ConvergenceError(
        iterations=MOST_STEPS,
        residual=float("nan"),
        tolerance=BALANCED,
        unit="of the friction",
        problem="the balance of friction in the direction of rolling",
        remedy="Check that the traction is finite, not negative and does not fall where the speed grows.",
    )


@cache
def quadrature_of(nodes: tuple[int, int]) -> Record:
    """So many transverse nodes in a panel, and so many along rolling, of Gauss; at most MOST_NODES each."""
    quadrature = np.zeros(1, QUADRATURE).view(np.recarray)[0]
    quadrature.across, quadrature.along = nodes
    (t, weight), (s, length) = (_unit_gauss(count) for count in nodes)
    quadrature.places[: t.size], quadrature.widths[: t.size] = t, weight
    # Along rolling x = s (2 - s) makes the root of the pressure at the rim smooth.
    quadrature.reaches[: s.size], quadrature.lengths[: s.size] = s * (2 - s), 2 * (1 - s) * length
    return quadrature


def _unit_gauss(nodes: int) -> tuple[Array, Array]:
    """Gauss-Legendre nodes and weights on 0 to 1."""
    x, weight = np.polynomial.legendre.leggauss(nodes)
    return (1 + x) / 2, weight / 2
