"""`fembearing compare`."""

from typing import Annotated

import typer

from fembearing.cli.options import AsJson, Given, Named, Output, Samples, Talk
from fembearing.cli.status import STATUS

Data = Annotated[
    str | None,
    typer.Argument(
        metavar="DATA",
        help="CSV or .xlsx file of measured torques, columns with units (default: from [measured] of the scene).",
    ),
]
Seed = Annotated[int, typer.Option(help="Seed of the samples of the intervals.")]


def compare(
    given: Given,
    output: Output,
    talk: Talk,
    scene: Named,
    data: Data = None,
    samples: Samples = None,
    seed: Seed = 1,
    as_json: AsJson = False,
) -> None:
    """Compare the computed torque with measured torques: error, uncertainty and verdict of each.

    Give the scene and the file, or the scene alone if its table [measured] names the file. Exit status 0: every
    measured torque lies in its 95 % interval; 1: at least one lies outside; 2: input error.
    """
    from analytic.units import SYSTEMS
    from fembearing.check.measured.comparison import compare_measured
    from fembearing.cli.console import out, print_json, tell_assumed
    from fembearing.plain_types import document
    from fembearing.report.files import compared_files, write_all
    from fembearing.report.sections.measured import measured_sections
    from fembearing.report.terminal import print_sections

    read = given.scene(scene, measured=data)
    with talk.progress() as progress, output.opened() as place:
        result = compare_measured(read, samples=samples, seed=seed, progress=progress)
        if place is not None:
            write_all(compared_files(result, read), place)
    if as_json:
        print_json(document("compare", result))
    else:
        print_sections(out, measured_sections(result, SYSTEMS[read.report.units]))
        tell_assumed(read.usual)
        of_file = () if read.measured is None else read.measured.warnings
        talk.warn(result.warnings, read=(*read.warnings, *of_file))
        if output.folder is not None:
            out.tell(f"report: {output.folder / 'compare.html'}")
    raise typer.Exit(STATUS[result.verdict])
