"""Factors of a symmetric positive definite matrix K, by MKL's PARDISO, or by SciPy's SuperLU where there is no MKL.

K comes as its upper triangle. Both factors give K^-1 r, and B.T K^-1 B for a border B of further columns. A matrix that
PARDISO gives up is left to SuperLU, with a warning.
"""

import os
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Protocol

import numpy as np
from scipy.linalg import LinAlgError
from scipy.sparse import csr_matrix, triu
from scipy.sparse.linalg import splu

from analytic.scene import Array

try:
    from pymklpardiso import PardisoSolver
except ImportError:  # other processors than x86-64 have no MKL
    PardisoSolver = None

OUT_OF_MEMORY = ("not enough memory", "32-bit integer overflow", "not enough out-of-core memory")  # in its errors
POSITIVE_DEFINITE = 2  # its type of matrices that are real and symmetric too
RELEASE, FORWARD, SOLUTION = 0, 331, 33  # phases of PARDISO
PERMANENT, FACTORS = 15, 16  # indices of its counts of memory, kB
AT_ONCE = 64  # columns of a border that are dense at a time
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


def new_factor(upper: csr_matrix) -> Factor:
    """A factor for matrices with the stored entries of this one, its diagonal among them."""
    if PardisoSolver is None:
        return SuperLUFactor()
    try:
        return FactorWithSubstitute(PardisoFactor(upper), substitute=SuperLUFactor())
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

    def __init__(self, upper: csr_matrix) -> None:
        assert PardisoSolver is not None  # `new_factor` has checked it
        with _named_errors():
            self._solver = PardisoSolver(upper, POSITIVE_DEFINITE, {1: 2, 9: 8})  # METIS, pivot 1e-8
        self._entries, self._values = upper.nnz, upper.data  # of the upper triangle that is factored

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """As `Factor`, by K = L L.T."""
        self._factor(upper)
        half = np.zeros(border.shape, order="F")  # L^-1 B
        for start in range(0, border.shape[1], AT_ONCE):
            some = slice(start, start + AT_ONCE)
            self._run(FORWARD, border[:, some].toarray(order="F"), half[:, some])
        return half.T @ half

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """As `Factor`."""
        self._factor(upper)
        found = np.zeros_like(right)
        self._run(SOLUTION, right, found)
        return found

    def forget_numbers(self) -> None:
        """As `Factor`."""
        self._values = np.array([])
        self._solver.run_phase(RELEASE)

    @property
    def memory(self) -> int:
        """As `Factor`."""
        counts = (PERMANENT, FACTORS) if self._values.size else (PERMANENT,)
        return (
            sum(1024 * self._solver.get_iparm_value(each) for each in counts) + 16 * self._entries + self._values.nbytes
        )

    def _factor(self, upper: csr_matrix) -> None:
        """Nothing where the last matrix was the same."""
        if np.array_equal(self._values, upper.data):
            return
        self._values = np.array([])
        with _named_errors():
            self._solver.refactor(upper.data)
        self._values = upper.data

    def _run(self, phase: int, right: Array, found: Array) -> None:
        with _named_errors():
            self._solver.run_phase_into(phase, right, found)


@contextmanager
def _named_errors() -> Iterator[None]:
    """Raise MemoryError or LinAlgError for PARDISO's RuntimeError."""
    try:
        yield
    except RuntimeError as problem:
        raise (MemoryError if any(said in str(problem) for said in OUT_OF_MEMORY) else LinAlgError)(
            problem
        ) from problem


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
        try:
            factor = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options)
        except RuntimeError as problem:  # "Factor is exactly singular"
            raise LinAlgError(problem) from problem
        return factor.solve(right)
