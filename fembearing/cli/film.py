"""`fembearing film`."""

from typing import Annotated, Literal

import typer

from fembearing.cli.options import (
    AsJson,
    Bodies,
    Folder,
    Load,
    SceneName,
    read_load,
    read_scene,
    read_speed,
    read_tolerance,
    require_folder_name,
)
from fembearing.cli.status import DONE, NOT_SOLVED, complain, print_warnings

Tolerance = Annotated[
    str | None,
    typer.Option(help='Required accuracy of film and rolling force, for example "1 %" (default: from the scene).'),
]
Speed = Annotated[
    str | None, typer.Option(help='Speed of the inner ring, for example "500 rpm" (default: from the scene).')
]
RaceName = Annotated[Literal["inner", "outer"], typer.Option("--pair", help="Race of the contact.")]


def film(
    scene: SceneName = None,
    pair: RaceName = "inner",
    load: Load = None,
    speed: Speed = None,
    tolerance: Tolerance = None,
    compliance: Bodies = "half-space",
    folder: Folder = None,
    as_json: AsJson = False,
) -> None:
    """Solve the lubricated contact of a ball on a race and compare the formulas for film and rolling.

    Exit status 0: required accuracy reached, for any difference of the formulas; 2: input error; 3: accuracy not
    reached.
    """
    require_folder_name(folder)
    given = read_scene(scene)
    limit = read_tolerance(tolerance, given)
    force = None if load is None else read_load(load)
    turning = None if speed is None else read_speed(speed)
    from contextlib import nullcontext

    from analytic.words import percent_of
    from analytic.writing import new_folder
    from fembearing.cli.console import out, print_json, shown_progress
    from fembearing.quantities import SYSTEMS
    from fembearing.report.film_folder import film_content, write_film
    from fembearing.report.tables.film import film_table
    from fembearing.report.terminal.table import show
    from fembearing.verify.film.scene_film import film_of

    with shown_progress() as progress, nullcontext() if folder is None else new_folder(folder) as place:
        result = film_of(
            given,
            pair=pair,
            load=force,
            inner_speed=turning,
            tolerance=limit,
            compliance=compliance,
            progress=progress,
        )
        if place is not None:
            write_film(result, place)
    if as_json:
        print_json(film_content(result.numbers))
    else:
        show(out, film_table(result.numbers, SYSTEMS[given.report.units]))
        print_warnings(result.numbers.warnings)
    name, uncertainty = result.numbers.worst
    if uncertainty <= limit:
        raise typer.Exit(DONE)
    raise typer.Exit(
        complain(
            f"not solved to {percent_of(limit, 2)}: the {name.replace('_', ' ')} has an uncertainty of "
            f"{percent_of(uncertainty, 2)}; give a larger --tolerance",
            NOT_SOLVED,
        )
    )
