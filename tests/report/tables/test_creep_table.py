"""Friction of a ball on both races: which quantities have a row, and its cells, worked out by hand."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.rows import OperatingPoint
from fembearing.check.comparison import Comparison, compared
from fembearing.check.creep.scene_creep import CreepNumbers, RaceNumbers
from fembearing.report.tables.creep import creep_table

RPM = np.pi / 30  # rad/s
NOTHING = compared(0.0, 0.0, 2e-6, formula=0.0)
SUMS = compared(2.9e-3, 2.5e-3, 1.23e-4, formula=3.1e-3)


def race(**known: Comparison) -> RaceNumbers:
    names = ("creepage_along", "creepage_across", "spin_creepage", "spin_moment", "rolling_moment", "transverse_force")
    quantities: Any = dict.fromkeys((*names, "slip_share", "power"), NOTHING) | known
    return RaceNumbers(
        contact_angle=0.31, load=87.0, semi_axis_rolling=0.12e-3, semi_axis_transverse=0.9e-3, quantities=quantities
    )


def numbers(inner: RaceNumbers | None = None, **changed: Any) -> CreepNumbers:
    given: dict[str, Any] = {
        "point": OperatingPoint(axial_load=700.0, inner_speed=600 * RPM, radial_load=0.0, moment=0.0),
        "friction_coefficient": None,
        "races": {"inner": inner or race(), "outer": race()},
        "torque": SUMS,
        "solved_balls": 3,
        "different_balls": 3,
        "strips": 31,
        "cells": 60,
        "tolerance": 0.01,
        "seconds": 2.7,
        "production_seconds": 0.003,
        "warnings": (),
    }
    return CreepNumbers(**given | changed)


@pytest.mark.parametrize("method", ["formula", "production", "reference"])
def test_a_quantity_has_a_row_if_one_method_finds_more_than_the_uncertainty(method: str) -> None:
    moment, zero = replace(NOTHING, **{method: -5e-6}), replace(NOTHING, uncertainty=0.0)  # pyright: ignore[reportArgumentType]
    creep = numbers(race(spin_moment=moment, power=zero))
    inner, outer, whole = creep_table(creep).groups
    assert [row[0] for row in inner.rows] == ["spin moment, N mm"]
    assert outer.rows == []
    assert len(whole.rows) == 1


def test_a_quantity_has_its_three_values_and_a_star_beyond_the_uncertainty() -> None:
    """Of a reference that may be 0, the uncertainty is in the unit of the row."""
    inner = race(
        creepage_along=compared(-2.1e-3, -2e-3, 0.2e-3, formula=-2.4e-3),
        spin_creepage=compared(2200.0, 2500.0, 50.0, formula=2600.0),
        rolling_moment=compared(4e-6, 3e-6, 4e-6, formula=5e-6),
        slip_share=compared(0.66, 0.6, 0.03, formula=0.97),
        power=compared(0.25, 0.25, 0.0, formula=0.45),
    )
    first, _, whole = creep_table(numbers(inner)).groups
    assert first.title == "Friction on the inner race: 87 N at 17.76 deg, inner ring at 600 rpm"
    assert first.rows == [
        ["creepage along", "-0.0024", "-0.0021", "-0.002", "+5.0%  ", "10.0%"],
        ["spin over speed, 1/mm", "2.6", "2.2", "2.5", "-12.0% *", "2.0%"],
        ["rolling moment, N mm", "0.005", "0.004", "0.003", "none  ", "0.004"],
        ["area that slips, %", "97", "66", "60", "+10.0% *", "5.0%"],
        ["power, W", "0.45", "0.25", "0.25", "+0.0%  ", "0.0%"],
    ]
    assert whole.rows == [["torque by sliding, N mm", "3.1", "2.9", "2.5", "+16.0% *", "4.9%"]]
