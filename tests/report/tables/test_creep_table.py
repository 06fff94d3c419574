"""Friction of a ball on both races: which quantities have a row, and its cells, worked out by hand."""

from dataclasses import replace

import pytest

from fembearing.report.sections.creep import creep_table
from tests.report.specimens import NOTHING, numbers, race


@pytest.mark.parametrize("method", ["formula", "production", "reference"])
def test_a_quantity_has_a_row_if_one_method_finds_more_than_the_uncertainty(method: str) -> None:
    moment, zero = replace(NOTHING, **{method: -5e-6}), replace(NOTHING, uncertainty=0.0)  # pyright: ignore[reportArgumentType]
    creep = numbers(race(spin_moment=moment, power=zero))
    inner, outer, whole = creep_table(creep).groups
    assert [row[0] for row in inner.rows] == ["spin moment, N mm"]
    assert outer.rows == []
    assert len(whole.rows) == 1
