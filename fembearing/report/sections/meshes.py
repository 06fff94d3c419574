"""What each mesh of a contact gave, and what the meshes say together."""

from collections.abc import Iterator

from analytic.units import Units
from fembearing.check.contact.solution import ContactNumbers
from fembearing.report.document import Group, Head, Row, Section, Table
from fembearing.report.phrases import digits, shown
from fembearing.report.report import Report
from fembearing.report.sections.contacts import contact_title, quantities_of

NOTES = (
    "Extrapolated: from the last two meshes with the formal order, 4 for approach and stiffness, 3 for semi-axes; "
    "peak pressure has no steady order and is that of the finest mesh. Mesh: half the extrapolation's step; for peak "
    "pressure the remainder of the last change with order 3, plus 0.03 %. Values of meshes that do not converge are "
    "not extrapolated; mesh: three times the spread of the last three, or of the remainder with the observed order if "
    "larger.",
    "By the compliance of the pair all quantities are extrapolated with order 3, the approach after a correction of "
    "1.4 % of the square of the larger semi-axis over level and ball's radius; mesh: 0.7 times the step, 0.02 %, 0.1 % "
    "of the square of the semi-axis over the radius, and more where an unlike shoulder is near.",
    "A contact cut off at a shoulder is not extrapolated either; mesh: three times the last change, plus 0.03 %. All "
    "have 0.008 % more for common errors of the meshes.",
    "Far boundary: change by a larger block, included in the value. Semi-axes and pressure: as in an infinite block; "
    "half of the change is the uncertainty. Approach and stiffness have no such limit: they count race or seat up to "
    "8 major semi-axes; a quarter of the change is the uncertainty, an eighth where it is that of the second level, or "
    "half by plain meshes. A sheet has no far boundary. Mesh and far boundary add as squares. Order: observed on the "
    "last three meshes, to compare with the formal one.",
    "GCI: Roache's grid-convergence index of the finest mesh, not extrapolated: factor 1.25 with the formal order if "
    "the observed one is within a tenth of it, else 3 with the lower of the two (3 for peak pressure). It is not part "
    "of the intervals.",
)
HEADS = (
    Head("quantity", "name"),
    Head("on each mesh, coarse to fine", "text"),
    Head("order"),
    Head("GCI"),
    Head("extrapolated"),
    Head("mesh"),
    Head("far boundary"),
)


def meshes_section(document: Report) -> Section:
    """A group for each contact, a row for each quantity."""
    groups = [
        Group(list(_rows(contact, document.units)), contact_title(contact, document.units))
        for contact in document.contacts
    ]
    return Section("Meshes and convergence", [Table("Meshes of each contact", HEADS, groups, NOTES)])


def _rows(contact: ContactNumbers, units: Units) -> Iterator[Row]:
    for name, quantity in quantities_of(contact).items():
        study, factor = contact.estimates[name], quantity.shown(units).factor
        yield [
            quantity.heading(units),
            ", ".join(digits(value, factor) for value in study.values),
            shown(study.order, ".1f", absent="none"),
            shown(study.grid_convergence_index, ".2%", absent="none"),
            digits(study.richardson, factor, absent=""),
            f"{study.mesh:.2%}",
            f"{study.domain:.2%}",
        ]
