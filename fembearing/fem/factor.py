"""Factors of a symmetric positive definite matrix K, by MKL's PARDISO, or by SciPy's SuperLU where there is no MKL.

K comes as its upper triangle; with it comes a border B of further columns. Both factors give B.T K^-1 B and K^-1 r.
PARDISO eliminates K from [K B; B.T 0] without ever computing K^-1 B: the Schur complement that remains is -B.T K^-1 B.
A matrix that PARDISO gives up is left to SuperLU, with a warning.
"""

import os
import warnings
from typing import Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError
from scipy.sparse import csr_matrix, hstack, triu, vstack
from scipy.sparse.linalg import splu

from analytic.scene import Array

try:  # the package's public class factors before it can be told which columns are the border
    from pymklpardiso._mkl_pardiso import PardisoSolver
except ImportError:  # other processors than x86-64 have no MKL
    PardisoSolver = None

OUT_OF_MEMORY = ("not enough memory", "32-bit integer overflow", "not enough out-of-core memory")  # in its errors
RELEASE, ANALYSIS, NUMBERS, FORWARD, BACKWARD = 0, 11, 22, 331, 333  # phases of PARDISO
PERMANENT, FACTORS = 16, 17  # its counts of memory, kB
GIVEN_UP = "PARDISO gave up a matrix ({}): SciPy's SuperLU solved it instead, which takes many times as long"


class Factor(Protocol):
    """For matrices of one sparsity. Both methods raise LinAlgError for a matrix without a factor, or MemoryError."""

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """B.T K^-1 B, (k, k), for the upper triangle of K, (n, n), and B, (n, k)."""
        ...

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """K^-1 right, (n,)."""
        ...

    def forget_numbers(self) -> None:
        """Keep what every matrix of the sparsity has in common alone."""
        ...

    @property
    def memory(self) -> int:
        """Bytes that it holds."""
        ...


def new_factor(upper: csr_matrix, border: csr_matrix) -> Factor:
    """A factor for matrices and borders with the stored entries of these."""
    if PardisoSolver is None:
        return SuperLUFactor()
    try:
        return FactorWithSubstitute(PardisoFactor(upper, border), substitute=SuperLUFactor())
    except LinAlgError as problem:
        warnings.warn(GIVEN_UP.format(problem), RuntimeWarning, stacklevel=2)
        return SuperLUFactor()


class FactorWithSubstitute:
    """A factor, and another for a matrix that the first one gives up; an error of both is that of the substitute."""

    def __init__(self, factor: Factor, *, substitute: Factor) -> None:
        self._factor, self._substitute = factor, substitute

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """As `Factor`."""
        try:
            return self._factor.complement(upper, border)
        except LinAlgError as problem:
            return self._noted(self._substitute.complement(upper, border), problem)

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """As `Factor`."""
        try:
            return self._factor.solution(upper, right)
        except LinAlgError as problem:
            return self._noted(self._substitute.solution(upper, right), problem)

    def forget_numbers(self) -> None:
        """As `Factor`."""
        self._factor.forget_numbers()

    @property
    def memory(self) -> int:
        """As `Factor`."""
        return self._factor.memory

    @staticmethod
    def _noted(found: Array, problem: LinAlgError) -> Array:
        warnings.warn(GIVEN_UP.format(problem), RuntimeWarning, stacklevel=3)
        return found


class PardisoFactor:
    """PARDISO, which works out the order of elimination once for all matrices of one sparsity.

    It runs on one thread: its last digits depend on the number of threads, and two of them take more time in all.
    """

    def __init__(self, upper: csr_matrix, border: csr_matrix) -> None:
        self._size, self._columns = border.shape
        self._stored = border.nnz
        matrix, self._source = _bordered(upper, border)
        self._rows, self._entries = matrix.shape[0], matrix.nnz
        assert PardisoSolver is not None  # `new_factor` has checked it
        self._solver = PardisoSolver(mtype=2)  # symmetric positive definite, upper triangle
        for number, value in ((2, 2), (10, 8), (36, int(self._columns > 0))):  # METIS, pivot 1e-8, complement
            self._solver.set_iparm(number - 1, value)
        self._solver.set_pattern(matrix.indptr, matrix.indices, self._rows)
        self._solver.set_perm(np.repeat([0, 1], [self._size, self._columns]))
        self._values: Array = np.array([])  # of the upper triangle that is factored
        self._call(ANALYSIS, np.zeros(self._rows))

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """As `Factor`."""
        largest = abs(border).max(axis=0).toarray().ravel()
        scale = upper.diagonal().max() / np.where(largest > 0, largest, 1.0)  # same magnitude as the matrix
        found = self._factored(upper, border.data * scale[border.indices])
        return -found / np.outer(scale, scale)

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """As `Factor`; the numbers are factored again only where the last ones were another matrix."""
        if not np.array_equal(self._values, upper.data):
            self._factored(upper, np.zeros(self._stored))
        begun = self._call(FORWARD, np.append(right, np.zeros(self._columns)))
        begun[self._size :] = 0.0  # the border is no part of K
        return self._call(BACKWARD, begun)[: self._size]

    def forget_numbers(self) -> None:
        """As `Factor`."""
        self._values = np.array([])
        self._call(RELEASE, np.zeros(self._rows))

    @property
    def memory(self) -> int:
        """As `Factor`."""
        counts = (PERMANENT, FACTORS) if self._values.size else (PERMANENT,)
        own = 8 * (2 * self._entries + self._rows) + self._source.nbytes + self._values.nbytes  # numbers of 64 bits
        return sum(1024 * self._solver.get_iparm_value(each - 1) for each in counts) + own

    def _factored(self, upper: csr_matrix, stored: Array) -> Array:
        """The Schur complement of K, and its factor for `solution`; `stored` are the entries of the border."""
        self._values = np.array([])
        self._solver.set_values(np.concatenate([[0.0], upper.data, stored])[self._source])
        count = self._columns
        room = np.zeros((self._rows, max(1, -(-(count**2) // self._rows))), order="F")  # for all of the complement
        found = self._call(NUMBERS, room).ravel(order="F")[: count**2]
        self._values = upper.data
        return found.reshape(count, count)

    def _call(self, phase: int, right: Array) -> Array:
        """One phase of PARDISO; the answer has the shape of `right`."""
        found = np.zeros_like(right)
        try:
            self._solver.run_phase_into(phase, right, found)
        except RuntimeError as problem:
            if any(reason in str(problem) for reason in OUT_OF_MEMORY):
                raise MemoryError(str(problem)) from problem
            raise LinAlgError(str(problem)) from problem
        return found


def _bordered(upper: csr_matrix, border: csr_matrix) -> tuple[csr_matrix, NDArray[np.int32]]:
    """[K B; 0 0], a triangle with a stored diagonal; and where each of its entries comes from.

    The entries are numbered: 0 a stored zero, then those of K, then those of B.
    """
    size, columns = border.shape
    first, second, all_ = np.cumsum([1.0, upper.nnz, border.nnz])
    known = csr_matrix((np.arange(first, second), upper.indices, upper.indptr), shape=(size, size))
    added = csr_matrix((np.arange(second, all_), border.indices, border.indptr), shape=border.shape)
    corner = csr_matrix((np.zeros(columns), np.arange(columns), np.arange(columns + 1)), shape=(columns, columns))
    below = hstack([csr_matrix((columns, size)), corner])
    matrix = csr_matrix(vstack([hstack([known, added]), below], format="csr"))
    matrix.sort_indices()
    return matrix, matrix.data.astype(np.int32)


def solver_threads() -> int:
    """Number of factors to work on at a time: MKL_NUM_THREADS, OMP_NUM_THREADS, or the cores of this process.

    It is 1 without PARDISO.
    """
    if PardisoSolver is None:
        return 1
    for name in ("MKL_NUM_THREADS", "OMP_NUM_THREADS"):
        given = os.environ.get(name, "").partition(",")[0].strip()  # of nested threads the outer ones
        if given.isdecimal() and int(given) > 0:
            return int(given)
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


class SuperLUFactor:
    """SciPy's SuperLU, which solves for each column of the border and cannot keep an order of elimination."""

    memory = 0

    def forget_numbers(self) -> None:
        """As `Factor`."""

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """As `Factor`."""
        return border.T @ self.solution(upper, border.toarray())

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """As `Factor`; `right` may have columns too."""
        matrix = (upper + triu(upper, 1).T).tocsc()
        options = {"SymmetricMode": True}
        return splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options).solve(right)
