"""Operating points as tables name them, and those of a long series that are shown."""

from types import SimpleNamespace
from typing import Any

import numpy as np

from analytic.errors import InputError
from analytic.left_out import Places
from analytic.scene import Operation
from analytic.units import INCH_POUND, METRIC
from fembearing.report.sections.points import (
    fixed_loads,
    heaviest_point,
    point_cells,
    point_heads,
    point_name,
    shown_places,
)

RPM = np.pi / 30  # rad/s
SERIES = (  # the radial load is the same
    {"inner_speed": 600 * RPM, "axial_load": 700.0, "radial_load": 130.0, "moment": 0.0},
    {"inner_speed": 900.123 * RPM, "axial_load": 800.0, "radial_load": 130.0, "moment": 2.5},
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
    assert point_name((first | {"axial_load": 0.0, "radial_load": 0.0},), 0, METRIC) == "0 N axial, 600 rpm"


def test_the_heaviest_point_is_the_first_with_the_largest_load_on_either_race() -> None:
    loads = ((310.0, 290.0), (300.0, 420.0), (420.0, 280.0), (415.0, 305.0))
    assert heaviest_point([{"load_inner": inner, "load_outer": outer} for inner, outer in loads]) == 1


def series(totals: dict[int, float], size: int) -> Any:
    """A torque at these of the points of a series."""
    lost = {number: InputError("too heavy") for number in range(size) if number not in totals}
    operation = Operation(axial_load=np.full(size, 9e9), inner_speed=np.full(size, 3.0))
    points = [{"torque_total": totals.get(number)} for number in range(size)]
    return SimpleNamespace(points=points, places=Places(operation=operation, failures=lost))


def test_of_a_long_series_both_ends_the_extremes_and_an_even_choice_are_shown() -> None:
    """Of 34 points 1, 3, ... 27 have no torque; the 20 others rise, but for two least and two largest totals."""
    totals = [0.03 + 0.001 * place for place in range(20)]
    totals[7] = totals[12] = 0.011
    totals[5] = totals[15] = 0.093
    without = range(1, 28, 2)
    known = [number for number in range(34) if number not in without]
    torque = series(dict(zip(known, totals, strict=True)), 34)
    # Among the 20: both ends, 7 and 5, the first of the extremes; of the 16 others every 15/7th: 0, 2, 4, 6, 9, 11, 13
    # and 15, which are 1, 3, 6, 9, 12, 14, 16 and 18 of the 20.
    shown = [known[place] for place in (0, 1, 3, 5, 6, 7, 9, 12, 14, 16, 18, 19)]
    assert shown_places(torque) == sorted([*shown, *without[:12]])
    short = series(dict.fromkeys(range(14, 26), 0.04), 26)
    assert shown_places(short) == [*range(12), *range(14, 26)]  # 12 of 14 without a torque, and 12 with one
