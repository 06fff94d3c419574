"""The report as one HTML page with everything in it: no other file, no address.

It is made from the document alone, which is what report.json holds (plain types, SI), and from the pictures that the
document lists under "pictures" and that lie beside it. What a section shows comes from `fembearing.report.page.sections`.

A plot of the page is an entry of `fembearing.report.figures.plots`: the section that it ends, its heading, and a function of
the document that gives a matplotlib figure and its caption, or None and in place of the caption why there is nothing to
draw. The template shows the plots of each section at its end, in the order of PLOTS.
"""

from pathlib import Path
from typing import Any

from jinja2 import Environment, PackageLoader, StrictUndefined

from fembearing.report.figures.plot import Document, embedded, plots_of
from fembearing.report.figures.plots import PLOTS
from fembearing.report.page.sections.cost import cost_section
from fembearing.report.page.sections.evidence import standing_section
from fembearing.report.page.sections.meshes import mesh_section
from fembearing.report.page.sections.published import published_section
from fembearing.report.page.sections.scene import scene_section
from fembearing.report.page.sections.torque import torque_section
from fembearing.report.page.sections.verdicts import verdict_section
from fembearing.report.words import title_of

SECTIONS = (
    *(scene_section, verdict_section, torque_section, mesh_section, cost_section),
    *(published_section, standing_section),
)
GENERATOR = "fembearing"
MARK = f'<meta name="generator" content="{GENERATOR}">'  # by which a page of ours is known
PNG, VIEW = b"\x89PNG\r\n\x1a\n", b"<!DOCTYPE html>"  # how such a file begins


def write_page(document: Document, *, folder: Path, file: Path) -> None:
    """Write the page.

    folder : where the pictures of the document lie; one that is missing leaves a word
    """
    environment = Environment(
        loader=PackageLoader("fembearing.report.page"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    context: dict[str, Any] = {}
    for section in SECTIONS:
        context |= section(document)
    page = environment.get_template("page.html").render(
        document=document,
        generator=GENERATOR,
        tolerance=f"{100 * document['tolerance']:g} %",
        plots=plots_of(document, PLOTS),
        pictures=[_picture(picture, document, folder) for picture in document.get("pictures", ())],
        trouble=None if document.get("renderer", "VTK") == "VTK" else document["renderer"],
        provenance=document["provenance"],
        **context,
    )
    file.write_text(page, "utf-8", newline="\n")


def _picture(told: Document, document: Document, folder: Path) -> dict[str, Any]:
    """One picture with its contact's title and the file itself; where there is none, why."""
    contact = next(
        contact
        for contact in document["contacts"]
        if (contact["pair"], contact["geometry"]) == (told["pair"], told["geometry"])
    )
    found = {"title": title_of(contact), "caption": told["caption"], "source": None, "view": None, "missing": None}
    try:
        content = (folder / told["file"]).read_bytes()
    except OSError:
        return found | {"missing": f"The picture {told['file']} does not lie beside report.json."}
    if told["kind"] == "view" and content.startswith(VIEW):
        return found | {"view": content.decode("utf-8", "replace")}
    if not content.startswith(PNG):
        return found | {"missing": f"The file {told['file']} beside report.json is no picture."}
    return found | {"source": embedded(content)}
