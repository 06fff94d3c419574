"""The tables of ring and balls: units, zeros, alike balls, and the points that are shown."""

from typing import Any

import numpy as np
import pytest

from analytic.loads.ring_state import Balls, Displacement, RingPoint
from fembearing.quantities import INCH_POUND, METRIC, Units
from fembearing.report.page.sections.ring import ring_tables
from tests.report.figures.figure_reader import as_document
from tests.report.torque_rows import point

POUND, INCH = 4.4482216152605, 0.0254  # N and m, by definition
PLACE = Displacement(axial=13e-6, x=-2.5e-6, y=0.75e-6, tilt_x=3e-4, tilt_y=-7e-4)
STIFFNESS = (
    (31e6, 2e6, -3e6, 4e3, 5e3),
    (2e6, 53e6, 1e-4, 6e3, 7e3),  # the 1e-4 N/m are round-off of the diagonal
    (-3e6, 1e-4, 59e6, 8e3, 9e3),
    (4e3, 6e3, 8e3, 710.0, 11.0),
    (5e3, 7e3, 9e3, 11.0, 730.0),
)
UNEQUAL = Balls(
    azimuth=(0.0, 2.1),
    inner_load=(310.0, 0.0),
    outer_load=(290.0, 17.0),
    inner_angle=(0.26, None),
    outer_angle=(0.25, 0.03),
)
ALIKE = Balls(
    azimuth=(0.0, 2.1, 4.2),
    inner_load=(310.0,) * 3,
    outer_load=(290.0,) * 3,
    inner_angle=(0.26,) * 3,
    outer_angle=(0.25,) * 3,
)


def ring(balls: Balls = UNEQUAL, displacement: Displacement | None = PLACE) -> RingPoint:
    return RingPoint(displacement=displacement, stiffness=STIFFNESS, balls=balls, holding_moment=None)


def tables(*points: TorquePoint, units: Units = METRIC) -> list[Any]:
    document: Any = as_document({"torque": {}}, units)
    document.torque.points = points
    return ring_tables(document)


def numbers(rows: Any) -> list[list[float]]:
    return [[float(cell) for cell in row[1:]] for row in rows]


@pytest.mark.parametrize(
    ("units", "force", "torque", "length"),
    [(METRIC, 1.0, 1e-3, 1e-6), (INCH_POUND, POUND, POUND * INCH, 1e-6 * INCH)],
)
def test_a_column_of_the_stiffness_is_what_moves_the_ring_by_one_unit(
    units: Units, force: float, torque: float, length: float
) -> None:
    """A micrometre or a microinch along an axis, or a thousandth of a radian about one."""
    _, stiffness, _ = tables(point(ring=ring()), units=units)
    (group,) = stiffness.groups
    moved, unit = np.diag([length] * 3 + [1e-3] * 2), np.array([force] * 3 + [torque] * 2)
    expected = np.array(STIFFNESS) @ moved / unit[:, None]
    expected[1, 2] = expected[2, 1] = 0.0
    assert numbers(group.rows) == pytest.approx(expected, rel=5.1e-4)  # four digits are written
    assert [row[0].rpartition(", ")[2] for row in group.rows] == [units.force.name] * 3 + [units.torque.name] * 2


def test_a_ring_has_its_place_in_small_lengths_and_both_angles() -> None:
    placed, *_ = tables(point(ring=ring()))
    (group,) = placed.groups
    assert group.rows[0][-5:] == [
        "13.000", "-2.500", "0.750", "0.0172 (0.000300)", "-0.0401 (-0.000700)",
    ]  # fmt: skip
    assert placed.heads[-5].text == "axially, um"


def test_without_a_place_there_are_stiffness_and_balls() -> None:
    titles = [table.label for table in tables(point(ring=ring(displacement=None)))]
    assert titles == ["Stiffness: what moves the ring by one unit", "Load and contact angle of every ball"]


def test_each_ball_has_a_row_and_alike_ones_have_one_row() -> None:
    *_, balls = tables(point(ring=ring()))
    first, second = balls.groups[0].rows
    assert first[:3] == ["0.0 (0.000)", "310.0", "290.0"]
    assert second[:3] == ["120.3 (2.100)", "0.000", "17.00"]
    *_, balls = tables(point(ring=ring(ALIKE)))
    (row,) = balls.groups[0].rows
    assert row[:3] == ["all 3 balls", "310.0", "290.0"]


def test_the_first_and_the_last_point_with_a_ring_are_shown() -> None:
    series = [point(number, ring=ring()) for number in range(3)]
    for table in tables(*series)[1:]:
        assert [group.title.partition(":")[0] for group in table.groups] == ["point 1", "point 3"]
    *_, balls = tables(*series[:1])
    assert len(balls.groups) == 1
    *_, balls = tables(series[0], point(1))  # whose balls have loads by a formula
    assert len(balls.groups) == 1
    assert tables(point()) == []
    assert tables() == []
    assert ring_tables(as_document({"torque": None})) == []
