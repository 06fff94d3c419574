"""The sentences that page and terminal share."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.inputs import UNCERTAIN
from analytic.rows import OperatingPoint
from analytic.scene import Clearances
from analytic.verdicts import NumericalCheck, PhysicalCheck
from fembearing.quantities import METRIC
from fembearing.report.phrases import (
    angle_cell,
    between,
    clearances_of,
    creep_change_words,
    digits,
    explained_words,
    film_change_words,
    friction_of,
    input_name,
    interval_words,
    listed,
    loads_of,
    numerical_words,
    pair_of,
    percent,
    place_of,
    present_loads,
    ring_line,
    rounded,
    share_of,
    shoulder_lines,
    shown,
    title_of,
    uncertainty_of,
    value_of,
    varying_loads,
    worst_of,
)
from tests.analytic.specimens import present


def test_an_uncertainty_has_its_number_or_the_reason_why_it_is_not_known() -> None:
    lost = NumericalCheck(verdict="not reached", uncertainty=None, tolerance=0.04, reason="the cage came apart")
    unknown = numerical_words(lost)
    assert "not known: the cage came apart" in unknown
    assert "%" not in unknown
    solved = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.04, reason="")
    for check, side in ((solved, "within"), (replace(solved, verdict="not reached", uncertainty=0.067), "beyond")):
        words = numerical_words(check)
        assert f"{100 * present(check.uncertainty):g} %, {side} the tolerance 4 %" in words
        assert "not known" not in words


@pytest.mark.parametrize(
    ("pair", "geometry", "words"),
    [
        ("pocket", "wall", "ball in cage pocket, sheet on its rim"),
        ("pocket", "real", "ball in cage pocket, thick seat"),
        ("outer", "hertzian", "ball on outer race, idealised"),
        ("inner", "real", "ball on inner race"),
    ],
)
def test_a_contact_is_named_by_its_race_or_its_seat(pair: str, geometry: str, words: str) -> None:
    assert place_of(pair, geometry) == words


def test_every_uncertain_input_has_a_name() -> None:
    names = [input_name(key) for key in UNCERTAIN]
    assert all(names)
    assert not any("." in name for name in names)


@pytest.mark.parametrize(("value", "words"), [(0.01234, "1.2 %"), (None, "unknown"), (float("inf"), "unknown")])
def test_a_share_that_is_not_known_has_no_number(value: float | None, words: str) -> None:
    assert percent(value) == words


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


def test_friction_comes_from_a_coefficient_or_from_oil_and_surface_or_is_not_known() -> None:
    assert "coefficient 0.08 at each race" in friction_of(coefficient=0.08, is_lubricated=True)
    assert "mixed lubrication" in friction_of(coefficient=None, is_lubricated=True)
    assert "no torque" in friction_of(coefficient=None, is_lubricated=False)


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


def test_a_share_is_a_number_a_bound_or_not_known() -> None:
    for kind, share, words in (
        ("unbounded", None, "no known limit"),
        ("unknown", None, "not known"),
        ("bound", 0.0321, "<= 3.21 %"),
        ("own", 0.0321, "3.21 %"),
        ("own", 1.234, "123 %"),
        ("own", 1.0, "100 %"),
        ("own", 3e-9, "0 %"),
        ("bound", 3e-9, "<= 3e-07 %"),
    ):
        assert share_of(kind, share) == words


def test_what_the_formulas_leave_open_is_named_part_by_part() -> None:
    words = uncertainty_of(0.043, {"film": 0.021, "gap": 0.0, "rolling": 0.037})
    assert "up to 4.3 % of the total, by film formula 2.1 %, formula of rolling 3.7 %. Not included" in words
    assert "not known without oil" in uncertainty_of(None, {})


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


def test_a_clearance_tells_its_way_its_seats_and_its_preload() -> None:
    tight = Clearances(
        unmounted=12e-6,
        mounted=7e-6,
        operating=0.0,
        shaft_interference=9e-6,
        housing_interference=0.0,
        shaft_pressure=21e6,
        housing_pressure=0.0,
        ball_load=0.0,
    )
    assert clearances_of(tight) == (
        "Clearance on the diameter: 12 um unmounted, 7 um mounted, 0 um operating. In operation: shaft seat 9 um "
        "tight, 21 MPa, housing seat loose."
    )
    squeezed = replace(tight, operating=-3e-6, ball_load=170.0, housing_interference=4e-6, housing_pressure=8e6)
    words = clearances_of(squeezed)
    assert "-3 um operating; every ball is preloaded with 170 N. In operation" in words
    assert "housing seat 4 um tight, 8 MPa" in words


def test_a_pair_has_a_preload_or_shares_its_load() -> None:
    rows: Any = SimpleNamespace(kind="O", preload=130.0, offset=7e-6, distance=0.031)
    assert pair_of(rows).startswith("Preload 130 N at standstill, by closing 7 um; the axial load presses on the first")
    assert "middles 31 mm apart" in pair_of(rows)
    rows.kind = "tandem"
    assert pair_of(rows).startswith("Both bearings carry the axial load, without preload.")


def test_shares_of_inputs_are_worth_something_where_half_of_the_variance_is_explained() -> None:
    for explained, words in ((0.49, "the ranking of the inputs is not known"), (0.51, "attributed to no input")):
        prediction: Any = SimpleNamespace(explained=explained)
        assert explained_words(prediction).startswith(
            f"The regression for the shares explains {100 * explained:.0f} % or more"
        )
        assert words in explained_words(prediction)


def test_an_interval_tells_how_it_was_computed() -> None:
    prediction: Any = SimpleNamespace(
        samples=512, seed=7, seconds=12.3, largest_error=0.021, failures="", not_varied=("seals", "temperature")
    )
    words = interval_words(prediction)
    assert words.startswith("95 % interval by 512 Latin hypercube samples, seed 7, in 12 s; the standard error of an")
    assert "at most 2.1 %. Spreads" in words
    assert words.endswith("Not included: seals; temperature.")


def test_loads_are_named_where_they_are_and_told_apart_where_they_differ() -> None:
    one = OperatingPoint(inner_speed=30.0, axial_load=700.0, radial_load=0.0, moment=0.0)
    two = replace(one, moment=1.5, axial_load=300.0)
    assert present_loads([one]) == ["axial_load"]
    assert present_loads([one, two]) == ["axial_load", "moment"]
    assert varying_loads([one, two]) == ["axial_load", "moment"]
    assert varying_loads([two, two]) == []
    assert loads_of(two, ["axial_load", "moment"]) == "300 N axial, 1500 N mm moment"
    assert loads_of(one, ["radial_load"]) == "0 N radial"


def test_a_contact_of_a_pair_names_its_bearing_and_a_pocket_no_angle() -> None:
    assert place_of("inner", "real", "second") == "ball on inner race of the second bearing"
    assert title_of("pocket", "real", 0.31, "28 N") == "Ball in cage pocket, thick seat: 28 N"
    assert title_of("outer", "real", 0.31, "370 N") == "Ball on outer race at 17.76 deg (0.31 rad): 370 N"


def test_changes_by_films_and_friction_have_their_ends_and_their_signs() -> None:
    assert "the torque changes by -1.2% to +3.4%." in film_change_words([0.034, -0.012, 0.02])
    assert "changes by +2.0%." in film_change_words([0.02, 0.02])
    assert creep_change_words(-0.031).endswith("changes by -3.1%.")


def test_a_ring_adds_to_the_approach_with_its_sign() -> None:
    ring: Any = SimpleNamespace(approach=-0.2125e-6, share=-0.0407, uncertainty=7.8e-9)
    assert ring_line(ring) == (
        "Ring on a rigid seat: approach -0.212 um (-4.1% of the contact's), +- 0.008 um: structure, not contact."
    )


def at_shoulder(cuts: list[float], *, half: bool) -> Any:
    def part(fe: float, uncertainty: float) -> Any:
        return SimpleNamespace(fe=fe, uncertainty=uncertainty)

    shoulder = SimpleNamespace(
        cuts=cuts,
        half=half,
        strip_width=0.08e-3,
        hertz_line_load=2e5,
        centroid=part(-0.021e-3, 0.04),
        strip_share=part(0.123, 0.03),
        strip_line_load=part(3e5, 0.03),
    )
    return SimpleNamespace(shoulder=shoulder)


def test_a_shoulder_is_told_by_its_place_its_edge_load_and_the_half_that_is_meshed() -> None:
    first, second = shoulder_lines(at_shoulder([0.8e-3], half=True))
    assert first.startswith("Cut off at the shoulder, y = 0.8 mm, on one side: half of the contact is meshed;")
    assert "at y = -0.021 mm (+-4.0% of that)." in first
    assert "the strip of 0.08 mm beside the shoulder carries 12.30% of the load (+-3.0% of that)" in second
    assert "or 1.5 times Hertz's greatest line load" in second
    first, second = shoulder_lines(at_shoulder([0.8e-3, -0.9e-3], half=False))
    assert first == "Cut off at both shoulders, y = -0.9 mm and y = 0.8 mm."
    assert "beside the shoulder at y = 0.8 mm carries" in second
    none: Any = SimpleNamespace(shoulder=None)
    assert shoulder_lines(none) == []
