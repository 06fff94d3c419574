"""Reading of scene files: units, defaults, the catalog, tables, materials, and other temperatures of the oil."""

from pathlib import Path

import numpy as np
import pytest

import analytic
from analytic import catalog
from analytic.errors import InputError
from analytic.scene import Land, Material
from analytic.scenefile.read import load_scene, parse_by_temperature, parse_scene
from tests.analytic.scenefile.scene_texts import OIL, PLAIN, ROUGH, SURFACE, changed, refusal, scene
from tests.analytic.specimens import present
from tests.refusals import refused


@pytest.mark.parametrize("scene_name", catalog.names("scenes"))
def test_the_built_in_scenes_are_table_1_of_the_paper(scene_name: str, bearing_6205) -> None:
    parsed = load_scene(scene_name)
    table = bearing_6205  # typed in a second time
    for name in ("ball_count", "ball_diameter", "ball_mass"):
        assert getattr(parsed.bearing, name) == getattr(table, name), name
    for ring in ("inner", "outer"):
        for name in ("bottom_radius", "groove_radius"):
            assert getattr(getattr(parsed.bearing, ring), name) == getattr(getattr(table, ring), name), (ring, name)
    np.testing.assert_allclose(parsed.bearing.pitch_diameter, 39.01e-3, rtol=1e-12)  # round-off
    np.testing.assert_allclose(parsed.bearing.diametral_clearance, 0.020e-3, rtol=1e-9)  # round-off of a difference
    # Boundary dimensions of a 6205 as every maker lists them.
    assert (parsed.bearing.bore_diameter, parsed.bearing.outside_diameter, parsed.bearing.width) == (
        25e-3,
        52e-3,
        15e-3,
    )
    assert parsed.tolerance == 0.05
    assert parsed.friction_coefficient == (0.1 if scene_name == "6205-dry" else None)
    assert (parsed.contact_angle.rule, parsed.contact_angle.free) == ("solved", 0.18)
    np.testing.assert_allclose(parsed.operation.axial_load, [1000.0] * 5)
    speeds = np.array([100, 200, 300, 400, 500]) * 2 * np.pi / 60
    np.testing.assert_allclose(parsed.operation.inner_speed, speeds, rtol=1e-15)  # one rounding
    assert parsed.cage is not None
    assert (parsed.cage.pocket_diameter, parsed.cage.pocket_depth, parsed.cage.mass) == (8.14e-3, 4.07e-3, 6.58e-3)
    assert parsed.warnings == ()


@pytest.mark.parametrize("clearance", [13e-6, -7e-6])
def test_a_clearance_moves_both_rings(bearing_6205, clearance: float) -> None:
    key = f'catalog = "paper_6205"\nclearance = "{clearance * 1e6} um"'
    parsed = scene(changed('catalog = "paper_6205"', key)).bearing
    np.testing.assert_allclose(parsed.diametral_clearance, clearance, rtol=1e-9)  # a difference of radii of 20 mm
    np.testing.assert_allclose(parsed.pitch_diameter, bearing_6205.pitch_diameter, rtol=1e-15)  # one rounding
    assert parsed.inner.bottom_radius != bearing_6205.inner.bottom_radius


def test_no_cage_table_is_no_cage() -> None:
    assert scene(PLAIN).cage is None
    wide = present(scene(PLAIN + '[cage]\npocket_clearance = "0.3 mm"').cage)
    np.testing.assert_allclose((wide.pocket_diameter, wide.pocket_depth), (8.24e-3, 4.12e-3), rtol=1e-15)
    direct = present(scene(PLAIN + '[cage]\npocket_diameter = "8.3 mm"').cage)  # replaces the clearance of the catalog
    assert direct.pocket_diameter == 8.3e-3


def test_the_printed_pocket_needs_its_name_and_warns() -> None:
    printed = scene(PLAIN + '[cage]\nvariant = "as_printed"')
    assert printed.cage is not None
    assert (printed.cage.pocket_diameter, printed.cage.pocket_depth) == (13.9e-3, 6.81e-3)
    (warning,) = printed.warnings
    assert "13.9 mm" in warning
    assert "13.34" in warning
    assert "overlap" in refusal(PLAIN + '[cage]\npocket_diameter = "13.9 mm"\npocket_depth = "6.81 mm"')


def test_a_moulded_cage_is_a_variant_with_its_own_pocket() -> None:
    moulded = scene(PLAIN + '[cage]\nvariant = "peek"\npocket_clearance = "0.3 mm"')
    assert moulded.cage is not None
    assert (moulded.cage.material.name, moulded.cage.wall_thickness) == ("peek", 1.5e-3)
    assert moulded.cage.material.youngs_modulus == 3.6e9
    np.testing.assert_allclose(moulded.cage.pocket_diameter, 8.24e-3, rtol=1e-15)
    assert moulded.warnings == ()
    stamped = present(scene(PLAIN + "[cage]").cage)
    volume = 1.5 / 0.9 * stamped.mass / stamped.material.density
    np.testing.assert_allclose(moulded.cage.mass, volume * moulded.cage.material.density, rtol=0.02)  # written: 1.8 g
    # Only the printed pocket may overlap its neighbour.
    assert "overlap" in refusal(PLAIN + '[cage]\nvariant = "peek"\npocket_diameter = "13.9 mm"')


def test_the_motion_of_a_cage_is_read() -> None:
    text = (
        'start = "sudden"\nseeds = 7\nduration = "0.3 s"\nrestitution = 0.6\ngravity = "along"\ndrag = "2e-6 N m s"\n'
        "steps_per_contact = 57\n"
        'pocket_axis = "radial"\nfriction_coefficient = 0.08\n'
        'pocket_approach = { load = "28 N", approach = "0.9 um" }\n'
        'sheet_stiffness = "130 N/um"\n'
        'land = { ring = "outer", clearance = "0.3 mm", width = "9 mm" }\n'
    )
    cage = present(scene(PLAIN + "[cage]\n" + text).cage)
    assert (cage.start, cage.seeds, cage.duration, cage.restitution) == ("sudden", 7, 0.3, 0.6)
    assert cage.steps_per_contact == 57
    assert (cage.gravity, cage.drag, cage.pocket_axis) == ("along", 2e-6, "radial")
    assert cage.friction_coefficient == 0.08
    assert cage.land == Land(ring="outer", clearance=0.3e-3, width=9e-3)
    assert cage.pocket_stiffness == pytest.approx(28 / 0.9e-6**1.5, rel=1e-12)
    assert cage.sheet_stiffness == pytest.approx(1.3e8, rel=1e-12)


def test_a_lubricant_is_read() -> None:
    oil = present(scene(OIL).lubricant)
    assert (oil.viscosity, oil.pressure_viscosity, oil.eyring_stress, oil.traction) == (0.06, 2e-8, 5e6, "eyring_sinh")
    assert oil.temperature == oil.reference_temperature == 313.15  # 40 degC by default
    warm = present(scene(OIL + 'reference_temperature = "40.5 degC"\nviscosity_temperature = "0.03 1/K"').lubricant)
    assert (warm.temperature, warm.reference_temperature, warm.viscosity_temperature) == (313.65, 313.65, 0.03)
    hot = scene(OIL + 'temperature = "80 degC"\nthermal_conductivity = "0.13 W/m/K"\ndensity = "0.85 g/cm^3"').lubricant
    assert hot is not None
    assert (hot.temperature, hot.reference_temperature, hot.thermal_conductivity) == (353.15, 313.15, 0.13)
    assert hot.density == 850.0
    assert hot.compressible
    assert not present(scene(OIL + "compressible = false").lubricant).compressible


def test_a_surface_is_read(tmp_path: Path) -> None:
    declared = scene(ROUGH + 'ball_rms_roughness = "20 nm"\nhardness = "6.9 GPa"\nboundary_friction = 0.11').surface
    assert declared is not None
    assert declared.autocorrelation is not None
    assert (declared.rms_roughness, declared.ball_rms_roughness) == (1e-7, 2e-8)
    assert (declared.hardness, declared.boundary_friction, declared.height_map) == (6.9e9, 0.11, None)
    assert (declared.autocorrelation.kind, declared.autocorrelation.length) == ("gaussian", 6e-5)
    assert declared.autocorrelation.spacing == 2e-6
    (tmp_path / "race.CSV").write_text("0, 1")
    (tmp_path / "case.toml").write_text(PLAIN + '[surface]\nheight_map = { path = "race.CSV", spacing = "0.7 um" }')
    measured = present(load_scene(tmp_path / "case.toml").surface)  # relative to the folder of the scene file
    assert measured.height_map is not None
    assert (measured.height_map.path, measured.height_map.spacing) == (str(tmp_path / "race.CSV"), 7e-7)
    assert measured.rms_roughness is None


OILED = f'{PLAIN}[lubricant]\nname = "ISO VG 46"\ntemperature = "55 degC"\n{SURFACE}'
THERMAL = '[thermal]\nresistance = "0.5 K/W"\nambient = "20 degC"\n'
PAIR = 'viscosity = ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]\nbase_oil = "mineral"'


def test_the_oil_is_read_again_at_another_temperature() -> None:
    read = parse_by_temperature(OILED, origin="here")
    warm = parse_scene(OILED.replace("55 degC", "70 degC"), origin="here")
    assert read.at(343.15).lubricant == warm.lubricant
    assert read.fixed.lubricant == parse_scene(OILED, origin="here").lubricant != warm.lubricant
    refused(lambda: read.at(463.15), "here: oil at 190 degC: lubricant.temperature must be -40 to 140 degC")


def test_without_an_oil_there_is_no_other_temperature() -> None:
    refused(lambda: parse_by_temperature(PLAIN, origin="here").at(320.0), "here: the scene has no [lubricant]; give")


def test_friction_warms_an_oil_that_is_known_at_every_temperature() -> None:
    for lines in ('name = "ISO VG 46"', PAIR):
        read = parse_by_temperature(f"{PLAIN}[lubricant]\n{lines}\n{SURFACE}{THERMAL}", origin="here")
        assert read.thermal is not None
        refused(lambda: read.fixed, "here: the scene has [thermal]", "or run fembearing torque")  # noqa: B023


@pytest.mark.parametrize(
    ("lines", "words"),
    [
        (
            "",
            "thermal = {'ambient': '20 degC', 'resistance': '0.5 K/W'} warms the oil, and the scene has no [lubricant]",
        ),
        (
            '[lubricant]\nviscosity = "60 mPa s"\nbase_oil = "mineral"\n',
            "lubricant.viscosity = '60 mPa s' is known at one",
        ),
    ],
)
def test_friction_warms_no_other_oil(lines: str, words: str) -> None:
    assert words in refusal(PLAIN + lines + THERMAL)


BEARING = 'catalog = "paper_6205"'


def ball(material: str) -> Material:
    return scene(changed(BEARING, f"{BEARING}\nball_material = {material}")).bearing.ball_material


def test_a_named_material_is_that_of_the_prints() -> None:
    steel = ball('"100Cr6"')
    assert (steel.youngs_modulus, steel.poisson_ratio, steel.density) == (208e9, 0.3, 7830.0)
    assert steel.thermal_expansion == pytest.approx(12.5e-6, rel=1e-12)  # round-off
    assert steel == ball('"52100"') == ball('"aisi 52100"') == analytic.material("100cr6")
    assert analytic.material("Si3N4") != analytic.material("silicon_nitride")


def test_a_table_completes_a_material_of_the_catalog() -> None:
    completed = ball('{ name = "440C", poisson_ratio = 0.284, thermal_expansion = "9.9e-6 1/K" }')
    assert (completed.youngs_modulus, completed.poisson_ratio, completed.density) == (200e9, 0.284, 7680.0)
    assert completed.thermal_expansion == pytest.approx(9.9e-6, rel=1e-12)
    assert "given: poisson_ratio, thermal_expansion" in completed.source
    assert analytic.material("440C", poisson_ratio=0.284, thermal_expansion=9.9e-6) == completed


def test_a_material_that_lacks_a_constant_names_it() -> None:
    message = refusal(changed(BEARING, f'{BEARING}\nball_material = "440C"'))
    assert "bearing.ball_material = '440C' has no sourced poisson_ratio" in message
    assert '{ name = "440C", poisson_ratio = 0.29 }' in message
    assert "poisson_ratio is missing" in refusal(changed(BEARING, f'{BEARING}\nball_material = {{ name = "M50" }}'))
    with pytest.raises(InputError, match="material 'brass' has no sourced poisson_ratio"):
        analytic.material("brass")


@pytest.mark.parametrize("name", catalog.names("materials"))
def test_every_material_of_the_catalog_is_read(name: str) -> None:
    read = analytic.material(name, poisson_ratio=0.31)
    assert read.poisson_ratio == 0.31
    assert 1e9 < read.youngs_modulus < 400e9
    assert 1000 < read.density < 9000
    assert read.thermal_expansion is None or 2e-6 < read.thermal_expansion < 20e-6
