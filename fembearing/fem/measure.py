"""What is read off a computed contact, so that two people get the same number."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.linalg import spsolve

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class Quantities:
    """The five quantities of a contact; x along rolling, y transverse."""

    semi_axis_rolling: float  # m
    semi_axis_transverse: float  # m
    peak_pressure: float  # Pa
    approach: float  # m, of the ball's middle plane and the race's far field
    stiffness: float  # N/m^1.5, load over approach^1.5


def semi_axis(position: Array, force: Array) -> float:
    """sqrt(5 sum(F s^2)/sum(F)), m: that of the semi-ellipsoidal pressure with the same second moment.

    position : s, (m,) on the plane tangent at the contact's centre, m
    force : F, (m,) the forces' component along the load, N
    """
    return float(np.sqrt(5 * np.sum(force * position**2) / np.sum(force)))


def nodal_pressure(force: Array, mass: csr_matrix) -> Array:
    """Pressure (m,), Pa, whose integrals against the shape functions are the normal forces (m,), N."""
    carrying = np.flatnonzero(mass.diagonal())
    pressure = np.zeros_like(force)
    pressure[carrying] = spsolve(mass[carrying][:, carrying].tocsc(), force[carrying])
    return pressure


def peak_pressure(x: Array, y: Array, pressure: Array, area: Array, *, semi_axes: tuple[float, float]) -> float:
    """Pressure at the centre, Pa, from a fit of p^2 = c0 + c1 x^2 + c2 y^2 over the inner half of the ellipse.

    p^2 is that polynomial where the pressure is semi-ellipsoidal; nodes count by their `area`, m^2.
    Raw nodal values are some tenths of a per cent off; where too few nodes touch for a fit, the centre's is returned.
    """
    centre = float(pressure[np.argmin(x**2 + y**2)])
    if min(semi_axes) == 0:  # a single node or line of nodes
        return centre
    reach = (x / semi_axes[0]) ** 2 + (y / semi_axes[1]) ** 2
    inner = reach < 0.5
    terms = np.column_stack(
        [np.ones(inner.sum()), x[inner] ** 2 / semi_axes[0] ** 2, y[inner] ** 2 / semi_axes[1] ** 2]
    )
    weight = np.sqrt(area[inner])
    fitted = np.linalg.lstsq(terms * weight[:, None], pressure[inner] ** 2 * weight, rcond=None)[0]
    return float(np.sqrt(fitted[0])) if fitted[0] > 0 else centre
