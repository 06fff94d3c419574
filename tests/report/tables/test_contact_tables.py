"""The tables of a terminal and the numbers in JSON, against a result made by hand: see `made` in conftest.py."""

import re
from dataclasses import replace
from io import StringIO
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from fembearing.check.comparison import compared, compared_with
from fembearing.check.contact.load_series import LoadPoint, LoadSeries, StiffnessLaw
from fembearing.check.contact.subsurface import NAMES, SubsurfaceComparison
from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.report import report_of
from fembearing.report.tables.contacts import pocket_table, series_table, subsurface_table
from fembearing.report.terminal.table import show
from fembearing.report.terminal.validation import print_details
from tests.analytic.specimens import present

NARROW = 80  # columns, of a pipe


def text_of(result: Validation) -> str:
    out = StringIO()
    print_details(Console(file=out, width=NARROW), report_of(result))
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


def test_a_stress_has_its_share_and_a_depth_its_length() -> None:
    """Hertz's von Mises stress is greatest on the surface here: a length is off, no share."""
    hertz, by_fe = (0.612e9, 75.3e-6, 1.12e9, 0.0), (0.6e9, 75e-6, 1.11e9, 3.5e-6)
    found = map(compared, hertz, by_fe, (0.003e9, 0.61e-6, 0.0222e9, 1.4e-6))
    quantities = dict(zip(NAMES, found, strict=True))
    quantities[NAMES[-1]] = replace(quantities[NAMES[-1]], discrepancy=None)
    below = SubsurfaceComparison(side="lower", quantities=quantities)
    out = StringIO()
    show(Console(file=out, width=NARROW), subsurface_table(below))
    rows = rows_of(out.getvalue())
    for row in (
        ["shear, GPa", "0.6120", "0.6000", "+2.00% *", "0.50%"],
        ["its depth, um", "75.30", "75.00", "+0.40%", "0.61 um"],
        ["von Mises, GPa", "1.120", "1.110", "+0.90%", "2.00%"],
        ["its depth, um", "0.000", "3.500", "- *", "1.4 um"],
    ):
        assert row in rows


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
    table = present(pocket_table([race, race, seat, sheet]))
    assert table.label.endswith("at 28.5 N")
    assert table.groups[0].rows == [
        ["half spaces, Hertz", "60.00", "", "+0.0%", "0.6000"],
        ["thick seat", "63.00", "1.50%", "+5.0%", "0.5800"],
        ["sheet on its rim", "39.00", "3.00%", "-35.0%", "0.8800"],
    ]
    # 0.0058 and 0.0176 of 0.3 um
    assert table.notes == ["Sheet in series with the seat: 95 N/um +- 7.80%, for cage.sheet_stiffness."]
    stiff = pocket("wall", (0.59e-6, 0.02), (39e9, 0.03))
    assert present(pocket_table([seat, stiff])).notes == []
    assert pocket_table([race]) is None


def under(load: float, hertz: float, approach: float, mesh: float, tangent: tuple[Any, Any]) -> LoadPoint:
    """One load of a series; mesh : relative uncertainty, beside 4 % of the domain"""
    uncertainty = float(np.hypot(mesh, 0.04)) * approach
    return LoadPoint(
        load=load,
        quantities={"approach": compared(hertz, approach, uncertainty)},
        tangent=tangent[0],
        tangent_uncertainty=tangent[1],
        hertz_tangent=1.5 * load / hertz,
    )


def series(**changed: Any) -> LoadSeries:
    given: dict[str, Any] = {
        "pair": "pocket",
        "contact_angle": 0.0,
        "geometry": "wall",
        "tolerance": 0.05,
        "points": (
            under(20.0, 5.6e-6, 5e-6, 0.03, (7.1e6, 0.034)),
            under(64.0, 8.2e-6, 8e-6, 0.03, (9.3e6, None)),
            under(40.0, 6e-6, 7.5e-6, 0.075, (None, None)),
        ),
        "law": None,
        "pocket_law": None,
        "hertz_stiffness": 60e9,
        "verdict": "shown",
        "warnings": (),
        "meshes": 3,
        "seconds": 12.3,
        "peak_memory": None,
    }
    return LoadSeries(**given | changed)


def test_each_load_of_a_series_has_its_approach_and_its_tangent() -> None:
    """Hertz's tangent is 1.5 F/delta."""
    table = series_table(series())
    assert table.label == "Ball in cage pocket, sheet on its rim: 3 loads"
    assert table.groups[0].rows == [
        ["20", "5.6000", "5.0000", "+12.00% *", "5.00%", "7.100", "3.40%", "5.357"],
        ["64", "8.2000", "8.0000", "+2.50%  ", "5.00%", "9.300", "-", "11.71"],
        ["40", "6.0000", "7.5000", "-20.00% *", "8.50%", "-", "-", "10.00"],
    ]
    assert len(table.notes) == 2  # without a law
    assert table.notes[-1] == "Finite elements, wall, 3 meshes for all loads, 12.3 s"
    assert series_table(series(meshes=1)).notes[-1].endswith("wall, 1 mesh for all loads, 12.3 s")


def test_the_law_of_a_series_has_the_uncertainties_that_are_known() -> None:
    law = StiffnessLaw(
        stiffness=24.5e9,
        exponent=1.47,
        stiffness_uncertainty=0.21,
        misfit=0.012,
        propagated=0.005,
        exponent_uncertainty=0.017,
    )
    assert series_table(series(law=law)).notes[0] == (
        "F = K delta^n: K 24.5 GN/m^1.4700 +- 21.00%, n 1.4700 +- 0.0170 by finite elements; 60 GN/m^1.5 and 1.5 by "
        "Hertz."
    )
    two = replace(law, stiffness_uncertainty=None, misfit=None, exponent_uncertainty=None)
    said = series_table(series(law=two)).notes[0]
    assert "K 24.5 GN/m^1.4700, n 1.4700 (power law assumed) by finite elements" in said


def test_every_word_of_the_table_fits(checked: Validation) -> None:
    """The widest verdict beside the widest numbers."""
    inner = checked.contacts[0]
    found = inner.numbers
    parts = {
        name: compared_with(
            replace(part, mesh=0.789, order=None, corrected=()), found.quantities[name].production, verdict="undecided"
        )
        for name, part in found.estimates.items()
    }
    inner = inner.with_numbers(quantities=parts, verdict="undecided", tolerance=0.3)
    wide = replace(checked, contacts=(inner, *checked.contacts[1:]))
    rows = [line for line in text_of(wide).splitlines() if " none " in line][: len(parts)]  # the inner race comes first
    assert len(rows) == len(parts)
    assert all(row.rstrip().endswith("undecided") for row in rows)
    assert max(map(len, text_of(wide).splitlines())) <= NARROW
    assert "\N{HORIZONTAL ELLIPSIS}" not in text_of(wide)


def test_a_scene_without_friction_is_told_that_there_is_no_torque(checked: Validation) -> None:
    bare = text_of(replace(checked, torque=None, torque_change=None))
    assert "No torque:" in bare
    assert "Friction torque" not in bare
    assert "No torque:" not in text_of(checked)


@pytest.mark.parametrize("verdict", ["pass", "outside validity"])
def test_the_last_line_is_the_verdict(checked: Validation, verdict: str) -> None:
    inner = checked.contacts[0].with_numbers(verdict=verdict)
    result = replace(checked, contacts=(inner, *checked.contacts[1:]))
    overall = {"pass": "pass", "outside validity": "fail"}[verdict]
    assert text_of(result).splitlines()[-1] == f"{overall}: comparison {verdict}, numerical pass, physical pass"
