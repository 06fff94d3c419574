"""The page of the keys in JSON, from the tables that write and read a report."""

import types
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin

from docs.extensions.annotations import with_parts
from docs.extensions.source import field_comments
from docs.extensions.tables import code, table
from fembearing.quantities import QUANTITIES
from fembearing.report.document.report import Report
from fembearing.report.document.table import Table

HEAD = """\
# Keys in JSON

Made from the tables that `report.json` is written and read with. Numbers are SI: m, N, Pa, rad, rad/s, N m, K, s;
uncertainties and discrepancies are relative. `null` stands where something is not known or was not computed.

- `report.json` of `fembearing validate`, and `validate --json`: [Report](#report).
- `torque.json` and `torque --json`: [Torque](#torque); the file has `cage_motion`, the files of moving cages, as well.
- `contact --json`: [Contact](#contact), with the stresses below the surface.
"""
TableType = type[Table]
PLAIN = {float: "number", int: "whole number", str: "text", bool: "`true` or `false`", type(None): "`null`"}


def json_page() -> str:
    """The page in Markdown."""
    found = tables(Report, [])
    names = [named.__name__ for named in found]
    headings = {
        each: each.__name__ if names.count(each.__name__) == 1 else f"{each.__name__} in {file_of(each)}"
        for each in found
    }
    return "\n".join([HEAD, *(section(each, headings) for each in found)])


def tables(of: TableType, seen: list[TableType]) -> list[TableType]:
    """This table and all below it, each once; those of all quantities are one."""
    of = generic(of)[0] or of
    if of not in seen:
        seen.append(of)
        for field in of.model_fields.values():
            for inside in (part for kind in with_parts(field.annotation) for part in (kind, *generic(kind)[1])):
                if isinstance(inside, type) and issubclass(inside, Table):
                    tables(inside, seen)
    return seen


def generic(kind: Any) -> tuple[TableType | None, tuple[Any, ...]]:
    """The table of any kind of entry that this one is made from, and the kind of its entries."""
    made = getattr(kind, "__pydantic_generic_metadata__", {})
    return made.get("origin"), made.get("args", ())


def file_of(of: TableType) -> str:
    return of.__module__.rpartition(".")[2]


def section(of: TableType, headings: dict[TableType, str]) -> str:
    """A heading, what the table is, and its keys."""
    comments = {name: said for above in reversed(of.__mro__) for name, said in comments_of(above).items()}
    rows = []
    for name, field in of.model_fields.items():
        quantity = QUANTITIES.get(name) if float in with_parts(field.annotation) else None
        unit, meaning = ("", "") if quantity is None else (quantity.unit, quantity.meaning)
        note = comments.get(name) or meaning
        rows.append(
            [code(field.alias or name), holds(field.annotation, headings), unit, note.replace("None", "`null`")]
        )
    said = " ".join((of.__doc__ or "").split()).replace("None", "`null`")
    return f"## {headings[of]}\n\n{said}\n\n" + table(["key", "holds", "unit", "meaning"], rows)


def comments_of(of: type) -> dict[str, str]:
    """The comments beside the fields of a table of ours."""
    return field_comments(of) if issubclass(of, Table) else {}


def holds(kind: Any, headings: dict[TableType, str]) -> str:
    """What a value is, in words; a table as a link."""
    origin, parts = get_origin(kind), get_args(kind)
    if kind in PLAIN:
        return PLAIN[kind]
    if isinstance(kind, TypeVar):
        return "an entry"
    if kind in headings:
        return f"[{headings[kind]}](#{headings[kind].lower().replace(' ', '-')})"
    of, entries = generic(kind)
    if of is not None:
        return f"{holds(of, headings)}: {' or '.join(holds(each, headings) for each in entries)}"
    if origin is Annotated:
        return holds(parts[0], headings)
    if origin in (Union, types.UnionType):
        return " or ".join(dict.fromkeys(holds(part, headings) for part in parts))
    if origin is Literal:
        return " or ".join(code(str(part)) for part in parts)
    if origin is list:
        return f"list of {holds(parts[0], headings)}"
    if origin is dict:
        return f"{holds(parts[1], headings)} by name"
    raise TypeError(f"{kind} has no words")
