"""What each mesh gave, and what they say together."""

from typing import Any

from fembearing.quantities import Quantity
from fembearing.report.document.contact import Study
from fembearing.report.document.report import Report
from fembearing.report.page.sections.verdicts import contact_place
from fembearing.report.phrases import digits, quantities_of


def mesh_section(document: Report) -> dict[str, Any]:
    """The table of the section on mesh convergence."""
    return {
        "meshes": [
            (
                contact_place(contact),
                [_row(contact.convergence[name], quantity) for name, quantity in quantities_of(contact).items()],
            )
            for contact in document.contacts
        ]
    }


def _row(study: Study, quantity: Quantity) -> dict[str, str]:
    limit, index, factor = study.richardson, study.grid_convergence_index, quantity.shown.factor
    return {
        "quantity": quantity.heading,
        "values": ", ".join(digits(value * factor) for value in study.values),
        "order": "none" if study.order is None else f"{study.order:.1f}",
        "index": "none" if index is None else f"{index:.2%}",
        "richardson": "" if limit is None else digits(limit * factor),
        "mesh": f"{study.mesh:.2%}",
        "domain": f"{study.domain:.2%}",
    }
