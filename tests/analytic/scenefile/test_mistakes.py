"""Mistakes in scene files: every message is one line with the key, the value and a remedy, for any text."""

from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.errors import InputError
from analytic.scenefile.read import load_scene
from analytic.scenefile.text import LARGEST_FILE
from tests.analytic.scenefile.scene_texts import INLINE, OIL, PLAIN, ROUGH, changed, refusal, scene

BEARING = 'catalog = "paper_6205"'
MAP = '{ path = "a.npy", spacing = "1 um" }'
CAGE = PLAIN + "[cage]\n"
GREASED = """
[lubricant]
name = "ISO VG 68"
temperature = "40 degC"
supply = "grease"
[assumed.lubricant]
temperature = "a guess"
"""


def with_bearing(line: str) -> str:
    """The text with one more line in the table of the bearing."""
    return changed(BEARING, f"{BEARING}\n{line}")


MISTAKES = [  # text, and words of the message: key, value, what is accepted
    (changed('"700 N"', "700"), ("operation.axial_load = 700", "no unit", '"1 kN"')),
    (changed('"700 N"', '"700"'), ("operation.axial_load = '700'", "unit is missing", '"1 kN"')),
    (changed('"700 N"', '"700 mm"'), ("operation.axial_load = '700 mm'", "unit like kN")),
    (changed('"700 N"', '"700 newtonn"'), ("operation.axial_load", "'newtonn'", '"1 kN"')),
    (changed('"700 N"', '"1.200,7 N"'), ("operation.axial_load = '1.200,7 N'", "decimal point")),
    (changed('"700 N"', '"2,500 N"'), ("operation.axial_load = '2,500 N'", "ambiguous", "write 2500 N or 2.5 N")),
    (changed('"700 N"', '"-700 N"'), ("operation.axial_load = '-700 N'", "out of range", "0 to 100000 kN")),
    (changed('"700 N"', '"nan N"'), ("operation.axial_load = 'nan N'", '"1 kN"')),
    (changed('"700 N"', '"1e9999 N"'), ("operation.axial_load = '1e9999 N'", "finite")),
    (changed('"700 N"', '"9**9**9**9 N"'), ("operation.axial_load = '9**9**9**9 N'", '"1 kN"')),
    (changed('"700 N"', '"2**1000000 N"'), ("operation.axial_load", '"1 kN"')),
    (changed('"700 N"', '"7 N^9999999"'), ("operation.axial_load", '"1 kN"')),
    (changed('"700 N"', '"7 __import__"'), ("operation.axial_load", '"1 kN"')),
    (changed('"700 N"', '"700 N"\nmoment = "3 N"'), ("operation.moment = '3 N'", "unit like N m")),
    (changed('"700 N"', '"700 N"\ndown = [0, 0, 0]'), ("operation.down = [0, 0, 0] is no direction", "[1, 0, 0]")),
    (changed('"700 N"', '"700 N"\ndown = [3, 4]'), ("operation.down = [3, 4] is no direction",)),
    (changed('"700 N"', '"700 N"\ndown = [1, 0, 0, 0]'), ("is no direction",)),
    (changed('"700 N"', '"700 N"\ndown = [1, "x", 0]'), ("is no direction",)),
    (changed('"700 N"', '"700 N"\ndown = [1, inf, 0]'), ("is no direction",)),
    (changed('"700 N"', '"700 N"\ndown = "x"'), ("operation.down = 'x' is no direction",)),
    (changed('"700 N"', '"700 N"\nradial_load = []'), ("operation.radial_load = []", "empty")),
    (changed('"solved" }', '"solved", free = "0.1 rad" }\nclearance = "5 um"'),
        ("bearing.clearance = '5 um'", "contact_angle.free", "leave one of them out")),
    (changed('"700 N"', "[]"), ("operation.axial_load = []", "empty")),
    (changed('"700 N"', "true"), ("operation.axial_load = True", '"1 kN"')),
    (changed('"700 N"', '["5 N", "6 N", 7]'), ("operation.axial_load[2] = 7", "no unit")),
    (changed('"700 N"', '["5 N", "6 N", "7 N"]'), ("axial_load has 3", "inner_speed has 2", "equal lengths")),
    (changed('"100 rpm"', '"100 Hz"'), ("operation.inner_speed[0] = '100 Hz'", '"300 rpm"')),
    (changed('"100 rpm"', '"100 Hz"'), ("Hz may count turns or radians: write rpm", "-1e+07 to 1e+07 rpm")),
    (changed('"100 rpm"', '"100 s-1"'), ("s-1 may count turns or radians: write rpm",)),
    (changed('"700 N"', '"70 kg"'), ("operation.axial_load = '70 kg'", "kg is a mass: write kgf")),
    (changed('"700 N"', '"7 min-1"'), ("operation.axial_load = '7 min-1'", "unit like kN")),
    (changed('"700 N"', '"10² N"'), ("operation.axial_load = '10² N'", "not a number and a unit")),
    (changed('"700 N"', '"700 N"\nmoment = "3 Nmm"'), ("operation.moment = '3 Nmm'", "units stand apart: write N mm")),
    (changed('axial_load = "700 N"', ""), ("operation.axial_load leaves a point without any load", '"1000 N"')),
    (changed('"2 %"', "2"), ("tolerance = 2 ", "0.0001 to 100 %", '"5 %"')),
    (changed('"2 %"', "nan"), ("tolerance = nan", "finite")),
    (changed('"2 %"', '"0.02"'), ("tolerance = '0.02'", "no quotes")),
    (changed('"2 %"', "0x" + "f" * 6000), ("tolerance", "a number of some 7225 digits", "too large")),
    (changed('name = "a series"', ""), ("name is missing", "give a name")),
    (changed('name = "a series"', 'name = "two\\nlines"'), ("name = 'two\\nlines'", "printable")),
    (changed('name = "a series"', 'name = "a"\n"odd\\nkey" = 5'), ("'odd\\nkey' = 5", "unknown key")),
    (changed("tolerance", "tolerence"), (" tolerence = '2 %'", "did you mean tolerance?")),
    (PLAIN + '[weather]\nviscosity = "0.06 Pa s"',
        ("weather", "unknown key", "known: thermal", " more, see docs/scenes.md")),
    (OIL.replace('"2e-8 1/Pa"', "2e-8"), ("lubricant.pressure_viscosity = 2e-08", "no unit", '"2e-8 1/Pa"')),
    (OIL.replace('"2e-8 1/Pa"', '"2e-8 Pa"'), ("lubricant.pressure_viscosity = '2e-8 Pa'", "in a unit like 1/Pa")),
    (OIL.replace('"60 mPa s"', '"68 mm^2/s"'), ("lubricant.viscosity = '68 mm^2/s'", "Pa s", '"0.06 Pa s"')),
    (OIL.replace("eyring_sinh", "newtonian"), ("lubricant.traction = 'newtonian'", "eyring_sinh", "eyring_constant")),
    (OIL + 'temperature = "-80 degC"', ("lubricant.temperature = '-80 degC'", "-73.15 to 326.85 degC", '"40 degC"')),
    (OIL + 'temperature = "70 s"', ("lubricant.temperature = '70 s'", "unit like degC", '"40 degC"')),
    (OIL + 'compressible = "yes"', ("lubricant.compressible = 'yes'", "neither true nor false")),
    (OIL + "compressible = 1", ("lubricant.compressible = 1", "neither true nor false")),
    (OIL + "limiting_shear = 1.2", ("lubricant.limiting_shear = 1.2", "0 to 1")),
    (PLAIN + '[lubricant]\nviscosity = "0.06 Pa s"', ("lubricant.pressure_viscosity is missing", "2e-8 1/Pa")),
    ("lubricant = 7\n" + PLAIN, ("lubricant = 7", "not a table", "pressure_viscosity")),
    (PLAIN + "[surface]", ("surface", "exactly one of rms_roughness, Ra, finish and height_map")),
    ("surface = 7\n" + PLAIN, ("surface = 7", "not a table", "rms_roughness")),
    (ROUGH.replace('"0.1 um"', '"-0.1 um"'), ("surface.rms_roughness = '-0.1 um'", "out of range", '"0.1 um"')),
    (ROUGH.replace('"gaussian"', '"fractal"'), ("surface.autocorrelation.kind = 'fractal'", '"exponential"')),
    (ROUGH.replace('"60 um"', "60"), ("surface.autocorrelation.length = 60", "no unit", '"2 um"')),
    (ROUGH.replace(', spacing = "2 um"', ""), ("surface.autocorrelation.spacing is missing", '"2 um"')),
    (ROUGH + 'hardness = "780 HV"', ("surface.hardness = '780 HV'", '"7.8 GPa"')),
    (ROUGH + "boundary_friction = -0.1", ("surface.boundary_friction = -0.1", "0 to 5")),
    (ROUGH + 'gap = "flat"', ("surface.gap = 'flat'", "'elastic'", "'truncated'")),
    (ROUGH + 'asperities = "zhao_maietta_chang"', ("surface.asperities", 'gap = "truncated"', "leave it out")),
    (ROUGH.partition("autocorrelation")[0],
        ("surface.autocorrelation is missing", "goes with rms_roughness", '"60 um"')),
    (ROUGH + f"height_map = {MAP}", ("surface", "exactly one of")),
    (PLAIN + f"[surface]\nheight_map = {MAP}", ("surface.height_map.path = 'a.npy'", "not a file")),
    (PLAIN + f"[surface]\nheight_map = {MAP}".replace("npy", "pkl"), ("path = 'a.pkl'", ".npy, .csv")),
    (PLAIN + '[surface]\nheight_map = { path = "a.npy" }', ("surface.height_map.spacing is missing", '"2 um"')),
    (PLAIN + '[surface]\nheight_map = "a.npy"', ("surface.height_map = 'a.npy'", "not a table", "path =")),
    (ROUGH + 'gap = "truncated"\n[cage]\nmaterial = "peek"\n' + '[lubricant]\nname = "vg46"',
        ("surface.hardness is missing, and peek has none",)),
    (PLAIN + '[effects]\nspin = "yes"', ("effects.spin = 'yes'", "'auto', 'on' or 'off'")),
    (PLAIN + '[effects]\nfilm = "on"', ("effects.film = 'on'", "unknown key", "known: ")),
    (PLAIN + '[effects]\ncage = "on"', ("effects.cage = 'on'", "[cage]")),
    (PLAIN + '[effects]\ncage_dynamics = "on"', ("effects.cage_dynamics = 'on' needs a table [cage]",)),
    (PLAIN + "[friction]\ncoefficient = -0.1", ("friction.coefficient = -0.1", "0 to 5")),
    (PLAIN + "[friction]", ("friction.coefficient is missing", "0.1")),
    ("bearing = 5\n" + PLAIN.replace("[bearing]", "[spare]"), ("bearing = 5", "not a table", "[bearing]")),
    (changed(BEARING, 'catalog = "6299"'), ("bearing.catalog: bearing '6299'", "nearest: ", "by hand")),
    (changed(BEARING, 'catalog = "../scenes/6205"'), ("bearing.catalog: bearing '../scenes/6205'", "nearest: ")),
    (changed(BEARING, "catalog = [[6205]]"), ("bearing.catalog: [[6205]]", 'in quotes, for example "6206"')),
    (changed(BEARING, ""), ("bearing.ball_count is missing", 'catalog = "6206"', "bearing.ball_diameter is missing")),
    (changed("catalog", "catalogue"), (": bearing.catalogue = 'paper_6205' is an unknown key; did you mean catalog?",)),
    (with_bearing("inner = 7"), ("bearing.inner = 7", "not a table", "bottom_radius")),
    (with_bearing("ball_count = 9.0"), ("bearing.ball_count = 9.0", "whole number")),
    (with_bearing("ball_count = 17"), ("bearing.ball_count = 17", "at most 15 fit")),
    (with_bearing('ball_material = "stel"'), ("bearing.ball_material = 'stel'", "peek, silicon_nitride, steel")),
    (with_bearing('ball_material = { youngs_modulus = "5 GPa", poisson_ratio = 0.6, density = "0 g/cm^3" }'),
        ("bearing.ball_material.poisson_ratio = 0.6", "0 to 0.49999", "bearing.ball_material.density = '0 g/cm^3'")),
    (with_bearing('inner.grove_radius = "4 mm"'),
        ("bearing.inner.grove_radius = '4 mm'", "did you mean groove_radius?")),
    (with_bearing('inner.groove_radius = "3.97 mm"'),
        ("bearing.inner.groove_radius = '3.97 mm'", "ball radius 3.97 mm", "line")),
    (with_bearing('outer.shoulder_half_width = "4.3 mm"'), ("bearing.outer.shoulder_half_width = '4.3 mm'", "4.21 mm")),
    (with_bearing('outer.bottom_radius = "23.9 mm"'),
        ("bearing.outer.bottom_radius = '23.9 mm'", "clearance of 0.86 mm", "0.8 mm")),
    (with_bearing('inner.bottom_radius = "16.1 mm"'),
        ("bearing.outer.bottom_radius = '23.48 mm'", "7.38 mm", "7.94 mm", "preload")),
    (with_bearing('outer.groove_radius = "24 mm"'),
        ("bearing.outer.groove_radius = '24 mm'", "bottom_radius 23.48 mm")),
    (with_bearing('inner.shoulder_half_width = "4.129 mm"\nouter.shoulder_half_width = "4.2 mm"'),
        ("bearing.inner.shoulder_half_width = '4.129 mm'", "19.5691 mm", "19.56 mm", "the rings touch")),
    (changed(BEARING, 'catalog = "6205"\nclearance = "2 mm"'),
        ("bearing.clearance = '2 mm'", "clearance of 2 mm", "0.682668 mm")),
    (changed(BEARING, 'catalog = "6205"\nclearance = "-600 um"'),
        ("bearing.clearance = '-600 um'", "7.638 mm", "at least -0.3969 mm")),
    (changed(BEARING, 'catalog = "6205"\npitch_diameter = "60 mm"'),
        ("bearing.pitch_diameter = '60 mm'", "outer groove's bottom at 67.9442 mm", "outside diameter of 52 mm")),
    (changed(BEARING, 'catalog = "6205"\npitch_diameter = "32.8 mm"\nball_count = 7'),
        ("bearing.pitch_diameter = '32.8 mm'", "inner groove's bottom at 24.8558 mm", "bore of 25 mm")),
    (with_bearing('bore_diameter = "31.06 mm"'), ("bearing.bore_diameter = '31.06 mm'", "below", "31.06 mm")),
    (with_bearing('outside_diameter = "46.9 mm"'), ("bearing.outside_diameter = '46.9 mm'", "exceed", "46.96 mm")),
    (with_bearing('width = "6.1 mm"'), ("bearing.width = '6.1 mm'", "exceed", "6.2 mm")),
    (with_bearing('width = "6.3 mm"\ninner.shoulder_half_width = "3.2 mm"'),
        ("bearing.width = '6.3 mm'", "the wider groove, 6.4 mm")),
    (with_bearing("width = 15"), ("bearing.width = 15", "no unit")),
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
    (CAGE + 'pocket_diameter = "12.9 mm"\nwall_thickness = "0.45 mm"',
        ("cage.wall_thickness = '0.45 mm'", "at most the web between pockets, 0.442206 mm")),
    (CAGE + 'variant = "printed"', ("cage.variant = 'printed'", "as_printed")),
    (CAGE + "variant = [7]", ("cage.variant = [7]", "as_printed")),
    (CAGE + 'variant = "as_printed"\npocket_depth = "5 mm"', ("cage.pocket_depth = '5 mm'", "cage.variant")),
    (CAGE + 'start = "still"', ("cage.start = 'still'", '"sudden"')),
    (CAGE + "seeds = 1", ("cage.seeds = 1", "2 to 1000")),
    (CAGE + "steps_per_contact = 9", ("cage.steps_per_contact = 9", "10 to 1000")),
    (CAGE + "steps_per_contact = 40.5", ("cage.steps_per_contact = 40.5", "whole number")),
    (CAGE + 'duration = "0 s"', ("cage.duration", "0.0001 to 1000 s")),
    (CAGE + "restitution = 1.2", ("cage.restitution = 1.2", "0.05 to 1")),
    (CAGE + 'pocket_depth = "3.9 mm"', ("cage.pocket_depth = '3.9 mm'", "ball radius 3.97 mm")),
    (CAGE + 'pocket_approach = { load = "28 N" }', ("cage.pocket_approach.approach is missing",)),
    (CAGE + 'land = { ring = "middle", clearance = "0.3 mm", width = "9 mm" }', ("cage.land.ring = 'middle'",)),
    (CAGE + 'pocket_diameter = "9 mm"\npocket_clearance = "1 mm"', ("cage", "exactly one of", "pocket_clearance")),
    (with_bearing("conformity = 0.5") + GREASED, ("bearing.inner.groove_radius must exceed the ball radius 3.97 mm",)),
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
]  # fmt: skip


@pytest.mark.parametrize(("text", "words"), MISTAKES, ids=range(len(MISTAKES)))
def test_a_mistake_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    message = refusal(text)
    assert message.startswith("case.toml: ")
    assert message.isprintable(), "one line without control characters"
    assert len(message) < 1000
    missing = [word for word in words if word not in message]
    assert not missing, message


def test_a_wall_as_thick_as_the_web_between_pockets_is_accepted() -> None:
    assert scene(CAGE + 'pocket_diameter = "12.9 mm"\nwall_thickness = "0.44 mm"').cage is not None


def test_gravity_has_a_direction_of_any_length() -> None:
    assert scene(changed('"700 N"', '"700 N"\ndown = [3, 0, -4.0]')).down == pytest.approx((0.6, 0.0, -0.8), rel=1e-15)


def test_more_than_five_mistakes_are_counted() -> None:
    """Each of these keys of the operation is unknown."""
    for count, words in ((5, None), (7, "; and 2 more")):
        lines = "".join(f"\nodd{letter} = 3" for letter in "abcdefg"[:count])
        message = refusal(changed('"700 N"', f'"700 N"{lines}'))
        assert message.count("is an unknown key") == 5
        assert (words is None) == ("; and " not in message)
        assert words is None or message.endswith(words)


def test_a_misspelt_key_explains_the_keys_that_are_missing_without_it() -> None:
    for text in (changed("catalog", "catalogue", CAGE), changed("tolerance", "tolerence")):
        message = refusal(text)
        assert "did you mean" in message
        assert "is missing" not in message
    both = refusal(changed("tolerance", "tolerence", changed('name = "a series"', "")))
    assert both.index("tolerence") < both.index("name is missing")  # another key is missing for itself


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (OIL + 'rms_roughness = "0.1 um"', "did you mean surface.rms_roughness?"),
        (changed(BEARING, BEARING + '\naxial_load = "3 N"'), "did you mean operation.axial_load?"),
        (PLAIN + "[weather]", " and 13 more, see docs/scenes.md"),
    ],
)
def test_an_unknown_key_is_answered_in_short(text: str, words: str) -> None:
    message = refusal(text)
    assert words in message
    assert len(message) < 250  # a scene has more than a hundred keys, of 15 letters and more


def test_several_mistakes_are_reported_together() -> None:
    message = refusal(changed('"2 %"', "7", changed('"700 N"', "700")))
    assert "tolerance = 7" in message
    assert "operation.axial_load = 700" in message


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "give the path of a scene file (built in: 6205-dry, paper_6205)"),
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
def test_a_path_that_is_no_file_is_refused(path: str) -> None:
    with pytest.raises(InputError) as problem:
        load_scene(path)
    assert str(problem.value).isprintable()


@pytest.mark.parametrize("name", ["6205.tml", "6205.txt", "6205.JSON", "6205.yaml"])
def test_a_name_with_an_extension_is_a_file_and_no_bearing(name: str) -> None:
    with pytest.raises(InputError, match=f"^{name}: No such file"):
        load_scene(name)
    assert load_scene("6205.C3").bearing.series == "62"


def test_a_designation_without_quotes_is_refused() -> None:
    """From Python, where 6206 is a number."""
    with pytest.raises(InputError, match='write it in quotes: "6206"'):
        load_scene(6206)  # type: ignore[arg-type]


def test_a_file_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_bytes(b"\xef\xbb\xbf" + PLAIN.encode())
    assert load_scene(str(tmp_path / "scene.toml")).name == "a series"


# Fuzzing: garbled scene files give a Scene or a message of one line, never another exception.
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
    try:
        outcome = scene(text)
    except InputError as problem:
        outcome = str(problem)
    if isinstance(outcome, str):
        assert outcome.isprintable()
    else:
        assert np.all(outcome.operation.axial_load > 0)
        assert outcome.bearing.groove_centre_distance > 0
