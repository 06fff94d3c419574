"""Values as callers give them, and the options of a scene. It imports little: the help of commands shows it."""

import os
from collections.abc import Mapping
from typing import Any, Literal, Protocol, TypedDict

Supply = Literal["oil_bath", "oil_jet", "oil_spot", "grease"]
UnitSystem = Literal["metric", "inch"]  # that pages and tables show


class Quantity(Protocol):
    """A number or an array with its unit, as in pint."""

    @property
    def magnitude(self) -> Any: ...

    @property
    def units(self) -> Any: ...


class OfNumPy(Protocol):
    """A number of NumPy, or an array of them for a series."""

    @property
    def dtype(self) -> Any: ...

    def tolist(self) -> Any: ...


Given = float | OfNumPy | str | Quantity  # a number in SI, a text with a unit, or a quantity


class OperatingOptions(TypedDict, total=False):
    """Values of a scene by the names of options: numbers in SI, texts with units, lists or arrays for a series."""

    axial_load: Given | list[Any]
    radial_load: Given | list[Any]
    speed: Given | list[Any]
    oil: str
    temperature: Given
    supply: Supply


class SceneOptions(OperatingOptions, total=False):
    """What `analytic.load_scene` takes beside a name."""

    measured: str | os.PathLike[str] | None
    settings: Mapping[str, Any]


KEYS: Mapping[str, str] = {  # of a scene file, by the options
    "axial_load": "operation.axial_load",
    "radial_load": "operation.radial_load",
    "speed": "operation.inner_speed",
    "oil": "lubricant.name",
    "temperature": "lubricant.temperature",
    "supply": "lubricant.supply",
}
USUAL_SPEED, USUAL_TEMPERATURE = "1000 rpm", "60 degC"  # of a bearing of the catalogue, where nobody gives another


def has_unit(value: Any) -> bool:
    """Whether a number, or one of a list, has a unit of its own; known by what a quantity of pint has."""
    if isinstance(value, list | tuple):
        return any(has_unit(each) for each in value)
    return hasattr(value, "magnitude") and hasattr(value, "units")


def why_no_unit(field: str, value: Any, unit: str | None = None) -> str:
    """Why a value with a unit is refused, in one line; unit : in SI, "" of a pure number; None: not known here."""
    wanted = "its number in SI" if unit is None else f"a plain number in {unit}" if unit else "a plain number"
    written = " ".join(str(value).split())
    return f"{field} = {written:.80} has a unit of its own, which is not read here: give {wanted}"
