"""The numbers of the page: every one of report.json, and some in their rows and columns, of a result made by hand."""

import re
from collections.abc import Iterator
from dataclasses import is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic.prediction.prediction import predict
from fembearing.check.validation import Validation
from fembearing.plain_types import written_fields
from fembearing.report.page.write import page_of
from fembearing.report.report import Report, report_of
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page
from tests.report.page.tables_of_page import Tables
from tests.report.tables.test_film_table import FILM
from tests.report.test_measured import TWO

Way = tuple[str | int, ...]  # to a number of report.json
UNPRINTED = (  # drawn, in sentences made earlier, a part of what is printed, or the same number in another place
    r"format|provenance\.scene_content\..*|sensitivity\..*|.*\.(radial_load|moment)",
    r"contacts\.(corrected\.uncertainty|meshes|ring|formal_order|pressure_profile|approach_curve)\..*",
    r"contacts\.(quantities\.\w+\.(uncertainty|study\.(beyond|sides))|tolerance|peak_memory)",
    r"torque\..*",  # the page has it of the result itself, and so has JSON
    r"torque_change\.(change\.(?!total).*|uncertainties\.\w+|finite_geometry\.uncertainty)",
    r"films\.(viscosity|pressure_viscosity|reach\.side|tolerance|quantities\.\w+\.(uncertainty|study\.(?!order).*))",
    r"creep\.(point\.axial_load|friction_coefficient|(solved|different)_balls|tolerance|torque\.relative_uncertainty)",
    r"creep\.races\.\w+\.(semi_axis_\w+|quantities\.(\w+\.uncertainty|(creepage_across|transverse_force)\..*))",
    r"measured\.(rows\.computed_(low|high)|inside|mean_error|scatter|shares\..*|samples|seed|seconds)",
    r"cost\.(peak_memory|ladders\.methods\.(repeats|warm_up|memory|known_error))",
)
SMALLEST = 1e-9  # less is round-off, or 0


def parts_of(node: Any) -> dict[Any, Any]:
    if is_dataclass(node):
        return {part.name: getattr(node, part.name) for part in written_fields(node)}
    return node if isinstance(node, dict) else dict(enumerate(node)) if isinstance(node, tuple | list) else {}


def ways(node: Any, way: Way = ()) -> Iterator[Way]:
    for name, part in parts_of(node).items():
        if isinstance(part, int | float) and not isinstance(part, bool):
            if abs(part) > SMALLEST:
                yield (*way, name)
        else:
            yield from ways(part, (*way, name))


def changed(node: Any, way: Way) -> Any:
    """The document with another number in one place."""
    if not way:
        return 1.37 * node if isinstance(node, float) else max(node - 1, 0)
    name, *others = way
    part = changed(parts_of(node)[name], tuple(others))
    if is_dataclass(node):
        return replace(node, **{str(name): part})  # pyright: ignore[reportArgumentType]
    if isinstance(node, dict):
        return {**node, name: part}
    return type(node)(part if number == name else each for number, each in enumerate(node))


@pytest.fixture(scope="module")
def whole(made: Validation) -> Report:
    """With an interval, films and measured torques."""
    torque = present(made.torque)
    prediction = predict(torque.scene, samples=64, workers=1)
    predicted = replace(torque, prediction=prediction, interval=np.array(prediction.total.ends))
    return replace(report_of(replace(made, torque=predicted)), films=(FILM,), measured=TWO)


@pytest.mark.parametrize("part", [0, *(pytest.param(part, marks=pytest.mark.nightly) for part in (1, 2, 3))])
def test_every_number_of_the_document_is_on_the_page(whole: Report, part: int) -> None:
    """One of each kind, as all rows of a list are alike: where it is another, so is the page."""
    page = page_of(whole, Path(), plots={})
    kinds: dict[str, Way] = {}
    for way in ways(whole):
        kinds.setdefault(".".join(name for name in way if isinstance(name, str)), way)
    printed = {kind: way for kind, way in kinds.items() if not any(re.fullmatch(each, kind) for each in UNPRINTED)}
    assert len(printed) > 150
    for kind in [*printed][part::4]:
        is_there = page_of(changed(whole, printed[kind]), Path(), plots={}) != page
        assert is_there, kind


@pytest.fixture(scope="module")
def tables(made: Validation) -> Tables:
    return Tables(written_page(made))


def test_each_verdict_stands_with_its_numbers(tables: Tables) -> None:
    """Quantity, Hertz, finite elements, the difference with a star where it exceeds the uncertainty of mesh and far
    boundary together, that uncertainty, the order of convergence, and the verdict."""
    blocks = tables.blocks("Contacts")
    inner, outer, seat, sheet = blocks
    assert inner.startswith("Ball on inner race")
    assert inner.endswith("371.5 N")
    assert outer.startswith("Ball on outer race")
    assert outer.endswith("368.5 N")
    assert seat == "Ball in cage pocket, thick seat: 28.5 N"
    assert blocks[inner] == [
        ("approach, um", "5.3295", "5.2250", "+2.00% *", "1.14%", "3.6", "pass"),
        ("semi-axis a, mm", "0.11760", "0.12000", "-2.00%", "2.03%", "2.7", "pass"),
        ("semi-axis b, mm", "0.96800", "0.88000", "+10.00% *", "1.80%", "1.4", "fail"),
        ("peak pressure, GPa", "1.7850", "1.7000", "+5.00% *", "1.39%", "4.2", "undecided"),
        ("stiffness, GN/m^1.5", "24.250", "25.000", "-3.00% *", "1.41%", "none", "undecided"),
    ]
    assert blocks[outer][4] == ("stiffness, GN/m^1.5", "22.800", "24.000", "-5.00%", "5.02%", "2.2", "outside")
    assert blocks[seat][3] == ("peak pressure, GPa", "0.13720", "0.14000", "-2.00%", "3.07%", "2.4", "undecided")
    assert blocks[sheet][0] == ("approach, um", "0.60900", "0.87000", "-30.00% *", "0.33%", "2.8", "shown")
    corrected = "approach 5.2198 um (-0.10%), semi-axis a 0.1203 mm (+0.25%), semi-axis b 0.8778 mm (-0.25%)"
    assert corrected in " ".join(tables.text.split())


def test_no_verdict_wears_the_colour_of_another(tables: Tables) -> None:
    colours = {"pass": "pass", "fail": "fail", "undecided": "undecided", "outside validity": "outside"}
    for verdict, colour in colours.items():
        assert {style for style, text in tables.styled if text == verdict} == {colour}


def test_the_pocket_is_set_against_hertz(tables: Tables) -> None:
    (heading,) = (each for each in tables.rows if each.startswith("Cage pocket"))
    assert [row[1:] for row in tables.rows[heading][1:]] == [
        ("60.80", "", "+0.0%", "0.6090"),
        ("64.00", "0.52%", "+5.3%", "0.5800"),  # 64/60.8; the other way round it would be -5.0 %
        ("39.52", "0.57%", "-35.0%", "0.8700"),
    ]


def test_each_operating_point_has_its_torque_and_what_contacts_change_in_it(tables: Tables) -> None:
    """The total that `torque` computes, by its parts, and the same total with what finite elements change."""
    assert tables.rows["Friction torque of 6205"][1:] == [
        ("1", "150", "700", "17.10", "11.40", "2.500", "34.00", "1.1 %", "21 %"),
        ("2", "300", "900", "22.50", "14.30", "3.200", "42.00", "1.2 %", "22 %"),
        ("3", "600", "910", "27.00", "19.00", "4.000", "53.00", "1.3 %", "23 %"),
    ]
    assert tables.rows["Changes by finite-element contacts"][1:] == [
        ("1", "150", "700", "34.00", "16.16 (0.2820)", "-", "-", "-", "-"),
        ("2", "300", "900", "42.00", "17.26 (0.3013)", "43.00", "17.18 (0.2998)", "+2.38", "-2.13"),  # 1 N mm more
        ("3", "600", "910", "53.00", "17.37 (0.3032)", "51.50", "17.30 (0.3019)", "-2.83", "-2.67"),
    ]
    assert "the change is the whole effect of the true shapes" in " ".join(tables.text.split())
    assert "1.37 %" in tables.text
    assert "the torque does not depend on speed" not in tables.text  # no lubricant, and yet it does


def test_each_row_has_a_cell_for_each_head(tables: Tables) -> None:
    """A row of one cell is a heading between rows."""
    assert len(tables.rows) > 15
    for heading, (head, *rows) in tables.rows.items():
        assert {len(row) for row in rows} <= {1, len(head)}, heading


def test_the_mesh_study_shows_what_each_mesh_gave(tables: Tables) -> None:
    """Quantity, values, order, GCI, extrapolated, uncertainty from the meshes and from the far boundary."""
    inner, *_ = tables.blocks("Meshes and convergence").values()
    assert inner == [
        ("approach, um", "4.4000, 5.0600, 5.5000", "3.6", "3.30%", "5.2250", "1.10%", "0.30%"),
        ("semi-axis a, mm", "0.12600, 0.12120, 0.11950", "2.7", "5.85%", "0.12000", "1.95%", "0.55%"),
        ("semi-axis b, mm", "0.79200, 0.86240, 0.89000", "1.4", "5.10%", "0.88000", "1.70%", "0.60%"),
        ("peak pressure, GPa", "1.8700, 1.7340, 1.6900", "4.2", "3.60%", "1.7000", "1.20%", "0.70%"),
        ("stiffness, GN/m^1.5", "32.500, 27.500, 25.000", "none", "none", "", "1.40%", "0.20%"),
    ]
