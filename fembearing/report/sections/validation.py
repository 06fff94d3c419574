"""The check of a scene as a document: the pages that are signed, and the appendices."""

import shlex
from collections.abc import Callable, Mapping, Sequence

from fembearing.report.document import Block, Drawing, Facts, Section
from fembearing.report.report import Report
from fembearing.report.sections.cage import cage_section
from fembearing.report.sections.contacts import contacts_section
from fembearing.report.sections.cost import cost_section
from fembearing.report.sections.creep import creep_section
from fembearing.report.sections.film import film_section
from fembearing.report.sections.inputs import inputs_section
from fembearing.report.sections.limits import limits_section
from fembearing.report.sections.measured import measured_section
from fembearing.report.sections.meshes import meshes_section
from fembearing.report.sections.next import next_section
from fembearing.report.sections.ring import ring_section
from fembearing.report.sections.summary import summary_sections
from fembearing.report.sections.torque import torque_section

Drawn = Mapping[str, Sequence[Block]]  # plots and pictures, by the name of their section


def provenance_section(document: Report) -> Section:
    """Where the numbers come from."""
    origin, hard = document.provenance, document.hard
    cases = f"{hard.right} right, {hard.refused} correctly refused, {hard.wrong} wrong"
    seeds = "; ".join(f"{name}: {', '.join(map(str, values))}" for name, values in origin.seeds.items())
    versions = ", ".join(f"{name} {number or 'not installed'}" for name, number in origin.versions.items())
    rows = [
        ("command", shlex.join(origin.command)),
        ("scene", f"{origin.scene}; SHA-256 of its content in SI {origin.scene_sha256}"),
        ("date", origin.date),
        ("machine", f"{origin.platform}, {origin.processor}, {origin.cores} cores, Python {origin.python}"),
        ("versions", versions),
        (
            "hard cases",
            f"last run {hard.date}, fembearing {hard.fembearing}, model version {hard.model_version}: {cases}",
        ),
        ("seeds", seeds or "none: no random numbers"),
        (
            "files",
            "report.json in the same folder holds these numbers in SI units at full precision, and the .vtu files the "
            "finest meshes with the pressure on them",
        ),
    ]
    return Section("Provenance", [Facts(rows)])


def _drawn_alone(title: str) -> Callable[[Report], Section]:
    return lambda _: Section(title, [])


APPENDICES: Mapping[str, Callable[[Report], Section]] = {  # by name; those without blocks are left out
    "inputs": inputs_section,
    "torque": torque_section,
    "measured": measured_section,
    "contacts": contacts_section,
    "pictures": _drawn_alone("Contact pressure"),
    "film": film_section,
    "creep": creep_section,
    "meshes": meshes_section,
    "ring": ring_section,
    "cage": cage_section,
    "sensitivity": _drawn_alone("Sensitivity to inputs"),
    "cost": cost_section,
    "next": next_section,
    "provenance": provenance_section,
}


def report_sections(document: Report, drawn: Drawn) -> list[Section]:
    """The whole report."""
    bearing = [each for each in drawn.get("bearing", ()) if isinstance(each, Drawing)]
    made = {name: make(document) for name, make in APPENDICES.items()}
    appendices = [Section(each.title, [*each.blocks, *drawn.get(name, ())], True) for name, each in made.items()]
    return [*summary_sections(document, bearing), *(each for each in appendices if each.blocks)]


def detail_sections(document: Report) -> list[Section]:
    """What a terminal shows of the report on demand."""
    torque = document.solved
    numerical, notes = (None, ()) if torque is None else (torque.verdicts.numerical, torque.notes)
    return [
        *(make(document) for make in (contacts_section, film_section, creep_section)),
        torque_section(document, every=False),
        measured_section(document),
        limits_section(document.physical, numerical, notes, document.verdict, document.units),
    ]
