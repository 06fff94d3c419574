"""The pictures of a report as the page takes them in: files beside report.json."""

import re
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

from fembearing.report.figures.page_plots import embedded
from fembearing.report.phrases import contact_title
from fembearing.report.report import Report

SENTENCE_END = re.compile(r"(?<=[.]) (?=[A-Z])")


class ShownPicture(NamedTuple):
    """A picture as the template shows it: an image, or a view to turn."""

    title: str  # of its contact
    caption: str
    source: str | None = None  # a data address
    view: str | None = None  # a page of its own


def shown_pictures(document: Report, folder: Path, *, kinds: Collection[str]) -> list[ShownPicture]:
    """The pictures of some kinds; a sentence that several captions share stands in the first of them."""
    said: set[str] = set()
    shown = []
    for picture in document.pictures:
        if picture.kind not in kinds:
            continue
        sentences = [each for each in SENTENCE_END.split(picture.caption) if each not in said]
        said |= {*sentences}
        one = ShownPicture(contact_title(document.contact_of(picture)), " ".join(sentences))
        content = (folder / picture.file).read_bytes()
        one = one._replace(view=content.decode()) if picture.kind == "view" else one._replace(source=embedded(content))
        shown.append(one)
    return shown
