"""`fembearing film`."""

from typing import Annotated, Literal

import typer

from fembearing.cli.options import (
    AsJson,
    Bodies,
    GivenAccurate,
    Load,
    Output,
    SceneName,
    Talk,
    read_load,
)
from fembearing.cli.status import reached

RaceName = Annotated[Literal["inner", "outer"], typer.Option("--pair", help="Race of the contact.")]


def film(
    given: GivenAccurate,
    output: Output,
    talk: Talk,
    scene: SceneName = None,
    pair: RaceName = "inner",
    load: Load = None,
    compliance: Bodies = "half-space",
    as_json: AsJson = False,
) -> None:
    """Solve the lubricated contact of a ball on a race and compare the formulas for film and rolling.

    The accuracy is that of film and rolling force. Exit status 0: required accuracy reached, for any difference of the
    formulas; 2: input error; 3: accuracy not reached.
    """
    read = given.scene(scene)
    from analytic.units import SYSTEMS
    from fembearing.check.film.scene_film import film_of
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import document
    from fembearing.report.document import Section
    from fembearing.report.files import solution_files, write_all
    from fembearing.report.sections.film import film_table
    from fembearing.report.terminal import print_sections

    with talk.progress() as progress, output.opened() as place:
        result = film_of(read, pair=pair, load=read_load(load), compliance=compliance, progress=progress)
        if place is not None:
            write_all(solution_files(result), place)
    if as_json:
        print_json(document("film", result.numbers))
    else:
        print_sections(out, [Section("", [film_table(result.numbers, SYSTEMS[read.report.units])])])
        talk.warn(result.numbers.warnings, read=read.warnings)
    raise typer.Exit(reached(read.tolerance, *result.numbers.worst))
