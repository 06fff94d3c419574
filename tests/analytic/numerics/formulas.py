"""Formulas and an entry, for tests of what compiles them."""

from typing import NamedTuple

import numpy as np

from analytic.numerics.compilation import compiled
from analytic.numerics.machine_code import Layout, entry
from analytic.numerics.records import dtype_of
from analytic.scene import Array


class Law(NamedTuple):
    """What the entry takes by name, as a record."""

    doubled: bool
    factor: float
    shift: tuple[float, float]


class Tables(NamedTuple):
    """And as arrays."""

    powers: Array
    law: Law


SUMS = np.dtype([("total", "f8"), ("counted", "i8")], align=True)


@compiled
def power_sum(base: float, powers: Array) -> float:
    total = 0.0
    for power in powers:
        total += base**power
    return total


@compiled(inline=True)
def both(base, tables):
    total = power_sum(base, tables.powers) * tables.law.factor
    return total, total + tables.law.shift[0] * tables.law.shift[1]


def _layout() -> dict[str, Layout]:
    tables = Tables._make((1, dtype_of(Law)))
    return {"bases": 1, "tables": tables, "limits": (float, int), "sums": (SUMS, 2), "adds": bool}


@entry(_layout)
def fill(bases: Array, tables: Tables, limits: tuple[float, int], sums: Array, adds: bool) -> int:
    """Write the sums of the first bases, from a least one on; returns how many."""
    found = 0
    for index in range(limits[1]):
        if bases[index] < limits[0]:
            continue
        first, second = both(bases[index], tables)
        of_base = sums[index, 1]
        of_base.total = (first + 0.25) / bases[index] + np.sinh(second) if adds else np.arcsinh(second)
        of_base.counted = 2 if tables.law.doubled else 1
        found += 1
    return found
