"""`fembearing export`."""

import re
from pathlib import Path
from typing import Annotated, Any, Literal

import typer

from fembearing.cli.added_options import with_options
from fembearing.cli.options import BUILTIN, STANDARD_INPUT, SceneName, read_by_temperature
from fembearing.cli.scene_options import OPTIONS, SETTINGS, given_options, given_settings
from fembearing.cli.status import STANDING_STATUS, print_warnings

RANGES: dict[str, Any] = {  # options that are a range here, in place of those of one torque
    "axial_load": Annotated[
        str | None, typer.Option(help='Axial load, for example "500 N", or a range "100 N to 1 kN in 5 log".')
    ],
    "radial_load": Annotated[
        str | None, typer.Option(help='Radial load, for example "2 kN", or a range "1 kN to 5 kN in 5".')
    ],
    "speed": Annotated[
        str | None,
        typer.Option(
            help='Speed of the inner ring, for example "0 rpm to 6000 rpm in 15" (default: 0 to twice the speed of the '
            "scene)."
        ),
    ],
    "temperature": Annotated[
        str | None, typer.Option(help='Oil temperature, for example "70 degC", or a range "40 degC to 100 degC in 4".')
    ],
}


@with_options(OPTIONS | RANGES | SETTINGS)
def export(
    to: Annotated[
        Literal["csv", "netcdf", "modelica", "simscape", "ross", "fmu"], typer.Option("--to", help="Output format.")
    ],
    scene: SceneName = None,
    file: Annotated[
        Path | None,
        typer.Option("--out", "-o", help="New file (default: named after bearing and format)."),
    ] = None,
) -> None:
    """Write the torque over speed, load and temperature for another program, or the stiffness for rotor dynamics.

    csv, netcdf: maps with 95 % interval. modelica, simscape: friction over speed. fmu: a unit of FMI 2.0 (needs a C
    compiler). ross: stiffness over speed. Loads and temperature are one value or a range.
    """
    from analytic.scenefile.find import find_scene
    from fembearing.cli.console import out, shown_progress
    from fembearing.formats.axes import end_of
    from fembearing.formats.choice import FORMATS, export_of

    options = given_options()
    over = {name: options[name] for name in RANGES if name in options}
    name = BUILTIN if scene is None else scene
    if name != STANDARD_INPUT and find_scene(name).designation is not None:
        ends = {key: end_of(key, text) for key, text in over.items()}
        found = read_by_temperature(name, settings=given_settings(), options=options | ends)
    else:  # a scene that says its own loads: an option is an axis of the table alone
        others = {key: text for key, text in options.items() if key not in RANGES}
        found = read_by_temperature(scene, settings=given_settings(), options=others)
    if file is None:
        word = re.sub(r"\W+", "_", found.scene.bearing.name).strip("_")
        file = Path(f"friction_{word}{FORMATS[to].ending}")
    with shown_progress() as progress:
        done = export_of(found, to=to, out=file, over=over, progress=progress)
    print_warnings(done.warnings)
    out.tell(f"written: {done.file}; {done.axes}")
    for note in done.notes:
        out.tell(f"note: {note}")
    out.tell(done.standing.line("points"))
    raise typer.Exit(STANDING_STATUS[done.standing.word])
