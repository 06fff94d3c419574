"""The table of what accuracy costs, by its cells."""

from dataclasses import replace
from typing import Any

from fembearing.check.cost.ladder import Choice, Ladder, Method
from fembearing.report.tables.cost import cost_table


def method(name: str, **changed: Any) -> Method:
    given: dict[str, Any] = {"name": name, "error": 0.0123, "bound": 0.034, "seconds": 0.27, "spread": 0.06}
    given |= {"repeats": 5, "warm_up": 0.8, "memory": 3 * 2**28, "unknowns": 31000}
    return Method(**given | changed)


LADDER = Ladder(
    quantity="peak pressure",
    reference="the finest mesh",
    methods=(
        method("Hertz", chosen=True, unknowns=None, warm_up=None, memory=None),
        method("finite elements, level 2"),
        method("finite elements, level 5", error=None, bound=None),
        method("series", failed="no end", error=None, bound=None, seconds=None, spread=None, memory=None),
    ),
    choices=(
        Choice(tolerance=0.1, method="Hertz", seconds=0.27, price=None),
        Choice(tolerance=0.01, method="finite elements, level 2", seconds=3.1, price=11.7),
    ),
)


def test_a_method_has_its_error_bound_and_price_or_failed() -> None:
    table = cost_table([LADDER])
    assert {head.text for head in table.heads if head.wide} == {"spread", "unknowns"}
    (group,) = table.groups
    assert group.title == "Peak pressure"
    assert group.rows == [
        ["> Hertz", "1.2 %", "3.4 %", "0.27", "0.06", "", "", ""],
        ["FE, level 2", "1.2 %", "3.4 %", "0.27", "0.06", "0.8", "0.75", "31000"],
        ["FE, level 5", "reference", "", "0.27", "0.06", "0.8", "0.75", "31000"],
        ["series", "failed", "", "", "", "0.8", "", "31000"],
    ]
    assert group.notes == [
        "series failed: no end",
        "Price of the next digit: 10 %: Hertz, 0.27 s; 1 %: FE, level 2, 3.1 s, 12 times as much.",
        "Reference: the finest mesh.",
    ]


def test_a_quantity_that_a_scene_does_not_have_says_why_and_nothing_else() -> None:
    (group,) = cost_table([replace(LADDER, methods=(), choices=(), absent="no oil")]).groups
    assert group.rows == []
    assert group.notes == ["Does not apply: no oil."]
