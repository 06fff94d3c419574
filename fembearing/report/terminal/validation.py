"""The check of a scene as tables and lines of text for a terminal or a pipe of 80 characters."""

from rich.console import Console

from analytic.words import percent_of
from fembearing.report.headline import headline_title, torque_words
from fembearing.report.phrases import creep_change_words, film_change_words, friction_of, numerical_words
from fembearing.report.report import Report
from fembearing.report.tables.contacts import contacts_of, pocket_table
from fembearing.report.tables.creep import creep_table
from fembearing.report.tables.film import film_table
from fembearing.report.tables.measured import measured_table
from fembearing.report.tables.points import shown_places
from fembearing.report.tables.prediction import prediction_tables
from fembearing.report.tables.torque import change_table, pair_table, torque_table
from fembearing.report.tables.verdicts import physical_table
from fembearing.report.terminal.table import show

NO_TORQUE = "No torque: no friction coefficient, lubricant or surface is given."


def print_headline(out: Console, document: Report) -> None:
    """Print the torque with its interval, a line for each reference, and last how far to trust the torque."""
    scene, torque, verdict = document.scene, document.solved, document.verdict
    first, last = [f"{scene.name}. {NO_TORQUE}"], []
    if torque is not None:
        first = [headline_title(torque, document.units), torque_words(torque, document.units)]
        last = [f"{torque.standing.word}: {torque.standing.reason}"]
    first += [] if document.measured is None else [document.measured.conclusions[0]]
    references = f"references {verdict.overall}: {verdict.reason}"
    for line in (*first, *(finding.words for finding in document.findings), references, *last):
        out.print(line, markup=False)


def print_details(out: Console, document: Report) -> None:
    """Print all tables of a check, and the verdicts, in the last line in a word each."""
    scene, torque, change = document.scene, document.solved, document.torque_change
    units = document.units
    pocket = pocket_table(document.contacts, units)
    films = [film_table(each, units) for each in document.films]
    for table in (contacts_of(document, units), *films, *([] if pocket is None else [pocket])):
        show(out, table)
    for creep in document.creep:
        show(out, creep_table(creep, units))
    if torque is None or change is None:
        out.print(f"{NO_TORQUE}\n")
    else:
        places = shown_places(torque)
        show(out, torque_table(torque, scene.bearing.name, places, units))
        if torque.friction.pair is not None:
            show(out, pair_table(torque.friction.pair, places, units))
        friction = friction_of(coefficient=scene.friction_coefficient, is_lubricated=scene.has_friction)
        out.print(f"Friction: {friction}.\n", markup=False)
        for table in prediction_tables(torque, places, units):
            show(out, table)
        show(out, change_table(torque.points, change, places, units))
    if document.measured is not None:
        show(out, measured_table(document.measured, units))
    if document.film_change is not None:
        out.print(f"{film_change_words(document.film_change)}\n")
    if document.creep_change is not None:
        out.print(f"{creep_change_words(document.creep_change)}\n")
    show(out, physical_table(document.physical, units))
    numerical = None if torque is None else torque.verdicts.numerical
    if torque is not None and numerical is not None:
        for note in (*torque.notes, numerical_words(numerical)):
            out.print(note, markup=False)
    out.print(f"Tolerance {percent_of(document.tolerance)}, {document.cost.seconds:.1f} s.")
    out.print(document.verdict.words)
