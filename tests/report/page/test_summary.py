"""The two pages that are signed: bounded for any scene, every number with what it belongs to, and who signs."""

import math
import re
from html import unescape
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.page import write as page
from fembearing.report.page.running_header import css_string
from fembearing.report.page.write import page_of
from fembearing.report.report import report_in, report_of
from fembearing.report.tables.points import shown_places
from tests.analytic.specimens import present
from tests.report.page.test_page_numbers import Tables

SUMMARY, ALL = "Friction torque by effect, N mm", "Friction torque of 6205"
Document = dict[str, Any]


@pytest.fixture
def document(made: Validation) -> Document:
    return plain(report_of(made))


@pytest.fixture(autouse=True)
def without_plots(monkeypatch: pytest.MonkeyPatch) -> None:
    """They take seconds, and are tested by themselves."""
    monkeypatch.setattr(page, "PLOTS", ())


def with_points(document: Document, count: int) -> Document:
    """As many operating points, each with a total of its own; the largest and the smallest are in the middle."""
    torque, change = document["torque"], document["torque_change"]
    first = torque["points"][0]
    torque["points"] = [
        first
        | {"inner_speed": (101 + 7 * number) * math.pi / 30, "axial_load": 500.0 + 13 * number}
        | {"torque": first["torque"] | {"total": 0.0351 + 0.0002 * number}}
        for number in range(count)
    ]
    torque["points"][count // 3]["torque"]["total"] = 0.0912
    torque["points"][count // 2]["torque"]["total"] = 0.0123
    torque["catalogue_band"] |= {"low": None, "high": None, "values": {}}
    torque["interval"] = [None] * count
    for check in [*torque["verdicts"]["physical"], *document["physical"]]:
        check["point"] = min(check["point"], count - 1)
    for lists in (change["contact_angle"], change["torque"], change["change"], change["finite_geometry"] or {}):
        for name, values in lists.items():
            lists[name] = values and [values[0]] * count
    return document


def written(document: Document, folder: Path) -> str:
    return page_of(report_in(document), folder)


def summary_of(text: str) -> str:
    """What stands before the appendices."""
    return text.partition('<section class="appendix"')[0]


@pytest.mark.parametrize(("count", "shown"), [(1, 1), (12, 12), (13, 12), (40, 12)])
def test_at_most_twelve_points_are_in_the_summary_and_all_in_the_appendix(
    document: Document, tmp_path: Path, count: int, shown: int
) -> None:
    tables = Tables(written(with_points(document, count), tmp_path))
    (heading,) = (each for each in tables.rows if each.startswith(ALL))
    few, every = tables.rows[SUMMARY][1:], tables.rows[heading][1:]
    assert (len(few), len(every)) == (shown, count)
    numbers = [int(row[0]) for row in few]
    assert numbers == sorted(set(numbers))
    assert {1, count, count // 3 + 1, count // 2 + 1} <= set(numbers)  # ends, largest and smallest
    assert all(any(row[:3] == other[:3] for other in every) for row in few)
    assert (f"{shown} of {count} operating points" in " ".join(tables.text.split())) == (count > shown)


@pytest.mark.parametrize("count", [13, 14, 25, 1000])
def test_the_points_of_the_summary_are_spread_over_the_series(document: Document, count: int) -> None:
    chosen = shown_places(present(report_in(with_points(document, count)).torque))
    assert len(chosen) == 12
    gaps = [after - before for before, after in pairwise(chosen)]
    assert max(gaps) <= 2 + count / 7  # eight of twelve are spread evenly, whatever the largest and the smallest are


def test_every_total_of_the_page_is_that_of_the_numbers(document: Document, tmp_path: Path) -> None:
    """In N mm to the printed digits, in the row of its load and speed, wherever it stands."""
    many = with_points(document, 20)
    text = written(many, tmp_path)
    tables = Tables(text)
    for heading in (SUMMARY, ALL):
        place = tables.rows[heading][0].index("total")
        for row in tables.rows[heading][1:]:
            point = many["torque"]["points"][int(row[0]) - 1]
            assert row[2] == f"{point['axial_load']:.5g}"
            assert float(row[1]) == pytest.approx(point["inner_speed"] * 30 / math.pi, rel=1e-4)  # five digits
            assert float(row[place]) == pytest.approx(1e3 * point["torque"]["total"], rel=5e-4)  # four digits
    headline = " ".join(unescape(summary_of(text)).split())
    assert "Largest friction torque</span> <strong>91.20 N mm</strong> <span>point 7: 578 N axial, 143 rpm" in headline
    assert "Smallest</span> <strong>12.30 N mm</strong> <span>point 11: 630 N axial, 171 rpm" in headline


def test_who_signs_is_shown_as_text(document: Document, tmp_path: Path) -> None:
    people = {"author": "<img src=x onerror=alert(1)>", "checker": "B & <b>Chen</b>", "revision": '"C"', "date": "a<b"}
    document["report"] |= people
    text = written(document, tmp_path)
    tables = Tables(text)
    assert [row[:2] for row in tables.rows["Sign-off"][1:]] == [
        ("Author", people["author"]),
        ("Checker", people["checker"]),
    ]
    assert tables.rows["Sign-off"][0] == ("role", "name", "signature", "date")
    for raw in ("<img src=x", "<b>Chen", "a<b"):
        assert raw not in text
    assert document["provenance"]["scene_sha256"] in summary_of(text)


def test_a_name_cannot_leave_the_style_sheet(document: Document, tmp_path: Path) -> None:
    """The running header is a text of CSS: neither quotes nor tags nor line ends get through."""
    name = 'a"; } </style><script>alert(1)</script> \\'
    document["provenance"]["scene"] = name
    text = written(document, tmp_path)
    header = re.search(r'@top-left \{ content: "([^"]*)"; \}', text)
    assert header is not None
    assert re.sub(r"\\([0-9a-f]+) ", lambda match: chr(int(match[1], 16)), header[1]) == name
    assert "<script" not in text
    assert text.count("</style>") == 1
    assert css_string("\n") == r'"\a "'


@pytest.mark.parametrize(
    ("kind", "word", "overall"), [("numerical", "not reached", "undecided"), ("physical", "fail", "fail")]
)
def test_green_is_the_box_of_all_verdicts_only_where_all_hold(
    document: Document, tmp_path: Path, kind: str, word: str, overall: str
) -> None:
    for contact in document["contacts"][:3]:
        for each in (contact, *contact["quantities"].values()):
            each["verdict"] = "pass"
    words = {"comparison": "pass", "numerical": "pass", "physical": "pass", "overall": "pass"}
    document["verdict"] = words | {"reason": "nothing speaks against it"}
    text = written(document, tmp_path)
    assert 'class="overall pass"' in text
    assert "nothing speaks against it" in summary_of(text)
    document["verdict"] |= {kind: word, "overall": overall}
    text = written(document, tmp_path)
    assert f'class="overall {overall}"' in text
    box = re.search(rf'{kind.capitalize()}</span> <strong class="(\w+)">{word}</strong>', text)
    assert box is not None
    assert box[1] == word.split()[0]


def test_long_words_of_a_scene_do_not_lengthen_the_summary(document: Document, tmp_path: Path) -> None:
    document["warnings"] = [f"{number} {'word ' * 400}" for number in range(50)]
    others = len({check["note"] for check in document["physical"] if check["verdict"] != "pass"})
    others += len(document["torque"]["notes"])
    text = written(document, tmp_path)
    assert f"{50 + others - 5} more: appendix" in summary_of(text)
    assert len(re.findall("word", summary_of(text))) < 5 * 70
    assert len(re.findall("word", text)) > 50 * 400  # the appendix has all


def test_every_table_says_what_its_rows_and_columns_are(document: Document, tmp_path: Path) -> None:
    text = written(document, tmp_path)
    assert '<html lang="en">' in text
    assert not re.findall(r"<th(?![^>]*scope=)[ >]", text)  # thead is another tag
    assert all(re.findall(r"<th|<thead", table) for table in re.findall(r"<table.*?</table>", text, re.DOTALL))
    assert not re.findall(r"<img(?![^>]*alt=)", text)
