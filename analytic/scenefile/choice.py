"""What the scene of a bearing of the catalogue gives beside it. It imports little: the help of commands shows it."""

from dataclasses import dataclass


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
