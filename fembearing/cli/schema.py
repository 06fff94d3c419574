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
    TORQUE = "torque"
    COMPARE = "compare"
    DUTY = "duty"


def schema(
    file: Annotated[
        File,
        typer.Argument(
            help="scene, grid: input files; report: report.json; torque: torque --json; compare: compare --json; "
            "duty: duty --json."
        ),
    ],
) -> None:
    """Print the JSON Schema of a scene or grid, for the completion of keys in editors, or of a JSON result."""
    typer.echo(json.dumps(_schema_of(file), indent=1, ensure_ascii=False))


def _schema_of(file: File) -> dict[str, Any]:
    """Each import is slow, and needed by one file only."""
    if file is File.SCENE:
        from analytic.scenefile.schema import scene_schema

        return scene_schema()
    if file is File.GRID:
        from fembearing.sweep.schema import grid_schema

        return grid_schema()
    from fembearing.report.schema import comparison_schema, duty_schema, report_schema, torque_schema

    results = {
        File.REPORT: report_schema,
        File.TORQUE: torque_schema,
        File.COMPARE: comparison_schema,
        File.DUTY: duty_schema,
    }
    return results[file]()
