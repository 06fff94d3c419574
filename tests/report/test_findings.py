"""The headline of a check: the largest difference from each reference, and the verdict with its reason."""

from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console

from fembearing.check.validation import Validation
from fembearing.cli.status import STATUS
from fembearing.report.report import Report
from fembearing.report.sections.headline import check_headline
from fembearing.report.terminal import print_sections
from tests.report.test_measured import TWO


def printed(document: Report) -> list[str]:
    out = StringIO()
    print_sections(Console(file=out, width=80), [check_headline(document)])
    return out.getvalue().splitlines()


def test_what_measured_torques_miss_stands_before_the_references(document: Report) -> None:
    lines = printed(replace(document, measured=TWO))
    assert lines.index("Missed: one of them.") < next(n for n, line in enumerate(lines) if line.startswith("contacts:"))


def test_without_friction_there_is_no_torque(document: Report) -> None:
    lines = printed(replace(document, solved=None, torque=None, torque_change=None))
    assert "No torque:" in " ".join(lines)


def test_the_command_prints_tables_with_details_alone(
    command, checked: Validation, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fembearing.report.folder.validate", lambda *_, **__: checked)
    short, whole = (command("validate", "6205-dry", *more) for more in ((), ("--details",)))
    assert short.status == whole.status == STATUS[checked.verdict]
    assert whole.out.startswith(short.out)
    assert "Hertz/FE-1" in whole.out
    assert "Hertz/FE-1" not in short.out
