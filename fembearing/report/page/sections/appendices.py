"""The appendices of a report, in their order: which there are, and their letters."""

from collections.abc import Callable
from string import ascii_uppercase
from typing import NamedTuple

from fembearing.report.page.sections.ring import ring_tables
from fembearing.report.report import Report


class Appendix(NamedTuple):
    """One appendix."""

    letter: str
    title: str
    section: str  # the name of its template, and of its plots


class Part(NamedTuple):
    """What may become an appendix."""

    section: str
    title: str
    is_there: Callable[[Report], bool] = lambda _: True


PARTS = (
    Part("inputs", "Inputs and effects"),
    Part("torque", "Torque at every operating point", lambda document: document.torque is not None),
    Part("measured", "Measured torques", lambda document: document.measured is not None),
    Part("contacts", "Contacts"),
    Part("pictures", "Contact pressure"),
    Part("film", "Film and rolling", lambda document: bool(document.films)),
    Part("creep", "Spin, conformity and creep", lambda document: bool(document.creep)),
    Part("meshes", "Meshes and convergence"),
    Part("ring", "Ring and balls", lambda document: bool(ring_tables(document))),
    Part("cage", "Cage", lambda document: document.scene.cage is not None),
    Part("sensitivity", "Sensitivity to inputs", lambda document: document.sensitivity is not None),
    Part("cost", "Cost of accuracy"),
    Part("next", "Warnings and next steps"),
    Part("provenance", "Provenance"),
)


def appendices_of(document: Report) -> list[Appendix]:
    """Those that a report has."""
    there = [part for part in PARTS if part.is_there(document)]
    return [Appendix(letter, part.title, part.section) for letter, part in zip(ascii_uppercase, there, strict=False)]


def letters_of(appendices: list[Appendix]) -> dict[str, str]:
    """The letter of each appendix, for references to it."""
    return {each.section: each.letter for each in appendices}
