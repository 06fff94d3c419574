"""A report whose parts do not belong together is refused, in words that say which."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import pytest

from fembearing.report import report as module
from fembearing.report.report import PictureFile, Report
from tests.analytic.specimens import present
from tests.report.torque_rows import lost

PICTURE = PictureFile(file="inner-pressure.png", kind="pressure", pair="inner", geometry="real", caption="a picture")


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda _: {"pictures": (replace(PICTURE, geometry="wall"),)}, "no contact for the picture inner-pressure.png"),
        (
            lambda d: {"verdict": replace(d.verdict, comparison=None)},
            "verdict on the comparison than the worst on a contact",
        ),
        (lambda _: {"torque": None}, "torque without torque_change, or the other way round"),
        (lambda _: {"torque_change": None}, "torque without torque_change, or the other way round"),
        (lambda d: {"physical": (replace(d.physical[0], point=3),)}, "a physical verdict on a point beyond the 3"),
        (lambda _: {"film_change": (0.1, 0.2)}, "a film_change of other than the 3"),
        (lambda _: {"cage_motion": ()}, "a cage_motion of other than the 3"),
        (
            lambda d: {"torque_change": replace(d.torque_change, change=replace(d.torque_change.change, total=(0.1,)))},
            "a torque_change of other than the 3",
        ),
        (lambda d: {"torque": replace(d.torque, left_out=(lost(0),))}, "a torque with points left out"),
        (
            lambda d: {"torque": replace(d.torque, verdicts=replace(d.torque.verdicts, numerical=None))},
            "a torque with points left out",
        ),
    ],
)
def test_parts_of_another_check_are_refused(
    document: Report, change: Callable[[Any], dict[str, Any]], words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        replace(document, **change(document))


def test_parts_of_this_check_are_taken(document: Report) -> None:
    last = replace(document.physical[0], point=2)
    found = replace(
        document, pictures=(PICTURE,), film_change=(0.1, 0.2, 0.3), physical=(last,), torque=document.torque
    )
    assert present(found.contact_of(PICTURE)).pair == "inner"
    replace(document, torque=None, torque_change=None, film_change=None, physical=(replace(last, point=7),))


@pytest.mark.parametrize("name", ["../a.png", "a/b.png", ".hidden.png", "a b.png", ""])
def test_a_picture_has_a_plain_name(name: str) -> None:
    with pytest.raises(ValueError, match="is no plain name"):
        replace(PICTURE, file=name)


def test_a_dollar_sign_is_in_no_name_of_a_figure(document: Report) -> None:
    ladder = document.cost.ladders[0]
    for changed in (
        replace(ladder, quantity="a $ sign"),
        replace(ladder, methods=(replace(ladder.methods[0], name="a $ sign"), *ladder.methods[1:])),
    ):
        with pytest.raises(ValueError, match="in which a formula begins"):
            replace(document, cost=replace(document.cost, ladders=(changed,)))


def test_numbers_beyond_the_usual_are_refused_wherever_they_stand() -> None:
    module._require_usual_numbers({"a": [1.0, {"b": -module.LARGEST}]})
    with pytest.raises(ValueError, match=r"^a\.1\.b .* is larger than"):
        module._require_usual_numbers({"a": [1.0, {"b": -2 * module.LARGEST}]})


def test_a_long_value_is_shown_by_its_ends() -> None:
    text = "x" * (module.SHOWN - 2)
    assert module._shortened(text) == repr(text)
    longer = module._shortened("a" + text + "z")
    assert len(longer) <= module.SHOWN + 3
    assert longer.startswith("'a")
    assert longer.endswith("z'")


def test_a_damaged_report_names_its_writer_where_it_is_another(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(module, "_ours", lambda: "3.1")
    for versions, words in (
        ({"fembearing": "2.9"}, "was changed or was written by fembearing 2.9, this is 3.1: run"),
        ({"fembearing": "3.1"}, "it was changed: run"),
        ({"fembearing": 7}, "it was changed: run"),
        ([], "it was changed: run"),
    ):
        assert words in module._remedy({"provenance": {"versions": versions}})
    assert "it was changed: run" in module._remedy({"provenance": None})
