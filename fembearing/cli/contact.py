"""`fembearing contact`."""

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any

import typer

from fembearing.cli.options import (
    Accuracy,
    AsJson,
    Geometry,
    Loads,
    PairName,
    SceneName,
    read_load,
    read_scene,
    read_tolerance,
)
from fembearing.cli.status import DONE, NOT_SOLVED, complain, print_warnings

if TYPE_CHECKING:
    from fembearing.quantities import Units
    from fembearing.verify.contact.discrepancy import ContactSolution
    from fembearing.verify.contact.load_series import LoadSeries
    from fembearing.verify.contact.subsurface import SubsurfaceComparison


def contact(
    scene: SceneName = None,
    pair: Annotated[PairName, typer.Option(help="Contact of the ball.")] = "inner",
    load: Loads = None,
    geometry: Geometry = "real",
    accuracy: Accuracy = None,
    as_json: AsJson = False,
) -> None:
    """Solve one contact by finite elements and compare Hertz with it. Several --load give the stiffness law.

    Exit status 0: required accuracy reached, for any verdict on Hertz; 2: input error; 3: accuracy not reached.
    """
    given = read_scene(scene)
    limit = read_tolerance(accuracy, given)
    loads = [read_load(text) for text in load or ()]
    from analytic.errors import InputError
    from fembearing.cli.console import shown_progress
    from fembearing.quantities import SYSTEMS
    from fembearing.verify.contact.discrepancy import solve_contact
    from fembearing.verify.contact.load_series import solve_load_series
    from fembearing.verify.contact.subsurface import compare_subsurface

    units = SYSTEMS[given.report.units]
    with shown_progress() as progress:
        settings: dict[str, Any] = {"pair": pair, "accuracy": limit, "geometry": geometry, "progress": progress}
        if len(loads) > 1:
            show = partial(_show_series, solve_load_series(given, loads=loads, **settings), units)
        else:
            result, below = solve_contact(given, load=loads[0] if loads else None, **settings), None
            progress(0.8, f"{result.contact.pair}: stress under the contact")
            try:
                below = compare_subsurface(result)
            except InputError as problem:  # a contact cut off at a shoulder: everything else is known
                result = replace(result, warnings=(*result.warnings, str(problem)))
            show = partial(_show_contact, result, below, limit, units)
    raise typer.Exit(_status(show(as_json=as_json), limit))


def _show_contact(
    result: "ContactSolution", below: "SubsurfaceComparison | None", accuracy: float, units: "Units", *, as_json: bool
) -> dict[str, float]:
    """The relative uncertainties of the quantities that are to be known to the accuracy, by their names."""
    from analytic.words import percent_of
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.contact import contact_record
    from fembearing.report.tables.contacts import contact_table, subsurface_table
    from fembearing.report.terminal.table import show
    from fembearing.verify.contact.discrepancy import SHOWN_OF_A_SHEET
    from fembearing.verify.contact.mesh_refinement import COMPARED

    if as_json:
        added = {"tolerance": result.tolerance, "accuracy": accuracy, "subsurface": plain(below)}
        print_json(plain(contact_record(result)) | added)
    else:
        show(out, contact_table([(contact_record(result), result.verdicts)], units))
        if below is not None:
            show(out, subsurface_table(below, units))
        if result.judged:
            out.print(f"Hertz, tolerance of the scene {percent_of(result.tolerance)}: {result.verdict}")
        print_warnings(result.warnings)
    return {name: result.estimates[name].total for name in (COMPARED if result.judged else SHOWN_OF_A_SHEET)}


def _show_series(result: "LoadSeries", units: "Units", *, as_json: bool) -> dict[str, float]:
    from analytic.words import percent_of
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.load_series import series_record
    from fembearing.report.tables.contacts import series_table
    from fembearing.report.terminal.table import show

    if as_json:
        print_json(plain(series_record(result)))
    else:
        show(out, series_table(result, units))
        verdict = result.verdict if result.judged else "no verdict"
        out.print(f"{verdict}: tolerance {percent_of(result.tolerance)}")
        print_warnings(result.warnings)
    return {f"approach at {part.load:g} N": part.approach.total for part in result.points}


def _status(uncertainties: dict[str, float], accuracy: float) -> int:
    """Whether the largest relative uncertainty is within the accuracy; a line on standard error says if it is not."""
    name = max(uncertainties, key=lambda name: uncertainties[name])
    if uncertainties[name] <= accuracy:
        return DONE
    from analytic.words import percent_of

    return complain(
        f"not solved to {percent_of(accuracy, 2)}: the {name.replace('_', ' ')} has an uncertainty of "
        f"{percent_of(uncertainties[name], 2)}; give a larger --tolerance",
        NOT_SOLVED,
    )
