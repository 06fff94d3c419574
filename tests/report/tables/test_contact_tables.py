"""The tables of a terminal and the numbers in JSON, against a result made by hand: see `made` in conftest.py."""

import re
from dataclasses import replace
from io import StringIO
from types import SimpleNamespace
from typing import Any

import numpy as np
from rich.console import Console

from fembearing.check.comparison import compared
from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.report import report_of
from fembearing.report.sections.contacts import pocket_tables
from fembearing.report.sections.validation import detail_sections
from fembearing.report.terminal import print_sections

NARROW = 80  # columns, of a pipe


def text_of(result: Validation) -> str:
    out = StringIO()
    print_sections(Console(file=out, width=NARROW), detail_sections(report_of(result)))
    return out.getvalue()


def rows_of(printed: str) -> list[list[str]]:
    return [re.split(r"\s{2,}", line.strip()) for line in printed.splitlines()]


def with_limits(made: Validation, **numbers: np.ndarray) -> Validation:
    assert made.torque is not None
    friction = made.torque.friction
    return replace(
        made, torque=replace(made.torque, friction=replace(friction, limits=replace(friction.limits, **numbers)))
    )


def test_a_limit_that_is_passed_fails_the_whole_and_says_why(made: Validation) -> None:
    """The race yields and the scene's numbers stay: numerical and physical verdicts are apart."""
    result = with_limits(made, peak_pressure=np.array([[1e9, 6.3e9, 2e9], [1e9, 1e9, 1e9]]))
    lines = " ".join(text_of(result).split())
    assert "peak pressure inner race 2 6.3 GPa 4.2 GPa fail" in lines
    assert "Peak pressure: Above the static limit of ISO 76" in lines
    assert lines.endswith("fail: comparison fail, numerical pass, physical fail")
    found = plain(report_of(result))
    assert (found["verdict"]["numerical"], found["verdict"]["physical"]) == ("pass", "fail")
    assert found["physical"] == found["torque"]["verdicts"]["physical"]
    assert found["physical"][0]["value"] == 6.3e9


def test_what_is_not_known_of_a_limit_is_neither_pass_nor_fail(made: Validation) -> None:
    """The outer shoulder is not known and a low one would cut off 0.13; the friction at one point is not known."""
    result = with_limits(
        made, cut_off=np.array([[0.0, 0.0, 0.0], [0.0, 0.13, 0.1]]), cage_grip=np.array([0.2, np.nan, 0.3])
    )
    rows = rows_of(text_of(result))
    assert ["load cut off", "outer race", "2", "13 %", "10 %", "unknown"] in rows
    assert ["cage force", "cage", "3", "30 %", "90 %", "unknown"] in rows
    assert plain(report_of(result))["verdict"]["physical"] == "unknown"


def pocket(geometry: str, approach: tuple[float, float], stiffness: tuple[float, float]) -> Any:
    """By finite elements, with uncertainty each, relative."""
    found = {"approach": compared(0.6e-6, approach[0], approach[1] * approach[0])}
    found |= {"stiffness": compared(60e9, stiffness[0], stiffness[1] * stiffness[0])}
    hertz, reference = (
        SimpleNamespace(approach=0.6e-6, stiffness=60e9),
        SimpleNamespace(approach=approach[0], stiffness=stiffness[0]),
    )
    return SimpleNamespace(
        pair="pocket", geometry=geometry, load=28.5, quantities=found, hertz=hertz, reference=reference
    )


def test_a_pocket_is_softer_by_its_sheet_which_is_a_spring_in_series() -> None:
    """28.5 N over the 0.3 um that the sheet adds; no spring where that is uncertain, no table without a pocket."""
    seat = pocket("real", (0.58e-6, 0.01), (63e9, 0.015))
    sheet = pocket("wall", (0.88e-6, 0.02), (39e9, 0.03))
    race: Any = SimpleNamespace(pair="inner")
    (table,) = pocket_tables([race, race, seat, sheet])
    assert table.label.endswith("at 28.5 N")
    assert table.groups[0].rows == [
        ["half spaces, Hertz", "60.00", "", "+0.0%", "0.6000"],
        ["thick seat", "63.00", "1.50%", "+5.0%", "0.5800"],
        ["sheet on its rim", "39.00", "3.00%", "-35.0%", "0.8800"],
    ]
    # 0.0058 and 0.0176 of 0.3 um
    assert table.notes[0] == "Sheet in series with the seat: 95 N/um +- 7.80%, for cage.sheet_stiffness."
    stiff = pocket("wall", (0.59e-6, 0.02), (39e9, 0.03))
    assert "series" not in pocket_tables([seat, stiff])[0].notes[0]
    assert pocket_tables([race]) == []
