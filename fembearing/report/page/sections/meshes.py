"""What each mesh gave, and what they say together."""

from typing import Any

from fembearing.report.words import Shown, Told, capital, digits, place_of, quantities_of


def mesh_section(document: Told) -> dict[str, Any]:
    return {
        "meshes": [
            (
                capital(place_of(contact)),
                [_row(contact["convergence"][name], shown) for name, shown in quantities_of(contact).items()],
            )
            for contact in document["contacts"]
        ]
    }


def _row(part: Told, shown: Shown) -> dict[str, str]:
    limit, index = part["richardson"], part["grid_convergence_index"]
    return {
        "quantity": shown.heading(),
        "values": ", ".join(digits(value * shown.factor) for value in part["values"]),
        "order": "none" if part["order"] is None else f"{part['order']:.1f}",
        "index": "none" if index is None else f"{index:.2%}",
        "richardson": "" if limit is None else digits(limit * shown.factor),
        "mesh": f"{part['mesh']:.2%}",
        "domain": f"{part['domain']:.2%}",
    }
