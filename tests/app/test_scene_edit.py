"""Fields that change the text of a scene: what is read afterwards, and that all else of the text stays."""

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.template import scene_text
from fembearing.app.scene_edit import (
    FIELDS,
    OPERATION,
    commented_value,
    field_in,
    has_table,
    of_bearing,
    values_in,
    with_cage,
    with_dimensions,
    with_typed,
    with_value,
)

USUAL = scene_text("6206")
TYPED = {  # by the fields, what a scene has after it
    "operation.radial_load": ("2,5 kN", "2.5 kN"),
    "operation.axial_load": ("320N", "320 N"),
    "operation.inner_speed": ("730", "730 rpm"),
    "lubricant.name": ("ISO VG 46", "ISO VG 46"),
    "lubricant.temperature": ("81C", "81 degC"),
    "lubricant.supply": ("grease", "grease"),
    "surface.finish": ("superfinished", "superfinished"),
    "bearing.ball_count": ("8", 8),
    "bearing.ball_diameter": ("9,5 mm", "9.5 mm"),
    "bearing.pitch_diameter": ("46.5mm", "46.5 mm"),
    "bearing.inner.conformity": ("0.515", 0.515),
    "bearing.outer.conformity": ("0.525", 0.525),
    "bearing.inner.shoulder_half_width": ("3.5 mm", "3.5 mm"),
    "bearing.outer.shoulder_half_width": ("3.6 mm", "3.6 mm"),
    "bearing.clearance": ("C3", "C3"),
    "mounting.shaft_interference": ("7um", "7 um"),
    "mounting.housing_interference": ("-5 um", "-5 um"),
    "mounting.inner_temperature": ("75C", "75 degC"),
    "mounting.outer_temperature": ("66 degC", "66 degC"),
    "cage.pocket_clearance": ("0.3 mm", "0.3 mm"),
    "cage.wall_thickness": ("1.3mm", "1.3 mm"),
    "cage.mass": ("13 g", "13 g"),
    "cage.material": ("peek", "peek"),
}


@pytest.mark.parametrize("key", FIELDS)
def test_a_field_changes_its_key_and_no_other(key: str) -> None:
    typed, value = TYPED[key]
    usual = with_cage(USUAL, has_cage=key.startswith("cage."))
    changed, _ = with_typed(usual, key, typed)
    assert values_in(changed) == values_in(usual) | {key: value}
    before, after = usual.split("\n"), changed.split("\n")
    *head, line = [new for old, new in zip(before, after, strict=True) if old != new]
    assert [each.split()[0] for each in head] == (["[mounting]"] if key.startswith("mounting.") else [])
    assert line.partition("=")[0].strip() == key.partition(".")[2]
    assert ("#" in line) == any(f"{key.partition('.')[2]} =" in old and "#" in old[1:] for old in before)


def test_the_scene_is_that_of_the_options_of_the_command_line() -> None:
    text = USUAL
    for key in OPERATION:
        if key != "surface.finish":
            text, _ = with_typed(text, key, TYPED[key][0])
    options = {"radial_load": "2,5 kN", "axial_load": "320N", "speed": "730", "oil": "ISO VG 46"}
    shown = parse_scene(text, origin="here")
    told = load_scene("6206", settings={}, **options, temperature="81C", supply="grease")
    for name, values in told.operation.points.items():
        assert getattr(shown.operation, name).tolist() == values.tolist()
    # The note that a speed without a unit is read as rpm is a warning of the scene there, and stands beside the field.
    others = vars(told).keys() - {"operation", "usual", "warnings"}
    assert {name: getattr(shown, name) for name in others} == {name: getattr(told, name) for name in others}


def test_an_empty_field_leaves_its_key_out_and_a_later_one_takes_its_line() -> None:
    first, _ = with_typed(USUAL, "lubricant.supply", "oil_spot")
    without, _ = with_typed(first, "lubricant.supply", " ")
    assert "lubricant.supply" not in values_in(without)
    again, _ = with_typed(without, "lubricant.supply", "oil_spot")
    assert again == first
    assert with_typed(without, "lubricant.supply", "")[0] == without


def test_a_key_whose_table_is_missing_gets_it() -> None:
    changed = with_value('name = "dry"\n[friction]\ncoefficient = 0.1', "surface.finish", "ground")
    assert values_in(changed) == {"surface.finish": "ground"}
    assert changed.startswith('name = "dry"\n[friction]\ncoefficient = 0.1\n')


@pytest.mark.parametrize(
    "text",
    [
        'operation = { inner_speed = "500 rpm" }',
        'operation.inner_speed = "500 rpm"',
        '[operation]\ninner_speed = [\n "500 rpm",\n "700 rpm",\n]',
    ],
)
def test_a_key_that_stands_in_another_way_is_not_changed(text: str) -> None:
    with pytest.raises(InputError, match=r"operation\.inner_speed .*change it in the scene"):
        with_typed(text, "operation.inner_speed", "730 rpm")


def test_another_bearing_keeps_what_was_changed() -> None:
    changed, _ = with_typed(USUAL, "operation.inner_speed", "730 rpm")
    moved = of_bearing("6308", changed)
    assert values_in(moved) == values_in(scene_text("6308")) | {"operation.inner_speed": "730 rpm"}
    assert values_in(of_bearing("6206", moved)) == values_in(changed)


def test_another_bearing_has_its_own_dimensions_and_the_cage_of_its_balls() -> None:
    changed, _ = with_typed(with_cage(USUAL, has_cage=True), "bearing.ball_diameter", "9.4 mm")
    changed, _ = with_typed(changed, "mounting.shaft_interference", "7 um")
    usual = values_in(with_cage(scene_text("6308"), has_cage=True))
    assert values_in(of_bearing("6308", changed)) == usual | {"mounting.shaft_interference": "7 um"}


def test_a_cage_is_put_in_and_taken_away() -> None:
    with_one = with_cage(USUAL, has_cage=True)
    cage = parse_scene(with_one, origin="here").cage
    assert cage is not None
    assert cage.mass == 0.011
    assert with_cage(with_one, has_cage=True) == with_one
    assert with_cage(with_one, has_cage=False) == USUAL
    # A text without the comments gets them from the usual scene of its bearing.
    bare = '[bearing]\ncatalog = "6206"\n'
    assert values_in(with_cage(bare, has_cage=True)) == values_in(bare) | {
        key: value for key, value in values_in(with_one).items() if key.startswith("cage.")
    }
    assert has_table(with_cage("[bearing]\nball_count = 7\n", has_cage=True), "cage")


def test_the_last_key_of_the_seats_takes_their_table_away() -> None:
    first, _ = with_typed(USUAL, "mounting.inner_temperature", "75 degC")
    second, _ = with_typed(first, "mounting.outer_temperature", "66 degC")
    assert parse_scene(second, origin="here").bearing != parse_scene(USUAL, origin="here").bearing
    without, _ = with_typed(second, "mounting.inner_temperature", "")
    assert has_table(without, "mounting")
    without, _ = with_typed(without, "mounting.outer_temperature", "")
    assert not has_table(without, "mounting")
    assert with_typed(without, "mounting.inner_temperature", "75 degC")[0].count("[mounting]") == 1


@pytest.mark.parametrize("designation", ["6206", "7208B"])
def test_dimensions_to_edit_are_those_of_the_bearing(designation: str) -> None:
    text = scene_text(designation)
    own = with_dimensions(text)
    assert "\nball_diameter = " in own
    given, derived = (parse_scene(each, origin="here").bearing for each in (own, text))
    # The text has 7 digits.
    assert given.ball_diameter == pytest.approx(derived.ball_diameter, rel=1e-6)
    assert given.inner.groove_radius == pytest.approx(derived.inner.groove_radius, rel=1e-4)  # conformity has %g
    assert given.ball_count == derived.ball_count
    changed = parse_scene(with_value(own, "bearing.ball_count", derived.ball_count - 1), origin="here").bearing
    assert changed.ball_count == derived.ball_count - 1


def test_a_refused_value_is_put_beside_its_field() -> None:
    wrong, _ = with_typed(USUAL, "operation.radial_load", "5 kg")
    with pytest.raises(InputError) as refused:
        parse_scene(wrong, origin="scene")
    assert field_in(str(refused.value)) == "operation.radial_load"
    assert field_in("the bearing is blue") is None


def test_only_comments_and_lines_of_the_own_table_count() -> None:
    text = '[cage]\nmass = "3 g"\n#[lubricant]\n#name = "oil"\n[bearing]\n#mass = "5 g"\ncatalog = "6206"\n'
    assert commented_value(text, "bearing.mass") == "5 g"
    assert commented_value(text, "cage.mass") == ""
    assert commented_value(text, "lubricant.name") == "oil"
    assert commented_value(text, "surface.finish") == ""
    changed = with_value(text, "lubricant.name", "other")
    assert "\n[lubricant]\n" in changed
    assert values_in(changed)["lubricant.name"] == "other"
    assert with_value(text, "surface.finish", None) == text  # nothing to leave out


def test_a_key_that_is_set_counts_before_its_comment_and_the_first_of_each() -> None:
    text = '[lubricant]\n#name = "a"\nname = "b"\n#name = "c"\n'
    assert with_value(text, "lubricant.name", "d").split("\n")[1:4] == ['#name = "a"', 'name = "d"', '#name = "c"']
    assert with_value(text, "lubricant.name", None).split("\n")[2] == '#name = "b"'
    bare = '[lubricant]\n#name = "a"\n#name = "c"\ntemperature = "50 degC"\n'
    assert with_value(bare, "lubricant.name", "d").split("\n")[1:3] == ['name = "d"', '#name = "c"']
    assert with_value("[lubricant]\n", "lubricant.name", "d").startswith('[lubricant]\nname = "d"\n')
