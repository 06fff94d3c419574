"""A bearing in one line: how its options are read, the scene that `fembearing init` writes, and what they replace."""

import re
from typing import Any

import numpy as np
import pytest
from pint import UnitRegistry

from analytic import friction_torque
from analytic.given import KEYS, OperatingOptions
from analytic.quantity import SI
from analytic.scene import Scene
from analytic.scenefile.keys import scene_key, scene_table
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.setting import read_setting, typed_settings
from analytic.scenefile.template import scene_text
from tests.analytic.specimens import present
from tests.refusals import refused

RPM = np.pi / 30
LINE: dict[str, Any] = {
    "radial_load": "3kN",
    "axial_load": "200N",
    "speed": "2900rpm",
    "oil": "ISO VG 46",
    "temperature": "65C",
    "supply": "grease",
}
WRITTEN = OperatingOptions(
    radial_load="3 kN", axial_load="200 N", speed="2900 rpm", oil="ISO VG 46", temperature="65 degC", supply="grease"
)


def same(one: Scene, other: Scene) -> None:
    """Every field of both scenes, to the last digit; the operation holds arrays."""
    np.testing.assert_equal(vars(one.operation), vars(other.operation))
    for name, value in vars(one).items():
        assert name in ("operation", "usual") or value == getattr(other, name), name


@pytest.mark.parametrize(
    ("key", "typed", "read"),
    [
        ("lubricant.temperature", "65C", "65 degC"),
        ("lubricant.temperature", "140 F", "140 degF"),
        ("lubricant.temperature", 338, SI(338, "K")),
        ("operation.radial_load", "3KN", "3 kN"),
        ("operation.radial_load", "2,5 kN", "2.5 kN"),
        ("operation.radial_load", "0,500 kN", "0.500 kN"),  # no thousands begin with 0
        ("operation.radial_load", "7 mN", "7 mN"),  # not MN
        ("operation.radial_load", '"3 kN"', "3 kN"),  # as in a scene file
        ("operation.inner_speed", "2900RPM", "2900 rpm"),
        ("operation.inner_speed", '["700 rpm", "2900rpm"]', ["700 rpm", "2900 rpm"]),
        ("operation.inner_speed", [70.0, 290.5], [SI(70.0, "rad/s"), SI(290.5, "rad/s")]),
        ("operation.down", "[0, 0, 2]", [0, 0, 2]),
        ("lubricant.compressible", "false", False),
        ("lubricant.supply", "grease", "grease"),
        (
            "lubricant.viscosity",
            '["46 cSt at 40 degC", "7 cSt at 100 degC"]',
            ["46 cSt at 40 degC", "7 cSt at 100 degC"],
        ),
        ("bearing.catalog", "6206", "6206"),  # a name, not a number
        ("bearing.clearance", "C3", "C3"),
        ("report.date", "2026-03-04", "2026-03-04"),
        ("tolerance", "2%", "2 %"),
        ("friction.hysteresis_loss", "0,005", 0.005),
        ("losses.seals", "estimate", "estimate"),
        ("operation.inner_speed", "900 U/min; 2,5 rpm", ["900 rpm", "2.5 rpm"]),
    ],
)
def test_a_value_is_read_by_the_unit_of_its_key(key: str, typed: Any, read: Any) -> None:
    value, notes = read_setting(key, typed)
    assert (value, type(value), notes) == (read, type(read), [])


@pytest.mark.parametrize(
    ("key", "typed", "meant"),
    [
        ("lubricant.supply", " Oil-Bath", "oil_bath"),
        ("bearing.clearance", "c3", "C3"),
        ("operation.moment", "3 Nmm", 3e-3),
        ("effects.cage", "OFF", "off"),
    ],
)
def test_a_word_is_known_as_people_write_it(key: str, typed: str, meant: Any) -> None:
    assert scene_key(key).read(typed) == meant


@pytest.mark.parametrize("typed", ["2900", " 2900 ", '"2900"'])
def test_a_speed_without_a_unit_is_in_rpm_and_says_so(typed: Any) -> None:
    note = "operation.inner_speed = 2900 has no unit and is read as 2900 rpm"
    assert read_setting("operation.inner_speed", typed) == ("2900 rpm", [note])
    scene = load_scene("6308", **{**LINE, "speed": typed})
    np.testing.assert_allclose(scene.operation.inner_speed, 2900 * RPM, rtol=1e-12)  # round-off
    assert scene.warnings == (*load_scene("6308", **LINE).warnings, note)
    assert load_scene("6308", settings={"operation.inner_speed": typed}).warnings[-1] == note


def test_a_quantity_of_pint_is_an_option_too() -> None:
    unit = UnitRegistry()
    same(load_scene("6308", radial_load=3 * unit.kN), load_scene("6308", radial_load="3 kN"))


def test_numbers_of_numpy_are_those_of_python() -> None:
    same(load_scene("6308", radial_load=np.int64(310)), load_scene("6308", radial_load="310 N"))
    loads = {"operation.radial_load": np.array([310.0, 470.0]), "operation.down": np.array([0, 0, 3])}
    given = load_scene("6308", speed=np.float32(62.5), settings=loads)
    listed = {"operation.radial_load": [310.0, 470.0], "operation.down": [0, 0, 3]}
    same(given, load_scene("6308", speed=62.5, settings=listed))
    np.testing.assert_array_equal(given.operation.radial_load, [310.0, 470.0])


def test_the_options_are_keys_of_a_scene() -> None:
    assert KEYS.keys() == OperatingOptions.__optional_keys__
    assert {*KEYS.values()} <= {*scene_table().paths()}


@pytest.mark.parametrize("designation", ["6308", "6305-2RS/C3"])
def test_one_line_is_the_scene_that_init_writes(designation: str) -> None:
    file = parse_scene(scene_text(designation, **WRITTEN), origin="here")
    same(load_scene(designation, **LINE), file)
    settings = {KEYS[name]: value for name, value in LINE.items()}
    same(load_scene(designation, settings=settings), file)  # keys one by one: the second way to the same scene


def test_a_setting_takes_the_place_of_a_key_and_leaves_the_others() -> None:
    usual = load_scene("6308", **LINE)
    changed = load_scene("6308", settings={"bearing.inner.conformity": "0,515", "effects.cage": "off"}, **LINE)
    assert changed.bearing.inner.groove_radius == pytest.approx(0.515 * usual.bearing.ball_diameter, rel=1e-12)
    assert changed.effects["cage"] == "off"
    assert (changed.operation.radial_load, changed.lubricant) == (usual.operation.radial_load, usual.lubricant)


def test_what_nobody_gave_is_assumed(tmp_path: Any) -> None:
    def left(name: str, *settings: str, **options: Any) -> dict[str, str]:
        return dict(load_scene(name, settings=typed_settings([*settings]), **options).usual)

    usual = left("6308")
    assert usual["operation.inner_speed"] == "1000 rpm"
    assert usual["lubricant.supply"] == "oil_bath"
    assert usual["bearing.clearance"] == "CN"
    assert usual.keys() - left("6308", **LINE).keys() == {*KEYS.values()}
    assert usual.keys() - left("6308", "friction.hysteresis_loss=0.004").keys() == {"friction.hysteresis_loss"}
    assert "bearing.clearance" not in left("6308/C3")  # the designation says it
    assert "bearing.clearance" not in left("7208B")  # its contact angle takes the place
    (tmp_path / "a.toml").write_text(scene_text("6308"), "utf-8")
    assert left(str(tmp_path / "a.toml")) == left("paper_6205") == {}


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("6399", {}, ("6399", "nearest: ")),
        ("6308", {"radial_load": "2,500 N"}, ("radial_load = '2,500 N' is ambiguous", "write 2500 N or 2.5 N")),
        ("6308", {"oil": "ISO VG 47"}, ("lubricant.name = 'ISO VG 47'", "near it are", "ISO VG 46")),
        ("6308", {"supply": "butter"}, ("lubricant.supply = 'butter'", "oil_bath", "grease")),
        ("6308", {"radial_load": 10**400}, ("operation.radial_load = inf N is not finite",)),
        (
            "6308",
            {"speed": "3 rpm", "settings": {"operation.inner_speed": "7 rpm"}},
            ("speed = '3 rpm' and operation.inner_speed are the same: leave one of them out",),
        ),
        ("6308", {"sped": "3 rpm"}, ("sped is no option of a bearing", "did you mean speed?")),
        ("6308", {"settings": {"lubricant.suply": "grease"}}, ("lubricant.suply", "did you mean lubricant.supply")),
        ("6308", {"settings": {"lubricant": "grease"}}, ("lubricant is a table", "lubricant.name")),
        ("6308", {"settings": {"surface.Ra": "0,050 um", "surface.finish": 3}}, ("surface.finish = 3",)),
        ("paper_6205", {"sped": "3 rpm"}, ("sped is no option of a bearing", "did you mean speed?")),
    ],
)
def test_a_mistake_is_one_line(name: str, given: dict[str, Any], words: tuple[str, ...]) -> None:
    refused(lambda: load_scene(name, **given), *words)
    refused(lambda: friction_torque(name, **given), *words)


def test_a_table_is_set_as_a_remedy_writes_it() -> None:
    given = {"surface.rms_roughness": "0.06um"}
    refused(lambda: load_scene("6206", settings=given), '{ kind = "gaussian", length = "60 um", spacing = "2 um" }')
    given["surface.autocorrelation"] = '{ kind = "gaussian", length = "60 um", spacing = "2 um" }'
    surface = present(load_scene("6206", settings=given).surface)
    np.testing.assert_allclose(present(surface.rms_roughness), 0.06e-6, rtol=1e-12)
    ring = load_scene("6206", settings={"bearing.inner.material": {"name": "own", "youngs_modulus": "190 GPa",
                                        "poisson_ratio": 0.3, "density": "7800 kg/m^3"}}).bearing.inner  # fmt: skip
    assert (ring.material.name, ring.material.youngs_modulus) == ("own", 190e9)


def test_a_range_is_the_list_that_it_stands_for() -> None:
    by_range = load_scene("6206", speed="2 rpm to 200 rpm in 3 log", axial_load="100 N to 500 N in 3")
    by_list = load_scene("6206", speed=["2 rpm", "20 rpm", "200 rpm"], axial_load=["100 N", "300 N", "500 N"])
    for name in ("inner_speed", "axial_load", "radial_load"):
        found, expected = (getattr(scene.operation, name) for scene in (by_range, by_list))
        np.testing.assert_allclose(found, expected, rtol=1e-14)
    assert by_range.lubricant is not None
    assert by_list.lubricant is not None
    assert by_range.lubricant.name == by_list.lubricant.name  # that of the highest speed
    file = parse_scene(scene_text("6206").replace('"1000 rpm"', '"2 rpm to 200 rpm in 3 log"'), origin="here")
    np.testing.assert_array_equal(file.operation.inner_speed, by_range.operation.inner_speed)
    refused(lambda: load_scene("6206", speed="30 rpm to 300 rpm"), "is no range", "FIRST to LAST in COUNT")
    refused(lambda: load_scene("6206", speed="0 rpm to 300 rpm in 4 log"), "no equal ratios")
    refused(lambda: load_scene("6206", speed="1 rpm to 9 rpm in 3", axial_load="1 N to 9 N in 4"), "equal lengths")


@pytest.mark.parametrize("text", ["lubricant.supply", "=grease", "lubricant.supply=", ""])
def test_a_setting_needs_key_and_value(text: str) -> None:
    refused(lambda: typed_settings([text]), "--set", "KEY=VALUE")


@pytest.mark.parametrize(
    ("designation", "supply"),
    [
        *(("6206-2RS", "grease"), ("6206-2Z", "grease"), ("6206 VV", "grease"), ("6206-RZ/C3", "grease")),
        *(("6206", "oil_bath"), ("6206/C3", "oil_bath"), ("7014C", "oil_bath")),
    ],
)
def test_a_bearing_with_seals_or_shields_is_greased(designation: str, supply: str) -> None:
    found = load_scene(designation)
    assert found.lubricant is not None
    assert found.lubricant.supply == supply
    assert found.usual["lubricant.supply"] == supply


@pytest.mark.parametrize(
    "name", ["628/8", "618/5", "6202/15.875", "W 628/8-2Z", "NSK/6399", "6399/C3", "6205/ETN9", "HC628/8", "60/99"]
)
def test_a_slash_in_a_designation_makes_no_path(name: str) -> None:
    for read in (load_scene, friction_torque):
        refused(lambda: read(name), f"bearing {name!r}" if name != "618/5" else "bearing 618/5")  # noqa: B023


FINISH, CLEARANCE = 'finish = "ground and honed"', 'clearance = "CN"'
ANGLE = 'contact_angle = { nominal = "40 deg" }'


@pytest.mark.parametrize(
    ("name", "settings", "assumed", "instead"),
    [
        ("6206", {"surface.Ra": "0.05 um"}, FINISH, 'Ra = "0.05 um"'),
        (
            "6206",
            {
                "surface.rms_roughness": 7e-8,
                "surface.autocorrelation.kind": "gaussian",
                "surface.autocorrelation.length": 3e-5,
                "surface.autocorrelation.spacing": 1e-6,
            },
            FINISH,
            'rms_roughness = "7e-8 m"\nautocorrelation = { kind = "gaussian", length = "3e-5 m", spacing = "1e-6 m" }',
        ),
        ("6206", {"bearing.contact_angle.nominal": "15 deg"}, CLEARANCE, 'contact_angle = { nominal = "15 deg" }'),
        ("6206", {"bearing.contact_angle.free": "15 deg"}, CLEARANCE, 'contact_angle = { free = "15 deg" }'),
        ("7206BEP", {"bearing.clearance": "15 um"}, ANGLE, 'clearance = "15 um"'),
        ("6206", {"friction.coefficient": 0.1}, f"[surface]\n{FINISH}", "[friction]\ncoefficient = 0.1"),
    ],
)
def test_a_setting_replaces_an_assumption(name: str, settings: dict[str, Any], assumed: str, instead: str) -> None:
    found = load_scene(name, axial_load=300.0, settings=settings)
    text = "\n".join(line.partition(" #")[0].rstrip() for line in scene_text(name).splitlines())
    text = text.replace("\n[friction]\n", "\n") if "[friction]" in instead else text
    same = parse_scene(text.replace(assumed, instead), origin="same")
    assert (found.bearing, found.surface, found.contact_angle) == (same.bearing, same.surface, same.contact_angle)
    assert found.friction_coefficient == same.friction_coefficient
    replaced = "surface.finish" if "finish" in assumed else "bearing.c"
    assert not any(each.startswith(replaced) for each in found.usual)


@pytest.mark.parametrize(
    ("name", "settings", "words"),
    [
        ("6206/C3", {"bearing.contact_angle.nominal": "15 deg"}, "bearing.clearance = 'C3' and contact_angle.nominal"),
        ("6206", {"surface.Ra": "0.05 um", "surface.finish": "ground"}, "it has Ra and finish"),
        (
            "7206BEP",
            {"bearing.clearance": "15 um", "bearing.contact_angle.nominal": "15 deg"},
            "bearing.clearance = '15 um' and contact_angle.nominal both determine the clearance",
        ),
        ("6206", {"bearing.inner.bottom_radius": "18 mm"}, "bearing.outer.bottom_radius is missing"),
    ],
)
def test_what_someone_gives_stays(name: str, settings: dict[str, Any], words: str) -> None:
    refused(lambda: load_scene(name, settings=settings), words)


def test_a_coefficient_beside_a_given_surface_is_refused() -> None:
    scene = load_scene("6206", settings={"friction.coefficient": 0.1, "surface.boundary_friction": 0.13})
    refused(lambda: friction_torque(scene), "friction.coefficient = 0.1 and [surface] both determine the friction")


PAIR = {"arrangement.kind": "O", "arrangement.preload": "300 N"}


@pytest.mark.parametrize(
    ("settings", "options", "loads"),
    [
        (PAIR, {}, (0.0, 0.0)),
        (PAIR, {"axial_load": "200 N"}, (200.0, 0.0)),
        (PAIR, {"radial_load": "150 N"}, (0.0, 150.0)),
        ({"arrangement.kind": "X", "arrangement.offset": "9 um"}, {}, (0.0, 0.0)),
        ({"operation.axial_load": "300 N"}, {}, (300.0, 0.0)),
        ({"operation.radial_load": "70 N", "operation.axial_load": "310 N"}, {}, (310.0, 70.0)),
    ],
)
def test_no_usual_load_stands_beside_a_given_one(
    settings: dict[str, Any], options: dict[str, Any], loads: tuple[float, float]
) -> None:
    operation = load_scene("7014C", settings=settings, **options).operation.as_series()
    assert (float(operation.axial_load[0]), float(np.asarray(operation.radial_load)[0])) == loads


PAIR_OF_VISCOSITIES = ["120 cSt at 40 degC", "12 cSt at 100 degC"]


@pytest.mark.parametrize(
    ("settings", "table"),
    [
        (
            {"lubricant.viscosity": PAIR_OF_VISCOSITIES, "lubricant.base_oil": "PAO"},
            'viscosity = ["120 cSt at 40 degC", "12 cSt at 100 degC"]\nbase_oil = "PAO"',
        ),
        (
            {"lubricant.viscosity": '["120 cSt at 40 degC", "12 cSt at 100 degC"]'},
            'viscosity = ["120 cSt at 40 degC", "12 cSt at 100 degC"]\nbase_oil = "mineral"',
        ),
        (
            {"lubricant.viscosity": 0.012},
            'viscosity = "0.012 Pa s"\nreference_temperature = "80 degC"\nbase_oil = "mineral"',
        ),
        (
            {"lubricant.viscosity": "33 cSt at 55 degC", "lubricant.base_oil": "PAO"},
            'viscosity = "33 cSt at 55 degC"\nbase_oil = "PAO"',
        ),
        (
            {"lubricant.viscosity": "0.03 Pa s", "lubricant.reference_temperature": "50 degC"},
            'viscosity = "0.03 Pa s"\nreference_temperature = "50 degC"\nbase_oil = "mineral"',
        ),
    ],
)
def test_an_assumed_oil_makes_room_for_a_given_one(settings: dict[str, Any], table: str) -> None:
    """The same as in a file that has these keys alone."""
    text = scene_text("6309", radial_load="4 kN", temperature="80 degC", oil="FILE")
    file = parse_scene(re.sub(r'(?m)^name = "FILE".*$', table, text), origin="file")
    given = load_scene("6309", radial_load="4 kN", temperature="80C", settings=settings)
    assert given.lubricant == file.lubricant
    assert given.lubricant is not None
    assert not given.lubricant.name  # so that no headline names an oil that is not computed


def test_a_name_that_someone_gives_is_no_assumption() -> None:
    settings = {"lubricant.base_oil": "PAO", "lubricant.viscosity": PAIR_OF_VISCOSITIES}
    refused(lambda: load_scene("6309", radial_load="4 kN", oil="FVA 3", settings=settings), "base_oil goes with")


def test_a_whole_number_of_radians_that_looks_like_rpm_is_told_once() -> None:
    told = load_scene("6206", radial_load=700.0, speed=1500).warnings
    assert [each for each in told if "rpm" in each] == [
        'operation.inner_speed = 1500 is in rad/s, 14324 rpm; write "1500 rpm" if it is in rpm'
    ]
    for speed in (157.08, 62, "1500 rpm"):
        assert not any("rad/s" in each for each in load_scene("6206", radial_load=700.0, speed=speed).warnings)
