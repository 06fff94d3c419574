"""The paper's numbers beside the scene's, calibration apart from prediction."""

from typing import Any

from fembearing.report.words import PER_MINUTE, Told, capital

UNITS = {"torque": ("N mm", 1e3), "force": ("N", 1.0)}


def published_section(document: Told) -> dict[str, Any]:
    published = document["published"]
    return {
        "published": published,
        "printed": [_row(row) for row in published["rows"]],
        "chosen": [
            f"{name} {value['value']:.4g} {value['unit']}".strip() for name, value in published["chosen"].items()
        ],
    }


def _row(row: Told) -> dict[str, str]:
    unit, factor = UNITS[row["quantity"].rpartition("_")[2]]
    return {
        "quantity": capital(f"{row['quantity'].replace('_', ' ')}, {unit}"),
        "roughness": f"{row['rms_roughness'] * 1e6:g}",
        "speed": f"{row['inner_speed'] * PER_MINUTE:.4g}",
        "paper": f"{'about ' if row['note'] == 'about' else ''}{row['value'] * factor:.4g}",
        "ours": "-" if row["ours"] is None else f"{row['ours'] * factor:.4g}",
        "deviation": "-" if row["deviation"] is None else f"{row['deviation']:+.1%}",
    }
