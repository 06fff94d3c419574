"""The two pages that are signed: bounded for any scene, every number with what it belongs to, and who signs."""

import math
import re
from html import unescape
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest

from fembearing.plain_types import plain
from fembearing.report.page import write as page
from fembearing.report.page.running_header import css_string
from fembearing.report.page.write import page_of
from fembearing.report.report import report_in, report_of
from fembearing.report.tables.points import shown_places
from fembearing.verify.validation import Validation
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


def test_the_interval_and_the_standing_of_the_torque_come_before_the_check(document: Document, tmp_path: Path) -> None:
    """To first order, by samples where there are any, or not known; the torque is named before anything passes."""
    count = len(document["torque"]["points"])
    document["torque"]["interval"] = [[0.0107, 0.0943]] * count
    document["torque"]["standing"] = {"word": "check", "reason": "far below all makers"}
    text = " ".join(unescape(summary_of(written(document, tmp_path))).split())
    assert "95 % interval 10.7-94.3 N mm; " in text
    assert text.index("<strong>check</strong> far below all makers") < text.index("References and limits")
    document["torque"]["interval"] = [None] * count
    assert "95 % interval not known; " in summary_of(written(document, tmp_path))
    points = document["torque"]["points"]
    document["torque"]["prediction"] = predicted(points, low=0.8, high=1.57)
    largest = max(point["torque"]["total"] for point in points)
    assert f"-{1.57e3 * largest:.3g} N mm; " in summary_of(written(document, tmp_path))


def predicted(points: list[dict[str, Any]], *, low: float, high: float) -> dict[str, Any]:
    """An interval of these shares of each total; all else is empty."""
    loads = ("inner_speed", "axial_load", "radial_load", "moment")
    return {
        "covered": 0.95,
        "points": [
            {name: point[name] for name in loads}
            | {
                "nominal": (total := point["torque"]["total"]),
                "total": {
                    "low": low * total,
                    "median": total,
                    "high": high * total,
                    "low_error": 0.0,
                    "high_error": 0.0,
                },
                "parts": {},
                "made_of": {},
                "indices": {"first": [0.4], "total": [0.5], "first_error": [0.1], "total_error": [0.2]},
                "explained": 0.9,
            }
            for point in points
        ],
        "inputs": [
            {"key": "friction.coefficient", "value": 0.1, "unit": "", "deviation": 0.02, "source": "judgement"}
            | {"floor": 0.0, "kind": "input"}
        ],
        "not_varied": ["all else"],
        "samples": 512,
        "failed": 0,
        "reasons": [],
        "seed": 3,
        "seconds": 7.0,
        "evaluation_seconds": 6.0,
    }


def test_the_contacts_stand_with_ball_load_point_and_verdict(made: Validation, tmp_path: Path) -> None:
    tables = Tables(written(plain(report_of(made)), tmp_path))
    inner, outer, pocket = tables.rows["Contacts: Hertz against finite elements"][1:]
    assert inner[:2] == ("inner race", "371.5")
    assert inner[3:5] == ("1.785", "1.700")
    assert inner[5:] == ("+2.00 ± 1.14", "-2.00 ± 2.03", "+10.00 ± 1.80", "+5.00 ± 1.39", "-3.00 ± 1.41", "fail")
    assert outer[-1] == "outside validity"
    assert pocket[:3] == ("cage pocket", "28.50", "-")
    assert "the heaviest ball, at point 3: 910 N axial, 600 rpm" in " ".join(tables.text.split())


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
    for row in document["verdicts"]:
        row["verdict"] = "pass"
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


def test_each_physical_limit_stands_with_number_place_and_point(document: Document, tmp_path: Path) -> None:
    document["physical"] = [
        {"name": "peak_pressure", "where": "inner race", "point": 1, "value": 4.71e9, "limit": 4.2e9, "unit": "Pa"}
        | {"verdict": "fail", "note": "It yields."},
        {"name": "shoulder", "where": "outer race", "point": 2, "value": None, "limit": 0.1, "unit": "1"}
        | {"verdict": "unknown", "note": "The shoulder is not known."},
    ]
    text = written(document, tmp_path)
    first, second = Tables(text).rows["Physical limits"][1:]
    assert first == ("peak pressure", "inner race", "2", "4.71 GPa", "4.2 GPa", "fail")
    assert second == ("load cut off", "outer race", "3", "unknown", "10 %", "unknown")
    assert "It yields." in summary_of(text)
    assert "The shoulder is not known." in summary_of(text)


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


def test_the_page_says_why_the_ball_loads_of_contacts_and_torque_differ(document: Document, tmp_path: Path) -> None:
    """Where the torque's contacts have the fit for finite geometry; those that are compared are Hertz's as they are."""
    why = "The torque includes the fit for finite geometry"
    assert document["torque_change"]["finite_geometry"] is not None  # beside the torque, and not in its contacts
    assert why not in unescape(written(document, tmp_path))
    document["torque_change"]["finite_geometry"] = None
    assert why in unescape(summary_of(written(document, tmp_path)))


def test_a_page_in_inches_says_that_its_notes_are_metric(document: Document, tmp_path: Path) -> None:
    document["torque"]["notes"] = ["The combined roughness is 0.1 um."]
    said = "Notes and warnings are in metric units"
    assert said not in summary_of(written(document, tmp_path))
    document["report"]["units"] = "inch"
    assert said in summary_of(written(document, tmp_path))
