"""What the model does not compute, and how near a torque is to it; and every warning of a torque."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from analytic.contact.geometry import RACES, USUAL_SHOULDERS
from analytic.effects import NO_CAGE
from analytic.numerics.records import Records
from analytic.oil.grease import MEASURED_SIZES
from analytic.oil.inlets import replenishment_exponent
from analytic.oil.lubrication import SHORTEST
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, Scene, Supply
from analytic.solve.kernel import IN_LOADED_ZONE
from analytic.solve.solution import Solution
from analytic.surface.roughness import GapRoughness
from analytic.words import MICROMETRE, MILLIMETRE, RPM, length_of, percent_of, pressure_of, speed_of

CHECKED = "checked, not modelled"  # how a reason begins
MOST_CUT = 0.1  # share of an ellipse's load beyond a shoulder, by Hertz, up to which its torque is known
# -ln of the replenishment factor, ln 2: less than half of rolling is left, so the torque of a start is another one. A
# judgement, as [SKF2018] states no range.
MOST_STARVED = 0.693
STATIC_LIMIT = 4.2e9  # Pa, peak pressure that leaves a dent of 1e-4 ball diameters (ISO 76, ball bearings)
LIGHT = 0.01  # of the heaviest ball's load: a film of a lighter ball hardly changes the torque
HEAVY = 0.1  # weight of a ball over the load of the lightest one, from which its direction matters, a judgement
# Speed n d_m, mm/min, beyond which bearings need more than usual design; rules of thumb [BearingWorks], [Anderson1973]
USUAL_SPEEDS: dict[Supply, float] = {"grease": 0.5e6, "oil_bath": 1e6, "oil_spot": 1e6, "oil_jet": 2e6}
HYBRID_JET = 3e6  # with an oil jet and ceramic balls
ENDLESS = "the formula is -8 to +1 % off for endless ellipses"  # `analytic.oil.film.FORMULA_UNCERTAINTY`
LIGHTEST_STEEL = 6000.0  # kg/m^3: a lighter ball is a ceramic one


@dataclass(frozen=True, kw_only=True, eq=False)
class LimitNumbers:
    """What is judged against a limit, by the worst ball at each of n operating points; None: not in the scene.

    `analytic.verdicts` has the limits.
    """

    peak_pressure: Array  # (2, n) Pa, of each race
    cut_off: Array  # (2, n) share of a contact's load beyond a shoulder; by the lowest usual one where it is not known
    knows_shoulder: NDArray[np.bool_]  # (2,) of each race
    sliding_number: Array | None = None  # (2, n) rolling force of the oil over the most friction of each race
    gyroscopic_hold: Array | None = None  # (n,) ratio of gyroscopic moment to the most that friction holds
    cage_grip: Array | None = None  # (n,) share of the grip of the races that the cage uses; NaN: not known
    tilt: Array | None = None  # (n,) of the inner ring, rad, where it is not held straight
    replenishment: Array | None = None  # (n,) -ln of the replenishment factor that starves the inlets

    def at(self, points: NDArray[np.intp]) -> "LimitNumbers":
        """The same at some operating points.

        Parameters
        ----------
        points : ndarray, shape (k,)
            Numbers of the points, from 0.

        Returns
        -------
        LimitNumbers
            Of k points.
        """
        changed = {n: v[..., points] for n, v in vars(self).items() if v is not None and n != "knows_shoulder"}
        return replace(self, **changed)

    def worst(self, rows: Sequence[NDArray[np.intp]], points: Sequence[NDArray[np.intp]], count: int) -> "LimitNumbers":
        """The worst of several balls or bearings at each operating point.

        Parameters
        ----------
        rows : sequence of ndarray, shape (k,)
            Numbers of the elements of these arrays.
        points : sequence of ndarray, shape (k,)
            Numbers of the operating points that they belong to.
        count : int
            Number of operating points.

        Returns
        -------
        LimitNumbers
            Of `count` points.
        """

        def largest(values: Array) -> Array:
            found = np.zeros((*values.shape[:-1], count))
            for row, point in zip(rows, points, strict=True):
                found[..., point] = np.maximum(found[..., point], values[..., row])
            return found

        changed = {n: largest(v) for n, v in vars(self).items() if v is not None and n != "knows_shoulder"}
        return replace(self, **changed)


def known_shoulders(bearing: Bearing) -> tuple[bool, bool]:
    """Whether the shoulder of the inner and of the outer race is known."""
    return bearing.inner.shoulder_half_width is not None, bearing.outer.shoulder_half_width is not None


def limit_numbers(scene: Scene, found: Solution, counted: Mapping[str, bool]) -> LimitNumbers:
    """The numbers of the contacts of a torque."""
    starves = scene.lubricant is not None and counted["starvation"]
    return LimitNumbers(
        peak_pressure=found.points["peak_pressure"].T.copy(),
        cut_off=found.points["cut_off"].T.copy(),
        knows_shoulder=np.array(known_shoulders(scene.bearing)),
        replenishment=replenishment_exponent(scene.bearing, scene.lubricant, scene.operation.as_series().inner_speed)
        if starves and scene.lubricant is not None
        else None,
    )


def limit_reasons(scene: Scene, found: Solution) -> dict[str, str]:
    """How near each limit is, in words, by the effects of the kind "limit"."""
    peak = float(found.points["peak_pressure"].max())
    return {
        "plasticity": f"{CHECKED}: peak pressure {pressure_of(peak)}, {percent_of(peak / STATIC_LIMIT)} of the static "
        f"limit, {pressure_of(STATIC_LIMIT)}",
        "shoulder": f"{CHECKED}: {_nearest_shoulder(scene.bearing, found)}",
    }


def _at_shoulders(bearing: Bearing, found: Solution) -> Iterator[tuple[str, bool, float, float]]:
    """(race, whether its shoulder is known, semi-axis and distance of the contact that comes nearest to it, m)."""
    for race, (name, is_known) in enumerate(zip(RACES, known_shoulders(bearing), strict=True)):
        b, distance = (found.balls[field][..., race] for field in ("semi_axis_transverse", "shoulder_distance"))
        worst = np.unravel_index(np.argmin(distance - b), distance.shape)
        yield name, is_known, b[worst], distance[worst]


def _nearest_shoulder(bearing: Bearing, found: Solution) -> str:
    left, nearest, unknown = np.inf, "no ball is loaded", []
    for name, is_known, b, distance in _at_shoulders(bearing, found):
        if not is_known:
            unknown.append(name)
        elif distance - b < left:
            left = distance - b
            nearest = f"semi-axis {length_of(b)} of {length_of(distance)} to the {name} race's shoulder"
    if not unknown:
        return nearest
    rings = " and ".join(f"bearing.{name}.shoulder_height" for name in unknown)
    return f"shoulder not known: give {rings}" + (f"; {nearest}" if np.isfinite(left) else "")


def _past_limits(scene: Scene, found: Solution, numbers: LimitNumbers) -> Iterator[str]:
    """A warning for each limit that is past."""
    bearing = scene.bearing
    for name, is_known, b, distance in _at_shoulders(bearing, found):
        if is_known and b > distance:
            yield (
                f"the contact ellipse exceeds the shoulder of the {name} race: semi-axis {length_of(b)}, "
                f"distance {length_of(distance)}; the real contact is cut off there, with a higher pressure"
            )
    share = float(found.points["cut_off"].max())
    if share > MOST_CUT and not numbers.knows_shoulder.all():
        yield (
            f"shoulder not known: a low one, {USUAL_SHOULDERS[0]:g} ball diameters high, cuts off "
            f"{percent_of(share, 2)} of a contact's load, limit {percent_of(MOST_CUT)}; give shoulder_height of "
            "both rings"
        )
    elif share > MOST_CUT:
        yield (
            f"a shoulder cuts off {percent_of(share, 2)} of a contact's load by Hertz, limit {percent_of(MOST_CUT)}: "
            "Hertz does not hold for pressure and position; raise shoulder_half_width or lower the load"
        )
    for name, peak in zip(RACES, found.points["peak_pressure"].max(axis=0), strict=True):
        if peak > STATIC_LIMIT:
            yield (
                f"the peak pressure on the {name} race, {pressure_of(peak)}, exceeds the static limit, "
                f"{pressure_of(STATIC_LIMIT)}: the contact is no longer elastic"
            )
    exponent = numbers.replenishment
    if exponent is not None and (worst_factor := exponent.max(initial=0.0)) > MOST_STARVED:
        speed = speed_of(float(np.abs(scene.operation.as_series().inner_speed).max()))
        yield (
            f"starved to flooded: SKF's replenishment factor leaves {percent_of(np.exp(-worst_factor), 2)} of rolling "
            f"at {speed}, a law for running bearings; at a start oil lies in the races, and the interval contains "
            "both; give lubricant.starvation_degree"
        )


def _light_balls(scene: Scene, found: Solution, counted: Mapping[str, bool]) -> Iterator[str]:
    """A ball whose weight is not small against its load, where the direction of gravity is assumed."""
    if scene.down is not None or not (counted["weight"] and scene.effects.get("weight") != "off"):
        return
    load = found.balls["load"].min(axis=2)
    lightest = np.where(load > IN_LOADED_ZONE * load.max(axis=1, keepdims=True), load, np.inf).min(axis=1)
    share = float((scene.bearing.ball_mass * STANDARD_GRAVITY / lightest).max(initial=0.0))
    if share > HEAVY:
        yield (
            f"the weight of a ball is {percent_of(share, 2)} of its load, limit {percent_of(HEAVY)}, and the direction "
            "of gravity is not given: give operation.down"
        )


def torque_warnings(
    scene: Scene,
    found: Solution,
    counted: Mapping[str, bool],
    *,
    numbers: LimitNumbers,
    roughness: GapRoughness | None,
) -> list[str]:
    """Every warning, the worst first: limits, what the total is without, and how it was read and computed.

    counted : `counted_effects`;  numbers : `limit_numbers`
    roughness : of ball and race together, where film and asperities share the load
    """
    warnings = [*_past_limits(scene, found, numbers), *_lacking(scene), *scene.warnings]
    warnings += _light_balls(scene, found, counted)
    if scene.clearances is not None and scene.clearances.operating < 0:
        warnings.append(
            f"no clearance in operation: {MICROMETRE.written(scene.clearances.unmounted, '.3g')} unmounted, "
            f"{MICROMETRE.written(scene.clearances.mounted, '.3g')} mounted, an interference of "
            f"{MICROMETRE.written(-scene.clearances.operating, '.3g')} on the diameter in operation; it preloads every "
            f"ball with {scene.clearances.ball_load:.3g} N"
        )
    if scene.friction_coefficient is not None:
        warnings.append(
            f"the friction coefficient {scene.friction_coefficient:g} is from the scene, not from a lubrication model"
        )
    if scene.microslip == "as_printed":
        warnings.append(
            'friction.microslip = "as_printed" is no model: equations 2 to 7 as printed exchange M_z and M_r without '
            "spin and from a spin-to-roll ratio of 1/2 on, equation 2 lacks its factor 0.322, and both moments jump "
            'there; "derived" is correct'
        )
    if (seals := scene.losses.origins.get("seals")) is not None and scene.losses.seals is not None:
        warnings.append(
            f"the drag of the seals, {1e3 * scene.losses.seals:.3g} N mm, is assumed: {seals.source}; give "
            "losses.seals by a measured torque"
        )
    if (speed := too_fast(scene)) is not None:
        warnings.append(speed)
    if counted["starvation"]:
        warnings += _greased(scene)
    if roughness is not None:
        warnings += roughness.warnings
    for race, name in enumerate(RACES):
        if roughness is not None:
            warnings += _film(found.balls, race)
        if counted["rolling"] and found.points["rolling_extrapolated"][:, race].any():
            warnings.append(
                f"rolling on the {name} race is extrapolated: the law holds for slow rolling, contacts longer across "
                f"rolling than along, and oil {SHORTEST:g} semi-axes ahead or more"
            )
    return warnings


def _lacking(scene: Scene) -> Iterator[str]:
    """Parts of unknown size that the total is without."""
    if scene.bearing.seals_rub and scene.losses.seals is None:
        yield (
            f"the total is without the drag of the seals ({scene.bearing.seals}): give losses.seals, for example "
            '"5 N mm" or "estimate"'
        )
    if scene.cage is None and scene.losses.pockets is None and scene.effects.get("cage") != "off":
        yield f"the total is without the cage: {NO_CAGE}"
    if scene.lubricant is None and scene.effects.get("rolling") != "off":
        yield "the total is without the hydrodynamic rolling resistance: add a table [lubricant]"


def usual_speed(scene: Scene) -> float:
    """Speed up to which n d_m is usual practice with the supply of the oil, rad/s; without an oil as in a bath."""
    is_hybrid = scene.bearing.ball_material.density < LIGHTEST_STEEL
    supply = _supply(scene)
    limit = HYBRID_JET if is_hybrid and supply == "oil_jet" else USUAL_SPEEDS[supply]
    return limit / (RPM.factor * MILLIMETRE.number(scene.bearing.pitch_diameter))


def _supply(scene: Scene) -> Supply:
    return "oil_bath" if scene.lubricant is None else scene.lubricant.supply


def too_fast(scene: Scene) -> str | None:
    """That n d_m is beyond usual practice, in words; None: it is not."""
    fastest, usual = float(np.max(np.abs(scene.operation.inner_speed), initial=0.0)), usual_speed(scene)
    if fastest <= usual:
        return None
    found, limit = (RPM.number(speed) * MILLIMETRE.number(scene.bearing.pitch_diameter) for speed in (fastest, usual))
    return (
        f"n d_m = {found:.3g} mm/min exceeds {limit:.2g} mm/min, the usual limit with "
        f"{_supply(scene).replace('_', ' ')}: life of cage and lubrication not checked"
    )


def _greased(scene: Scene) -> Iterator[str]:
    """A greased bearing of another size than the measured ones."""
    bearing, oil = scene.bearing, scene.lubricant
    if oil is None or not oil.starves_as_measured(bearing):
        return
    (low, high), mean = MEASURED_SIZES, bearing.pitch_diameter
    if not low <= mean <= high:
        yield (
            f"films with grease are extrapolated: measured in bearings of {MILLIMETRE.written(low, 'g')} to "
            f"{MILLIMETRE.written(high, 'g')} pitch diameter (6204 to 6209), here {MILLIMETRE.written(mean, '.3g')}"
        )


def _film(balls: Records, race: int) -> Iterator[str]:
    """Films that the formula does not give, on balls that carry enough to matter."""
    load = balls["load"][..., race]
    carries = load > LIGHT * np.max(load, axis=-1, keepdims=True, initial=0.0)
    if np.any((balls["film_extrapolated"][..., race] != 0) & carries):
        a, b = (balls[f"semi_axis_{way}"][..., race] for way in ("rolling", "transverse"))
        error = "error not known: it is longer along rolling than across" if np.any(a > b) else ENDLESS
        yield f"the film on the {RACES[race]} race is extrapolated: contact ellipse outside the fitted shapes; {error}"
    if np.any((balls["film_capped"][..., race] != 0) & carries):
        yield f"the film on the {RACES[race]} race is limited to the space between the bodies, less than the formula"
