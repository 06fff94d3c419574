"""Bearings, materials and scenes that ship with the package, in the format of a scene file, and fitted corrections."""

import tomllib
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any, Literal

Kind = Literal["bearings", "corrections", "materials", "scenes"]


@cache
def names(kind: Kind) -> tuple[str, ...]:
    """What the catalog holds of this kind, sorted."""
    entries = (entry.name for entry in (files(__name__) / kind).iterdir())
    return tuple(sorted(name.removesuffix(".toml") for name in entries if name.endswith(".toml")))


def path(kind: Kind, name: str) -> Path:
    """Where the entry is kept; it exists if `names` lists it."""
    return Path(str(files(__name__) / kind / f"{name}.toml"))


def entry(kind: Kind, name: str) -> dict[str, Any]:
    """The entry's tables as written, units included."""
    return tomllib.loads(path(kind, name).read_text("utf-8"))
