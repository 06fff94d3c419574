"""The pictures of a report as the page takes them in: files beside report.json, which a stranger may have put there."""

import re
from collections.abc import Collection
from pathlib import Path
from typing import NamedTuple

from analytic.errors import InputError
from analytic.reading import content_of
from fembearing.report.figures.page_plots import embedded
from fembearing.report.page.view import remade
from fembearing.report.phrases import contact_title
from fembearing.report.report import PictureFile, Report

PNG = b"\x89PNG\r\n\x1a\n"  # how such a file begins
LARGEST_FILE = 64_000_000  # bytes
SENTENCE_END = re.compile(r"(?<=[.]) (?=[A-Z])")


class ShownPicture(NamedTuple):
    """A picture as the template shows it: an image, a view to turn, or why there is neither."""

    title: str  # of its contact
    caption: str
    source: str | None = None  # a data address
    view: str | None = None  # a page of its own
    missing: str | None = None


def shown_pictures(document: Report, folder: Path, *, kinds: Collection[str]) -> list[ShownPicture]:
    """The pictures of some kinds; a sentence that several captions share stands in the first of them."""
    said: set[str] = set()
    shown = []
    for picture in document.pictures:
        if picture.kind not in kinds:
            continue
        sentences = [each for each in SENTENCE_END.split(picture.caption) if each not in said]
        said |= {*sentences}
        shown.append(_shown(picture, document, folder)._replace(caption=" ".join(sentences)))
    return shown


def _shown(picture: PictureFile, document: Report, folder: Path) -> ShownPicture:
    """One picture with its contact's title and the file itself; where there is none, why."""
    contact = document.contact_of(picture)
    assert contact is not None  # the document holds it
    shown = ShownPicture(title=contact_title(contact), caption=picture.caption)
    content = _content_of(folder / picture.file)
    if content is None:
        return shown._replace(missing=f"The picture {picture.file} is missing beside report.json.")
    if picture.kind == "view":
        view = remade(content)
        if view is None:
            return shown._replace(missing=f"The file {picture.file} beside report.json is no view.")
        return shown._replace(view=view)
    if not content.startswith(PNG):
        return shown._replace(missing=f"The file {picture.file} beside report.json is no picture.")
    return shown._replace(source=embedded(content))


def _content_of(file: Path) -> bytes | None:
    """The content of a regular file of bounded size; None where there is none. No link is followed, no pipe opened."""
    try:
        return content_of(file, most=LARGEST_FILE, remedy="", linked=False)
    except InputError:
        return None
