"""The inputs of a scene that are not simply given: values with where they come from and how uncertain they are."""

from dataclasses import dataclass

from analytic.scene import Bearing, Clearances, Groove, Lubricant, Origin, Scene, Surface

UNITS = {
    **dict.fromkeys(("ball_count", "conformity", "limiting_shear", "boundary_friction"), "1"),
    **dict.fromkeys(("static_load_rating", "dynamic_load_rating"), "N"),
    **dict.fromkeys(("eyring_stress", "hardness"), "Pa"),
    "ball_mass": "kg",
    "viscosity": "Pa s",
    "pressure_viscosity": "1/Pa",
    "thermal_conductivity": "W/m/K",
    "density": "kg/m^3",
}


@dataclass(frozen=True, kw_only=True)
class StatedInput:
    """One input: what it is, and how far to trust it."""

    key: str  # of the scene file, "bearing.ball_diameter"
    value: float | None  # None: not known
    unit: str  # SI; "1" for a pure number
    origin: Origin  # its uncertainty is a standard deviation, in the same unit


def stated_inputs(scene: Scene) -> tuple[StatedInput, ...]:
    """The inputs of bearing, oil and surface that have an origin, in the order of the scene file."""
    tables = (("bearing", scene.bearing), ("lubricant", scene.lubricant), ("surface", scene.surface))
    return tuple(
        StatedInput(key=f"{name}.{key}", value=_value(table, key, scene.clearances), unit=_unit(key), origin=origin)
        for name, table in tables
        if table is not None
        for key, origin in table.origins.items()
    )


def _value(table: Bearing | Lubricant | Surface, key: str, clearances: Clearances | None) -> float | None:
    """The value of a key, SI; the clearance is that before mounting."""
    if isinstance(table, Bearing) and key == "clearance":
        return table.diametral_clearance if clearances is None else clearances.unmounted
    part = table
    *path, last = key.split(".")
    for name in path:
        part = getattr(part, name)
    if isinstance(table, Bearing) and isinstance(part, Groove) and last == "conformity":
        return part.groove_radius / table.ball_diameter
    return getattr(part, last)


def _unit(key: str) -> str:
    """The unit of a key in SI; a length, if it is not listed."""
    return UNITS.get(key.rpartition(".")[2], "m")
