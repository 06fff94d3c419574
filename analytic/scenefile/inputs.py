"""The inputs of a scene: where they come from, how uncertain they are, and which of them a prediction varies."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.declared import Whole, read_only
from analytic.errors import InputError
from analytic.rows import NotNegative
from analytic.scene import LOSS_SPREAD, Bearing, Cage, Groove, Material, Origin, Scene, Status
from analytic.scenefile.keys import ASSUMABLE, GIVEN, NORMAL, UNCERTAIN, Values, scene_key
from analytic.scenefile.kinds import LARGEST_SHARE, GivenSpread


@dataclass(frozen=True, kw_only=True)
class StatedInput:
    """One input: what it is, and how far to trust it."""

    key: str  # of the scene file, "bearing.ball_diameter"
    value: float | str | None  # a word of the scene file where it is no number; None: not known
    unit: str  # SI; "1" for a pure number, "" for a word
    status: Status  # how it came about, in a word
    uncertainty: NotNegative | None  # standard deviation, in the same unit; None: unknown
    source: str  # in words


LARGEST = {"losses.oil_share": 1.0}  # at which the distribution of an input ends, in its unit

USUAL_LOSS_ORIGIN = "usual in calculations for bearing steel; 0.003 to 0.025 are in use, none of them measured"
USUAL = "a usual value: none was given"
USUAL_DOWN = "along x, as the radial load"


def unit_of(key: str) -> str:
    """The SI unit of an input; "1" of a pure number, empty of a word."""
    if key.startswith("model."):
        return "1"
    entry = scene_key(key)
    dimension = entry.dimension
    if dimension is None:
        return "1" if isinstance(entry.kind, Whole) else ""
    return dimension.unit or "1"


def stated_inputs(scene: Scene) -> tuple[StatedInput, ...]:
    """The inputs with an origin: of bearing, cage, oil and surface, what scene and designation assume, a usual loss."""
    known = known_inputs(scene)
    stated = {key: known[key] for key in _with_origin(scene)}
    for key, text in scene.usual.items():
        word = StatedInput(key=key, value=text, unit="", status="assumed", uncertainty=None, source=USUAL)
        stated.setdefault(key, replace(known[key], status="assumed", source=USUAL) if key in known else word)
    assumed = {key: replace(known[key], status="assumed", source=source) for key, source in scene.assumed.items()}
    return tuple((stated | assumed).values())


def known_inputs(scene: Scene) -> dict[str, StatedInput]:
    """By key: the inputs with an origin, and the others that a scene may declare as assumed; these count as given."""
    values: dict[str, Any] = {key: uncertain_value(scene, key) for key in ASSUMABLE if key in UNCERTAIN}
    if scene.cage is not None:
        of_cage = ("pocket_clearance", "wall_thickness", "material", "start")
        values |= {f"cage.{key}": _stated(scene, scene.cage, key) for key in of_cage}
    known = {key: (value, GIVEN) for key, value in values.items() if value is not None} | _with_origin(scene)
    return {
        key: StatedInput(key=key, value=value, unit=unit_of(key), **vars(origin))
        for key, (value, origin) in known.items()
    }


def _with_origin(scene: Scene) -> dict[str, tuple[float | str | None, Origin]]:
    """By key, each with its value."""
    tables = {name: getattr(scene, name) for name in ("bearing", "cage", "lubricant", "surface", "losses")}
    usual = {}
    loss = uncertain_value(scene, "friction.hysteresis_loss")
    if scene.hysteresis_loss is None and loss is not None:
        origin = Origin(status="assumed", uncertainty=LOSS_SPREAD * loss, source=USUAL_LOSS_ORIGIN)
        usual["friction.hysteresis_loss"] = loss, origin
    counts = scene.contact_angle.rule == "solved" and scene.effects.get("weight") != "off"
    if scene.down is None and counts and not scene.operation.is_thrust:
        usual["operation.down"] = "1, 0, 0", Origin(status="assumed", uncertainty=None, source=USUAL_DOWN)
    return usual | {
        f"{name}.{key}": (_stated(scene, table, key), origin)
        for name, table in tables.items()
        if table is not None
        for key, origin in table.origins.items()
    }


def uncertain_value(scene: Scene, key: str) -> float | None:
    """The value of an input of UNCERTAIN, SI, about which it varies; None where the torque does not ask for it.

    Of a load the largest magnitude of the series, which varies as a whole; of a formula 1, of a step between two 0.
    """
    table, _, rest = key.partition(".")
    if not _is_asked_for(scene, key):
        return None
    if table == "model":
        return 0.0 if UNCERTAIN[key] is NORMAL else 1.0
    if table == "operation":
        return float(np.max(np.abs(getattr(scene.operation, rest)))) or None
    if table == "friction":
        return (scene.friction_coefficient if rest == "coefficient" else scene.loss_factor) or None
    if key.startswith("bearing.contact_angle."):
        return getattr(scene.contact_angle, rest.rpartition(".")[2])
    part = getattr(scene, table)
    value = None if part is None else _value(part, rest)
    return value if table in ("bearing", "arrangement", "cage") else value or None


def _is_asked_for(scene: Scene, key: str) -> bool:
    """Whether the torque depends on an input of UNCERTAIN, as far as the scene has it."""
    oil, surface, angle, effects = scene.lubricant, scene.surface, scene.contact_angle, scene.effects
    is_solved, is_washer = angle.rule == "solved", scene.bearing.kind == "thrust"  # equal grooves, and 90 degrees
    mixed = oil is not None and surface is not None and scene.friction_coefficient is None
    can_starve = effects.get("starvation") != "off"
    is_elastic = scene.has_friction and effects.get("hysteresis") != "off"
    if key in ("lubricant.surface_tension", "model.grease_film"):
        return oil is not None and can_starve and oil.starves_as_measured(scene.bearing)
    if key == "model.starvation":
        return oil is not None and can_starve and oil.starves_by_replenishment(scene.bearing)
    if key == "model.unloaded_balls":
        has_bath = oil is not None and oil.supply == "oil_bath"
        return has_bath and effects.get("unloaded_balls") != "off" and not scene.operation.is_thrust
    if key in (
        "model.rolling",
        "model.heating",
        "lubricant.viscosity",
        "lubricant.temperature",
        "lubricant.reach.ahead",
    ):
        return oil is not None
    own = {
        "bearing.contact_angle.free": is_solved,
        "bearing.contact_angle.value": not is_solved and not is_washer,
        "bearing.outer.conformity": not is_washer,
        "bearing.clearance": is_solved and angle.free is None,
        "friction.hysteresis_loss": is_elastic and scene.elastic_rolling == "hysteresis",
        "model.elastic_rolling": is_elastic and bool(scene.loss_factor),
        "model.oil_losses": scene.losses.has_oil,
        "surface.autocorrelation.length": mixed and surface is not None and surface.autocorrelation is not None,
    }
    return own.get(key, mixed or not key.startswith(("lubricant.", "surface.", "model.")))


def checked_deviation(key: str, value: float, deviation: float) -> float:
    """The standard deviation of an input, in its unit. Raises InputError if it is negative or too large.

    value : of the input
    """
    floor = UNCERTAIN[key]
    unit = "" if unit_of(key) == "1" else f" {unit_of(key)}"
    if not 0 <= deviation < np.inf:
        raise InputError(f"uncertainty.{key} = {deviation:g}{unit}: give a standard deviation of at least 0")
    if floor is not None and deviation > LARGEST_SHARE * (value - floor):
        most = LARGEST_SHARE * (value - floor)
        above = f" above {floor:g}" if floor else ""
        raise InputError(
            f"uncertainty.{key} = {deviation:.4g}{unit}: is more than {100 * LARGEST_SHARE:g} % of the value{above}, "
            f"{most:.4g}{unit}; an input that is so uncertain is not known, give a smaller one"
        )
    return deviation


def with_spreads(v: Values, scene: Scene) -> Scene:
    """The scene with its [uncertainty] and [assumed]; what does not fit it is noted in the values."""
    spreads: dict[str, float] = {}
    for key in UNCERTAIN:
        given: GivenSpread | None = v[f"uncertainty.{key}"]
        value = None if given is None else uncertain_value(scene, key)
        if given is not None and value is not None:
            try:
                spreads[key] = checked_deviation(key, value, given.value * value if given.is_share else given.value)
            except InputError as problem:
                v.misfits.append((f"uncertainty.{key}", str(problem).partition(": ")[2]))
        elif given is not None:
            problem = "is of an input that this scene lacks or its torque does not depend on; leave it out"
            v.misfits.append((f"uncertainty.{key}", problem))
    known = known_inputs(scene)
    sources = {key: source for key in ASSUMABLE if (source := v[f"assumed.{key}"]) is not None}
    problem = "is of an input that this scene does not have; leave it out"
    v.misfits += [(f"assumed.{key}", problem) for key in sources if key not in known]
    return replace(scene, uncertainty=read_only(spreads), assumed=read_only(sources))


def _stated(scene: Scene, table: object, key: str) -> float | str | None:
    """The value of a key as it is stated, SI or a word; the clearance is that before mounting."""
    if isinstance(table, Bearing) and key == "clearance" and scene.clearances is not None:
        return scene.clearances.unmounted
    if isinstance(table, Cage) and key == "pocket_clearance":
        return table.pocket_diameter - scene.bearing.ball_diameter
    value = _value(table, key)
    return value.name if isinstance(value, Material) else value


def _value(table: object, key: str) -> Any:
    """The value of a key: a number in SI, a material, or None."""
    if isinstance(table, Bearing) and key == "clearance":
        return table.diametral_clearance
    part = table
    *path, last = key.split(".")
    for name in path:
        part = getattr(part, name)
    if isinstance(table, Bearing) and isinstance(part, Groove) and last == "conformity":
        return part.groove_radius / table.ball_diameter
    return getattr(part, last)
