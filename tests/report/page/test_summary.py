"""The two pages that are signed: bounded for any scene, every number with what it belongs to, and who signs."""

import re
from dataclasses import replace

import numpy as np
import pytest

from analytic.scene import Operation
from analytic.torque import friction_torque
from fembearing.check.validation import Validation
from fembearing.report.folder import report_page
from fembearing.report.page.document import css_string
from fembearing.report.report import Report, report_of
from tests.analytic.specimens import present
from tests.report.page.tables_of_page import Tables

SUMMARY, ALL = "Friction torque by effect, N mm", "Friction torque of 6205"


def with_points(made: Validation, count: int) -> Report:
    """As many operating points, each with a total of its own; the largest and the smallest are in the middle."""
    number = np.arange(count, dtype=float)
    totals = 0.0351 + 0.0002 * number
    totals[count // 3], totals[count // 2] = 0.0912, 0.0123
    operation = Operation(axial_load=500.0 + 13 * number, inner_speed=(101 + 7 * number) * np.pi / 30)
    scene = replace(made.scene, operation=operation)
    solved = friction_torque(scene)
    solved = replace(solved, torque=replace(solved.torque, total=totals))
    torque = replace(present(made.torque), scene=scene, friction=solved)
    change = replace(present(made.torque_change), production=solved, own=solved, corrected=solved, fitted=None)
    return report_of(replace(made, scene=scene, torque=torque, torque_change=change))


def summary_of(text: str) -> str:
    """What stands before the appendices."""
    return text.partition('<section class="appendix"')[0]


@pytest.mark.parametrize(("count", "shown"), [(1, 1), (12, 12), (13, 12), (40, 12)])
def test_at_most_twelve_points_are_in_the_summary_and_all_in_the_appendix(
    made: Validation, count: int, shown: int
) -> None:
    """Every total is that of the numbers, in N mm to the printed digits, in the row of its load and speed."""
    many = with_points(made, count)
    text = report_page(many)
    tables = Tables(text)
    (heading,) = (each for each in tables.rows if each.startswith(ALL))
    assert (len(tables.rows[SUMMARY]) - 1, len(tables.rows[heading]) - 1) == (shown, count)
    numbers = [int(row[0]) for row in tables.rows[SUMMARY][1:]]
    assert numbers == sorted(set(numbers))
    assert {1, count, count // 3 + 1, count // 2 + 1} <= set(numbers)  # ends, largest and smallest
    assert (f"{shown} of {count} operating points" in " ".join(tables.text.split())) == (count > shown)
    for rows in (tables.rows[SUMMARY], tables.rows[heading]):
        place = rows[0].index("total")
        for row in rows[1:]:
            point = present(many.solved).points[int(row[0]) - 1]
            assert row[2] == f"{point['axial_load']:.5g}"
            assert float(row[1]) == pytest.approx(30 / np.pi * point["inner_speed"], rel=1e-4)  # five digits
            assert float(row[place]) == pytest.approx(1e3 * point["torque_total"], rel=5e-4)  # four digits


def test_who_signs_is_shown_as_text(document: Report) -> None:
    people = {"author": "<img src=x onerror=alert(1)>", "checker": "B & <b>Chen</b>", "revision": '"C"', "date": "a<b"}
    text = report_page(replace(document, report=replace(document.report, **people)))
    tables = Tables(text)
    assert [row[:2] for row in tables.rows["Sign-off"][1:]] == [
        ("Author", people["author"]),
        ("Checker", people["checker"]),
    ]
    for raw in ("<img src=x", "<b>Chen", "a<b"):
        assert raw not in text
    assert document.provenance.scene_sha256 in summary_of(text)


def test_a_name_cannot_leave_the_style_sheet(document: Report) -> None:
    """The running header is a text of CSS: neither quotes nor tags nor line ends get through."""
    name = 'a"; } </style><script>alert(1)</script> \\'
    text = report_page(replace(document, provenance=replace(document.provenance, scene=name)))
    header = re.search(r'@top-left \{ content: "([^"]*)"; \}', text)
    assert header is not None
    assert re.sub(r"\\([0-9a-f]+) ", lambda match: chr(int(match[1], 16)), header[1]) == name
    assert "<script" not in text
    assert text.count("</style>") == 1
    assert css_string("\n") == r'"\a "'


def test_long_words_of_a_scene_do_not_lengthen_the_summary(document: Report) -> None:
    others = len({check.note for check in document.physical if check.verdict != "pass"})
    others += len(present(document.solved).notes)
    text = report_page(replace(document, warnings=tuple(f"{number} {'word ' * 400}" for number in range(50))))
    assert f"{50 + others - 5} more: appendix" in summary_of(text)
    assert len(re.findall("word", summary_of(text))) < 5 * 70
    assert len(re.findall("word", text)) > 50 * 400  # the appendix has all


def test_every_table_says_what_its_rows_and_columns_are(document: Report) -> None:
    text = report_page(document)
    assert '<html lang="en">' in text
    assert not re.findall(r"<th(?![^>]*scope=)[ >]", text)  # thead is another tag
    assert all(re.findall(r"<th|<thead", table) for table in re.findall(r"<table.*?</table>", text, re.DOTALL))
    assert not re.findall(r"<img(?![^>]*alt=)", text)
