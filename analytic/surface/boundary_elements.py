"""A rigid rough surface pressed on an elastic half space, by boundary elements.

There is no friction, and all is elastic. Heights and gaps are over sigma, the rms height. Pressures are over E* slope,
with slope the rms gradient. In these units neither a factor on heights nor one on lengths changes anything. Pressure p,
gap g and displacement u of the half space satisfy
    p >= 0,  g >= 0,  p g = 0,  mean of p given,  u(q) = 2 p(q)/(E* q) for wavenumbers q > 0
Source: conjugate gradients [Polonsky1999], here preconditioned. `python validation/film/elastic_gap.py --check`
compares with another program.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from analytic.errors import ConvergenceError, InputError
from analytic.scene import Array

MISSED = 1e-3  # rms gap where surfaces touch, plus mean overlap elsewhere, over the mean gap: the error of the mean gap
NO_GAP = 1e-6  # over sigma: a smaller mean gap is no gap
MOST_STEPS = 2000  # of the conjugate gradients; 5 to 100 are usual
# A point that joins the contact gets so much of the pressure that would alone press its overlap down. With a tenth the
# neighbours that join with it may be pressed down so far that they leave again, for ever.
JOINING = 0.03


@dataclass(frozen=True, kw_only=True, eq=False)
class PressedSurface:
    """Fields at every point of the surface."""

    pressure: Array  # over E* slope
    gap: Array  # between the deformed surfaces, over sigma

    @property
    def mean_gap(self) -> float:
        return float(self.gap.mean())

    @property
    def area_fraction(self) -> float:
        """Points under pressure over all points."""
        return float(np.mean(self.pressure > 0))


def pressed(heights: Array, pressures: tuple[float, ...], *, periodic: bool) -> Iterator[PressedSurface]:
    """The surface under these mean pressures over E* slope, falling; each solution is the start for the next.

    heights : (rows, columns), in any unit
    periodic : the surface repeats itself; otherwise mirror images continue it, without a step at its edges
    Slope is that of differences of neighbours, as in `heightmap.measure`.
    Raises InputError for a flat surface or one that is not finite.
    """
    deviation = float(heights.std())
    if not 0 < deviation < np.inf:
        raise InputError(f"heights deviate by {deviation!r} from their mean: give the map of a rough surface")
    heights = (heights - heights.mean()) / deviation
    slope = np.sqrt(sum(float(np.mean(np.diff(heights, axis=axis) ** 2)) for axis in (0, 1)))
    displacement, full = _half_space(heights.shape, 2 * slope, periodic=periodic)
    point = np.zeros_like(heights)
    point[0, 0] = 1.0
    joining = JOINING / float(displacement(point)[0, 0])
    pressure = np.maximum(full(heights) + pressures[0], 0.0)
    for mean in pressures:
        pressure, gap = _balanced(displacement, full, heights, pressure * (mean / pressure.mean()), joining)
        yield PressedSurface(pressure=pressure, gap=gap)


def _half_space(
    shape: tuple[int, ...], factor: float, *, periodic: bool
) -> tuple[Callable[[Array], Array], Callable[[Array], Array]]:
    """Displacement of a pressure, factor p(q)/q with q per point, and pressure of a displacement; without means."""
    from scipy import fft  # only rough surfaces need it

    rows, columns = shape
    if periodic:
        q = 2 * np.pi * np.hypot(fft.fftfreq(rows)[:, None], fft.rfftfreq(columns))
    else:
        q = np.pi * np.hypot(np.arange(rows)[:, None] / rows, np.arange(columns) / columns)

    def filtered(gain: Array) -> Callable[[Array], Array]:
        if periodic:
            return lambda field: fft.irfft2(fft.rfft2(field) * gain, s=shape)
        return lambda field: fft.idctn(fft.dctn(field) * gain)

    return filtered(np.divide(factor, q, out=np.zeros_like(q), where=q > 0)), filtered(q / factor)


def _balanced(
    displacement: Callable[[Array], Array], full: Callable[[Array], Array], heights: Array, start: Array, joining: float
) -> tuple[Array, Array]:
    """Pressure and gap by conjugate gradients of the pressure where it is above 0.

    They are preconditioned by `full`, the pressure of a displacement in full contact: 10 to 100 steps in place of some
    hundred. start : pressures with the given mean;  joining : pressure over overlap of a point that joins the contact
    """
    pressure, mean = start, start.mean()
    direction, before, keep = np.zeros_like(heights), 1.0, 0.0
    missed = allowed = np.inf
    for _ in range(MOST_STEPS):
        gap = displacement(pressure) - heights
        touching = pressure > 0
        gap = gap - gap[touching].mean()
        residual = gap[touching]
        missed = np.sqrt(np.mean(residual**2)) - np.sum(np.minimum(gap, 0.0), where=~touching) / gap.size
        allowed = MISSED * max(float(gap.mean()), NO_GAP)
        if missed <= allowed:
            return pressure, np.where(touching, 0.0, np.maximum(gap, 0.0))
        needed = full(np.where(touching, gap, 0.0))
        needed = np.where(touching, needed - needed[touching].mean(), 0.0)
        square = float(residual @ needed[touching])
        direction = needed + keep * square / before * direction * touching
        change = displacement(direction)[touching]
        step = square / float((change - change.mean()) @ direction[touching])
        pressure = np.maximum(pressure - step * direction, 0.0)
        overlapping = (pressure == 0) & (gap < 0)
        pressure[overlapping] = -joining * gap[overlapping]
        before, keep = square, 0.0 if overlapping.any() else 1.0
        pressure *= mean / pressure.mean()
    raise ConvergenceError(
        iterations=MOST_STEPS,
        residual=float(missed),
        tolerance=float(allowed),
        unit="rms heights",
        problem="the contact of a rough surface",
        remedy="Check the height map for spikes, or give a smoother one.",
    )
