"""Every quantity of a result, once: name, symbol, SI unit, the unit in which it is shown, and meaning.

Datasets, sweeps, maps, tables and figures read them here. The columns of a friction torque stand in `analytic.result`,
which knows nothing of this package.
"""

from typing import NamedTuple

from analytic.columns import COLUMNS, COORDINATES
from analytic.labelled import Column
from analytic.units import GIGA, MICRO, STIFFNESS, Units, unit_for
from analytic.units import INCH_POUND as INCH_POUND
from analytic.units import METRIC as METRIC
from analytic.units import MILLI as MILLI
from analytic.units import SYSTEMS as SYSTEMS
from analytic.words import NEWTON, NEWTON_MILLIMETRE, PERCENT, Unit

MILLISECOND = Unit("ms", 1e3)


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
VERDICT = "verdict"  # a column of words beside those of numbers
CONTACT_COLUMNS: dict[str, Column] = {  # of a solved contact
    "load": Column("N", QUANTITIES["load"].meaning),
    "contact_angle": Column("rad", "contact angle"),
    **{
        f"{prefix}{name}": Column(unit or each.unit, words.format(each.meaning))
        for prefix, unit, words in (
            ("", "", "{}, finite elements"),
            ("uncertainty_", "1", "numerical uncertainty of the {}, relative, 95 %"),
            ("hertz_", "", "{}, Hertz"),
            ("discrepancy_", "1", "discrepancy of Hertz's {}, over finite elements minus one"),
        )
        for name, each in CONTACT.items()
    },
    "unknowns": Column("1", "unknowns of the finest mesh"),
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


def about(seconds: float) -> str:
    """A duration in words: one digit, in seconds or minutes."""
    return f"about {round(seconds / 60):d} min" if seconds >= 90 else f"about {float(f'{seconds:.1g}'):g} s"
