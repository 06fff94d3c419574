"""What the contacts do to the torque at each operating point, and the cage where it moved."""

from collections.abc import Sequence
from itertools import groupby
from operator import itemgetter
from typing import Any

from fembearing.report.page.sections.scene import speeds
from fembearing.report.words import PER_MINUTE, Told, capital, digits, uncertainty_of


def torque_section(document: Told) -> dict[str, Any]:
    torque, change = document["torque"], document["torque_change"]
    if torque is None or change is None:
        return {"torque": [], "cage": [], "parts": [], "change": None}
    models = [point["uncertainty"]["model"] for point in torque["points"]]
    parts = _parts(torque["points"][0])
    rows = _rows(torque, change, parts)
    return {
        "torque": rows,
        "is_joined": len(rows) < len(torque["points"]),
        "parts": parts,
        "change": change,
        "band": torque["catalogue_band"]["low"] is not None,
        "catalogue_note": capital(torque["catalogue_band"]["note"]),
        "model_uncertainty": uncertainty_of(max((model for model in models if model is not None), default=None)),
        "cage": [_cage(point) for point in document["cage_motion"] or () if point["start"] is not None],
    }


def _parts(point: Told) -> list[str]:
    """Those that were computed; the race's is the total less what is declared and the cage's."""
    return [name for name, value in point["torque"].items() if value is not None and name != "race"]


def _rows(torque: Told, change: Told, parts: Sequence[str]) -> list[dict[str, Any]]:
    """One row for each operating point, points in a row that differ in speed alone together."""
    band = torque["catalogue_band"]
    rows = []
    for number, point in enumerate(torque["points"]):
        corrected = {key: change[key]["corrected"][number] for key in ("contact_angle", "torque")}
        rows.append(
            {
                "load": f"{point['axial_load']:.4g}",
                "angle": f"{point['contact_angle']:.4f}",
                "parts": [_digits(point["torque"][name]) for name in parts],
                "corrected_angle": _known(corrected["contact_angle"], ".4f"),
                "corrected": _digits(corrected["torque"]),
                "change": _known(change["change"]["total"][number], "+.2%"),
                "fitted": _known(change["finite_geometry"]["change"][number], "+.2%"),
                "catalogue": "-"
                if band["low"] is None
                else f"{band['low'][number] * 1e3:.3g}-{band['high'][number] * 1e3:.3g}",
            }
        )
    # At a constant coefficient slow speeds read the same: one row for each run of them.
    runs = [[number for number, _ in run] for _, run in groupby(enumerate(rows), key=itemgetter(1))]
    found = [point["inner_speed"] for point in torque["points"]]
    return [{**rows[run[0]], "speed": speeds([found[number] for number in run])} for run in runs]


def _known(value: float | None, form: str) -> str:
    return "-" if value is None else f"{value:{form}}"


def _digits(value: float | None) -> str:
    """Of N m, in N mm."""
    return "-" if value is None else digits(value * 1e3, 4)


def _cage(point: Told) -> dict[str, str]:
    """An operating point whose cage moved."""

    def between(ends: Sequence[float], factor: float = 1.0) -> str:
        return " to ".join(f"{factor * end:.3g}" for end in ends)

    other = point["other"]
    return {
        "speed": f"{point['inner_speed'] * PER_MINUTE:.5g}",
        "state": point["state"],
        "start": point["start"],
        "torque": f"{point['torque'] * 1e3:.3g}",
        "torque_interval": between(point["interval"]["torque"], 1e3),
        "moment": f"{point['signed_moment'] * 1e3:.2g}",
        "mean_force": f"{point['mean_force']:.3g}",
        "max_force": f"{point['max_force']:.3g}",
        "max_force_interval": between(point["interval"]["max_force"]),
        "watched": f"{point['duration']:.3g} s in blocks of {point['block']:.3g} s",
        "other": "the cage cannot whirl: one steady motion"
        if other is None
        else f"{other['state']} from {other['start']}, {other['torque'] * 1e3:.3g} N mm"
        + ("" if other["state"] == point["state"] else ": the start decides"),
    }
