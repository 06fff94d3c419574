"""delta = (F/K)^(2/3) + F/k of a ball in the sheet of a cage pocket: a local contact and a sheet that bends.

F: load, N; delta: approach, m; K: stiffness of the local contact, N/m^1.5; k: stiffness of the sheet, N/m. Bending is
linear in the load and the local contact is not: one stiffness K of both holds at a single load.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import stdtrit

from fembearing.check.contact.power_law import CONFIDENCE, LawData

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class PocketLaw:
    """The law fitted to a series. Uncertainties are relative half-widths, 95 %; None for two loads: they always fit."""

    stiffness: float  # K, N/m^1.5
    stiffness_uncertainty: float | None
    sheet: float  # k, N/m
    sheet_uncertainty: float | None

    def approach(self, load: ArrayLike) -> Array:
        """Approach of the fitted law.

        Parameters
        ----------
        load : array_like, any shape
            F, N.

        Returns
        -------
        ndarray
            delta, m, of the shape of load.
        """
        force = np.asarray(load, dtype=np.float64)
        return (force / self.stiffness) ** (2 / 3) + force / self.sheet


def fit_pocket_law(data: LawData) -> PocketLaw | None:
    """The law through two loads or more, by least squares of relative errors; None for one, or without bending.

    The uncertainty is the deviation of the loads from the law plus what the uncertain approaches bring, with the most
    unfavourable signs.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([data.load ** (2 / 3), data.load]) / data.approach[:, None]
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)
    local, bending = inverse.sum(axis=1)
    if min(local, bending) <= 0:
        return None
    left = data.load.size - 2
    relative = [None, None]
    if left > 0:
        deviation = np.sqrt(np.sum((basis @ [local, bending] - 1) ** 2) / left) * stdtrit(left, (1 + CONFIDENCE) / 2)
        uncertain = np.linalg.norm(inverse, axis=1) * deviation + np.abs(inverse) @ (data.common + data.crossing)
        relative = [float(1.5 * uncertain[0] / local), float(uncertain[1] / bending)]
    return PocketLaw(
        stiffness=float(local**-1.5),
        stiffness_uncertainty=relative[0],
        sheet=float(1 / bending),
        sheet_uncertainty=relative[1],
    )
