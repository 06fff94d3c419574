"""The sentences that page and terminal share."""

from dataclasses import replace

import pytest

from analytic.inputs import UNCERTAIN
from analytic.verdicts import NumericalCheck
from fembearing.report.phrases import input_name, numerical_words, percent, place_of
from tests.analytic.specimens import present


def test_an_uncertainty_has_its_number_or_the_reason_why_it_is_not_known() -> None:
    lost = NumericalCheck(verdict="not reached", uncertainty=None, tolerance=0.04, reason="the cage came apart")
    unknown = numerical_words(lost)
    assert "not known: the cage came apart" in unknown
    assert "%" not in unknown
    solved = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.04, reason="")
    for check, side in ((solved, "within"), (replace(solved, verdict="not reached", uncertainty=0.067), "beyond")):
        words = numerical_words(check)
        assert f"{100 * present(check.uncertainty):g} %, {side} the tolerance 4 %" in words
        assert "not known" not in words


@pytest.mark.parametrize(
    ("pair", "geometry", "words"),
    [
        ("pocket", "wall", "ball in cage pocket, sheet on its rim"),
        ("pocket", "real", "ball in cage pocket, thick seat"),
        ("outer", "hertzian", "ball on outer race, idealised"),
        ("inner", "real", "ball on inner race"),
    ],
)
def test_a_contact_is_named_by_its_race_or_its_seat(pair: str, geometry: str, words: str) -> None:
    assert place_of(pair, geometry) == words


def test_every_uncertain_input_has_a_name() -> None:
    names = [input_name(key) for key in UNCERTAIN]
    assert all(names)
    assert not any("." in name for name in names)


@pytest.mark.parametrize(("value", "words"), [(0.01234, "1.2 %"), (None, "unknown"), (float("inf"), "unknown")])
def test_a_share_that_is_not_known_has_no_number(value: float | None, words: str) -> None:
    assert percent(value) == words
