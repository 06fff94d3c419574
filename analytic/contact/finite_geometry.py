"""Factors that correct Hertz's contacts for the true shape of ball and groove, with their uncertainty and warnings.

`analytic.contact.finite_geometry_fit` has the fit and says where it comes from.
"""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.contact.factors import ContactCorrection, ContactFactors, FactorNumbers
from analytic.contact.finite_geometry_fit import (
    BASES,
    OFF_SHOULDER,
    POWERS,
    SIDES,
    ShapeNumbers,
    bases_of,
    fit_record,
    geometries_on,
    geometry_of,
    limits,
    put_geometry,
    shape_on,
    unit_of,
)
from analytic.contact.geometry import (
    USUAL_SHOULDERS,
    Race,
    race_numbers,
    require_contact_angle,
    with_shoulders,
)
from analytic.contact.hertz import ball_share, contact_modulus, hertz_contact
from analytic.numerics.elements import mapped, rows_of
from analytic.numerics.records import record_of
from analytic.scene import Array, Bearing, Contact
from analytic.words import DEGREE, Unit, percent_of


@dataclass(frozen=True, kw_only=True, eq=False)
class ContactShape:
    """The ratios that the correction depends on; the fields broadcast."""

    conformity: ArrayLike  # r_g/D
    rolling_curvature: ArrayLike  # r/R: radius of the ball over rolling radius of the race, negative on an outer race
    size: ArrayLike  # b/r: Hertz's transverse semi-axis over the ball's radius
    ball_poisson_ratio: ArrayLike
    race_poisson_ratio: ArrayLike
    ball_share: ArrayLike  # share of the ball in the compliance 1/E*
    shoulder: ArrayLike  # distance of the shoulder that the contact has moved towards from its centre, over r
    far_shoulder: ArrayLike | None = None  # likewise of the other shoulder; None: as `shoulder`
    contact_angle: ArrayLike = 0.0  # rad: the lands beyond the shoulders are parallel to the axis of the bearing


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
    """Semi-axes, peak pressure and approach of the true shape over Hertz's, with their uncertainty.

    The range of each ratio is that of the file, and both shoulders are at least 1.15 Hertz semi-axes b away. Smaller
    sizes are accepted too: there the correction fades to 1. Outside the range the change of Hertz is that at the
    border, times b/r (approach) or (b/r)^2 over that there, and its uncertainty grows. Two steps of `steps_beyond` away
    the factors are 1, and the uncertainty holds all of that change. The warnings say which ratios lie outside.
    """

    def of_numbers(*ratios: float) -> Array:
        fields = np.empty(10)
        put_geometry(geometry_of(fit_record(), ShapeNumbers(*ratios), np.empty(POWERS)), fields)
        return fields

    return _corrected(mapped(of_numbers, *_ratios(shape)), lambda: shape)


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
    found = _corrected(
        fields.reshape(len(fields), *of),
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
    numbers = record_of(race_numbers(bearing, race))
    shoulders = numbers.near_shoulder, numbers.far_shoulder
    shapes = mapped(lambda angle, load: shape_on(numbers, shoulders, angle, load), contact_angle, ball_load)
    return ContactShape(**dict(zip(ShapeNumbers._fields, shapes, strict=True)))


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
        size=hertz.semi_axis_y / radius,
        ball_poisson_ratio=ball.poisson_ratio,
        race_poisson_ratio=race.poisson_ratio,
        ball_share=ball_share(ball, race),
        shoulder=contact.shoulder / radius,
        far_shoulder=contact.far_shoulder / radius,
        contact_angle=contact.tilt,
    )


def shape_bases(shape: ContactShape) -> dict[str, Array]:
    """The bases of the terms by name, see `Bases`: those of a shoulder (2, ...), near and far, the others (...)."""

    def of_numbers(*ratios: float) -> list[tuple[float, float]]:
        each = ShapeNumbers(*ratios)
        unit, slope = unit_of(each), float(np.tan(each.contact_angle))
        near, far = bases_of(each, unit, each.shoulder, -slope), bases_of(each, unit, each.far_shoulder, slope)
        return list(zip(near, far, strict=True))

    bases = dict(zip(BASES, mapped(of_numbers, *_ratios(shape)), strict=True))
    return {name: sides if name in SIDES else sides[0] for name, sides in bases.items()}


def _corrected(fields: Array, shape: Callable[[], ContactShape]) -> CorrectedGeometry:
    """The correction from the fields of `_put`; shape : that it was applied to, of the same dimensions."""
    quantities, size = FactorNumbers._fields, len(FactorNumbers._fields)
    factors, uncertainty = (dict(zip(quantities, fields[first : first + size], strict=True)) for first in (0, size))
    beyond, applied = fields[-2:]
    return CorrectedGeometry(
        factors=ContactFactors(**factors),
        uncertainty=MappingProxyType(uncertainty),
        covered=beyond == 0,
        applied=applied,
        warnings=tuple(_outside(shape(), applied)) if beyond.any() else (),
    )


def _ratios(shape: ContactShape) -> list[ArrayLike]:
    """The ratios in the order of `ShapeNumbers`."""
    if shape.far_shoulder is None:
        shape = replace(shape, far_shoulder=shape.shoulder)
    return [getattr(shape, name) for name in ShapeNumbers._fields]


def _range(name: str, value: float, low: float, high: float) -> str:
    """A ratio outside its range, or an angle in degrees."""
    unit = DEGREE if name == "contact_angle" else Unit("", 1.0)
    ends = f"{unit.number(low):.4g} to {unit.written(high, '.4g')}"
    return f"{name.replace('_', ' ')} {unit.written(value, '.4g')} is outside {ends}"


def _outside(shape: ContactShape, applied: Array) -> Iterator[str]:
    """Which ratios lie outside the range, and what the correction does there."""
    values = dict(zip(ShapeNumbers._fields, np.broadcast_arrays(*_ratios(shape)), strict=True))

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
