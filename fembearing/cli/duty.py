"""`fembearing duty`."""

from typing import Annotated

import typer

from fembearing.cli.added_options import with_options
from fembearing.cli.assumed import tell_assumed
from fembearing.cli.options import (
    STANDARD_INPUT,
    AsJson,
    Folder,
    read_by_temperature,
    require_folder_name,
    scene_names_like,
)
from fembearing.cli.scene_options import OPTIONS, SETTINGS, given_options, given_settings
from fembearing.cli.status import STANDING_STATUS, print_warnings

SceneName = Annotated[
    str,
    typer.Argument(
        metavar="SCENE",
        help="Scene file (TOML), - for standard input, or a bearing of the catalog, for example 6206.",
        autocompletion=scene_names_like,
    ),
]
CycleFile = Annotated[
    str,
    typer.Argument(metavar="CYCLE", help="CSV file of the steps: duration and operating columns, each with its unit."),
]


@with_options(OPTIONS | SETTINGS)
def duty(scene: SceneName, cycle: CycleFile, folder: Folder = None, as_json: AsJson = False) -> None:
    """Friction energy of a duty cycle, with mean and worst torque, each with its 95 % interval.

    Columns of the cycle: duration, and one or more of inner_speed, axial_load, radial_load and temperature. The scene
    gives the values without a column; a bearing of the catalog has no usual load beside a column of loads. With
    [thermal] in the scene, the mean power determines the oil temperature.
    """
    require_folder_name(folder)
    settings, options = given_settings(), given_options()
    from contextlib import nullcontext

    from analytic.prediction.duty import cycle_with_torques
    from analytic.scenefile.assumption import assumptions
    from analytic.scenefile.cycle import read_cycle
    from analytic.writing import new_folder
    from fembearing.cli.console import out, print_json
    from fembearing.plain_types import plain
    from fembearing.report.duty_folder import duty_file, write_duty
    from fembearing.report.tables.duty import cycle_table, steps_table
    from fembearing.report.terminal.table import show
    from fembearing.verify.torque.worst import worst_standing

    steps = read_cycle(cycle)
    found = read_by_temperature(scene, settings=settings, options=options, columns=vars(steps))
    with nullcontext() if folder is None else new_folder(folder) as place:
        result, torques = cycle_with_torques(found, steps)
        standing = worst_standing(torques)
        if place is not None:
            write_duty(result, standing, found.scene, place)
    if as_json:
        print_json(plain(duty_file(result, standing)))
    else:
        show(out, steps_table(result))
        show(out, cycle_table(result))
        out.tell(standing.line("turning steps"))
        if scene != STANDARD_INPUT:
            told = assumptions(scene, found.scene, settings=settings, options=options, columns=vars(steps))
            settled = "lubricant.temperature = "  # by friction, with [thermal]
            tell_assumed(each for each in told if found.thermal is None or not each.startswith(settled))
        if folder is not None:
            out.tell(f"folder: {folder}")
    print_warnings(result.warnings)
    raise typer.Exit(STANDING_STATUS[standing.word])
