"""Mesh recipes: how a contact is meshed, read from TOML. Every mesh that is solved comes from one."""

import tomllib
from dataclasses import dataclass, fields
from importlib.resources import files
from importlib.resources.abc import Traversable
from itertools import pairwise
from typing import Any, Literal, get_args

from analytic.errors import InputError

Geometry = Literal["real", "hertzian", "wall"]


LARGEST = 1000  # of any number in a recipe: beyond it, a slip
LEAST = {"core_bulge": (0, True), "margin_size": (1, False), "growth": (1, False)}  # and whether it is itself accepted


@dataclass(frozen=True, kw_only=True)
class Cells:
    """Cells of a quarter patch, per level unit in a recipe, in full once multiplied by a level."""

    core: int  # each way across the square core of the contact
    inside: int  # rings from the core to the edge of the contact
    margin: int  # rings just outside the edge
    outside: int  # rings from there to the far boundary
    depth: int  # layers

    @property
    def rings(self) -> int:
        return self.inside + self.margin + self.outside

    def times(self, level: int) -> "Cells":
        return Cells(**{part.name: level * getattr(self, part.name) for part in fields(self)})


@dataclass(frozen=True, kw_only=True)
class Patch:
    """Shape of the patch around the contact; lengths in semi-axes."""

    core_size: float
    core_bulge: float  # 0 a square core, 1 a circular one
    edge_grading: float  # exponent that shrinks the cells towards the edge
    margin_size: float


@dataclass(frozen=True, kw_only=True)
class Depth:
    layer: float  # evenly thick layers down to here, in minor semi-axes
    share: float  # of all layers that lie in them


@dataclass(frozen=True, kw_only=True)
class Domain:
    extent: float  # far boundary of a block, in major semi-axes
    growth: float  # the far boundary may lie this many times further off for each outer cell per level unit


@dataclass(frozen=True, kw_only=True)
class Recipe:
    name: str
    geometry: Geometry
    levels: tuple[int, ...]  # increasing; one ratio in all three directions between two levels
    cells: Cells  # per level unit
    patch: Patch
    depth: Depth
    domain: Domain


def load_recipe(name: str) -> Recipe:
    """The recipe that ships with the package under `name`. Raises InputError if it is missing or at fault."""
    return parse_recipe(files("fembearing") / "meshes" / f"{name}.toml", name=name)


def parse_recipe(source: Traversable, *, name: str) -> Recipe:
    """Read one recipe. Raises InputError naming the key, the value and what is accepted."""
    try:
        table = tomllib.loads(source.read_text("utf-8"))
    except FileNotFoundError as problem:
        raise InputError(
            f"mesh recipe {name} is missing, and nothing is meshed without one: install fembearing again, or in a "
            f"checkout restore meshes/{name}.toml"
        ) from problem
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as problem:
        raise InputError(f"mesh recipe {name}: {problem}; restore meshes/{name}.toml") from problem
    parts = {"cells": (Cells, int), "patch": (Patch, float), "depth": (Depth, float), "domain": (Domain, float)}
    unknown = table.keys() - parts.keys() - {"geometry", "levels"}
    if unknown:
        raise InputError(f"mesh recipe {name}: unknown key {min(unknown)!r}")
    geometry: Any = table.get("geometry")
    levels = table.get("levels")
    if geometry not in get_args(Geometry):
        raise InputError(f"mesh recipe {name}: geometry = {geometry!r}, accepted: {', '.join(get_args(Geometry))}")
    if not (isinstance(levels, list) and len(levels) >= 3 and all(type(level) is int for level in levels)):
        raise InputError(f"mesh recipe {name}: levels = {levels!r}, accepted: three or more whole numbers")
    if levels[0] < 1 or any(fine < 1.3 * coarse for coarse, fine in pairwise(levels)):
        raise InputError(f"mesh recipe {name}: levels = {levels!r}, accepted: each at least 1.3 times the one before")
    sections = {key: _section(name, key, kind, number, table.get(key)) for key, (kind, number) in parts.items()}
    return Recipe(name=name, geometry=geometry, levels=tuple(levels), **sections)


def _section(name: str, key: str, kind: type, number: type, given: Any) -> Any:
    """One table of a recipe: exactly the fields of `kind`, each a positive `number` (zero where that has a meaning)."""
    wanted = {part.name for part in fields(kind)}
    if not isinstance(given, dict) or given.keys() != wanted:
        raise InputError(f"mesh recipe {name}: [{key}] must hold exactly {', '.join(sorted(wanted))}, got {given!r}")
    for part, value in given.items():
        least, inclusive = LEAST.get(part, (1, True) if number is int else (0, False))
        real = isinstance(value, int | number) and not isinstance(value, bool)
        if not real or not (least < value <= LARGEST or (inclusive and value == least)):
            sort = "whole number" if number is int else "number"
            bound = f"{least} or more" if inclusive else f"more than {least}"
            raise InputError(f"mesh recipe {name}: {key}.{part} = {value!r}, accepted: a {sort}, {bound}, to {LARGEST}")
    return kind(**given)
