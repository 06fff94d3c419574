"""The JSON Schema of the grid file of a sweep, made from the tables of a grid and of a scene file."""

from analytic.scenefile.keys import scene_key, scene_table
from analytic.scenefile.schema import DIALECT, Schema, entry_schema, table_schema
from fembearing.sweep.grid import EXAMPLE, GRID, OF_AXES, STEPS

BY_STEPS: Schema = {"$ref": "#/definitions/steps"}


def grid_schema() -> Schema:
    """The schema of a whole grid file."""
    grid = table_schema(GRID)
    scene = table_schema(scene_table(), whole=False)  # axes may set what it lacks
    axes = _axes(scene) | {"patternProperties": {r"\.": {"anyOf": [_list({}), BY_STEPS]}}}  # a whole key in quotes
    axes["properties"] |= {key: _axis(entry_schema(scene_key(key, root=GRID))) for key in OF_AXES}
    words = {"description": grid["properties"]["scene"]["description"]}
    grid["properties"] |= {
        "scene": words | {"anyOf": [{"type": "string"}, scene]},
        "axes": axes | {"description": EXAMPLE, "minProperties": 1},
    }
    return {"$schema": DIALECT, "title": "fembearing grid", **grid, "definitions": {"steps": table_schema(STEPS)}}


def _axes(table: Schema) -> Schema:
    """The keys of a table, each with a list of values or with steps in place of its value."""
    keys = {
        name: _axes(inside) if inside.get("type") == "object" else _axis(inside)
        for name, inside in table["properties"].items()
    }
    return {"type": "object", "additionalProperties": False, "properties": keys}


def _axis(value: Schema) -> Schema:
    words = {"description": value["description"]} if "description" in value else {}
    one = {key: part for key, part in value.items() if key not in ("description", "default")}
    return words | {"anyOf": [_list(one), BY_STEPS]}


def _list(value: Schema) -> Schema:
    return {"type": "array", "items": value, "minItems": 1}
