"""`fembearing init`."""

import json
import os
import re
import shlex
from pathlib import Path
from typing import Annotated

import typer

from fembearing.cli.options import Force, Talk, Usual, bearing_names_like


def init(
    given: Usual,
    talk: Talk,
    designation: Annotated[
        str,
        typer.Argument(
            metavar="DESIGNATION",
            help="Bearing of the catalog, for example 6206, 7208B or 6305-2RS/C3.",
            autocompletion=bearing_names_like,
        ),
    ],
    file: Annotated[
        Path | None, typer.Option("--out", "-o", help="New scene file (default: DESIGNATION.toml in this folder).")
    ] = None,
    force: Force = False,
) -> None:
    """Write a scene file for a bearing of the catalog, ready to run and to edit."""
    from analytic.scenefile.read import parse_scene
    from analytic.scenefile.schema import scene_schema
    from analytic.scenefile.setting import given_values
    from analytic.scenefile.template import SCHEMA_NAME, scene_text
    from analytic.writing import new_file
    from fembearing.cli.console import out

    _, notes = given_values({}, given.options)
    text = scene_text(designation, **given.options)
    parse_scene(text, origin="init")  # so that a scene with a mistake in it is not written
    path = Path(re.sub(r"[^\w.+-]+", "-", designation.strip()) + ".toml") if file is None else file
    with new_file(path, force=force) as apart:
        apart.write_text(text, "utf-8")
    schema = path.with_name(SCHEMA_NAME)
    if not os.path.lexists(schema):
        with new_file(schema) as apart:
            apart.write_text(json.dumps(scene_schema(), indent=1, ensure_ascii=False), "utf-8")
    talk.warn(notes, read=notes)
    out.tell(f"written: {path}; schema for editors: {schema}")
    out.tell(f"next: fembearing torque {shlex.quote(str(path))}")
