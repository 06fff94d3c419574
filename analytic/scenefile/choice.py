"""What the scene of a bearing of the catalogue gives beside it. It imports little: the help of commands shows it."""

import os
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, TypedDict

from analytic.units import Quantity

if TYPE_CHECKING:
    from analytic.scene import Supply

Given = float | str | Quantity  # a number in SI, a text with a unit, or a quantity


class OperatingOptions(TypedDict, total=False):
    """Values of a scene by the names of options: numbers in SI, texts with units, lists for a series."""

    axial_load: Given | list[Any]
    radial_load: Given | list[Any]
    speed: Given | list[Any]
    oil: str
    temperature: Given
    supply: "Supply"


class SceneOptions(OperatingOptions, total=False):
    """What `analytic.load_scene` takes beside a name."""

    measured: str | os.PathLike[str]
    settings: Mapping[str, Any]


@dataclass(frozen=True, kw_only=True)
class Choice:
    """Values of a scene file by the names of the options that give them; a list makes a series."""

    axial_load: object = None  # None of both loads: a light load that suits the bearing
    radial_load: object = None
    speed: object = "1000 rpm"
    oil: object = None  # None: a mineral oil of the class that suits size, speed and temperature
    temperature: object = "60 degC"
    supply: object = None  # None: grease where the bearing is closed or the lubricant is one, else an oil bath


USUAL = Choice()
KEYS = {  # of a scene file, by the options
    "axial_load": "operation.axial_load",
    "radial_load": "operation.radial_load",
    "speed": "operation.inner_speed",
    "oil": "lubricant.name",
    "temperature": "lubricant.temperature",
    "supply": "lubricant.supply",
}
LOADS = ("axial_load", "radial_load")
# What also takes the place of the usual load of a bearing.
OTHER_LOADS = ("operation.moment", "arrangement.preload", "arrangement.offset")


def require_nothing_beside(given: SceneOptions) -> None:
    """Raises InputError for anything that is given beside a Scene."""
    if not given:
        return
    from analytic.errors import InputError  # with NumPy

    unknown = sorted({*given} - SceneOptions.__optional_keys__)
    if unknown:
        raise InputError(f"{unknown[0]} is no argument of this function, nor one that goes with a designation")
    raise InputError(f"{min(given)} goes with a designation as 6308; change a Scene by dataclasses.replace")
