"""Texts of eight scenes as they were read once by eye: terminal and page. `--renew` writes them again.

    python -m pytest tests/report/test_golden.py --renew

Words must be the same; a number may differ by one in its last digit, which depends on the processor.
"""

import re
from collections.abc import Sequence
from dataclasses import replace
from html.parser import HTMLParser
from io import StringIO
from itertools import zip_longest
from pathlib import Path

import pytest
from rich.console import Console

from analytic.scene_torque import SceneTorque
from analytic.units import INCH_POUND
from fembearing.check.contact.load_series import PocketLaw
from fembearing.check.validation import Validation
from fembearing.report.document import Section
from fembearing.report.folder import report_page
from fembearing.report.report import report_of
from fembearing.report.sections.cage import motion_table, regime_table
from fembearing.report.sections.contacts import series_sections, subsurface_table
from fembearing.report.sections.cost import cost_table
from fembearing.report.sections.creep import creep_table
from fembearing.report.sections.duty import duty_section
from fembearing.report.sections.film import film_table
from fembearing.report.sections.headline import check_headline, headline_section
from fembearing.report.sections.measured import measured_sections
from fembearing.report.sections.torque import torque_sections
from fembearing.report.sections.validation import detail_sections
from fembearing.report.terminal import print_sections
from fembearing.report.torque_file import torque_content
from tests.report.specimens import (
    ABSENT,
    CONTACT,
    CREEP,
    FILM,
    LAW,
    SCENES,
    STRESS,
    TWO,
    cycle,
    moved,
    series,
    step,
    torque_of,
)

GOLDEN = Path(__file__).parent / "golden"
CAGES = {3: moved(), 4: moved("grip_share", "grip_number", "race_excess"), 5: moved("start", "interval", "other")}
POCKET = PocketLaw(stiffness=62.7e9, stiffness_uncertainty=0.031, sheet=93.1e6, sheet_uncertainty=None)
MADE = {
    "film": [Section("", [film_table(FILM), film_table(FILM, INCH_POUND)])],
    "creep": [Section("", [creep_table(CREEP)])],
    "cage": [Section("", [motion_table(CAGES), regime_table(CAGES)])],
    "duty": [duty_section(cycle(step(0), step(1, temperature=323.15), step(2, power=0.0)))],
    "measured": measured_sections(TWO),
    "stress": [Section("", [subsurface_table(STRESS)])],
    "loads": series_sections(series(law=LAW, pocket_law=POCKET)),
    "cost": [Section("", [cost_table([CONTACT, ABSENT])])],
}
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?(?!\w)")


@pytest.fixture(scope="module", params=SCENES)
def result(request: pytest.FixtureRequest) -> tuple[str, SceneTorque]:
    return request.param, torque_of(request.param)


def test_the_terminal_says(result: tuple[str, SceneTorque], pytestconfig: pytest.Config) -> None:
    name, torque = result
    compare(f"{name}-terminal", printed([headline_section(torque), *torque_sections(torque)]), pytestconfig)


def test_the_page_says(result: tuple[str, SceneTorque], pytestconfig: pytest.Config) -> None:
    name, torque = result
    compare(f"{name}-page", text_of(torque_content(torque, ending=".html").decode()), pytestconfig)


@pytest.mark.parametrize("name", MADE)
def test_the_terminal_says_of_results_made_by_hand(name: str, pytestconfig: pytest.Config) -> None:
    """Each number of `specimens` is known: these texts were worked out from them by hand."""
    compare(f"{name}-terminal", printed(MADE[name]), pytestconfig)


def test_a_check_says(made: Validation, pytestconfig: pytest.Config) -> None:
    """Of the check made by hand in conftest.py, without the friction that was computed, which varies by processor."""
    document = report_of(replace(made, creep=(), ladders=(CONTACT, ABSENT)))
    compare("check-terminal", printed([check_headline(document), *detail_sections(document)]), pytestconfig)
    compare("check-page", text_of(report_page(document).partition("Provenance</h2>")[0]), pytestconfig)


def printed(sections: Sequence[Section]) -> str:
    text = StringIO()
    print_sections(Console(file=text, width=80), sections)
    return text.getvalue()


class Words(HTMLParser):
    """The text of a page, a line for each cell and paragraph."""

    def __init__(self) -> None:
        super().__init__()
        self.lines: list[str] = []
        self.silent = 0

    def handle_starttag(self, tag: str, attrs: object) -> None:  # noqa: ARG002
        """Leave out what is not read."""
        self.silent += tag in ("style", "script", "svg")

    def handle_endtag(self, tag: str) -> None:
        """The end of what is not read."""
        self.silent -= tag in ("style", "script", "svg")

    def handle_data(self, data: str) -> None:
        """One piece of text."""
        if not self.silent and data.strip():
            self.lines.append(" ".join(data.split()))


def text_of(page: str) -> str:
    words = Words()
    words.feed(page)
    kept = [line for line in words.lines if not re.search(r"SHA-256|^[0-9a-f]{64}$", line)]
    return "\n".join(kept) + "\n"


def compare(name: str, text: str, config: pytest.Config) -> None:
    file = GOLDEN / f"{name}.txt"
    text = re.sub(r"\bin\s+\d+ s;", "in 0 s;", text)  # that the samples took
    if config.getoption("--renew"):
        file.write_text(text, "utf-8")
    for number, (was, now) in enumerate(zip_longest(file.read_text("utf-8").splitlines(), text.splitlines()), start=1):
        assert same(was, now), f"{file.name}:{number}: was {was!r}, is {now!r}"


def same(was: str | None, now: str | None) -> bool:
    """Whether two lines have the same words, and numbers that differ by one in the last digit at most."""
    if was is None or now is None or NUMBER.sub("#", was).split() != NUMBER.sub("#", now).split():
        return was == now
    return all(close(a, b) for a, b in zip(NUMBER.findall(was), NUMBER.findall(now), strict=True))


def close(was: str, now: str) -> bool:
    if was == now:
        return True
    mantissa, _, power = max(was, now, key=len).partition("e")
    last = 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))
    return abs(float(was) - float(now)) <= 1.001 * last
