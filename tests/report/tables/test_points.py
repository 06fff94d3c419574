"""Operating points as tables name them, and those of a long series that are shown."""

from dataclasses import replace

from analytic.result import OnRaces
from analytic.rows import OperatingPoint
from fembearing.quantities import INCH_POUND, METRIC
from fembearing.report.tables.points import (
    fixed_loads,
    heaviest_point,
    point_cells,
    point_heads,
    point_name,
    shown_places,
)
from tests.report.torque_rows import RPM, loaded, lost, point, record

SERIES = (  # the radial load is the same
    OperatingPoint(inner_speed=600 * RPM, axial_load=700.0, radial_load=130.0, moment=0.0),
    OperatingPoint(inner_speed=900.123 * RPM, axial_load=800.0, radial_load=130.0, moment=2.5),
)


def test_a_point_has_its_number_from_one_its_speed_and_the_loads_that_are_there() -> None:
    """A terminal has no column for a load that does not vary."""
    assert [(head.text, head.short, head.wide) for head in point_heads(SERIES, METRIC)] == [
        ("#", "", False),
        ("speed, rpm", "rpm", False),
        ("axial load, N", "Fa, N", False),
        ("radial load, N", "Fr, N", True),
        ("moment, N mm", "M, N mm", False),
    ]
    assert point_cells(SERIES, 1, METRIC) == ["2", "900.12", "800", "130", "2500"]
    assert fixed_loads(SERIES, METRIC) == ["radial load 130 N"]
    assert fixed_loads(SERIES, INCH_POUND) == ["radial load 29.225 lbf"]  # of 4.4482 N


def test_a_point_is_named_by_its_loads_and_by_its_number_among_several() -> None:
    first, second = SERIES
    assert point_name(SERIES, 0, METRIC) == "point 1: 700 N axial, 130 N radial, 600 rpm"
    assert point_name(SERIES, 1, METRIC) == "point 2: 800 N axial, 130 N radial, 2500 N mm moment, 900.12 rpm"
    assert point_name((second,), 0, METRIC) == "800 N axial, 130 N radial, 2500 N mm moment, 900.12 rpm"
    assert point_name((replace(first, axial_load=0.0, radial_load=0.0),), 0, METRIC) == "0 N axial, 600 rpm"


def test_the_heaviest_point_is_the_first_with_the_largest_load_on_either_race() -> None:
    loads = ((310.0, 290.0), (300.0, 420.0), (420.0, 280.0), (415.0, 305.0))
    points = [point(contact=OnRaces(inner=loaded(inner), outer=loaded(outer))) for inner, outer in loads]
    assert heaviest_point(points) == 1


def test_of_a_long_series_both_ends_the_extremes_and_an_even_choice_are_shown() -> None:
    """Of 34 points 1, 3, ... 27 have no torque; the 20 others rise, but for two least and two largest totals."""
    totals = [0.03 + 0.001 * place for place in range(20)]
    totals[7] = totals[12] = 0.011
    totals[5] = totals[15] = 0.093
    without = range(1, 28, 2)
    known = [number for number in range(34) if number not in without]
    rows = {number: replace(point(number).torque, total=total) for number, total in zip(known, totals, strict=True)}
    points = [replace(point(number), torque=rows.get(number, point(number).torque)) for number in range(34)]
    torque = record(*points, left_out=tuple(map(lost, without)))
    # Among the 20: both ends, 7 and 5, the first of the extremes; of the 16 others every 15/7th: 0, 2, 4, 6, 9, 11, 13
    # and 15, which are 1, 3, 6, 9, 12, 14, 16 and 18 of the 20.
    shown = [known[place] for place in (0, 1, 3, 5, 6, 7, 9, 12, 14, 16, 18, 19)]
    assert shown_places(torque) == sorted([*shown, *without[:12]])
    short = record(*map(point, range(26)), left_out=tuple(lost(number) for number in range(14)))
    assert shown_places(short) == [*range(12), *range(14, 26)]  # 12 of 14 without a torque, and 12 with one
