"""`fembearing creep`."""

from typing import Annotated

import typer

from fembearing.cli.options import (
    AsJson,
    Bodies,
    GivenAccurate,
    Output,
    SceneName,
    Talk,
    read_load,
    read_option,
)
from fembearing.cli.status import reached

Load = Annotated[
    str | None,
    typer.Option(help='Load of the heaviest ball, for example "620 N"; scales all loads (default: from the scene).'),
]
Friction = Annotated[
    str | None, typer.Option(help="Friction coefficient of both races, for example 0.1 (default: from the scene).")
]


def creep(
    given: GivenAccurate,
    output: Output,
    talk: Talk,
    scene: SceneName = None,
    load: Load = None,
    friction: Friction = None,
    compliance: Bodies = "half-space",
    as_json: AsJson = False,
) -> None:
    """Solve stick and slip of a ball on both races and compare the formulas for spin, conformity and creep.

    The accuracy is that of the torque by sliding. Exit status 0: required accuracy reached, for any difference of the
    formulas; 2: input error; 3: accuracy not reached.
    """
    read = given.scene(scene)
    coefficient = None if friction is None else read_option("--friction", friction, "friction.coefficient")
    from analytic.units import SYSTEMS
    from fembearing.check.creep.scene_creep import creep_of
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import document
    from fembearing.report.document import Section
    from fembearing.report.files import write_creep
    from fembearing.report.sections.creep import creep_table
    from fembearing.report.terminal import print_sections

    trouble = None
    with talk.progress() as progress, output.opened() as place:
        result = creep_of(read, load=read_load(load), friction=coefficient, compliance=compliance, progress=progress)
        if place is not None:
            trouble = write_creep(result, place)
    numbers = result.numbers
    if as_json:
        print_json(document("creep", numbers))
    else:
        print_sections(out, [Section("", [creep_table(numbers, SYSTEMS[read.report.units])])])
    pictures = () if trouble is None else (f"no pictures: {trouble}",)
    talk.warn((*(() if as_json else numbers.warnings), *pictures), read=read.warnings)
    raise typer.Exit(reached(read.tolerance, "torque by sliding", numbers.relative_uncertainty))
