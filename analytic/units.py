"""Systems of units: the unit in which each kind of number is shown, and operating points in these units in words."""

from dataclasses import dataclass, fields
from typing import Protocol

from analytic.given import UnitSystem
from analytic.words import (
    DEGREE,
    GIGAPASCAL,
    MICROMETRE,
    MILLIMETRE,
    NEWTON,
    NEWTON_MILLIMETRE,
    PERCENT,
    RPM,
    Unit,
    rounded,
)

GIGA, MILLI, MICRO = GIGAPASCAL, MILLIMETRE, MICROMETRE
STIFFNESS = Unit("GN/m^1.5", 1e-9)
TANGENT = Unit("N/um", 1e-6)
MILLISECOND = Unit("ms", 1e3)
LINE_LOAD = Unit("N/mm", 1e-3)
MEGAPASCAL = Unit("MPa", 1e-6)
PER_PRESSURE = Unit("1/GPa", 1e9)
POUND, INCH = 4.4482216152605, 0.0254  # N and m, exact by definition
KSI = 1e3 * POUND / INCH**2  # Pa


@dataclass(frozen=True, kw_only=True)
class Units:
    """A system of units: the one in which each kind of quantity is shown."""

    force: Unit
    torque: Unit  # moments too
    pressure: Unit
    stress: Unit  # of seats and of oil
    per_pressure: Unit
    length: Unit
    small_length: Unit
    stiffness: Unit  # of a contact: load over approach^1.5
    tangent: Unit  # load over displacement
    line_load: Unit
    temperature: Unit
    angle: Unit = DEGREE
    speed: Unit = RPM
    share: Unit = PERCENT

    def instead_of(self, metric: Unit) -> Unit:
        """What takes the place of a metric unit; that one itself where both systems have it."""
        kinds = (each.name for each in fields(self) if getattr(METRIC, each.name) == metric)
        return getattr(self, next(kinds, ""), metric)

    def unit_for(self, unit: str, largest: float) -> Unit:
        """The unit in which values up to `largest` are shown; unit : SI."""
        return self.instead_of(unit_for(unit, largest))


METRIC = Units(
    force=NEWTON,
    torque=NEWTON_MILLIMETRE,
    pressure=GIGA,
    stress=MEGAPASCAL,
    per_pressure=PER_PRESSURE,
    length=MILLI,
    small_length=MICRO,
    stiffness=STIFFNESS,
    tangent=TANGENT,
    line_load=LINE_LOAD,
    temperature=Unit("degC", 1.0, -273.15),
)
INCH_POUND = Units(
    force=Unit("lbf", 1 / POUND),
    torque=Unit("lbf in", 1 / (POUND * INCH)),
    pressure=Unit("ksi", 1 / KSI),
    stress=Unit("ksi", 1 / KSI),
    per_pressure=Unit("1/ksi", KSI),
    length=Unit("in", 1 / INCH),
    small_length=Unit("uin", 1e6 / INCH),
    stiffness=Unit("Mlbf/in^1.5", 1e-6 / POUND * INCH**1.5),
    tangent=Unit("lbf/uin", 1e-6 / POUND * INCH),
    line_load=Unit("lbf/in", INCH / POUND),
    temperature=Unit("degF", 1.8, -459.67),
)
SYSTEMS: dict[UnitSystem, Units] = {"metric": METRIC, "inch": INCH_POUND}

# SI unit -> units in which it is shown, each from a size on, large to small.
UNITS: dict[str, tuple[tuple[float, Unit], ...]] = {
    "Pa": ((1e8, GIGA), (1e5, MEGAPASCAL), (0.0, Unit("Pa", 1.0))),
    "m": ((1e-3, MILLI), (0.0, MICRO)),
    "1/Pa": ((0.0, PER_PRESSURE),),
    "N": ((0.0, NEWTON),),
    "K": ((0.0, METRIC.temperature),),
    "N m": ((0.0, NEWTON_MILLIMETRE),),
    "rad/s": ((0.0, RPM),),
    "rad": ((0.0, DEGREE),),
    "1": ((0.0, Unit("", 1.0)),),
}


def unit_for(unit: str, largest: float) -> Unit:
    """The unit in which values up to `largest` are shown.

    unit : SI; one that has no entry in UNITS is shown as it is
    """
    for least, shown in UNITS.get(unit, ()):
        if abs(largest) >= least:
            return shown
    return Unit(unit.replace("*", " "), 1.0)


class NamedOil(Protocol):
    """What the words on an oil need of it."""

    @property
    def name(self) -> str: ...
    @property
    def temperature(self) -> float: ...


def coordinate_unit(name: str, units: Units) -> Unit:
    """The unit in which the speed, a load or the moment of an operating point is shown."""
    return {"inner_speed": units.speed, "moment": units.torque}.get(name, units.force)


def load_words(name: str, value: float, units: Units) -> str:
    """A load, N, or the moment, N m, for example "1000 N axial"."""
    words = {"axial_load": "axial", "radial_load": "radial", "moment": "moment"}
    return f"{coordinate_unit(name, units).written(value, '.6g')} {words[name]}"


def speed_words(speed: float, units: Units) -> str:
    """A speed, rad/s, in words."""
    return f"{rounded(units.speed.number(speed), 5)} {units.speed.name}"


def oil_words(oil: NamedOil | None, units: Units) -> str:
    """Oil and temperature, for example "ISO VG 68 at 70 degC"."""
    return "no oil" if oil is None else f"{oil.name or 'oil'} at {units.temperature.written(oil.temperature, '.4g')}"
