"""The table of physical limits, and why some do not hold."""

from typing import Any

from analytic.verdicts import PhysicalCheck
from fembearing.report.tables.verdicts import POINT, physical_table


def check(verdict: str, **changed: Any) -> PhysicalCheck:
    given: dict[str, Any] = {"name": "peak_pressure", "where": "inner race", "point": 2, "value": 1.78e9}
    given |= {"limit": 4.2e9, "unit": "Pa", "verdict": verdict, "note": "the race yields"}
    return PhysicalCheck(**given | changed)


def test_only_a_limit_that_does_not_hold_is_explained_and_each_reason_stands_once() -> None:
    table = physical_table(
        [
            check("pass", note="holds"),
            check("fail", value=6.3e9),
            check("fail", where="outer race", point=0, value=5.1e9),
            check("unknown", name="shoulder", unit="1", value=0.13, limit=0.1, note="no height is known"),
        ]
    )
    assert table.groups[0].rows == [
        ["peak pressure", "inner race", "3", "1.78 GPa", "4.2 GPa", "pass"],
        ["peak pressure", "inner race", "3", "6.3 GPa", "4.2 GPa", "fail"],
        ["peak pressure", "outer race", "1", "5.1 GPa", "4.2 GPa", "fail"],
        ["load cut off", "inner race", "3", "13 %", "10 %", "unknown"],
    ]
    assert table.notes == ["Peak pressure: the race yields", "Load cut off: no height is known", POINT]
