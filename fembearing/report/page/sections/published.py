"""The paper's numbers next to the scene's, calibration apart from prediction."""

from typing import Any

from fembearing.quantities import PER_MINUTE
from fembearing.report.document.report import Printed, Report
from fembearing.report.phrases import capital

UNITS = {"torque": ("N mm", 1e3), "force": ("N", 1.0)}


def published_section(document: Report) -> dict[str, Any]:
    """Table and sentences of the section on published numbers."""
    published = document.published
    return {
        "published": published,
        "printed": [_row(row) for row in published.rows],
        "chosen": [f"{name} {each.value:.4g} {each.unit}".strip() for name, each in published.chosen.items()],
    }


def _row(row: Printed) -> dict[str, str]:
    unit, factor = UNITS[row.quantity.rpartition("_")[2]]
    return {
        "quantity": capital(f"{row.quantity.replace('_', ' ')}, {unit}"),
        "roughness": f"{row.rms_roughness * 1e6:g}",
        "speed": f"{row.inner_speed * PER_MINUTE:.4g}",
        "paper": f"{'about ' if row.note == 'about' else ''}{row.value * factor:.4g}",
        "ours": "-" if row.ours is None else f"{row.ours * factor:.4g}",
        "deviation": "-" if row.deviation is None else f"{row.deviation:+.1%}",
    }
