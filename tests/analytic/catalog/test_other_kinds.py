"""Designations of bearings that the catalogue does not have say what they are; words beside a number do not matter."""

import pytest

from analytic.catalog.bearing_rows import bearing_names, find_bearing
from analytic.catalog.designation import other_kind
from tests.refusals import refused


@pytest.mark.parametrize(
    ("designation", "kind", "remedy"),
    [
        ("nu205", "cylindrical roller", "6205"),
        ("NUP 2208 ECP", "cylindrical roller", "6205"),
        ("22210", "spherical roller", "6205"),
        ("SKF 23040 CC/W33", "spherical roller", "6205"),
        ("51105", "thrust ball", 'kind = "thrust"'),
        ("FAG 52207", "thrust ball bearing with two rows", 'kind = "thrust"'),
        ("29412 E", "thrust roller", "6205"),
        ("1205", "self-aligning ball", "6205"),
        ("2306 ETN9", "self-aligning ball", "6205"),
        ("30205", "tapered roller", "6205"),
        ("32008 X", "tapered roller", "6205"),
        ("LM11949", "tapered roller", "6205"),
        ("NA4900", "needle roller", "6205"),
        ("HK 2016", "needle roller", "6205"),
        ("QJ 208", "four-point contact", "35 deg"),
        ("3205 A", "angular contact ball bearing with two rows", "[arrangement]"),
        ("4206", "deep groove ball bearing with two rows", "ball_count"),
        ("UC205", "insert", "ball_diameter"),
        ("R8", "inch size", "ball_diameter"),
        ("C 2205", "toroidal roller", "6205"),
        ("LM20UU", "linear ball", "6205"),
    ],
)
def test_another_kind_is_named_with_its_remedy(designation: str, kind: str, remedy: str) -> None:
    refused(lambda: find_bearing(designation), repr(designation), kind, remedy)


def test_no_bearing_of_the_catalogue_is_another_kind() -> None:
    plain = [name.replace(" ", "").partition("GMN")[2] or name.replace(" ", "") for name in bearing_names()]
    taken = [name for name in plain if other_kind(name.removeprefix("SNFA")) is not None]
    assert len(plain) > 900
    assert [name for name in taken if name[0] in "67"] == []


@pytest.mark.parametrize("beside", ["DGBB {}", "deep groove ball bearing {}", "{} Rillenkugellager", "Bearing: {}"])
@pytest.mark.parametrize("number", ["6205-2RS C3", "SKF 6205-2RSH/C3"])
def test_words_for_the_kind_say_nothing_more(beside: str, number: str) -> None:
    plain, found = find_bearing(number), find_bearing(beside.format(number))
    assert found == plain
    assert found.clearance_group == "C3"
