"""`fembearing duty`."""

from typing import Annotated

import typer

from fembearing.cli.options import AsJson, Given, Named, Output, Talk
from fembearing.cli.status import STANDING_STATUS

CycleFile = Annotated[
    str,
    typer.Argument(
        metavar="CYCLE", help="CSV or .xlsx file of the steps: duration and operating columns, each with its unit."
    ),
]


def duty(given: Given, output: Output, talk: Talk, scene: Named, cycle: CycleFile, as_json: AsJson = False) -> None:
    """Friction energy of a duty cycle, with mean and worst torque, each with its 95 % interval.

    Columns of the cycle: duration, and one or more of inner_speed, axial_load, radial_load and temperature. The scene
    gives the values without a column; a bearing of the catalog has no usual load beside a column of loads. With
    [thermal] in the scene, the mean power determines the oil temperature.
    """
    from analytic.prediction.duty import cycle_with_torques
    from analytic.scenefile.columns import read_cycle
    from analytic.scenefile.find import require_no_data
    from analytic.standing import worst_standing
    from analytic.units import SYSTEMS
    from fembearing.cli.console import out, print_json, tell_assumed
    from fembearing.plain_types import document
    from fembearing.report.files import duty_files, write_all
    from fembearing.report.sections.duty import duty_section
    from fembearing.report.terminal import print_sections

    require_no_data(scene)
    steps = read_cycle(cycle)
    found = given.by_temperature(scene, columns=vars(steps))
    with output.opened() as place:
        result, torques = cycle_with_torques(found, steps)
        standing = worst_standing(torques)
        if place is not None:
            write_all(duty_files(result, standing, found.scene), place)
    if as_json:
        print_json(document("duty", result, standing=standing))
    else:
        print_sections(out, [duty_section(result, SYSTEMS[found.scene.report.units])])
        out.tell(standing.line("turning steps"))
        settled = {"lubricant.temperature"} if found.thermal else set()  # by friction
        tell_assumed({key: value for key, value in found.scene.usual.items() if key not in settled})
        if output.folder is not None:
            out.tell(f"folder: {output.folder}")
    talk.warn(result.warnings, read=(*found.scene.warnings, *steps.warnings))
    raise typer.Exit(STANDING_STATUS[standing.word])
