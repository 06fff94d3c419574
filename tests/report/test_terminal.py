"""What a check prints: complete at 80 columns, and no silence where something is missing."""

import io
from dataclasses import replace

import pytest
from rich.console import Console

from fembearing.compare.validation import Validation
from fembearing.report.terminal import print_validation

NARROW = 80  # columns, of a pipe


def printed(result: Validation) -> str:
    target = io.StringIO()
    print_validation(Console(file=target, width=NARROW), result)
    return target.getvalue()


def test_every_word_of_the_table_fits(checked: Validation) -> None:
    """The widest verdict beside the widest numbers."""
    inner = checked.contacts[0]
    parts = {name: replace(part, mesh=12.3456, order=None) for name, part in inner.estimates.items()}
    wide = replace(checked, contacts=(replace(inner, estimates=parts), *checked.contacts[1:]))
    rows = [line for line in printed(wide).splitlines() if " none " in line][: len(parts)]  # the inner race comes first
    assert len(rows) == len(parts)
    assert all(row.rstrip().endswith("undecided") for row in rows)
    assert max(map(len, printed(wide).splitlines())) <= NARROW
    assert "\N{HORIZONTAL ELLIPSIS}" not in printed(wide)


def test_a_scene_without_friction_is_told_that_there_is_no_torque(checked: Validation) -> None:
    assert "no friction coefficient, so there is no torque" in printed(replace(checked, torque=None))
    assert "Race torque" not in printed(replace(checked, torque=None))
    assert "no friction coefficient" not in printed(checked)


@pytest.mark.parametrize("verdict", ["pass", "outside validity"])
def test_the_last_line_is_the_verdict(checked: Validation, verdict: str) -> None:
    inner = replace(checked.contacts[0], valid=verdict == "pass")
    result = replace(checked, contacts=(inner, *checked.contacts[1:]))
    assert printed(result).splitlines()[-1].startswith(f"{verdict}: tolerance 0.9")
