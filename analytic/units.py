"""The SI unit of each field; numbers with a unit of their own, of pint or the like, which the model does not take."""

from typing import Any, Literal, Protocol

UnitSystem = Literal["metric", "inch"]  # that pages and tables show

# SI units by field of the nouns in `analytic.scene` and by argument; "1" for a pure number, ""
# for a word.
UNITS: dict[str, str] = {
    **dict.fromkeys(("ball_count", "conformity", "limiting_shear", "boundary_friction", "poisson_ratio"), "1"),
    **dict.fromkeys(("friction_coefficient", "coefficient", "restitution", "starvation_degree"), "1"),
    **dict.fromkeys(("ahead", "behind"), "1"),
    **dict.fromkeys(("hysteresis_loss", "tolerance", "accuracy", "seeds", "steps_per_contact"), "1"),
    **dict.fromkeys(("static_load_rating", "dynamic_load_rating", "preload"), "N"),
    **dict.fromkeys(("axial_load", "radial_load", "load", "loads", "ball_load"), "N"),
    **dict.fromkeys(
        ("eyring_stress", "cavitation_pressure", "hardness", "youngs_modulus", "shaft_pressure", "housing_pressure"),
        "Pa",
    ),
    **dict.fromkeys(("moment", "seals", "drag"), "N m"),
    **dict.fromkeys(("ball_mass", "mass"), "kg"),
    **dict.fromkeys(("inner_speed", "outer_speed"), "rad/s"),
    **dict.fromkeys(("value", "free", "contact_angle", "tilt"), "rad"),
    **dict.fromkeys(("temperature", "reference_temperature", "mounting_temperature"), "K"),
    **dict.fromkeys(("inner_temperature", "outer_temperature", "ball_temperature"), "K"),
    **dict.fromkeys(("viscosity_temperature", "thermal_expansion"), "1/K"),
    "viscosity": "Pa s",
    "pressure_viscosity": "1/Pa",
    "thermal_conductivity": "W/m/K",
    "density": "kg/m^3",
    "duration": "s",
    "pocket_stiffness": "N/m^1.5",
    "sheet_stiffness": "N/m",
    "surface_tension": "N/m",
    "oil_flow": "m^3/s",
    "oil_share": "1",
    "Cage.drag": "N m s",
    **dict.fromkeys(("MeasuredTorque.torque", "MeasuredTorque.uncertainty"), "N m"),
    **dict.fromkeys(("start", "material", "ball_material"), ""),  # words
}


class Quantity(Protocol):
    """A number or an array with its unit, as in pint."""

    @property
    def magnitude(self) -> Any: ...

    @property
    def units(self) -> Any: ...


def unit_of(field: str) -> str:
    """The SI unit of a field, "Cage.drag" or "drag"; a length, if it is not listed."""
    return UNITS.get(field, UNITS.get(field.rpartition(".")[2], "m"))


def has_unit(value: Any) -> bool:
    """Whether a number, or one of a list, has a unit of its own; known by what a quantity of pint has."""
    if isinstance(value, list | tuple):
        return any(has_unit(each) for each in value)
    return hasattr(value, "magnitude") and hasattr(value, "units")


def why_no_unit(field: str, value: Any, unit: str | None = None) -> str:
    """Why a value with a unit is refused, in one line; unit : in SI, None: not known here."""
    wanted = "its number in SI" if unit is None else f"a plain {'number' if unit == '1' else f'number in {unit}'}"
    written = " ".join(str(value).split())
    return f"{field} = {written:.80} has a unit of its own, which is not read here: give {wanted}"
