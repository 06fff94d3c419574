"""Mesh recipes, read from TOML: every mesh that is solved is made from one."""

import tomllib
from dataclasses import dataclass, fields
from importlib.resources import files
from importlib.resources.abc import Traversable
from itertools import pairwise
from typing import Any, Literal, get_args

from analytic.errors import InputError

Geometry = Literal["real", "hertzian", "wall"]

LARGEST = 1000  # number in a recipe; a larger one is a mistake
LEAST = {
    "core_bulge": (0, True),
    "margin_size": (1, False),
    "growth": (1, False),
}  # lower bound, and whether it is accepted itself


@dataclass(frozen=True, kw_only=True)
class Cells:
    """Cells of a quarter patch: per level unit in a recipe, all of them after `times(level)`."""

    core: int  # in each direction in the square core of the contact
    inside: int  # rings from the core to the edge of the contact
    margin: int  # rings just outside the edge
    outside: int  # rings from there to the far boundary
    depth: int  # layers

    @property
    def rings(self) -> int:
        """Number of rings from the core to the far boundary."""
        return self.inside + self.margin + self.outside

    def times(self, level: int) -> "Cells":
        """Cell counts of a level."""
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
    """Layers of cells under the surface."""

    layer: float  # depth of the evenly thick layers, in minor semi-axes
    share: float  # number of these layers over the number of all


@dataclass(frozen=True, kw_only=True)
class Domain:
    """The far boundary of a block."""

    extent: float  # distance of the far boundary, in major semi-axes
    growth: float  # largest ratio of distances that one outer cell per level unit may span


@dataclass(frozen=True, kw_only=True)
class Recipe:
    """How a contact is meshed."""

    name: str
    geometry: Geometry
    levels: tuple[int, ...]  # increasing; from one to the next, cells shrink by one ratio in all three directions
    cells: Cells  # per level unit
    patch: Patch
    depth: Depth
    domain: Domain


def load_recipe(name: str) -> Recipe:
    """The recipe `name` of the package. Raises InputError if it is missing or invalid."""
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
    """One table of a recipe: exactly the fields of `kind`, each a positive `number`, or zero where that is allowed."""
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
