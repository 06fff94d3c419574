"""What is read off a computed contact, so that two people get the same number."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve

Array = NDArray[np.float64]
STRIP = 0.1  # of the room to the shoulder: the width of the strip beside it


@dataclass(frozen=True, kw_only=True)
class Quantities:
    """The five quantities of a contact; x along rolling, y transverse."""

    semi_axis_rolling: float  # m
    semi_axis_transverse: float  # m
    peak_pressure: float  # Pa, at the centre: where a shoulder cuts the contact off, that is not its largest
    approach: float  # m, of the ball's middle plane and the race's far field
    stiffness: float  # N/m^1.5, load over approach^1.5


@dataclass(frozen=True, kw_only=True)
class ShoulderLoad:
    """What a contact cut off at a shoulder does there, y = s.

    At a sharp shoulder the pressure has no bound, and neither has the line load (the pressure summed along x): the load
    of a strip beside the shoulder, `STRIP` of s wide, has one.
    """

    centroid: float  # y of the load's centroid, m; below 0 away from the shoulder; 0 where both shoulders are reached
    strip_share: float  # of the load that the strip carries
    strip_line_load: float  # mean over the strip, N/m


def semi_axis(position: Array, force: Array, *, centre: float = 0.0) -> float:
    """sqrt(5 sum(F (s - c)^2)/sum(F)), m: that of the semi-ellipsoidal pressure with the same second moment.

    position : s, (m,) on the plane tangent at the contact's centre, m
    force : F, (m,) the forces' component along the load, N
    centre : c, m
    """
    return float(np.sqrt(5 * np.sum(force * (position - centre) ** 2) / np.sum(force)))


def uncut_semi_axes(x: Array, y: Array, force: Array) -> tuple[float, float]:
    """Semi-axes, m, that the side y <= 0 of a contact shows, away from the nearer shoulder.

    Of the ellipse that nothing cuts off, as long as the farther shoulder does not either; else of what that leaves.
    """
    beyond = force * np.where(y < 0, 1.0, np.where(y > 0, 0.0, 0.5))
    return semi_axis(x, beyond), semi_axis(y, beyond)


def nodal_pressure(force: Array, mass: csr_matrix) -> Array:
    """Pressure (m,), Pa, whose integrals against the shape functions are the normal forces (m,), N."""
    carrying = np.flatnonzero(mass.diagonal())
    pressure = np.zeros_like(force)
    pressure[carrying] = spsolve(mass[carrying][:, carrying].tocsc(), force[carrying])
    return pressure


def peak_pressure(
    x: Array, y: Array, pressure: Array, area: Array, *, semi_axes: tuple[float, float], half: bool = False
) -> float:
    """Pressure at the centre, Pa, from a fit of p^2 = c0 + c1 x^2 + c2 y^2 over the inner half of the ellipse.

    half : both sides of y = 0 are given, and the fit has a slope across too
    p^2 is that polynomial where the pressure is semi-ellipsoidal; nodes count by their `area`, m^2.
    Raw nodal values are some tenths of a per cent off; where too few nodes touch for a fit, the centre's is returned.
    """
    centre = float(pressure[np.argmin(x**2 + y**2)])
    if min(semi_axes) == 0:  # a single node or line of nodes
        return centre
    inner = (x / semi_axes[0]) ** 2 + (y / semi_axes[1]) ** 2 < 0.5
    along, across = x[inner] / semi_axes[0], y[inner] / semi_axes[1]
    terms = np.column_stack([np.ones(inner.sum()), along**2, across**2, *([across] if half else [])])
    weight = np.sqrt(area[inner])
    fitted = np.linalg.lstsq(terms * weight[:, None], pressure[inner] ** 2 * weight, rcond=None)[0]
    return float(np.sqrt(fitted[0])) if fitted[0] > 0 else centre


def shoulder_load(*, centroid: float, strip_force: float, shoulder: float, load: float) -> ShoulderLoad:
    """All lengths in m, all forces in N.

    strip_force : along the load, of the strip on one side of x = 0
    shoulder : s
    load : of the whole contact
    """
    share = 2 * strip_force / load
    return ShoulderLoad(centroid=centroid, strip_share=share, strip_line_load=share * load / (STRIP * shoulder))
