"""Results as labelled arrays, data frames and tables of a notebook: every number with its unit and meaning."""

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from analytic.errors import require_packages
from analytic.units import METRIC, Units, unit_for
from analytic.words import Unit


class Column(NamedTuple):
    """What the numbers of a column are, and how they are shown."""

    unit: str  # SI; "1" of a pure number
    meaning: str
    symbol: str = ""
    short: str = ""  # a name for tables and figures; empty: the meaning
    metric: Unit | None = None  # that is shown, whatever the size; None: the usual one of the SI unit

    @property
    def name(self) -> str:
        """As it stands over a column."""
        return self.short or self.meaning

    def shown(self, units: Units = METRIC) -> Unit:
        """The unit in which a system shows it."""
        return units.instead_of(self.metric or unit_for(self.unit, 0.0))

    def heading(self, units: Units = METRIC) -> str:
        """Name and shown unit."""
        return f"{self.name}, {self.shown(units).name}"


class Labelled(NamedTuple):
    """Numbers with the names of their dimensions."""

    dimensions: tuple[str, ...]
    values: ArrayLike
    column: Column


def dataset_of(
    variables: Mapping[str, Labelled], *, coordinates: Mapping[str, Labelled], attributes: Mapping[str, Any]
) -> Any:
    """An xarray.Dataset with `units` and `long_name` of each variable as attributes.

    It lacks the variables that hold nothing, because their part was left out or is not modelled.
    Raises MissingPackageError without xarray.
    """
    require_packages("a dataset", "xarray")
    import xarray  # on demand: it takes a second

    def variable(given: Labelled) -> tuple[tuple[str, ...], ArrayLike, dict[str, str]]:
        return given.dimensions, given.values, {"units": given.column.unit, "long_name": given.column.meaning}

    return xarray.Dataset(
        {name: variable(given) for name, given in variables.items() if not _is_empty(given.values)},
        coords={name: variable(given) for name, given in coordinates.items()},
        attrs=dict(attributes),
    )


def frame_of(columns: Mapping[str, Labelled], dimension: str) -> Any:
    """A pandas.DataFrame with a row for each element of one dimension, in the order of the columns.

    It lacks columns that have other dimensions or hold nothing. `attrs["units"]` has the units.
    Raises MissingPackageError without pandas.
    """
    require_packages("a data frame", "pandas")
    import pandas  # on demand, as xarray

    kept = {
        name: each for name, each in columns.items() if each.dimensions == (dimension,) and not _is_empty(each.values)
    }
    frame = pandas.DataFrame({name: np.asarray(each.values) for name, each in kept.items()})
    frame.index.name = dimension
    frame = frame.set_index(dimension) if dimension in kept else frame
    frame.attrs["units"] = {name: each.column.unit for name, each in kept.items() if name in frame}
    return frame


def _is_empty(values: ArrayLike) -> bool:
    array = np.asarray(values)
    return array.dtype.kind == "f" and array.size > 0 and bool(np.all(np.isnan(array)))
