"""A document as one HTML page with everything in it: no other file, no address."""

from collections.abc import Sequence
from string import ascii_uppercase

from analytic.scene import ReportDetails
from fembearing.provenance import Provenance
from fembearing.report.document import Section
from fembearing.report.page.template import filled
from fembearing.report.page.view import script_hash

LONGEST_NAME, LONGEST_DATE = 60, 20  # letters of what the scene says that fit beside the rest of the running header
SHORT_HASH, DAY = 12, 10  # letters; the day of a date and time
UNSIGNED = ReportDetails()


def page_of(
    title: str, sections: Sequence[Section], provenance: Provenance, *, details: ReportDetails = UNSIGNED
) -> str:
    """The page;  provenance : of the scene that it is about;  details : revision and date of every printed page"""
    name = provenance.scene
    revision = f"revision {details.revision[:LONGEST_DATE]}, " if details.revision else ""
    header = (
        name if len(name) <= LONGEST_NAME else f"{name[:LONGEST_NAME]}...",
        f"SHA-256 {provenance.scene_sha256[:SHORT_HASH]}",
        f"{revision}{details.date[:LONGEST_DATE] if details.date else provenance.date[:DAY]}",
    )
    return filled(
        "document.html",
        title=title,
        sections=sections,
        provenance=provenance,
        header=[css_string(words) for words in header],
        letters=ascii_uppercase,
        script=script_hash(),
    )


def css_string(text: str) -> str:
    """A text as a string of CSS in which no letter can end the string or the style sheet."""
    letters = (letter if letter.isalnum() or letter == " " else f"\\{ord(letter):x} " for letter in text)
    return f'"{"".join(letters)}"'


def shown(section: Section) -> str:
    """A section alone, for a page of others."""
    return filled("section.html", section=section)
