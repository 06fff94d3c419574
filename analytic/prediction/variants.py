"""A scene with other values of its uncertain inputs."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

from analytic.contact.geometry import RACES
from analytic.oil.variation import Variation
from analytic.scene import Bearing, Scene, Surface
from analytic.scenefile.inputs import uncertain_value


def varied_scene(scene: Scene, values: Mapping[str, float]) -> tuple[Scene, Variation]:
    """The scene with these values, and the variation of the formulas.

    values : by the keys of `analytic.scenefile.inputs.UNCERTAIN`, SI
    An angle below 0 leans to the other side of the groove and counts by its size.
    """
    tables: dict[str, dict[str, float]] = {}
    for key, value in values.items():
        table, _, rest = key.partition(".")
        tables.setdefault(table, {})[rest] = value
    changed: dict[str, Any] = {}
    if "bearing" in tables:
        inside = tables["bearing"].items()
        of_angle = {key.partition(".")[2]: abs(v) for key, v in inside if key.startswith("contact_angle")}
        changed["contact_angle"] = replace(scene.contact_angle, **of_angle)
        changed["bearing"] = _bearing(scene.bearing, tables["bearing"])
    if "operation" in tables:
        factors = {name: load / _nominal(scene, f"operation.{name}") for name, load in tables["operation"].items()}
        loads = {name: getattr(scene.operation, name) * factor for name, factor in factors.items()}
        changed["operation"] = replace(scene.operation, **loads)
    ahead = tables.get("lubricant", {}).pop("reach.ahead", None)
    for name in ("arrangement", "lubricant", "losses", "cage"):
        if name in tables:
            changed[name] = replace(getattr(scene, name), **tables[name])
    cage = changed.get("cage", scene.cage)
    if cage is not None and cage.gives_way and "bearing" in changed:  # its pockets are sized by the balls
        grown = changed["bearing"].ball_diameter / scene.bearing.ball_diameter
        sizes = {name: grown * getattr(cage, name) for name in ("pocket_diameter", "pocket_depth")}
        changed["cage"] = replace(cage, **sizes)
    if ahead is not None:
        oil = changed.get("lubricant", scene.lubricant)
        changed["lubricant"] = replace(oil, reach=replace(oil.reach, ahead=ahead))
    if "surface" in tables and scene.surface is not None:
        changed["surface"] = _surface(scene.surface, tables["surface"])
    names = {"coefficient": "friction_coefficient", "hysteresis_loss": "hysteresis_loss"}
    changed |= {names[key]: value for key, value in tables.get("friction", {}).items()}
    model = tables.get("model", {})
    variation = Variation(
        film=model.get("film", 1.0),
        traction=model.get("traction", 1.0),
        rolling_error=model.get("rolling", 1.0),
        heating=model.get("heating", 1.0),
        starvation=model.get("starvation", 0.0),
        asperity_pressure=model.get("surfaces", 1.0),
        asperity_share=model.get("gap", 0.0),
        elastic_rolling=model.get("elastic_rolling", 0.0),
        grease_film=model.get("grease_film", 1.0),
        unloaded_balls=model.get("unloaded_balls", 1.0),
        oil_losses=model.get("oil_losses", 1.0),
    )
    return replace(scene, **changed), variation


def _nominal(scene: Scene, key: str) -> float:
    value = uncertain_value(scene, key)
    assert value is not None, key
    return value


def _bearing(bearing: Bearing, values: Mapping[str, float]) -> Bearing:
    """Balls, grooves and their places; a clearance that closes at a nominal angle keeps that angle.

    The ball's mass and the shoulders follow its diameter. Both washers of a thrust bearing have one groove.
    """
    ball = values.get("ball_diameter", bearing.ball_diameter)
    pitch = values.get("pitch_diameter", bearing.pitch_diameter)
    washers = bearing.kind == "thrust"
    grown = ball / bearing.ball_diameter
    radii = {}
    for race in RACES:
        own = getattr(bearing, race).groove_radius / bearing.ball_diameter
        radii[race] = values.get("inner.conformity" if washers else f"{race}.conformity", own) * ball
    opening = 0.0  # of the bottoms of both grooves, on the diameter
    if not washers:
        clearance = values.get("clearance", bearing.diametral_clearance)
        closes = bearing.origins.get("clearance")
        if closes is not None and closes.status == "derived":
            clearance *= (sum(radii.values()) - ball) / bearing.groove_centre_distance
        opening = ball + clearance / 2
    grooves = {
        race: replace(
            groove := getattr(bearing, race),
            bottom_radius=(pitch + side * opening) / 2,
            groove_radius=radii[race],
            shoulder_half_width=_times(groove.shoulder_half_width, grown),
            far_shoulder_half_width=_times(groove.far_shoulder_half_width, grown),
        )
        for race, side in zip(RACES, (-1, 1), strict=True)
    }
    return replace(bearing, ball_diameter=ball, ball_mass=bearing.ball_mass * grown**3, **grooves)


def _times(width: float | None, factor: float) -> float | None:
    return None if width is None else width * factor


def _surface(surface: Surface, values: Mapping[str, float]) -> Surface:
    """Ball and race together; the spacing of the points follows the length of the waves."""
    changed: dict[str, Any] = {key: value for key, value in values.items() if key != "autocorrelation.length"}
    rough, waves = surface.rms_roughness, surface.autocorrelation
    if rough and surface.ball_rms_roughness is not None and "rms_roughness" in values:
        changed["ball_rms_roughness"] = surface.ball_rms_roughness * values["rms_roughness"] / rough
    if waves is not None and "autocorrelation.length" in values:
        length = values["autocorrelation.length"]
        changed["autocorrelation"] = replace(waves, length=length, spacing=waves.spacing * length / waves.length)
    return replace(surface, **changed)
