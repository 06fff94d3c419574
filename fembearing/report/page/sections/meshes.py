"""What each mesh of a contact gave, and what the meshes say together."""

from collections.abc import Iterator

from fembearing.check.contact.solution import ContactNumbers
from fembearing.grid_convergence import Estimate
from fembearing.quantities import Units
from fembearing.report.phrases import contact_title, digits, quantities_of, shown
from fembearing.report.report import Report
from fembearing.report.tables.table import Group, Head, Row, Table

HEADS = (
    Head("quantity", "name"),
    Head("on each mesh, coarse to fine", "text"),
    Head("order"),
    Head("GCI"),
    Head("extrapolated"),
    Head("mesh"),
    Head("far boundary"),
)


def mesh_grid(document: Report) -> Table:
    """A group for each contact, a row for each quantity."""
    groups = [
        Group(list(_rows(contact, document.units)), contact_title(contact, document.units))
        for contact in document.contacts
    ]
    return Table("meshes of each contact", HEADS, groups)


def _rows(contact: ContactNumbers, units: Units) -> Iterator[Row]:
    for name, quantity in quantities_of(contact, units).items():
        study, factor = contact.estimates[name], quantity.shown.factor
        yield [
            quantity.heading,
            _on_meshes(study, factor),
            shown(study.order, ".1f", absent="none"),
            shown(study.grid_convergence_index, ".2%", absent="none"),
            digits(study.richardson, factor, absent=""),
            f"{study.mesh:.2%}",
            f"{study.domain:.2%}",
        ]


def _on_meshes(study: Estimate, factor: float) -> str:
    plain, corrected = (
        ", ".join(digits(value, factor) for value in values) for values in (study.values, study.corrected)
    )
    return f"{plain}; with twin {corrected}" if corrected else plain
