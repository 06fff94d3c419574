"""One key of a scene file by its path, `operation.axial_load`: what it takes, and a document that has it."""

from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from types import UnionType
from typing import Annotated, Any, Union, get_args, get_origin

from pydantic import TypeAdapter, ValidationError
from pydantic.fields import FieldInfo

from analytic import catalog
from analytic.errors import InputError
from analytic.scenefile.quantity import Dimension
from analytic.scenefile.tables import SceneTable, Table
from analytic.scenefile.text import plain, shown

Value = float | int | str | bool
CATALOG = "bearing.catalog"


@dataclass(frozen=True, kw_only=True)
class SceneKey:
    """A key that takes one value: a quantity, a number or a word."""

    path: str
    dimension: Dimension | None  # of a quantity; None: a count or a word
    in_series: bool  # whether a list of values makes a series
    field: FieldInfo

    def read(self, given: object) -> Value:
        """The value, a quantity in SI. Raises ValueError, saying what is wrong and what would be accepted."""
        if self.dimension is not None:
            return self.dimension.read(given)
        if not isinstance(given, Value):
            raise ValueError("is not a number or a word")
        if self.path == CATALOG and given not in catalog.names("bearings"):
            raise ValueError(f"is not in the catalog; give one of {', '.join(catalog.names('bearings'))}")
        try:
            TypeAdapter(self.field.rebuild_annotation()).validate_python(given)
        except ValidationError as problem:
            fault = problem.errors(include_url=False)[0]
            words = fault.get("ctx", {})
            raise ValueError(
                str(words["error"]) if "error" in words else f"is not a word known here; give {words['expected']}"
            ) from None
        return given


def scene_key(path: str) -> SceneKey:
    """The key of that path. Raises InputError for one that is unknown, or that takes a table."""
    table: type[Table] | None = SceneTable
    field: FieldInfo | None = None
    for part in path.split("."):
        field = None if table is None else table.model_fields.get(part)
        if field is None:
            raise InputError(f"{plain(path)} is no key of a scene file{_hint(path)}")
        table = _table_of(field)
    assert field is not None
    if table is not None and not field.metadata:  # a material has a validator too, which takes its name
        inside = ", ".join(f"{path}.{name}" for name in table.model_fields)
        raise InputError(f"{path} is a table of a scene file; give one of its keys: {inside}")
    return SceneKey(
        path=path,
        dimension=next(_dimensions(field.rebuild_annotation()), None),
        in_series=get_origin(field.annotation) is list,
        field=field,
    )


def with_key(document: dict[str, Any], path: str, value: object) -> dict[str, Any]:
    """A copy of the document with that key set. Raises InputError where a word stands in place of a table."""
    first, _, rest = path.partition(".")
    if not rest:
        return document | {first: value}
    inside = document.get(first, {})
    if not isinstance(inside, dict):
        raise InputError(f"{first} = {shown(inside)} is no table in the scene, so {rest} cannot be set; write it out")
    return document | {first: with_key(inside, rest, value)}


def _hint(path: str) -> str:
    known = list(_paths(SceneTable))
    last = path.rpartition(".")[2]
    near = [name for name in known if name.rpartition(".")[2] == last] or get_close_matches(path, known, n=2)
    near = near or [name for name in known if name.rpartition(".")[2].endswith(last)]
    return f"; did you mean {' or '.join(near[:4])}?" if near else "; give its whole path, as operation.axial_load"


def _paths(table: type[Table], before: str = "") -> Iterator[str]:
    for name, field in table.model_fields.items():
        inside = _table_of(field)
        if inside is None or field.metadata:
            yield before + name
        if inside is not None:
            yield from _paths(inside, f"{before}{name}.")


def _table_of(field: FieldInfo) -> type[Table] | None:
    for kind in (field.annotation, *get_args(field.annotation)):
        if isinstance(kind, type) and issubclass(kind, Table):
            return kind
    return None


def _dimensions(kind: Any) -> Iterator[Dimension]:
    """Of an annotation: of a float, of a float or nothing, of a list of them."""
    if get_origin(kind) is Annotated:
        yield from (note for note in kind.__metadata__ if isinstance(note, Dimension))
        yield from _dimensions(kind.__origin__)
    elif get_origin(kind) in (Union, UnionType, list):
        for part in get_args(kind):
            yield from _dimensions(part)
