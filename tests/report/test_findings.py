"""The headline of a check: the largest difference from each reference, and the verdict with its reason."""

from dataclasses import replace
from io import StringIO

import pytest
from rich.console import Console

from fembearing.check.validation import Validation
from fembearing.cli.status import STATUS
from fembearing.report.findings import Finding
from fembearing.report.report import Report
from fembearing.report.sections.headline import check_headline
from fembearing.report.terminal import print_sections
from tests.analytic.specimens import present
from tests.report.test_measured import TWO

LONGEST = 24  # lines: a screen of a terminal


def printed(document: Report) -> list[str]:
    out = StringIO()
    print_sections(Console(file=out, width=80), [check_headline(document)])
    return out.getvalue().splitlines()


@pytest.fixture(scope="module")
def found(document: Report) -> dict[str, Finding]:
    return {finding.reference: finding for finding in document.findings}


def test_the_largest_difference_of_all_judged_contacts_is_found(found: dict[str, Finding]) -> None:
    """The sheet, 80 % off, is not judged; that verdict fails which is the worst of all."""
    finding = found["contacts"]
    assert (finding.quantity, finding.place) == ("semi-axis b", "inner race")
    assert finding.difference == pytest.approx(0.1, abs=1e-12)  # 0.968/0.88 - 1, to round-off
    assert finding.uncertainty == pytest.approx(0.018, abs=5e-5)  # printed as 1.80 %
    assert finding.verdict == "fail"
    assert finding.words == "contacts: Hertz +10 % off in semi-axis b, inner race; solver error 1.8 %: fail"


def test_the_sheet_and_the_torque_are_shown_and_not_judged(found: dict[str, Finding]) -> None:
    """As in the table of the pocket and in that of the change, at the point with the heaviest ball."""
    assert found["pocket"].words == "sheet of the pocket: -35 % of the stiffness K_pb; solver error 0.57 %"
    assert found["torque"].words == "finite elements change the torque by -2.83 %, point 3; solver error 1.4 %"
    assert {found[name].verdict for name in ("pocket", "torque")} == {"shown"}


def test_the_headline_is_short_and_ends_with_the_reason(document: Report) -> None:
    lines = printed(document)
    assert len(lines) <= LONGEST
    assert max(map(len, lines)) <= 80
    torque = present(document.torque)
    assert lines[0].startswith("6205, friction coefficient 0.1")
    said = " ".join(" ".join(lines).split())  # a line is broken at a space, which may stay
    assert said.endswith("references fail: Hertz differs from finite elements by more than the tolerance")
    assert f"{torque.standing.word}: {torque.standing.reason}" in said


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
