"""`fembearing export`."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

import typer

from fembearing.cli.options import BUILTIN, STANDARD_INPUT, Force, Given, SceneName, Talk
from fembearing.cli.status import STANDING_STATUS

if TYPE_CHECKING:
    from collections.abc import Iterator, Mapping

RANGES = ("axial_load", "radial_load", "speed", "temperature")


def export(
    given: Given,
    talk: Talk,
    to: Annotated[
        Literal["csv", "netcdf", "modelica", "simscape", "ross", "fmu"], typer.Option("--to", help="Output format.")
    ],
    scene: SceneName = None,
    file: Annotated[
        Path | None, typer.Option("--out", "-o", help="New file (default: named after bearing and format).")
    ] = None,
    force: Force = False,
) -> None:
    """Write the torque over speed, load and temperature for another program, or the stiffness for rotor dynamics.

    csv, netcdf: maps with 95 % interval. modelica, simscape: friction over speed. fmu: a unit of FMI 2.0 (needs a C
    compiler). ross: stiffness over speed. Loads and temperature are one value or a range;
    without --speed the table goes from 0 to the usual limit of n d_m, or to a faster speed of the scene.
    """
    from analytic.scenefile.find import find_scene
    from fembearing.cli.console import out
    from fembearing.formats.axes import end_of
    from fembearing.formats.choice import FORMATS, export_of
    from fembearing.formats.names import friction_name

    over = {name: text for name, text in given.options.items() if name in RANGES}
    name = BUILTIN if scene is None else scene
    if name != STANDARD_INPUT and find_scene(name).bearing is not None:
        found = replace(given, **{key: end_of(key, text) for key, text in over.items()}).by_temperature(name)
    else:  # a scene that says its own loads: an option is an axis of the table alone
        found = replace(given, **dict.fromkeys(over)).by_temperature(scene)
    if file is None:
        file = Path(friction_name(found.scene.bearing.name) + FORMATS[to].ending)
    with talk.progress() as progress:
        done = export_of(found, to=to, out=file, force=force, over=over, progress=progress)
    read = dict.fromkeys((*found.scene.warnings, *_notes(over)))
    talk.warn(dict.fromkeys((*read, *done.warnings)), read=[*read])
    out.tell(f"written: {done.file}; {done.axes}")
    for note in done.notes:
        out.tell(f"note: {note}")
    out.tell(done.standing.line("points"))
    raise typer.Exit(STANDING_STATUS[done.standing.word])


def _notes(over: "Mapping[str, str]") -> "Iterator[str]":
    """How the axes were read."""
    from analytic.given import KEYS
    from analytic.scenefile.setting import read_setting

    for name, text in over.items():
        yield from read_setting(KEYS[name], text)[1]
