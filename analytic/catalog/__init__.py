"""Built-in bearings, materials and scenes, in the format of a scene file; oils, finishes and fitted corrections.

Bearings by their designation, in tables: `analytic.catalog.bearing_rows`.
"""

import csv
import re
import tomllib
from collections.abc import Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from types import MappingProxyType
from typing import Any, Literal

Kind = Literal["bearings", "corrections", "materials", "scenes"]
Row = Mapping[str, str]  # of a table: the text of each column, whose name may end in a unit, as "density [kg/m^3]"


@cache
def names(kind: Kind) -> tuple[str, ...]:
    """The names of all entries of this kind, sorted."""
    entries = (entry.name for entry in (files(__name__) / kind).iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in entries if name.endswith(".toml")))


def path(kind: Kind, name: str) -> Path:
    """The file of an entry; it exists if `names` lists it."""
    return Path(str(files(__name__) / kind / f"{name}.toml"))


def entry(kind: Kind, name: str) -> dict[str, Any]:
    """The tables of an entry as they are written, with units."""
    return tomllib.loads(path(kind, name).read_text("utf-8"))


@cache
def rows(table: Literal["oils", "base_oils", "finishes"]) -> Mapping[str, Row]:
    """The rows of a table by their names, in its order."""
    lines = (files(__name__) / f"{table}.csv").read_text("utf-8").splitlines()
    read = csv.DictReader(line for line in lines if not line.startswith("#"))
    return MappingProxyType({row["name"]: MappingProxyType(row) for row in read})


def oil_names() -> tuple[str, ...]:
    """The names of all oils and greases."""
    return tuple(rows("oils"))


def find(table: Literal["oils", "materials"], name: str) -> str | None:
    """The name of the oil or material that a text means, whatever its case, spaces and punctuation; None: of none.

    An oil of an ISO class is mineral unless the text says another.
    """
    return _spellings(table).get(spelling(name))


def spelling(name: str) -> str:
    """The letters and digits that tell one name from another."""
    return re.sub(r"^(iso|grease)|mineral$", "", re.sub(r"[\W_]", "", name.lower()))


@cache
def _spellings(table: Literal["oils", "materials"]) -> Mapping[str, str]:
    if table == "oils":
        others = {name: [text for text in row["also"].split(";") if text] for name, row in rows("oils").items()}
    else:
        others = {name: entry("materials", name).get("also", []) for name in names("materials")}
    return {spelling(text): name for name, texts in others.items() for text in (name, *texts)}
