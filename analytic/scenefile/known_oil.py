"""What the catalog knows of a named oil, or of a kind of base oil, in SI."""

import re
from dataclasses import dataclass, replace
from difflib import get_close_matches
from math import log, sqrt
from typing import Any

import numpy as np

from analytic import catalog
from analytic.errors import InputError
from analytic.oil.viscosity_temperature import PressureViscosityLaw, ViscosityLine, viscosity_line
from analytic.quantity import in_si
from analytic.scene import Lubricant, Origin, Status
from analytic.words import shown

COLD, HOT = 313.15, 373.15  # K: where the catalog's viscosities are given
DENSITY_AT = 288.15  # K: where its densities are given
# Limits, over the value.
DENSITY_LIMIT = 0.03  # an assumed density: mineral base oils are some 850 to 900 kg/m^3
MEASURED_LIMIT = 0.05  # a measured pressure-viscosity coefficient; two laboratories differ by 8 %
SHEAR_LIMIT = 0.10  # traction by the limiting shear of [Arana2019] was within 10 % of tests
HOT_LIMIT = 0.20  # an assumed viscosity at 100 degC: indices of 95 and 140 differ by 18 % in VG 46
KINDS = {"diester": "ester"}  # other names of kinds of base oil
UNKNOWN_KIND = "not known"


@dataclass(frozen=True, kw_only=True)
class Known:
    """How a value is known."""

    status: Status
    source: str
    limit: float | None = None  # +-, over the value; None: not known

    def property(self, value: float) -> "Property":
        """A limit +-a counts as a rectangular distribution, whose standard deviation is a/sqrt(3)."""
        deviation = None if self.limit is None else abs(value) * self.limit / sqrt(3)
        return Property(value=value, origin=Origin(status=self.status, uncertainty=deviation, source=self.source))


@dataclass(frozen=True, kw_only=True)
class Property:
    """A value in SI and where it comes from."""

    value: float
    origin: Origin


@dataclass(frozen=True, kw_only=True)
class Density:
    """rho = rho_15 + slope (T - 15 degC)."""

    at_15: float  # kg/m^3
    slope: float  # kg/(m^3 K)
    known: Known

    def at(self, temperature: float) -> float:
        """rho, kg/m^3; temperature : K."""
        return self.at_15 + self.slope * (temperature - DENSITY_AT)


@dataclass(frozen=True, kw_only=True)
class KnownOil:
    """What the catalog knows of an oil; None: no readable source."""

    name: str  # for messages and sources
    source: str = ""  # of the viscosities
    line: ViscosityLine | None = None
    is_class: bool = False  # whether the viscosity is that of a class of ISO 3448
    hot_is_assumed: bool = False  # whether nobody prints the viscosity at 100 degC
    density: Density | None = None
    law: PressureViscosityLaw | None = None
    modulus: tuple[float, float] | None = None  # a1, Pa, and a2, Pa/K, of 1/alpha = a1 + a2 T; None: by the law
    law_known: Known = Known(status="derived", source="")  # of the coefficient
    modulus_rise: tuple[float, float] = Lubricant.modulus_rise
    traction_spread: float = 0.5  # as of `Lubricant`
    limiting_shear: Property | None = None
    thermal_conductivity: Property | None = None  # W/(m K)
    is_grease: bool = False

    def pressure_viscosity(self, viscosity: float, temperature: float) -> Property | None:
        """alpha, 1/Pa; viscosity : kinematic, m^2/s;  temperature : K. None: no readable source."""
        if self.modulus is not None:
            a_1, a_2 = self.modulus
            return self.law_known.property(1 / (a_1 + a_2 * temperature))
        return None if self.law is None else self.law_known.property(self.law.coefficient(viscosity))


def named_oil(given: str) -> KnownOil:
    """The oil or grease of that name. Raises InputError for an unknown name."""
    name = catalog.find("oils", given)
    if name is None:
        raise InputError(
            f"lubricant.name = {shown(given)} is not an oil of the catalog; near it are {', '.join(_near(given))}; or "
            'leave the name out and give its two viscosities and kind, for example viscosity = ["46 cSt at 40 degC", '
            '"6.8 cSt at 100 degC"] and base_oil = "mineral"'
        )
    row = catalog.rows("oils")[name]
    kind = KINDS.get(row["base oil"], row["base oil"])
    base = base_oil(kind if kind in catalog.rows("base_oils") else UNKNOWN_KIND)
    cold, printed = _value(row, "viscosity_40"), _cell(row, "viscosity_100")
    hot = _usual_hot_viscosity(cold) if printed is None else printed
    own: dict[str, Any] = {"line": viscosity_line(temperatures=(COLD, HOT), viscosities=(cold, hot))}
    if row["density status"]:
        known = Known(status="printed", source=row["source"])
        if row["density status"] != "printed":
            near = row["source"] if base.density is None else f"near that of {base.density.known.source}"
            known = Known(status="assumed", source=near, limit=DENSITY_LIMIT)
        own["density"] = Density(at_15=_value(row, "density_15"), slope=_value(row, "density_slope"), known=known)
    if _cell(row, "modulus_a1") is not None:
        own["modulus"] = _value(row, "modulus_a1"), _value(row, "modulus_a2")
        own["modulus_rise"] = _value(row, "modulus_b1"), _value(row, "modulus_b2")
        own["law_known"] = Known(status="printed", source=row["source"], limit=MEASURED_LIMIT)
    own |= _shear_and_conductivity(row, "printed", SHEAR_LIMIT)
    return replace(
        base,
        name=f"grease {name}" if row["kind"] == "grease" else name,
        source="; ".join(text for text in (row["source"], row["note"]) if text),
        hot_is_assumed=printed is None,
        is_class=row["viscosity status"] == "class",
        is_grease=row["kind"] == "grease",
        **own,
    )


def _usual_hot_viscosity(cold: float) -> float:
    """Kinematic viscosity at 100 degC of a mineral oil of the classes with this one at 40 degC, m^2/s.

    Interpolated in logarithms of both.
    """
    rows = [row for name, row in catalog.rows("oils").items() if name.endswith(" mineral")]
    both = np.log([(_value(row, "viscosity_40"), _value(row, "viscosity_100")) for row in rows])
    return float(np.exp(np.interp(np.log(cold), *both.T)))


def viscosities_of(name: str) -> list[str]:
    """The viscosities of an oil of the catalog at 40 and 100 degC, as a scene file has them."""
    line = named_oil(name).line
    assert line is not None
    return [f"{1e6 * line.kinematic_viscosity(at):.4g} cSt at {at - 273.15:g} degC" for at in (COLD, HOT)]


def assumed_properties(name: str) -> tuple[str, ...]:
    """What of an oil of the catalog is assumed, of its coefficient and its viscosity at 100 degC."""
    oil = named_oil(name)
    known = {"pressure_viscosity": oil.law_known.status != "assumed", "viscosity_100": not oil.hot_is_assumed}
    return tuple(each for each, is_known in known.items() if not is_known)


def _near(given: str) -> list[str]:
    """Names of the catalog that are like this one: of a class of ISO 3448 the nearest class."""
    names = {catalog.spelling(each): each for each in catalog.oil_names()}
    number = re.search(r"vg0*([1-9]\d*)", catalog.spelling(given))
    if number:
        classes = {each: int(found[1]) for each in names.values() if (found := re.match(r"ISO VG (\d+) ", each))}
        nearest = min(classes.values(), key=lambda grade: abs(log(grade) - log(int(number[1]))))
        return [each for each, grade in classes.items() if grade == nearest]
    near = get_close_matches(catalog.spelling(given), names, n=3, cutoff=0.4)
    return [names[each] for each in near] or ["ISO VG 46", "ISO VG 46 PAO", "FVA 3"]


def base_oil(name: str) -> KnownOil:
    """What oils of this kind have in common; name : one of catalog.rows("base_oils")."""
    row = catalog.rows("base_oils")[name]
    density, slope = _value(row, "density_15"), _value(row, "density_slope")
    assumed = Known(status="assumed", source=row["source"], limit=float(row["density_limit"]))
    status: Status = "assumed" if row["status"] == "assumed" else "derived"
    law = f"{row['factor [1/GPa]']} nu^{row['exponent']} 1/GPa, nu in mm2/s; {row['source']}"
    return KnownOil(
        name=f"{name} oil",
        density=Density(at_15=density, slope=slope, known=assumed),
        law=PressureViscosityLaw(factor=_value(row, "factor"), exponent=_value(row, "exponent")),
        law_known=Known(status=status, source=law, limit=float(row["coefficient_limit"])),
        modulus_rise=(_value(row, "modulus_b1"), _value(row, "modulus_b2")),
        traction_spread=float(row["traction_spread"]),
        **_shear_and_conductivity(row, "assumed", float(row["shear_limit"])),
    )


def _shear_and_conductivity(row: catalog.Row, status: Status, limit: float) -> dict[str, Any]:
    """Those that the row has."""
    read = row.get("status") != "assumed"
    source = "by the kind of oil, table 2 of [Arana2019]" if read else row["source"]
    shear = Known(status=status, source=source, limit=limit)
    conductivity = Known(status=status, source="table A1 of [Schwarz2023], of FVA 3")
    cells = {"limiting_shear": shear, "thermal_conductivity": conductivity}
    return {name: known.property(value) for name, known in cells.items() if (value := _cell(row, name)) is not None}


def _value(row: catalog.Row, column: str) -> float:
    """The value of a cell in SI, by the unit in the name of its column."""
    title = next(title for title in row if title.partition(" [")[0] == column)
    unit = title.partition(" [")[2].rstrip("]")
    return in_si(row[title], unit) if unit else float(row[title])


def _cell(row: catalog.Row, column: str) -> float | None:
    """The same; None if the cell is empty."""
    return _value(row, column) if next(row[title] for title in row if title.partition(" [")[0] == column) else None
