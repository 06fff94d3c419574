"""Bearings of a scene: by designation, by what engineers have, and where each dimension comes from."""

import math
from typing import Any

import numpy as np
import pytest

import analytic
from analytic.catalog.bearing_rows import bearing_names, find_bearing
from analytic.errors import InputError
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import Bearing
from analytic.scenefile.fit import bearing_misfits
from tests.analytic.scenefile.scene_texts import refusal, scene

HEAD = 'name = "by hand"\ntolerance = "3 %"\n[operation]\naxial_load = "700 N"\ninner_speed = "90 rpm"\n[bearing]\n'
HAND = HEAD + 'ball_count = 8\nball_diameter = "10 mm"\npitch_diameter = "50 mm"\nconformity = 0.53\n'
PLAY = 'clearance = "16 um"\n'


def bearing(text: str) -> Bearing:
    return scene(text).bearing


def named(name: str, keys: str = "") -> Bearing:
    return bearing(f'{HEAD}catalog = "{name}"\n{keys}')


def test_bottom_radii_follow_from_pitch_ball_and_clearance() -> None:
    made = bearing(HAND + PLAY)
    # r_i = (50 - 10 - 0.008)/2 mm by hand; round-off
    np.testing.assert_allclose((made.inner.bottom_radius, made.outer.bottom_radius), (19.996e-3, 30.004e-3), rtol=1e-12)
    assert (made.inner.groove_radius, made.outer.groove_radius) == pytest.approx((5.3e-3, 5.3e-3), rel=1e-12)
    assert made.inner.shoulder_half_width is None


def test_a_ball_without_mass_is_solid() -> None:
    """7.83 g/cm3 of 100Cr6 [NSK's print]; a sphere of 10 mm has 523.6 mm3."""
    made = bearing(HAND + PLAY + 'ball_material = "100Cr6"\n')
    np.testing.assert_allclose(made.ball_mass, 523.5988e-9 * 7830, rtol=1e-6)  # digits of the volume
    given = bearing(HAND + PLAY + 'ball_mass = "4.05 g"\n')
    assert given.ball_mass == 4.05e-3


def test_the_nominal_angle_is_that_of_the_unloaded_bearing() -> None:
    """The free angle by the ring's own equilibrium, at a load that does not press the contacts together."""
    made = scene(HAND.replace("700 N", "1e-6 N") + 'contact_angle = { nominal = "23 deg" }\n')
    balls = thrust_equilibrium(made.bearing, made.contact_angle, axial_load=made.operation.axial_load)
    # 1e-6 N presses by 1e-10 m of a groove distance of 0.6 mm.
    assert math.degrees(float(balls["angle"].ravel()[0])) == pytest.approx(23, rel=1e-4)


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_a_shoulder_by_height_diameter_or_half_width_is_the_same(ring: str) -> None:
    """Height 2 mm on a profile of 5.3 mm: the half width is the chord sqrt(5.3^2 - 3.3^2) = 4.14729 mm."""
    bottom = {"inner": 19.996, "outer": 30.004}[ring]
    diameter = 2 * (bottom + 2 if ring == "inner" else bottom - 2)
    for key in (
        'shoulder_height = "2 mm"',
        f'shoulder_diameter = "{diameter} mm"',
        'shoulder_half_width = "4.1472883 mm"',
    ):
        near = getattr(bearing(f"{HAND}{PLAY}{ring}.{key}\n"), ring)
        far = getattr(bearing(f'{HAND}{PLAY}{ring} = {{ shoulder_height = "2.5 mm", far_{key} }}\n'), ring)
        assert near.shoulder_half_width == pytest.approx(4.1472883e-3, rel=1e-6)
        assert (near.far_shoulder_half_width, far.far_shoulder_half_width) == (
            None,
            pytest.approx(4.1472883e-3, rel=1e-6),
        )


def test_a_group_of_clearance_is_taken_in_its_middle() -> None:
    made = bearing(HAND + 'clearance = "C4"\nbore_diameter = "35 mm"\n')
    np.testing.assert_allclose(made.diametral_clearance, 37e-6, rtol=1e-9)  # 28 to 46 um; a difference of radii
    origin = made.origins["clearance"]
    assert origin.status == "printed"
    assert origin.uncertainty == pytest.approx(18e-6 / math.sqrt(12), rel=1e-9)  # of a uniform distribution


def test_the_clearance_of_a_nominal_angle_is_as_uncertain_as_the_angle() -> None:
    """1.5 degrees, by a difference of 2 A_0 (1 - cos al) with A_0 = 0.6 mm."""
    origin = bearing(HAND + 'contact_angle = { nominal = "23 deg" }\n').origins["clearance"]
    step = 0.01
    less, more = (1.2e-3 * (1 - math.cos(math.radians(23 + side * step))) for side in (-1, 1))
    assert origin.uncertainty == pytest.approx((more - less) / (2 * step) * 1.5, rel=1e-6)
    assert origin.source == "closes at the unloaded contact angle of 23 deg"


def test_a_series_is_that_of_its_boundary_dimensions() -> None:
    assert named("6206").series == find_bearing("6206").series is not None
    for key in ('bore_diameter = "29 mm"', 'outside_diameter = "63 mm"', 'width = "15 mm"'):
        assert named("6206", key + "\n").series is None
    assert bearing(HAND + PLAY).series is None


def test_own_dimensions_replace_those_of_the_catalogue() -> None:
    row = find_bearing("6208")
    own = named(
        "6208", 'inner = { groove_radius = "6.2 mm", shoulder_height = "1.7 mm" }\npitch_diameter = "60.3 mm"\n'
    )
    assert own.inner.groove_radius == 6.2e-3
    assert own.outer.groove_radius == pytest.approx(row.conformity[1] * row.ball_diameter, rel=1e-12)
    assert own.inner.shoulder_half_width == pytest.approx(math.sqrt(6.2**2 - 4.5**2) * 1e-3, rel=1e-12)
    assert own.pitch_diameter == pytest.approx(60.3e-3, rel=1e-12)
    statuses = {key: origin.status for key, origin in own.origins.items()}
    assert {key for key, status in statuses.items() if status == "given"} == {
        "pitch_diameter",
        "inner.conformity",
        "inner.shoulder_half_width",
    }
    assert (statuses["ball_count"], statuses["outer.conformity"], statuses["width"]) == (
        "derived",
        "assumed",
        "printed",
    )


def test_a_free_angle_leaves_given_bottom_radii_and_makes_missing_ones() -> None:
    """P_d = 2 A_0 (1 - cos 20 deg) with A_0 = 0.6 mm is 72.37 um."""
    angle = 'contact_angle = { free = "20 deg" }\n'
    np.testing.assert_allclose(bearing(HAND + angle).diametral_clearance, 72.369e-6, rtol=1e-5)  # digits typed
    bottoms = 'inner.bottom_radius = "20 mm"\nouter.bottom_radius = "30.02 mm"\n'
    given = bearing(HAND.replace('pitch_diameter = "50 mm"\n', bottoms) + angle)
    assert (given.inner.bottom_radius, given.outer.bottom_radius) == (20e-3, 30.02e-3)


def test_thrust_that_seats_too_few_balls_is_named() -> None:
    """tan 40 deg = 0.8391: 1049 N load half of the balls under 1 kN."""
    text = HEAD.replace('"700 N"', '"{} N"\nradial_load = "1 kN"') + 'catalog = "7205 BEP"\n'
    few, half = (scene(text.format(thrust)).warnings for thrust in (1040, 1060))
    assert sum("fewer than half" in warning for warning in few) == 1
    assert not any("fewer than half" in warning for warning in half)


def test_the_suffix_gives_clearance_and_seals() -> None:
    plain, sealed = named("6206"), named("6206-2RS1/C3")
    assert plain.seals is None
    assert "2RS1" in (sealed.seals or "")
    np.testing.assert_allclose((plain.diametral_clearance, sealed.diametral_clearance), (12.5e-6, 20.5e-6), rtol=1e-8)
    tighter = named("6206/C3", 'clearance = "C2"\n')  # the key wins over the suffix
    np.testing.assert_allclose(tighter.diametral_clearance, 6e-6, rtol=1e-8)


def test_an_angular_contact_bearing_has_its_angle_and_one_shoulder() -> None:
    made = scene(HEAD + 'catalog = "7208 BEP"\n')
    cosine = 1 - made.bearing.diametral_clearance / (2 * made.bearing.groove_centre_distance)
    assert math.degrees(math.acos(cosine)) == pytest.approx(40, rel=1e-9)
    assert made.bearing.outer.far_shoulder_half_width == 0
    assert made.bearing.outer.shoulder_half_width is not None
    assert made.contact_angle.free is None


def test_grade_c_has_two_candidates_unless_the_scene_says_the_balls() -> None:
    made = named("6306")
    other = made.other_candidate
    assert (made.grade, made.ball_count, other is not None) == ("C", 8, True)
    assert other is not None
    assert (other.ball_count, other.ball_diameter) == (8, pytest.approx(12e-3, rel=1e-9))
    assert other.pitch_diameter == pytest.approx(made.pitch_diameter, rel=1e-12)
    assert named("6306", "ball_count = 8\n").other_candidate is None
    assert named("6206").other_candidate is None


def test_every_other_candidate_is_a_bearing() -> None:
    """Its grooves are as high as those of the first one: 7206 BEP has shoulders wider than the groove of its second."""
    others = [named(name) for name in bearing_names() if find_bearing(name).grade == "C"]
    assert len(others) > 50
    for made in others:
        other = made.other_candidate
        assert other is not None, made.name
        assert list(bearing_misfits(other, gap_key="bearing.clearance", own={})) == [], made.name


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (HAND, ("bearing.clearance is missing", '"10 um"', '"CN"', "nominal")),
        (HAND + 'clearance = "C3"\n', ("bearing.clearance = 'C3'", "bore_diameter")),
        (HAND + 'clearance = "C6"\n', ("bearing.clearance = 'C6'", "C2, CN, C3, C4, C5")),
        (HAND + PLAY + 'contact_angle = { nominal = "15 deg" }\n',
            ("bearing.clearance = '16 um'", "contact_angle.nominal", "leave one of them out")),
        (HAND + PLAY + "inner.conformity = 0.52\n", ("bearing.conformity = 0.53", "inner", "leave one of them out")),
        (HAND.replace("conformity = 0.53\n", 'inner = { conformity = 0.52, groove_radius = "5.2 mm" }\n') + PLAY,
            ("bearing.inner.conformity = 0.52", "groove_radius", "bearing.outer.groove_radius is missing")),
        (HAND + PLAY + 'outer = { shoulder_height = "2 mm", shoulder_diameter = "56 mm" }\n',
            ("bearing.outer.shoulder_diameter = '56 mm'", "says the same as shoulder_height")),
        (HAND + PLAY + 'inner.shoulder_height = "5.4 mm"\n', ("inner.shoulder_height = '5.4 mm'", "5.3 mm")),
        (HAND + PLAY + 'inner.shoulder_diameter = "39 mm"\n', ("shoulder_diameter = '39 mm'", "39.992", "50.592")),
        (HAND + PLAY + 'outer.shoulder_diameter = "49 mm"\n', ("shoulder_diameter = '49 mm'", "60.008", "49.408")),
        (
            HAND.replace('pitch_diameter = "50 mm"\n', 'outer.bottom_radius = "30.02 mm"\n')
            + 'inner = { bottom_radius = "20 mm", shoulder_diameter = "40 mm" }\n',  # at the bottom: no shoulder
            ("bearing.inner.shoulder_diameter = '40 mm' must be between", "40 mm, and 50.6 mm"),
        ),
        (HAND + PLAY + 'inner.bottom_radius = "20 mm"\nouter.bottom_radius = "30 mm"\n',
            ("bearing.clearance = '16 um' follows from the bottom_radius", "bearing.pitch_diameter = '50 mm' follows")),
        (HEAD + 'catalog = "7205 BEP"\nclearance = "C3"\n', ("clearance = 'C3'", "deep groove", "40 deg")),
        (HEAD.replace('axial_load = "700 N"', 'radial_load = "1 kN"') + 'catalog = "7205 BEP"\n',
            ("operation.axial_load", "slide apart", "1430 N", "[arrangement]")),
        (HEAD.replace('axial_load = "700 N"', 'axial_load = ["0 N", "1 N"]\nradial_load = ["1 N", "2 N", "3 N"]')
            + 'catalog = "7205 BEP"\n', ("axial_load has 2 and operation.radial_load has 3", "equal lengths")),
        (HAND + PLAY + 'inner.bottom_radius = "20 mm"\n', ("outer.bottom_radius is missing", "leave out bearing")),
        (HAND.replace('pitch_diameter = "50 mm"\n', PLAY), ("bearing.pitch_diameter is missing", '"39 mm"')),
    ],
)  # fmt: skip
def test_what_is_missing_or_said_twice_is_named(text: str, words: tuple[str, ...]) -> None:
    message = refusal(text)
    assert message.isprintable()
    assert [word for word in words if word not in message] == [], message


def test_a_bearing_from_python_is_that_of_the_scene() -> None:
    ours = analytic.bearing("6206/C3", inner={"shoulder_height": 1.7e-3}, pitch_diameter="46.3 mm")
    theirs = named("6206/C3", 'inner.shoulder_height = "1.7 mm"\npitch_diameter = "46.3 mm"\n')
    assert ours == theirs
    with pytest.warns(UserWarning, match="differs between makers"):
        analytic.bearing("6208")
    misspelt: Any = {"clearence": 1e-6}
    with pytest.raises(InputError, match=r"did you mean bearing\.clearance"):
        analytic.bearing("6206", **misspelt)


def test_operating_points_from_python() -> None:
    made = analytic.operation(inner_speed=[30.0, 40.0], radial_load=200.0)
    np.testing.assert_array_equal(made.radial_load, [200.0, 200.0])
    np.testing.assert_array_equal(made.axial_load, [0.0, 0.0])
    texts = analytic.operation(inner_speed=["300 rpm", "500 rpm"], radial_load="2 kN")
    np.testing.assert_allclose(texts.inner_speed, [31.41592653589793, 52.35987755982988], rtol=1e-15)
    np.testing.assert_array_equal(texts.radial_load, [2000.0, 2000.0])
    mistakes: list[tuple[str, Any]] = [("'1000 Hz' .*rpm", "1000 Hz"), ("'fast' ", "fast"), ("neither numbers", {1: 3})]
    for words, speed in mistakes:
        with pytest.raises(InputError, match=rf"operation\.inner_speed = .*{words}"):
            analytic.operation(inner_speed=speed)
    with pytest.raises(InputError, match="shapes"):
        analytic.operation(inner_speed=[30.0, 40.0], radial_load=[1.0, 2.0, 3.0])


@pytest.mark.parametrize(
    "keys",
    [
        *("ball_count = 11\n", 'ball_diameter = "7.144 mm"\n', "conformity = 0.53\n", "inner.conformity = 0.515\n"),
        *('outer.groove_radius = "5.1 mm"\n', 'ball_count = 11\nball_diameter = "7.144 mm"\nconformity = 0.52\n'),
    ],
)
def test_other_balls_or_grooves_are_those_of_an_own_bearing(keys: str) -> None:
    """Its name says so, and ratings, series and grade of the maker's are gone; boundary dimensions stay."""
    original, own = named("6206/C3"), named("6206/C3", keys)
    assert (original.name, own.name) == ("6206/C3", "own bearing (from 6206/C3)")
    assert (own.static_load_rating, own.dynamic_load_rating, own.series, own.grade) == (None, None, None, None)
    assert not {"static_load_rating", "dynamic_load_rating"} & {*own.origins}
    assert (own.bore_diameter, own.width) == (original.bore_diameter, original.width)


@pytest.mark.parametrize(
    "keys", ['ball_count = 9\nball_diameter = "9.525 mm"\ninner.conformity = 0.519\n', 'clearance = "16 um"\n', ""]
)
def test_the_same_balls_and_grooves_are_those_of_the_maker(keys: str) -> None:
    found = named("6206", keys)
    assert (found.name, found.series, found.grade) == ("6206", "62", "A")
    assert found.static_load_rating is not None


@pytest.mark.parametrize(
    "typed", ["6309", "6309/C3", "6309-2Z", "6309 M P5", "NSK 6309", "6309-2RS1/C3", "7208B", "6205/HC5", "62/28"]
)
def test_a_bearing_has_the_name_that_was_typed(typed: str) -> None:
    assert named(typed).name == named(f"  {typed.replace(' ', '   ')} ").name == typed
