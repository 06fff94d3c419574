"""The sentences that page and terminal share."""

from dataclasses import replace

import pytest

from analytic.scenefile.keys import UNCERTAIN
from analytic.units import METRIC
from analytic.verdicts import PhysicalCheck
from analytic.words import rounded
from fembearing.report.phrases import angle_cell, between, digits, input_name, listed, shown
from fembearing.report.sections.inputs import value_of
from fembearing.report.sections.limits import worst_of


def test_every_uncertain_input_has_a_name() -> None:
    names = [input_name(key) for key in UNCERTAIN]
    assert all(names)
    assert not any("." in name for name in names)


def test_distinct_values_are_listed_up_to_twelve() -> None:
    assert listed(0.25, 1e3) == "250"
    assert listed([2.0, 7.0, 2.0], 10.0) == "20, 70"
    assert listed([float(number) for number in range(12)]).count(",") == 11
    assert listed([float(number) for number in range(3, 16)]) == "3 to 15, 13 values"


def test_numbers_have_their_digits_and_no_power_of_ten_below_a_million() -> None:
    for value, words in (
        (123456.0, "120000"),
        (999999.0, "1000000"),
        (1e6, "1e+06"),
        (2.345e6, "2.3e+06"),
        (0.0123, "0.012"),
    ):
        assert rounded(value, 2) == words
    assert rounded(-123456.0, 2) == "-120000"
    assert (digits(2.5, 10.0, 4), digits(1234.0, count=4), digits(None)) == ("25.00", "1234", "-")
    assert (shown(2.5, ".1f", 10.0, " N"), shown(None, ".1f", absent="none")) == ("25.0 N", "none")
    assert (between((0.0123, 0.4567), METRIC.torque), between(None, METRIC.torque)) == ("12.3-457", "-")
    assert (angle_cell(0.31), angle_cell(None), angle_cell(-1e-9)) == ("17.76 (0.3100)", "-", "0.00 (0.0000)")


@pytest.mark.parametrize(
    ("value", "uncertainty", "unit", "words"),
    [
        (None, 0.1, "m", "not known"),
        ("gaussian", None, "", "gaussian"),
        (0.31, 0.02, "rad", "17.76 deg (0.31 rad) +- 1.1 deg"),
        (0.31, None, "rad", "17.76 deg (0.31 rad)"),
        (206e9, 3e9, "Pa", "206 +- 3 GPa"),
        (7.94e-3, None, "m", "7.94 mm"),
        (0.52, 0.01, "1", "0.52 +- 0.01"),
    ],
)
def test_an_input_has_its_value_its_spread_and_its_unit(
    value: float | str | None, uncertainty: float | None, unit: str, words: str
) -> None:
    assert value_of(value, uncertainty, unit) == words


def test_a_limit_is_a_pressure_or_a_share() -> None:
    usual = PhysicalCheck(
        name="peak_pressure", where="ball", point=0, value=1.7e9, limit=4.2e9, unit="Pa", verdict="pass", note=""
    )
    assert worst_of(usual) == "1.7 GPa"
    assert worst_of(replace(usual, value=0.31, unit="1")) == "31 %"
    assert worst_of(replace(usual, value=9e-7, unit="1")) == "0 %"
    assert worst_of(replace(usual, value=-2e-6, unit="1")) == "-0.0002 %"
    assert worst_of(replace(usual, value=None, verdict="fail")) == "infinite"
    assert worst_of(replace(usual, value=None, verdict="unknown")) == "unknown"
