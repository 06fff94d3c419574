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
- `marched`: along rolling, from the leading edge, c L u d stress/d xi = s - g, and g slides against the law. With
  Coulomb friction this is FASTSIM [Kalker1982] on strips. Spin then pushes the ball across the groove. c is MARCHED,
  along and across: with it the torque by sliding is that of half spaces (`validation/creep/`). Across, it is near what
  Kalker's C23 of spin asks for, not C22 of an even slip: what pushes a ball across its groove is spin.
- `closed`: stress = T f(k), k = s p/(T p0 u L/a), f(k) = (2/pi)[atan k + k/(1 + k^2)] with the law's T(p, s). With
  Coulomb friction this is Polach's law [Polach2005], exact for the force of an even slip on a strip. It has no memory:
  the lateral push of spin is missing, which is up to 35 % of the torque.
- `none`: the closed law with surfaces STIFFER times as stiff.
Rates are per unit ring speed w, so slip is a length and all exists at standstill. Source: derived here.
"""

from functools import cache
from typing import Literal, NamedTuple

import numpy as np

from analytic.free_ball.state import QUADRATURE
from analytic.numerics.records import Record, Records
from analytic.scene import Array

Creep = Literal["none", "closed", "marched"]
MARCHED = 1.35, 0.8  # L along and across rolling, over that of a long ellipse: fitted to `fembearing.creep`
STIFFER = 1e3  # times: surfaces without creep, for a force that must not jump


class Nodes(NamedTuple):
    """Of a quadrature, across and along rolling."""

    across: int
    along: int


COARSE = Nodes(8, 6)  # for a start
QUADRATURES = (Nodes(16, 12), Nodes(32, 20), Nodes(64, 36), Nodes(128, 72), Nodes(192, 108))  # of the passes


@cache
def quadratures_of(creep: Creep) -> Records:
    """(k,) of `state.QUADRATURE`: a coarse one, and that of each pass."""
    each = (COARSE, *QUADRATURES)
    quadratures = np.zeros(len(each), QUADRATURE)
    for quadrature, nodes in zip(quadratures, each, strict=True):
        _write_nodes(quadrature, nodes, marched=creep == "marched")
    return quadratures


def _write_nodes(quadrature: Record, nodes: Nodes, *, marched: bool) -> None:
    """Marched nodes lie at equal steps of the angle, without the ends."""
    count = nodes.along - 1 if marched else nodes.along
    quadrature["strips"], quadrature["nodes"], quadrature["marched"] = nodes.across, count, marched
    quadrature["across"][:, : nodes.across] = _gauss(nodes.across)
    if not marched:
        quadrature["along"][:, :count] = _gauss(count)
        return
    angle = np.pi * (np.arange(1, nodes.along) / nodes.along - 0.5)
    step = np.diff(np.sin(angle), prepend=-1.0)
    ratio = np.append(0.0, step[1:] / step[:-1])
    quadrature["steps"][:, :count] = np.stack([(1 + 2 * ratio) / (1 + ratio), 1 + ratio, ratio**2 / (1 + ratio)]) / step
    quadrature["along"][:, :count] = [np.sin(angle), np.cos(angle), np.full(count, np.pi / nodes.along)]


def _gauss(nodes: int) -> Array:
    x, weight = np.polynomial.legendre.leggauss(nodes)
    return np.stack([np.sin(np.pi / 2 * x), np.cos(np.pi / 2 * x), np.pi / 2 * weight])
