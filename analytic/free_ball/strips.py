"""Forces of one strip of a contact along rolling, compiled, with their stiffness.

Rates are per unit ring speed w, so slip is a length. One contact is a row of numbers (`analytic.free_ball.layout`).
"""

from typing import NamedTuple

import numpy as np

from analytic.free_ball.layout import (
    BOUNDARY,
    EXPONENT,
    EYRING,
    FLUIDITY,
    GROWTH,
    LIMIT,
    LOAD,
    PLAIN,
    ROLLING,
    SHARE,
    TRANSVERSE,
)
from analytic.free_ball.stress import Shear, flow_at, sheared, yielding
from analytic.numerics.compilation import compiled
from analytic.oil.traction import PointLaw
from analytic.scene import Array

NO_SLIP = 1e-200  # m: keeps a direction where nothing slides


class Quadrature(NamedTuple):
    """Nodes of the ellipse of a contact, on strips along rolling; angles as sines, cosines and weights."""

    across: Array  # (3, strips)
    along: Array  # (3, nodes) of a strip, which is marched from its leading edge
    # (3, nodes) of second-order backward differences between them, times the half-length: how far stress at the node,
    # at the last one and at the one before pulls the slip. The first step is exact where nothing slides.
    steps: Array
    marched: bool


@compiled(inline=True)
def strip_closed(contact, slip, strip, along, flows):
    """One strip by the closed law: forces and stiffness by slip along it, across it and by spin, and all friction.

    slip : (along, across, spin);  strip : half-length, direction of the flow, pressure at its middle, p0 L u/a
    along : sines, cosines and weights of the nodes;  flows : (2, nodes) fluidity and `most`
    """
    slide, lateral, spin = slip
    half, flow, middle, length = strip
    sines, cosines, weights = along[0], along[1], along[2]
    f_p = f_l = f_n = pp = pl = pn = ll = ln = nn = friction = 0.0
    for k in range(sines.shape[0]):
        pressure, area, x = middle * cosines[k], weights[k] * half * cosines[k], flow * half * sines[k]
        across = lateral + spin * x
        size = max(np.sqrt(slide * slide + across * across), NO_SLIP)
        stress, slope = yielding(size, shear_at(contact, pressure, flows[0, k], flows[1, k]))
        if stress == 0.0:
            continue
        creep = size * pressure / (stress * length) if length > 0.0 else 1e100
        square = 1.0 + creep * creep
        share, steep = 2.0 / np.pi * (np.arctan(creep) + creep / square), 4.0 / np.pi / (square * square)
        over = stress * share / size
        rest = slope * (share - creep * steep) + stress * steep * creep / size - over
        e_x, e_y = slide / size, across / size
        xx, xy, yy = area * (over + rest * e_x * e_x), area * rest * e_x * e_y, area * (over + rest * e_y * e_y)
        f_p += area * over * slide
        f_l += area * over * across
        f_n += area * over * across * x
        pp += xx
        pl += xy
        pn += xy * x
        ll += yy
        ln += yy * x
        nn += yy * x * x
        friction += area * over * size
    return (f_p, f_l, f_n), (pp, pl, pn, pl, ll, ln, pn, ln, nn), friction


@compiled(inline=True)
def strip_marched(contact, slip, strip, quadrature, flows):
    """One strip, marched from its leading edge; arguments and results of `strip_closed`, p0 L u/a being L u there."""
    slide, lateral, spin = slip
    half, flow, middle, length = strip
    sines, cosines, weights = quadrature.along[0], quadrature.along[1], quadrature.along[2]
    per_step = length / half
    f_p = f_l = f_n = pp = pl = pn = lp = ll = ln = np_ = nl = nn = friction = 0.0
    stress_x = stress_y = older_x = older_y = 0.0
    xp = xl = xn = yp = yl = yn = old_xp = old_xl = old_xn = old_yp = old_yl = old_yn = 0.0
    for k in range(sines.shape[0]):
        pressure, area, x = middle * cosines[k], weights[k] * half * cosines[k], flow * half * sines[k]
        acting = x if k > 0 else flow * half * (sines[0] - 1.0) / 2.0  # halfway from the edge
        from_last, from_older = per_step * quadrature.steps[1, k], per_step * quadrature.steps[2, k]
        reach_x = slide + from_last * stress_x - from_older * older_x
        reach_y = lateral + spin * acting + from_last * stress_y - from_older * older_y
        reach = max(np.sqrt(reach_x * reach_x + reach_y * reach_y), NO_SLIP)
        older_x, older_y = stress_x, stress_y
        shear = shear_at(contact, pressure, flows[0, k], flows[1, k])
        stress, slope = sheared(reach, per_step * quadrature.steps[0, k], shear)
        per_reach = 1.0 / reach
        e_x, e_y, over = reach_x * per_reach, reach_y * per_reach, stress * per_reach
        stress_x, stress_y = stress * e_x, stress * e_y
        xx, xy = over + (slope - over) * e_x * e_x, (slope - over) * e_x * e_y
        yy = over + (slope - over) * e_y * e_y
        to_xp, to_yp = 1.0 + from_last * xp - from_older * old_xp, from_last * yp - from_older * old_yp
        to_xl, to_yl = from_last * xl - from_older * old_xl, 1.0 + from_last * yl - from_older * old_yl
        to_xn, to_yn = from_last * xn - from_older * old_xn, acting + from_last * yn - from_older * old_yn
        old_xp, old_xl, old_xn, old_yp, old_yl, old_yn = xp, xl, xn, yp, yl, yn
        xp, yp = xx * to_xp + xy * to_yp, xy * to_xp + yy * to_yp
        xl, yl = xx * to_xl + xy * to_yl, xy * to_xl + yy * to_yl
        xn, yn = xx * to_xn + xy * to_yn, xy * to_xn + yy * to_yn
        f_p += area * stress_x
        f_l += area * stress_y
        f_n += area * stress_y * x
        pp, pl, pn = pp + area * xp, pl + area * xl, pn + area * xn
        lp, ll, ln = lp + area * yp, ll + area * yl, ln + area * yn
        np_, nl, nn = np_ + area * yp * x, nl + area * yl * x, nn + area * yn * x
        friction += area * stress
    return (f_p, f_l, f_n), (pp, pl, pn, lp, ll, ln, np_, nl, nn), friction


@compiled(inline=True)
def shear_at(contact, pressure, fluidity, most):
    """The law at a node."""
    return Shear(
        contact[BOUNDARY] * pressure + contact[PLAIN], contact[LIMIT] * pressure, contact[EYRING], fluidity, most
    )


@compiled
def hold_flows(contact: Array, quadrature: Quadrature, flows: Array) -> None:
    """Write (across, 2, along) fluidity and `most` of the nodes, which do not change with the slip.

    The nodes lie in pairs about the middle of the ellipse, where the pressure is the same.
    """
    law = PointLaw(
        contact[BOUNDARY],
        contact[PLAIN],
        contact[LIMIT],
        contact[EYRING],
        contact[FLUIDITY],
        contact[SHARE],
        contact[GROWTH],
        contact[EXPONENT],
    )
    strips, nodes = quadrature.across[1], quadrature.along[1]
    last_strip, last_node = strips.shape[0] - 1, nodes.shape[0] - 1
    peak = peak_pressure(contact)
    for j in range(last_strip // 2 + 1):
        for k in range(last_node // 2 + 1):
            flow = flow_at(law, peak * strips[j] * nodes[k])
            for each in range(2):
                flows[j, each, k] = flows[j, each, last_node - k] = flow[each]
                flows[last_strip - j, each, k] = flows[last_strip - j, each, last_node - k] = flow[each]


@compiled
def peak_pressure(contact: Array) -> float:
    """p0, Pa."""
    return 1.5 * contact[LOAD] / (np.pi * contact[ROLLING] * contact[TRANSVERSE])
