"""Operating points that have no torque: which they are and why, and their places in what is shown."""

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.columns import COORDINATES, Point, rows_of
from analytic.errors import FembearingError
from analytic.scene import Operation


@dataclass(frozen=True, kw_only=True, eq=False)
class Places:
    """All n operating points of a scene, some of which have no torque."""

    operation: Operation  # as a series
    failures: Mapping[int, FembearingError]  # of the points without a torque, by their numbers from 0

    @cached_property
    def computed(self) -> list[int]:
        """The numbers of the points that have a torque, from 0."""
        return [each for each in range(self.operation.inner_speed.size) if each not in self.failures]

    @property
    def rows(self) -> NDArray[np.intp]:
        """(n,) the row of each point among those that have a torque; 0 of one that has none."""
        found = np.zeros(self.operation.inner_speed.size, dtype=np.intp)
        found[self.computed] = np.arange(len(self.computed))
        return found

    @property
    def left_out(self) -> tuple[Point, ...]:
        """A row for each point without a torque: its number, its loads and speed, and the reason."""
        lost = [*self.failures]
        given = {name: np.asarray(getattr(self.operation, name))[lost] for name in COORDINATES}
        return rows_of({**given, "point": lost, "reason": [*map(str, self.failures.values())]})

    def columns(self, computed: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
        """Columns over all points: speed and loads are known everywhere, all else is NaN or None without a torque.

        Parameters
        ----------
        computed : mapping of str to ndarray, shape (m, ...)
            Columns over the points that have a torque.

        Returns
        -------
        dict of str to ndarray, shape (n, ...)
            By the same names.
        """
        whole = {name: self._spread(values) for name, values in computed.items()}
        return whole | {name: np.asarray(getattr(self.operation, name)) for name in COORDINATES if name in whole}

    def _spread(self, values: NDArray[Any]) -> NDArray[Any]:
        """(n, ...) from (m, ...): NaN, or None in place of a text, where there is no torque."""
        if not self.failures:
            return values
        is_number = values.dtype.kind == "f"
        whole = np.full(
            (self.rows.size, *values.shape[1:]), np.nan if is_number else None, float if is_number else object
        )
        whole[self.computed] = values
        return whole
