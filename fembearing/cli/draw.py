"""`fembearing draw`."""

import re
from pathlib import Path
from typing import Annotated

import typer

from fembearing.cli.added_options import with_options
from fembearing.cli.options import SceneName, read_scene
from fembearing.cli.scene_options import SETTINGS, given_settings
from fembearing.cli.status import print_warnings


@with_options(SETTINGS)
def draw(
    scene: SceneName = None,
    file: Annotated[
        Path | None,
        typer.Option("--out", "-o", help="New file: .svg, .png or .pdf (default: BEARING.svg in this folder)."),
    ] = None,
) -> None:
    """Draw the bearing of a scene to scale, with dimensions and their origins, to find input errors."""
    given = read_scene(scene, settings=given_settings())
    from fembearing.cli.console import out
    from fembearing.report.drawing import draw_bearing

    target = Path(re.sub(r"[^\w.+-]+", "-", given.bearing.name.strip()) + ".svg") if file is None else file
    draw_bearing(given, out=target)
    print_warnings(given.warnings)
    out.tell(f"file: {target}")
