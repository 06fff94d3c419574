"""How results are named to a reader: quantities with their units, contacts with their place.

Everything is read off the JSON of a result, so that a page made from a file says the same as a terminal did.
"""

from itertools import groupby
from operator import attrgetter
from typing import Any, NamedTuple

import numpy as np
from rich.box import SIMPLE_HEAD

from analytic.oil.film import FORMULA_UNCERTAINTY
from fembearing.compare.cost.ladder import Ladder

Told = dict[str, Any]  # a result as its to_json tells it, SI


class Shown(NamedTuple):
    """A quantity as it is printed: its name, its unit, and what an SI value is multiplied by."""

    name: str
    unit: str
    factor: float

    def heading(self) -> str:
        return f"{self.name}, {self.unit}"


QUANTITIES = {
    "approach": Shown("approach", "um", 1e6),
    "semi_axis_rolling": Shown("semi-axis a", "mm", 1e3),
    "semi_axis_transverse": Shown("semi-axis b", "mm", 1e3),
    "peak_pressure": Shown("peak pressure", "GPa", 1e-9),
    "stiffness": Shown("stiffness", "GN/m^1.5", 1e-9),
}
AT_THE_CENTRE = QUANTITIES["peak_pressure"]._replace(name="pressure at y = 0")
STRESSES = {
    "max_shear": Shown("shear", "GPa", 1e-9),
    "max_shear_depth": Shown("its depth", "um", 1e6),
    "max_von_mises": Shown("von Mises", "GPa", 1e-9),
    "max_von_mises_depth": Shown("its depth", "um", 1e6),
}
PER_MINUTE = 30 / np.pi  # rpm in one rad/s
PLAIN: dict[str, Any] = {  # a table of a terminal
    "title_justify": "left",
    "box": SIMPLE_HEAD,
    "padding": (0, 1, 0, 0),
    "pad_edge": False,
    "show_edge": False,
}
SHARES = (
    "Share: of the total, the largest of all operating points; with <= no part of its own but a bound, on what leaving "
    "the effect out would change. What the scene says off is left out on purpose: no uncertainty of the torque counts "
    "it."
)
AXES = "a along rolling (x), b transverse (y), load along z"


def quantities_of(contact: Told) -> dict[str, Shown]:
    """`QUANTITIES`, where a shoulder cuts the contact off with another word: the pressure is largest at its edge."""
    return QUANTITIES | {"peak_pressure": AT_THE_CENTRE} if contact["shoulder"] else QUANTITIES


def place_of(contact: Told) -> str:
    """Where the ball sits, for example "ball on inner race"; of a contact or of a series of loads."""
    if contact["pair"] == "pocket":
        return "ball in cage pocket, " + ("sheet on its rim" if contact["geometry"] == "wall" else "thick seat")
    ideal = ", idealised" if contact["geometry"] == "hertzian" else ""
    return f"ball on {contact['pair']} race{ideal}"


def ring_line(ring: Told) -> str:
    """What the ring adds to the approach, in one sentence."""
    return (
        f"Ring on a rigid seat: approach {ring['approach'] * 1e6:+.3f} um ({ring['share']:+.1%} of the contact's), "
        f"+- {ring['uncertainty'] * 1e6:.3f} um: structure, not contact."
    )


def title_of(contact: Told) -> str:
    """Place and load, or of a series the number of loads, for the head of a table or a picture."""
    angle = "" if contact["pair"] == "pocket" else f" at {contact['contact_angle']:.4f} rad"
    load = f"{len(contact['loads'])} loads" if "loads" in contact else f"{contact['load']:.4g} N"
    return f"{capital(place_of(contact))}{angle}: {load}"


def capital(words: str) -> str:
    """As at the beginning of a sentence; what follows the first letter is left as it is."""
    return words[:1].upper() + words[1:]


def digits(value: float, count: int = 5) -> str:
    """A value with its significant digits, zeros at the end included: numbers below each other are as exact."""
    return f"{value:#.{count}g}".removesuffix(".")


def friction_of(*, coefficient: float | None, is_lubricated: bool) -> str:
    """Where the friction of ball on race comes from."""
    if coefficient is not None:
        return f"coefficient {coefficient:g} at each race, given by the scene and by no lubrication model"
    if is_lubricated:
        return "coefficient of each race by mixed lubrication, from the scene's lubricant and surface"
    return "neither a coefficient nor both lubricant and surface in the scene: no torque"


def share_of(effect: Told) -> str:
    """An effect's largest share of the total; a bound says so."""
    kind, share = effect["share_is"], effect["share"]
    if kind in ("unknown", "unbounded"):
        return "not known" if kind == "unknown" else "no bound"
    return f"{'' if kind == 'part' else '<= '}{100 * share:{'.0f' if share > 1 else '.3g'}} %"


def uncertainty_of(model: float | None) -> str:
    """What is known of the model's uncertainty, at most of all operating points and relative, in a sentence."""
    if model is None:
        return "Model uncertainty: not known, as no film is computed, and no measurement was found."
    return (
        f"Model uncertainty: the film formula's, {200 * FORMULA_UNCERTAINTY:.0f} % of the film, moves the total by up "
        f"to {100 * model:.2g} %; what else the model leaves is not known, as no "
        "measured torque of such a bearing was found."
    )


def short_name(rung: str) -> str:
    """A rung's name where there is little room."""
    return rung.replace("finite elements, ", "FE, ").replace("corrected for finite geometry", "corrected")


def choices_line(ladder: Ladder) -> str:
    """Which rung each of some tolerances takes, and by how much the next digit is dearer."""
    parts = []
    for rung, run in groupby(ladder.choices, key=attrgetter("method")):
        choices = list(run)
        digits = ", ".join(f"{100 * choice.tolerance:g}" for choice in choices)
        taken = "none" if rung is None else f"{short_name(rung.name)}, {rung.seconds:.2g} s"
        price = choices[0].price
        parts.append(f"{digits} %: {taken}" + ("" if price is None else f", {price:.2g} times as much"))
    return "; ".join(parts)


def shoulder_lines(contact: Told) -> list[str]:
    """What a contact cut off at a shoulder does there, a sentence each; none where it ends before."""
    shoulder = contact["shoulder"]
    if not shoulder:
        return []
    centroid, share, line = (shoulder[name] for name in ("centroid", "strip_share", "strip_line_load"))
    ends = [f"{y * 1e3:.4g} mm" for y in sorted(-y if side == "below" else y for side, y in shoulder["sides"].items())]
    found = []
    if len(ends) == 1:
        where, beside = f"Cut off at the shoulder, y = {ends[0]}, on one side", "the shoulder"
    else:
        where, beside = f"Cut off at both shoulders, y = {ends[0]} and y = {ends[1]}", f"the shoulder at y = {ends[1]}"
    if shoulder["half"]:
        found.append(
            f"{where}: half of the contact is meshed, semi-axes are about the load's centroid, at y = "
            f"{centroid['fe'] * 1e3:.3g} mm (+-{centroid['uncertainty']:.1%} of that)."
        )
    else:
        found.append(f"{where}.")
    times = line["fe"] / shoulder["hertz_line_load"]
    found.append(
        f"Edge load: the strip of {shoulder['strip_width'] * 1e3:.3g} mm beside {beside} carries {share['fe']:.2%} of "
        f"the load (+-{share['uncertainty']:.1%} of that), {line['fe'] * 1e-3:.4g} N/mm or {times:.3g} times Hertz's "
        "greatest line load. The pressure shown is that at y = 0, not at the edge, where it has no bound."
    )
    return found
