"""The systems of units, against the definitions of pound and inch."""

from dataclasses import fields
from math import pi

import pytest

from analytic.columns import COLUMNS
from analytic.units import INCH_POUND, METRIC, SYSTEMS, Units, unit_for

POUND, INCH = 4.4482216152605, 25.4e-3  # N and m, by definition
SAME = 1e-14  # a few round-offs


@pytest.mark.parametrize(
    ("kind", "in_si", "metric", "inch"),
    [
        ("force", 5 * POUND, 22.2411080763025, 5),
        ("torque", 3 * POUND * INCH, 338.954487082850, 3),  # N mm, lbf in
        ("pressure", 250e3 * POUND / INCH**2, 1.72368932329205, 250),  # GPa, ksi
        ("stress", 2e3 * POUND / INCH**2, 13.7895145863364, 2),
        ("per_pressure", 0.14e-3 * INCH**2 / POUND, 20.3052832822, 0.14),
        ("length", 3.5 * INCH, 88.9, 3.5),
        ("small_length", 40e-6 * INCH, 1.016, 40),
        ("stiffness", 7e6 * POUND / INCH**1.5, 7.69190445876, 7),
        ("tangent", 2e6 * POUND / INCH, 350.253670493, 2),
        ("line_load", 1e4 * POUND / INCH, 1751.26835246, 1e4),
        ("temperature", 313.15, 40, 104),
        ("angle", pi / 12, 15, 15),
        ("speed", 50 * pi, 1500, 1500),
        ("share", 0.025, 2.5, 2.5),
    ],
)
def test_a_value_is_shown_by_the_definition_of_its_unit(kind: str, in_si: float, metric: float, inch: float) -> None:
    assert getattr(METRIC, kind).number(in_si) == pytest.approx(metric, rel=1e-11)  # digits of the figures above
    assert getattr(INCH_POUND, kind).number(in_si) == pytest.approx(inch, rel=10 * SAME)


def test_every_kind_has_a_unit_and_no_metric_one_stands_for_two() -> None:
    assert set(SYSTEMS) == {"metric", "inch"}
    metric = [getattr(METRIC, each.name) for each in fields(Units)]
    assert len(set(metric)) == len(metric)
    for each in fields(Units):
        assert METRIC.instead_of(getattr(METRIC, each.name)) == getattr(METRIC, each.name)
        assert INCH_POUND.instead_of(getattr(METRIC, each.name)) == getattr(INCH_POUND, each.name)


@pytest.mark.parametrize(
    ("unit", "size", "name"),
    [
        ("Pa", 1.01e8, "GPa"),
        ("Pa", 0.99e8, "MPa"),
        ("Pa", -2e8, "GPa"),
        ("Pa", 1.01e5, "MPa"),
        ("Pa", 0.99e5, "Pa"),
        ("m", 1.01e-3, "mm"),
        ("m", 0.99e-3, "um"),
        ("m", -2e-3, "mm"),
        ("N*m^2", 3.0, "N m^2"),
    ],
)
def test_a_unit_changes_with_the_size_of_its_values(unit: str, size: float, name: str) -> None:
    assert unit_for(unit, size).name == name


@pytest.mark.parametrize(
    ("column", "name", "inch"),
    [
        ("uncertainty_numerical", "%", "%"),
        ("friction_coefficient_inner", "", ""),
        ("film_inner", "um", "uin"),
        ("peak_pressure_outer", "GPa", "ksi"),
        ("torque_total", "N mm", "lbf in"),
        ("inner_speed", "rpm", "rpm"),
    ],
)
def test_a_column_has_one_unit_in_each_system(column: str, name: str, inch: str) -> None:
    assert (COLUMNS[column].shown().name, COLUMNS[column].shown(INCH_POUND).name) == (name, inch)
