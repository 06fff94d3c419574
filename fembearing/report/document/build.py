"""The document of a check, built once from its results."""

from collections.abc import Iterator, Sequence
from typing import Any

from fembearing.plain_types import plain
from fembearing.report.document.contact import Contact
from fembearing.report.document.report import FORMAT, KIND, Report
from fembearing.verify.contact.comparison_error import WHY
from fembearing.verify.contact.discrepancy import ContactSolution
from fembearing.verify.torque.scene_torque import SceneTorque
from fembearing.verify.validation import Validation

INSTANTS = 400  # of a cage's motion that are kept


def report_of(
    result: Validation, *, pictures: Sequence[dict[str, str]] | None = None, renderer: str | None = None
) -> Report:
    """The document of a check.

    pictures : as the document lists them, and `renderer` what drew them; without them the document has neither key
    """
    drawn = {} if pictures is None else {"pictures": list(pictures), "renderer": renderer or "VTK"}
    change, torque, verdicts = result.torque_change, result.torque, result.verdicts
    return Report.model_validate(
        {
            "kind": KIND,
            "format": FORMAT,
            "verdict": verdicts.summary(),
            "physical": verdicts.to_json()["physical"],
            "report": plain(result.scene.report),
            "tolerance": result.tolerance,
            "verdicts": [row for contact in result.contacts if contact.judged for row in _verdicts(contact)],
            "uncertainties": WHY,
            "contacts": [contact.to_json() for contact in result.contacts],
            "torque": None if torque is None else torque.to_json(),
            "torque_change": None if change is None else change.to_json(),
            "cage_motion": None if torque is None else _cage_motion(torque),
            "cage_records": [record.drawn(most=INSTANTS) for record in result.cage_records],
            "sensitivity": plain(result.sensitivity),
            "cost": {
                "measured": result.measured,
                "seconds": result.seconds,
                "peak_memory": result.peak_memory,
                "ladders": [ladder.to_json() for ladder in result.ladders],
            },
            "hard": plain(result.hard),
            "warnings": list(result.warnings),
            "provenance": result.provenance,
        }
        | drawn
    )


def contact_table(solution: ContactSolution) -> Contact:
    """One contact as the document has it."""
    return Contact.model_validate(solution.to_json())


def _verdicts(contact: ContactSolution) -> Iterator[dict[str, Any]]:
    """A row of the document for each quantity of a contact."""
    for name, part in contact.estimates.items():
        yield {
            "pair": contact.contact.pair,
            "geometry": contact.geometry,
            "quantity": name,
            "production": getattr(contact.hertz, name),
            "reference": part.value,
            "discrepancy": contact.discrepancy[name],
            "uncertainty": part.total,
            "exceeds_uncertainty": contact.exceeds_uncertainty[name],
            "comparison": contact.comparisons[name].to_json(),
            "verdict": contact.verdicts[name],
        }


def _cage_motion(torque: SceneTorque) -> list[dict[str, Any]] | None:
    """Each operating point, None where no cage moved; torque, start and block are None at a point where it rests."""
    part = torque.friction.cage
    if part is None or not any(part.motion):
        return None
    return [
        part.at(point)
        | {"inner_speed": float(torque.friction.inner_speed[point])}
        | {name: None if motion is None else getattr(motion, name) for name in ("torque", "start", "block")}
        | {"other": None if motion is None else plain(motion.other)}
        for point, motion in enumerate(part.motion)
    ]
