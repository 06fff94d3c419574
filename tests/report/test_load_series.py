"""The record of a load series: its numbers are those of the series, and its JSON is read again as it was written."""

import json
from collections.abc import Callable
from dataclasses import replace

from pydantic import TypeAdapter

from analytic.scene import Contact
from fembearing.check.contact.hertz import hertz_quantities
from fembearing.check.contact.load_series import compare_series
from fembearing.check.contact.refinement import FORMAL_ORDERS
from fembearing.mesh.recipe import Recipe
from fembearing.plain_types import plain
from fembearing.report.load_series import SeriesRecord, series_record
from tests.analytic.specimens import present


def test_a_series_has_all_quantities_where_the_compliance_gives_them(
    contacts: dict[str, Contact], shallow: Callable[[str], Recipe]
) -> None:
    contact = replace(contacts["inner"], shoulder=0.9e-3, far_shoulder=0.9e-3, contact_angle=0.0)
    loads = [70.0, 200.0, 340.0]  # the last reaches the shoulder
    series = compare_series(contact, recipe=shallow("race"), loads=loads, tolerance=0.9)
    record = series_record(series)
    assert [list(each.fe) == list(each.convergence) for each in record.loads] == [True] * 3
    assert [set(each.fe) for each in record.loads] == [set(FORMAL_ORDERS), set(FORMAL_ORDERS), {"approach"}]
    for each, point in zip(record.loads, series.points, strict=True):
        assert each.fe["approach"] == point.approach.value
        assert each.uncertainty["approach"] == point.approach.total
        for name, value in each.discrepancy.items():
            hertz = getattr(hertz_quantities(replace(contact, load=point.load)), name)
            assert abs(each.fe[name] * (1 + value) / hertz - 1) < 1e-12, name  # round-off
    peak = series.points[1].others["peak_pressure"]
    assert (record.loads[1].fe["peak_pressure"], record.loads[1].uncertainty["peak_pressure"]) == (
        peak.value,
        peak.total,
    )
    assert record.exponent_uncertainty == present(series.law).exponent_uncertainty


def test_what_is_written_is_read_again(contacts: dict[str, Contact], shallow: Callable[[str], Recipe]) -> None:
    for loads in ([310.0], [310.0, 120.0]):
        record = series_record(compare_series(contacts["outer"], recipe=shallow("race"), loads=loads, tolerance=0.9))
        text = json.dumps(plain(record), allow_nan=False)
        assert TypeAdapter(SeriesRecord).validate_json(text) == record
