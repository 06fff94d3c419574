"""Built-in bearings, materials and scenes, in the format of a scene file, and fitted corrections of contacts.

Bearings by their designation, in tables: `analytic.catalog.bearing_rows`.
"""

import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Literal

Kind = Literal["bearings", "corrections", "materials", "scenes"]


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
