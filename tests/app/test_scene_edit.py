"""Fields that change the text of a scene: what is read afterwards, and that all else of the text stays."""

import tomllib

import pytest

from analytic.errors import InputError
from analytic.scenefile.read import load_scene, parse_scene
from analytic.scenefile.template import scene_text
from fembearing.app.evaluation import at_once
from fembearing.app.scene_edit import FIELDS, OPERATION, field_in, of_bearing, values_in, with_typed, with_value

USUAL = scene_text("6206")
TYPED = {  # by the fields, what a scene has after it
    "operation.radial_load": ("2,5 kN", "2.5 kN"),
    "operation.axial_load": ("320N", "320 N"),
    "operation.inner_speed": ("730", "730 rpm"),
    "operation.moment": ("2,5 N m", "2.5 N m"),
    "operation.tilt": ("free", "free"),
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
    "bearing.static_load_rating": ("11,2 kN", "11.2 kN"),
    "bearing.dynamic_load_rating": ("19.4kN", "19.4 kN"),
    "bearing.clearance": ("C3", "C3"),
    "mounting.shaft_interference": ("7um", "7 um"),
    "mounting.housing_interference": ("-5 um", "-5 um"),
    "mounting.inner_temperature": ("75C", "75 degC"),
    "mounting.outer_temperature": ("66 degC", "66 degC"),
    "arrangement.kind": ("X", "X"),
    "arrangement.preload": ("90N", "90 N"),
    "arrangement.offset": ("12um", "12 um"),
    "arrangement.distance": ("31 mm", "31 mm"),
    "cage.pocket_clearance": ("0.3 mm", "0.3 mm"),
    "cage.wall_thickness": ("1.3mm", "1.3 mm"),
    "cage.mass": ("13 g", "13 g"),
    "cage.material": ("peek", "peek"),
    "losses.seals": ("6 N mm", "6 N mm"),
    "losses.drag": ("2,5 N mm", "2.5 N mm"),
    "losses.oil_share": ("3 %", "3 %"),
    "losses.oil_flow": ("0.7 l/min", "0.7 l/min"),
    "thermal.resistance": ("0,6 K/W", "0.6 K/W"),
    "thermal.ambient": ("31C", "31 degC"),
}
BESIDE = {  # what has a meaning only, or a torque only, with others
    "operation.radial_load": {"operation.axial_load": "210 N"},
    "lubricant.temperature": {"thermal.resistance": "0.3 K/W", "thermal.ambient": "22 degC"},
    "arrangement.distance": {"arrangement.kind": "O", "arrangement.preload": "90 N"},
    # A cage of which nothing is given gives way to its balls.
    **{key: {"cage.mass": "13 g"} for key in ("cage.pocket_clearance", "cage.wall_thickness", "cage.material")},
    "cage.mass": {"cage.wall_thickness": "1.3 mm"},
}
# Without the first, or with one of the last alone, a scene has no torque.
NOT_ALONE = {"operation.inner_speed", "lubricant.name", "surface.finish"}
NOT_ALONE |= {"mounting.inner_temperature", "mounting.outer_temperature"}


@pytest.mark.parametrize("key", FIELDS)
def test_a_field_changes_its_key_and_no_other(key: str) -> None:
    """Cleared again, it leaves no key and no table."""
    typed, value = TYPED[key]
    table, _, name = key.partition(".")
    changed, _ = with_typed(USUAL, key, typed)
    assert values_in(changed) == values_in(USUAL) | {key: value}
    before, after = USUAL.rstrip().split("\n"), changed.rstrip().split("\n")
    if len(after) > len(before):  # the usual scene has no such line
        assert [line for line in after if line and line not in before][-1].startswith(f"{name} = ")
    else:
        *head, line = [new for old, new in zip(before, after, strict=True) if old != new]
        assert [each.split()[0] for each in head] == ([f"[{table}]"] if f"\n#[{table}]" in USUAL else [])
        assert line.partition("=")[0].strip() == name
        assert ("#" in line) == any(f"{name} =" in old and "#" in old[1:] for old in before)
    if key not in values_in(USUAL):
        cleared, _ = with_typed(changed, key, " ")
        assert tomllib.loads(cleared) == tomllib.loads(USUAL)


@pytest.mark.parametrize("key", sorted({*FIELDS} - NOT_ALONE))
def test_an_empty_field_shows_what_the_torque_is_computed_with(key: str) -> None:
    """Typed in, it gives the same torque."""
    text = USUAL
    for other, value in BESIDE.get(key, {}).items():
        text = with_value(text, other, value)
    found = at_once(with_value(text, key, None))
    derived = found.derived[key]
    if derived == "none":
        return
    alone = USUAL if key == "lubricant.temperature" else text  # friction settles it no longer
    again = at_once(with_typed(alone, key, derived)[0])
    assert again.derived[key] == derived
    # It has 6 digits.
    assert again.row["torque_total"] == pytest.approx(found.row["torque_total"], rel=1e-4)


def test_an_empty_field_shows_the_seals_and_the_cage_of_the_designation() -> None:
    angular = at_once(scene_text("7208B"))
    assert angular.derived["bearing.clearance"] == f"{1e6 * angular.result.scene.bearing.diametral_clearance:g} um"
    found = at_once(scene_text("6305-2RS"))
    scene = found.result.scene
    assert scene.losses.seals
    assert scene.cage
    assert found.derived["losses.seals"] == f"{1e3 * scene.losses.seals:g} N mm"
    assert found.derived["cage.mass"] == f"{1e3 * scene.cage.mass:g} g"


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


def test_another_bearing_has_its_own_dimensions_and_cage_and_what_was_cleared_stays_so() -> None:
    changed = USUAL
    for key, typed in {"bearing.ball_diameter": "9.4 mm", "cage.mass": "13 g", "operation.axial_load": "320 N"}.items():
        changed, _ = with_typed(changed, key, typed)
    changed, _ = with_typed(changed, "operation.radial_load", "")
    usual = {key: value for key, value in values_in(scene_text("6308")).items() if key != "operation.radial_load"}
    assert values_in(of_bearing("6308", changed)) == usual | {"operation.axial_load": "320 N"}


def test_the_last_key_of_the_seats_takes_their_table_away() -> None:
    first, _ = with_typed(USUAL, "mounting.inner_temperature", "75 degC")
    second, _ = with_typed(first, "mounting.outer_temperature", "66 degC")
    assert parse_scene(second, origin="here").bearing != parse_scene(USUAL, origin="here").bearing
    without, _ = with_typed(second, "mounting.inner_temperature", "")
    assert "\n[mounting]" in without
    without, _ = with_typed(without, "mounting.outer_temperature", "")
    assert "\n[mounting]" not in without
    assert with_typed(without, "mounting.inner_temperature", "75 degC")[0].count("[mounting]") == 1


def test_a_refused_value_is_put_beside_its_field() -> None:
    wrong, _ = with_typed(USUAL, "operation.radial_load", "5 kg")
    with pytest.raises(InputError) as refused:
        parse_scene(wrong, origin="scene")
    assert field_in(str(refused.value)) == "operation.radial_load"
    assert field_in("the bearing is blue") is None


def test_only_lines_of_the_own_table_count() -> None:
    text = '[cage]\nmass = "3 g"\n#[lubricant]\n#name = "oil"\n[bearing]\n#mass = "5 g"\ncatalog = "6206"\n'
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
