"""A number that the model is compared with, beside its own."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from analytic.scene import Array
from validation.study import numbers, published

Kind = Literal["measured", "second hand", "maker's formula", "formula", "trend"]


@dataclass(frozen=True, kw_only=True, eq=False)
class Anchor:
    """Points of one source; theirs, ours and uncertainty broadcast, in the unit shown."""

    what: str
    source: str
    kind: Kind
    theirs: ArrayLike  # D
    ours: ArrayLike  # S
    unit: str
    uncertainty: ArrayLike | None = None  # u_val, standard; None: none can be stated
    worth: str  # what the comparison is worth

    @property
    def error(self) -> Array:
        """E over D, at every point that both have."""
        ratio = np.ravel(np.asarray(self.ours) / np.asarray(self.theirs)) - 1
        return ratio[np.isfinite(ratio)]

    @property
    def relative_uncertainty(self) -> Array | None:
        """u_val over D."""
        if self.uncertainty is None:
            return None
        return np.ravel(np.broadcast_to(np.asarray(self.uncertainty) / np.asarray(self.theirs), np.shape(self.ours)))

    @property
    def missed(self) -> int | None:
        """Points with abs(E) above 2 u_val; None without u_val."""
        uncertainty = self.relative_uncertainty
        return None if uncertainty is None else int(np.sum(np.abs(self.error) > 2 * uncertainty))


def first_what_is_missed(anchors: Iterable[Anchor]) -> list[Anchor]:
    """Those beyond 2 u_val, those without u_val from the largest ratio on, and those that hold."""

    def order(anchor: Anchor) -> tuple[int, float]:
        group = 1 if anchor.missed is None else 0 if anchor.missed else 2
        return group, -float(np.max(np.abs(np.log1p(anchor.error))))

    return sorted(anchors, key=order)


def published_columns(name: str) -> dict[str, Array]:
    """The columns of a file of numbers alone, NaN where a cell is empty."""
    rows = published(name)
    return {key: numbers(rows, key) for key in rows[0]}
