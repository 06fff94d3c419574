"""Contacts whose pictures need a look of their own: one cut off, ellipses apart, a small body under a large ball."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from fembearing.check.contact.solution import ContactSolution
from fembearing.check.validation import Validation
from fembearing.report.pictures.draw import Kind, Picture, contact_jobs, contact_pictures


@dataclass(frozen=True)
class OddPicture:
    """One picture of a contact, and the job that draws it."""

    picture: Picture
    job: dict[str, Any]


def odd_pictures(checked: Validation, cut: ContactSolution, folder: Path) -> dict[str, OddPicture]:
    """One kind of picture of each, on coarse meshes: all three on the finest would take VTK many seconds."""
    race, _, seat, _ = checked.contacts
    contacts: dict[str, tuple[ContactSolution, Kind]] = {
        "cut": (on_level(cut, 1), "pressure"),
        "cut view": (on_level(cut, 1), "view"),
        "race": (with_ellipses(on_level(race, 0), computed=(1.15, 1.2), hertz=(1.3, 1.05)), "pressure"),
        "pocket": (with_ellipses(on_level(seat, 0), computed=(1.3, 1.1), hertz=(1.15, 1.25)), "pressure"),
    }
    made = {}
    for name, (contact, kind) in contacts.items():
        place = folder / name
        place.mkdir()
        (job,) = (job for job in contact_jobs(contact, place) if job["kind"] == kind)
        (picture,) = (picture for picture in contact_pictures(contact, place) if picture.kind == kind)
        made[name] = OddPicture(picture, job)
    return made


def on_level(contact: ContactSolution, number: int) -> ContactSolution:
    """With one of its meshes in place of the finer ones: their number belongs to other numbers of the contact."""
    kept = contact.meshes[: number + 1]
    return replace(contact, meshes=(*kept, *kept[-1:] * (len(contact.meshes) - len(kept))))


def with_ellipses(
    contact: ContactSolution, *, computed: tuple[float, float], hertz: tuple[float, float]
) -> ContactSolution:
    """The ellipses as multiples of the computed one; (rolling, transverse)."""
    names = "semi_axis_rolling", "semi_axis_transverse"
    found = contact.numbers.quantities
    made = {
        name: replace(found[name], reference=by_fe * found[name].reference, production=by_hertz * found[name].reference)
        for name, by_fe, by_hertz in zip(names, computed, hertz, strict=True)
    }
    return contact.with_numbers(quantities=found | made)
