"""`fembearing schema`."""

import json
from enum import StrEnum
from typing import Annotated, Any

import typer


class File(StrEnum):
    """The files that have a schema."""

    SCENE = "scene"
    GRID = "grid"
    REPORT = "report"


def schema(
    file: Annotated[File, typer.Argument(help="scene or grid, which people write; report is report.json.")],
) -> None:
    """Print the JSON Schema of a file: scene and grid, by which editors complete keys, or a JSON result."""
    typer.echo(json.dumps(_schema_of(file), indent=1, ensure_ascii=False))


def _schema_of(file: File) -> dict[str, Any]:
    """Each import is slow, and needed by one file only."""
    if file is File.SCENE:
        from analytic.scenefile.schema import scene_schema

        return scene_schema()
    if file is File.GRID:
        from fembearing.sweep.schema import grid_schema

        return grid_schema()
    from fembearing.report.document.report import Report

    return Report.model_json_schema()
