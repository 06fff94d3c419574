"""Bearings of the catalogue: what a designation finds, and what every row must fulfil."""

import math
from collections.abc import Iterator
from typing import get_args

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given

from analytic.catalog.bearing_rows import (
    CatalogBearing,
    Grade,
    bearing_names,
    clearance_group,
    find_bearing,
    series_of_size,
)
from analytic.errors import InputError

MAKERS = ("NSK", "SKF", "KOYO")


def usable_bearings() -> Iterator[CatalogBearing]:
    """Every bearing of the catalogue, without a maker and by every maker that has it."""
    for name in bearing_names():
        yield find_bearing(name)
        if name[0] == "6" or name[:2] == "16":
            for maker in MAKERS:
                try:
                    yield find_bearing(f"{maker} {name}")
                except InputError:  # not made by this maker, or refused
                    continue


BEARINGS = list(usable_bearings())


def refusal(designation: str) -> str:
    with pytest.raises(InputError) as caught:
        find_bearing(designation)
    message = str(caught.value)
    assert "\n" not in message
    return message


@pytest.mark.parametrize(
    ("designation", "count", "diameter", "maker"),
    [
        # Balls that others print, in validation/published/ball_bearing_geometry.csv, and printed spindle bearings.
        ("6206", 9, 9.525, "NSK"),
        ("6309", 8, 17.462, "NSK"),
        ("6004-2RS", 9, 6.35, "NSK"),
        ("608", 7, 3.969, "SKF"),
        ("6804", 13, 3.5, "NSK"),
        ("GMN S 6205 C TA", 13, 7.938, "GMN"),
        ("SNFA EX 25", 13, 7.144, "SNFA"),
        # Makers differ.
        ("NSK 6305", 8, 10.319, "NSK"),
        ("SKF 6305", 7, 11.509, "SKF"),
        ("KOYO 6309", 8, 16.669, "KOYO"),
    ],
)
def test_balls_are_those_of_the_maker(designation: str, count: int, diameter: float, maker: str) -> None:
    bearing = find_bearing(designation)
    assert (bearing.ball_count, bearing.maker) == (count, maker)
    np.testing.assert_allclose(bearing.ball_diameter, diameter / 1e3, rtol=1e-3)  # inch sizes rounded to 1 um


@pytest.mark.parametrize(
    ("designation", "words"),
    [
        ("FAG 6206", ("FAG 6206", "KOYO, NSK and SKF")),
        ("KOYO 6028", ("KOYO 6028", "that of SKF is")),
        ("NSK 7208 B", ("7208 BEP", "SKF")),
        ("62305", ("62305", "6305", "bearing.ball_count")),
        ("7208", ("contact angle", "7208C", "7208A5", "7208A", "7208 BEP")),
        ("618/5", ("refused", "Count the balls", "BPFO and BPFI", "bearing.ball_count")),
        ("SKF 607", ("refused", "GMN prints 8 x 3.175 mm")),
        ("6232RS", ("6232", "623", "hyphen")),
        ("NSK 6205 SKF", ("two makers", "NSK and SKF")),
        ("6205 ETN9", ("ETN9", "other balls")),
        ("6205-C", ("C is changed inner design",)),
        ("SNFA EX 25 7CE3", ("another contact angle",)),
        ("", ("characters",)),
        ("6" * 70, ("characters",)),
    ],
)
def test_a_refusal_is_one_line_with_a_remedy(designation: str, words: tuple[str, ...]) -> None:
    message = refusal(designation)
    assert all(word in message for word in words), message


def test_an_unknown_designation_names_the_three_nearest() -> None:
    near = refusal("63066").partition("nearest: ")[2].partition(". Or")[0].split(", ")
    assert len(near) == 3
    assert "6306" in near


@given(st.text(max_size=80))
def test_any_text_is_found_or_refused_in_one_line(text: str) -> None:
    try:
        assert find_bearing(text).ball_count > 0
    except InputError as refused:
        assert len(str(refused).splitlines()) == 1  # noqa: PT017 # both outcomes are right


def test_every_bearing_can_be_built() -> None:
    assert len(BEARINGS) > 1300
    for bearing in BEARINGS:
        name, ball, pitch = bearing.designation, bearing.ball_diameter, bearing.pitch_diameter
        assert pitch * math.sin(math.pi / bearing.ball_count) > ball, name  # balls side by side on the pitch circle
        assert bearing.bore < pitch - ball < pitch + ball < bearing.outside, name
        assert ball < bearing.width, name
        rings = zip(bearing.shoulder_height, bearing.shoulder_half_width, bearing.conformity, strict=True)
        for height, width, conformity in rings:
            assert (height is None) == (width is None), name
            if height is not None and width is not None:
                radius = conformity * ball
                np.testing.assert_allclose((radius - height) ** 2 + width**2, radius**2, rtol=1e-12)  # a circle
                assert 0 < height < 0.5 * ball, name  # shoulders lie below the ball's middle
                assert width < bearing.width / 2, name
        assert bearing.grade in get_args(Grade), name
        assert bearing.dynamic_load_rating > 0 < bearing.static_load_rating, name


SCENE_KEYS = {
    *("ball_count", "ball_diameter", "pitch_diameter", "bore_diameter", "outside_diameter", "width"),
    *("static_load_rating", "dynamic_load_rating"),
    *(f"{ring}.{key}" for ring in ("inner", "outer") for key in ("conformity", "shoulder_half_width")),
}


def test_every_number_has_an_origin() -> None:
    for bearing in BEARINGS:
        name = bearing.designation
        far = {"inner.far_shoulder_half_width", "outer.far_shoulder_half_width"}
        one_sided = bearing.far_half_width != (None, None)
        assert bearing.origins.keys() == (SCENE_KEYS | far if one_sided else SCENE_KEYS), name
        assert all(origin.source for origin in bearing.origins.values()), name
        balls = bearing.origins["ball_diameter"]
        assert balls.status == ("printed" if bearing.grade == "printed" else "derived"), name
        assert balls.uncertainty is not None
        share = balls.uncertainty / bearing.ball_diameter
        np.testing.assert_allclose(share, 0.06 if bearing.grade == "C" else 0.001)  # docs/catalogue.md
        assert bearing.origins["ball_count"].uncertainty == (1.0 if bearing.grade == "C" else 0.0), name
        assert ("right in about" in balls.source) == (bearing.grade in ("A", "B")), name
        assert bearing.origins["outer.conformity"].status == "assumed"
        unknown = bearing.origins["inner.shoulder_half_width"].status == "not known"
        assert unknown == (bearing.shoulder_half_width[0] is None), name
        assert (bearing.other_candidate is not None) or bearing.grade in ("printed", "A", "B"), name


@pytest.mark.parametrize(
    ("bore", "group", "smallest", "largest"),
    [
        # As other makers print them: SKF, NTN and Mitsubishi Electric (motors), um.
        (25, "CN", 5, 20),
        (30, "C3", 13, 28),
        (45, "C4", 30, 51),
        (50, "C2", 1, 11),
        (8, "CN", 2, 13),
        (75, "CN", 10, 30),
    ],
)
def test_clearance_is_that_of_the_standard(bore: float, group: str, smallest: float, largest: float) -> None:
    np.testing.assert_allclose(clearance_group(bore / 1e3, group), (smallest / 1e6, largest / 1e6), rtol=1e-14)


@pytest.mark.parametrize(
    ("bore", "group", "word"), [(0.002, "CN", "2.5 mm"), (0.9, "C3", "800 mm"), (0.03, "C6", "'C6'")]
)
def test_clearance_outside_the_standard_is_refused(bore: float, group: str, word: str) -> None:
    with pytest.raises(InputError, match=word):
        clearance_group(bore, group)


@pytest.mark.parametrize(
    ("designation", "series"),
    [
        ("6205", "62"),
        ("7208 BEP", "72 B"),
        ("7008C", "NSK 70 C"),
        ("7210A5", "NSK 72 A5"),
        ("GMN S 6205 C TA", "GMN S"),
        ("SNFA EX 25", "SNFA EX"),
    ],
)
def test_a_series_is_that_of_the_maker(designation: str, series: str) -> None:
    bearing = find_bearing(designation)
    assert bearing.series == series
    assert bearing.kind == ("deep groove" if series.isdigit() else "angular contact")
    assert (bearing.nominal_angle is None) == series.isdigit()


@pytest.mark.parametrize(
    ("size", "series"),
    [  # mm
        ((25.0, 52.0, 15.0), "62"),
        ((25.0, 52.0, None), "62"),
        ((50.0, 80.0, 16.0), "60"),
        ((50.0, 80.0, 10.0), "160"),
        ((50.0, 80.0, 13.1), "60"),  # nearer to 16 mm than to 10 mm
        ((50.0, 80.0, None), "60"),
        ((25.04, 51.96, 15.0), "62"),
        ((25.06, 52.0, 15.0), None),
        ((25.0, 51.94, 15.0), None),
    ],
)
def test_a_size_belongs_to_a_series_within_a_twentieth_of_a_millimetre(
    size: tuple[float, float, float | None], series: str | None
) -> None:
    bore, outside, width = size
    assert series_of_size(bore / 1e3, outside / 1e3, None if width is None else width / 1e3) == series


def test_every_deep_groove_bearing_has_the_series_of_its_size() -> None:
    for bearing in BEARINGS:
        if bearing.kind == "deep groove":
            found = series_of_size(bearing.bore, bearing.outside, bearing.width)
            assert found == bearing.series, bearing.designation


def test_shoulders_of_another_ball_are_in_proportion() -> None:
    """SKF's 6305 has larger balls than NSK's, whose shoulders are assumed."""
    one, other = find_bearing("NSK 6305"), find_bearing("SKF 6305")
    grown = other.ball_diameter / one.ball_diameter
    assert grown > 1.1
    for small, large in zip(one.shoulder_height, other.shoulder_height, strict=True):
        assert small is not None
        assert large == pytest.approx(grown * small, rel=1e-12)
    assert "another maker" in other.origins["inner.shoulder_half_width"].source
    assert "another maker" not in one.origins["inner.shoulder_half_width"].source


def test_makers_that_differ_are_named_unless_one_is_asked_for() -> None:
    """Every other maker whose balls are usable and others."""
    told = 0
    by_name = {bearing.designation: bearing for bearing in BEARINGS}
    for name in bearing_names():
        plain, words = by_name[name], " ".join(by_name[name].warnings)
        for maker in MAKERS:
            own = by_name.get(f"{maker} {name}")
            if own is None or maker == plain.maker:
                continue
            assert "differs between makers" not in " ".join(own.warnings)
            balls = f"{maker} {own.ball_count} x {1e3 * own.ball_diameter:.3f} mm"
            same = own.ball_count == plain.ball_count and abs(own.ball_diameter / plain.ball_diameter - 1) < 1e-3
            told += balls in words
            assert same or balls in words, name
            assert not same or f"{maker} {own.ball_count} x" not in words or plain.grade == "printed", name
    assert told > 50


def test_the_last_of_several_clearance_groups_is_taken() -> None:
    assert find_bearing("6205 C2 C4").clearance_group == "C4"
    assert find_bearing("6205 C4 C2").clearance_group == "C2"
    assert not any("clearance groups" in words for words in find_bearing("6205 C4").warnings)
