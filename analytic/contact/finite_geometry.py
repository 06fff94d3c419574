"""Factors that correct Hertz's contacts for the true shape of ball and groove, with their uncertainty and warnings.

`analytic.contact.finite_geometry_fit` has the fit and says where it comes from.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.finite_geometry_fit import (
    OFF_SHOULDER,
    POWERS,
    ContactShape,
    GeometryNumbers,
    fit_numbers,
    fit_record,
    geometries_on,
    geometry_of,
    limits,
    shape_on,
)
from analytic.contact.geometry import USUAL_SHOULDERS, Race, race_numbers, require_contact_angle, with_shoulders
from analytic.contact.hertz import ball_share, contact_modulus, hertz_contact
from analytic.numerics.elements import rows_of
from analytic.numerics.records import record_of
from analytic.scene import Array, Bearing, Contact
from analytic.words import DEGREE, Unit, percent_of


@dataclass(frozen=True, kw_only=True, eq=False)
class CorrectedGeometry:
    """Factors on Hertz's contact, all of one shape; held at the border of the fit's range, and 1 far outside."""

    factors: ContactFactors
    uncertainty: Mapping[str, Array]  # of each factor, relative half-width, 95 %; grows outside the range
    covered: NDArray[np.bool_]  # where the shape lies within the range
    applied: Array  # share: 1 within the range and one step beyond, from there falling to 0
    warnings: tuple[str, ...]  # which ratios lie outside, with the numbers


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceCorrections:
    """The corrections of both races of a bearing, with one element for each operating point."""

    inner: CorrectedGeometry
    outer: CorrectedGeometry

    @property
    def correction(self) -> ContactCorrection:
        """The factors of both races."""
        return ContactCorrection(inner=self.inner.factors, outer=self.outer.factors)

    @property
    def warnings(self) -> tuple[str, ...]:
        """Where a race lies outside the range of the fit, one line each."""
        sides = (("inner", self.inner), ("outer", self.outer))
        return tuple(f"{race}: {warning}" for race, side in sides for warning in side.warnings)


def finite_geometry_factors(shape: ContactShape) -> CorrectedGeometry:
    """`geometry_of` shapes whose ratios broadcast, with the warnings.

    The range of each ratio is that of the file, and both shoulders are at least 1.15 Hertz semi-axes b away. Smaller
    sizes are accepted too: there the correction fades to 1. The warnings say which ratios lie outside.
    """
    return _corrected(geometry_of(fit_numbers(), shape, np.empty(POWERS)), lambda: shape)


def race_geometry(bearing: Bearing, race: Race, *, contact_angle: ArrayLike, ball_load: ArrayLike) -> CorrectedGeometry:
    """The correction of ball on race; arguments as of `race_shape`.

    Of shoulders that are not known the factors are those of a typical height. Their uncertainty reaches to those of a
    low and of a high one, and nothing is covered.
    """
    require_contact_angle(bearing, np.abs(contact_angle))
    numbers = race_numbers(bearing, race)
    given, of = rows_of(contact_angle, ball_load)
    fields, taken = np.empty((10, given.shape[1])), with_shoulders(bearing, USUAL_SHOULDERS[1])
    geometries_on(fit_record(), record_of(numbers), given, np.empty(POWERS), fields)
    each = fields.reshape(len(fields), *of)
    found = _corrected(
        GeometryNumbers(ContactFactors(*each[:4]), ContactFactors(*each[4:8]), each[8], each[9]),
        lambda: race_shape(taken, race, contact_angle=contact_angle, ball_load=ball_load),
    )
    if not np.isnan(numbers.near_shoulder):
        return found
    return replace(found, covered=np.zeros_like(found.covered))


def race_shape(bearing: Bearing, race: Race, *, contact_angle: ArrayLike, ball_load: ArrayLike) -> ContactShape:
    """The shape of ball on race, whose shoulders must be known.

    contact_angle (al, rad, in [-pi/2, pi/2], see `shoulder_distances`) and ball_load (Q, N, >= 0) broadcast.
    """
    require_contact_angle(bearing, np.abs(contact_angle))
    numbers = race_numbers(bearing, race)
    return shape_on(numbers, (numbers.near_shoulder, numbers.far_shoulder), contact_angle, ball_load)


def contact_shape(contact: Contact) -> ContactShape:
    """The shape of one contact."""
    ball, race, radius = contact.ball_material, contact.race_material, contact.ball_radius
    hertz = hertz_contact(
        curvature_x=(1 + radius / contact.rolling_radius) / radius,
        curvature_y=(contact.groove_radius - radius) / (radius * contact.groove_radius),
        load=contact.load,
        modulus=contact_modulus(ball, race),
    )
    return ContactShape(
        conformity=contact.groove_radius / (2 * radius),
        rolling_curvature=radius / contact.rolling_radius,
        size=float(hertz.semi_axis_y / radius),
        ball_poisson_ratio=ball.poisson_ratio,
        race_poisson_ratio=race.poisson_ratio,
        ball_share=ball_share(ball, race),
        shoulder=contact.shoulder / radius,
        far_shoulder=contact.far_shoulder / radius,
        contact_angle=contact.tilt,
    )


def _corrected(found: GeometryNumbers, shape: Callable[[], ContactShape]) -> CorrectedGeometry:
    """The correction with its warnings; shape : that it was applied to, of the same dimensions."""
    outside = np.asarray(found.beyond) > 0
    return CorrectedGeometry(
        factors=found.factors,
        uncertainty=MappingProxyType(found.uncertainty._asdict()),
        covered=~outside,
        applied=np.asarray(found.applied),
        warnings=tuple(_outside(shape(), np.asarray(found.applied))) if outside.any() else (),
    )


def _range(name: str, value: float, low: float, high: float) -> str:
    """A ratio outside its range, or an angle in degrees."""
    unit = DEGREE if name == "contact_angle" else Unit("", 1.0)
    ends = f"{unit.number(low):.4g} to {unit.written(high, '.4g')}"
    return f"{name.replace('_', ' ')} {unit.written(value, '.4g')} is outside {ends}"


def _outside(shape: ContactShape, applied: Array) -> Iterator[str]:
    """Which ratios lie outside the range, and what the correction does there."""
    values = dict(zip(ContactShape._fields, np.broadcast_arrays(*shape), strict=True))

    def done(least: float) -> str:
        if least == 1:
            return "the correction is that at the border"
        return "the correction is not applied" if least == 0 else f"{percent_of(least, 2)} of the correction is applied"

    loaded = values["size"] > 0
    for name, (low, high) in limits().items():
        value = values[name]
        outside = ~((value >= low) & (value <= high)) & loaded
        if outside.any():
            farthest = value[outside][np.argmax(np.abs(value[outside] - (low + high) / 2))]
            least = applied[value == farthest].min()
            yield f"{_range(name, farthest, low, high)} of the fit: {done(least)}"
    near = np.minimum(values["shoulder"], values["far_shoulder"]) < OFF_SHOULDER * values["size"]
    if near.any():
        yield (
            f"the contact is nearer to the shoulder than {OFF_SHOULDER:g} semi-axes, outside the range of the fit: "
            f"{done(applied[near].min())}"
        )
