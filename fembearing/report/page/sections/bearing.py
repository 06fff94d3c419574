"""What was computed: bearing, oil, surfaces, friction and materials, in the units of a drawing."""

from collections.abc import Iterator

from analytic.result import COORDINATES
from fembearing.quantities import CONTACT, MICRO, MILLI, RPM, unit_for
from fembearing.report.document.report import Report
from fembearing.report.document.scene import Cage, Groove, Scene
from fembearing.report.phrases import MEGAPASCAL, angle_of, celsius, clearances_of, friction_of, listed, shown

GIGA = CONTACT["peak_pressure"].shown
Facts = list[tuple[str, str]]


def facts_of(document: Report) -> Facts:
    """Name and words of what defines the torque, for the summary."""
    scene = document.provenance.scene_content
    facts = list(_facts(scene))
    return facts if document.torque is not None else [*facts, ("operation", _operation(scene))]


def details_of(document: Report) -> Facts:
    """The same of grooves, materials and seats, for an appendix."""
    scene, torque = document.provenance.scene_content, document.torque
    bearing = scene.bearing
    details = [
        (f"{race} groove", _groove(groove, bearing.ball_diameter))
        for race, groove in (("inner", bearing.inner), ("outer", bearing.outer))
    ]
    details += [
        (each.name, f"E {GIGA.written(each.youngs_modulus, '.4g')}, nu {each.poisson_ratio:.3g}; {each.source}")
        for each in scene.materials
    ]
    if torque is not None and torque.clearances is not None:
        details.append(("seats", clearances_of(torque.clearances)))
    details.append(("spin of balls", f"rule: {scene.spin_rule.replace('_', ' ')}"))
    chosen = scene.calibration or "the scene names no input that was chosen until a number came out"
    return [*details, ("calibration", chosen)]


def _facts(scene: Scene) -> Iterator[tuple[str, str]]:
    bearing, angle = scene.bearing, scene.contact_angle
    pitch = bearing.inner.bottom_radius + bearing.outer.bottom_radius
    gap = 2 * (bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter)
    clearance = (
        f", diametral clearance {MICRO.written(gap, '.3g')}" if bearing.kind == "radial" else ""
    )  # washers: none
    diameter, material = MILLI.written(bearing.ball_diameter, ".5g"), bearing.ball_material.name
    yield (
        "bearing",
        f"{bearing.name}: {bearing.ball_count} balls of {diameter} ({material}), pitch diameter "
        f"{MILLI.written(pitch, '.5g')}{clearance}",
    )
    if angle.rule == "given":
        yield "contact angle", f"given, {angle_of(angle.value)}"
    else:
        free = "that of the clearance" if angle.free is None else angle_of(angle.free)
        yield "contact angle", f"solved from the load; unloaded: {free}"
    if scene.lubricant is not None:
        oil = scene.lubricant
        yield (
            "lubricant",
            f"at {celsius(oil.temperature)}; {oil.viscosity:.3g} Pa s at {celsius(oil.reference_temperature)}, "
            f"pressure-viscosity {unit_for('1/Pa', 0).written(oil.pressure_viscosity, '.3g')}, Eyring stress "
            f"{MEGAPASCAL.written(oil.eyring_stress, '.3g')}",
        )
    if scene.surface is not None:
        yield "surfaces", _surface(scene)
    yield "cage", "none in the scene: no pocket contact" if scene.cage is None else _cage(scene.cage)
    yield "friction", friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.is_lubricated)


def _operation(scene: Scene) -> str:
    """Loads and speeds, where no torque has them."""
    given = scene.operation
    words = [f"axial load {listed(given.axial_load)} N"]
    for name, unit in (("radial_load", "N"), ("moment", "N m")):
        if (values := listed(getattr(given, name))) not in ("0", "-0"):
            words.append(f"{COORDINATES[name].meaning} {values} {unit}")
    return ", ".join([*words, f"inner speed {listed(given.inner_speed, RPM.factor)} {RPM.name}"])


def _surface(scene: Scene) -> str:
    surface = scene.surface
    assert surface is not None
    if surface.height_map is not None:
        words = f"height map {surface.height_map.path}"
    else:
        heights = surface.autocorrelation
        words = f"rms roughness {MICRO.written(surface.rms_roughness, '.3g')} of each race, {heights.kind} "
        words += f"autocorrelation of {MICRO.written(heights.length, '.3g')}"
    return f"{words}, boundary friction {surface.boundary_friction:g}"


def _cage(cage: Cage) -> str:
    return (
        f"pocket {MILLI.written(cage.pocket_diameter, '.5g')} in diameter, {MILLI.written(cage.pocket_depth, '.4g')} "
        f"deep, wall {MILLI.written(cage.wall_thickness, '.3g')}, {cage.material.name}"
    )


def _groove(groove: Groove, ball_diameter: float) -> str:
    near = "not known" if groove.shoulder_half_width is None else MILLI.written(groove.shoulder_half_width, ".3g")
    far = shown(groove.far_shoulder_half_width, ".3g", MILLI.factor, f" {MILLI.name}", absent="")
    return (
        f"radius {MILLI.written(groove.groove_radius, '.5g')}, conformity "
        f"{groove.groove_radius / ball_diameter:.4f}, bottom radius {MILLI.written(groove.bottom_radius, '.5g')}, "
        f"shoulders {near} from the middle{f', the far one {far}' if far else ''}, {groove.material.name}"
    )
