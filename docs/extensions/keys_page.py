"""The page of all keys of a scene file, from the tables that read it."""

from collections.abc import Iterator
from typing import get_origin

from pydantic.fields import FieldInfo
from pydantic_core import PydanticUndefined

from analytic.scenefile.keys import scene_key
from analytic.scenefile.quantity import Dimension, QuantityOrWord
from analytic.scenefile.spread_tables import Spread
from analytic.scenefile.table import Table, table_of
from analytic.scenefile.tables import CageTable, MaterialTable, SceneTable
from analytic.scenefile.viscosity import Viscosity
from docs.extensions.annotations import with_parts, words_in
from docs.extensions.tables import code, table

HEAD = """\
# Keys of a scene

Made from the tables that read a scene: every key, what it takes, its range and its default. [Scenes](../scenes.md)
says what the keys mean, and which of them exclude each other. A quantity may have any unit of its kind; range and
default are in the one that is shown. A default of "none" means that the key may be left out: another key, the catalogue
or the oil's name then gives the value, or the part of the model that needs it is not computed. In `[bearing]` and
`[cage]` the catalogue supplies every required key.
"""
COLUMNS = ["key", "unit, or what it takes", "range", "default", "example"]
PLAIN = {int: "whole number", bool: "`true` or `false`", str: "text"}


def keys_page() -> str:
    """The page in Markdown."""
    return "\n".join([HEAD, *sections(SceneTable, "")])


def sections(of: type[Table], path: str) -> Iterator[str]:
    """A heading and a table of keys for each table of a scene, the outer ones first."""
    heading = f"`[{path}]`" if path else "Top of the file"
    rows = [row(f"{path}.{name}" if path else name, field) for name, field in of.model_fields.items() if takes(field)]
    if rows:
        yield f"## {heading}\n\n{table(COLUMNS, rows)}"
    for name, field in of.model_fields.items():
        inside = table_of(field)
        if inside is not None and inside is not MaterialTable:
            yield from sections(inside, f"{path}.{name}" if path else name)
        elif inside is MaterialTable and name == "ball_material":  # once for all materials
            yield from sections(inside, f"{path}.{name}")


def takes(field: FieldInfo) -> bool:
    """Whether the key takes a value: a table of keys has rows of its own, unless a word may stand in its place."""
    inside = table_of(field)
    return inside is None or inside is MaterialTable or bool(field.metadata)


def row(path: str, field: FieldInfo) -> list[str]:
    dimension = scene_key(path).dimension
    name = code(path.rpartition(".")[2])
    if dimension is None:
        words = words_of(field)
        return [name, words, "", code_default(field), ""]
    unit = dimension.shown_unit or "pure number"
    series = ", or a list" if scene_key(path).in_series else ""
    return [name, f"{unit}{series}", ranged(dimension), shown(dimension, field), code(dimension.example)]


def ranged(dimension: Dimension) -> str:
    words = f", or {', '.join(map(code, dimension.words))}" if isinstance(dimension, QuantityOrWord) else ""
    share = ", or a percentage" if isinstance(dimension, Spread) and dimension.takes_share else ""
    return dimension.span.removesuffix(f" {dimension.shown_unit}") + words + share


def shown(dimension: Dimension, field: FieldInfo) -> str:
    """The default of a quantity in the unit of its example."""
    given = field.default
    if field.is_required():
        return "required"
    if isinstance(given, list):
        given = given[0]
    if isinstance(given, float | int):
        return code(f"{dimension.written(float(given))} {dimension.shown_unit}".strip())
    return "none" if given is None else code(str(given))


def code_default(field: FieldInfo) -> str:
    given = field.default
    if field.is_required() or given is PydanticUndefined:
        return "required"
    return "none" if given is None else code(str(given).lower() if isinstance(given, bool) else str(given))


def words_of(field: FieldInfo) -> str:
    """What a key takes that is no quantity."""
    if table_of(field) is MaterialTable:
        return "name of a material, or a table"
    if table_of(field) is CageTable:
        return "`none`, or a table"
    kind = field.rebuild_annotation()
    parts = list(with_parts(kind))
    if words := words_in(kind):
        return " or ".join([*map(code, words), *(["another name"] if str in parts else [])])
    if any(get_origin(part) is tuple for part in parts):
        return "three numbers"
    if any(isinstance(note, Viscosity) for part in parts for note in getattr(part, "__metadata__", ())):
        return "one viscosity, or a list of two"
    return next(PLAIN[part] for part in parts if part in PLAIN)
