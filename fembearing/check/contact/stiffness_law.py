"""The stiffness laws of a contact under many loads, fitted with uncertainties.

F = K delta^n with its tangents; in the sheet of a cage pocket delta = (F/K)^(2/3) + F/k, a local contact and a sheet
that bends. Bending is linear in the load and the local contact is not: one stiffness K of both holds at a single load.
F: load, N, exact; delta: approach, m, each with its own half-width; k: stiffness of the sheet, N/m.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.special import stdtrit

from fembearing.grid_convergence import Estimate

Array = NDArray[np.float64]
ALIKE = 0.3  # in ln F, a tenth of a semi-axis: farther apart, off-mesh errors of two loads are independent
CONFIDENCE = 0.95
ENOUGH = 5  # distinct loads from which the tangents may depart from a power law


@dataclass(frozen=True, kw_only=True)
class StiffnessLaw:
    """F = K delta^n, fitted to a series. Uncertainties except `propagated` are None for two loads, which always fit."""

    stiffness: float  # K, N/m^n: extrapolated to 1 m, to be used only with n
    exponent: float  # n
    stiffness_uncertainty: float | None  # of K, relative half-width, 95 %: large, as 1 m is far from any approach
    misfit: float | None  # of the exponent, from the deviation of the loads from a power law
    propagated: float  # of the exponent, from uncertain approaches
    exponent_uncertainty: float | None  # absolute, 95 %: the sum of both parts, as they may depend on each other

    def load(self, approach: ArrayLike) -> Array:
        """Load of the fitted law.

        Parameters
        ----------
        approach : array_like, any shape
            delta, m.

        Returns
        -------
        ndarray
            F, N, of the shape of approach.
        """
        return self.stiffness * np.asarray(approach, dtype=np.float64) ** self.exponent


@dataclass(frozen=True, kw_only=True, eq=False)
class LawData:
    """The data of the fit, (n,) each: distinct loads, ascending, and relative half-widths of their approaches."""

    load: Array  # N
    approach: Array  # m
    common: Array  # errors that may have one cause at all loads
    crossing: Array  # off-mesh errors

    @classmethod
    def of(cls, loads: Array, approaches: Sequence[Estimate], crossing: Sequence[float]) -> "LawData":
        """From loads in any order, which may repeat."""
        load, index = np.unique(loads, return_index=True)
        total = np.array([approaches[i].total for i in index])
        off = np.array([crossing[i] for i in index])
        value = np.array([approaches[i].value for i in index])
        return cls(load=load, approach=value, common=total - off, crossing=off)

    @property
    def redundant(self) -> bool:
        """Whether there are more loads than a power law has parameters."""
        return self.load.size > 2


def fit_law(data: LawData) -> StiffnessLaw | None:
    """F = K delta^n; None for a single load.

    Loads are exact and approaches are not: ln delta is fitted over ln F by least squares, with slope 1/n. Two loads
    cannot show a departure from the law: it is assumed, without an interval.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load)])
    (intercept, slope), weights, deviation, propagated = _fitted(data, basis, of=np.array([[0.0, 1.0]]))
    exponent = 1 / slope
    logarithm = -intercept * exponent  # of K
    _, moves, _, uncertain = _fitted(data, basis, of=np.array([[-exponent, -logarithm * exponent]]))  # d ln K
    propagation = float(exponent**2 * propagated[0])
    misfit = float(exponent**2 * deviation * np.linalg.norm(weights)) if data.redundant else None
    return StiffnessLaw(
        stiffness=float(np.exp(logarithm)),
        exponent=float(exponent),
        stiffness_uncertainty=float(deviation * np.linalg.norm(moves) + uncertain[0]) if data.redundant else None,
        misfit=misfit,
        propagated=propagation,
        exponent_uncertainty=None if misfit is None else misfit + propagation,
    )


def fit_tangents(data: LawData, loads: Array, approaches: Sequence[Estimate]) -> list[tuple[float, float | None]]:
    """dF/d(delta), N/m, and its relative uncertainty, at each of `loads`, (n,) N, with their `approaches`.

    Five loads or more give the slope of ln delta = c0 + c1 ln F + c2 F^(1/3): a groove departs from its power law as
    the ratio of contact size to body size, which grows as F^(1/3). Fewer loads give the slope of the power law itself,
    two without an uncertainty.
    """
    terms = 3 if data.load.size >= ENOUGH else 2
    largest = data.load[-1]
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load), (data.load / largest) ** (1 / 3)])
    of = np.column_stack([np.zeros(loads.size), np.ones(loads.size), (loads / largest) ** (1 / 3) / 3])[:, :terms]
    coefficients, weights, deviation, propagated = _fitted(data, basis[:, :terms], of=of)
    slope = of @ coefficients  # of ln delta over ln F
    # Residuals of a power law are systematic, not random: neighbouring loads share their sign.
    misfit = deviation * np.linalg.norm(weights, ord=1 if terms == 2 else 2, axis=1)
    tangent = loads / np.array([part.value for part in approaches]) / slope
    uncertainty = (misfit + propagated) / np.abs(slope) + np.array([part.total for part in approaches])
    known = uncertainty.tolist() if data.redundant else [None] * loads.size
    return list(zip(tangent.tolist(), known, strict=True))


def _fitted(data: LawData, basis: Array, *, of: Array) -> tuple[Array, Array, float, Array]:
    """Least squares of ln delta over `basis` (n, k), for combinations `of` (m, k) of its coefficients.

    Returns the coefficients (k,); the absolute weight of each load in each combination (m, n); the deviation from the
    fit, 95 %, 0 without redundant loads; and the half-width (m,) of each combination from uncertain approaches.
    Common errors, and off-mesh errors of neighbouring loads, count with the most unfavourable signs. Off-mesh errors
    of loads farther apart add as squares.
    """
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)  # its type stub allows any float
    values = np.log(data.approach)
    coefficients = inverse @ values
    weights = np.abs(of @ inverse)
    left = basis.shape[0] - basis.shape[1]
    deviation = 0.0
    if left > 0:
        scatter = np.sqrt(np.sum((values - basis @ coefficients) ** 2) / left)
        deviation = float(stdtrit(left, (1 + CONFIDENCE) / 2) * scatter)  # Student's t
    cell = np.floor(np.log(data.load) / ALIKE)
    alike = (cell[:, None] == np.unique(cell)).astype(float)
    crossing = np.sqrt(np.sum(((weights * data.crossing) @ alike) ** 2, axis=1))
    return coefficients, weights, deviation, weights @ data.common + crossing


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
