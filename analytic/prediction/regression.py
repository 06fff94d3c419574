"""A polynomial through the samples, from which quantiles and Sobol indices are read.

It is quadratic in the scores of the inputs: every input and its square, and products of the inputs that matter most.
How many products are good is decided by leaving out each sample in turn. Values above 0 are fitted by their logarithm.
"""

from collections.abc import Callable
from dataclasses import dataclass
from itertools import combinations

import numpy as np

from analytic.scene import Array

PRODUCTS = (0, 3, 5, 8, 12, 20)  # inputs whose products are tried
LEAST_PER_TERM = 2  # samples for each coefficient
GROUPS = 16  # of samples that the jackknife leaves out in turn


@dataclass(frozen=True, kw_only=True)
class Basis:
    """The terms: 1, every score z, (z^2 - 1)/sqrt(2) if `squares`, and the products of `paired`."""

    squares: bool
    paired: tuple[int, ...]  # inputs

    def at(self, scores: Array) -> Array:
        """(N, terms) of the scores (N, d); terms are orthonormal for normal scores."""
        columns = [np.ones((scores.shape[0], 1)), scores]
        if self.squares:
            columns.append((scores**2 - 1) / np.sqrt(2))
        columns += [(scores[:, a] * scores[:, b])[:, None] for a, b in combinations(self.paired, 2)]
        return np.concatenate(columns, axis=1)


@dataclass(frozen=True, kw_only=True, eq=False)
class Regression:
    """Polynomials of m quantities."""

    basis: Basis
    coefficients: Array  # (terms, m)
    is_log: Array  # (m,) bool: whether it is the logarithm that is fitted
    left_out: Array  # (N, m) each sample by the polynomial through the others
    explained: Array  # (m,) share of the variance that these predict, at most 1

    def at(self, scores: Array) -> Array:
        """(M, m) of the scores (M, d)."""
        return _plain(self.basis.at(scores) @ self.coefficients, self.is_log)

    def without_groups(self, scores: Array, values: Array, column: int) -> Callable[[Array], Array]:
        """One quantity by the whole polynomial, and by those that are fitted without each group of the samples.

        scores, values : of the samples;  the function takes points (d, M) and gives (1 + GROUPS, M)
        """
        terms, is_log = self.basis.at(scores), bool(self.is_log[column])
        fitted = np.log(values[:, column]) if is_log else values[:, column]
        group = np.arange(fitted.size) % GROUPS
        parts = [_coefficients(terms[group != each], fitted[group != each]) for each in range(GROUPS)]
        coefficients = np.stack([self.coefficients[:, column], *parts])

        def polynomials(points: Array) -> Array:
            found = coefficients @ self.basis.at(points.T).T
            return np.exp(found) if is_log else found

        return polynomials


def regression_of(scores: Array, values: Array) -> Regression:
    """The regression of values (N, m) on scores (N, d), with the basis that predicts left-out samples best."""
    count, inputs = scores.shape
    is_log = np.all(values > 0, axis=0)
    fitted = np.where(is_log, np.log(np.where(is_log, values, 1.0)), values)
    varies = np.ptp(fitted, axis=0) > 0
    bases = [Basis(squares=False, paired=())]
    if LEAST_PER_TERM * (1 + 2 * inputs) <= count:
        squares = Basis(squares=True, paired=())
        weights = (_coefficients(squares.at(scores), fitted)[1:] ** 2).reshape(2, inputs, -1).sum(axis=0)
        weights = weights[:, varies] / np.maximum(weights[:, varies].sum(axis=0), np.finfo(float).tiny)
        order = np.argsort(-weights.sum(axis=1), kind="stable")
        for most in PRODUCTS:
            basis = Basis(squares=True, paired=tuple(sorted(order[:most].tolist())))
            if LEAST_PER_TERM * basis.at(scores[:1]).shape[1] <= count:
                bases.append(basis)
    best = min(bases, key=lambda basis: _lost(basis, scores, fitted[:, varies]))
    terms = best.at(scores)
    left_out = fitted - _left_out_errors(terms, fitted)
    plain = _plain(left_out, is_log)
    spread = np.maximum(values.var(axis=0), np.finfo(float).tiny)
    explained = np.where(varies, 1 - np.mean((plain - values) ** 2, axis=0) / spread, 1.0)
    return Regression(
        basis=best,
        coefficients=_coefficients(terms, fitted),
        is_log=is_log,
        left_out=np.where(varies, plain, values),
        explained=explained,
    )


def _plain(fitted: Array, is_log: Array) -> Array:
    return np.where(is_log, np.exp(np.where(is_log, fitted, 0.0)), fitted)


def _coefficients(terms: Array, fitted: Array) -> Array:
    return np.asarray(np.linalg.lstsq(terms, fitted)[0], dtype=np.float64)


def _left_out_errors(terms: Array, fitted: Array) -> Array:
    """Residual of each sample by the polynomial through the others: the residual over 1 - leverage."""
    q, _ = np.linalg.qr(terms)
    leverage = np.minimum(np.sum(q**2, axis=1, keepdims=True), 1 - 1e-9)
    return (fitted - q @ (q.T @ fitted)) / (1 - leverage)


def _lost(basis: Basis, scores: Array, fitted: Array) -> float:
    """Mean share of the variance that left-out predictions miss."""
    if fitted.shape[1] == 0:  # nothing varies: any basis is as good
        return 0.0
    errors = _left_out_errors(basis.at(scores), fitted)
    return float(np.mean(np.sum(errors**2, axis=0) / np.sum((fitted - fitted.mean(axis=0)) ** 2, axis=0)))
