"""Definitions of the quantities of a computed contact, so that two people get the same numbers."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve

Array = NDArray[np.float64]
STRIP = 0.1  # width of the strip at the shoulder, over the distance of the shoulder


@dataclass(frozen=True, kw_only=True)
class Quantities:
    """The five quantities of a contact."""

    semi_axis_rolling: float  # m
    semi_axis_transverse: float  # m
    peak_pressure: float  # Pa, at the centre; a contact cut off at a shoulder has larger pressures there
    approach: float  # m, of the ball's middle plane towards the race's far field
    stiffness: float  # N/m^1.5, load over approach^1.5


@dataclass(frozen=True, kw_only=True)
class ShoulderLoad:
    """The load near a shoulder, y = s, that cuts a contact off.

    At a sharp shoulder the pressure is unbounded, and so is the line load (the pressure integrated along x). The load
    of a strip at the shoulder, `STRIP` times s wide, is bounded.
    """

    centroid: float  # y of the load's centroid, m; negative away from the shoulder; 0 where both shoulders are reached
    strip_share: float  # load of the strip over the whole load
    strip_line_load: float  # mean over the strip, N/m


def semi_axis(position: Array, force: Array, *, centre: float = 0.0) -> float:
    """sqrt(5 sum(F (s - c)^2)/sum(F)), m: the semi-axis of a semi-ellipsoidal pressure with the same second moment.

    position : s, (m,) on the plane tangent at the contact's centre, m
    force : F, (m,) component of the forces along the load, N
    centre : c, m
    """
    return float(np.sqrt(5 * np.sum(force * (position - centre) ** 2) / np.sum(force)))


def uncut_semi_axes(x: Array, y: Array, force: Array) -> tuple[float, float]:
    """Semi-axes, m, from the side y <= 0 of a contact, which the nearer shoulder does not cut off.

    They are those of the uncut ellipse, unless the farther shoulder cuts that side off too.
    """
    uncut = force * np.where(y < 0, 1.0, np.where(y > 0, 0.0, 0.5))
    return semi_axis(x, uncut), semi_axis(y, uncut)


def within_ellipse(x: Array, y: Array, semi_axes: tuple[float, float], *, square: float = 1.0) -> NDArray[np.bool_]:
    """(m,) where x^2/a^2 + y^2/b^2 is below `square`."""
    return (x / semi_axes[0]) ** 2 + (y / semi_axes[1]) ** 2 < square


def nodal_pressure(force: Array, mass: csr_matrix) -> Array:
    """Pressure (m,), Pa, whose integrals with the shape functions are the normal forces (m,), N."""
    carrying = np.flatnonzero(mass.diagonal())
    pressure = np.zeros_like(force)
    pressure[carrying] = spsolve(mass[carrying][:, carrying].tocsc(), force[carrying])
    return pressure


def peak_pressure(
    x: Array, y: Array, pressure: Array, area: Array, *, semi_axes: tuple[float, float], half: bool = False
) -> float:
    """Pressure at the centre, Pa, from a fit of p^2 = c0 + c1 x^2 + c2 y^2 over the inner half of the ellipse.

    half : both sides of y = 0 are given, and the fit has a term linear in y too
    p^2 of a semi-ellipsoidal pressure is such a polynomial. Nodes are weighted by their `area`, m^2. Nodal values are
    wrong by some tenths of a per cent; that of the centre is returned only where too few nodes touch for a fit.
    """
    centre = float(pressure[np.argmin(x**2 + y**2)])
    if min(semi_axes) == 0:  # a single node or line of nodes
        return centre
    inner = within_ellipse(x, y, semi_axes, square=0.5)
    rolling, transverse = x[inner] / semi_axes[0], y[inner] / semi_axes[1]
    terms = np.column_stack([np.ones(inner.sum()), rolling**2, transverse**2, *([transverse] if half else [])])
    weight = np.sqrt(area[inner])
    fitted = np.linalg.lstsq(terms * weight[:, None], pressure[inner] ** 2 * weight, rcond=None)[0]
    return float(np.sqrt(fitted[0])) if fitted[0] > 0 else centre


def measured_quantities(
    x: Array, y: Array, force: Array, pressure: Array, area: Array, *, load: float, approach: float
) -> Quantities:
    """All quantities of a contact symmetric to x = 0 and y = 0, from the nodes of a quarter.

    force : (m,) along the load, N
    pressure, area : (m,) Pa and m^2
    load : of the whole contact, N
    """
    semi_axes = semi_axis(x, force), semi_axis(y, force)
    return Quantities(
        semi_axis_rolling=semi_axes[0],
        semi_axis_transverse=semi_axes[1],
        peak_pressure=peak_pressure(x, y, pressure, area, semi_axes=semi_axes),
        approach=approach,
        stiffness=load / approach**1.5,
    )


def ratio(first: Quantities, second: Quantities) -> Quantities:
    """First over second, of each quantity."""
    return Quantities(**{name: value / getattr(second, name) for name, value in vars(first).items()})


def product(first: Quantities, second: Quantities) -> Quantities:
    """First times second, of each quantity."""
    return Quantities(**{name: value * getattr(second, name) for name, value in vars(first).items()})


def shoulder_load(*, centroid: float, strip_force: float, shoulder: float, load: float) -> ShoulderLoad:
    """The load at a shoulder from sums over the mesh.

    centroid : y of the load's centroid, m
    strip_force : of the strip on one side of x = 0, along the load, N
    shoulder : its distance s, m
    load : of the whole contact, N
    """
    share = 2 * strip_force / load
    return ShoulderLoad(centroid=centroid, strip_share=share, strip_line_load=share * load / (STRIP * shoulder))
