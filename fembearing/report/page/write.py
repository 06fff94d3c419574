"""The report as one HTML page with everything in it: no other file, no address.

It is made from the document and from the pictures that the document lists and that lie beside report.json. What a
section shows comes from `fembearing.report.page.sections`, its plots from `fembearing.report.figures.page_plots`.
"""

from pathlib import Path

from analytic.oil.film import FILM_FACTORS
from fembearing.report import phrases
from fembearing.report.figures.page_plots import PLOTS, ShownPlot, plots_of
from fembearing.report.page.pictures import shown_pictures
from fembearing.report.page.running_header import header_of
from fembearing.report.page.sections.appendices import appendices_of, letters_of
from fembearing.report.page.sections.bearing import details_of
from fembearing.report.page.sections.meshes import mesh_grid
from fembearing.report.page.sections.next_steps import next_section
from fembearing.report.page.sections.ring import ring_tables
from fembearing.report.page.sections.summary import summary_of
from fembearing.report.page.sections.verdicts import comparisons_of
from fembearing.report.page.template import filled
from fembearing.report.page.view import script_hash
from fembearing.report.report import Report
from fembearing.report.tables.cage import cage_tables
from fembearing.report.tables.contacts import contacts_of, pocket_table
from fembearing.report.tables.cost import cost_table
from fembearing.report.tables.creep import creep_table
from fembearing.report.tables.film import film_table
from fembearing.report.tables.inputs import effects_table, inputs_table
from fembearing.report.tables.measured import measured_table
from fembearing.report.tables.points import shown_places
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.table import Table
from fembearing.report.tables.torque import ball_table, change_table, pair_table, torque_table

GENERATOR = "fembearing"
MARK = f'<meta name="generator" content="{GENERATOR}">'  # by which a page of ours is known


def page_of(document: Report, folder: Path, *, plots: dict[str, list[ShownPlot]] | None = None) -> str:
    """The page.

    folder : where the pictures of the document lie
    plots : of the document, by section, where they are drawn already
    """
    appendices, units = appendices_of(document), document.units
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
        scene=document.scene,
        phrases=phrases,
        film_factors=FILM_FACTORS,
        details=details_of(document),
        contacts=contacts_of(document, units),
        comparisons=comparisons_of(document),
        pocket=pocket_table(document.contacts, units),
        tables={
            "inputs": _inputs(document),
            "torque": _torque(document),
            "measured": document.measured and measured_table(document.measured, units),
            "film": [film_table(film, units) for film in document.films],
            "creep": [creep_table(creep, units) for creep in document.creep],
            "ring": ring_tables(document),
            "cage": _cage(document),
        },
        meshes=mesh_grid(document),
        cost=cost_table(document.cost.ladders),
        next_section=next_section(document),
    )


def _inputs(document: Report) -> list[Table]:
    torque = document.solved
    if torque is None:
        return []
    named = [inputs_table("Sources of the inputs", torque.inputs, document.units)] if torque.inputs else []
    return [
        *named,
        effects_table(torque.friction.effects, torque.friction.effects.among(torque.places.computed).points),
    ]


def _torque(document: Report) -> list[Table]:
    """Of every operating point; of a long series some balls and intervals."""
    torque, change, units = document.solved, document.torque_change, document.units
    if torque is None or change is None:
        return []
    every, some = range(len(torque.points)), shown_places(torque)
    return [
        torque_table(torque, document.scene.bearing.name, every, units),
        *([] if torque.friction.pair is None else [pair_table(torque.friction.pair, every, units)]),
        ball_table(torque, some, units),
        *prediction_tables(torque, every, units),
        change_table(torque.points, change, every, units),
    ]


def _cage(document: Report) -> list[Table]:
    torque = document.solved
    every = () if torque is None else range(len(torque.points))
    return [] if torque is None else cage_tables(document.cage_motion, torque, every, document.units)
