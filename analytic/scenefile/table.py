"""What every table of a scene file is."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, get_args

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, create_model
from pydantic.fields import FieldInfo
from pydantic_core import CoreSchema, core_schema


def _text(given: object) -> str:
    if not isinstance(given, str) or not given.strip() or len(given) > 200 or not given.isprintable():
        raise ValueError("is no name or text; give printable text of 1 to 200 characters")
    return given


Text = Annotated[str, BeforeValidator(_text), Field(description="give a name")]


@dataclass(frozen=True, kw_only=True)
class Whole:
    """Accepts a whole number of these things, from low to high."""

    things: str
    low: int
    high: int
    example: int

    def __get_pydantic_core_schema__(self, _source: object, _handler: object) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(self.read)

    def read(self, given: object) -> int:
        if isinstance(given, bool) or not isinstance(given, int) or not self.low <= given <= self.high:
            span = f"a whole number from {self.low} to {self.high}, for example {self.example}"
            raise ValueError(f"is not a number of {self.things}; give {span}")
        return given


class Table(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")
    HINT: ClassVar[str] = ""  # what to give for it, for messages


def table_of(field: FieldInfo) -> type[Table] | None:
    """The class of the table that a field holds; None for a field that holds a value."""
    for kind in (field.annotation, *get_args(field.annotation)):
        if isinstance(kind, type) and issubclass(kind, Table):
            return kind
    return None


def table_of_paths(name: str, fields: Mapping[str, Any], hint: str) -> type[Table]:
    """A table whose keys are paths, as "surface.hardness"; fields : annotation and default of each."""
    parts: dict[str, dict[str, Any]] = {}
    for key, field in fields.items():
        first, _, rest = key.partition(".")
        parts.setdefault(first, {})[rest] = field
    inside: dict[str, Any] = {}
    for first, rest in parts.items():
        if "" in rest:
            inside[first] = rest[""]
        else:
            table = table_of_paths(f"{name}_{first}", rest, hint=f"give a table of {', '.join(rest)}")
            inside[first] = table, table()
    made = create_model(name, __base__=Table, **inside)
    made.HINT = hint
    return made


def given_paths(table: Table, before: str = "") -> Iterator[tuple[str, Any]]:
    """The paths of a table of paths that are given, with their values."""
    for name, given in table:
        if isinstance(given, Table):
            yield from given_paths(given, f"{before}{name}.")
        elif given is not None:
            yield before + name, given
