"""One verdict of several: which of them decides."""

from typing import Any

import pytest

from analytic.verdicts import NumericalCheck, PhysicalCheck, Verdicts


def physical(verdict: Any, name: Any = "peak_pressure", where: Any = "inner race") -> PhysicalCheck:
    return PhysicalCheck(name=name, where=where, point=0, value=1.7e9, limit=4.2e9, unit="Pa", verdict=verdict, note="")


SOLVED = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.05)
LOOSE = NumericalCheck(verdict="not reached", uncertainty=0.083, tolerance=0.05)
GOOD, BAD = physical("pass"), physical("fail", "sliding", "outer race")
OPEN = physical("unknown", "cage_force", "cage")


@pytest.mark.parametrize(
    ("compared", "numerical", "checks", "overall", "causes"),
    [
        ({}, SOLVED, (GOOD,), "pass", 1),
        ({"contacts": "pass", "film": "pass"}, None, (GOOD, GOOD), "pass", 1),
        ({"contacts": "outside validity"}, SOLVED, (GOOD,), "fail", 1),
        ({"contacts": "undecided"}, SOLVED, (GOOD,), "undecided", 1),
        ({"contacts": "pass", "film": "undecided"}, SOLVED, (GOOD,), "undecided", 1),
        ({"contacts": "undecided", "film": "pass", "friction": "fail"}, SOLVED, (GOOD,), "fail", 1),
        ({}, LOOSE, (GOOD,), "undecided", 1),
        ({}, SOLVED, (OPEN, GOOD), "undecided", 1),
        ({"contacts": "fail"}, LOOSE, (GOOD, BAD, OPEN, BAD), "fail", 2),  # the failures alone, each once
        ({"contacts": "undecided", "film": "undecided"}, LOOSE, (GOOD, OPEN), "undecided", 4),
    ],
)
def test_the_most_serious_verdict_counts_with_its_causes(
    compared: Any, numerical: NumericalCheck | None, checks: tuple[PhysicalCheck, ...], overall: str, causes: int
) -> None:
    found = Verdicts(numerical=numerical, physical=checks, compared=compared)
    assert found.overall == overall
    assert len(found.reason.split("; ")) == causes
