"""The numbers of the page: every one of report.json, and some in their rows and columns, of a result made by hand."""

import re
from collections.abc import Iterator
from dataclasses import is_dataclass, replace
from typing import Any

import numpy as np
import pytest

from analytic.prediction.prediction import predict
from fembearing.check.validation import Validation
from fembearing.plain_types import written_fields
from fembearing.report.folder import report_page
from fembearing.report.report import Report, report_of
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page
from tests.report.page.tables_of_page import Tables
from tests.report.specimens import FILM
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
        return 2.7 * node if isinstance(node, float) else max(node - 1, 0)
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
    page = report_page(whole)
    kinds: dict[str, Way] = {}
    for way in ways(whole):
        kinds.setdefault(".".join(name for name in way if isinstance(name, str)), way)
    printed = {kind: way for kind, way in kinds.items() if not any(re.fullmatch(each, kind) for each in UNPRINTED)}
    assert len(printed) > 150
    for kind in [*printed][part::4]:
        is_there = report_page(changed(whole, printed[kind])) != page
        assert is_there, kind


@pytest.fixture(scope="module")
def tables(made: Validation) -> Tables:
    return Tables(written_page(made))


def test_no_verdict_wears_the_colour_of_another(tables: Tables) -> None:
    colours = {"pass": "pass", "fail": "fail", "undecided": "undecided", "outside validity": "outside"}
    for verdict, colour in colours.items():
        assert {style for style, text in tables.styled if text == verdict} == {colour}


def test_each_row_has_a_cell_for_each_head(tables: Tables) -> None:
    """A row of one cell is a heading between rows."""
    assert len(tables.rows) > 15
    for heading, (head, *rows) in tables.rows.items():
        assert {len(row) for row in rows} <= {1, len(head)}, heading
