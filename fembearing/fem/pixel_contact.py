"""Normal contact of a pair on pixels, by the compliance of the pair.

Each pixel bears an even pressure; the half spaces yield to it in closed form. What the true shapes add to the
displacement is some per cent of it and depends on the force through a few moments: the half spaces are pressed over
the gap that the last displacement left, until it stays.

The edge of a contact crosses pixels. The error that this causes is that of two half spaces on the same pixels over the
paraboloid of the same ellipse, whose answer is exact; exact over computed corrects each quantity.
"""

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from analytic.errors import ConvergenceError
from analytic.scene import Array, Contact
from fembearing.fem.compliance import PairCompliance
from fembearing.fem.contact import press
from fembearing.fem.half_space import curvatures_under, exact_quantities, pressed_rectangle
from fembearing.fem.measure import Quantities, measured_quantities, product, ratio, within_ellipse
from fembearing.fem.twin import QUARTERS, shared_axes
from fembearing.mesh.footprint import as_quarter
from fembearing.mesh.race import distance_to_race

WIDEST = 1.2  # semi-axes from the centre to the farthest pixels
PIXELS = 16  # in each direction over `WIDEST` semi-axes; with 24 no quantity of 6 contacts changed by more than 0.01 %
SAME = 1e-7  # change of the added displacement in a round, over the approach
ROUNDS = 30  # three to six are usual: a round leaves some per cent of the change
CORRECTIONS = 2  # the exact ellipse follows from its own factors
KEPT = 64  # grids of one process, 0.3 MB each


@dataclass(frozen=True, kw_only=True, eq=False)
class PixelSolution:
    """A contact on the pixels of a quarter, x > 0 and y > 0."""

    contact: Contact  # under its load
    level: int  # number of the mesh from which the compliance was sampled
    quantities: Quantities  # without the error of the pixels
    x: Array  # (m,) of the pixels, m
    y: Array  # (m,)
    force: Array  # (m,) along the normals, N
    shoulder: None = None  # no shoulder cuts it off

    @property
    def semi_axes(self) -> tuple[float, float]:
        """Rolling and transverse, m."""
        return self.quantities.semi_axis_rolling, self.quantities.semi_axis_transverse


@dataclass(frozen=True, kw_only=True, eq=False)
class Pixels:
    """A quarter of an ellipse on pixels, and its half spaces."""

    x: Array  # (m,) m
    y: Array  # (m,) m
    area: float  # of a pixel, m^2
    compliance: Array  # (m, m) m/N: under forces on a pixel and on its three images

    def pressed(self, *, gap: Array, lever: Array, load: float, start: NDArray[np.bool_]) -> tuple[Array, Quantities]:
        """Force (m,), N, of each pixel, and the quantities; arguments as of `press`, `load` of the whole contact, N."""
        force, approach, _ = press(
            compliance=self.compliance,
            drift=np.zeros_like(gap),
            gap=gap,
            lever=lever,
            load=load / QUARTERS,
            start=start,
        )
        along, area = force * lever, np.full_like(gap, self.area)
        return force, measured_quantities(self.x, self.y, along, along / area, area, load=load, approach=approach)


def press_pair(compliance: PairCompliance, *, load: float) -> PixelSolution:
    """Press a pair together.

    load : of the whole contact, N; its semi-axes are about those in which the compliance was sampled
    Raises ConvergenceError if the contact does not converge.
    """
    contact, pixels = compliance.contact, pixels_of(compliance)
    plane = np.array([pixels.x, pixels.y]) / contact.ball_radius
    lever = np.sqrt(1 - np.sum(plane**2, axis=0))
    gap = distance_to_race(as_quarter(contact, "even"), np.vstack([plane, -lever]))
    touching = within_ellipse(pixels.x, pixels.y, compliance.semi_axes)
    added, change = np.zeros_like(gap), np.inf
    for _ in range(ROUNDS):
        force, found = pixels.pressed(gap=gap + added, lever=lever, load=load, start=touching)
        touching, before = force > 0, added
        added = compliance.added_displacement(pixels.x, pixels.y, QUARTERS * force)
        change = float(np.abs(added - before)[touching].max() / found.approach)
        if change < SAME:
            corrected = product(found, _factors(pixels, found, modulus=compliance.modulus, load=load, start=touching))
            return PixelSolution(
                contact=replace(contact, load=load),
                level=compliance.level,
                quantities=corrected,
                x=pixels.x,
                y=pixels.y,
                force=force,
            )
    raise ConvergenceError(
        iterations=ROUNDS,
        residual=change,
        tolerance=SAME,
        unit="of the approach",
        problem="the displacement that the shapes of ball and race add to half spaces",
        remedy="Lower the load: the contact is too large for its ball.",
    )


def _factors(pixels: Pixels, found: Quantities, *, modulus: float, load: float, start: NDArray[np.bool_]) -> Quantities:
    """Exact over computed of half spaces on the pixels, whose exact ellipse is the corrected one of `found`."""
    factors = ratio(found, found)
    for _ in range(CORRECTIONS):
        ellipse = product(found, factors)
        semi_axes = ellipse.semi_axis_rolling, ellipse.semi_axis_transverse
        x, y = curvatures_under(semi_axes, load=load, modulus=modulus)
        gap = (x * pixels.x**2 + y * pixels.y**2) / 2
        _, flat = pixels.pressed(gap=gap, lever=np.ones_like(gap), load=load, start=start)
        factors = ratio(exact_quantities(semi_axes, load=load, modulus=modulus), flat)
    return factors


def pixels_of(compliance: PairCompliance) -> Pixels:
    """Pixels over the ellipse of a compliance, with the axis ratio of `shared_axes`."""
    rolling, transverse = shared_axes(compliance.semi_axes)
    unit = _unit_pixels(float(f"{transverse / rolling:.9g}"))
    return Pixels(
        x=rolling * unit.x,
        y=rolling * unit.y,
        area=rolling**2 * unit.area,
        compliance=unit.compliance / (compliance.modulus * rolling),
    )


@lru_cache(KEPT)
def _unit_pixels(axis_ratio: float) -> Pixels:
    """Pixels over an ellipse with a rolling semi-axis of 1, and E* = 1."""
    side = WIDEST / PIXELS
    first, second = np.indices((PIXELS, PIXELS)).reshape(2, -1)
    inside = (first + 0.5) ** 2 + (second + 0.5) ** 2 < PIXELS**2
    first, second = first[inside], second[inside]
    apart: Array = side * np.arange(2 * PIXELS, dtype=np.float64)
    half_sides = side / 2, axis_ratio * side / 2
    influence = pressed_rectangle(apart[:, None], axis_ratio * apart, half_sides=half_sides) / np.pi
    compliance = np.zeros((first.size, first.size))
    for along_x in (np.abs(first[:, None] - first), first[:, None] + first + 1):  # from a pixel, and from its image
        for along_y in (np.abs(second[:, None] - second), second[:, None] + second + 1):
            compliance += influence[along_x, along_y]
    return Pixels(
        x=np.asarray(side * (first + 0.5), dtype=np.float64),
        y=np.asarray(axis_ratio * side * (second + 0.5), dtype=np.float64),
        area=axis_ratio * side**2,
        compliance=compliance,
    )
