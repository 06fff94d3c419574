"""The friction torque at each operating point, what finite-element contacts change, and the cage where it moved."""

from collections.abc import Sequence
from itertools import groupby
from operator import itemgetter
from typing import NamedTuple

from analytic.result import COORDINATES
from fembearing.quantities import NEWTON_MILLIMETRE, RPM
from fembearing.report.document.report import Report
from fembearing.report.document.torque import Point, Torque, TorqueChange
from fembearing.report.phrases import digits, interval_at, listed, present_loads, shown, uncertainty_of

NM = NEWTON_MILLIMETRE.factor


class Row(NamedTuple):
    """One row of a table over the operating points."""

    loads: tuple[str, ...]
    speed: str  # of all points that share the row
    cells: tuple[str, ...]


class TorqueSection(NamedTuple):
    """Tables and sentences of the section on the torque."""

    totals: list[Row]
    changes: list[Row]
    is_fitted: bool  # whether the correction by the fit has a column
    is_joined: bool  # whether points share a row
    load_heads: list[str]
    parts: list[str]
    change: TorqueChange
    model_uncertainty: str


def torque_section(document: Report) -> TorqueSection | None:
    """What the section shows; None without a torque."""
    torque, change = document.torque, document.torque_change
    if torque is None or change is None:
        return None
    points = torque.points
    parts = [name for name, value in points[0].torque if value is not None and name not in ("race", "total")]
    loads = present_loads(points)
    totals, changes = _joined(points, loads, _totals(torque, parts)), _joined(points, loads, _changes(change))
    return TorqueSection(
        totals=totals,
        changes=changes,
        is_fitted=change.finite_geometry is not None,
        is_joined=min(len(totals), len(changes)) < len(points),
        load_heads=[f"{COORDINATES[name].meaning}, {COORDINATES[name].unit}" for name in loads],
        parts=parts,
        change=change,
        model_uncertainty=uncertainty_of(
            max((point.uncertainty.model for point in points if point.uncertainty.model is not None), default=None),
            _largest_parts(points),
        ),
    )


def _largest_parts(points: Sequence[Point]) -> dict[str, float]:
    """Of the model's uncertainty, each at its worst operating point."""
    known = [point.uncertainty.model_parts or {} for point in points]
    names = dict.fromkeys(name for parts in known for name in parts)
    return {name: max(parts.get(name, 0.0) for parts in known) for name in names}


def _totals(torque: Torque, parts: Sequence[str]) -> list[tuple[str, ...]]:
    """Contact angle, parts, total, its numerical uncertainty, its interval and the catalogue band of each point."""
    band = torque.catalogue_band
    both = zip(band.low or (), band.high or (), strict=True)
    predicted = torque.prediction
    intervals = [()] * len(torque.points) if predicted is None else [(interval_at(p),) for p in predicted.points]
    bands = [(f"{low * NM:.3g}-{high * NM:.3g}",) for low, high in both] or [()] * len(torque.points)
    return [
        (
            f"{point.contact_angle:.4f}",
            *(digits(getattr(point.torque, name), NM, 4) for name in (*parts, "total")),
            shown(point.uncertainty.numerical, ".2%"),
            *interval,
            *sides,
        )
        for point, interval, sides in zip(torque.points, intervals, bands, strict=True)
    ]


def _changes(change: TorqueChange) -> list[tuple[str, ...]]:
    """Angle and total of the production and with contacts of finite elements, and the relative changes."""
    angles, totals, fitted = change.contact_angle, change.torque, change.finite_geometry
    columns = (angles.production, totals.production, angles.corrected, totals.corrected, change.change.total)
    fits = [()] * len(totals.production) if fitted is None else [(shown(value, "+.2%"),) for value in fitted.change]
    return [
        (
            *(f"{own_angle:.4f}", digits(own, NM, 4), shown(angle, ".4f"), digits(total, NM, 4)),
            *(shown(relative, "+.2%"), *fit),
        )
        for (own_angle, own, angle, total, relative), fit in zip(zip(*columns, strict=True), fits, strict=True)
    ]


def _joined(points: Sequence[Point], loads: Sequence[str], cells: Sequence[tuple[str, ...]]) -> list[Row]:
    """One row for each point; neighbours that differ in speed alone share one."""
    keys = [
        (tuple(f"{getattr(point, name):.4g}" for name in loads), row) for point, row in zip(points, cells, strict=True)
    ]
    runs = groupby(zip(keys, points, strict=True), key=itemgetter(0))
    return [
        Row(loads=key[0], speed=listed([point.inner_speed for _, point in run], RPM.factor), cells=key[1])
        for key, run in runs
    ]
