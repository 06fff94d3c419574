"""The torque at each operating point, the heaviest ball there, and what finite-element contacts change."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from analytic.columns import COLUMNS, CONTACT, COORDINATES, MODEL_PARTS, Point
from analytic.figures.torque import RESIDUE
from analytic.result import BEARINGS, PairPart
from analytic.scene import OwnTraction
from analytic.scene_torque import SceneTorque
from analytic.units import METRIC, SYSTEMS, Units
from analytic.words import angle_of
from fembearing.report.document import (
    Block,
    Bullets,
    Drawing,
    Head,
    Row,
    Section,
    Table,
    Text,
    table_of,
    without_zero_angles,
)
from fembearing.report.phrases import MEASURED, angle_cell, between, capital, digits, listed, percent, shown
from fembearing.report.sections.cage import cage_tables
from fembearing.report.sections.inputs import PAIRS, clearances_of, effects_of, friction_of, inputs_table
from fembearing.report.sections.limits import limits_section
from fembearing.report.sections.points import fixed_loads, point_cells, point_heads, shown_places
from fembearing.report.sections.prediction import prediction_tables
from fembearing.report.torque import cage_motion

if TYPE_CHECKING:  # a torque alone needs no solver, which the report of a check loads
    from fembearing.report.report import ChangeRecord, Report

LEAST_PART = 1e-4  # relative; less of the model's uncertainty is not named
METHODS = ("loads", "contacts", "sliding", "kinematics", "cage")
OF_CHECK = "Torque at every operating point"
CHANGES = (
    "The table of effects says what the total lacks. Changes: equilibrium and slip power with a, b, "
    "delta and K by finite elements in place of production."
)
PARTS = {  # with their names in a terminal
    "spin": "spin",
    "conformity": "conf.",
    "hysteresis": "hyst.",
    "rolling": "roll.",
    "cage": "cage",
    "oil": "oil",
    "declared": "decl.",
}


def torque_table(torque: SceneTorque, bearing: str, places: Sequence[int], units: Units = METRIC) -> Table:
    """Parts, total, its uncertainties, its interval and the catalogue band.

    places : of the points that are shown; one without a torque has no numbers
    """
    points, predicted, band = torque.points, torque.prediction, torque.catalogue.band
    parts = [name for name in PARTS if getattr(torque.friction.torque, name) is not None]
    model = torque.friction.model_uncertainty is not None
    after = [Head("+-", fixed=True), *([Head("+- of formulas, 95 %", wide=True)] if model else [])]
    after += [] if predicted is None else [Head("95 %", fixed=True)]
    after += [] if band is None else [Head("catalogue", fixed=True)]
    heads = [*point_heads(points, units), *(Head(name, short=PARTS[name]) for name in parts)]
    heads += [Head("total", fixed=True), *after]

    def row(place: int) -> Row:
        point = points[place]
        if place not in computed:
            return [*point_cells(points, place, units), *("" for _ in parts), "left out", *("" for _ in after)]
        values, total = [point[f"torque_{name}"] for name in parts], point["torque_total"]
        cells = [digits(each, units.torque.factor, 4) if each > RESIDUE * total else "0" for each in values]
        cells += [digits(total, units.torque.factor, 4), percent(point["uncertainty_numerical"])]
        cells += [percent(point["uncertainty_model"])] if model else []
        cells += [] if predicted is None else [between((point["interval_low"], point["interval_high"]), units.torque)]
        ends = () if band is None else (point["catalogue_low"], point["catalogue_high"])
        return [*point_cells(points, place, units), *cells, *([between(ends, units.torque)] if ends else [])]

    computed = set(torque.places.computed)
    words = [
        f"Friction torque of {'' if torque.friction.pair is None else 'two '}{bearing}",
        *fixed_loads(points, units),
    ]
    return table_of(", ".join(words), heads, [row(place) for place in places], _torque_notes(torque, places, units))


def _torque_notes(torque: SceneTorque, places: Sequence[int], units: Units) -> list[str]:
    """What the columns are, which points are there, and how uncertain the model is at its worst point."""
    whole, parts = torque.friction.model_uncertainty, torque.friction.model_parts or {}
    largest = {name: float(np.max(values)) for name, values in parts.items()}
    model = None if whole is None else float(np.max(whole))
    count = len(torque.points)
    some = f"{len(places)} of {count} operating points, with the least and the largest total; the JSON has all."
    return [
        *([some] if len(places) < count else []),
        f"In {units.torque.name} about the bearing axis; +-: solver error.",
        uncertainty_of(model, largest),
        f"{capital(torque.catalogue.note)}.",
    ]


def ball_table(torque: SceneTorque, places: Sequence[int], units: Units = METRIC) -> Table:
    """The ball that presses hardest, on both races."""
    computed, gap = torque.places.computed, torque.friction.gap_roughness
    points = [torque.points[place] for place in computed]
    shapes = ("peak_pressure", "semi_axis_rolling", "semi_axis_transverse")
    contact = {name: CONTACT[name].shown(units) for name in shapes}
    film, mu = COLUMNS["film"], COLUMNS["friction_coefficient_inner"].symbol
    columns = [
        ("friction_coefficient", Head(mu), 1.0),
        ("film", Head(film.heading(units)), film.shown(units).factor),
        ("film", Head("film/roughness", wide=True), 1 / gap if gap else 0.0),
        ("asperity_share", Head("asperities, %"), 100.0),
    ]
    known = [each for each in columns if points[0][f"{each[0]}_inner"] is not None]
    heads = [Head("#"), Head("race", "name"), Head(f"load, {units.force.name}")]
    heads += [Head(f"{CONTACT[name].symbol}, {unit.name}") for name, unit in contact.items()]
    heads += [*(head for _, head, _ in known), Head("contact angle, deg (rad)", wide=True)]

    def row(place: int, race: str) -> Row:
        point = torque.points[place]
        return [
            str(place + 1),
            race,
            digits(point[f"load_{race}"], units.force.factor, 4),
            *(digits(point[f"{name}_{race}"], unit.factor, 4) for name, unit in contact.items()),
            *(digits(point[f"{name}_{race}"], factor, 3) for name, _, factor in known),
            angle_cell(point["contact_angle"]) if race == "inner" else "",
        ]

    rows = [row(place, race) for place in places if place in computed for race in ("inner", "outer")]
    angles = [point["contact_angle"] for point in points]
    angle = " to ".join(dict.fromkeys((angle_of(min(angles)), angle_of(max(angles)))))
    share = "; asperities: their share of the load" if points[0]["asperity_share_inner"] is not None else ""
    notes = [f"Contact angle {angle}, mean of both races. a along rolling, b transverse{share}."]
    pocket = [each for point in points if (each := point["friction_coefficient_pocket"]) is not None]
    notes += [f"Friction coefficient of ball on pocket: {listed(pocket)}."] if pocket else []
    return without_zero_angles(table_of("Heaviest ball", heads, rows, notes))


def pair_table(pair: PairPart, places: Sequence[int], units: Units = METRIC) -> Table:
    """The loads and the torque of each bearing of a pair, and the pair's stiffness; places : as `torque_table`."""
    found = pair.columns()
    loads = {"axial_load": COORDINATES["axial_load"].symbol, "radial_load": "Fr", "moment": "M"}
    shown_loads = {
        name: COLUMNS[name].shown(units)
        for name in loads
        if name == "axial_load" or any(np.any(found[f"{name}_{bearing}"]) for bearing in BEARINGS)
    }
    heads = [Head("#"), Head("bearing", "name")]
    heads += [Head(f"{loads[name]}, {unit.name}") for name, unit in shown_loads.items()]
    heads += [Head(f"ball, {units.force.name}"), Head(f"torque, {units.torque.name}")]
    heads += [Head(f"dFa/dz, {units.tangent.name}")]
    rows = [
        [
            str(place + 1),
            f"{name}, relieved" if found[f"is_relieved_{name}"][place] else name,
            *(f"{unit.number(found[f'{load}_{name}'][place]):.4g}" for load, unit in shown_loads.items()),
            f"{units.force.number(found[f'ball_load_{name}'][place]):.4g}",
            f"{units.torque.number(found[f'torque_{name}'][place]):.4g}",
            f"{units.tangent.number(found['shaft_stiffness'][place]):.4g}" if name == "first" else "",
        ]
        for place in places
        for name in BEARINGS
    ]
    return table_of(f"Bearings of the pair, {PAIRS[pair.kind]}", heads, rows, [pair_of(pair, units)])


def change_table(
    points: Sequence[Point], change: "ChangeRecord", places: Sequence[int], units: Units = METRIC
) -> Table:
    """Angle and total of the production and with contacts of finite elements, and the relative changes."""
    angles, totals, fitted = change.contact_angle, change.torque, change.finite_geometry
    angle = Head("angle, deg (rad)", wide=True)
    heads = [*point_heads(points, units), Head("production"), angle, Head("contacts of FE"), angle, Head("change, %")]
    heads += [] if fitted is None else [Head("by the fit, %")]
    rows = [
        [
            *point_cells(points, place, units),
            digits(totals.production[place], units.torque.factor, 4),
            angle_cell(angles.production[place]),
            digits(totals.corrected[place], units.torque.factor, 4),
            angle_cell(angles.corrected[place]),
            shown(change.change.total[place], "+.2f", 100),
            *([] if fitted is None else [shown(fitted.change[place], "+.2f", 100)]),
        ]
        for place in places
    ]
    return without_zero_angles(
        table_of("Changes by finite-element contacts", heads, rows, _change_notes(change, units))
    )


def _change_notes(change: "ChangeRecord", units: Units) -> list[str]:
    """What the columns are, how uncertain the changes are, and how far the contacts under them hold."""
    words = [
        f"Torque in {units.torque.name}; the change has a numerical uncertainty of {100 * change.uncertainty:.2f} %. "
        f"-: no contact solved at that ball load. {change.note}"
    ]
    if change.finite_geometry is not None:
        off = max((each for each in change.finite_geometry.uncertainty if each is not None), default=0.0)
        words.append(f"By the fit: Hertz's contacts corrected for finite geometry; +- {100 * off:.2f} %.")
    if change.verdict != "pass":
        words.append(f"The race contacts are not all within the tolerance: {change.verdict}.")
    return words


def uncertainty_of(model: float | None, parts: Mapping[str, float]) -> str:
    """What is known of the model's uncertainty, at most of all operating points and relative, in a sentence.

    parts : of it, by the formula that is varied
    """
    if model is None:
        return f"Model uncertainty: not known without oil. {MEASURED}"
    named = ", ".join(f"{MODEL_PARTS[name]} {100 * part:.2g} %" for name, part in parts.items() if part > LEAST_PART)
    return (
        f"Model uncertainty, 95 %: up to {100 * model:.2g} % of the total, by {named}. Not included: oil data "
        f"and inputs. {MEASURED}"
    )


def pair_of(pair: PairPart, units: Units = METRIC) -> str:
    """What the columns of a pair's table mean, and its preload."""
    held = (
        "Both bearings carry the axial load, without preload"
        if pair.kind == "tandem"
        else f"Preload {units.force.written(pair.equilibrium.preload, '.4g')} at standstill, by closing "
        f"{units.small_length.written(pair.equilibrium.offset, '.3g')}; the axial load presses on the first bearing"
    )
    return (
        f"{held}. Loads of each bearing along and across its own axis; ball: load of its heaviest; middles "
        f"{units.length.written(pair.equilibrium.distance, '.4g')} apart; dFa/dz: axial stiffness of the pair."
    )


def torque_sections(result: SceneTorque, drawn: Sequence[Drawing] = ()) -> list[Section]:
    """All that is known of a torque beyond its headline;  drawn : its plot"""
    places, units = shown_places(result), SYSTEMS[result.scene.report.units]
    contacts = [ball_table(result, places, units), *cage_tables(cage_motion(result), result, places, units)]
    numerical, summary = result.verdicts.numerical, result.verdicts.summary
    return [
        Section("Parts of the torque", [*drawn, *_parts(result, places, units)]),
        Section("Contacts and cage", contacts),
        Section("Effects", [effects_of(result)]),
        Section("Inputs and methods", _inputs(result, units)),
        limits_section(result.verdicts.physical, numerical, result.notes, summary, units),
    ]


def torque_section(document: "Report", *, every: bool = True) -> Section:
    """The torque of a check, and what contacts of finite elements change in it; without blocks: there is none.

    every : operating point; else those that `torque_sections` shows
    """
    torque, change, units = document.solved, document.torque_change, document.units
    if torque is None or change is None:
        return Section(OF_CHECK, [])
    some = shown_places(torque)
    places = range(len(torque.points)) if every else some
    blocks = [*_parts(torque, places, units), ball_table(torque, some, units)]
    return Section(OF_CHECK, [*blocks, change_table(torque.points, change, places, units), Text(CHANGES, wide=True)])


def _parts(result: SceneTorque, places: Sequence[int], units: Units) -> list[Block]:
    """Parts and total, the bearings of a pair, the clearance, and the interval."""
    friction = result.friction
    return [
        torque_table(result, result.scene.bearing.name, places, units),
        *([] if friction.pair is None else [pair_table(friction.pair, places, units)]),
        *([] if friction.clearances is None else [Text(clearances_of(friction.clearances, units))]),
        *prediction_tables(result, places, units),
    ]


def _inputs(result: SceneTorque, units: Units) -> list[Block]:
    """The inputs that are not given as known, with where they come from, and the methods."""
    scene, friction = result.scene, result.friction
    stated = [each for each in result.inputs if each.status != "given"]
    blocks: list[Block] = []
    if stated:
        blocks.append(inputs_table("Printed, derived and assumed inputs", stated, units))
        if scene.assumed:
            sources = [f"{key}: {source}" for key, source in scene.assumed.items()]
            blocks.append(Bullets(sources, "Assumed in this scene:"))
    names = [name for name in METHODS if name != "cage" or friction.cage is not None]
    methods = [f"{name} by {friction.provenance[name]}".replace("_", " ") for name in names]
    source = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
    law = None if scene.lubricant is None else scene.lubricant.traction
    own = f" Law of traction: {law.origin}." if isinstance(law, OwnTraction) else ""
    return [*blocks, Text(f"Methods: {'; '.join(methods)}. Friction: {source}.{own}")]
