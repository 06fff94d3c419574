"""The report as one HTML page with everything in it: no other file, no address.

It is made from the document and from the pictures that the document lists and that lie beside report.json. What a
section shows comes from `fembearing.report.page.sections`, its plots from `fembearing.report.figures.page_plots`.
"""

from pathlib import Path

from analytic.oil.film import FILM_FACTORS
from fembearing.quantities import RPM
from fembearing.report import phrases
from fembearing.report.figures.page_plots import PLOTS, ShownPlot, plots_of
from fembearing.report.page.pictures import shown_pictures
from fembearing.report.page.running_header import header_of
from fembearing.report.page.sections.appendices import appendices_of, letters_of
from fembearing.report.page.sections.bearing import details_of
from fembearing.report.page.sections.cage import cage_section
from fembearing.report.page.sections.cost import cost_grid
from fembearing.report.page.sections.meshes import mesh_grid
from fembearing.report.page.sections.next_steps import next_section
from fembearing.report.page.sections.ring import ring_section
from fembearing.report.page.sections.summary import summary_of
from fembearing.report.page.sections.torque import torque_section
from fembearing.report.page.sections.verdicts import verdict_section
from fembearing.report.page.template import filled
from fembearing.report.page.view import script_hash
from fembearing.report.report import Report
from fembearing.report.tables.creep import creep_notes, creep_tables
from fembearing.report.tables.film import film_notes, film_table
from fembearing.report.tables.inputs import effects_table, inputs_table

GENERATOR = "fembearing"
MARK = f'<meta name="generator" content="{GENERATOR}">'  # by which a page of ours is known


def page_of(document: Report, folder: Path, *, plots: dict[str, list[ShownPlot]] | None = None) -> str:
    """The page.

    folder : where the pictures of the document lie; the page says which of them is missing
    plots : of the document, by section, where they are drawn already
    """
    appendices = appendices_of(document)
    return filled(
        "page.html",
        document=document,
        generator=GENERATOR,
        script=script_hash(),
        header=header_of(document),
        tolerance=f"{100 * document.tolerance:g} %",
        summary=summary_of(document),
        appendices=appendices,
        letters=letters_of(appendices),
        plots=plots_of(document, PLOTS) if plots is None else plots,
        pictures=shown_pictures(document, folder, kinds=("pressure", "section", "view")),
        film_pictures=shown_pictures(document, folder, kinds=("film",)),
        creep_pictures=shown_pictures(document, folder, kinds=("creep",)),
        film_tables=[film_table(film, document.units) for film in document.films],
        film_notes=[film_notes(film, document.units) for film in document.films],
        creep_tables=document.creep and creep_tables(document.creep, document.units),
        creep_notes=document.creep and creep_notes(document.creep, document.units),
        trouble=None if document.renderer == "VTK" else document.renderer,
        scene=document.scene,
        phrases=phrases,
        per_minute=RPM.factor,
        film_factors=FILM_FACTORS,
        details=details_of(document),
        effects=document.torque and effects_table(document.torque.effects),
        inputs=document.torque and inputs_table("where the inputs come from", document.torque.inputs, document.units),
        verdict_section=verdict_section(document),
        torque_section=torque_section(document),
        ring_section=ring_section(document),
        cage_section=cage_section(document),
        mesh_grid=mesh_grid(document),
        cost_grid=cost_grid(document),
        next_section=next_section(document),
    )
