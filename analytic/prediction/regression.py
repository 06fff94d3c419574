"""A polynomial through the samples, from which quantiles and Sobol indices are read.

It is quadratic in the scores of the inputs: every input and its square, and products of the inputs that matter most.
How many products are good is decided by leaving out each sample in turn. Values above 0 are fitted by their logarithm.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import cholesky, solve_triangular

from analytic.scene import Array

PRODUCTS = (0, 3, 5, 8, 12, 20)  # inputs whose products are tried
LEAST_PER_TERM = 2  # samples for each coefficient
GROUPS = 16  # of samples that the jackknife leaves out in turn


@dataclass(frozen=True, kw_only=True)
class Basis:
    """The terms: 1, every score z, (z^2 - 1)/sqrt(2) if `squares`, and the products of `paired`.

    A basis with fewer of the first `paired` has the first of these terms.
    """

    squares: bool
    paired: tuple[int, ...]  # inputs

    def at(self, scores: Array) -> Array:
        """(N, terms) of the scores (N, d); terms are orthonormal for normal scores."""
        columns = [np.ones((scores.shape[0], 1)), scores]
        if self.squares:
            columns.append((scores**2 - 1) / np.sqrt(2))
        for number, each in enumerate(self.paired):
            columns.append(scores[:, [each]] * scores[:, self.paired[:number]])
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

    def without_groups(self, scores: Array, values: Array, columns: NDArray[np.intp]) -> Callable[[Array], Array]:
        """Some quantities by the whole polynomial, and by those that are fitted without each group of the samples.

        scores, values : of the samples;  columns : (k,) numbers of the quantities
        The function takes points (d, M) and gives ((1 + GROUPS) k, M). With the terms A = Q R of all samples and Q_g of
        a group, the coefficients without it are R^-1 (1 - Q_g' Q_g)^-1 (Q' y - Q_g' y_g).
        """
        is_log = self.is_log[columns]
        fitted = _logarithms(values[:, columns], is_log)
        q, r = _factors(self.basis.at(scores))
        whole, rotated = q.T @ fitted, []
        for own, its in ((q[group::GROUPS], fitted[group::GROUPS]) for group in range(GROUPS)):
            rotated.append(np.linalg.solve(np.eye(len(r)) - own.T @ own, whole - own.T @ its))
        coefficients = solve_triangular(r, np.concatenate([whole, *rotated], axis=1))
        logarithms = np.tile(is_log, 1 + GROUPS)

        def polynomials(points: Array) -> Array:
            return _plain(self.basis.at(points.T) @ coefficients, logarithms).T

        return polynomials


def regression_of(scores: Array, values: Array) -> Regression:
    """The regression of values (N, m) on scores (N, d), with the basis that predicts left-out samples best."""
    count, inputs = scores.shape
    is_log = np.all(values > 0, axis=0)
    fitted = _logarithms(values, is_log)
    varies = np.ptp(fitted, axis=0) > 0
    bases = [Basis(squares=False, paired=())]
    if LEAST_PER_TERM * (1 + 2 * inputs) <= count:
        order = _by_importance(scores, fitted[:, varies])
        for most in PRODUCTS:
            basis = Basis(squares=True, paired=order[:most])
            if LEAST_PER_TERM * basis.at(scores[:1]).shape[1] <= count:
                bases.append(basis)
    # Each basis has the first terms of the next one, so that one factorisation serves all.
    q, r = _factors(bases[-1].at(scores))
    sizes = [basis.at(scores[:1]).shape[1] for basis in bases]
    errors = [_left_out_errors(q[:, :size], fitted) for size in sizes]
    best = min(range(len(bases)), key=lambda place: _lost(errors[place][:, varies], fitted[:, varies]))
    size = sizes[best]
    plain = _plain(fitted - errors[best], is_log)
    spread = np.maximum(values.var(axis=0), np.finfo(float).tiny)
    explained = np.where(varies, 1 - np.mean((plain - values) ** 2, axis=0) / spread, 1.0)
    return Regression(
        basis=bases[best],
        coefficients=solve_triangular(r[:size, :size], q[:, :size].T @ fitted),
        is_log=is_log,
        left_out=np.where(varies, plain, values),
        explained=explained,
    )


def _by_importance(scores: Array, fitted: Array) -> tuple[int, ...]:
    """The inputs from the one that alone makes most of what varies, by a polynomial of every input and its square."""
    q, r = _factors(Basis(squares=True, paired=()).at(scores))
    weights = (solve_triangular(r, q.T @ fitted)[1:] ** 2).reshape(2, scores.shape[1], -1).sum(axis=0)
    weights /= np.maximum(weights.sum(axis=0), np.finfo(float).tiny)
    return tuple(np.argsort(-weights.sum(axis=1), kind="stable").tolist())


def _factors(terms: Array) -> tuple[Array, Array]:
    """Q with orthonormal columns and the upper triangle R, terms = Q R.

    By Cholesky's method, in a third of the time that Householder's takes: the terms are nearly orthogonal, and the
    samples are at least twice as many.
    """
    r = cholesky(terms.T @ terms)
    return np.asarray(solve_triangular(r, terms.T, trans="T").T, dtype=np.float64), np.asarray(r, dtype=np.float64)


def _logarithms(values: Array, is_log: Array) -> Array:
    return np.where(is_log, np.log(np.where(is_log, values, 1.0)), values)


def _plain(fitted: Array, is_log: Array) -> Array:
    return np.where(is_log, np.exp(np.where(is_log, fitted, 0.0)), fitted)


def _left_out_errors(q: Array, fitted: Array) -> Array:
    """Residual of each sample by the polynomial through the others: the residual over 1 - leverage.

    q : orthonormal columns that span the terms
    """
    leverage = np.minimum(np.sum(q**2, axis=1, keepdims=True), 1 - 1e-9)
    return (fitted - q @ (q.T @ fitted)) / (1 - leverage)


def _lost(errors: Array, fitted: Array) -> float:
    """Mean share of the variance that left-out predictions miss."""
    if fitted.shape[1] == 0:  # nothing varies: any basis is as good
        return 0.0
    return float(np.mean(np.sum(errors**2, axis=0) / np.sum((fitted - fitted.mean(axis=0)) ** 2, axis=0)))
