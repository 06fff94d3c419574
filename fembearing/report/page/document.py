"""A document as one HTML page, which needs no other file."""

from collections.abc import Sequence

from fembearing.provenance import Provenance
from fembearing.report.document import Section
from fembearing.report.page.template import filled


def page_of_sections(title: str, sections: Sequence[Section], provenance: Provenance) -> str:
    """The page;  provenance : of the scene that it is about"""
    return filled("document.html", title=title, sections=sections, provenance=provenance)
