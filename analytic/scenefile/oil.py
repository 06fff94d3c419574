"""The oil of a scene: an oil of the catalog by its name, two viscosities, or every number; keys that are given win."""

from collections.abc import Mapping
from dataclasses import replace
from math import hypot, log, sqrt
from typing import Any

from analytic.declared import read_only
from analytic.errors import InputError
from analytic.oil.viscosity_temperature import ViscosityLine, viscosity_line
from analytic.scene import Lubricant, Reach
from analytic.scenefile.keys import GivenLength, Values
from analytic.scenefile.known_oil import (
    COLD,
    DENSITY_LIMIT,
    HOT,
    HOT_LIMIT,
    Density,
    Known,
    KnownOil,
    Property,
    base_oil,
    named_oil,
)
from analytic.scenefile.law_packages import BUILT_IN, installed_law
from analytic.scenefile.viscosity import GivenViscosity, ViscosityPoint
from analytic.words import length_of

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
GIVEN = Known(status="given", source="the scene")
TYPICAL = Known(status="assumed", source="typical of mineral oils near 40 degC, no source seen")
BLED_TENSION = 0.022  # N/m, between those of two greases
BLED = Known(status="assumed", source="between 0.017 and 0.028 N/m of two greases at 61 degC [Shetty2024]", limit=0.25)
PROPERTIES = (*EXAMPLES, "viscosity", "limiting_shear", "thermal_conductivity")


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
    if given.get("supply", "grease" if oil.is_grease else "") == "grease":
        tension = given.get("surface_tension")
        properties["surface_tension"] = BLED.property(BLED_TENSION) if tension is None else GIVEN.property(tension)
    if "eyring_stress" in given:
        properties["eyring_stress"] = GIVEN.property(given["eyring_stress"])
    choices: dict[str, Any] = {"traction": "eyring_sinh", "supply": "grease" if oil.is_grease else "oil_bath"}
    others = "thickening", "starvation_degree", "cavitation_pressure", "compressible", "film_formula", "rolling_formula"
    choices |= {key: given[key] for key in (*choices, *others) if key in given}
    if choices["traction"] not in BUILT_IN:
        choices["traction"] = installed_law(choices["traction"])
    return Lubricant(
        **{key: each.value for key, each in properties.items()},
        viscosity_temperature=_slope(given, line, oil, reference),
        reference_temperature=reference,
        temperature=temperature,
        modulus_rise=oil.modulus_rise,
        traction_spread=oil.traction_spread,
        name=oil.name if "name" in given and viscosity is None else "",
        origins=read_only({key: each.origin for key, each in properties.items()}),
        reach=_reach(values, ball_radius),
        **choices,
    )


def _reach(values: Values, ball_radius: float) -> Reach:
    def share(key: str) -> float:
        given: float | GivenLength = values[f"lubricant.reach.{key}"]
        if not isinstance(given, GivenLength):
            return given
        if given.metres > ball_radius:
            raise InputError(
                f"lubricant.reach.{key} of {length_of(given.metres)} is beyond the ball's radius, "
                f"{length_of(ball_radius)}: give at most that"
            )
        return given.metres / ball_radius

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
