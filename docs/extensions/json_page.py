"""The page of the keys in JSON, from the dataclasses that results are written from, and the registry of columns."""

import types
from collections.abc import Mapping
from dataclasses import is_dataclass
from typing import Annotated, Any, Literal, TypeVar, Union, get_args, get_origin, get_type_hints

from analytic.columns import COLUMNS, OF_CAGE, OF_MOTION, OF_RING
from analytic.labelled import Column
from analytic.prediction.duty import DutyCycle
from docs.extensions.annotations import with_parts
from docs.extensions.source import field_comments
from docs.extensions.tables import code, table
from fembearing.plain_types import written_fields
from fembearing.report.report import Report

HEAD = """\
# Keys in JSON

Made from the types that results are written from. Every file begins with `kind` and `format`; the number of the format
is the same for all files, and rises when a key changes its name or meaning. Numbers are SI: m, N, Pa, rad, rad/s, N m,
K, s; discrepancies are relative. `null` stands where something is not known or was not computed.

- `report.json` of `fembearing validate`, and `validate --json`: [Report](#report).
- `torque.json` and `torque --json`: [TorqueContent](#torquecontent); the file has `run`, where it comes from, and the
  folder's `cage_motion`, the files of moving cages, as well.
- `compare.json` and `compare --json`: [MeasuredComparison](#measuredcomparison); the file has `run` as well.
- `duty.json` and `duty --json`: [DutyCycle](#dutycycle) with `standing`; the file has `run` as well.
- `contact --json`: [ContactNumbers](#contactnumbers), with the stresses below the surface.
"""
PLAIN = {float: "number", int: "whole number", str: "text", bool: "`true` or `false`", type(None): "`null`", Any: "any"}


def json_page() -> str:
    """The page in Markdown."""
    found = tables(DutyCycle, tables(Report, []))
    names = [named.__name__ for named in found]
    headings = {
        each: each.__name__ if names.count(each.__name__) == 1 else f"{each.__name__} in {file_of(each)}"
        for each in found
    }
    return "\n".join([HEAD, *(section(each, headings) for each in found), columns()])


def columns() -> str:
    """The registry of the numbers of an operating point."""
    about = "Of an operating point, a step or a measured torque; CSV, datasets and data frames have the same names."
    group = "`group/name` is the key `name` in the table `group`."
    parts = (
        ("Columns", about, COLUMNS),
        (
            "Columns of the cage",
            f"{group} From `torque` on only in the `cage_motion` of a report.",
            OF_CAGE | OF_MOTION,
        ),
        ("Columns of the ring", f"{group} Lists have a number for each ball or freedom.", OF_RING),
    )
    head = ["key", "symbol", "unit", "meaning"]

    def rows(known: Mapping[str, Column]) -> list[list[str]]:
        return [[code(name), each.symbol, each.unit, each.meaning] for name, each in known.items()]

    return "\n".join(f"## {name}\n\n{said}\n\n{table(head, rows(known))}" for name, said, known in parts)


def keys_of(of: type) -> dict[str, Any]:
    """The type of each key of a table."""
    hints = get_type_hints(of, include_extras=True)
    return {field.name: hints[field.name] for field in written_fields(of)}


def tables(of: type, seen: list[type]) -> list[type]:
    """This table and all below it, each once; those of any kind of entry are one."""
    if of not in seen:
        seen.append(of)
        for kind in keys_of(of).values():
            for part in with_parts(kind):
                if isinstance(part, type) and is_dataclass(part):
                    tables(part, seen)
    return seen


def file_of(of: type) -> str:
    return of.__module__.rpartition(".")[2]


def section(of: type, headings: dict[type, str]) -> str:
    """A heading, what the table is, and its keys."""
    above = [each for each in reversed(of.__mro__) if is_dataclass(each)]
    comments = {name: said for each in above for name, said in field_comments(each).items()}
    rows = []
    for name, kind in keys_of(of).items():
        quantity = COLUMNS.get(name) if float in with_parts(kind) else None
        unit, meaning = ("", "") if quantity is None else (quantity.unit, quantity.meaning)
        note = comments.get(name) or meaning
        rows.append([code(name), holds(kind, headings), unit, note.replace("None", "`null`")])
    said = " ".join((of.__doc__ or "").split()).replace("None", "`null`")
    return f"## {headings[of]}\n\n{said}\n\n" + table(["key", "holds", "unit", "meaning"], rows)


def holds(kind: Any, headings: dict[type, str]) -> str:
    """What a value is, in words; a table as a link."""
    origin, parts = get_origin(kind), get_args(kind)
    if kind in PLAIN:
        return PLAIN[kind]
    if isinstance(kind, TypeVar):
        return "an entry"
    if kind in headings:
        return f"[{headings[kind]}](#{headings[kind].lower().replace(' ', '-')})"
    if origin in headings:
        return f"{holds(origin, headings)}: {' or '.join(holds(each, headings) for each in parts)}"
    if origin is Annotated:
        return holds(parts[0], headings)
    if origin in (Union, types.UnionType):
        return " or ".join(dict.fromkeys(holds(part, headings) for part in parts))
    if origin is Literal:
        return " or ".join(code(str(part)) for part in parts)
    if origin is tuple and parts[-1] is not Ellipsis:
        return f"{len(parts)} of {holds(parts[0], headings)}"
    if origin in (list, tuple):
        return f"list of {holds(parts[0], headings)}"
    if origin in (dict, Mapping):
        return f"{holds(parts[1], headings)} by name"
    raise TypeError(f"{kind} has no words")
