"""The inputs of a scene that are not simply given: values with where they come from and how uncertain they are."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from analytic.scene import Bearing, Groove, Origin, Scene


@dataclass(frozen=True, kw_only=True)
class StatedInput:
    """One input: what it is, and how far to trust it."""

    key: str  # of the scene file, "bearing.ball_diameter"
    value: float | None  # None: not known
    unit: str  # SI; "1" for a pure number
    origin: Origin  # its uncertainty is a standard deviation, in the same unit


def stated_inputs(scene: Scene) -> tuple[StatedInput, ...]:
    """The inputs that have an origin, in the order of the scene file: those of the bearing, the oil and the surface."""
    tables: tuple[tuple[str, Mapping[str, Origin], Callable[[str], tuple[float | None, str]]], ...] = (
        ("bearing", scene.bearing.origins, lambda key: _of_bearing(scene.bearing, key)),
    )
    return tuple(
        StatedInput(key=f"{table}.{key}", value=value, unit=unit, origin=origin)
        for table, origins, read in tables
        for key, origin in origins.items()
        for value, unit in (read(key),)
    )


def _of_bearing(bearing: Bearing, key: str) -> tuple[float | None, str]:
    """Value and unit of a dimension of the bearing."""
    ring, _, own = key.partition(".")
    if own:
        return _of_groove(getattr(bearing, ring), own, bearing.ball_diameter)
    if key == "clearance":
        return bearing.diametral_clearance, "m"
    unit = {"ball_count": "1", "ball_mass": "kg"}.get(key, "N" if key.endswith("_rating") else "m")
    return getattr(bearing, key), unit


def _of_groove(groove: Groove, key: str, ball_diameter: float) -> tuple[float | None, str]:
    return (groove.groove_radius / ball_diameter, "1") if key == "conformity" else (getattr(groove, key), "m")
