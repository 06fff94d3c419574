"""The friction torque at each operating point, what finite-element contacts change, and the cage where it moved."""

from collections.abc import Sequence
from itertools import groupby
from operator import itemgetter
from typing import Any

from analytic.result import COORDINATES
from fembearing.quantities import PER_MINUTE
from fembearing.report.document.report import Report
from fembearing.report.document.torque import MovedCage, Point, Torque, TorqueChange
from fembearing.report.page.sections.scene import speeds
from fembearing.report.phrases import capital, digits, present_loads, uncertainty_of

NM = 1e3  # N mm in one N m


def torque_section(document: Report) -> dict[str, Any]:
    """Tables and sentences of the section on the torque."""
    torque, change = document.torque, document.torque_change
    if torque is None or change is None:
        return {"torque": None, "cage": []}
    points = torque.points
    parts = [name for name, value in points[0].torque if value is not None and name not in ("race", "total")]
    loads = present_loads(points)
    totals, changes = _joined(points, loads, _totals(torque, parts)), _joined(points, loads, _changes(change))
    return {
        "torque": totals,
        "changes": changes,
        "is_joined": min(len(totals), len(changes)) < len(points),
        "load_heads": [f"{COORDINATES[name].meaning}, {COORDINATES[name].unit}" for name in loads],
        "parts": parts,
        "change": change,
        "band": torque.catalogue_band.low is not None,
        "catalogue_note": capital(torque.catalogue_band.note),
        "model_uncertainty": uncertainty_of(
            max((point.uncertainty.model for point in points if point.uncertainty.model is not None), default=None)
        ),
        "cage": [_cage(each) for each in document.cage_motion or () if isinstance(each, MovedCage)],
    }


def _totals(torque: Torque, parts: Sequence[str]) -> list[tuple[str, ...]]:
    """Contact angle, parts, total, its numerical uncertainty and the catalogue band of each point."""
    band = torque.catalogue_band
    sides = zip(band.low or (), band.high or (), strict=True)
    bands = [(f"{low * NM:.3g}-{high * NM:.3g}",) for low, high in sides] or [()] * len(torque.points)
    return [
        (
            f"{point.contact_angle:.4f}",
            *(_digits(getattr(point.torque, name)) for name in (*parts, "total")),
            _known(point.uncertainty.numerical, ".2%"),
            *shown,
        )
        for point, shown in zip(torque.points, bands, strict=True)
    ]


def _changes(change: TorqueChange) -> list[tuple[str, ...]]:
    """Angle and total with Hertz's contacts and with those of finite elements, and both relative changes."""
    angles, totals = change.contact_angle, change.torque
    columns = (angles.hertz, totals.hertz, angles.corrected, totals.corrected)
    return [
        (
            *(f"{hertz_angle:.4f}", _digits(hertz), _known(angle, ".4f"), _digits(total)),
            *(_known(relative, "+.2%"), _known(fitted, "+.2%")),
        )
        for hertz_angle, hertz, angle, total, relative, fitted in zip(
            *columns, change.change.total, change.finite_geometry.change, strict=True
        )
    ]


def _joined(points: Sequence[Point], loads: Sequence[str], cells: Sequence[tuple[str, ...]]) -> list[dict[str, Any]]:
    """One row for each point; neighbours that differ in speed alone share one."""
    keys = [
        (tuple(f"{getattr(point, name):.4g}" for name in loads), row) for point, row in zip(points, cells, strict=True)
    ]
    runs = groupby(zip(keys, points, strict=True), key=itemgetter(0))
    return [
        {"loads": key[0], "speed": speeds([point.inner_speed for _, point in run]), "cells": key[1]}
        for key, run in runs
    ]


def _known(value: float | None, form: str) -> str:
    return "-" if value is None else f"{value:{form}}"


def _digits(value: float | None) -> str:
    """A torque in N mm."""
    return "-" if value is None else digits(value * NM, 4)


def _cage(point: MovedCage) -> dict[str, str]:
    """An operating point whose cage moved."""

    def between(ends: Sequence[float], factor: float = 1.0) -> str:
        return " to ".join(f"{factor * end:.3g}" for end in ends)

    other = point.other
    return {
        "speed": f"{point.inner_speed * PER_MINUTE:.5g}",
        "state": point.state,
        "start": point.start,
        "torque": f"{point.torque * NM:.3g}",
        "torque_interval": between(point.interval.torque, NM),
        "moment": f"{point.signed_moment * NM:.2g}",
        "mean_force": f"{point.mean_force:.3g}",
        "max_force": f"{point.max_force:.3g}",
        "max_force_interval": between(point.interval.max_force),
        "duration": f"{point.duration:.3g} s in blocks of {point.block:.3g} s",
        "other": "the cage cannot whirl: one steady motion"
        if other is None
        else f"{other.state} from {other.start}, {other.torque * NM:.3g} N mm"
        + ("" if other.state == point.state else ": the start decides"),
    }
