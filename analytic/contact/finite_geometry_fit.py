"""The fit that corrects one contact by Hertz for the true shape of ball and groove, compiled.

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

from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from analytic import catalog
from analytic.contact.factors import ContactFactors
from analytic.contact.geometry import USUAL_SHOULDERS, RaceNumbers, distances_to_shoulders, rolling_curvature
from analytic.contact.hertz import HertzContact, unit_hertz
from analytic.numerics.compilation import compiled
from analytic.numerics.elements import formula
from analytic.numerics.machine_code import entry
from analytic.numerics.records import Record, dtype_of
from analytic.numerics.root import cube_root
from analytic.scene import Array

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
    "far_shoulder": 0.05,
    "contact_angle": 0.1,
}
STEP_TO_SHOULDER = 0.15  # of the shoulder's distance over b, likewise
SIZE_POWER = {"semi_axis_rolling": 2, "semi_axis_transverse": 2, "peak_pressure": 2, "approach": 1}  # the leading ones
# Uncertainty over the held change of Hertz: what grows over the first step, and what the fading adds.
HELD, FADED = 0.1, 1.4
SMALL = 0.1  # b/r below which the uncertainty falls in proportion to b/r, as the factors do: a point contact is Hertz's
EXPONENTS = 5  # of a base in a term: 0 to 4
MOST_FACTORS = 4  # powers of bases in a term
TINIEST = 1e-300  # replaces a size of 0 in the logarithm, which is multiplied by the size


class ContactShape(NamedTuple):
    """The ratios that the correction depends on."""

    conformity: float  # r_g/D
    rolling_curvature: float  # r/R: radius of the ball over rolling radius of the race, negative on an outer race
    size: float  # b/r: Hertz's transverse semi-axis over the ball's radius
    ball_poisson_ratio: float
    race_poisson_ratio: float
    ball_share: float  # share of the ball in the compliance 1/E*
    shoulder: float  # distance of the shoulder that the contact has moved towards from its centre, over r
    far_shoulder: float  # likewise of the other shoulder
    contact_angle: float = 0.0  # rad: the lands beyond the shoulders are parallel to the axis of the bearing


class Bases(NamedTuple):
    """What the terms are products of, at one side of a contact."""

    size: float  # b/r
    axis_ratio: float  # a/b, Hertz's, rolling over transverse
    relative_load: float  # Q/(E* r delta) by Hertz = 2 pi (b/r)/(3 K): a displacement Q/(E* r) over the approach
    rolling_curvature: float  # r/R
    openness: float  # 1 - r/r_g
    log_drift: float  # sum of s (1 - 2 nu)^2/(1 - nu) R_ball/R over both bodies, 1/R the mean curvature, times ln(b/r)
    shoulder_curvature: float  # r over the distance of the shoulder
    land_slope: float  # rise of the land towards the ball over the tangent plane: -tan(al), on the far side tan(al)
    ball_share: float  # s, of the compliance
    race_share: float
    ball_drift: float  # s (1 - 2 nu)/(1 - nu): how far a load draws the surface towards itself
    race_drift: float
    ball_bulk: float  # s/(1 - nu^2): E*/E
    race_bulk: float


BASES, SIDES = Bases._fields, ("shoulder_curvature", "land_slope")  # the latter differ between the sides
SIDED = len(BASES) * EXPONENTS  # where the products of these begin in the table of powers
CHANGES = SIDED + EXPONENTS**2  # where what they add to the four factors begins
POWERS = CHANGES + 4  # numbers in the table


class FitNumbers(NamedTuple):
    """The stored fit; quantities in the order of `ContactFactors`, ratios in that of `ContactShape`."""

    low: Array  # (9,) least of each ratio
    high: Array  # (9,)
    step: Array  # (9,)
    coefficients: Array  # (terms,) of all quantities
    factors: NDArray[np.intp]  # (terms, MOST_FACTORS) what of the table of powers each term multiplies
    first: NDArray[np.intp]  # (5,) term of each quantity, and the end
    uncertainty: Array  # (4,)
    size_power: NDArray[np.intp]  # (4,)


class GeometryNumbers(NamedTuple):
    """The correction of one contact; `CorrectedGeometry` says what it is."""

    factors: ContactFactors
    uncertainty: ContactFactors
    beyond: float  # steps out of the range, see `steps_beyond`
    applied: float


@cache
def stored_fit() -> dict[str, Any]:
    """The stored fit with its provenance."""
    return catalog.entry("corrections", "finite_geometry")


def limits() -> dict[str, tuple[float, float]]:
    """Least and greatest value of each ratio; a small contact is Hertz's, and both shoulders share one range."""
    stored = {name: (low, high) for name, (low, high) in stored_fit()["range"].items()}
    return stored | {"size": (0.0, stored["size"][1]), "far_shoulder": stored["shoulder"]}


@cache
def fit_numbers() -> FitNumbers:
    """The stored fit as tables."""
    quantities = [stored_fit()["quantity"][name] for name in ContactFactors._fields]
    terms = [term for quantity in quantities for term in quantity["terms"]]
    factors = np.zeros((len(terms), MOST_FACTORS), dtype=np.intp)  # 0: a power of 0
    for row, term in enumerate(terms):
        places = {BASES.index(base) * EXPONENTS + power for base, power in term["powers"].items() if base not in SIDES}
        curvature, slope = (term["powers"].get(base, 0) for base in SIDES)
        if curvature or slope:
            places.add(SIDED + curvature * EXPONENTS + slope)
        factors[row, : len(places)] = sorted(places)
    ranges = [limits()[name] for name in ContactShape._fields]
    return FitNumbers(
        low=np.array([low for low, _ in ranges], dtype=np.float64),
        high=np.array([high for _, high in ranges], dtype=np.float64),
        step=np.array([STEP[name] for name in ContactShape._fields]),
        coefficients=np.array([term["coefficient"] for term in terms]),
        factors=factors,
        first=np.cumsum([0, *(len(quantity["terms"]) for quantity in quantities)], dtype=np.intp),
        uncertainty=np.array([quantity["uncertainty"] for quantity in quantities]),
        size_power=np.array([SIZE_POWER[name] for name in ContactFactors._fields], dtype=np.intp),
    )


@cache
def fit_record() -> Record:
    """The stored fit as a record."""
    fit = fit_numbers()
    kinds = [(name, table.dtype, table.shape) for name, table in zip(FitNumbers._fields, fit, strict=True)]
    return np.array([tuple(fit)], dtype=np.dtype(kinds, align=True)).view(np.recarray)[0]


@compiled
def steps_beyond(fit: FitNumbers, shape: ContactShape) -> float:
    """How far a shape lies outside the range of the fit, in steps of each ratio; the largest of these, 0 within.

    0 without load, where nothing is to be corrected.
    """
    if not shape.size > 0:
        return 0.0
    nearer = min(shape.shoulder, shape.far_shoulder)
    beyond = max((OFF_SHOULDER - nearer / shape.size) / STEP_TO_SHOULDER, 0.0)
    for k in range(len(shape)):
        beyond = max(beyond, max(fit.low[k] - shape[k], shape[k] - fit.high[k]) / fit.step[k])
    return beyond


@compiled
def held_shape(fit: FitNumbers, shape: ContactShape) -> ContactShape:
    """The nearest shape within the range."""
    low, high = fit.low, fit.high
    size = min(max(shape.size, low[2]), high[2])
    nearest = OFF_SHOULDER * size
    return ContactShape(
        min(max(shape.conformity, low[0]), high[0]),
        min(max(shape.rolling_curvature, low[1]), high[1]),
        size,
        min(max(shape.ball_poisson_ratio, low[3]), high[3]),
        min(max(shape.race_poisson_ratio, low[4]), high[4]),
        min(max(shape.ball_share, low[5]), high[5]),
        max(min(max(shape.shoulder, low[6]), high[6]), nearest),
        max(min(max(shape.far_shoulder, low[7]), high[7]), nearest),
        min(max(shape.contact_angle, low[8]), high[8]),
    )


@formula
def shape_bases(shape: ContactShape) -> tuple[Bases, Bases]:
    """The bases at the near and at the far side."""
    unit, slope = unit_hertz(1 + shape.rolling_curvature, 1 - 0.5 / shape.conformity, 1.0), np.tan(shape.contact_angle)
    return _bases_of(shape, unit, shape.shoulder, -slope), _bases_of(shape, unit, shape.far_shoulder, slope)


@compiled
def _bases_of(shape: ContactShape, unit: HertzContact, shoulder: float, land_slope: float) -> Bases:
    """The bases at one side; shoulder : its distance over r;  land_slope : see `Bases`.

    unit : the contact of the shape with r = 1 and E* = 1, under the load 1
    """
    openness, ball, race = 1 - 0.5 / shape.conformity, shape.ball_share, 1 - shape.ball_share
    of_ball, of_race = shape.ball_poisson_ratio, shape.race_poisson_ratio
    ball_drift, race_drift = ball * (1 - 2 * of_ball) / (1 - of_ball), race * (1 - 2 * of_race) / (1 - of_race)
    mean_curvature = (shape.rolling_curvature + openness - 1) / 2  # of the race, times r; the ball's is 1
    logarithm = ball_drift * (1 - 2 * of_ball) + race_drift * (1 - 2 * of_race) * mean_curvature
    return Bases(
        shape.size,
        unit.semi_axis_x / unit.semi_axis_y,
        shape.size / (unit.semi_axis_y * unit.approach),
        shape.rolling_curvature,
        openness,
        logarithm * np.log(max(shape.size, TINIEST)),
        1 / shoulder,
        land_slope,
        ball,
        race,
        ball_drift,
        race_drift,
        ball / (1 - of_ball**2),
        race / (1 - of_race**2),
    )


@compiled
def _fill_powers(near: Bases, far: Bases, powers: Array) -> None:
    """Every base to the powers 0 to EXPONENTS - 1, and the products of the sided bases' powers, averaged."""
    for base in range(len(near)):
        power = 1.0
        for exponent in range(EXPONENTS):
            powers[base * EXPONENTS + exponent] = power
            power *= near[base]
    near_curvature, far_curvature = 1.0, 1.0
    for exponent in range(EXPONENTS):
        near_product, far_product = near_curvature, far_curvature
        for other in range(EXPONENTS):
            powers[SIDED + exponent * EXPONENTS + other] = (near_product + far_product) / 2
            near_product, far_product = near_product * near.land_slope, far_product * far.land_slope
        near_curvature, far_curvature = near_curvature * near.shoulder_curvature, far_curvature * far.shoulder_curvature


@compiled
def _change(fit: FitNumbers, quantity: int, powers: Array) -> float:
    """Sum of coefficient * (product of powers of bases)."""
    change = 0.0
    for term in range(fit.first[quantity], fit.first[quantity + 1]):
        product = fit.coefficients[term]
        for factor in range(MOST_FACTORS):
            product *= powers[fit.factors[term, factor]]
        change += product
    return change


@formula
def geometry_of(fit: FitNumbers, shape: ContactShape, powers: Array) -> GeometryNumbers:
    """Semi-axes, peak pressure and approach of the true shape over Hertz's; powers : (POWERS,), overwritten

    Outside the range the change of Hertz is that at the border, times b/r (approach) or (b/r)^2 over that there, and
    its uncertainty grows. Two steps of `steps_beyond` away the factors are 1, and the uncertainty holds all of that
    change.
    """
    held = held_shape(fit, shape)
    grown = shape.size / held.size if held.size > 0 else 1.0
    near, far = shape_bases(held)
    _fill_powers(near, far, powers)
    for quantity in range(4):
        powers[CHANGES + quantity] = _change(fit, quantity, powers) * grown ** fit.size_power[quantity]
    rolling, transverse = powers[CHANGES], powers[CHANGES + 1]
    approach, pressure = powers[CHANGES + 2], powers[CHANGES + 3]
    beyond = steps_beyond(fit, shape)
    applied = min(max(2 - beyond, 0.0), 1.0)
    growth = HELD * min(beyond, 1.0) + FADED * (1 - applied)
    small = min(1.0, shape.size / SMALL)
    return GeometryNumbers(
        ContactFactors(1 + applied * rolling, 1 + applied * transverse, 1 + applied * approach, 1 + applied * pressure),
        ContactFactors(
            fit.uncertainty[0] * small + growth * abs(rolling),
            fit.uncertainty[1] * small + growth * abs(transverse),
            fit.uncertainty[2] * small + growth * abs(approach),
            fit.uncertainty[3] * small + growth * abs(pressure),
        ),
        beyond,
        applied,
    )


@formula
def shape_on(race: RaceNumbers, shoulders: tuple[float, float], contact_angle: float, load: float) -> ContactShape:
    """The shape of ball on race.

    shoulders : angles of the near and the far one on the profile, rad
    contact_angle : al, rad, in [-pi/2, pi/2];  load : Q, N
    """
    curvature = rolling_curvature(race, contact_angle)
    unit = unit_hertz(curvature, race.curvature_transverse, race.modulus)
    towards, away = distances_to_shoulders(race, shoulders, contact_angle)
    return ContactShape(
        race.groove_radius / (2 * race.ball_radius),
        race.ball_radius * curvature - 1,
        unit.semi_axis_y * cube_root(load) / race.ball_radius,
        race.ball_poisson_ratio,
        race.race_poisson_ratio,
        race.ball_share,
        towards / race.ball_radius,
        away / race.ball_radius,
        abs(contact_angle) if race.bottom_angle == 0 else 0.0,
    )


@compiled
def shoulders_of(race: RaceNumbers, height: float) -> tuple[float, float]:
    """Angles of both shoulders on the profile, rad; height : over the ball's diameter, where they are not known."""
    if not np.isnan(race.near_shoulder):
        return race.near_shoulder, race.far_shoulder
    near = np.arccos(1 - 2 * height * race.ball_radius / race.groove_radius)
    return near, near if np.isnan(race.far_shoulder) else race.far_shoulder


@entry(lambda: {"fit": fit_record().dtype, "race": dtype_of(RaceNumbers), "given": 2, "powers": 1, "fields": 2})
def geometries_on(fit: FitNumbers, race: RaceNumbers, given: Array, powers: Array, fields: Array) -> None:
    """Write the corrections of n balls on a race; of shoulders that are not known, those of a typical height.

    given : (2, n) contact angles, rad, and loads, N;  powers : as `geometry_of`
    fields : (10, n) factors, their uncertainty, steps beyond the range and the share applied
    The uncertainty of a typical height reaches to the factors of a low and of a high shoulder.
    """
    known = not np.isnan(race.near_shoulder)
    for i in range(given.shape[1]):
        for number in range(1 if known else 3):  # the typical height first
            height = USUAL_SHOULDERS[(1, 0, 2)[number]]
            shape = shape_on(race, shoulders_of(race, height), given[0, i], given[1, i])
            found = geometry_of(fit, shape, powers)
            if number == 0:
                for k in range(4):
                    fields[k, i], fields[4 + k, i] = found.factors[k], found.uncertainty[k]
                fields[8, i], fields[9, i] = found.beyond, found.applied
                continue
            for k in range(4):
                away = abs(found.factors[k] - fields[k, i])
                fields[4 + k, i] = max(fields[4 + k, i], away + found.uncertainty[k])
