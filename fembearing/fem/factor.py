"""Factors of a symmetric positive definite matrix K, by MKL's PARDISO, or by SciPy's SuperLU where there is no MKL.

K comes as its upper triangle; with it comes a border B of further columns. Both factors give B.T K^-1 B and K^-1 r.
PARDISO eliminates K from [K B; B.T 0] without ever computing K^-1 B: the Schur complement that remains is -B.T K^-1 B.
A matrix that PARDISO gives up is left to SuperLU, with a warning.
"""

import ctypes
import os
import sys
import warnings
import weakref
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError
from scipy.sparse import csr_matrix, hstack, triu, vstack
from scipy.sparse.linalg import splu

# MKL's own packages install it here. Without this hint pypardiso searches the whole environment for half a second.
for library in Path(sys.prefix, "lib").glob("libmkl_rt.so*"):
    os.environ.setdefault("PYPARDISO_MKL_RT", str(library))
try:
    from pypardiso import PyPardisoSolver
except ImportError:  # other processors than x86-64 have no MKL
    PyPardisoSolver = None

Array = NDArray[np.float64]
OUT_OF_MEMORY = (-2, -8, -9)  # status codes of PARDISO: too little memory, too many entries to count, disk full
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
    if PyPardisoSolver is None:
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
        self._matrix, self._source = _bordered(upper, border)
        assert PyPardisoSolver is not None  # `new_factor` has checked it
        self._solver = PyPardisoSolver(mtype=2)  # symmetric positive definite, upper triangle
        has_border = int(self._columns > 0)
        for number, value in ((1, 1), (2, 2), (10, 8), (36, has_border)):  # own settings, METIS, pivot 1e-8, complement
            self._solver.set_iparm(number, value)
        self._solver.perm = np.repeat(np.array([0, 1], dtype=np.int32), [self._size, self._columns])
        weakref.finalize(self, self._solver.free_memory, everything=True).atexit = False  # the process frees it then
        self._values: Array = np.array([])  # of the upper triangle that is factored
        self._call(ANALYSIS, np.zeros(self._matrix.shape[0]))

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
        self._call(RELEASE, np.zeros(self._matrix.shape[0]))

    @property
    def memory(self) -> int:
        """As `Factor`."""
        counts = (PERMANENT, FACTORS) if self._values.size else (PERMANENT,)
        arrays = (self._source, self._matrix.data, self._matrix.indices, self._values)
        return sum(1024 * int(self._solver.get_iparm(each)) for each in counts) + sum(each.nbytes for each in arrays)

    def _factored(self, upper: csr_matrix, stored: Array) -> Array:
        """The Schur complement of K, and its factor for `solution`; `stored` are the entries of the border."""
        self._values = np.array([])
        self._matrix.data[:] = np.concatenate([[0.0], upper.data, stored])[self._source]
        count = self._columns
        found = self._call(NUMBERS, np.zeros(max(self._matrix.shape[0], count**2)))[: count**2]
        self._values = upper.data
        return found.reshape(count, count)

    def _call(self, phase: int, right: Array) -> Array:
        """One phase of PARDISO; the answer has the size of `right`."""
        with _one_thread(self._solver.libmkl):
            found, status = _pardiso(self._solver, phase, self._matrix, right)
        if status in OUT_OF_MEMORY:
            raise MemoryError(f"PARDISO status {status}")
        if status != 0:
            raise LinAlgError(f"PARDISO status {status}")
        return found


def _pardiso(solver: Any, phase: int, matrix: csr_matrix, right: Array) -> tuple[Array, int]:
    """The answer of MKL's function `pardiso` to one phase, and its status, 0 for success.

    pypardiso has no call for a phase alone or for a Schur complement; its solver holds the library and the state.
    """

    def whole(number: int) -> object:
        return ctypes.byref(ctypes.c_int32(number))

    def whole_numbers(array: NDArray[np.int32]) -> object:
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_int32))

    def numbers(array: Array) -> object:
        return array.ctypes.data_as(ctypes.POINTER(ctypes.c_double))

    found, status = np.zeros_like(right), ctypes.c_int32(0)
    starts, columns = ((part + 1).astype(np.int32) for part in (matrix.indptr, matrix.indices))  # counted from 1
    solver.libmkl.pardiso(
        solver.pt.ctypes.data_as(ctypes.POINTER(ctypes.c_int64)),
        whole(1),  # matrices with a factor
        whole(1),  # number of this one
        whole(solver.mtype),
        whole(phase),
        whole(matrix.shape[0]),
        numbers(matrix.data),
        whole_numbers(starts),
        whole_numbers(columns),
        whole_numbers(solver.perm),
        whole(1),  # columns of `right`
        whole_numbers(solver.iparm),
        whole(0),  # prints nothing
        numbers(right),
        numbers(found),
        ctypes.byref(status),
    )
    return found, status.value


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
    """Number of factors to work on at a time: the threads that MKL would use, as MKL_NUM_THREADS or the cores set it.

    It is 1 without MKL.
    """
    return 1 if PyPardisoSolver is None else int(PyPardisoSolver().libmkl.MKL_Get_Max_Threads())


@contextmanager
def _one_thread(mkl: ctypes.CDLL) -> Iterator[None]:
    """Let MKL use one thread for what this thread asks of it."""
    before = mkl.MKL_Set_Num_Threads_Local(1)
    try:
        yield
    finally:
        mkl.MKL_Set_Num_Threads_Local(before)


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
