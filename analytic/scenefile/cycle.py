"""A duty cycle in a CSV file: one row for each step, in columns as `analytic.scenefile.columns` reads.

duration [s],inner_speed [rpm],axial_load [N],radial_load [N],temperature [degC]
20,3000,100,2500,60
"""

import os
from dataclasses import dataclass

import numpy as np

from analytic.quantity import Dimension
from analytic.scene import Array
from analytic.scenefile.columns import OPERATING, Columns, operating_column
from analytic.words import plain

COLUMNS = Columns(
    known={
        "duration": Dimension(unit="s", low=1e-9, high=1e10, example='"20 s"'),
        **{name: operating_column(name) for name in OPERATING},
    },
    required="duration",
    row="duty step",
    where="what runs in its steps",
    example=("duration", "inner_speed"),
)


@dataclass(frozen=True, kw_only=True)
class Cycle:
    """The steps of a duty cycle, each array (n,); None: as in the scene."""

    file: str  # that has them, as messages name it
    duration: Array  # s, > 0
    inner_speed: Array | None = None  # rad/s; 0: a pause
    axial_load: Array | None = None  # N
    radial_load: Array | None = None  # N
    temperature: Array | None = None  # of the oil at the inlets, K


def read_cycle(path: str | os.PathLike[str]) -> Cycle:
    """The duty cycle in a CSV file. Raises InputError as `Columns.read`."""
    columns, rows = COLUMNS.read(path)
    values = {column.name: np.array([row.values[column.name] for row in rows]) for column in columns}
    return Cycle(file=plain(os.fspath(path)), **values)
