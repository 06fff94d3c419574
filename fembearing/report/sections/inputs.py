"""What was computed: bearing, oil, surfaces and materials, which effects count, and where the inputs come from."""

from collections.abc import Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np

from analytic.columns import COLUMNS
from analytic.effects import Effect
from analytic.scene import Array, Cage, Clearances, Groove, Material, OwnTraction, Scene, Surface
from analytic.scene_torque import SceneTorque
from analytic.scenefile.inputs import StatedInput
from analytic.units import METRIC, Units
from analytic.words import angle_of
from fembearing.report.document import Facts, Head, Section, Table, Text, table_of
from fembearing.report.phrases import listed
from fembearing.report.sections.points import LOADS

NO_TILT = 1e-6  # rad: less is rounding, or nobody's concern
NO_MOMENT = 1e-6  # N m: the same

if TYPE_CHECKING:  # a torque alone needs no solver, which the report of a check loads
    from fembearing.report.report import Report

Named = list[tuple[str, str]]
CLEARANCES = ("unmounted", "mounted", "operating")
PAIRS = {"O": "back to back (O)", "X": "face to face (X)", "tandem": "in tandem"}
NOTHING = 1e-8  # share of the torque that is printed as 0: 1e-6 %

EFFECTS = (Head("effect", "name"), Head("", "name"), Head("share", fixed=True), Head("reason", "text"))
SHARES = (
    "Share: of the total, the largest of all operating points where the effect has a part of the torque; else the "
    "change of the torque without it"
)
ORIGINS = (
    "Given: in the scene. Printed: in a catalogue or a paper. Derived: computed from printed values. Assumed: no "
    "printed source. +-: one standard deviation."
)
INPUTS = (Head("input", "name"), Head("value", "name"), Head("status", "name"), Head("source", "text", wide=True))


def effects_table(effects: Iterable[Effect], points: Sequence[int] = ()) -> Table:
    """Each effect with its decision, share and reason; points : at which shares are measured, from 0"""
    rows = [[each.name, each.decision, share_of(each.share_is, each.share), each.reason] for each in effects]
    at = ", ".join(str(1 + point) for point in points)
    where = f", at operating point{'s' if len(points) > 1 else ''} {at}" if points else ""
    return table_of("Effects", EFFECTS, rows, [f"{SHARES}{where}. About: estimated, not computed."])


def inputs_table(label: str, inputs: Iterable[StatedInput], units: Units = METRIC) -> Table:
    """Each input with its value and its origin."""
    rows = [
        [each.key, value_of(each.value, each.uncertainty, each.unit, units), each.status, each.source]
        for each in inputs
    ]
    return table_of(label, INPUTS, rows, [ORIGINS])


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


def effects_of(result: SceneTorque) -> Table:
    """The effects of a torque."""
    effects = result.friction.effects
    return effects_table(effects, effects.among(result.places.computed).points)


def inputs_section(document: "Report") -> Section:
    """Grooves, materials and seats, where the inputs come from, and which effects count."""
    torque, units = document.solved, document.units
    if torque is None:
        return Section("Inputs and effects", [Facts(details_of(document))])
    named = [inputs_table("Sources of the inputs", torque.inputs, units)] if torque.inputs else []
    metric = [] if units is METRIC else [Text("Reasons and warnings are in metric units.", wide=True, quiet=True)]
    return Section("Inputs and effects", [Facts(details_of(document)), *named, effects_of(torque), *metric])


def friction_of(*, coefficient: float | None, is_lubricated: bool) -> str:
    """Where the friction of ball on race comes from."""
    if coefficient is not None:
        return f"coefficient {coefficient:g} at each race, from the scene, without a lubrication model"
    if is_lubricated:
        return "coefficient of each race by mixed lubrication, from the scene's lubricant and surface"
    return "neither a coefficient nor both lubricant and surface in the scene: no torque"


def clearances_of(found: Clearances, units: Units = METRIC) -> str:
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


def facts_of(document: "Report") -> Named:
    """Name and words of what defines the torque, for the summary."""
    scene = document.scene
    facts = list(_facts(scene, document.units))
    pair = None if document.solved is None else document.solved.friction.pair
    if pair is not None:
        held = pair.equilibrium.preload
        preload = f", preload {document.units.force.written(held, '.4g')}" if held else ""
        facts.insert(1, ("arrangement", f"two such bearings, {PAIRS[pair.kind]}{preload}"))
    if document.solved is None:
        return [*facts, ("operation", _operation(scene, document.units))]
    return [*facts, *_parts(document.solved, document.units)]


def details_of(document: "Report") -> Named:
    """The same of grooves, materials and seats, for an appendix."""
    scene, torque, units = document.scene, document.torque, document.units
    bearing = scene.bearing
    details = [
        (f"{race} groove", _groove(groove, bearing.ball_diameter, units))
        for race, groove in (("inner", bearing.inner), ("outer", bearing.outer))
    ]
    details += [
        (
            each.name,
            f"E {units.pressure.written(each.youngs_modulus, '.4g')}, nu {each.poisson_ratio:.3g}; {each.source}",
        )
        for each in _materials(scene)
    ]
    if torque is not None and torque.clearances is not None:
        details.append(("seats", clearances_of(torque.clearances, units)))
    details.append(("spin of balls", f"rule: {scene.spin_rule.replace('_', ' ')}"))
    chosen = scene.calibration or "no calibrated inputs"
    return [*details, ("calibration", chosen)]


def _facts(scene: Scene, units: Units) -> Iterator[tuple[str, str]]:
    bearing, angle = scene.bearing, scene.contact_angle
    pitch = bearing.inner.bottom_radius + bearing.outer.bottom_radius
    gap = 2 * (bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter)
    clearance = (
        f", diametral clearance {units.small_length.written(gap, '.3g')}" if bearing.kind == "radial" else ""
    )  # washers: none
    diameter, material = units.length.written(bearing.ball_diameter, ".5g"), bearing.ball_material.name
    yield (
        "bearing",
        f"{bearing.name}: {bearing.ball_count} balls of {diameter} ({material}), pitch diameter "
        f"{units.length.written(pitch, '.5g')}{clearance}",
    )
    if angle.value is not None:
        yield "contact angle", f"given, {angle_of(angle.value)}"
    else:
        free = "that of the clearance" if angle.free is None else angle_of(angle.free)
        yield "contact angle", f"solved from the load; unloaded: {free}"
    if scene.lubricant is not None:
        oil = scene.lubricant
        named = f"{oil.name} " if oil.name else ""
        stress = "following the pressure"
        if oil.eyring_stress is not None:
            stress = units.stress.written(oil.eyring_stress, ".3g")
        yield (
            "lubricant",
            f"{named}at {units.temperature.written(oil.temperature, '.4g')}; {oil.viscosity:.3g} Pa s at "
            f"{units.temperature.written(oil.reference_temperature, '.4g')}, pressure-viscosity "
            f"{units.per_pressure.written(oil.pressure_viscosity, '.3g')}, Eyring stress {stress}"
            f"{_own_law(oil.traction)}",
        )
    if scene.surface is not None:
        yield "surfaces", _surface(scene.surface, units)
    yield (
        "cage",
        "none in the scene: neither pocket contact nor torque" if scene.cage is None else _cage(scene.cage, units),
    )
    yield "friction", friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)


def _parts(torque: SceneTorque, units: Units) -> Named:
    """What cage and seals add to the torque, and how the ring stands: each named, also where there is none."""
    scene, tilt = torque.scene, tilt_of(torque, units)
    cage = [part for point in torque.points if (part := point["torque_cage"]) is not None]
    seals, drag = scene.bearing.seals or "none named", scene.losses.seals
    if drag is not None:
        seals = f"{seals}; {units.torque.written(drag, '.4g')} of the torque"
    elif scene.bearing.seals_rub:
        seals = f"{seals}; their drag is not in the torque: give losses.seals"
    facts = [("seals", seals)]
    if torque.friction.pair is None:
        facts.append(("tilt of the ring", tilt or "none"))
    if cage:
        ends = " to ".join(dict.fromkeys(units.torque.written(end, ".4g") for end in (min(cage), max(cage))))
        facts.append(("torque of the cage", ends))
    elif scene.cage is not None:
        facts.append(("torque of the cage", "not in the total"))
    return facts


def _own_law(law: str | OwnTraction) -> str:
    """Name, package and digest of a user's law of traction."""
    if isinstance(law, str):
        return ""
    package = f" of {law.distribution} {law.version}" if law.distribution else ""
    return f", own law of traction {law.name}{package}, SHA-256 {law.sha256[:12]}"


def _operation(scene: Scene, units: Units) -> str:
    """Loads and speeds, where no torque has them."""
    given = scene.operation
    words = []
    for name in LOADS:
        unit = COLUMNS[name].shown(units)
        values = listed(_series(getattr(given, name)), unit.factor)
        if name == "axial_load" or values not in ("0", "-0"):
            words.append(f"{COLUMNS[name].name} {values} {unit.name}")
    return ", ".join(
        [*words, f"inner speed {listed(_series(given.inner_speed), units.speed.factor)} {units.speed.name}"]
    )


def _series(values: Array | float) -> list[float]:
    return np.atleast_1d(values).tolist()


def _materials(scene: Scene) -> list[Material]:
    """Each material once: of the balls, the rings and the cage."""
    bearing = scene.bearing
    bodies = [bearing.ball_material, bearing.inner.material, bearing.outer.material]
    bodies += [] if scene.cage is None else [scene.cage.material]
    return [material for number, material in enumerate(bodies) if material not in bodies[:number]]


def _surface(surface: Surface, units: Units) -> str:
    words, heights = "", surface.autocorrelation
    if surface.height_map is not None:
        words = f"height map {surface.height_map.path}"
    elif surface.rms_roughness is not None and heights is not None:
        words = (
            f"rms roughness {units.small_length.written(surface.rms_roughness, '.3g')} of each race, {heights.kind} "
            f"autocorrelation of {units.small_length.written(heights.length, '.3g')}"
        )
    return f"{words}, boundary friction {surface.boundary_friction:g}"


def _cage(cage: Cage, units: Units) -> str:
    return (
        f"pocket {units.length.written(cage.pocket_diameter, '.5g')} in diameter, "
        f"{units.length.written(cage.pocket_depth, '.4g')} deep, wall "
        f"{units.length.written(cage.wall_thickness, '.3g')}, {cage.material.name}"
    )


def _groove(groove: Groove, ball_diameter: float, units: Units) -> str:
    near = (
        "not known" if groove.shoulder_half_width is None else units.length.written(groove.shoulder_half_width, ".3g")
    )
    far = groove.far_shoulder_half_width
    apart = "" if far is None else f", the far one {units.length.written(far, '.3g')}"
    return (
        f"radius {units.length.written(groove.groove_radius, '.5g')}, conformity "
        f"{groove.groove_radius / ball_diameter:.4f}, bottom radius "
        f"{units.length.written(groove.bottom_radius, '.5g')}, shoulders {near} from the middle{apart}, "
        f"{groove.material.name}"
    )


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
