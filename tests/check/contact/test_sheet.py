"""The sheet of a pocket as a spring in series with its seat; half a contact, as its command shows it."""

import json
from types import SimpleNamespace
from typing import Any

import pytest

from fembearing.check.comparison import compared
from fembearing.check.contact import solution
from fembearing.check.contact.solution import ContactSolution, sheet_in_series
from tests.analytic.specimens import present


def pocket(approach: float, uncertainty: float) -> Any:
    """A pocket under 28 N."""
    return SimpleNamespace(load=28.0, quantities={"approach": compared(0.6e-6, approach, uncertainty * approach)})


def test_the_sheet_is_softer_by_what_it_adds_to_the_approach() -> None:
    """Both approaches off by their half-widths, in opposite directions, stay within the uncertainty."""
    exact, seat = 9.7e7, 0.587e-6
    found = present(sheet_in_series(pocket(seat, 1e-3), pocket(seat + 28.0 / exact, 2e-3)))
    assert found.stiffness == pytest.approx(exact, rel=1e-12)
    off = present(sheet_in_series(pocket(seat * 1.001, 0.0), pocket((seat + 28.0 / exact) * 0.998, 0.0)))
    assert abs(off.stiffness / exact - 1) == pytest.approx(found.uncertainty, rel=0.01)  # to first order
    assert sheet_in_series(pocket(seat, 1e-3), pocket(seat * 1.001, 2e-3)) is None


def test_half_a_contact_says_that_no_stress_below_it_is_computed(
    command, cut_contact: ContactSolution, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(solution, "solve_contact", lambda *_, **__: cut_contact)
    told, printed = (command("contact", *form) for form in (["--json"], []))
    found = json.loads(told.out)
    assert found["subsurface"] is None
    said = [line for line in found["warnings"] if "no stress below the contact" in line]
    assert len(said) == 1
    assert printed.err.count(said[0]) == 1
    assert "Greatest stress" not in printed.out
