"""The first lines of a torque: what was computed, the torque with its interval, and how far to trust it."""

from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from analytic.columns import COLUMNS, COORDINATES, Point
from analytic.effects import DECLARED
from analytic.limits import MOST_STARVED
from analytic.makers import NO_BAND, WITHOUT_LOSSES
from analytic.scene_torque import MOST_ESTIMATED, SceneTorque
from analytic.units import METRIC, SYSTEMS, Units, speed_words
from analytic.words import percent_of, rounded
from fembearing.report.document import Block, Head, Row, Section, Table, Text, table_of
from fembearing.report.phrases import between
from fembearing.report.sections.inputs import tilt_of
from fembearing.report.sections.points import point_cells, point_heads, present_loads, varying_loads
from fembearing.report.sections.torque import PARTS, RESIDUE

if TYPE_CHECKING:  # a torque alone needs no solver, which the report of a check loads
    from fembearing.report.report import Report

NO_TORQUE = "No torque: no friction coefficient, lubricant or surface is given."
MOST_ROWS = 6  # points of a series in the headline
FULL, BOUNDARY = 0.01, 0.9  # share of the load on asperities: below a full film, above boundary lubrication
MOST_PARTS = 3  # of a torque
MOST_NAMES = 8  # of scenes in a line
LINE, APART = 80, 2  # characters of a terminal's line, and between two columns
SMALLEST = 0.005  # share of the torque: 0 % as it is printed
UNLOADED = 1e-4  # share of the load on asperities that is none
THINNEST = 1e-3  # film ratio that is none
ABSENT = "not known"
Said = TypeVar("Said")


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
    return _headline(result, SYSTEMS[result.scene.report.units])


def _headline(result: SceneTorque, units: Units) -> Headline:
    points = [result.points[place] for place in result.places.computed]
    ends = [each for point in points if (each := ends_of(point)) is not None]
    known = len(ends) == len(points)
    return Headline(
        title=headline_title(result, units),
        torque=_span([units.torque.number(point["torque_total"]) for point in points], 4, "-"),
        unit=units.torque.name,
        interval=between((min(ends)[0], max(high for _, high in ends)), units.torque) if known else ABSENT,
        power=_span([point["torque_total"] * abs(point["inner_speed"]) for point in points], 3, "-"),
        split=split_of(max(points, key=lambda point: point["torque_total"]), declared_by(result)),
        film=film_words(result) or "",
        makers=makers_words(result, units),
        verdict=result.standing.word,
        reason=result.standing.reason,
    )


def headline_title(result: SceneTorque, units: Units = METRIC) -> str:
    """Bearing, loads, speed where it is one, oil, temperature and supply."""
    scene, points, oil = result.scene, result.points, result.scene.lubricant
    words = [f"{'' if result.friction.pair is None else 'two '}{scene.bearing.name}"]
    fixed = [name for name in present_loads(points) if name not in varying_loads(points) and points[0][name]]
    for name in fixed:
        load = COLUMNS[name].shown(units).written(points[0][name], ".5g")
        words.append(f"{COORDINATES[name].meaning.removesuffix(' load')} {load}")
    words += [tilt_of(result, units)] if tilt_of(result, units) else []
    speeds = {point["inner_speed"] for point in points}
    words += [speed_words(speeds.pop(), units)] if len(speeds) == 1 else []
    if oil is None:
        words.append(
            "dry" if scene.friction_coefficient is None else f"friction coefficient {scene.friction_coefficient:g}"
        )
    else:
        steady = " (steady)" if "temperature" in oil.origins else ""
        named, at = oil.name, units.temperature.written(oil.temperature, ".4g")
        if not named:
            reference = units.temperature.written(oil.reference_temperature, ".4g")
            named = f"oil of {oil.viscosity:.3g} Pa s{'' if reference == at else f' at {reference},'}"
        words.append(f"{named} at {at}{steady}")
        words.append(oil.supply.replace("_", " "))
    return ", ".join(words)


def headline_section(result: SceneTorque) -> Section:
    """What was computed, the torque with its interval, the film, the makers' formulas, and how far to trust it."""
    units = SYSTEMS[result.scene.report.units]
    lines = [line for line in (film_words(result), makers_words(result, units)) if line is not None]
    standing = Text(result.standing.reason, verdict=result.standing.word)
    return Section("", [headline_table(result, units), *map(Text, lines), standing])


def check_headline(document: "Report") -> Section:
    """The headline of the torque, the largest difference from each reference, and the one verdict of the check."""
    torque, verdict = document.solved, document.verdict
    found: Sequence[Block] = [Text(f"{document.scene.name}. {NO_TORQUE}")]
    if torque is not None:
        standing = Text(f"torque {torque.standing.word}: {torque.standing.reason}")
        found = [*headline_section(torque).blocks[:-1], standing]
    measured = [] if document.measured is None else [Text(document.measured.conclusions[0])]
    findings = [Text(finding.words) for finding in document.findings]
    return Section("", [*found, *measured, *findings, Text(verdict.reason, verdict=f"references {verdict.overall}")])


def headline_table(result: SceneTorque, units: Units = METRIC) -> Table:
    """One row for each point, at most six: torque, interval, power and the largest parts."""
    points, computed = result.points, result.places.computed
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
            rounded(units.torque.number(points[place]["torque_total"]), 4),
            ABSENT if (ends := ends_of(points[place])) is None else between(ends, units.torque),
            rounded(points[place]["torque_total"] * abs(points[place]["inner_speed"]), 3),
            split_of(points[place], declared_by(result)),
        ]
        for place in places
    ]
    notes = []
    if len(places) < len(computed):
        notes.append(f"{len(places)} of {len(computed)} operating points; --json and --out have all.")
    if all(ends_of(points[place]) is None for place in places):
        is_long = len(computed) > MOST_ESTIMATED
        why = f"more than {MOST_ESTIMATED} points" if is_long else "no torque at the bound of an input"
        notes.append(f"No interval: {why}; try --interval.")
    if lost := len(result.places.failures):
        notes.append(
            "1 point without a torque is skipped." if lost == 1 else f"{lost} points without a torque are skipped."
        )
    return table_of(headline_title(result, units), heads, _in_a_line(heads, rows, len(heads) - 1), notes)


def side_by_side(results: Mapping[str, SceneTorque], units: Units = METRIC) -> Table:
    """One row for each scene: torque, interval, power and the largest parts; of a series from the least to the most.

    results : by the name of the scene
    """
    heads = [Head("scene", "name"), Head(f"torque, {units.torque.name}", fixed=True), Head("95 %", fixed=True)]
    heads += [Head("power, W", fixed=True), Head("made of", "text"), Head("verdict", "verdict")]
    rows, said = [], {}
    for name, result in results.items():
        found, count = _headline(result, units), len(result.places.computed)
        rows.append([name, found.torque, found.interval, found.power, found.split, found.verdict])
        series = "" if count == 1 else f"{count} points, made of: at the highest torque; "
        said[name] = f"{series}{found.reason}"
    notes = [f"{names}{each}" for each, names in names_by(said.items()).items()]
    return table_of("Friction torque", heads, _in_a_line(heads, rows, len(heads) - 2), notes)


def names_by(said: Iterable[tuple[str, Said]]) -> dict[Said, str]:
    """The scenes that share what is said of them, as "6206, 6308: "; said : names with it"""
    names: dict[Said, list[str]] = {}
    for name, each in said:
        names.setdefault(each, []).append(name)
    more = {each: f" and {len(found) - MOST_NAMES} more" for each, found in names.items() if len(found) > MOST_NAMES}
    return {each: f"{', '.join(found[:MOST_NAMES])}{more.get(each, '')}: " for each, found in names.items()}


def _in_a_line(heads: Sequence[Head], rows: Sequence[Row], place: int) -> Sequence[Row]:
    """The rows with all parts of the torque, or with the largest two or one, as many as a line has room for.

    place : of the parts in a row
    """
    fitting = rows
    for most in range(MOST_PARTS, 0, -1):
        fitting = [[*row[:place], ", ".join(row[place].split(", ")[:most]), *row[place + 1 :]] for row in rows]
        widths = [
            max(len(head.short or head.text), *(len(row[column]) for row in fitting))
            for column, head in enumerate(heads)
            if not head.wide
        ]
        if sum(widths) + APART * (len(widths) - 1) <= LINE:
            break
    return fitting


def declared_by(result: SceneTorque) -> str:
    """What the declared part of the torque is of: seals, drag or both."""
    return "+".join(each.name for each in result.friction.effects.unmeasured if each.name in DECLARED and each.share)


def split_of(point: Point, declared: str) -> str:
    """The parts of the torque, from the largest, in per cent; declared : name of the declared part."""
    total = point["torque_total"]
    parts = {
        short: value
        for name, short in (PARTS | {"declared": declared}).items()
        if (value := point[f"torque_{name}"]) is not None and value > RESIDUE * total
    }
    largest = sorted(parts, key=parts.__getitem__, reverse=True)[:MOST_PARTS]
    shares = [(name, parts[name] / total) for name in largest]
    return ", ".join(f"{name} {100 * share:.0f} %" for name, share in shares if share > SMALLEST)


def film_words(result: SceneTorque) -> str | None:
    """Film ratio and regime of the heaviest ball; None without oil and surface."""
    films, roughness, shares = result.friction.film, result.friction.gap_roughness, result.friction.asperity_share
    if roughness is None or films.inner is None or films.outer is None or shares.inner is None or shares.outer is None:
        return None
    runs = result.friction.inner_speed != 0
    thick = {race: film / roughness for race, film in vars(films).items()}
    ratios = [f"{_span(np.where(runs & (each > THINNEST), each, 0.0))} {race}" for race, each in thick.items()]
    carried = np.concatenate([shares.inner, shares.outer])
    names = [
        "full film" if each < FULL else "boundary" if each > BOUNDARY else "mixed"
        for each in (carried.min(), carried.max())
    ]
    regime = " to ".join(dict.fromkeys(names))
    most = float(carried.max())
    load = "no load" if most < UNLOADED else f"up to {percent_of(most, 2)}"
    if not runs.any():
        return "film: none at standstill, starting torque in boundary lubrication"
    starved = result.friction.limits.replenishment
    state = "" if starved is None or starved.max(initial=0.0) <= MOST_STARVED else ", starved to flooded"
    return f"film: lambda {', '.join(ratios)}; asperities carry {load}: {regime}{state}"


def makers_words(result: SceneTorque, units: Units = METRIC) -> str:
    """What the formulas of each maker give, over all points; beside losses, that they are without them."""
    makers: dict[str, list[float]] = {}
    for name, series in result.makers.items():  # a maker may have two constants: "Palmgren, z = 0.0004"
        known = series[np.isfinite(series)].tolist()
        makers.setdefault(name.partition(",")[0], []).extend(known)
    shown = {name: [units.torque.number(each) for each in known] for name, known in makers.items() if known}
    numbers = [f"{name} {_span(each, 3, '-')}" for name, each in shown.items()]
    if not numbers:
        why = note.removeprefix(NO_BAND) if (note := result.catalogue.note).startswith(NO_BAND) else "not for this load"
        return f"makers: no formula: {why}"
    losses = result.friction.torque.declared is not None or result.friction.torque.oil is not None
    return f"makers: {', '.join(numbers)} {units.torque.name}{f', {WITHOUT_LOSSES}' if losses else ''}"


def ends_of(point: Point) -> tuple[float, float] | None:
    """Both ends of the 95 % interval, N m; None: not known."""
    low, high = point.get("interval_low"), point.get("interval_high")
    return None if low is None or high is None else (low, high)


def _span(values: Collection[float] | np.ndarray, count: int = 2, joined: str = " to ") -> str:
    low, high = rounded(min(values), count), rounded(max(values), count)
    return low if low == high else f"{low}{joined}{high}"
