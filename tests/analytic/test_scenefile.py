"""Scene files: what is read, and that every mistake is one line naming the key, the value and a remedy."""

from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.errors import InputError
from analytic.scene import Scene
from analytic.scenefile import LARGEST_FILE, builtin_scene, load_scene, parse_scene

PLAIN = """\
name = "a series"
tolerance = "2 %"
[bearing]
catalog = "6205"
contact_angle = { rule = "solved" }
[operation]
axial_load = "700 N"
inner_speed = ["100 rpm", "30 deg/s"]
"""
INLINE = """\
name = "by hand"
tolerance = 0.03
[bearing]
name = "hybrid"
ball_count = 11
ball_diameter = "6 mm"
ball_mass = "0.36 g"
ball_material = { name = "ceramic", youngs_modulus = "310 GPa", poisson_ratio = 0.27, density = "3.2 g/cm^3" }
contact_angle = { rule = "given", value = "15 deg" }
[bearing.inner]
bottom_radius = "12 mm"
groove_radius = "3.1 mm"
shoulder_half_width = "2 mm"
material = "steel"
[bearing.outer]
bottom_radius = "18.01 mm"
groove_radius = "3.2 mm"
shoulder_half_width = "2.1 mm"
material = "peek"
[operation]
axial_load = ["12 kgf", "1e-12 N"]
inner_speed = ["-200 rpm", "0 rpm"]
[cage]
pocket_diameter = "6.3 mm"
pocket_depth = "2.9 mm"
wall_thickness = "0.7 mm"
mass = "3 g"
material = "peek"
[effects]
spin = "off"
"""


def scene(text: str) -> Scene:
    return parse_scene(text, origin="case.toml")


def refusal(text: str) -> str:
    with pytest.raises(InputError) as problem:
        scene(text)
    return str(problem.value)


def changed(old: str, new: str, text: str = PLAIN) -> str:
    assert old in text, "the replacement would test nothing"
    return text.replace(old, new, 1)


def test_the_builtin_scene_is_table_1_of_the_paper(bearing_6205) -> None:
    found = load_scene(builtin_scene("6205"))
    table = bearing_6205  # typed in a second time beside these tests
    for name in ("ball_count", "ball_diameter", "ball_mass"):
        assert getattr(found.bearing, name) == getattr(table, name), name
    for ring in ("inner", "outer"):
        for name in ("bottom_radius", "groove_radius"):
            assert getattr(getattr(found.bearing, ring), name) == getattr(getattr(table, ring), name), (ring, name)
    np.testing.assert_allclose(found.bearing.pitch_diameter, 39.01e-3, rtol=1e-12)  # round-off
    np.testing.assert_allclose(found.bearing.diametral_clearance, 0.020e-3, rtol=1e-9)  # round-off of a difference
    # Boundary dimensions of a 6205 as every maker lists them.
    assert (found.bearing.bore_diameter, found.bearing.outside_diameter, found.bearing.width) == (25e-3, 52e-3, 15e-3)
    assert (found.tolerance, found.friction_coefficient) == (0.05, 0.1)
    assert (found.contact_angle.rule, found.contact_angle.free) == ("solved", 0.18)
    np.testing.assert_allclose(found.operation.axial_load, [1000.0] * 5)
    speeds = np.array([100, 200, 300, 400, 500]) * 2 * np.pi / 60
    np.testing.assert_allclose(found.operation.inner_speed, speeds, rtol=1e-15)  # one rounding
    assert found.cage is not None
    assert (found.cage.pocket_diameter, found.cage.pocket_depth, found.cage.mass) == (8.14e-3, 4.07e-3, 6.58e-3)
    assert found.warnings == ()


def test_units_become_si() -> None:
    found = scene(INLINE)
    assert found.bearing.ball_material.density == 3200.0
    assert (found.bearing.inner.material.name, found.bearing.outer.material.name) == ("steel", "peek")
    assert found.bearing.outer.bottom_radius == 18.01e-3
    np.testing.assert_allclose(found.contact_angle.value or 0.0, np.pi / 12, rtol=1e-15)  # one rounding
    np.testing.assert_allclose(found.operation.axial_load, [12 * 9.80665, 1e-12], rtol=1e-15)
    np.testing.assert_allclose(found.operation.inner_speed, [-200 * np.pi / 30, 0], rtol=1e-15)
    assert found.cage is not None
    assert (found.cage.pocket_diameter, found.cage.pocket_depth) == (6.3e-3, 2.9e-3)
    assert found.effects["spin"] == "off"
    assert found.effects["rolling"] == "auto"
    assert found.friction_coefficient is None


def test_one_quantity_serves_the_whole_series() -> None:
    operation = scene(PLAIN).operation
    np.testing.assert_array_equal(operation.axial_load, [700.0, 700.0])
    np.testing.assert_allclose(operation.inner_speed, [10.471975511965978, np.pi / 6], rtol=1e-15)
    with pytest.raises(ValueError, match="read-only"):
        operation.axial_load[0] = 3.0


def test_a_catalog_entry_is_overridden_key_by_key() -> None:
    found = scene(
        changed('catalog = "6205"', 'catalog = "6205"\ninner.groove_radius = "4.2 mm"\nball_count = 8')
    ).bearing
    assert (found.inner.groove_radius, found.inner.bottom_radius, found.ball_count) == (4.2e-3, 15.53e-3, 8)


def test_seats_and_width_may_be_left_out() -> None:
    found = scene(INLINE).bearing
    assert (found.bore_diameter, found.outside_diameter, found.width) == (None, None, None)
    wide = scene(changed('name = "hybrid"', 'name = "hybrid"\nwidth = "0.9 cm"', INLINE)).bearing
    assert (wide.bore_diameter, wide.width) == (None, 9e-3)


def test_radial_load_and_moment_of_a_ring() -> None:
    found = scene(changed('"700 N"', '"700 N"\nradial_load = ["-0.4 kN", "0 N"]\nmoment = "300 N mm"'))
    np.testing.assert_array_equal(found.operation.radial_load, [-400.0, 0.0])
    np.testing.assert_allclose(found.operation.moment, [0.3, 0.3], rtol=1e-15)  # one rounding
    assert found.warnings == ()
    np.testing.assert_array_equal(scene(PLAIN).operation.radial_load, [0.0, 0.0])


@pytest.mark.parametrize("clearance", [13e-6, -7e-6])
def test_a_clearance_moves_both_rings(bearing_6205, clearance: float) -> None:
    key = f'catalog = "6205"\ndiametral_clearance = "{clearance * 1e6} um"'
    found = scene(changed('catalog = "6205"', key)).bearing
    np.testing.assert_allclose(found.diametral_clearance, clearance, rtol=1e-9)  # a difference of radii of 20 mm
    np.testing.assert_allclose(found.pitch_diameter, bearing_6205.pitch_diameter, rtol=1e-15)  # one rounding
    assert found.inner.bottom_radius != bearing_6205.inner.bottom_radius


def test_no_cage_table_is_no_cage() -> None:
    assert scene(PLAIN).cage is None
    wide = scene(PLAIN + '[cage]\npocket_clearance = "0.3 mm"').cage
    assert wide is not None
    np.testing.assert_allclose((wide.pocket_diameter, wide.pocket_depth), (8.24e-3, 4.12e-3), rtol=1e-15)
    direct = scene(PLAIN + '[cage]\npocket_diameter = "8.3 mm"').cage  # in place of the catalog's clearance
    assert direct is not None
    assert direct.pocket_diameter == 8.3e-3


def test_the_printed_pocket_needs_its_name_and_warns() -> None:
    printed = scene(PLAIN + '[cage]\nvariant = "as_printed"')
    assert printed.cage is not None
    assert (printed.cage.pocket_diameter, printed.cage.pocket_depth) == (13.9e-3, 6.81e-3)
    (warning,) = printed.warnings
    assert "13.9 mm" in warning
    assert "13.34" in warning
    assert "overlap" in refusal(PLAIN + '[cage]\npocket_diameter = "13.9 mm"\npocket_depth = "6.81 mm"')


def test_a_moulded_cage_is_a_variant_that_keeps_the_pocket() -> None:
    moulded = scene(PLAIN + '[cage]\nvariant = "peek"\npocket_clearance = "0.3 mm"')
    assert moulded.cage is not None
    assert (moulded.cage.material.name, moulded.cage.wall_thickness) == ("peek", 1.5e-3)
    assert moulded.cage.material.youngs_modulus == 3.6e9
    np.testing.assert_allclose(moulded.cage.pocket_diameter, 8.24e-3, rtol=1e-15)
    assert moulded.warnings == ()
    stamped = scene(PLAIN + "[cage]").cage
    assert stamped is not None
    volume = 1.5 / 0.9 * stamped.mass / stamped.material.density
    np.testing.assert_allclose(moulded.cage.mass, volume * moulded.cage.material.density, rtol=0.02)  # written: 1.8 g
    # Only the printed pocket may overlap its neighbour.
    assert "overlap" in refusal(PLAIN + '[cage]\nvariant = "peek"\npocket_diameter = "13.9 mm"')


def test_no_lubricant_and_no_surface_is_none() -> None:
    assert scene(PLAIN).lubricant is None
    assert scene(PLAIN).surface is None


def test_a_lubricant_is_read() -> None:
    oil = scene(OIL).lubricant
    assert oil is not None
    assert (oil.viscosity, oil.pressure_viscosity, oil.eyring_stress, oil.traction) == (0.06, 2e-8, 5e6, "eyring_sinh")
    assert oil.temperature == oil.reference_temperature == 313.15  # 40 degC, where nothing else is said
    warm = scene(OIL + 'reference_temperature = "40.5 degC"\nviscosity_temperature = "0.03 1/K"').lubricant
    assert warm is not None
    assert (warm.temperature, warm.reference_temperature, warm.viscosity_temperature) == (313.65, 313.65, 0.03)
    hot = scene(OIL + 'temperature = "80 degC"\nthermal_conductivity = "0.13 W/m/K"\ndensity = "0.85 g/cm^3"').lubricant
    assert hot is not None
    assert (hot.temperature, hot.reference_temperature, hot.thermal_conductivity) == (353.15, 313.15, 0.13)
    assert hot.density == 850.0


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
    measured = load_scene(tmp_path / "case.toml").surface  # sought beside the scene file, wherever one works
    assert measured is not None
    assert measured.height_map is not None
    assert (measured.height_map.path, measured.height_map.spacing) == (str(tmp_path / "race.CSV"), 7e-7)
    assert measured.rms_roughness is None


def test_hardness_is_known_of_steel_alone() -> None:
    assert scene(PLAIN).bearing.ball_material.hardness == 7.8e9
    own = scene(changed("poisson_ratio = 0.27", 'poisson_ratio = 0.27, hardness = "15 GPa"', INLINE)).bearing
    assert (own.ball_material.hardness, own.outer.material.hardness) == (15e9, None)


def test_a_ball_of_the_wrong_mass_is_doubted() -> None:
    (warning,) = scene(changed('catalog = "6205"', 'catalog = "6205"\nball_diameter = "7.5 mm"')).warnings
    assert "2.04 g" in warning
    assert "1.734 g" in warning  # pi/6 (7.5 mm)^3 7850 kg/m^3


def test_an_elastic_preload_fits() -> None:
    found = scene(changed('catalog = "6205"', 'catalog = "6205"\nball_diameter = "7.96 mm"'))
    assert found.bearing.diametral_clearance < 0


BEARING = 'catalog = "6205"'
OIL = (
    PLAIN
    + """\
[lubricant]
viscosity = "60 mPa s"
pressure_viscosity = "2e-8 1/Pa"
eyring_stress = "5 MPa"
traction = "eyring_sinh"
"""
)
ROUGH = (
    PLAIN
    + """\
[surface]
rms_roughness = "0.1 um"
autocorrelation = { kind = "gaussian", length = "60 um", spacing = "2 um" }
"""
)
MAP = '{ path = "a.npy", spacing = "1 um" }'
CAGE = PLAIN + "[cage]\n"
MISTAKES = [  # text, and what the one line must name: key, value, what would be accepted
    (changed('"700 N"', "700"), ("operation.axial_load = 700", "no unit", '"1000 N"')),
    (changed('"700 N"', '"700"'), ("operation.axial_load = '700'", "unit is missing", '"1000 N"')),
    (changed('"700 N"', '"700 mm"'), ("operation.axial_load = '700 mm'", "unit like N")),
    (changed('"700 N"', '"700 newtonn"'), ("operation.axial_load", "'newtonn'", '"1000 N"')),
    (changed('"700 N"', '"0,7 N"'), ("operation.axial_load = '0,7 N'", "decimal point")),
    (changed('"700 N"', '"-700 N"'), ("operation.axial_load = '-700 N'", "out of range", "0 to 1e+12 N")),
    (changed('"700 N"', '"nan N"'), ("operation.axial_load = 'nan N'", '"1000 N"')),
    (changed('"700 N"', '"1e9999 N"'), ("operation.axial_load = '1e9999 N'", "finite")),
    (changed('"700 N"', '"9**9**9**9 N"'), ("operation.axial_load = '9**9**9**9 N'", '"1000 N"')),
    (changed('"700 N"', '"2**1000000 N"'), ("operation.axial_load", '"1000 N"')),
    (changed('"700 N"', '"7 N^9999999"'), ("operation.axial_load", '"1000 N"')),
    (changed('"700 N"', '"7 __import__"'), ("operation.axial_load", '"1000 N"')),
    (changed('"700 N"', '"700 N"\nmoment = "3 N"'), ("operation.moment = '3 N'", "unit like N m")),
    (changed('"700 N"', '"700 N"\nradial_load = []'), ("operation.radial_load = []", "empty")),
    (
        changed('"solved" }', '"solved", free = "0.1 rad" }\ndiametral_clearance = "5 um"'),
        ("bearing.diametral_clearance = '5 um'", "contact_angle.free", "leave one of them out"),
    ),
    (changed('"700 N"', "[]"), ("operation.axial_load = []", "empty")),
    (changed('"700 N"', "true"), ("operation.axial_load = True", '"1000 N"')),
    (changed('"700 N"', '["5 N", "6 N", 7]'), ("operation.axial_load[2] = 7", "no unit")),
    (changed('"700 N"', '["5 N", "6 N", "7 N"]'), ("axial_load has 3", "inner_speed has 2", "equal lengths")),
    (changed('"100 rpm"', '"100 Hz"'), ("operation.inner_speed[0] = '100 Hz'", '"300 rpm"')),
    (changed('"2 %"', "2"), ("tolerance = 2 ", "out of range", '"5 %"')),
    (changed('"2 %"', "nan"), ("tolerance = nan", "finite")),
    (changed('"2 %"', '"0.02"'), ("tolerance = '0.02'", "no quotes")),
    (changed('"2 %"', "0x" + "f" * 6000), ("tolerance", "thousands of digits", "too large")),
    (changed('name = "a series"', ""), ("name is missing", "give a name")),
    (changed('name = "a series"', 'name = "two\\nlines"'), ("name = 'two\\nlines'", "printable")),
    (changed('name = "a series"', 'name = "a"\n"odd\\nkey" = 5'), ("'odd\\nkey' = 5", "unknown key")),
    (changed("tolerance", "tolerence"), ("tolerance is missing", "tolerence = '2 %'", "did you mean tolerance?")),
    (PLAIN + '[weather]\nviscosity = "0.06 Pa s"', ("weather", "unknown key", "known: name")),
    (OIL.replace('"2e-8 1/Pa"', "2e-8"), ("lubricant.pressure_viscosity = 2e-08", "no unit", '"2e-8 1/Pa"')),
    (OIL.replace('"2e-8 1/Pa"', '"2e-8 Pa"'), ("lubricant.pressure_viscosity = '2e-8 Pa'", "in a unit like 1/Pa")),
    (OIL.replace('"60 mPa s"', '"68 mm^2/s"'), ("lubricant.viscosity = '68 mm^2/s'", "Pa*s", '"0.06 Pa s"')),
    (OIL.replace("eyring_sinh", "newtonian"), ("lubricant.traction = 'newtonian'", "eyring_sinh", "eyring_constant")),
    (OIL + 'temperature = "-80 degC"', ("lubricant.temperature = '-80 degC'", "200 to 600 K", '"40 degC"')),
    (OIL + "limiting_shear = 1.2", ("lubricant.limiting_shear = 1.2", "0 to 1")),
    (PLAIN + '[lubricant]\nviscosity = "0.06 Pa s"', ("lubricant.pressure_viscosity is missing", "eyring_stress")),
    ("lubricant = 7\n" + PLAIN, ("lubricant = 7", "not a table", "eyring_stress")),
    (PLAIN + "[surface]", ("surface", "exactly one of rms_roughness and height_map")),
    ("surface = 7\n" + PLAIN, ("surface = 7", "not a table", "rms_roughness")),
    (ROUGH.replace('"0.1 um"', '"-0.1 um"'), ("surface.rms_roughness = '-0.1 um'", "out of range", '"0.1 um"')),
    (ROUGH.replace('"gaussian"', '"fractal"'), ("surface.autocorrelation.kind = 'fractal'", "'exponential'")),
    (ROUGH.replace('"60 um"', "60"), ("surface.autocorrelation.length = 60", "no unit", '"2 um"')),
    (ROUGH.replace(', spacing = "2 um"', ""), ("surface.autocorrelation.spacing is missing", '"2 um"')),
    (ROUGH + 'hardness = "780 HV"', ("surface.hardness = '780 HV'", '"7.8 GPa"')),
    (ROUGH + "boundary_friction = -0.1", ("surface.boundary_friction = -0.1", "0 to 5")),
    (ROUGH.partition("autocorrelation")[0], ("surface.autocorrelation goes with rms_roughness",)),
    (ROUGH + f"height_map = {MAP}", ("surface", "exactly one of")),
    (PLAIN + f"[surface]\nheight_map = {MAP}", ("surface.height_map.path = 'a.npy'", "not a file")),
    (PLAIN + f"[surface]\nheight_map = {MAP}".replace("npy", "pkl"), ("path = 'a.pkl'", ".npy, .csv")),
    (PLAIN + '[surface]\nheight_map = { path = "a.npy" }', ("surface.height_map.spacing is missing", '"2 um"')),
    (PLAIN + '[surface]\nheight_map = "a.npy"', ("surface.height_map = 'a.npy'", "not a table", "path =")),
    (PLAIN + '[effects]\nspin = "yes"', ("effects.spin = 'yes'", "'auto', 'on' or 'off'")),
    (PLAIN + '[effects]\nfilm = "on"', ("effects.film = 'on'", "unknown key", "hysteresis")),
    (PLAIN + '[effects]\ncage = "on"', ("effects.cage = 'on'", "[cage]")),
    (PLAIN + "[friction]\ncoefficient = -0.1", ("friction.coefficient = -0.1", "0 to 5")),
    (PLAIN + "[friction]", ("friction.coefficient is missing", "0.1")),
    ("bearing = 5\n" + PLAIN.replace("[bearing]", "[spare]"), ("bearing = 5", "not a table", "[bearing]")),
    (changed(BEARING, 'catalog = "6206"'), ("bearing.catalog = '6206'", "give one of 6205")),
    (changed(BEARING, 'catalog = "../scenes/6205"'), ("bearing.catalog = '../scenes/6205'", "give one of")),
    (changed(BEARING, "catalog = [[6205]]"), ("bearing.catalog", "give one of 6205")),
    (changed(BEARING, ""), ("bearing.name is missing", "catalog", "and 2 more")),
    (changed(BEARING, BEARING + "\ninner = 7"), ("bearing.inner = 7", "not a table", "bottom_radius")),
    (changed(BEARING, BEARING + "\nball_count = 9.0"), ("bearing.ball_count = 9.0", "whole number")),
    (changed(BEARING, BEARING + "\nball_count = 17"), ("bearing.ball_count = 17", "at most 15 fit")),
    (
        changed(BEARING, BEARING + '\nball_material = "stel"'),
        ("bearing.ball_material = 'stel'", "peek, silicon_nitride, steel"),
    ),
    (
        changed(
            BEARING,
            BEARING + '\nball_material = { youngs_modulus = "5 GPa", poisson_ratio = 0.6, density = "0 g/cm^3" }',
        ),
        ("bearing.ball_material.poisson_ratio = 0.6", "0 to 0.49999", "bearing.ball_material.density = '0 g/cm^3'"),
    ),
    (
        changed(BEARING, BEARING + '\ninner.grove_radius = "4 mm"'),
        ("bearing.inner.grove_radius = '4 mm'", "did you mean groove_radius?"),
    ),
    (
        changed(BEARING, BEARING + '\ninner.groove_radius = "3.97 mm"'),
        ("bearing.inner.groove_radius = '3.97 mm'", "ball radius 3.97 mm", "line"),
    ),
    (
        changed(BEARING, BEARING + '\nouter.shoulder_half_width = "4.3 mm"'),
        ("bearing.outer.shoulder_half_width = '4.3 mm'", "4.21 mm"),
    ),
    (
        changed(BEARING, BEARING + '\nouter.bottom_radius = "23.9 mm"'),
        ("bearing.outer.bottom_radius = '23.9 mm'", "clearance of 0.86 mm", "0.8 mm"),
    ),
    (
        changed(BEARING, BEARING + '\ninner.bottom_radius = "16.1 mm"'),
        ("bearing.outer.bottom_radius = '23.48 mm'", "7.38 mm", "7.94 mm", "preload"),
    ),
    (
        changed(BEARING, BEARING + '\nouter.groove_radius = "24 mm"'),
        ("bearing.outer.groove_radius = '24 mm'", "bottom_radius 23.48 mm"),
    ),
    (
        changed(BEARING, BEARING + '\ninner.shoulder_half_width = "4.129 mm"\nouter.shoulder_half_width = "4.2 mm"'),
        ("bearing.inner.shoulder_half_width = '4.129 mm'", "19.5691 mm", "19.56 mm", "the rings touch"),
    ),
    (
        changed(BEARING, BEARING + '\nbore_diameter = "31.06 mm"'),
        ("bearing.bore_diameter = '31.06 mm'", "below", "31.06 mm"),
    ),
    (
        changed(BEARING, BEARING + '\noutside_diameter = "46.9 mm"'),
        ("bearing.outside_diameter = '46.9 mm'", "exceed", "46.96 mm"),
    ),
    (changed(BEARING, BEARING + '\nwidth = "6.1 mm"'), ("bearing.width = '6.1 mm'", "exceed", "6.2 mm")),
    (changed(BEARING, BEARING + "\nwidth = 15"), ("bearing.width = 15", "no unit")),
    (changed('{ rule = "solved" }', '"solved"'), ("bearing.contact_angle = 'solved'", "not a table", "rule")),
    (changed('"solved"', '"sloved"'), ("bearing.contact_angle.rule = 'sloved'", "'solved' or 'given'")),
    (changed('"solved"', '"given"'), ("bearing.contact_angle.value", '"0.18 rad"')),
    (changed('"solved"', '"given", value = "0 rad"'), ("bearing.contact_angle.value = '0 rad'", "above 0")),
    (changed('"solved"', '"given", value = 0.3'), ("bearing.contact_angle.value = 0.3", '"0.18 rad"')),
    (changed('"solved"', '"given", value = "18"'), ("bearing.contact_angle.value = '18'", "unit is missing")),
    (changed('"solved"', '"given", value = "18 %"'), ("bearing.contact_angle.value = '18 %'", "rad")),
    (changed('"solved"', '"solved", value = "0.3 rad"'), ("bearing.contact_angle.value = '0.3 rad'", "free")),
    (changed('"solved"', '"given", value = "0.3 rad", free = "0 rad"'), ("bearing.contact_angle.free = '0 rad'",)),
    (changed('"solved"', '"given", value = "48 deg"'), ("bearing.contact_angle.value = '48 deg'", "0.8276 rad")),
    (changed('"solved"', '"solved", free = "0.9 rad"'), ("bearing.contact_angle.free = '0.9 rad'", "0.8276 rad")),
    (CAGE + 'pocket_clearance = "0 mm"', ("cage.pocket_clearance = '0 mm'", '"0.2 mm"')),
    (CAGE + 'pocket_clearance = "5.5 mm"', ("cage.pocket_clearance = '5.5 mm'", "13.44 mm", "13.3422 mm")),
    (CAGE + 'pocket_diameter = "7.94 mm"', ("cage.pocket_diameter = '7.94 mm'", "ball_diameter 7.94 mm")),
    (CAGE + 'pocket_depth = "4.1 mm"', ("cage.pocket_depth = '4.1 mm'", "4.07 mm")),
    (CAGE + 'wall_thickness = "4.5 mm"', ("cage.wall_thickness = '4.5 mm'", "4.07 mm")),
    (CAGE + 'pocket_diameter = "12.9 mm"', ("cage.wall_thickness = '0.9 mm'", "0.442206 mm")),
    (CAGE + 'variant = "printed"', ("cage.variant = 'printed'", "as_printed")),
    (CAGE + "variant = [7]", ("cage.variant = [7]", "as_printed")),
    (CAGE + 'variant = "as_printed"\npocket_depth = "5 mm"', ("cage.pocket_depth = '5 mm'", "cage.variant")),
    (CAGE + 'pocket_diameter = "9 mm"\npocket_clearance = "1 mm"', ("cage", "exactly one of", "pocket_clearance")),
    (INLINE + '[effects.more]\na = "b"', ("effects.more", "unknown key")),
    (changed('mass = "3 g"', "", INLINE), ("cage.mass is missing", '"2.04 g"')),
    (changed('pocket_diameter = "6.3 mm"', "", INLINE), ("cage", "exactly one of")),
    (changed('pocket_diameter = "6.3 mm"', 'variant = "as_printed"', INLINE), ("cage.variant", "has none")),
    (PLAIN + "a = \n", ("not TOML", "line 9")),
    (PLAIN + "a = " + "[" * 5000, ("not TOML", "deep")),
    (PLAIN + "a = " + "7" * 5000, ("not TOML",)),
    (PLAIN + "a" + ".a" * 30_000 + " = 5", ("a.a.a", "at most four")),
    (PLAIN + '[a."b".' + "'c' . d." * 20 + "e]", ("b", "at most four")),
    (PLAIN + "name = 1979-99-99", ("not TOML",)),
]


@pytest.mark.parametrize(("text", "words"), MISTAKES, ids=range(len(MISTAKES)))
def test_a_mistake_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    message = refusal(text)
    assert message.startswith("case.toml: ")
    assert message.isprintable(), "one line, nothing that a terminal would act on"
    assert len(message) < 1500
    missing = [word for word in words if word not in message]
    assert not missing, message


def test_several_mistakes_come_together() -> None:
    message = refusal(changed('"2 %"', "7", changed('"700 N"', "700")))
    assert "tolerance = 7" in message
    assert "operation.axial_load = 700" in message


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "give the path of a scene file (built in: 6205)"),
        (b"\xff\xfe\x00n", "byte 0 is not UTF-8"),
        (b"#" * (LARGEST_FILE + 1), f"more than {LARGEST_FILE} bytes"),
        (b"\x00\x01\x02", "not TOML"),
    ],
)
def test_a_file_that_cannot_be_read_is_refused(tmp_path: Path, content: bytes | None, words: str) -> None:
    path = tmp_path / "broken.toml"
    if content is not None:
        path.write_bytes(content)
    with pytest.raises(InputError) as problem:
        load_scene(path)
    assert str(problem.value).startswith(f"{path}: ")
    assert words in str(problem.value)


@pytest.mark.parametrize("path", ["", ".", "no\0path", "two\nlines", "long" * 3000])
def test_what_is_no_file_is_refused(path: str) -> None:
    with pytest.raises(InputError) as problem:
        load_scene(path)
    assert str(problem.value).isprintable()


def test_a_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_bytes(b"\xef\xbb\xbf" + PLAIN.encode())
    assert load_scene(str(tmp_path / "scene.toml")).name == "a series"


def test_an_unknown_builtin_scene_is_refused() -> None:
    with pytest.raises(InputError, match="'6305'; give one of 6205"):
        builtin_scene("6305")


# Fuzz: the pieces of a scene file, garbled, give a Scene or a refusal in one line, never another exception.
PIECES = sorted({*PLAIN.split(), *INLINE.split(), *PLAIN.splitlines(), *INLINE.splitlines()})
JUNK = st.one_of(
    st.sampled_from(PIECES),
    st.sampled_from(["nan", "-inf", "1e400", "[[]]", "{}", '"5 °C"', '"1 dBm"', '"1 /m"', '"1 m/s/s"', "0o7", "'''"]),
    st.text(max_size=12),
    st.floats().map(repr),
    st.builds('"{} {}"'.format, st.floats(), st.text("mNPaskgrdu^*/1-2% ", max_size=8)),
)


@given(source=st.sampled_from([PLAIN, INLINE]), at=st.integers(0, 60), junk=JUNK, cut=st.integers(0, 2))
def test_a_garbled_file_is_read_or_refused(source: str, at: int, junk: str, cut: int) -> None:
    lines = source.splitlines()
    at %= len(lines)
    key, equals, _ = lines[at].partition("=")
    lines[at : at + cut] = [key + equals + junk]
    read_or_refused("\n".join(lines))


@given(text=st.one_of(st.text(), st.lists(st.sampled_from(PIECES)).map("\n".join)))
def test_any_text_is_read_or_refused(text: str) -> None:
    read_or_refused(text)


def read_or_refused(text: str) -> None:
    found = read(text)
    if isinstance(found, Scene):
        assert np.all(found.operation.axial_load > 0)
        assert found.bearing.groove_centre_distance > 0
    else:
        assert found.isprintable()


def read(text: str) -> Scene | str:
    try:
        return scene(text)
    except InputError as problem:
        return str(problem)
