"""`fembearing validate`."""

from typing import Annotated

import typer

from fembearing.cli.options import (
    AsJson,
    Folder,
    SceneName,
    Tolerance,
    WithInterval,
    read_scene,
    read_tolerance,
    require_folder_name,
)
from fembearing.cli.report_options import with_report_options
from fembearing.cli.status import STATUS, print_warnings


@with_report_options
def validate(
    scene: SceneName = None,
    tolerance: Tolerance = None,
    folder: Folder = None,
    with_cost: Annotated[
        bool, typer.Option("--cost", help="Measure error and time of all methods, as `fembearing cost`.")
    ] = False,
    with_interval: WithInterval = False,
    no_film: Annotated[bool, typer.Option("--no-film", help="Skip the numerical film.")] = False,
    no_creep: Annotated[bool, typer.Option("--no-creep", help="Skip the numerical friction.")] = False,
    details: Annotated[
        bool, typer.Option("--details", help="Print tables of contacts, film, friction, torque and limits.")
    ] = False,
    as_json: AsJson = False,
) -> None:
    """Check contacts, film, friction and torque of a scene against numerical references.

    One line per reference gives the largest difference; --details, --json and the report give all differences.
    """
    require_folder_name(folder)
    given = read_scene(scene)
    limit = read_tolerance(tolerance, given)
    from fembearing.cli.console import out, print_json, shown_progress
    from fembearing.plain_types import plain
    from fembearing.report.folder import validate as run
    from fembearing.report.report import report_of
    from fembearing.report.terminal.validation import print_details, print_headline

    with shown_progress() as progress:
        result = run(
            given,
            out=folder,
            tolerance=limit,
            cost=with_cost,
            samples="enough" if with_interval else None,
            film=not no_film,
            creep=not no_creep,
            progress=progress,
        )
    document = report_of(result)
    if as_json:
        print_json(plain(document))
    else:
        print_headline(out, document)
        if details:
            out.print()
            print_details(out, document)
        print_warnings(result.warnings)
        if folder is not None:
            out.tell(f"report: {folder / 'report.html'}")
    raise typer.Exit(STATUS[result.verdict])
