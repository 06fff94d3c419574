"""One verdict of several: which of them decides, and what is said of it."""

from typing import Any

import pytest

from analytic.verdicts import NumericalCheck, PhysicalCheck, Verdicts


def physical(verdict: Any, name: Any = "peak_pressure", where: Any = "inner race") -> PhysicalCheck:
    return PhysicalCheck(name=name, where=where, point=0, value=1.7e9, limit=4.2e9, unit="Pa", verdict=verdict, note="")


SOLVED = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.05)
LOOSE = NumericalCheck(verdict="not reached", uncertainty=0.083, tolerance=0.05)
GOOD, BAD = physical("pass"), physical("fail", "sliding", "outer race")
OPEN = physical("unknown", "cage_force", "cage")


def test_the_most_serious_physical_verdict_counts_wherever_it_stands() -> None:
    for checks, worst in (
        ((GOOD, GOOD), "pass"),
        ((GOOD, OPEN), "unknown"),
        ((OPEN, BAD, GOOD), "fail"),
        ((BAD, GOOD, OPEN), "fail"),
    ):
        assert Verdicts(numerical=SOLVED, physical=checks).worst_physical == worst


@pytest.mark.parametrize(
    ("comparison", "numerical", "checks", "overall", "reason"),
    [
        (None, SOLVED, (GOOD,), "pass", "solver error within the tolerance, no physical limit exceeded"),
        ("pass", None, (GOOD,), "pass", "contacts within the tolerance, no physical limit exceeded"),
        ("pass", SOLVED, (GOOD,), "pass", "contacts and solver error within the tolerance, no physical limit exceeded"),
        ("fail", LOOSE, (GOOD, OPEN), "fail", "Hertz differs from finite elements by more than the tolerance"),
        ("outside validity", SOLVED, (GOOD,), "fail", "a contact is outside the validity of Hertz"),
        ("undecided", SOLVED, (GOOD,), "undecided", "a contact is undecided by finite elements"),
        (None, LOOSE, (GOOD,), "undecided", "the solver error is 8.3 %, tolerance 5 %"),
        (None, SOLVED, (OPEN, GOOD), "undecided", "a physical limit is not known: cage force (cage)"),
        (
            "fail",
            LOOSE,
            (GOOD, BAD, OPEN, BAD),  # what is said twice stands once
            "fail",
            "Hertz differs from finite elements by more than the tolerance; "
            "the rolling force of the oil exceeds the driving friction (outer race)",
        ),
        (
            "undecided",
            LOOSE,
            (GOOD, OPEN),
            "undecided",
            "a contact is undecided by finite elements; the solver error is 8.3 %, tolerance 5 %; "
            "a physical limit is not known: cage force (cage)",
        ),
    ],
)
def test_the_reason_names_what_decides_and_nothing_else(
    comparison: Any, numerical: NumericalCheck | None, checks: tuple[PhysicalCheck, ...], overall: str, reason: str
) -> None:
    found = Verdicts(numerical=numerical, physical=checks, comparison=comparison)
    assert found.overall == overall
    assert found.reason == reason
    assert found.summary.overall == overall


def test_the_summary_leaves_out_what_was_not_judged() -> None:
    both = Verdicts(numerical=LOOSE, physical=(GOOD,), comparison="pass").summary
    assert both.words == "undecided: comparison pass, numerical not reached, physical pass"
    assert Verdicts(numerical=None, physical=(BAD,)).summary.words == "fail: physical fail"
    assert Verdicts(numerical=SOLVED, physical=(OPEN,)).summary.words == "undecided: numerical pass, physical unknown"
