"""Each contact's quantities by Hertz and by finite elements, and whether the difference counts."""

from typing import Any

from fembearing.report.words import (
    AXES,
    QUANTITIES,
    Shown,
    Told,
    capital,
    digits,
    place_of,
    quantities_of,
    ring_line,
    shoulder_lines,
    title_of,
)


def verdict_section(document: Told) -> dict[str, Any]:
    contacts = document["contacts"]
    judged = [contact for contact in contacts if contact["judged"]]
    return {
        "axes": AXES,
        "verdicts": [(title_of(contact), _rows(document, contact)) for contact in judged],
        "comparisons": [(capital(place_of(contact)), _resolved(document, contact)) for contact in judged],
        "uncertainties": document["uncertainties"],
        "shoulders": [(capital(place_of(contact)), line) for contact in contacts for line in shoulder_lines(contact)],
        "rings": [(capital(place_of(contact)), ring_line(contact["ring"])) for contact in contacts if contact["ring"]],
        "pocket": _pocket(contacts),
        "pocket_load": f"{contacts[-1]['load']:g}",
        "interpolated": any(contact["corrected"] for contact in judged),
    }


def verdicts_of(document: Told, contact: Told) -> dict[str, Told]:
    """The verdicts on one contact, by quantity."""
    place = contact["pair"], contact["geometry"]
    return {row["quantity"]: row for row in document["verdicts"] if (row["pair"], row["geometry"]) == place}


def _rows(document: Told, contact: Told) -> list[dict[str, Any]]:
    rows = verdicts_of(document, contact)
    return [
        {
            "quantity": shown.heading(),
            "production": digits(rows[name]["production"] * shown.factor),
            "reference": digits(rows[name]["reference"] * shown.factor),
            "discrepancy": f"{rows[name]['discrepancy']:+.2%}",
            "uncertainty": f"{_relative(rows[name]):.2%}",
            "resolved": "yes" if rows[name]["comparison"]["resolved"] else "no",
            "verdict": rows[name]["verdict"],
            **_corrected(contact, name, shown),
        }
        for name, shown in quantities_of(contact).items()
    ]


def _relative(row: Told) -> float:
    """u_val over the reference."""
    return row["comparison"]["total"] / abs(row["reference"])


def _corrected(contact: Told, name: str, shown: Shown) -> dict[str, str]:
    """Hertz corrected for finite geometry, and its interpolation error."""
    corrected = contact["corrected"]
    if not corrected:
        return {"corrected": "-", "interpolation": "-"}
    value = corrected["values"][name] * shown.factor
    return {"corrected": digits(value), "interpolation": f"{corrected['interpolation_error'][name]:+.2%}"}


def _resolved(document: Told, contact: Told) -> list[str]:
    """In sentences, what |E| against u_val says of Hertz in one contact."""
    rows, names = verdicts_of(document, contact), quantities_of(contact)
    parts: dict[bool, list[str]] = {True: [], False: []}
    for name, shown in names.items():
        error, u_val = rows[name]["discrepancy"], _relative(rows[name])
        parts[rows[name]["comparison"]["resolved"]].append(f"{shown.name} {error:+.2%} +- {u_val:.2%}")
    found = []
    if parts[True]:
        found.append(f"|E| > u_val: the difference is resolved, and is Hertz's error: {', '.join(parts[True])}.")
    if parts[False]:
        found.append(
            f"|E| <= u_val: the difference is not resolved, Hertz's error is somewhere in {', '.join(parts[False])}."
        )
    return found


def _pocket(contacts: list[Told]) -> list[dict[str, Any]]:
    """K_pb by each model, and the approach at the load; empty without a cage."""
    if len(contacts) < 4:
        return []
    seat, sheet = contacts[2:]
    formula = seat["hertz"]
    rows = [("Hertz: two half spaces", formula, None)]
    rows += [(place_of(found), found["fe"], found["uncertainty"]["stiffness"]) for found in (seat, sheet)]
    return [
        {
            "model": model,
            "stiffness": digits(found["stiffness"] * QUANTITIES["stiffness"].factor, 4),
            "uncertainty": "" if uncertainty is None else f"{uncertainty:.2%}",
            "approach": digits(found["approach"] * QUANTITIES["approach"].factor, 4),
            "change": f"{found['stiffness'] / formula['stiffness'] - 1:+.1%}",
        }
        for model, found, uncertainty in rows
    ]
