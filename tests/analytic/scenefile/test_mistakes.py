"""Mistakes in scene files: every message is one line with the key, the value and a remedy, for any text."""

import math
import re
import tomllib
from collections.abc import Iterator
from pathlib import Path

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.declared import AnyText, Key
from analytic.errors import InputError
from analytic.scenefile.find import LARGEST_FILE
from analytic.scenefile.keys import scene_key, scene_table, with_key
from analytic.scenefile.kinds import Extent
from analytic.scenefile.read import load_scene, scene_of
from analytic.scenefile.setting import read_setting
from tests.analytic.scenefile.scene_texts import INLINE, OIL, PLAIN, ROUGH, changed, refusal, scene

BEARING = 'catalog = "paper_6205"'
MAP = '{ path = "a.npy", spacing = "1 um" }'
CAGE = PLAIN + "[cage]\n"


def with_bearing(line: str) -> str:
    """The text with one more line in the table of the bearing."""
    return changed(BEARING, f"{BEARING}\n{line}")


SLIPS = [  # of people: text, and words of the message
    (changed('"700 N"', '"1.200,7 N"'), ("operation.axial_load = '1.200,7 N'", "decimal point")),
    (changed('"700 N"', '"2,500 N"'), ("operation.axial_load = '2,500 N'", "ambiguous", "write 2500 N or 2.5 N")),
    (changed('"700 N"', '"700 N"\ndown = [1, inf, 0]'), ("operation.down", "is no direction", "[1, 0, 0]")),
    (changed('"700 N"', '"700 N"\nradial_load = []'), ("operation.radial_load = []", "empty")),
    (changed('"700 N"', '["5 N", "6 N", 7]'), ("operation.axial_load[2] = 7", "no unit")),
    (changed('"700 N"', '["5 N", "6 N", "7 N"]'), ("axial_load has 3", "inner_speed has 2", "equal lengths")),
    (changed('"100 rpm"', '"100 Hz"'), ("inner_speed[0] = '100 Hz'", "Hz may count turns or radians: write rpm")),
    (changed('"700 N"', '"70 kg"'), ("operation.axial_load = '70 kg'", "kg is a mass: write kgf")),
    (changed('axial_load = "700 N"', ""), ("operation.axial_load leaves a point without any load", '"1000 N"')),
    (changed('"2 %"', "0x" + "f" * 6000), ("tolerance", "a number of some 7225 digits", "too large")),
    (changed('name = "a series"', ""), ("name is missing", "give a name")),
    (changed('name = "a series"', 'name = "a"\n"odd\\nkey" = 5'), ("'odd\\nkey' = 5", "unknown key")),
    (changed("tolerance", "tolerence"), (" tolerence = '2 %'", "did you mean tolerance?")),
    (PLAIN + f"[surface]\nheight_map = {MAP}", ("surface.height_map.path = 'a.npy'", "not a file")),
    (PLAIN + f"[surface]\nheight_map = {MAP}".replace("npy", "pkl"), ("path = 'a.pkl'", ".npy, .csv")),
    (ROUGH + 'gap = "truncated"\n[cage]\nmaterial = "peek"\n[lubricant]\nname = "vg46"',
        ("surface.hardness is missing, and peek has none",)),
    (PLAIN + '[effects]\ncage_dynamics = "on"', ("effects.cage_dynamics = 'on' needs a table [cage]",)),
    (PLAIN + "[friction]", ("friction.coefficient is missing", "0.1")),
    (changed(BEARING, 'catalog = "6299"'), ("bearing.catalog = '6299' is not in the catalogue", "nearest:")),
    (changed(BEARING, "catalog = [[6205]]"), ("bearing.catalog = [[6205]]", 'in quotes, for example "6206"')),
    (changed(BEARING, ""), ("bearing.ball_count is missing", 'catalog = "6206"', "bearing.ball_diameter is missing")),
    (changed("catalog", "catalogue"), (": bearing.catalogue = 'paper_6205' is an unknown key; did you mean catalog?",)),
    (with_bearing('ball_material = "stel"'), ("bearing.ball_material = 'stel'", "peek, silicon_nitride, steel")),
    (with_bearing('outer.bottom_radius = "23.9 mm"'),
        ("bearing.outer.bottom_radius = '23.9 mm'", "clearance of 0.86 mm", "0.8 mm")),
    (with_bearing('inner.shoulder_half_width = "4.129 mm"\nouter.shoulder_half_width = "4.2 mm"'),
        ("bearing.inner.shoulder_half_width = '4.129 mm'", "19.5691 mm", "19.56 mm", "the rings touch")),
    (changed(BEARING, 'catalog = "6205"\nclearance = "-600 um"'),
        ("bearing.clearance = '-600 um'", "7.638 mm", "at least -0.3969 mm")),
    (changed(BEARING, 'catalog = "6205"\npitch_diameter = "60 mm"'),
        ("bearing.pitch_diameter = '60 mm'", "outer groove's bottom at 67.9442 mm", "outside diameter of 52 mm")),
    (changed('"solved"', '"given"'), ("bearing.contact_angle.value", '"0.18 rad"')),
    (changed('"solved"', '"solved", value = "0.3 rad"'), ("bearing.contact_angle.value = '0.3 rad'", "free")),
    (changed('"solved"', '"given", value = "48 deg"'), ("bearing.contact_angle.value = '48 deg'", "0.8276 rad")),
    (CAGE + 'pocket_clearance = "5.5 mm"', ("cage.pocket_clearance = '5.5 mm'", "13.44 mm", "13.3422 mm")),
    (CAGE + 'variant = "as_printed"\npocket_depth = "5 mm"', ("cage.pocket_depth = '5 mm'", "cage.variant")),
    (CAGE + 'pocket_diameter = "9 mm"\npocket_clearance = "1 mm"', ("cage", "exactly one of", "pocket_clearance")),
    (changed('mass = "3 g"', "", INLINE), ("cage.mass is missing", '"2.04 g"')),
    (PLAIN + "a = " + "[" * 5000, ("not TOML", "deep")),
    (PLAIN + "a" + ".a" * 30_000 + " = 5", ("a.a.a", "at most four")),
    (PLAIN + "name = 1979-99-99", ("not TOML",)),
]  # fmt: skip
DOCUMENT = tomllib.loads(PLAIN)


def wrong_values(key: Key) -> Iterator[object]:
    """Values that no such key takes: below, above, without a unit, in a wrong one, no number, of another type."""
    yield {"a": "table"}
    dimension = key.dimension
    if dimension is None:
        yield from () if isinstance(key.kind, AnyText) else (-1, "no such word")
        return
    yield True
    unit = dimension.shown_unit
    for bound, beyond in ((dimension.low, -1), (dimension.high, 1)):
        shown = float(dimension.written(bound))
        yield f"{shown + beyond * max(abs(shown), 1.0) * 1e-3!r} {unit}" if unit else bound + beyond
    if dimension.unit:
        yield from (0.5, "0.5", f"nan {unit}", "0.5 kat")
    elif not isinstance(key.kind, Extent):  # a share, or a length
        yield from ("0.5", "0.5 mm", math.nan)


def refusals() -> Iterator[tuple[str, object]]:
    for path in scene_table().paths():
        key = scene_key(path)
        inside = path.rpartition(".")[0].endswith("material")
        if not inside or path.startswith("bearing.ball_material."):  # once for all materials
            yield from ((path, value) for value in wrong_values(key))


@pytest.mark.parametrize(("path", "value"), [*refusals()])
def test_a_value_that_a_key_does_not_take_is_refused_with_one_that_it_takes(path: str, value: object) -> None:
    document = with_key(DOCUMENT, path, value)
    with pytest.raises(InputError) as refused:
        scene_of(document, origin="here")
    message = str(refused.value)
    assert message.isprintable()
    named = re.search(rf"(?<![\w.]){re.escape(path)}(?:\[0\])?(?:\.a)? (= .*|is an unknown key)", message)
    assert named, message
    example = re.search(r"for example (\"[^\"]*\"|[\d.e+-]+)", named[0])
    if example and scene_key(path).dimension is not None:
        in_a_file, typed = tomllib.loads(f"v = {example[1]}")["v"], example[1].strip('"')
        for remedy in (in_a_file, read_setting(path, typed)[0]):  # as --set and options have it
            assert np.isfinite(scene_key(path).read(remedy))  # raises ValueError for what is refused


@pytest.mark.parametrize(("text", "words"), SLIPS, ids=range(len(SLIPS)))
def test_a_slip_is_named_in_one_line(text: str, words: tuple[str, ...]) -> None:
    message = refusal(text)
    assert message.startswith("case.toml: ")
    assert message.isprintable(), "one line without control characters"
    assert len(message) < 1000
    missing = [word for word in words if word not in message]
    assert not missing, message


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


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (None, "fembearing init 6206 writes a scene file"),
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
