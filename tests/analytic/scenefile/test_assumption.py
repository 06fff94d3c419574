"""Keys that someone gives beside a bearing of the catalogue replace what its usual scene assumes in another way."""

import re
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.template import scene_text
from tests.refusals import refused

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
