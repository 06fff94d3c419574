"""The JSON Schema of a scene file, by which an editor completes keys and marks mistakes; made from the tables.

An editor knows less than the reader: of a quantity it sees that a number
and a unit are there, not whether the unit fits.
"""

from types import NoneType, UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BeforeValidator
from pydantic.fields import FieldInfo

from analytic import catalog
from analytic.scenefile.keys import accepted
from analytic.scenefile.quantity import NUMBER, Dimension
from analytic.scenefile.spread_tables import Spread
from analytic.scenefile.table import Table, Whole
from analytic.scenefile.tables import BearingTable, CageTable, GrooveTable, MaterialTable, SceneTable
from analytic.scenefile.viscosity import Viscosity

DIALECT = "http://json-schema.org/draft-07/schema#"  # that editors of TOML know
FILLED = (BearingTable, GrooveTable, CageTable)  # by the catalog: no key of these tables is required
WITH_UNIT = rf'^ *{NUMBER} *(?:1? */ *)?[A-Za-zµμ°Ω"][^,]*$'
PERCENT = rf"^ *{NUMBER} *%$"
WORDS = {str: "string", bool: "boolean", int: "integer", float: "number"}
Schema = dict[str, Any]


def scene_schema() -> Schema:
    """The schema of a whole scene file."""
    return {"$schema": DIALECT, "title": "fembearing scene", **table_schema(SceneTable)}


def table_schema(table: type[Table], *, whole: bool = True) -> Schema:
    """The schema of a table; whole : whether keys without a default must be there."""
    properties = {name: field_schema(field, whole=whole) for name, field in table.model_fields.items()}
    required = [name for name, field in table.model_fields.items() if field.is_required()]
    result: Schema = {"type": "object", "additionalProperties": False, "properties": properties}
    return result | {"required": required} if whole and required and table not in FILLED else result


def field_schema(field: FieldInfo, *, whole: bool = True) -> Schema:
    """The schema of what a key takes, with range and example in words."""
    words = accepted(field)
    default = field.default
    result = {"description": words} if words else {}
    result |= _value(field.rebuild_annotation(), whole)
    plain = isinstance(default, str | bool) or (isinstance(default, int) and result.get("type") == "integer")
    return result | ({"default": default} if plain else {})


def _value(kind: Any, whole: bool) -> Schema:
    """The schema of a value of this annotation."""
    origin, parts = get_origin(kind), get_args(kind)
    if origin is Annotated:
        for note in kind.__metadata__:
            if isinstance(note, Viscosity):
                one = _quantity(note)
                return _one_of([one, {"type": "array", "items": one, "minItems": 2, "maxItems": 2}])
            if isinstance(note, Dimension):
                words = [part for part in get_args(parts[0]) if get_origin(part) is Literal]
                return _one_of([_quantity(note), *(_value(part, whole) for part in words)])
            if isinstance(note, Whole):
                return {"type": "integer", "minimum": note.low, "maximum": note.high}
        inside = _value(parts[0], whole)
        by_name = parts[0] is MaterialTable and any(isinstance(note, BeforeValidator) for note in kind.__metadata__)
        names = [{"enum": list(catalog.names("materials"))}, {"type": "string"}]  # each has other spellings too
        if CageTable in get_args(parts[0]):
            return _one_of([{"enum": ["none"]}, inside])
        return _one_of([*names, inside]) if by_name else inside
    if origin in (Union, UnionType):
        return _one_of([_value(part, whole) for part in parts if part is not NoneType])
    if origin is list:
        inside = _value(parts[0], whole)
        return _one_of([inside, {"type": "array", "items": inside, "minItems": 1}])
    if origin is tuple:
        inside = [_value(part, whole) for part in parts]
        return {"type": "array", "items": inside, "minItems": len(inside), "maxItems": len(inside)}
    if origin is dict:
        return {"type": "object"}
    if origin is Literal:
        return {"enum": list(parts)}
    if issubclass(kind, Table):
        return table_schema(kind, whole=whole)
    return {"type": WORDS[kind]}


def _one_of(choices: list[Schema]) -> Schema:
    return choices[0] if len(choices) == 1 else {"anyOf": choices}


def _quantity(dimension: Dimension) -> Schema:
    if dimension.unit:
        quantity = {"type": "string", "pattern": WITH_UNIT}
        takes_share = isinstance(dimension, Spread) and dimension.takes_share
        return _one_of([quantity, {"type": "string", "pattern": PERCENT}]) if takes_share else quantity
    number = {"type": "number", "minimum": dimension.low, "maximum": dimension.high}
    return {"anyOf": [number, {"type": "string", "pattern": PERCENT}]}
