"""F = K delta^n fitted to a load series, its tangents, and how uncertain both are.

F: load, N, exact; delta: approach, m, each with a half-width of its own.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.stats import t as student

from fembearing.compare.contact.uncertainty import Estimate

Array = NDArray[np.float64]
ALIKE = 0.3  # in ln F, a tenth of a semi-axis: of loads further apart, errors off the mesh have nothing in common
CONFIDENCE = 0.95
ENOUGH = 5  # distinct loads, for the tangents to bend away from a power law


@dataclass(frozen=True, kw_only=True)
class StiffnessLaw:
    """F = K delta^n, fitted to a series. Uncertainties but `propagated` are None of two loads, which fit it always."""

    stiffness: float  # K, N/m^n: extrapolated to 1 m, to be used with n alone
    exponent: float  # n
    stiffness_uncertainty: float | None  # of K, relative half-width, 95 %: large, as it is far from any load
    misfit: float | None  # what n owes to loads that are no power law
    propagated: float  # what it owes to uncertain approaches

    @property
    def exponent_uncertainty(self) -> float | None:
        """Half-width, 95 %, absolute: both parts added, since nothing says that they are independent."""
        return None if self.misfit is None else self.misfit + self.propagated

    def load(self, approach: ArrayLike) -> Array:
        """N, at approaches of any shape, m."""
        return self.stiffness * np.asarray(approach, dtype=np.float64) ** self.exponent


@dataclass(frozen=True, kw_only=True, eq=False)
class LawData:
    """What a law is fitted to, (n,) each: distinct loads, rising, and relative half-widths of their approaches."""

    load: Array  # N
    approach: Array  # m
    common: Array  # errors that may have one cause at all loads
    crossing: Array  # errors off the mesh

    @classmethod
    def of(cls, loads: Array, approaches: Sequence[Estimate], crossing: Sequence[float]) -> "LawData":
        """From loads in any order, each as often as may be."""
        load, index = np.unique(loads, return_index=True)
        total = np.array([approaches[i].total for i in index])
        off = np.array([crossing[i] for i in index])
        value = np.array([approaches[i].value for i in index])
        return cls(load=load, approach=value, common=total - off, crossing=off)

    @property
    def redundant(self) -> bool:
        """Whether there are loads left over to judge a power law by."""
        return self.load.size > 2


def fit_law(data: LawData) -> StiffnessLaw | None:
    """F = K delta^n; None where there is only one load.

    Loads are exact and approaches are not: ln delta is fitted over ln F by least squares, and 1/n is its slope. Two
    loads show no departure from it: they are given a law, which is then assumed, and no interval.
    """
    if data.load.size < 2:
        return None
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load)])
    (intercept, slope), weights, deviation, propagated = _fitted(data, basis, of=np.array([[0.0, 1.0]]))
    exponent = 1 / slope
    logarithm = -intercept * exponent  # of K
    _, moves, _, uncertain = _fitted(data, basis, of=np.array([[-exponent, -logarithm * exponent]]))  # d ln K
    return StiffnessLaw(
        stiffness=float(np.exp(logarithm)),
        exponent=float(exponent),
        stiffness_uncertainty=float(deviation * np.linalg.norm(moves) + uncertain[0]) if data.redundant else None,
        misfit=float(exponent**2 * deviation * np.linalg.norm(weights)) if data.redundant else None,
        propagated=float(exponent**2 * propagated[0]),
    )


def fit_tangents(data: LawData, loads: Array, approaches: Sequence[Estimate]) -> list[tuple[float, float | None]]:
    """dF/d(delta), N/m, and its relative uncertainty, at each of `loads`, (n,) N with their `approaches`.

    From five loads on, the slope of ln delta = c0 + c1 ln F + c2 F^(1/3): a groove departs from its power law as the
    contact's size over the body's, which goes as F^(1/3). Fewer loads give the slope of the power law itself, two of
    them without an uncertainty.
    """
    terms = 3 if data.load.size >= ENOUGH else 2
    largest = data.load[-1]
    basis = np.column_stack([np.ones(data.load.size), np.log(data.load), (data.load / largest) ** (1 / 3)])
    of = np.column_stack([np.zeros(loads.size), np.ones(loads.size), (loads / largest) ** (1 / 3) / 3])[:, :terms]
    coefficients, weights, deviation, propagated = _fitted(data, basis[:, :terms], of=of)
    slope = of @ coefficients  # of ln delta over ln F
    # What a power law leaves over is a curve that it does not know, no chance: neighbouring loads share its sign.
    misfit = deviation * np.linalg.norm(weights, ord=1 if terms == 2 else 2, axis=1)
    tangent = loads / np.array([part.value for part in approaches]) / slope
    uncertainty = (misfit + propagated) / np.abs(slope) + np.array([part.total for part in approaches])
    known = uncertainty.tolist() if data.redundant else [None] * loads.size
    return list(zip(tangent.tolist(), known, strict=True))


def _fitted(data: LawData, basis: Array, *, of: Array) -> tuple[Array, Array, float, Array]:
    """Coefficients (k,) of ln delta over `basis` (n, k); for each row of `of` (m, k), a combination of them, how each
    load moves it, (m, n), absolute; the deviation from the fit, 95 %, 0 where nothing is left over; and for each row
    the half-width (m,) that it owes to uncertain approaches.

    Common errors count as if each had the sign that hurts most, and so do those off the mesh at neighbouring loads;
    apart from each other these add as squares.
    """
    inverse = np.asarray(np.linalg.pinv(basis), dtype=np.float64)  # its stub promises any float
    values = np.log(data.approach)
    coefficients = inverse @ values
    weights = np.abs(of @ inverse)
    left = basis.shape[0] - basis.shape[1]
    deviation = 0.0
    if left > 0:
        scatter = np.sqrt(np.sum((values - basis @ coefficients) ** 2) / left)
        deviation = float(student.ppf((1 + CONFIDENCE) / 2, left) * scatter)
    cell = np.floor(np.log(data.load) / ALIKE)
    alike = (cell[:, None] == np.unique(cell)).astype(float)
    crossing = np.sqrt(np.sum(((weights * data.crossing) @ alike) ** 2, axis=1))
    return coefficients, weights, deviation, weights @ data.common + crossing
