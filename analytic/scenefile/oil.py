"""The oil of a scene: an oil of the catalog by its name, two viscosities, or every number; keys that are given win."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from difflib import get_close_matches
from math import hypot, log, sqrt
from typing import Any

import numpy as np

from analytic import catalog
from analytic.declared import read_only
from analytic.errors import InputError
from analytic.oil.viscosity_temperature import PressureViscosityLaw, ViscosityLine, viscosity_line
from analytic.quantity import SI, in_si
from analytic.scene import Lubricant, Origin, Reach, Status
from analytic.scenefile.keys import Values
from analytic.scenefile.kinds import GivenViscosity, ViscosityPoint
from analytic.scenefile.law_packages import BUILT_IN, installed_law
from analytic.words import length_of, shown

COLD, HOT = 313.15, 373.15  # K: where the catalog's viscosities are given
DENSITY_AT = 288.15  # K: where its densities are given
# Limits, over the value.
DENSITY_LIMIT = 0.03  # an assumed density: mineral base oils are some 850 to 900 kg/m^3
MEASURED_LIMIT = 0.05  # a measured pressure-viscosity coefficient; two laboratories differ by 8 %
SHEAR_LIMIT = 0.10  # traction by the limiting shear of [Arana2019] was within 10 % of tests
HOT_LIMIT = 0.20  # an assumed viscosity at 100 degC: indices of 95 and 140 differ by 18 % in VG 46
KINDS = {"diester": "ester"}  # other names of kinds of base oil
UNKNOWN_KIND = "not known"
DEFAULTS = {  # typical of mineral oils near 40 degC (no source seen)
    "limiting_shear": 0.065,
    "viscosity_temperature": 0.045,  # 1/K
    "thermal_conductivity": 0.14,  # W/(m K)
    "density": 870.0,  # kg/m^3
}
EXAMPLES = {"density": '"900 kg/m^3"', "pressure_viscosity": '"2e-8 1/Pa"'}
# Limits, over the value.
CLASS_LIMIT = 0.10  # a class of ISO 3448, at 40 degC
INDEX_LIMIT = 0.05  # at 100 degC: some ten points of an assumed viscosity index; in proportion at other temperatures
FAR = 0.05  # limit by the line alone, of a temperature that is said to be beyond it
PROPERTIES = (*EXAMPLES, "viscosity", "limiting_shear", "thermal_conductivity")


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


GIVEN = Known(status="given", source="the scene")
TYPICAL = Known(status="assumed", source="typical of mineral oils near 40 degC, no source seen")
BLED = Known(status="assumed", source="between 0.017 and 0.028 N/m of two greases at 61 degC [Shetty2024]", limit=0.25)


def lubricant_of(values: Values, *, ball_radius: float) -> Lubricant:
    """The lubricant of a scene; ball_radius : m, over which lengths of the reach become shares.

    Raises InputError, in one line, for an unknown name, for keys in conflict, for a temperature beyond the oil's data,
    and for what neither the keys nor the catalog gives.
    """
    given = {key.partition(".")[2]: value for key, value in values.items() if key.startswith("lubricant.")}
    _refuse_conflicts(given)
    if "name" in given:
        oil = named_oil(given["name"])
    else:
        oil = base_oil(given["base_oil"]) if "base_oil" in given else KnownOil(name="")
    viscosity: GivenViscosity | None = given.get("viscosity")
    own = None if viscosity is None else viscosity.temperature
    if "name" in given or (viscosity is not None and viscosity.is_pair):
        temperature = reference = given.get("temperature", COLD if own is None else own)
    else:
        reference = given.get("reference_temperature", COLD) if own is None else own
        temperature = given.get("temperature", reference)

    own = {key: GIVEN.property(given[key]) for key in PROPERTIES if key in given and key != "viscosity"}
    found = {"limiting_shear": oil.limiting_shear, "thermal_conductivity": oil.thermal_conductivity} | own
    density = _density(given, oil, reference)
    line = _given_line(given, oil) or oil.line
    if density is not None:
        found["density"] = density
        found["viscosity"] = eta = _viscosity(given, oil, line, density, reference)
        if "pressure_viscosity" not in own:
            found["pressure_viscosity"] = oil.pressure_viscosity(eta.value / density.value, reference)
    missing = [key for key in EXAMPLES if found.get(key) is None]
    if missing:
        reason = f": no sourced value for {oil.name}" if "name" in given else ""
        raise InputError(
            "; ".join(f"lubricant.{key} is missing{reason}; give for example {EXAMPLES[key]}" for key in missing)
        )
    properties = {key: found[key] or TYPICAL.property(DEFAULTS[key]) for key in PROPERTIES}
    supply = given.get("supply", "grease" if oil.is_grease else "oil_bath")
    if supply == "grease":
        tension = given.get("surface_tension")
        usual = BLED.property(Lubricant.surface_tension)
        properties["surface_tension"] = usual if tension is None else GIVEN.property(tension)
    if "eyring_stress" in given:
        properties["eyring_stress"] = GIVEN.property(given["eyring_stress"])
    traction = values["lubricant.traction"]
    of_oil = {
        "viscosity_temperature": _slope(given, line, oil, reference),
        "reference_temperature": reference,
        "temperature": temperature,
        "modulus_rise": oil.modulus_rise,
        "traction_spread": oil.traction_spread,
        "name": oil.name if "name" in given and viscosity is None else "",
        "origins": read_only({key: each.origin for key, each in properties.items()}),
        "supply": supply,
        "traction": traction if traction in BUILT_IN else installed_law(traction),
        "reach": _reach(values, ball_radius),
        "surface_tension": Lubricant.surface_tension,
    } | {key: each.value for key, each in properties.items()}
    return Lubricant(**values.fields(Lubricant, "lubricant", **of_oil))


def _reach(values: Values, ball_radius: float) -> Reach:
    def share(key: str) -> float:
        given: float = values[f"lubricant.reach.{key}"]
        if not isinstance(given, SI):  # a length
            return given
        if given > ball_radius:
            raise InputError(
                f"lubricant.reach.{key} of {length_of(given)} is beyond the ball's radius, "
                f"{length_of(ball_radius)}: give at most that"
            )
        return given / ball_radius

    return Reach(ahead=share("ahead"), behind=share("behind"))


def _refuse_conflicts(given: Mapping[str, Any]) -> None:
    viscosity: GivenViscosity | None = given.get("viscosity")
    if viscosity is None and "name" not in given:
        raise InputError(
            'lubricant.viscosity is missing; give for example "0.06 Pa s", or ["46 cSt at 40 degC", "6.8 cSt at '
            '100 degC"] with density, or name = "ISO VG 46" alone'
        )
    if given.get("traction") == "eyring_constant" and "eyring_stress" not in given:
        raise InputError(
            'lubricant.eyring_stress is missing: with traction = "eyring_constant" the oil shears at this stress; give '
            'for example "5 MPa", or leave traction out'
        )
    if "name" in given and "base_oil" in given:
        raise InputError(
            "lubricant.base_oil goes with viscosity; the oil of lubricant.name has its own, so leave it out"
        )
    has_temperatures = viscosity is not None and viscosity.is_pair
    if "reference_temperature" in given and ("name" in given or has_temperatures):
        owner = "lubricant.name" if "name" in given else "lubricant.viscosity with two temperatures"
        raise InputError(
            f"lubricant.reference_temperature does not go with {owner}, which is known at every temperature; give "
            "temperature alone"
        )
    own = None if viscosity is None else viscosity.temperature
    if own is not None and "reference_temperature" in given:
        raise InputError(
            "lubricant.reference_temperature and the temperature in lubricant.viscosity say the same; "
            "leave one of them out"
        )
    if viscosity is not None and viscosity.is_kinematic and own is None and not viscosity.is_pair and "name" in given:
        raise InputError(
            f"lubricant.viscosity = {viscosity.text} has no temperature beside lubricant.name: "
            'write for example "46 cSt at 40 degC", or leave it out'
        )
    if viscosity is not None and own is not None and "name" in given and given.get("temperature", own) != own:
        raise InputError(
            f"lubricant.viscosity = {viscosity.text} is not at lubricant.temperature, "
            f"{given['temperature'] - 273.15:.4g} degC: give it at that temperature, give two at two temperatures, or "
            "leave out the name"
        )
    is_density_known = "density" in given or "name" in given or "base_oil" in given
    if viscosity is not None and viscosity.is_kinematic and not is_density_known:
        raise InputError(
            f"lubricant.viscosity = {viscosity.text} is kinematic, so lubricant.density is missing; give for example "
            '"870 kg/m^3" (or base_oil = "mineral"), or a viscosity in Pa s, for example "0.06 Pa s"'
        )


def _density(given: Mapping[str, Any], oil: KnownOil, temperature: float) -> Property | None:
    """None for an oil whose kinematic viscosity is known and whose density is not."""
    if "density" in given:
        return GIVEN.property(given["density"])
    if oil.density is not None:
        return oil.density.known.property(oil.density.at(temperature))
    if "name" in given and not _has_dynamic_viscosity(given):
        return None
    return replace(TYPICAL, limit=DENSITY_LIMIT).property(DEFAULTS["density"])


def _has_dynamic_viscosity(given: Mapping[str, Any]) -> bool:
    return "viscosity" in given and not given["viscosity"].is_kinematic


def _given_line(given: Mapping[str, Any], oil: KnownOil) -> ViscosityLine | None:
    """The line through two given viscosities; a dynamic one is divided by the density at its temperature."""
    viscosity: GivenViscosity | None = given.get("viscosity")
    if viscosity is None or not viscosity.is_pair:
        return None
    (first, first_nu), (second, second_nu) = ((p.temperature, _kinematic(given, oil, p)) for p in viscosity.points)
    assert first is not None  # the reader refuses a pair without temperatures
    assert second is not None
    try:
        return viscosity_line(temperatures=(first, second), viscosities=(first_nu, second_nu))
    except InputError as problem:
        raise InputError(f"lubricant.{problem}") from problem


def _kinematic(given: Mapping[str, Any], oil: KnownOil, point: ViscosityPoint) -> float:
    """m^2/s."""
    if point.is_kinematic or point.temperature is None:
        return point.value
    density = _density(given, oil, point.temperature)
    return point.value / (DEFAULTS["density"] if density is None else density.value)


def _viscosity(
    given: Mapping[str, Any], oil: KnownOil, line: ViscosityLine | None, density: Property, temperature: float
) -> Property:
    viscosity: GivenViscosity | None = given.get("viscosity")
    if viscosity is not None and not viscosity.is_pair:
        (point,) = viscosity.points
        value = point.value * density.value if point.is_kinematic else point.value
        return GIVEN.property(value)
    assert line is not None  # of a name, or of two viscosities
    try:
        nu = line.kinematic_viscosity(temperature)
    except InputError as problem:
        raise InputError(f"lubricant.{problem}") from problem
    cold = sqrt(3) * line.deviation(temperature)  # a limit, as those of rectangular distributions
    far = f"; extrapolated to {temperature - 273.15:.3g} degC" if cold > FAR else ""
    if viscosity is not None:
        known = Known(
            status="derived",
            source=f"two viscosities of the scene, ASTM D341{far}",
            limit=hypot(CLASS_LIMIT, cold) if far else None,
        )
        return known.property(nu * density.value)
    limit = hypot(CLASS_LIMIT, cold) if far else None
    source = f"{oil.name}: {oil.source}"
    away = log(temperature / COLD) / log(HOT / COLD)
    if oil.is_class:
        limit = hypot(CLASS_LIMIT, INDEX_LIMIT * away, DENSITY_LIMIT, cold)
        source += "; the limits of the class are +-10 % at 40 degC"
    at_a_print = abs(temperature - COLD) < 0.01
    if oil.hot_is_assumed and not at_a_print:
        limit = hypot(HOT_LIMIT * away, cold)
        source += f"; at 100 degC as mineral oils of a viscosity index of 95, assumed{far}"
        return Known(status="assumed", source=source, limit=limit).property(nu * density.value)
    at_a_print |= abs(temperature - HOT) < 0.01 and not oil.is_class and not oil.hot_is_assumed
    known = Known(status="printed", source=source, limit=limit)
    if not at_a_print:
        known = Known(status="derived", source=f"{source}; ASTM D341{far}", limit=limit)
    return known.property(nu * density.value)


def _slope(given: Mapping[str, Any], line: ViscosityLine | None, oil: KnownOil, temperature: float) -> float:
    """-d ln(eta)/dT: that of the kinematic viscosity and that of the density."""
    if "viscosity_temperature" in given:
        return given["viscosity_temperature"]
    if line is None or not line.coldest <= temperature <= line.hottest:
        return DEFAULTS["viscosity_temperature"]
    density: Density | None = None if "density" in given else oil.density
    thermal = 0.0 if density is None else -density.slope / density.at(temperature)
    return line.temperature_slope(temperature) + thermal
