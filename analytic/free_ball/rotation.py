"""How a free ball turns between its races: its axis, its orbital speed and its slip follow from the tractions.

A ball at its place between the grooves has four freedoms: v = (r_m w_c, r w_phi, r w_rho, r w_z), the speed along its
orbit of radius r_m and its absolute rotation along the orbit, outward and along the bearing axis. At a point of a
contact, y across the groove and x along rolling, with the normal n out of the ball, t across the groove and t x n along
the orbit, the ball slides against its race by
    s_phi = r_m (w_c - w_ring) + W_t (r - y^2/2R) - W_n y,  s_t = x (W_n + W_t y/R) - W_phi r,  W = w_ball - w_ring z
along the curved surface, about whose normal it turns by W_n + W_t y/R. R differs from r by so little that a turn about
the orbit slides all points alike. This is linear in v, s = A v - const, so one map gives force, spin, conformity and
the moments: the ball feels -int A^T stress dA. It turns steadily where
    F_phi = 0,  M_rho = -J w_c w_phi,  M_phi = J w_c w_rho,  M_z = 0,  J = (2/5) m r^2
The terms of balls that come round to another load are left out; the cage carries what is along the orbit.

The stress is that of the law of traction at the slip that the elasticity of the surfaces leaves. Both have the
flexibility L = 32 a/(3 pi^2 E*), that of a long ellipse in steady rolling at the speed u.
Along rolling, from the leading edge, c L u d stress/d xi = s - g, and g slides against the law. With Coulomb friction
this is FASTSIM [Kalker1982] on strips. Spin then pushes the ball across the groove. c is MARCHED, along and across:
with it the torque by sliding is that of half spaces (`validation/creep/`). Across, it is near what Kalker's C23 of spin
asks for, not C22 of an even slip: what pushes a ball across its groove is spin. Without creep the surfaces are STIFFER
times as stiff, so that the force does not jump.
Rates are per unit ring speed w, so slip is a length and all exists at standstill. Source: derived here.

Nodes: each level has twice those of the one before in each direction, and a first one follows from the tolerance
(`analytic.solve.model.first_level`). They are doubled across, then along: both changes have opposite signs where balls
creep, and would cancel.
"""

from functools import cache
from typing import NamedTuple

import numpy as np

from analytic.free_ball.state import QUADRATURE
from analytic.numerics.records import Record, Records
from analytic.scene import Array

MARCHED = 1.35, 0.8  # L along and across rolling, over that of a long ellipse: fitted to `fembearing.creep`
STIFFER = 1e3  # times: surfaces without creep


class Nodes(NamedTuple):
    """Of a quadrature, across and along rolling."""

    across: int
    along: int


COARSE = Nodes(8, 6)  # for a start
LEVELS = (Nodes(16, 12), Nodes(32, 24), Nodes(64, 48), Nodes(128, 96))


@cache
def free_quadratures() -> Records:
    """(k,) of `state.QUADRATURE`: a coarse one, then the levels; between two, the former with twice as many across."""
    of_levels = (each for n, m in LEVELS for each in (Nodes(n, m), Nodes(2 * n, m)))
    each = (COARSE, *of_levels)[:-1]
    quadratures = np.zeros(len(each), QUADRATURE)
    for quadrature, nodes in zip(quadratures, each, strict=True):
        _write_nodes(quadrature, nodes)
    return quadratures


def _write_nodes(quadrature: Record, nodes: Nodes) -> None:
    """Nodes along rolling lie at equal steps of the angle, without the ends."""
    count = nodes.along - 1
    quadrature["strips"], quadrature["nodes"] = nodes.across, count
    quadrature["across"][:, : nodes.across] = _gauss(nodes.across)
    angle = np.pi * (np.arange(1, nodes.along) / nodes.along - 0.5)
    step = np.diff(np.sin(angle), prepend=-1.0)
    ratio = np.append(0.0, step[1:] / step[:-1])
    quadrature["steps"][:, :count] = np.stack([(1 + 2 * ratio) / (1 + ratio), 1 + ratio, ratio**2 / (1 + ratio)]) / step
    quadrature["along"][:, :count] = [np.sin(angle), np.cos(angle), np.full(count, np.pi / nodes.along)]


def _gauss(nodes: int) -> Array:
    x, weight = np.polynomial.legendre.leggauss(nodes)
    return np.stack([np.sin(np.pi / 2 * x), np.cos(np.pi / 2 * x), np.pi / 2 * weight])
