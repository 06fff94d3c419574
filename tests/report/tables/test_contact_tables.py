"""The tables of a terminal and the numbers in JSON, against a result made by hand: see `made` in conftest.py."""

import json
import math
import re
from dataclasses import replace
from io import StringIO
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from fembearing.grid_convergence import Estimate
from fembearing.plain_types import plain
from fembearing.report.report import report_of
from fembearing.report.tables.contacts import pocket_table, series_table, subsurface_table
from fembearing.report.terminal.table import show
from fembearing.report.terminal.validation import print_details
from fembearing.verify.contact.load_series import LoadPoint, LoadSeries
from fembearing.verify.contact.pocket_law import PocketLaw
from fembearing.verify.contact.power_law import StiffnessLaw
from fembearing.verify.contact.ring import RingStructure
from fembearing.verify.contact.subsurface import NAMES, comparison_below
from fembearing.verify.torque.catalogue import BesideCatalogue
from fembearing.verify.torque.catalogue_models import CatalogueBand
from fembearing.verify.validation import Validation
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import as_document

NARROW = 80  # columns, of a pipe


def text_of(result: Validation) -> str:
    out = StringIO()
    print_details(Console(file=out, width=NARROW), report_of(result))
    return out.getvalue()


@pytest.fixture(scope="module")
def printed(made: Validation) -> str:
    return text_of(made)


@pytest.fixture(scope="module")
def told(made: Validation) -> dict[str, Any]:
    return json.loads(json.dumps(plain(report_of(made)), allow_nan=False))


def rows_of(printed: str) -> list[list[str]]:
    return [re.split(r"\s{2,}", line.strip()) for line in printed.splitlines()]


def test_each_row_of_the_terminal_shows_its_numbers(printed: str) -> None:
    rows = rows_of(printed)
    for row in (
        ["approach, um", "5.3295", "5.2250", "+2.00% *", "1.14%", "3.6", "pass"],
        ["semi-axis a, mm", "0.11760", "0.12000", "-2.00%", "2.03%", "2.7", "pass"],
        ["semi-axis b, mm", "0.96800", "0.88000", "+10.00% *", "1.80%", "1.4", "fail"],
        ["stiffness, GN/m^1.5", "22.800", "24.000", "-5.00%", "5.02%", "2.2", "outside"],
        ["semi-axis b, mm", "0.31680", "0.32000", "-1.00% *", "0.25%", "2.1", "pass"],
        ["approach, um", "0.60900", "0.87000", "-30.00% *", "0.33%", "2.8", "shown"],
    ):
        assert row in rows


def test_the_longest_verdict_is_not_cut_at_80_characters(printed: str) -> None:
    row = ["stiffness, GN/m^1.5", "24.250", "25.000", "-3.00% *", "1.41%", "none", "undecided"]
    assert row in rows_of(printed)


def test_the_terminal_sums_up_pocket_and_torque(printed: str) -> None:
    words = " ".join(printed.split())
    for said in (
        "sheet on its rim 39.52 0.57% -35.0% 0.8700",
        "3 600 910 53.00 51.50 -2.83 -2.67",  # 53 + 48.5 - 50
        "the change has a numerical uncertainty of 1.37 %",
        "the change is the whole effect of the true shapes",
        "semi-axis a 0.1203 mm (+0.25%)",
        "error, over FE - 1): approach 5.2198 um (-0.10%)",
        "peak pressure 1.7085 GPa (+0.50%)",
        "stiffness 25.05 GN/m^1.5 (+0.20%)",
        "stated 95 % uncertainty at most 0.81%",
        "Hertz's contacts corrected for finite geometry; +- 0.43 %",
        "Numerical: pass, the uncertainty of the torque is 1.3 %, within the tolerance 5 %.",
        "Tolerance 5 %, 43.2 s.",
        "fail: comparison fail, numerical pass, physical pass",
    ):
        assert said in words


def test_every_operating_point_has_its_total_with_the_loads_that_vary(printed: str) -> None:
    """The total is that of the command `torque`."""
    rows = rows_of(printed)
    assert "Friction torque" in printed
    assert ["#", "rpm", "Fa, N", "spin", "conf.", "hyst.", "total", "+-"] in rows
    for row in (
        ["1", "150", "700", "17.10", "11.40", "2.500", "34.00", "1.1 %"],
        ["2", "300", "900", "22.50", "14.30", "3.200", "42.00", "1.2 %"],
        ["3", "600", "910", "27.00", "19.00", "4.000", "53.00", "1.3 %"],
    ):
        assert row in rows


def test_a_radial_load_and_a_moment_stand_with_their_point(made: Validation) -> None:
    assert made.torque is not None
    friction = replace(made.torque.friction, radial_load=np.array([0.0, 310.0, 320.0]), moment=np.full(3, 1.5))
    result = replace(made, torque=replace(made.torque, friction=friction))
    rows = rows_of(text_of(result))
    assert ["3", "600", "910", "320", "27.00", "19.00", "4.000", "53.00", "1.3 %"] in rows
    assert "Friction torque of 6205, moment 1500 N mm" in text_of(result)
    point = plain(report_of(result))["torque"]["points"][2]
    assert (point["radial_load"], point["moment"]) == (320.0, 1.5)


def test_each_physical_limit_has_a_row_with_its_worst_point(printed: str) -> None:
    rows = rows_of(printed)
    for row in (
        ["peak pressure", "inner race", "2", "1.78 GPa", "4.2 GPa", "pass"],
        ["peak pressure", "outer race", "3", "1.57 GPa", "4.2 GPa", "pass"],
        ["load cut off", "inner race", "3", "3.1 %", "10 %", "pass"],
        ["load cut off", "outer race", "3", "0.2 %", "10 %", "pass"],
        ["sliding number", "inner race", "3", "17 %", "100 %", "pass"],
        ["sliding number", "outer race", "2", "13 %", "100 %", "pass"],
        ["cage force", "cage", "2", "43 %", "90 %", "pass"],
    ):
        assert row in rows
    assert "gyroscopic" not in printed  # nothing of it is known here


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


def test_the_catalogue_band_is_noted_and_not_judged(made: Validation) -> None:
    assert made.torque is not None
    band = CatalogueBand(low=np.full(3, 30e-3), high=np.full(3, 45e-3), values={})
    result = replace(made, torque=replace(made.torque, catalogue=BesideCatalogue(band=band, note="a band")))
    outside = "The torque is outside the catalogue band: above it at 1 of 3 operating points."
    assert outside in " ".join(text_of(result).split())
    assert plain(report_of(result))["torque"]["notes"] == [outside]
    assert result.verdicts.summary == made.verdicts.summary


def test_the_ring_is_told_apart_from_the_contact(made: Validation) -> None:
    ring = RingStructure(approach=-0.2125e-6, share=-0.0407, mesh=6e-9, domain=1.5e-9, reach=0.3e-9, uncertainty=7.8e-9)
    inner, outer, *pocket = made.contacts
    result = replace(made, contacts=(replace(inner, ring=ring), replace(outer, ring=None), *pocket))
    words = " ".join(text_of(result).split())
    said = "Ring on a rigid seat: approach -0.212 um (-4.1% of the contact's), +- 0.008 um: structure, not contact."
    assert words.count(said) == words.count("Ring on a rigid seat") == 1
    told = [contact["ring"] for contact in plain(report_of(result))["contacts"]]
    assert told == [plain(ring), None, None, None]


def test_a_stress_has_its_share_and_a_depth_its_length() -> None:
    """Hertz's von Mises stress is greatest on the surface here: a length is off, no share."""
    below = comparison_below(
        "lower",
        hertz=dict(zip(NAMES, (0.612e9, 75.3e-6, 1.12e9, 0.0), strict=True)),
        fe=dict(zip(NAMES, (0.6e9, 75e-6, 1.11e9, 3.5e-6), strict=True)),
        uncertainty=dict(zip(NAMES, (0.003e9, 0.61e-6, 0.0222e9, 1.4e-6), strict=True)),
    )
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


def pocket(geometry: str, approach: float, stiffness: float, uncertainty: dict[str, float]) -> dict[str, Any]:
    fe = {"approach": approach, "stiffness": stiffness}
    hertz = {"approach": 0.6e-6, "stiffness": 60e9}
    return {"pair": "pocket", "geometry": geometry, "load": 28.5, "hertz": hertz, "fe": fe, "uncertainty": uncertainty}


def test_a_pocket_is_softer_by_its_sheet_which_is_a_spring_in_series() -> None:
    """28.5 N over the 0.3 um that the sheet adds; no spring where that is uncertain, no table without a pocket."""
    seat = pocket("real", 0.58e-6, 63e9, {"approach": 0.01, "stiffness": 0.015})
    sheet = pocket("wall", 0.88e-6, 39e9, {"approach": 0.02, "stiffness": 0.03})
    race = seat | {"pair": "inner", "load": 371.5}
    table = present(pocket_table(as_document({"contacts": [race, race, seat, sheet]}).contacts))
    assert table.label.endswith("at 28.5 N")
    assert table.groups[0].rows == [
        ["half spaces, Hertz", "60.00", "", "+0.0%", "0.6000"],
        ["thick seat", "63.00", "1.50%", "+5.0%", "0.5800"],
        ["sheet on its rim", "39.00", "3.00%", "-35.0%", "0.8800"],
    ]
    # 0.0058 and 0.0176 of 0.3 um
    assert table.notes == ["Sheet in series with the seat: 95 N/um +- 7.80%, for cage.sheet_stiffness."]
    stiff = sheet | {"fe": seat["fe"] | {"approach": 0.59e-6}}
    assert present(pocket_table(as_document({"contacts": [seat, stiff]}).contacts)).notes == []
    assert pocket_table(as_document({"contacts": [race]}).contacts) is None


def under(load: float, hertz: float, approach: float, mesh: float, tangent: tuple[Any, Any]) -> LoadPoint:
    """One load of a series; mesh : relative uncertainty, beside 4 % of the domain"""
    return LoadPoint(
        load=load,
        approach=Estimate(values=(0.9 * approach, approach), order=None, richardson=None, mesh=mesh, domain=0.04),
        others={},
        hertz_approach=hertz,
        tangent=tangent[0],
        tangent_uncertainty=tangent[1],
        verdict="pass",
    )


def series(**changed: Any) -> LoadSeries:
    known: Any = as_document({"pair": "pocket", "contact_angle": 0.0})
    given: dict[str, Any] = {
        "contact": known,
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
        **dict.fromkeys(("solutions", "warnings"), ()),
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
    law = StiffnessLaw(stiffness=24.5e9, exponent=1.47, stiffness_uncertainty=0.21, misfit=0.012, propagated=0.005)
    assert series_table(series(law=law)).notes[0] == (
        "F = K delta^n: K 24.5 GN/m^1.4700 +- 21.00%, n 1.4700 +- 0.0170 by finite elements; 60 GN/m^1.5 and 1.5 by "
        "Hertz."
    )
    two = replace(law, stiffness_uncertainty=None, misfit=None)
    said = series_table(series(law=two)).notes[0]
    assert "K 24.5 GN/m^1.4700, n 1.4700 (power law assumed) by finite elements" in said


def test_the_law_of_a_sheet_gives_the_keys_of_a_scene_at_the_largest_load() -> None:
    """(64/8e9)^(2/3) m = 4 um by the contact alone."""
    law = StiffnessLaw(stiffness=24.5e9, exponent=1.47, stiffness_uncertainty=None, misfit=None, propagated=0.005)
    sheet = PocketLaw(stiffness=8e9, stiffness_uncertainty=0.031, sheet=12.5e6, sheet_uncertainty=0.042)
    _, found, approach, stiffness, *_ = series_table(series(law=law, pocket_law=sheet)).notes
    assert found.endswith("K 8 GN/m^1.5 +- 3.10%, k 12.5 N/um +- 4.20%. In a scene:")
    assert approach == 'cage.pocket_approach = { load = "64 N", approach = "4 um" }'
    assert stiffness == 'cage.sheet_stiffness = "12.5 N/um"'
    two = replace(sheet, stiffness_uncertainty=None, sheet_uncertainty=None)
    assert "K 8 GN/m^1.5, k 12.5 N/um. In" in series_table(series(law=law, pocket_law=two)).notes[1]


def test_json_tells_each_verdict_with_its_numbers(told: dict[str, Any]) -> None:
    rows = {(row["pair"], row["quantity"]): row for row in told["verdicts"]}
    assert len(rows) == len(told["verdicts"]) == 3 * 5
    for pair, quantity, production, reference, discrepancy, uncertainty, exceeds, verdict in (
        ("inner", "semi_axis_rolling", 0.1176e-3, 0.12e-3, -0.02, math.hypot(0.0195, 0.0055), False, "pass"),
        ("inner", "semi_axis_transverse", 0.968e-3, 0.88e-3, 0.1, math.hypot(0.017, 0.006), True, "fail"),
        ("outer", "stiffness", 22.8e9, 24e9, -0.05, math.hypot(0.0301, 0.0402), False, "outside validity"),
        ("pocket", "approach", 0.609e-6, 0.58e-6, 0.05, math.hypot(0.0029, 0.0038), True, "undecided"),
    ):
        assert rows[pair, quantity] == {
            "pair": pair,
            "geometry": "real",
            "quantity": quantity,
            "production": production,
            "reference": reference,
            "discrepancy": pytest.approx(discrepancy, rel=1e-12),  # round-off
            "uncertainty": pytest.approx(uncertainty, rel=1e-12),
            "exceeds_uncertainty": exceeds,
            "comparison": {
                "error": pytest.approx(production - reference, rel=1e-9),  # a difference of near values
                "numerical": 0.0,
                "input": 0.0,
                "reference": pytest.approx(uncertainty * reference, rel=1e-12),
                "total": pytest.approx(uncertainty * reference, rel=1e-12),
                "resolved": exceeds,
            },
            "verdict": verdict,
            "bearing": None,
        }


def test_json_tells_each_contact_with_its_numbers(told: dict[str, Any]) -> None:
    inner, outer, seat, sheet = told["contacts"]
    assert inner["load"] == 371.5
    assert inner["hertz"]["approach"] == 5.3295e-6
    assert inner["fe"]["approach"] == 5.225e-6
    assert inner["discrepancy"]["approach"] == pytest.approx(0.02, rel=1e-12)  # round-off
    assert inner["uncertainty"]["approach"] == pytest.approx(math.hypot(0.011, 0.003), rel=1e-12)
    assert inner["convergence"]["approach"] == {
        "values": [4.4e-6, 5.06e-6, 5.5e-6],
        "order": 3.6,
        "grid_convergence_index": 0.033,
        "richardson": 5.225e-6,
        "mesh": 0.011,
        "settled": True,
        "beyond": 0.0,
        "domain": 0.003,
        "sides": 0.0,
        "corrected": [],
    }
    assert inner["formal_order"]["approach"] == 4.0
    assert [contact["verdict"] for contact in (inner, outer, seat)] == ["fail", "outside validity", "undecided"]
    assert (sheet["geometry"], sheet["cost"]["unknowns"]) == ("wall", 43000)


def test_json_tells_the_change_of_torque(told: dict[str, Any]) -> None:
    change = told["torque_change"]
    assert change["contact_angle"] == {"production": [0.282, 0.3013, 0.3032], "corrected": [None, 0.2998, 0.3019]}
    assert change["torque"]["production"] == [34e-3, 42e-3, 53e-3]
    added = [pytest.approx(total, rel=1e-12) for total in (43e-3, 51.5e-3)]  # round-off
    assert change["torque"]["corrected"] == [None, *added]
    relative = [pytest.approx(part, rel=1e-9) for part in (1 / 42, -1.5 / 53)]  # of near values
    assert change["change"]["total"] == [None, *relative]
    assert change["change"]["race"] == [None, pytest.approx(1 / 40, rel=1e-9), pytest.approx(-1.5 / 50, rel=1e-9)]
    assert (change["uncertainty"], change["verdict"]) == (0.0137, "undecided")
    assert change["uncertainties"] == {"total": 0.0137, "spin": 0.021, "contact_angle": 0.0019}


def test_every_word_of_the_table_fits(checked: Validation) -> None:
    """The widest verdict beside the widest numbers."""
    inner = checked.contacts[0]
    parts = {name: replace(part, mesh=0.789, order=None, corrected=()) for name, part in inner.estimates.items()}
    wide = replace(checked, contacts=(replace(inner, estimates=parts, tolerance=0.3), *checked.contacts[1:]))
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
    inner = replace(checked.contacts[0], valid=verdict == "pass")
    result = replace(checked, contacts=(inner, *checked.contacts[1:]))
    overall = {"pass": "pass", "outside validity": "fail"}[verdict]
    assert text_of(result).splitlines()[-1] == f"{overall}: comparison {verdict}, numerical pass, physical pass"
