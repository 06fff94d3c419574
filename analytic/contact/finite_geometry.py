"""Factors that correct Hertz's contact for the true shape of ball and groove, fitted to finite-element solutions.

Hertz assumes that both bodies are half spaces and that the gap is a paraboloid. In a bearing the ball ends at its
middle plane, the surfaces under the contact are curved, and the groove encloses the ball and ends at its shoulders. In
linear elasticity the ratio of each quantity to Hertz's depends only on the ratios in a `ContactShape`. The fit is
    1 + sum of coefficient * (product of powers of the bases below)
with the coefficients of catalog/corrections/finite_geometry.toml, whose head says how they were obtained. Every term
vanishes with the size of the contact, so a small contact is Hertz's.
Each shoulder acts by itself, to 1e-5 (validation/correction/sides.py): the fit is taken at each side, with its shoulder
and the slope of its land, and averaged.
The terms of first order follow theory. Take a body of modulus E, Poisson ratio nu and curvature 1/R under the load Q.
Its approach to a plane far away differs from that of a half space by Q/(E R) times a number, and is larger by
-(1 - 2 nu)^2 (1 + nu) Q ln(b/R)/(2 pi E R). The reason: on a curved surface Boussinesq's radial stress
(1 - 2 nu) Q/(2 pi x^2) leaves a shear x/R times as large, and removing this shear from the surface pushes the middle
in. This is derived here; the sphere of [Sternberg1952] has such a logarithm.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, fields, replace
from functools import cache
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic import catalog
from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.contact.geometry import USUAL_SHOULDERS, Race, race_curvatures, shoulder_distances
from analytic.contact.hertz import contact_modulus, hertz_contact
from analytic.scene import Array, Bearing, Contact, Material
from analytic.words import DEGREE, Unit, percent_of

OFF_SHOULDER = 1.15  # least distance from a fitted contact's centre to the shoulder, in Hertz's semi-axes b
# Beyond its range the fit's change of Hertz is held at the border, and follows a power of b/r beyond the largest size,
# for as far as finite elements confirm it (the set `beyond` of validation/correction/solves.csv: shoulders down to the
# edge of the contact; sizes to 0.49). These lengths are a step of `beyond_range`; over the second it fades.
STEP = {
    "conformity": 0.0025,
    "rolling_curvature": 0.12,
    "size": 0.05,
    "ball_poisson_ratio": 0.1,
    "race_poisson_ratio": 0.1,
    "ball_share": 0.01,
    "shoulder": 0.05,
    "contact_angle": 0.1,
}
STEP_TO_SHOULDER = 0.15  # of the shoulder's distance over b, likewise
SIZE_POWER = {"semi_axis_rolling": 2, "semi_axis_transverse": 2, "peak_pressure": 2, "approach": 1}  # the leading ones
# Uncertainty over the held change of Hertz: what grows over the first step, and what the fading adds.
HELD, FADED = 0.1, 1.4
SMALL = 0.1  # b/r below which the uncertainty falls in proportion to b/r, as the factors do: a point contact is Hertz's
BASES = (  # of `shape_bases`
    *("size", "axis_ratio", "relative_load", "rolling_curvature", "openness", "log_drift"),
    *("shoulder_curvature", "land_slope"),
    *("ball_share", "race_share", "ball_drift", "race_drift", "ball_bulk", "race_bulk"),
)
MOST_POWER = 4  # highest power of a base in a term
TINIEST = 1e-300  # replaces a size of 0 in the logarithm, which is multiplied by the size
LEAST_FACTOR = 0.1  # of what the uncertainty allows


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
    farthest: ContactFactors  # those that lie as far beyond Hertz's as the growth of the uncertainty outside allows
    uncertainty: Mapping[str, Array]  # of each factor, relative half-width, 95 %; grows outside the range
    covered: NDArray[np.bool_]  # where the shape lies within the range
    applied: Array  # 1 within the range and one step beyond, from there falling to 0
    warnings: tuple[str, ...]  # which ratios lie outside, with the numbers


@dataclass(frozen=True, kw_only=True, eq=False)
class RaceCorrections:
    """The corrections of both races of a bearing, with one element for each operating point."""

    inner: CorrectedGeometry
    outer: CorrectedGeometry

    @property
    def correction(self) -> ContactCorrection:
        return ContactCorrection(inner=self.inner.factors, outer=self.outer.factors)

    @property
    def farthest(self) -> ContactCorrection:
        return ContactCorrection(inner=self.inner.farthest, outer=self.outer.farthest)

    @property
    def warnings(self) -> tuple[str, ...]:
        sides = (("inner", self.inner), ("outer", self.outer))
        return tuple(f"{race}: {warning}" for race, side in sides for warning in side.warnings)


def finite_geometry_factors(shape: ContactShape) -> CorrectedGeometry:
    """Semi-axes, peak pressure and approach of the true shape over Hertz's, with their uncertainty.

    The range of each ratio is that of the file, and both shoulders are at least 1.15 Hertz semi-axes b away. Smaller
    sizes are accepted too: there the correction fades to 1. Outside the range the change of Hertz is that at the
    border, times b/r (approach) or (b/r)^2 over that there, and its uncertainty grows. Two steps of `beyond_range` away
    the factors are 1, and the uncertainty holds all of that change. The warnings say which ratios lie outside.
    """
    fit = stored_fit()
    values, beyond = _broadcast(shape), beyond_range(shape)
    held, grown = _held(values)
    powers = _powers(shape_bases(held))
    applied = np.clip(2 - beyond, 0.0, 1.0)
    growth = HELD * np.minimum(beyond, 1.0) + FADED * (1 - applied)
    factors, farthest, uncertainty = {}, {}, {}
    for name, quantity in fit["quantity"].items():
        change = grown ** SIZE_POWER[name] * _change(name, powers)
        factors[name] = 1 + applied * change
        # A contact far beyond the range may have any size, but no factor is negative.
        farthest[name] = np.maximum(1 + (applied + growth) * change, LEAST_FACTOR)
        uncertainty[name] = quantity["uncertainty"] * np.minimum(1, values["size"] / SMALL) + growth * np.abs(change)
    return CorrectedGeometry(
        factors=ContactFactors(**factors),
        farthest=ContactFactors(**farthest),
        uncertainty=MappingProxyType(uncertainty),
        covered=beyond == 0,
        applied=applied,
        warnings=tuple(_outside(values, applied)),
    )


def within_unknown_shoulders(
    typical: CorrectedGeometry, low: CorrectedGeometry, high: CorrectedGeometry
) -> CorrectedGeometry:
    """The correction of shoulders that are not known, from those of a typical, a low and a high one.

    The factors are the typical ones. Their uncertainty reaches to those of either other, and nothing is covered.
    """
    every, factors = (typical, low, high), vars(typical.factors)
    farthest, uncertainty = {}, {}
    for name, factor in factors.items():
        others = np.stack([getattr(each.factors, name) for each in every])
        ends = np.stack([getattr(each.farthest, name) for each in every])
        own = np.stack([each.uncertainty[name] for each in every])
        uncertainty[name] = np.max(np.abs(others - factor) + own, axis=0)
        at = np.argmax(np.abs(ends - factor), axis=0)[None]
        farthest[name] = np.take_along_axis(ends, at, axis=0)[0]
    taken, least, most = (USUAL_SHOULDERS[place] for place in (1, 0, 2))
    return replace(
        typical,
        farthest=ContactFactors(**farthest),
        uncertainty=MappingProxyType(uncertainty),
        covered=np.zeros_like(typical.covered),
        warnings=(
            f"shoulder not known: the correction is that of a height of {taken:g} ball diameters, and its uncertainty "
            f"that of {least:g} to {most:g}",
            *typical.warnings,
        ),
    )


def beyond_range(shape: ContactShape) -> Array:
    """How far a shape lies outside the range of the fit, in steps of each ratio; the largest of these, 0 within.

    0 without load, where nothing is to be corrected.
    """
    values = _broadcast(shape)
    nearer = np.minimum(values["shoulder"], values["far_shoulder"])
    beyond = np.maximum(OFF_SHOULDER - nearer / np.maximum(values["size"], TINIEST), 0.0) / STEP_TO_SHOULDER
    for name, (low, high) in _limits().items():
        outside = np.maximum(low - values[name], values[name] - high)
        beyond = np.maximum(beyond, outside / STEP[name.removeprefix("far_")])
    return np.where(values["size"] > 0, beyond, 0.0)


def race_shape(bearing: Bearing, race: Race, *, contact_angle: ArrayLike, ball_load: ArrayLike) -> ContactShape:
    """The shape of ball on race, whose shoulders must be known.

    contact_angle (al, rad, in [-pi/2, pi/2], see `shoulder_distances`) and ball_load (Q, N, >= 0) broadcast.
    """
    groove, radius = bearing.inner if race == "inner" else bearing.outer, bearing.ball_radius
    shoulder, far_shoulder = shoulder_distances(bearing, race, contact_angle=contact_angle)
    rolling, _ = race_curvatures(bearing, race, contact_angle=np.abs(contact_angle))
    return _shape(
        radius=radius,
        groove_radius=groove.groove_radius,
        rolling_curvature=radius * rolling - 1,
        shoulders=(shoulder, far_shoulder),
        contact_angle=np.abs(contact_angle) if bearing.kind == "radial" else np.zeros_like(rolling),
        load=ball_load,
        materials=(bearing.ball_material, groove.material),
    )


def contact_shape(contact: Contact) -> ContactShape:
    """The shape of one contact."""
    return _shape(
        radius=contact.ball_radius,
        groove_radius=contact.groove_radius,
        rolling_curvature=contact.ball_radius / contact.rolling_radius,
        shoulders=(contact.shoulder, contact.far_shoulder),
        contact_angle=contact.tilt,
        load=contact.load,
        materials=(contact.ball_material, contact.race_material),
    )


def shape_bases(shape: ContactShape) -> dict[str, Array]:
    """The bases that the terms are products of, by name.

    size : b/r;  axis_ratio : a/b, Hertz's, rolling over transverse
    relative_load : Q/(E* r delta) by Hertz = 2 pi (b/r)/(3 K): a displacement Q/(E* r) over the approach
    ball_share, race_share : s, shares of the compliance, sum 1
    ball_drift, race_drift : s (1 - 2 nu)/(1 - nu): how far a load draws the surface towards itself
    ball_bulk, race_bulk : s/(1 - nu^2): E*/E
    log_drift : sum over both bodies of s (1 - 2 nu)^2/(1 - nu) R_ball/R, with 1/R the mean curvature, times ln(b/r)
    rolling_curvature : r/R;  openness : 1 - r/r_g
    shoulder_curvature : (2, ...) r over the distance of each shoulder
    land_slope : (2, ...) rise of each land towards the ball over the tangent plane: -tan(al), tan(al)
    """
    values = _broadcast(shape)
    size, rolling = values["size"], values["rolling_curvature"]
    openness, share = 1 - 0.5 / values["conformity"], values["ball_share"]
    unit = hertz_contact(curvature_x=1 + rolling, curvature_y=openness, load=1.0, modulus=1.0)
    log_size = np.log(np.maximum(size, TINIEST))
    shares = {"ball": share, "race": 1 - share}
    ratios = {body: values[f"{body}_poisson_ratio"] for body in shares}
    drift = {body: shares[body] * (1 - 2 * ratios[body]) / (1 - ratios[body]) for body in shares}
    curvature = {"ball": 1.0, "race": (rolling + openness - 1) / 2}
    logarithm = sum(drift[body] * (1 - 2 * ratios[body]) * curvature[body] for body in shares)
    return {
        "size": size,
        "axis_ratio": unit.semi_axis_x / unit.semi_axis_y,
        "relative_load": size / (unit.semi_axis_y * unit.approach),
        "rolling_curvature": rolling,
        "openness": openness,
        "shoulder_curvature": 1 / np.stack([values["shoulder"], values["far_shoulder"]]),
        "land_slope": np.stack([-np.tan(values["contact_angle"]), np.tan(values["contact_angle"])]),
        "log_drift": logarithm * log_size,
        **{f"{body}_share": shares[body] for body in shares},
        **{f"{body}_drift": drift[body] for body in shares},
        **{f"{body}_bulk": shares[body] / (1 - ratios[body] ** 2) for body in shares},
    }


@cache
def stored_fit() -> dict[str, Any]:
    """The stored fit with its provenance."""
    return catalog.entry("corrections", "finite_geometry")


def _powers(bases: Mapping[str, Array]) -> Array:
    """Every base at both sides to the powers 0 to MOST_POWER, which the terms choose: (bases times powers, 2, ...)."""
    stacked = np.stack(np.broadcast_arrays(*(bases[name] for name in BASES)))
    return np.stack([stacked**power for power in range(MOST_POWER + 1)], axis=1).reshape(-1, *stacked.shape[1:])


@cache
def _terms(name: str) -> tuple[Array, NDArray[np.intp]]:
    """The terms of one quantity: coefficients (terms,), and indices of the powers they multiply, (factors, terms)."""
    terms = stored_fit()["quantity"][name]["terms"]
    positions = {base: position for position, base in enumerate(BASES)}
    indices = np.zeros((max(len(term["powers"]) for term in terms), len(terms)), dtype=np.intp)  # index 0: a power of 0
    for column, term in enumerate(terms):
        for row, (base, power) in enumerate(term["powers"].items()):
            indices[row, column] = positions[base] * (MOST_POWER + 1) + power
    return np.array([term["coefficient"] for term in terms]), indices


def _change(name: str, powers: Array) -> Array:
    """Sum of coefficient * (product of powers of bases), averaged over the sides, for every shape."""
    coefficients, indices = _terms(name)
    products = powers[indices[0]]
    for factor in indices[1:]:
        products = products * powers[factor]
    return np.tensordot(coefficients, products, axes=1).mean(axis=0)


def _limits() -> dict[str, tuple[float, float]]:
    """Least and greatest value of each ratio; a small contact is Hertz's, and both shoulders share one range."""
    limits = {name: (low, high) for name, (low, high) in stored_fit()["range"].items()}
    return limits | {"size": (0.0, limits["size"][1]), "far_shoulder": limits["shoulder"]}


def _held(values: Mapping[str, Array]) -> tuple[ContactShape, Array]:
    """The nearest shape within the range, and how much larger the contact is than there."""
    held = {name: np.clip(values[name], low, high) for name, (low, high) in _limits().items()}
    for name in ("shoulder", "far_shoulder"):
        held[name] = np.maximum(held[name], OFF_SHOULDER * held["size"])
    grown = np.divide(values["size"], held["size"], out=np.ones_like(held["size"]), where=held["size"] > 0)
    return ContactShape(**held), grown


def _range(name: str, value: float, low: float, high: float) -> str:
    """A ratio outside its range, or an angle in degrees."""
    unit = DEGREE if name == "contact_angle" else Unit("", 1.0)
    ends = f"{unit.number(low):.4g} to {unit.written(high, '.4g')}"
    return f"{name.replace('_', ' ')} {unit.written(value, '.4g')} is outside {ends}"


def _outside(values: Mapping[str, Array], applied: Array) -> Iterator[str]:
    """Which ratios lie outside the range, and what the correction does there."""

    def done(least: float) -> str:
        if least == 1:
            return "the correction is held at the border"
        return "the correction is not applied" if least == 0 else f"{percent_of(least, 2)} of the correction is applied"

    loaded = values["size"] > 0
    for name, (low, high) in _limits().items():
        value = values[name]
        outside = ~((value >= low) & (value <= high)) & loaded
        if outside.any():
            farthest = value[outside][np.argmax(np.abs(value[outside] - (low + high) / 2))]
            least = applied[value == farthest].min()
            yield f"{_range(name, farthest, low, high)} of the fit: {done(least)}"
    near = np.minimum(values["shoulder"], values["far_shoulder"]) < OFF_SHOULDER * values["size"]
    if near.any():
        yield (
            f"the contact comes nearer to the shoulder than {OFF_SHOULDER:g} semi-axes, and the fit does not: "
            f"{done(applied[near].min())}"
        )


def _shape(
    *,
    radius: float,
    groove_radius: float,
    rolling_curvature: ArrayLike,
    shoulders: tuple[ArrayLike, ArrayLike],
    contact_angle: ArrayLike,
    load: ArrayLike,
    materials: tuple[Material, Material],
) -> ContactShape:
    ball, race = materials
    modulus = contact_modulus(ball, race)
    hertz = hertz_contact(
        curvature_x=(1 + np.asarray(rolling_curvature)) / radius,
        curvature_y=(groove_radius - radius) / (radius * groove_radius),
        load=load,
        modulus=modulus,
    )
    return ContactShape(
        conformity=groove_radius / (2 * radius),
        rolling_curvature=rolling_curvature,
        size=hertz.semi_axis_y / radius,
        ball_poisson_ratio=ball.poisson_ratio,
        race_poisson_ratio=race.poisson_ratio,
        ball_share=modulus * (1 - ball.poisson_ratio**2) / ball.youngs_modulus,
        shoulder=np.asarray(shoulders[0]) / radius,
        far_shoulder=np.asarray(shoulders[1]) / radius,
        contact_angle=contact_angle,
    )


def _broadcast(shape: ContactShape) -> dict[str, Array]:
    names = [field.name for field in fields(shape)]
    if shape.far_shoulder is None:
        shape = replace(shape, far_shoulder=shape.shoulder)
    values = np.broadcast_arrays(*(np.asarray(getattr(shape, name), dtype=np.float64) for name in names))
    return dict(zip(names, values, strict=True))
