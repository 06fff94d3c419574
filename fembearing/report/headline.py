"""The first lines of a torque: what was computed, the torque with its interval, and how far to trust it."""

from collections.abc import Collection, Mapping
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from analytic.result import COORDINATES, TorquePoint
from analytic.scene import Scene
from analytic.words import percent_of
from fembearing.quantities import METRIC, QUANTITIES, SYSTEMS, Units
from fembearing.report.phrases import between, present_loads, varying_loads
from fembearing.report.scene_view import SceneView
from fembearing.report.tables.points import point_cells, point_heads
from fembearing.report.tables.table import Head, Table, table_of
from fembearing.report.tables.torque import PARTS, RESIDUE
from fembearing.report.torque import TorqueRecord, torque_record
from fembearing.verify.torque.scene_torque import SceneTorque

MOST_ROWS = 6  # points of a series in the headline
FULL, BOUNDARY = 0.01, 0.9  # share of the load on asperities: below a full film, above boundary lubrication
ABSENT = "not known"


@dataclass(frozen=True, kw_only=True)
class Headline:
    """The first lines of `fembearing torque` in words, in the units of the scene; a series from least to greatest."""

    title: str  # bearing, loads, speed and oil
    torque: str
    unit: str  # of the torque
    interval: str  # of 95 %, in the same unit; or that it is not known
    power: str  # W
    split: str  # largest parts of the torque, in per cent
    film: str  # lambda on both races, and the regime; empty without oil and surface
    makers: str  # torques by the formulas of the makers
    verdict: str  # in one word
    reason: str  # of the verdict


def torque_headline(result: SceneTorque) -> Headline:
    """The first lines of `fembearing torque`, in words.

    Parameters
    ----------
    result : SceneTorque
        Of `torque_of_scene`.

    Returns
    -------
    Headline
        In the system of units of the scene.
    """
    record, units = torque_record(result), SYSTEMS[result.scene.report.units]
    found = span_of(record, units)
    return Headline(
        title=headline_title(result.scene, record, units),
        torque=found.torque,
        unit=units.torque.name,
        interval=found.interval,
        power=found.power,
        split=found.split,
        film=film_words(result) or "",
        makers=makers_words(record, units),
        verdict=record.standing.word,
        reason=record.standing.reason,
    )


def headline_title(scene: Scene | SceneView, record: TorqueRecord, units: Units = METRIC) -> str:
    """Bearing, loads, speed where it is one, oil, temperature and supply."""
    points, oil = record.points, scene.lubricant
    words = [f"{'' if record.pair is None else 'two '}{scene.bearing.name}"]
    fixed = [name for name in present_loads(points) if name not in varying_loads(points) and getattr(points[0], name)]
    for name in fixed:
        load = QUANTITIES[name].in_units(units).shown.written(getattr(points[0], name), ".5g")
        words.append(f"{COORDINATES[name].meaning.removesuffix(' load')} {load}")
    speeds = {point.inner_speed for point in points}
    words += [units.speed.written(speeds.pop(), ".5g")] if len(speeds) == 1 else []
    if oil is None:
        words.append(
            "dry" if scene.friction_coefficient is None else f"friction coefficient {scene.friction_coefficient:g}"
        )
    else:
        steady = " (steady)" if "temperature" in oil.origins else ""
        words.append(f"{oil.name or 'oil'} at {units.temperature.written(oil.temperature, '.4g')}{steady}")
        words.append(oil.supply.replace("_", " "))
    return ", ".join(words)


def headline_table(scene: Scene, record: TorqueRecord, units: Units = METRIC) -> Table:
    """One row for each point, at most six: torque, interval, power and the largest parts."""
    points, computed = record.points, record.computed
    places = (
        computed
        if len(computed) <= MOST_ROWS
        else [computed[round(number)] for number in np.linspace(0, len(computed) - 1, MOST_ROWS)]
    )
    heads = [*point_heads(points, units), Head(f"torque, {units.torque.name}", fixed=True), Head("95 %", fixed=True)]
    heads += [Head("power, W", fixed=True), Head("made of", "text")]
    rows = [
        [
            *point_cells(points, place, units),
            f"{units.torque.number(points[place].torque.total):.4g}",
            ABSENT if (ends := record.interval[place]) is None else between(ends, units.torque),
            f"{points[place].torque.total * abs(points[place].inner_speed):.3g}",
            split_of(points[place]),
        ]
        for place in places
    ]
    notes = []
    if len(places) < len(computed):
        notes.append(f"{len(places)} of {len(computed)} operating points; --json and --out have all.")
    if all(record.interval[place] is None for place in places):
        notes.append("No interval: more than 50 points, or no torque at the bound of an input; try --interval.")
    notes += [f"{len(record.left_out)} points without a torque are skipped."] if record.left_out else []
    return table_of(headline_title(scene, record, units), heads, rows, notes)


def side_by_side(results: Mapping[str, SceneTorque], units: Units = METRIC) -> Table:
    """One row for each scene: torque, interval, power and the largest parts; of a series from the least to the most.

    results : by the name of the scene
    """
    heads = [Head("scene", "name"), Head(f"torque, {units.torque.name}", fixed=True), Head("95 %", fixed=True)]
    heads += [Head("power, W", fixed=True), Head("made of", "text"), Head("verdict", "verdict")]
    rows, notes = [], []
    for name, result in results.items():
        record = torque_record(result)
        rows.append([name, *span_of(record, units), record.standing.word])
        count = len(record.computed)
        series = "" if count == 1 else f"{count} points, made of: at the highest torque; "
        notes.append(f"{name}: {series}{record.standing.reason}")
    return table_of("Friction torque", heads, rows, notes)


class Span(NamedTuple):
    """A torque over its operating points, each from the least to the most."""

    torque: str
    interval: str
    power: str  # W
    split: str  # at the highest torque


def span_of(record: TorqueRecord, units: Units = METRIC) -> Span:
    """Torque, interval, power and the largest parts."""
    points = [record.points[place] for place in record.computed]
    ends = [each for place in record.computed if (each := record.interval[place]) is not None]
    known = len(ends) == len(points)
    return Span(
        torque=_span([units.torque.number(point.torque.total) for point in points], ".4g", "-"),
        interval=between((min(ends)[0], max(high for _, high in ends)), units.torque) if known else ABSENT,
        power=_span([point.torque.total * abs(point.inner_speed) for point in points], ".3g", "-"),
        split=split_of(max(points, key=lambda point: point.torque.total)),
    )


def torque_words(record: TorqueRecord, units: Units = METRIC) -> str:
    """Torque, interval, power and the largest parts in a line."""
    found, count, name = span_of(record, units), len(record.computed), units.torque.name
    series = "" if count == 1 else f" at {count} points"
    return f"torque {found.torque} {name}{series}, 95 % {found.interval}, {found.power} W: {found.split}"


def split_of(point: TorquePoint) -> str:
    """The parts of the torque, from the largest, in per cent."""
    total = point.torque.total
    parts = {
        short: value
        for name, short in PARTS.items()
        if (value := getattr(point.torque, name)) is not None and value > RESIDUE * total
    }
    largest = sorted(parts, key=parts.__getitem__, reverse=True)
    return ", ".join(f"{name} {100 * parts[name] / total:.0f} %" for name in largest[:3])


def film_words(result: SceneTorque) -> str | None:
    """Film ratio and regime of the heaviest ball; None without oil and surface."""
    films, roughness, shares = result.friction.film, result.friction.gap_roughness, result.friction.asperity_share
    if roughness is None or films.inner is None or films.outer is None or shares.inner is None or shares.outer is None:
        return None
    ratios = [f"{_span(film / roughness)} {race}" for race, film in vars(films).items()]
    carried = np.concatenate([shares.inner, shares.outer])
    names = [
        "full film" if each < FULL else "boundary" if each > BOUNDARY else "mixed"
        for each in (carried.min(), carried.max())
    ]
    regime = " to ".join(dict.fromkeys(names))
    return f"film: lambda {', '.join(ratios)}; asperities carry up to {percent_of(float(carried.max()), 2)}: {regime}"


def makers_words(record: TorqueRecord, units: Units = METRIC) -> str:
    """What the formulas of each maker give, over all points."""
    band = record.catalogue_band
    makers: dict[str, list[float]] = {}
    for name, series in band.values.items():  # a maker may have two constants: "Palmgren, z = 0.0004"
        makers.setdefault(name.partition(",")[0], []).extend(each for each in series if each is not None)
    ends = {name: sorted({min(known), max(known)}) for name, known in makers.items() if known}
    numbers = [f"{name} {between(values, units.torque)}" for name, values in ends.items()]
    if not numbers:
        return "makers: no formula holds for this bearing or load"
    return f"makers: {', '.join(numbers)} {units.torque.name}"


def _span(values: Collection[float] | np.ndarray, form: str = ".2g", joined: str = " to ") -> str:
    low, high = f"{min(values):{form}}", f"{max(values):{form}}"
    return low if low == high else f"{low}{joined}{high}"
