"""The JSON Schema of a scene file, by which an editor completes keys and marks mistakes; made from the declared keys.

An editor knows less than the reader: of a quantity it sees that a number and a unit are there, not whether they fit.
"""

from typing import Any

from analytic import catalog
from analytic.declared import REQUIRED, Key, Kind, Switch, Table, Whole, Word
from analytic.quantity import NUMBER, Dimension, QuantityOrWord, Series
from analytic.scenefile.keys import scene_table
from analytic.scenefile.kinds import Direction, Extent, RowOf, Solid, Spread, Viscosity

DIALECT = "http://json-schema.org/draft-07/schema#"  # that editors of TOML know
FILLED = ("bearing", "bearing.inner", "bearing.outer", "cage")  # by the catalog: no key of these tables is required
WITH_UNIT = rf'^ *{NUMBER} *(?:1? */ *)?[A-Za-zµμ°Ω"][^,]*$'
PERCENT = rf"^ *{NUMBER} *%$"
Schema = dict[str, Any]


def scene_schema() -> Schema:
    """The schema of a whole scene file."""
    return {"$schema": DIALECT, "title": "fembearing scene", **table_schema(scene_table())}


def table_schema(table: Table, *, whole: bool = True) -> Schema:
    """The schema of a table; whole : whether keys without a default must be there."""
    result: Schema = {
        "type": "object",
        "additionalProperties": False,
        "properties": {name: entry_schema(entry, whole=whole) for name, entry in table.keys.items()},
    }
    needed = [name for name, entry in table.keys.items() if entry.default is REQUIRED]
    return result | {"required": needed} if whole and needed and table.path not in FILLED else result


def entry_schema(entry: Key | Table, *, whole: bool = True) -> Schema:
    """The schema of what a key or a table takes, with range and example in words."""
    if isinstance(entry, Table):
        inside = table_schema(entry, whole=whole)
        words = {"description": entry.hint} if entry.hint else {}
        return words | (_any_of([{"enum": [entry.word]}, inside]) if entry.word else inside)
    dimension = entry.dimension
    words = (entry.meaning, entry.accepted, "" if dimension is None else f"from {dimension.span}")
    result = {"description": "; ".join(filter(None, words))} | _value(entry.kind, whole)
    default = entry.default
    plain = isinstance(default, str | bool) or (isinstance(default, int) and result.get("type") == "integer")
    return result | ({"default": default} if plain else {})


def _value(kind: Kind, whole: bool) -> Schema:
    """The schema of a value of this kind."""
    match kind:
        case Solid():
            names = [{"enum": list(catalog.names("materials"))}, {"type": "string"}]  # each has other spellings too
            return _any_of([*names, table_schema(kind.inside, whole=whole)])
        case Viscosity():
            one = _quantity(kind.of)
            return _any_of([one, {"type": "array", "items": one, "minItems": 2, "maxItems": 2}])
        case Series():
            one = _quantity(kind.of)
            return _any_of([one, {"type": "array", "items": one, "minItems": 1}])
        case Spread():
            one = _quantity(kind.of)
            takes_share = kind.takes_share and kind.of.unit
            return _any_of([one, {"type": "string", "pattern": PERCENT}]) if takes_share else one
        case QuantityOrWord():
            return _any_of([_quantity(kind), {"enum": list(kind.words)}])
        case Extent():
            return _any_of([_quantity(kind), {"type": "string", "pattern": WITH_UNIT}])
        case Dimension():
            return _quantity(kind)
        case Word() | RowOf():
            return {"enum": list(kind.words)}
        case Whole():
            return {"type": "integer", "minimum": kind.low, "maximum": kind.high}
        case Switch():
            return {"type": "boolean"}
        case Direction():
            return {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3}
        case _:
            return {"type": "string"}


def _any_of(choices: list[Schema]) -> Schema:
    return choices[0] if len(choices) == 1 else {"anyOf": choices}


def _quantity(dimension: Dimension) -> Schema:
    if dimension.unit:
        return {"type": "string", "pattern": WITH_UNIT}
    number = {"type": "number", "minimum": dimension.low, "maximum": dimension.high}
    return {"anyOf": [number, {"type": "string", "pattern": PERCENT}]}
