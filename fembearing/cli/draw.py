"""`fembearing draw`."""

import re
from pathlib import Path
from typing import Annotated

import typer

from fembearing.cli.options import Force, Given, SceneName, Talk


def draw(
    given: Given,
    talk: Talk,
    scene: SceneName = None,
    file: Annotated[
        Path | None,
        typer.Option("--out", "-o", help="New file: .svg, .png or .pdf (default: BEARING.svg in this folder)."),
    ] = None,
    force: Force = False,
) -> None:
    """Draw the bearing of a scene to scale, with dimensions and their origins, to find input errors."""
    read = given.scene(scene)
    from fembearing.cli.console import out
    from fembearing.report.figures.bearing import draw_bearing

    target = Path(re.sub(r"[^\w.+-]+", "-", read.bearing.name.strip()) + ".svg") if file is None else file
    draw_bearing(read, out=target, force=force)
    talk.warn(read.warnings, read=read.warnings)
    out.tell(f"file: {target}")
