"""Oils by name, by two viscosities and by numbers, in scenes and from Python; laws of traction of packages."""

import sys
from collections.abc import Iterator
from math import log, sqrt
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import analytic
from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Lubricant, OwnTraction
from analytic.scenefile.law_packages import installed_law
from analytic.scenefile.oil import assumed_properties
from tests.analytic.scenefile.scene_texts import OIL, PLAIN, refusal, scene
from tests.analytic.specimens import present
from tests.traction_packages import install, install_example

WARM = 343.15  # K


def oil(text: str) -> Lubricant:
    return present(scene(f"{PLAIN}[lubricant]\n{text}").lubricant)


def refused(text: str) -> str:
    return refusal(f"{PLAIN}[lubricant]\n{text}")


def test_a_named_oil_is_that_of_the_prints() -> None:
    named = oil('name = "ISO VG 46"')
    assert named.name == "ISO VG 46 mineral"
    # 46 mm2/s at 40 degC (ISO 3448), 875 kg/m3 at 15 degC less 0.6 for each kelvin; 12.45 46^0.113 1/GPa.
    assert named.density == pytest.approx(860.0, rel=1e-12)  # round-off
    assert named.viscosity == pytest.approx(46e-6 * 860.0, rel=1e-12)
    assert named.pressure_viscosity == pytest.approx(12.45e-9 * 46**0.113, rel=1e-12)
    assert named.eyring_stress is None  # it follows from the limiting shear and the pressure
    assert (named.modulus_rise, named.traction_spread) == ((-68.2e-3, 27.68e-5), 0.15)
    assert (named.limiting_shear, named.thermal_conductivity, named.supply) == (0.047, 0.134, "oil_bath")
    assert (named.temperature, named.reference_temperature) == (313.15, 313.15)


@pytest.mark.parametrize("name", ["VG46", "iso vg 46", "ISO-VG46", "ISO VG 46 mineral", "Iso Vg 46 Mineral"])
def test_the_spelling_of_a_name_does_not_matter(name: str) -> None:
    assert oil(f'name = "{name}"') == oil('name = "ISO VG 46"') != oil('name = "VG 46 PAO"')


def test_no_two_oils_share_a_spelling() -> None:
    spellings = [catalog.spelling(name) for name in catalog.oil_names()]
    assert len(spellings) > 50
    assert len(set(spellings)) == len(spellings)


@pytest.mark.parametrize("name", ["ISO VG 46", "FVA 3", "PAO100", "SKF GJN"])
def test_the_slope_is_the_derivative_of_the_viscosity(name: str) -> None:
    step = 0.02  # K: the third derivative leaves 1e-8 of it, round-off 1e-12
    either = [analytic.lubricant(name, temperature=WARM + side * step).viscosity for side in (-1, 1)]
    slope = float(np.log(either[0] / either[1])) / (2 * step)
    assert analytic.lubricant(name, temperature=WARM).viscosity_temperature == pytest.approx(slope, rel=1e-7)


def test_keys_of_the_scene_win() -> None:
    own = oil('name = "vg46"\npressure_viscosity = "15 1/GPa"\ndensity = "0.9 g/cm^3"\nsupply = "grease"')
    assert (own.pressure_viscosity, own.density, own.supply) == (15e-9, 900.0, "grease")
    assert own.viscosity == pytest.approx(46e-6 * 900, rel=1e-12)
    assert own.origins["pressure_viscosity"].status == "given"
    assert oil('name = "vg46"\neyring_stress = "6 MPa"').eyring_stress == 6e6


def test_two_viscosities_give_one_at_any_temperature() -> None:
    numbers = 'pressure_viscosity = "2e-8 1/Pa"\neyring_stress = "5 MPa"\ntemperature = "70 degC"\n'
    kinematic = oil(f'viscosity = ["46 cSt at 40 degC", "6.65 mm2/s at 100 degC"]\ndensity = "842 kg/m^3"\n{numbers}')
    named = analytic.lubricant("ISO VG 46", temperature=WARM)  # has the same two viscosities, and this density
    assert kinematic.viscosity == pytest.approx(named.viscosity, rel=1e-12)
    assert (kinematic.origins["viscosity"].status, kinematic.supply) == ("derived", "oil_bath")
    assert (kinematic.reference_temperature, kinematic.temperature) == (WARM, WARM)
    dynamic = oil(
        f'viscosity = ["38.732 mPa s at 40 degC", "5.5993 mPa s at 100 degC"]\ndensity = "842 kg/m^3"\n{numbers}'
    )
    assert dynamic.viscosity == pytest.approx(named.viscosity, rel=1e-9)  # five digits of the first, exact products


def test_a_base_oil_gives_what_follows_from_the_viscosity() -> None:
    own = oil(
        'viscosity = ["46 cSt at 40 degC", "6.65 cSt at 100 degC"]\nbase_oil = "mineral"\ntemperature = "70 degC"'
    )
    named = analytic.lubricant("ISO VG 46", temperature=WARM)
    assert own.pressure_viscosity == pytest.approx(named.pressure_viscosity, rel=1e-12)
    assert (own.limiting_shear, own.origins["pressure_viscosity"].status) == (0.047, "derived")
    single = oil('viscosity = "46 cSt"\nbase_oil = "PAO"\ndensity = "820 kg/m^3"')
    assert single.viscosity == pytest.approx(46e-6 * 820, rel=1e-12)
    assert single.pressure_viscosity == pytest.approx(7.40e-9 * 46**0.162, rel=1e-12)


def test_one_viscosity_may_have_its_temperature() -> None:
    rest = 'density = "850 kg/m^3"\nbase_oil = "mineral"\ntemperature = "70 degC"\n'
    own = oil(f'viscosity = "30 cSt at 50 degC"\n{rest}')
    assert own == oil(f'viscosity = "30 cSt"\nreference_temperature = "50 degC"\n{rest}')
    assert own.viscosity == pytest.approx(30e-6 * 850, rel=1e-12)
    assert (own.reference_temperature, own.temperature) == (323.15, WARM)
    named = oil('name = "vg46"\nviscosity = "9 mPa s at 80 degC"')
    assert (named.viscosity, named.temperature) == (9e-3, pytest.approx(353.15))


def test_python_takes_units_and_an_oil_of_ones_own() -> None:
    assert analytic.lubricant("vg46", temperature="70 degC") == analytic.lubricant("vg46", temperature=WARM)
    own = analytic.lubricant(viscosity=0.03, density="0.87 g/cm^3", base_oil="mineral")
    assert own == oil('viscosity = "30 mPa s"\ndensity = "870 kg/m^3"\nbase_oil = "mineral"')
    pair = ["46 cSt at 40 degC", "6.65 cSt at 100 degC"]
    assert analytic.lubricant(viscosity=pair, base_oil="PAO") == oil(f'viscosity = {pair}\nbase_oil = "PAO"')


def test_an_oil_without_a_line_takes_a_viscosity_at_its_temperature() -> None:
    """Of a grease with a printed viscosity at 40 degC alone: that at 100 degC is assumed, as of mineral oils."""
    dense = 'density = "0.9 g/cm^3"\n'
    assert oil(f'name = "NSK MTE"\n{dense}').viscosity == pytest.approx(23e-6 * 900, rel=1e-12)
    warm = f'name = "NSK MTE"\ntemperature = "70 degC"\n{dense}'
    assert oil(f'{warm}viscosity = "7 mPa s"').viscosity == 7e-3
    found = oil(warm)
    origin = found.origins["viscosity"]
    assert origin.status == "assumed"
    # 20 % at 100 degC, in proportion to the logarithm of the temperature; as a rectangular distribution.
    share = 0.20 * log(343.15 / 313.15) / log(373.15 / 313.15)
    assert present(origin.uncertainty) == pytest.approx(share * found.viscosity / sqrt(3), rel=1e-9)


def test_a_class_is_less_certain_away_from_40_degrees() -> None:
    """10 % of the class, 5 % at 100 degC by its index and 3 % of the density, as limits, in proportion to ln T."""
    for temperature in (293.15, WARM, 373.15):
        read = analytic.lubricant("ISO VG 46", temperature=temperature)
        away = log(temperature / 313.15) / log(373.15 / 313.15)
        cold = 0.26 * (max(313.15 - temperature, 0.0) / 60) ** 4  # of the line below 40 degC, a standard deviation
        limit = sqrt(0.1**2 + (0.05 * away) ** 2 + 0.03**2 + 3 * cold**2)
        origin = read.origins["viscosity"]
        assert present(origin.uncertainty) == pytest.approx(limit * read.viscosity / sqrt(3), rel=1e-9)
        assert (origin.status, "ASTM D341" in origin.source) == ("derived", True)


@pytest.mark.parametrize(
    "text", ['name = "ISO VG 46"', 'name = "FVA 3"', 'viscosity = ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]\n'
             'base_oil = "mineral"'],
)  # fmt: skip
def test_a_cold_oil_is_less_certain_the_colder_it_is(text: str) -> None:
    """0.26 (4/3)^4 of the logarithm at -40 degC, and (3/4)^4 of it at -20 degC, beside limits of 10 to 14 %."""
    for celsius, line in ((-20.0, 0.26), (-40.0, 0.26 * (4 / 3) ** 4)):
        read = oil(f'{text}\ntemperature = "{celsius} degC"')
        origin = read.origins["viscosity"]
        rest = (present(origin.uncertainty) / read.viscosity) ** 2 - line**2
        assert 0.09**2 / 3 < rest < 0.14**2 / 3
        assert f"extrapolated to {celsius:g} degC" in origin.source


@pytest.mark.parametrize(
    ("name", "celsius", "status"),
    [
        ("FVA 3", 40.0, "printed"),
        ("FVA 3", 100.0, "printed"),
        ("FVA 3", 99.0, "derived"),
        ("ISO VG 46", 40.0, "printed"),
        ("ISO VG 46", 100.0, "derived"),  # a class has no print there
        ("NSK MTE", 40.0, "printed"),
        ("NSK MTE", 100.0, "assumed"),
    ],
)
def test_a_viscosity_is_printed_where_its_print_is(name: str, celsius: float, status: str) -> None:
    origin = analytic.lubricant(name, temperature=celsius + 273.15, density=870.0).origins["viscosity"]
    assert origin.status == status
    has_limit = name == "ISO VG 46" or status == "assumed"
    assert (origin.uncertainty is not None) == has_limit


def test_a_constant_stress_has_to_be_given() -> None:
    numbers = 'viscosity = "60 mPa s"\npressure_viscosity = "2e-8 1/Pa"\n'
    assert "lubricant.eyring_stress is missing" in refused(numbers + 'traction = "eyring_constant"')
    assert oil(f'{numbers}traction = "eyring_constant"\neyring_stress = "5 MPa"').eyring_stress == 5e6
    assert oil(numbers).eyring_stress is None
    assert oil(f'{numbers}thickening = "roelands"').thickening == "roelands"


def test_grease_has_the_surface_tension_of_its_oil() -> None:
    """That of greases by default, within a quarter; an oil has none that counts."""
    bled = oil('name = "SKF GJN"')
    origin = bled.origins["surface_tension"]
    assert (bled.surface_tension, origin.status) == (0.022, "assumed")
    assert present(origin.uncertainty) == pytest.approx(0.022 * 0.25 / sqrt(3), rel=1e-12)
    given = oil('name = "SKF GJN"\nsurface_tension = "0.027 N/m"')
    assert (given.surface_tension, given.origins["surface_tension"].status) == (0.027, "given")
    assert "surface_tension" in oil('name = "vg46"\nsupply = "grease"').origins
    for text in ('name = "vg46"', 'name = "SKF GJN"\nsupply = "oil_spot"'):
        assert "surface_tension" not in oil(text).origins


def test_a_dynamic_viscosity_needs_no_density() -> None:
    """Of a name whose density nobody prints the usual one is taken; a kinematic one is refused without it."""
    assert oil('name = "NSK MTE"\nviscosity = "20 mPa s"').viscosity == 0.02
    numbers = 'pressure_viscosity = "2e-8 1/Pa"\neyring_stress = "5 MPa"'
    single = oil(f'viscosity = "60 mPa s"\n{numbers}')
    origin = single.origins["density"]
    assert (single.density, origin.status) == (870.0, "assumed")
    assert present(origin.uncertainty) == pytest.approx(0.03 * 870.0 / sqrt(3), rel=1e-12)
    pair = oil(f'viscosity = ["40.02 mPa s at 40 degC", "5.7855 mPa s at 100 degC"]\n{numbers}')
    same = oil(f'viscosity = ["46 cSt at 40 degC", "6.65 cSt at 100 degC"]\ndensity = "870 kg/m^3"\n{numbers}')
    assert pair.viscosity == pytest.approx(same.viscosity, rel=1e-9)


def test_a_density_falls_from_15_degrees_on() -> None:
    """875 kg/m3 of the row of its class at 15 degC, and 0.6 for each kelvin; 3 % are its limit."""
    for celsius in (15.0, 70.0):
        read = analytic.lubricant("ISO VG 46", temperature=celsius + 273.15)
        assert read.density == pytest.approx(875.0 - 0.6 * (celsius - 15.0), rel=1e-12)
        origin = read.origins["density"]
        assert present(origin.uncertainty) == pytest.approx(0.03 * read.density / sqrt(3), rel=1e-9)
    printed = analytic.lubricant("FVA 3").origins["density"]
    assert (printed.status, printed.uncertainty) == ("printed", None)


def test_the_viscosity_that_nobody_prints_is_that_between_two_classes() -> None:
    """ln nu at 100 degC over ln nu at 40 degC, of the mineral classes of 22 and 32 around 23 mm2/s."""
    thin, thick = (
        float(catalog.rows("oils")[f"ISO VG {grade} mineral"]["viscosity_100 [mm^2/s]"]) for grade in (22, 32)
    )
    share = log(23 / 22) / log(32 / 22)
    expected = thin ** (1 - share) * thick**share
    found = analytic.lubricant("NSK MTE", temperature=373.15, density=900.0).viscosity
    assert found == pytest.approx(expected * 900e-6, rel=1e-9)


MESSAGES = [
    ('name = "ISO VG 48"', ("lubricant.name = 'ISO VG 48'", "near it are", "ISO VG 46 mineral")),
    ('name = "vg46"\ntemperature = "160 degC"', ("lubricant.temperature must be -40 to 140 degC", "got 160 degC")),
    ('name = "vg46"\nreference_temperature = "50 degC"', ("lubricant.reference_temperature", "lubricant.name")),
    ('name = "vg46"\nbase_oil = "PAO"', ("lubricant.base_oil", "leave it out")),
    ('base_oil = "PAO"', ("lubricant.viscosity is missing", 'name = "ISO VG 46"')),
    ('viscosity = "60 cSt"',
        ("lubricant.viscosity = '60 cSt' is kinematic", "lubricant.density is missing", "870 kg/m^3")),
    ('viscosity = "46 cSt at 40 degC"\nbase_oil = "PAO"\nreference_temperature = "40 degC"',
        ("lubricant.reference_temperature", "say the same", "leave one of them out")),
    ('name = "vg46"\nviscosity = "9 mPa s at 80 degC"\ntemperature = "70 degC"',
        ("lubricant.viscosity = '9 mPa s at 80 degC' is not at lubricant.temperature, 70 degC",)),
    ('name = "my oil"',
        ("two viscosities", 'viscosity = ["46 cSt at 40 degC", "6.8 cSt at 100', 'base_oil = "mineral"')),
    ('viscosity = ["46 cSt at 40 degC", "6.8 cSt"]', ("lubricant.viscosity", "has no temperature", "at 100 degC")),
    ('viscosity = ["46 cSt at 40 degC"]', ("lubricant.viscosity", "not one viscosity or two")),
    ('viscosity = ["46 cSt at 40 s", "6.8 cSt at 100 degC"]', ("lubricant.viscosity", "unit like degC")),
    ('viscosity = ["46 cSt at 40 degC", "68 cSt at 100 degC"]\nbase_oil = "PAO"',
        ("lubricant.viscosity must fall with the temperature", "68 mm2/s at 100 degC")),
    ('viscosity = ["46 cSt at 40 degC", "7 cSt at 100 degC"]\nbase_oil = "PAO"\nreference_temperature = "50 degC"',
        ("lubricant.reference_temperature", "two temperatures", "give temperature alone")),
    ('name = "vg46"\nviscosity = "46 cSt"', ("lubricant.viscosity = '46 cSt' has no temperature beside",)),
    ('viscosity = ["46 cSt at 40 degC", "7 cSt at 100 degC"]\npressure_viscosity = "2e-8 1/Pa"',
        ("is kinematic, so lubricant.density is missing",)),
]  # fmt: skip


@pytest.mark.parametrize(("text", "words"), MESSAGES)
def test_a_mistake_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    message = refused(text)
    assert message.isprintable()
    assert [word for word in words if word not in message] == [], message


def test_mistakes_from_python_are_named_too() -> None:
    misspelt: Any = {"viscositty": 0.03}
    with pytest.raises(InputError, match=r"lubricant\.density = 87.0 kg/m\^3 must be at least 100 kg/m\^3"):
        analytic.lubricant("vg46", density=87.0)
    with pytest.raises(InputError, match=r"lubricant\.viscositty is no key.*did you mean"):
        analytic.lubricant("vg46", **misspelt)
    with pytest.raises(InputError, match=r"lubricant\.supply = 'pump'"):
        analytic.lubricant("vg46", supply="pump")
    with pytest.raises(InputError, match=r"lubricant\.temperature must be -40 to 140 degC"):
        analytic.lubricant("vg46", temperature=450.0)


@pytest.mark.parametrize("name", catalog.oil_names())
def test_every_oil_of_the_catalog_is_read(name: str) -> None:
    more: dict[str, Any] = {"pressure_viscosity": 2e-8, "eyring_stress": 5e6, "density": 850.0}
    read = analytic.lubricant(name, **more)
    # Within what the row says at 40 degC: the class, or the base oil of the grease.
    assert read.viscosity == pytest.approx(
        float(catalog.rows("oils")[name]["viscosity_40 [mm^2/s]"]) * 850e-6, rel=1e-9
    )
    row = catalog.rows("oils")[name]
    complete = analytic.lubricant(name)
    assert 7e-9 < complete.pressure_viscosity < 30e-9
    at_ambient = 2 * complete.limiting_shear / complete.pressure_viscosity
    assert 3e6 < at_ambient < 10e6  # 3 to 8 MPa were published, of mineral oils and PAO
    is_assumed = complete.origins["pressure_viscosity"].status == "assumed"
    assert is_assumed == ("pressure_viscosity" in assumed_properties(name))
    if row["base oil"] in ("mineral", "naphthenic", "PAO"):
        assert not assumed_properties(name)


def test_a_kind_that_nobody_names_has_limits_that_hold_the_known_kinds() -> None:
    for grade in (10, 46, 220):
        nu = f'viscosity = "{grade} cSt"\n'
        kinds = "not known", "mineral", "naphthenic", "PAO", "ester"
        unknown, *known = (oil(f'{nu}base_oil = "{kind}"') for kind in kinds)
        for name in ("pressure_viscosity", "density", "limiting_shear"):
            half = present(unknown.origins[name].uncertainty) * sqrt(3)
            assert all(abs(getattr(each, name) - getattr(unknown, name)) <= half for each in known), (grade, name)


def test_the_slope_of_a_given_density_is_that_of_the_line_alone() -> None:
    """Else the density falls by 0.6 kg/m3 for each kelvin, of 842 at 70 degC."""
    given: Any = {"density": 842.0}
    with_, alone = (analytic.lubricant("ISO VG 46", temperature=WARM, **more) for more in ({}, given))
    assert with_.viscosity == pytest.approx(alone.viscosity, rel=1e-12)
    difference = with_.viscosity_temperature - alone.viscosity_temperature
    assert difference == pytest.approx(0.6 / 842.0, rel=1e-9)
    given = oil('name = "vg46"\nviscosity_temperature = "0.031 1/K"')
    assert given.viscosity_temperature == 0.031
    numbers = 'pressure_viscosity = "2e-8 1/Pa"\neyring_stress = "5 MPa"'
    assert oil(f'viscosity = "60 mPa s"\n{numbers}').viscosity_temperature == 0.045


@pytest.fixture
def packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of the path, for packages of one test."""
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "odd_laws", raising=False)
    installed_law.cache_clear()
    yield tmp_path
    installed_law.cache_clear()


def by(name: str) -> str:
    return OIL.replace("eyring_sinh", name)


def test_a_scene_names_the_law_of_a_package(packages: Path) -> None:
    install_example(packages)
    law = present(scene(by("carreau-squalane")).lubricant).traction
    assert isinstance(law, OwnTraction)
    assert (law.name, law.distribution, law.version) == ("carreau-squalane", "carreau-law", "0.1.0")
    named = analytic.lubricant("ISO VG 68", temperature=330.0, traction="carreau-squalane")
    assert named.traction == law


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("def law(x):\n    return x / (1 + x * x)\n", ("law of traction odd", "falls", "never falls")),
        ("import no_such_module_anywhere\n", ("odd-laws 0.3", "ModuleNotFoundError", "correct the package")),
        ("raise RuntimeError('two\\nlines')\n", ("odd-laws 0.3", "RuntimeError: two lines")),
        ("def other(x):\n    return x\n", ("odd-laws 0.3", "AttributeError", "correct the package")),
        ("law = 0.7\n", ("odd_laws:law of odd-laws 0.3 is float", "give a function")),
    ],
)
def test_a_package_without_a_law_is_refused_in_one_line(packages: Path, code: str, words: tuple[str, ...]) -> None:
    install(packages, "odd-laws", "0.3", {"odd": "odd_laws:law"})
    (packages / "odd_laws.py").write_text(code, "utf-8")
    message = refusal(by("odd"))
    assert "\n" not in message
    assert [word for word in words if word not in message] == []


def test_a_name_that_two_packages_give_is_refused(packages: Path) -> None:
    for name in ("first-laws", "second-laws"):
        install(packages, name, "1.0", {"mine": "math:asinh"})
    message = refusal(by("mine"))
    assert "first-laws 1.0" in message
    assert "second-laws 1.0" in message
    assert "remove all but one" in message
