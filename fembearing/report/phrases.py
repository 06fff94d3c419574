"""Titles, sentences and numbers as text, which terminal, page and figures share."""

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np

from analytic.columns import MODEL_PARTS, Point
from analytic.units import load_words
from analytic.units import speed_words as speed_words
from analytic.words import Unit, angle_of, percent_of, rounded
from fembearing.check.contact.scene_contact import place_of
from fembearing.quantities import CONTACT, METRIC, Quantity, Units

if TYPE_CHECKING:
    from analytic.prediction.prediction import Prediction
    from analytic.result import PairPart
    from analytic.scene import Clearances
    from analytic.scene_torque import SceneTorque
    from analytic.verdicts import NumericalCheck, PhysicalCheck
    from fembearing.check.contact.meshed_region import RingStructure
    from fembearing.check.contact.solution import ContactNumbers

AT_THE_CENTRE = CONTACT["peak_pressure"]._replace(name="pressure at y = 0")
PAIRS = {"O": "back to back (O)", "X": "face to face (X)", "tandem": "in tandem"}
NOTHING = 1e-8  # share of the torque that is printed as 0: 1e-6 %
CLEARANCES = ("unmounted", "mounted", "operating")
MADE_OF = {  # the parts of the 95 % interval
    "total": "all together",
    "numerical": "numerical alone",
    "input": "inputs alone",
    "model": "formulas alone",
    **{f"model.{name}": f"of them: {words}" for name, words in MODEL_PARTS.items()},
}
CHECKS = {  # the physical verdicts
    "peak_pressure": "peak pressure",
    "shoulder": "load cut off",
    "sliding": "sliding number",
    "gyroscopic_hold": "gyroscopic hold",
    "cage_force": "cage force",
    "tilt": "tilt of the inner ring",
    "replenishment": "starvation, -ln of the factor",
}
NO_TILT, NO_MOMENT = 1e-6, 1e-6  # rad and N m: less is rounding, or nobody's concern
LONGEST_LIST = 12  # values in a cell of a table
LOADS = ("axial_load", "radial_load", "moment")
MEASURED_RANGE = "35 % too low to 10 % too high"  # of validation/measured/measured.csv, which a test compares
MEASURED = f"Against the only measured torques, of three balls in oil, the torque is {MEASURED_RANGE}."
LEAST_EXPLAINED = 0.5  # share of the variance below which the shares of the inputs say nothing
AXES = "a along rolling (x), b transverse (y), load along z"


def quantities_of(contact: "ContactNumbers", units: Units = METRIC) -> dict[str, Quantity]:
    """The quantities of a contact; where a shoulder cuts it off, the pressure is largest there and not at y = 0."""
    named = CONTACT | {"peak_pressure": AT_THE_CENTRE} if contact.shoulder else CONTACT
    return {name: quantity.in_units(units) for name, quantity in named.items()}


def title_of(pair: str, geometry: str, contact_angle: float, load: str, bearing: str | None = None) -> str:
    """Place and load, for the head of a table or a picture."""
    angle = "" if pair == "pocket" else f" at {angle_of(contact_angle)}"
    return f"{capital(place_of(pair, geometry, bearing))}{angle}: {load}"


def contact_title(contact: "ContactNumbers", units: Units = METRIC) -> str:
    """Place and load of a contact, for the head of its table."""
    load = units.force.written(contact.load, ".4g")
    return title_of(contact.pair, contact.geometry, contact.contact_angle, load, contact.bearing)


def contact_place(contact: "ContactNumbers") -> str:
    """The place of a contact, as it begins a sentence."""
    return capital(place_of(contact.pair, contact.geometry, contact.bearing))


def ring_line(ring: "RingStructure", units: Units = METRIC) -> str:
    """What the ring adds to the approach, in one sentence."""
    return (
        f"Ring on a rigid seat: approach {units.small_length.written(ring.approach, '+.3g')} ({ring.share:+.1%} of "
        f"the contact's), +- {units.small_length.written(ring.uncertainty, '.1g')}: structure, not contact."
    )


def loads_of(point: Point, names: Sequence[str], units: Units = METRIC) -> str:
    """The loads of these names at an operating point, for example "1000 N axial, 50 N radial"."""
    return ", ".join(load_words(name, point[name], units) for name in names)


def tilt_of(torque: "SceneTorque", units: Units = METRIC) -> str:
    """How the inner ring of a single bearing is held or tilts, at most; empty: nothing tilts it."""
    ring = torque.friction.ring
    if ring is None:
        return ""
    holding = [] if ring.holding_moment is None else ring.holding_moment.tolist()
    tilts = [] if ring.displacement is None or ring.tilt is None else ring.tilt.tolist()
    tilt = max(tilts, key=abs, default=0.0)
    leans = f"{1e3 * abs(tilt):.3g} mrad" if abs(tilt) > NO_TILT else ""
    if not holding:
        return f"ring tilts by {leans}" if leans else ""
    moment = max(map(abs, holding))
    held = f"ring held at {leans}" if leans else "ring held straight"
    return f"{held} by {units.torque.written(moment, '.4g')}" if leans or moment > NO_MOMENT else ""


def varying_loads(points: Sequence[Point]) -> list[str]:
    """The names of the loads that differ between operating points."""
    return [name for name in LOADS if len({point[name] for point in points}) > 1]


def present_loads(points: Sequence[Point]) -> list[str]:
    """The axial load, and the names of the other loads that are not 0 at every operating point."""
    return [name for name in LOADS if name == "axial_load" or any(point[name] for point in points)]


def capital(words: str) -> str:
    """As at the beginning of a sentence; what follows the first letter is left as it is."""
    return words[:1].upper() + words[1:]


def digits(value: float | None, factor: float = 1.0, count: int = 5, *, absent: str = "-") -> str:
    """A value with its significant digits, zeros at the end included: numbers below each other are as exact."""
    return absent if value is None else f"{value * factor:#.{count}g}".removesuffix(".")


def shown(value: float | None, form: str, factor: float = 1.0, unit: str = "", *, absent: str = "-") -> str:
    """A value in the unit of a table, `factor` times the SI value."""
    return absent if value is None else f"{value * factor:{form}}{unit}"


def between(ends: Sequence[float] | None, unit: Unit) -> str:
    """Both ends of an interval, SI, in the unit of a table."""
    return "-" if ends is None else "-".join(rounded(unit.number(end), 3) for end in ends)


def percent(value: float | None) -> str:
    """A relative number in per cent; "unknown" where nothing is known of it."""
    if value is None or not np.isfinite(value):
        return "unknown"
    return percent_of(value, 2)


def angle_cell(radians: float | None) -> str:
    """An angle in a column of degrees, with radians beside."""
    return "-" if radians is None else f"{np.degrees(radians):z.2f} ({radians:z.4f})"


def listed(values: float | Sequence[float], factor: float = 1.0) -> str:
    """Distinct values in their order; a long series by its ends."""
    series = values if isinstance(values, Sequence) else [values]
    distinct = list(dict.fromkeys(f"{value * factor:.4g}" for value in series))
    if len(distinct) > LONGEST_LIST:
        return f"{distinct[0]} to {distinct[-1]}, {len(distinct)} values"
    return ", ".join(distinct)


def friction_of(*, coefficient: float | None, is_lubricated: bool) -> str:
    """Where the friction of ball on race comes from."""
    if coefficient is not None:
        return f"coefficient {coefficient:g} at each race, from the scene, without a lubrication model"
    if is_lubricated:
        return "coefficient of each race by mixed lubrication, from the scene's lubricant and surface"
    return "neither a coefficient nor both lubricant and surface in the scene: no torque"


def value_of(value: float | str | None, uncertainty: float | None, unit: str, units: Units = METRIC) -> str:
    """The value of an input with its unit and its standard deviation, as far as they are known."""
    if value is None:
        return "not known"
    if isinstance(value, str):
        return value
    shown = units.unit_for(unit, abs(value))
    if unit == "rad":
        return angle_of(value) + (f" +- {shown.written(uncertainty, '.2g')}" if uncertainty else "")
    number = f"{shown.number(value):.5g}"
    spread = f" +- {float(f'{uncertainty * shown.factor:.2g}'):g}" if uncertainty else ""  # 100, not 1e+02
    return f"{number}{spread} {shown.name}".strip()


def share_of(kind: str, share: float | None) -> str:
    """An effect's largest share of the total.

    kind : what the share is: of a part of its own, measured, an estimate, or unknown
    """
    if share is None:
        return "not known"
    seen = share if share > NOTHING else 0.0
    return f"{'about ' if kind == 'estimate' and seen else ''}{100 * seen:{'.0f' if share > 1 else '.3g'}} %"


def uncertainty_of(model: float | None, parts: Mapping[str, float]) -> str:
    """What is known of the model's uncertainty, at most of all operating points and relative, in a sentence.

    parts : of it, by the formula that is varied
    """
    if model is None:
        return f"Model uncertainty: not known without oil. {MEASURED}"
    named = ", ".join(f"{MODEL_PARTS[name]} {100 * part:.2g} %" for name, part in parts.items() if part > 0)
    return (
        f"Model uncertainty, 95 %: up to {100 * model:.2g} % of the total, by {named}. Not included: oil data "
        f"and inputs. {MEASURED}"
    )


def limit_of(value: float, unit: str, units: Units = METRIC) -> str:
    """A number of a physical verdict, SI, as it is shown: shares in per cent, those below 1e-6 as 0."""
    if unit == "rad":
        return f"{1e3 * value:.3g} mrad"
    return units.pressure.written(value, ".3g") if unit == "Pa" else percent_of(0.0 if abs(value) < 1e-6 else value)


def worst_of(check: "PhysicalCheck", units: Units = METRIC) -> str:
    """The number of a physical verdict."""
    if check.value is None:
        return "infinite" if check.verdict == "fail" else "unknown"
    return limit_of(check.value, check.unit, units)


def numerical_words(check: "NumericalCheck") -> str:
    """Whether the torque is solved within the tolerance, in a sentence."""
    words = f"Numerical: {check.verdict}, the uncertainty of the torque is {100 * check.uncertainty:.2g} %"
    return f"{words}, {'within' if check.verdict == 'pass' else 'beyond'} the tolerance {100 * check.tolerance:.3g} %."


def clearances_of(found: "Clearances", units: Units = METRIC) -> str:
    """How the bearing came to its clearance, in a sentence or two."""
    way = ", ".join(f"{units.small_length.written(getattr(found, name), '.3g')} {name}" for name in CLEARANCES)
    left = (
        "" if found.operating >= 0 else f"; every ball is preloaded with {units.force.written(found.ball_load, '.3g')}"
    )
    seats = [
        f"{name} seat "
        + (
            f"{units.small_length.written(tight, '.3g')} tight, {units.stress.written(pressure, '.3g')}"
            if tight > 0
            else "loose"
        )
        for name, tight, pressure in (
            ("shaft", found.shaft_interference, found.shaft_pressure),
            ("housing", found.housing_interference, found.housing_pressure),
        )
    ]
    return f"Clearance on the diameter: {way}{left}. In operation: {', '.join(seats)}."


def pair_of(pair: "PairPart", units: Units = METRIC) -> str:
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


def input_name(key: str) -> str:
    """The name of an uncertain input for narrow places: its key in words."""
    if key.startswith("model."):
        return MODEL_PARTS[key.partition(".")[2]]
    table, _, rest = key.partition(".")
    words = rest.replace(".", " ").replace("_", " ") or "numerical uncertainty"
    return f"{words} (cage)" if table == "cage" else words


def explained_words(prediction: "Prediction") -> str:
    """How far to trust the shares of the inputs, in a sentence."""
    explained = max(0.0, float(np.nanmin(prediction.explained)))
    known = f"The regression for the shares explains {100 * explained:.0f} % or more of the variance"
    if explained < LEAST_EXPLAINED:
        return f"{known}: the ranking of the inputs is not known; use more samples or smaller spreads."
    return f"{known}; the rest is attributed to no input and not included in the standard errors."


def interval_words(prediction: "Prediction") -> str:
    """How the interval was computed and what it does not include, in sentences."""
    return (
        f"95 % interval by {prediction.samples} Latin hypercube samples, seed {prediction.seed}, in "
        f"{prediction.seconds:.0f} s; the standard error of an end is at most "
        f"{100 * prediction.total.largest_error:.2g} %. "
        f"{prediction.failures} Spreads are mostly judgement; --json and the report give their sources. Not included: "
        f"{'; '.join(prediction.not_varied)}."
    ).replace("  ", " ")


def shoulder_lines(contact: "ContactNumbers", units: Units = METRIC) -> list[str]:
    """What a contact does at the shoulders that cut it off, a sentence each; none where it ends before them."""
    shoulder = contact.shoulder
    if shoulder is None:
        return []
    centroid, share, line = shoulder.centroid, shoulder.strip_share, shoulder.strip_line_load
    ends = [units.length.written(y, ".4g") for y in sorted(shoulder.cuts)]
    nearer = units.length.written(shoulder.cuts[0], ".4g")
    if len(ends) == 1:
        where, edge = f"Cut off at the shoulder, y = {ends[0]}, on one side", "the shoulder"
    else:
        where, edge = f"Cut off at both shoulders, y = {ends[0]} and y = {ends[1]}", f"the shoulder at y = {nearer}"
    half = (
        f": half of the contact is meshed; semi-axes about the centroid of the load, at y = "
        f"{units.length.written(centroid.reference, '.3g')} (+-{centroid.relative_uncertainty:.1%} of that)"
    )
    return [
        f"{where}{half if shoulder.half else ''}.",
        f"Edge load: the strip of {units.length.written(shoulder.strip_width, '.3g')} beside {edge} carries "
        f"{share.reference:.2%} of the load (+-{share.relative_uncertainty:.1%} of that), "
        f"{units.line_load.written(line.reference, '.4g')} or {line.reference / shoulder.hertz_line_load:.3g} times "
        "Hertz's greatest line load. The pressure shown is that at y = 0; the pressure at the edge is unbounded.",
    ]


def film_change_words(change: Sequence[float]) -> str:
    """What numerical films change in the torque;  change : at each operating point, relative."""
    ends = " to ".join(dict.fromkeys(f"{end:+.1%}" for end in (min(change), max(change))))
    return (
        f"With the numerical film and rolling force of the heaviest ball in all contacts the torque changes by {ends}. "
        "This is an estimate: lighter balls have other ratios."
    )


def creep_change_words(change: float) -> str:
    """What numerical friction changes in the torque;  change : at its operating point, relative."""
    return (
        f"With the numerical friction of the heaviest ball the torque at its operating point changes by {change:+.1%}."
    )
