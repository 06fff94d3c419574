"""Every quantity of a result, once: name, symbol, SI unit, the unit in which it is shown, and meaning; unit systems.

Datasets, sweeps, maps, tables and figures read them here. The columns of a friction torque stand in `analytic.result`,
which knows nothing of this package.
"""

from dataclasses import dataclass, fields
from typing import NamedTuple

from analytic.columns import COLUMNS, COORDINATES
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


class Quantity(NamedTuple):
    """What a number is, and how it is shown."""

    name: str  # short, for tables and figures
    symbol: str  # of the formulas; empty where none is used
    unit: str  # SI, of every stored number
    shown: Unit
    meaning: str  # for datasets

    @property
    def heading(self) -> str:
        """Name and shown unit, as they stand over a column."""
        return f"{self.name}, {self.shown.name}"

    def in_units(self, units: Units) -> "Quantity":
        """The same quantity as another system shows it."""
        return self._replace(shown=units.instead_of(self.shown))


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


CONTACT: dict[str, Quantity] = {  # those of a contact that are compared, in the order in which they are shown
    "approach": Quantity("approach", "delta", "m", MICRO, "approach"),
    "semi_axis_rolling": Quantity("semi-axis a", "a", "m", MILLI, "semi-axis along rolling"),
    "semi_axis_transverse": Quantity("semi-axis b", "b", "m", MILLI, "transverse semi-axis"),
    "peak_pressure": Quantity("peak pressure", "p0", "Pa", GIGA, "peak pressure"),
    "stiffness": Quantity("stiffness", "K", "N/m^1.5", STIFFNESS, "stiffness (load over approach^1.5)"),
}
STRESSES: dict[str, Quantity] = {  # under the centre of a contact
    "max_shear": Quantity("shear", "", "Pa", GIGA, "greatest shear stress"),
    "max_shear_depth": Quantity("its depth", "", "m", MICRO, "depth of the greatest shear stress"),
    "max_von_mises": Quantity("von Mises", "", "Pa", GIGA, "greatest von Mises stress"),
    "max_von_mises_depth": Quantity("its depth", "", "m", MICRO, "depth of the greatest von Mises stress"),
}
QUANTITIES: dict[str, Quantity] = {
    **{
        name: Quantity(column.meaning, column.symbol, column.unit, unit_for(column.unit, 0.0), column.meaning)
        for name, column in (COORDINATES | COLUMNS).items()
    },
    **CONTACT,
    **STRESSES,
    "torque": Quantity("friction torque", "", "N m", NEWTON_MILLIMETRE, "friction torque"),
    "film": Quantity("film", "h", "m", MICRO, "film thickness between the mean planes"),
    "load": Quantity("load", "Q", "N", NEWTON, "load of the ball"),
    "viscosity": Quantity("viscosity", "", "Pa s", Unit("Pa s", 1.0), "viscosity"),
    "rms_roughness": Quantity("rms roughness", "Sq", "m", MICRO, "rms roughness"),
    "conformity": Quantity("conformity", "", "1", Unit("", 1.0), "conformity, groove radius over ball diameter"),
}
SHARES = ("uncertainty_", "asperity_share", "boundary_share")  # pure numbers that are shown in percent
OF_A_RACE = ("_inner", "_outer")


def shown_unit(name: str, unit: str) -> Unit:
    """The unit in which a column of a torque is shown, whatever its size.

    name, unit : of the column, SI
    """
    if name.startswith(SHARES):
        return PERCENT
    stem = name.removesuffix(OF_A_RACE[0]).removesuffix(OF_A_RACE[1])
    if unit in ("m", "Pa") or stem == "load":
        return QUANTITIES[stem].shown
    return unit_for(unit, 0.0)
