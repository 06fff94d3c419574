"""The report as one HTML page with everything in it: no other file, no address.

It is made from the document and from the pictures that the document lists and that lie beside report.json. What a
section shows comes from `fembearing.report.page.sections`, its plots from `fembearing.report.figures.page_plots`.
"""

from pathlib import Path
from typing import NamedTuple

from jinja2 import Environment, PackageLoader, StrictUndefined

from analytic.cage.grip import LARGEST_GRIP
from analytic.oil.film import FILM_FACTORS
from analytic.result import COORDINATES
from fembearing.quantities import RPM
from fembearing.report import phrases
from fembearing.report.document.report import PictureFile, Report
from fembearing.report.document.torque import MovedCage
from fembearing.report.figures.page_plots import PLOTS, embedded, plots_of
from fembearing.report.page.sections.next_steps import next_section
from fembearing.report.page.sections.torque import torque_section
from fembearing.report.page.sections.verdicts import verdict_section

GENERATOR = "fembearing"
MARK = f'<meta name="generator" content="{GENERATOR}">'  # by which a page of ours is known
PNG, VIEW = b"\x89PNG\r\n\x1a\n", b"<!DOCTYPE html>"  # how such a file begins


def write_page(document: Report, *, folder: Path, file: Path) -> None:
    """Write the page.

    folder : where the pictures of the document lie; the page says which of them is missing
    """
    environment = Environment(
        loader=PackageLoader("fembearing.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters |= {"shown": phrases.shown, "digits": phrases.digits, "listed": phrases.listed}
    page = environment.get_template("page.html").render(
        document=document,
        generator=GENERATOR,
        tolerance=f"{100 * document.tolerance:g} %",
        plots=plots_of(document, PLOTS),
        pictures=[_picture(picture, document, folder) for picture in document.pictures],
        trouble=None if document.renderer == "VTK" else document.renderer,
        scene=document.provenance.scene_content,
        moved=[each for each in document.cage_motion or () if isinstance(each, MovedCage)],
        phrases=phrases,
        per_minute=RPM.factor,
        coordinates=COORDINATES,
        film_factors=FILM_FACTORS,
        largest_grip=LARGEST_GRIP,
        verdict_section=verdict_section(document),
        torque_section=torque_section(document),
        next_section=next_section(document),
    )
    file.write_text(page, "utf-8", newline="\n")


class ShownPicture(NamedTuple):
    """A picture as the template shows it: an image, a view to turn, or why there is neither."""

    title: str  # of its contact
    caption: str
    source: str | None = None  # a data address
    view: str | None = None  # a page of its own
    missing: str | None = None


def _picture(picture: PictureFile, document: Report, folder: Path) -> ShownPicture:
    """One picture with its contact's title and the file itself; where there is none, why."""
    contact = document.contact_at(picture.pair, picture.geometry)
    assert contact is not None  # the document holds it
    shown = ShownPicture(title=phrases.contact_title(contact), caption=picture.caption)
    try:
        content = (folder / picture.file).read_bytes()
    except OSError:
        return shown._replace(missing=f"The picture {picture.file} does not lie beside report.json.")
    if picture.kind == "view" and content.startswith(VIEW):
        return shown._replace(view=content.decode("utf-8", "replace"))
    if not content.startswith(PNG):
        return shown._replace(missing=f"The file {picture.file} beside report.json is no picture.")
    return shown._replace(source=embedded(content))
