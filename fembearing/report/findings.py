"""What each reference shows of a check, in a number with its solver error: the largest difference, and the verdict."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from analytic.columns import CONTACT
from analytic.rows import NotNegative
from analytic.words import PERCENT, percent_of
from fembearing.check.comparison import ShownVerdict, worst
from fembearing.check.contact.scene_contact import which_bearing
from fembearing.check.contact.solution import ContactNumbers
from fembearing.check.creep.scene_creep import CreepNumbers
from fembearing.check.film.scene_film import JUDGED, FilmNumbers
from fembearing.check.torque_change import TorqueChange

OFF = {  # what is compared with a reference
    "contacts": "contacts: Hertz",
    "film": "film: model",
    "friction": "friction: production",
}
CHANGED = {  # by what is not compared
    "ring": "ring on a rigid seat: {size} of the approach",
    "pocket": "sheet of the pocket: {size} of the stiffness K_pb",
    "torque": "finite elements change the torque by {size}",
}
FILM_NAMES = {"central_film": "central film", "rolling_force": "rolling force"}


@dataclass(frozen=True, kw_only=True)
class Finding:
    """The largest difference that one reference shows, over contacts and quantities."""

    # Hertz, film model and production friction less the reference, over the reference; what ring and sheet add to the
    # contact alone, and contacts by finite elements to the torque, over it
    reference: Literal["contacts", "film", "friction", "ring", "pocket", "torque"]
    quantity: str
    place: str  # in words; empty: all balls
    difference: float  # relative
    uncertainty: NotNegative  # numerical, of the reference, relative
    verdict: ShownVerdict  # of all that is compared with this reference; shown: not judged

    @property
    def words(self) -> str:
        """In a line."""
        size, place = PERCENT.written(self.difference, "+.3g"), f", {self.place}" if self.place else ""
        after = f"{place}; solver error {percent_of(self.uncertainty, 2)}"
        if self.reference in CHANGED:
            return f"{CHANGED[self.reference].format(size=size)}{after}"
        verdict = "" if self.verdict == "shown" else f": {self.verdict}"
        return f"{OFF[self.reference]} {size} off in {self.quantity}{after}{verdict}"


def findings_of(
    contacts: Sequence[ContactNumbers],
    films: Sequence[FilmNumbers],
    creep: Sequence[CreepNumbers],
    change: TorqueChange | None,
    friction: ShownVerdict,
) -> Iterator[Finding]:
    """One of each reference that the check has;  friction : the verdict on it"""
    yield contact_finding(contacts)
    if films:
        yield _of_films(films)
    if creep:
        yield max((_of_creep(each, friction) for each in creep), key=_size)
    rings = [contact for contact in contacts if contact.ring is not None]
    if rings:
        yield max(map(_of_ring, rings), key=_size)
    yield from (_of_sheet(contact) for contact in contacts if contact.geometry == "wall")
    if change is not None:
        yield _of_torque(change)


def _size(finding: Finding) -> float:
    return abs(finding.difference)


def contact_finding(contacts: Sequence[ContactNumbers]) -> Finding:
    """The largest difference that finite elements show of Hertz, over the contacts that are judged."""
    verdict = worst(contact.verdict for contact in contacts if contact.judged)
    found = (
        Finding(
            reference="contacts",
            quantity=quantity.name,
            place=_on(contact.pair, contact.bearing),
            difference=contact.quantities[name].difference,
            uncertainty=contact.quantities[name].uncertainty / contact.quantities[name].reference,
            verdict=verdict,
        )
        for contact in contacts
        if contact.judged
        for name, quantity in CONTACT.items()
    )
    return max(found, key=_size)


def _of_films(films: Sequence[FilmNumbers]) -> Finding:
    """Of central film and rolling force, which the torque takes and the verdict is on."""
    verdict = worst(film.verdict for film in films)
    found = (
        Finding(
            reference="film",
            quantity=FILM_NAMES[name],
            place=_on(film.pair, film.bearing),
            difference=film.quantities[name].difference,
            uncertainty=film.quantities[name].uncertainty / abs(film.quantities[name].reference),
            verdict=verdict,
        )
        for film in films
        for name in JUDGED
    )
    return max(found, key=_size)


def _of_creep(creep: CreepNumbers, verdict: ShownVerdict) -> Finding:
    """Of all balls of a bearing."""
    return Finding(
        reference="friction",
        quantity="torque by sliding",
        place=which_bearing(creep.bearing).removeprefix(" of the "),
        difference=creep.torque.difference,
        uncertainty=creep.relative_uncertainty,
        verdict=verdict,
    )


def _of_ring(contact: ContactNumbers) -> Finding:
    ring = contact.ring
    assert ring is not None
    return Finding(
        reference="ring",
        quantity="approach",
        place=_on(contact.pair, contact.bearing),
        difference=ring.share,
        uncertainty=ring.uncertainty / contact.reference.approach,
        verdict="shown",
    )


def _of_sheet(contact: ContactNumbers) -> Finding:
    stiffness = contact.quantities["stiffness"]
    return Finding(
        reference="pocket",
        quantity="stiffness",
        place="",
        difference=stiffness.reference / stiffness.production - 1,
        uncertainty=stiffness.uncertainty / stiffness.reference,
        verdict="shown",
    )


def _of_torque(change: TorqueChange) -> Finding:
    """At the point of the heaviest ball, whose contacts were solved."""
    loads, relative = change.own.ball_load, change.relative("total")
    assert relative is not None
    point = int(np.argmax(loads))
    return Finding(
        reference="torque",
        quantity="torque",
        place=f"point {point + 1}" if loads.size > 1 else "",
        difference=float(relative[point]),
        uncertainty=change.uncertainty,
        verdict="shown",
    )


def _on(pair: str, bearing: str | None) -> str:
    return "cage pocket" if pair == "pocket" else f"{pair} race{which_bearing(bearing)}"
