"""What the equations of two bodies have in common if they differ in shape and material alone.

The cells, and the degrees of freedom that are held, decide where each entry of a cell goes in the matrix of the free
ones and in which order that matrix is eliminated. Both take longer than the rest of a coarse mesh; they are worked out
once and kept for the next load, groove or material on the same cells.
"""

import threading
from collections import OrderedDict
from hashlib import blake2b

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix

from analytic.scene import Array
from fembearing.fem.elasticity import AT_ONCE, CELL, PAIRS
from fembearing.fem.factor import Factor, new_factor

Numbers = NDArray[np.intp]
MOST_MEMORY = 2**29  # bytes kept; the third level of two bodies takes half of it


class Topology:
    """Cells and free degrees of freedom: where the entries of the cells go, and the factor of the matrix.

    A degree of freedom has the number axis * nodes + node. The free ones are ordered node by node, for which METIS
    takes a sixth less time than axis by axis.
    """

    def __init__(self, cells: Numbers, held: NDArray[np.bool_]) -> None:
        """cells : (27, c) nodes of each cell; held : (3, nodes)"""
        functions, count = cells.shape
        nodes = held.shape[1]
        node, axis = np.nonzero(~held.T)
        self.free: Numbers = axis * nodes + node
        position = np.full((3, nodes), -1, dtype=np.int32)
        position[axis, node] = np.arange(node.size)
        rank = (np.cumsum(~held, axis=0) - 1)[axis, node].astype(np.int32)  # among the free ones of its node
        each = np.bincount(node, minlength=nodes)  # free ones of each node

        # The row of a node in the upper triangle of a matrix over nodes holds it and those of larger number.
        whole = cells.T.astype(np.int64)  # products of 32-bit numbers overflow from 46 341 nodes on
        first, second = (whole[:, number] for number in np.tril_indices(functions))
        keys, pair = np.unique(np.minimum(first, second) * nodes + np.maximum(first, second), return_inverse=True)
        low, high = np.divmod(keys, nodes)
        before = np.cumsum(each[high]) - each[high]  # free ones of the pairs before, of all rows
        starts = np.searchsorted(low, np.arange(nodes))
        length = np.bincount(low, weights=each[high], minlength=nodes).astype(np.int64)  # 0 for a node without cells
        before = (before - before[starts[low]]).astype(np.int32)[pair].reshape(count, -1)  # in this row
        # Each free one of a node has a row of its own, without those of the node that come before it.
        self._starts = np.append(0, np.cumsum(length[node] - rank)).astype(np.int32)

        held_place = self._starts[-1]  # one for all entries of what is held
        row_start = self._starts[:-1] - rank
        smaller, larger = np.sort([number % functions for number in PAIRS], axis=0)
        of_pair = larger * (larger + 1) // 2 + smaller
        self._columns = np.empty(held_place + 1, dtype=np.int32)
        place = np.empty((count, of_pair.size), dtype=np.int32)
        for start in range(0, count, AT_ONCE):
            some = slice(start, start + AT_ONCE)
            of_cell = position[:, cells[:, some]].reshape(CELL, -1).T
            one, other = (of_cell[:, number] for number in PAIRS)
            row, column = np.minimum(one, other), np.maximum(one, other)
            place[some] = row_start[row] + before[some][:, of_pair] + rank[column]
            place[some][row < 0] = held_place
            self._columns[place[some]] = column
        self._place = place.ravel()
        self._lock = threading.Lock()
        self._factor: Factor | None = None

    def assembled(self, entries: Array) -> csr_matrix:
        """The upper triangle of the matrix of the free degrees of freedom, from the `cell_stiffness` of all cells."""
        total = np.bincount(self._place, weights=entries.ravel(), minlength=self._columns.size)
        return csr_matrix((total[:-1], self._columns[:-1], self._starts), shape=(self.free.size,) * 2)

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Array:
        """B.T K^-1 B, (k, k), for the upper triangle of K from `assembled`, and B, (n, k); raises as `Factor`."""
        with self._lock:
            found = self._factor_of(upper).complement(upper, border)
        _shrink()
        return found

    def solution(self, upper: csr_matrix, right: Array) -> Array:
        """K^-1 right, (n,); raises as `Factor`."""
        with self._lock:
            return self._factor_of(upper).solution(upper, right)

    def forget_numbers(self) -> int:
        """Let go of the last matrix, unless it is in use; returns the bytes gained."""
        if self._factor is None or not self._lock.acquire(blocking=False):
            return 0
        try:
            before = self.memory
            self._factor.forget_numbers()
            return before - self.memory
        finally:
            self._lock.release()

    @property
    def memory(self) -> int:
        """Bytes that it holds."""
        own = self._place.nbytes + self._columns.nbytes + self._starts.nbytes
        return own + (0 if self._factor is None else self._factor.memory)

    def _factor_of(self, upper: csr_matrix) -> Factor:
        if self._factor is None:
            self._factor = new_factor(upper)
        return self._factor


_kept: OrderedDict[bytes, Topology] = OrderedDict()  # the one used last comes last
_keeping = threading.Lock()


def topology_of(cells: Numbers, held: NDArray[np.bool_]) -> Topology:
    """The topology of these cells, (27, c), and held degrees of freedom, (3, nodes).

    The last ones used are kept, as many as fit into `MOST_MEMORY`; the last one in any case. Any thread may ask.
    """
    key = blake2b(cells.tobytes() + held.tobytes(), digest_size=16).digest()
    with _keeping:
        if key in _kept:
            _kept.move_to_end(key)
            return _kept[key]
    made = Topology(cells, held)
    with _keeping:
        return _kept.setdefault(key, made)


def _shrink() -> None:
    """Keep `MOST_MEMORY`: numbers go first, then whole topologies; in both cases those that were used longest ago."""
    with _keeping:
        excess = sum(each.memory for each in _kept.values()) - MOST_MEMORY
        for each in list(_kept.values()):
            if excess > 0:
                excess -= each.forget_numbers()
        for key in list(_kept)[:-1]:
            if excess > 0:
                excess -= _kept.pop(key).memory
