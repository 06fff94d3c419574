"""The friction torque at each operating point, and what finite-element contacts change in it."""

from collections.abc import Sequence
from typing import NamedTuple

from analytic.result import TorquePoint
from fembearing.quantities import Units
from fembearing.report.page.sections.points import parts_of, point_cells, point_heads
from fembearing.report.phrases import (
    angle_cell,
    capital,
    digits,
    interval_at,
    interval_words,
    percent,
    shown,
    uncertainty_of,
)
from fembearing.report.report import ChangeRecord, Report
from fembearing.report.tables.table import Head, Table, table_of
from fembearing.report.torque import TorqueRecord

SIGNED = "+.2f"  # of a change in per cent


class TorqueSection(NamedTuple):
    """Tables and sentences of the section on the torque."""

    totals: Table
    changes: Table
    change: ChangeRecord
    notes: list[str]
    friction: Table | None  # of one point, which no figure shows


def torque_section(document: Report) -> TorqueSection | None:
    """What the section shows; None without a torque."""
    torque, change = document.torque, document.torque_change
    if torque is None or change is None:
        return None
    model = [point.uncertainty.model for point in torque.points if point.uncertainty.model is not None]
    notes = [
        f"{capital(torque.catalogue_band.note)}.",
        uncertainty_of(max(model, default=None), _largest_parts(torque.points)),
    ]
    if torque.prediction is not None:
        notes.append(interval_words(torque.prediction))
    friction = _friction(torque, document.units) if len(torque.points) == 1 else None
    return TorqueSection(
        totals=_totals(torque, document.units),
        changes=_changes(torque.points, change, document.units),
        change=change,
        notes=notes,
        friction=friction,
    )


def _largest_parts(points: Sequence[TorquePoint]) -> dict[str, float]:
    """Of the model's uncertainty, each at its worst operating point."""
    known = [point.uncertainty.model_parts or {} for point in points]
    names = dict.fromkeys(name for parts in known for name in parts)
    return {name: max(parts.get(name, 0.0) for parts in known) for name in names}


def _totals(torque: TorqueRecord, units: Units) -> Table:
    """Contact angle, parts, total, its numerical uncertainty, its interval and the catalogue band of each point."""
    points, parts, predicted = torque.points, parts_of(torque.points), torque.prediction
    low, high = torque.catalogue_band.low, torque.catalogue_band.high
    heads = [
        *point_heads(points, units),
        Head("contact angle, deg (rad)"),
        *(Head(name) for name in parts),
        Head("total"),
    ]
    heads += [Head("\N{PLUS-MINUS SIGN}"), *([] if predicted is None else [Head("95 %")])]
    heads += [] if low is None else [Head("catalogue band")]
    rows = [
        [
            *point_cells(points, index, units),
            angle_cell(point.contact_angle),
            *(digits(getattr(point.torque, name), units.torque.factor, 4) for name in (*parts, "total")),
            percent(point.uncertainty.numerical),
            *(() if predicted is None else (interval_at(predicted.points[index], units),)),
            *(
                ()
                if low is None or high is None
                else (f"{units.torque.number(low[index]):.3g}-{units.torque.number(high[index]):.3g}",)
            ),
        ]
        for index, point in enumerate(points)
    ]
    return table_of("friction torque at every operating point", heads, rows)


def _friction(torque: TorqueRecord, units: Units) -> Table | None:
    """Friction, film and asperities of the heaviest ball at the only point; None where nothing slides."""
    (point,) = torque.points
    small, gap = units.small_length, torque.gap_roughness
    rows = []
    for name in ("inner", "outer", "pocket"):
        coefficient = getattr(point.friction_coefficient, name)
        if coefficient is None:
            continue
        film, share = (getattr(group, name, None) for group in (point.film, point.asperity_share))
        ratio = film / gap if film is not None and gap else None
        rows.append(
            [
                "cage pocket" if name == "pocket" else f"{name} race",
                f"{coefficient:.4g}",
                digits(film, small.factor, 3),
                digits(ratio, 1.0, 3),
                "-" if share is None else percent(share),
            ]
        )
    heads = [Head("contact", "name"), *map(Head, ("friction coefficient", f"film, {small.name}"))]
    heads += [Head("film over roughness"), Head("load on asperities")]
    return table_of("friction, film and asperities", heads, rows) if rows else None


def _changes(points: Sequence[TorquePoint], change: ChangeRecord, units: Units) -> Table:
    """Angle and total of the production and with contacts of finite elements, and the relative changes."""
    angles, totals, fitted = change.contact_angle, change.torque, change.finite_geometry
    heads = [
        *point_heads(points, units),
        Head("production: angle, deg (rad)"),
        Head("production: torque"),
        Head("contacts of finite elements: angle, deg (rad)"),
        Head("contacts of finite elements: torque"),
        Head("change, %"),
        *([] if fitted is None else [Head("change by the fit, %")]),
    ]
    rows = [
        [
            *point_cells(points, index, units),
            angle_cell(angles.production[index]),
            digits(totals.production[index], units.torque.factor, 4),
            angle_cell(angles.corrected[index]),
            digits(totals.corrected[index], units.torque.factor, 4),
            shown(change.change.total[index], SIGNED, 100),
            *([] if fitted is None else [shown(fitted.change[index], SIGNED, 100)]),
        ]
        for index in range(len(points))
    ]
    return table_of("what contacts of finite elements change", heads, rows)
