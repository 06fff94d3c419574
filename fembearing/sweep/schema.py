"""The JSON Schema of the grid file of a sweep, made from the tables of a scene file."""

from analytic.scenefile.schema import DIALECT, Schema, table_schema
from analytic.scenefile.tables import SceneTable
from fembearing.sweep.grid import MOST_COUNT, OF_CONTACT, OWN_QUANTITIES, OWN_WORDS, RANGE, SAMPLES

STEPS: Schema = {
    "type": "object",
    "additionalProperties": False,
    "properties": {
        "from": {"type": ["string", "number"]},
        "to": {"type": ["string", "number"]},
        "count": {"type": "integer", "minimum": 2, "maximum": MOST_COUNT},
        "spacing": {"enum": ["linear", "log"], "default": "linear"},
    },
    "required": list(RANGE[:3]),
}
BY_STEPS: Schema = {"$ref": "#/definitions/steps"}


def grid_schema() -> Schema:
    """The schema of a whole grid file."""
    own = {key: {"enum": list(words)} for key, words in OWN_WORDS.items()}
    own |= {
        key: {"type": ["string", "number"], "description": dimension.accepted}
        for key, dimension in OWN_QUANTITIES.items()
    }
    scene = table_schema(SceneTable, whole=False)  # axes may set what it lacks
    axes = _axes(scene) | {"patternProperties": {r"\.": {"anyOf": [_list({}), BY_STEPS]}}}  # a whole key in quotes
    axes["properties"] |= {key: _axis(value) for key, value in own.items() if key != "accuracy"}
    named = {"type": "string", "description": "give the path of a scene file, a built-in scene or a bearing"}
    top = {key: own[key] for key in OF_CONTACT}
    return {
        "$schema": DIALECT,
        "title": "fembearing grid",
        "type": "object",
        "additionalProperties": False,
        "properties": {
            "what": {"enum": ["torque", "contact"], "default": "torque"},
            "scene": {"anyOf": [named, scene]},
            SAMPLES: {"type": "integer", "minimum": 1, "description": "of the 95 % interval of the torque"},
            **top,
            "axes": axes | {"description": "one line for each key that varies", "minProperties": 1},
        },
        "required": ["scene", "axes"],
        "definitions": {"steps": STEPS},
    }


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
