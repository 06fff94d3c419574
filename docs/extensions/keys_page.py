"""The page of all keys of a scene file, from the declarations that read it."""

from collections.abc import Iterator

from analytic.declared import REQUIRED, Key, Switch, Table, Whole, Word
from analytic.quantity import Dimension, QuantityOrWord
from analytic.scenefile.keys import scene_table
from analytic.scenefile.kinds import Direction, RowOf, Solid, Spread, Viscosity
from docs.extensions.tables import code, table

HEAD = """\
# Keys of a scene

Made from the declarations that read a scene: every key, what it takes, its range and its default.
[Scenes](../scenes.md) says what the keys mean together, and which of them exclude each other. A quantity may have any
unit of its kind; range and default are in the one that is shown. A default of "none" means that the key may be left
out: another key, the catalogue or the oil's name then gives the value, or the part of the model that needs it is not
computed. In `[bearing]` and `[cage]` the catalogue supplies every required key.
"""
COLUMNS = ["key", "meaning", "unit, or what it takes", "range", "default", "example"]
MATERIAL = "bearing.ball_material"  # whose keys stand once for all materials


def keys_page() -> str:
    """The page in Markdown."""
    return "\n".join([HEAD, *sections(scene_table())])


def sections(of: Table) -> Iterator[str]:
    """A heading and a table of keys for each table of a scene, the outer ones first."""
    heading = f"`[{of.path}]`" if of.path else "Top of the file"
    rows = [row(entry) for entry in of.keys.values() if isinstance(entry, Key) or entry.word]
    if rows:
        yield f"## {heading}\n\n{table(COLUMNS, rows)}"
    for entry in of.keys.values():
        if isinstance(entry, Table):
            yield from sections(entry)
        elif isinstance(entry.kind, Solid) and entry.path == MATERIAL:
            yield from sections(entry.kind.inside)


def row(entry: Key | Table) -> list[str]:
    name = code(entry.path.rpartition(".")[2])
    if isinstance(entry, Table):
        return [name, "", f"`{entry.word}`, or a table", "", "none", ""]
    dimension = entry.dimension
    if dimension is None:
        return [name, entry.meaning, words_of(entry), "", default_of(entry), ""]
    unit = dimension.shown_unit or "pure number"
    series = ", or a list" if entry.in_series else ""
    two = ", or a list of two" if isinstance(entry.kind, Viscosity) else ""
    example = code(dimension.example)
    return [name, entry.meaning, f"{unit}{series}{two}", ranged(entry, dimension), shown(entry, dimension), example]


def ranged(entry: Key, dimension: Dimension) -> str:
    words = f", or {', '.join(map(code, dimension.words))}" if isinstance(dimension, QuantityOrWord) else ""
    share = ", or a percentage" if isinstance(entry.kind, Spread) and entry.kind.takes_share else ""
    return dimension.span.removesuffix(f" {dimension.shown_unit}") + words + share


def shown(entry: Key, dimension: Dimension) -> str:
    """The default of a quantity in the unit of its example."""
    given = entry.default[0] if isinstance(entry.default, list) else entry.default
    if isinstance(given, float | int):
        return code(f"{dimension.written(float(given))} {dimension.shown_unit}".strip())
    return default_of(entry)


def default_of(entry: Key) -> str:
    given = entry.default
    if given is REQUIRED:
        return "required"
    return "none" if given is None else code(str(given).lower() if isinstance(given, bool) else str(given))


def words_of(entry: Key) -> str:
    """What a key takes that is no quantity."""
    match entry.kind:
        case Solid():
            return "name of a material, or a table"
        case Word() | RowOf():
            return " or ".join(map(code, entry.kind.words))
        case Direction():
            return "three numbers"
        case Whole():
            return "whole number"
        case Switch():
            return "`true` or `false`"
        case _:
            return "text"
