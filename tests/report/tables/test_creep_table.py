"""Friction of a ball on both races: which quantities have a row."""

from typing import Any

import pytest

from analytic.rows import OperatingPoint
from fembearing.report.tables.creep import creep_table
from fembearing.verify.creep.scene_creep import CreepNumbers, CreepQuantity, RaceNumbers

NOTHING = CreepQuantity(formula=0.0, production=0.0, reference=0.0, uncertainty=2e-6)
SUMS = CreepQuantity(formula=3.1e-3, production=2.9e-3, reference=2.7e-3, uncertainty=1e-5)


def race(**known: CreepQuantity) -> RaceNumbers:
    names = ("creepage_along", "creepage_across", "spin_creepage", "spin_moment", "rolling_moment", "transverse_force")
    quantities: Any = dict.fromkeys((*names, "slip_share", "power"), NOTHING) | known
    return RaceNumbers(
        contact_angle=0.31, load=87.0, semi_axis_rolling=0.12e-3, semi_axis_transverse=0.9e-3, **quantities
    )


@pytest.mark.parametrize("method", ["formula", "production", "reference"])
def test_a_quantity_has_a_row_if_one_method_finds_more_than_the_uncertainty(method: str) -> None:
    known: Any = {"formula": 0.0, "production": 0.0, "reference": 0.0} | {method: -5e-6}
    creep = CreepNumbers(
        point=OperatingPoint(axial_load=700.0, inner_speed=41.0, radial_load=0.0, moment=0.0),
        friction_coefficient=None,
        inner=race(spin_moment=CreepQuantity(**known, uncertainty=2e-6)),
        outer=race(),
        torque=SUMS,
        solved_balls=1,
        different_balls=1,
        strips=31,
        cells=60,
        tolerance=0.01,
        seconds=2.7,
        production_seconds=0.003,
        warnings=(),
    )
    inner, outer, whole = creep_table(creep).groups
    assert [row[0] for row in inner.rows] == ["spin moment, N mm"]
    assert outer.rows == []
    assert len(whole.rows) == 1
