"""What is kept for the next body with the same cells gives the same numbers as what is made for it alone."""

from collections import OrderedDict
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.sparse import csr_matrix

from analytic.scene import Array, Contact
from fembearing.fem import factor, topology
from fembearing.fem.condensation import CondensedBody, condense, held_stiffness
from fembearing.fem.factor import new_factor
from fembearing.fem.solution import solve_on_mesh
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import CONTACTS, INNER, NITRIDE, OUTER, STEEL
from tests.fem.assembly import stiffness, symmetric

RECIPE = load_recipe("race")
SIZES = (0.12e-3, 1.05e-3), (0.17e-3, 0.71e-3)  # m: two contacts on cells of the same numbers
has_pardiso = pytest.mark.skipif(factor.PardisoSolver is None, reason="PARDISO is not available for this processor")


def meshed(level: int) -> list[PairMesh]:
    both = zip((INNER, OUTER), SIZES, strict=True)
    return [pair_mesh(contact, recipe=RECIPE, level=level, semi_axes=size) for contact, size in both]


@pytest.fixture(scope="module")
def pairs() -> list[PairMesh]:
    return meshed(2)


def reduced(pair: PairMesh, side: str) -> CondensedBody:
    body, force, material = {"upper": (pair.upper, -pair.normal, NITRIDE), "lower": (pair.lower, pair.normal, STEEL)}[
        side
    ]
    return condense(body, material=material, force=force, semi_axes=pair.semi_axes)


def kept(monkeypatch: pytest.MonkeyPatch) -> OrderedDict[bytes, topology.Topology]:
    store: OrderedDict[bytes, topology.Topology] = OrderedDict()
    monkeypatch.setattr(topology, "_kept", store)
    return store


@pytest.mark.parametrize("side", ["upper", "lower"])
def test_a_kept_topology_gives_what_a_new_one_gives(
    pairs: list[PairMesh], side: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Another load, groove and material on the same cells, bit for bit; the first one again, after the other."""
    fresh = []
    for pair in pairs:
        kept(monkeypatch)
        fresh.append(reduced(pair, side))
    store = kept(monkeypatch)
    for number in (0, 1, 0):
        again = reduced(pairs[number], side)
        np.testing.assert_array_equal(again.compliance, fresh[number].compliance)
        np.testing.assert_array_equal(again.drift, fresh[number].drift)
    assert len(store) == 1
    assert np.abs(fresh[1].compliance / fresh[0].compliance - 1).max() > 0.1  # they are two bodies


@pytest.mark.usefixtures("nothing_kept")
def test_assembled_entries_are_those_of_the_cells_added_one_by_one(pairs: list[PairMesh]) -> None:
    """With degrees of freedom held at random, also all or one of a node."""
    body = pairs[0].lower
    whole = stiffness(body.mesh, STEEL)
    random = np.random.default_rng(3)
    planes = tuple(random.choice(body.mesh.doflocs.shape[1], 400, replace=False) for _ in range(3))
    held = held_stiffness(replace(body, planes=planes), material=STEEL, semi_axes=pairs[0].semi_axes)
    free = held.free
    assert np.unique(free).size == free.size < whole.shape[0] - 1100
    assert not np.isin(free, np.concatenate([plane + axis * held.nodes for axis, plane in enumerate(planes)])).any()
    difference = symmetric(held.upper) - whole[free][:, free]
    assert abs(difference).max() < 1e-14 * abs(whole).max()  # sums in another order
    far = -(whole[free] @ held.held.ravel())
    np.testing.assert_allclose(held.far_force, far, atol=1e-14 * np.abs(far).max() * 1e3, rtol=0)  # cancelling entries


@pytest.mark.usefixtures("solver")
def test_a_solution_is_that_of_its_own_matrix() -> None:
    """After the other body of the same topology was factored, after the same one, and before any was."""
    pairs = meshed(1)
    systems = [held_stiffness(pair.lower, material=STEEL, semi_axes=pair.semi_axes) for pair in pairs]
    right = np.random.default_rng(5).normal(size=systems[0].free.size)
    for number in (0, 0, 1, 0):
        system = systems[number]
        found = system.topology.solution(system.upper, right)
        left = symmetric(system.upper) @ found - right
        assert np.linalg.norm(left) < 1e-11 * np.linalg.norm(right)  # round-off; of the other matrix: 1
        reduced(pairs[1], "lower")


@pytest.mark.usefixtures("solver")
def test_complement_and_solution_by_hand() -> None:
    """K = [[4, 1], [1, 3]] with two columns of very different size; K^-1 = [[3, -1], [-1, 4]]/11."""
    upper, border = csr_matrix([[4.0, 1.0], [0.0, 3.0]]), csr_matrix([[2.0, 0.0], [5.0, 7e-9]])
    made = new_factor(upper)
    inverse = np.array([[3.0, -1.0], [-1.0, 4.0]]) / 11
    expected = border.toarray().T @ inverse @ border.toarray()
    np.testing.assert_allclose(made.complement(upper, border), expected, rtol=1e-14)
    np.testing.assert_allclose(made.solution(upper, np.array([0.3, -1.7])), inverse @ [0.3, -1.7], rtol=1e-14)


def test_a_matrix_without_an_inverse_is_named() -> None:
    """K = [[4, 2], [2, 1]] has rank 1."""
    upper = csr_matrix([[4.0, 2.0], [0.0, 1.0]])
    with pytest.raises(factor.LinAlgError, match="singular"):
        factor.SuperLUFactor().solution(upper, np.array([0.3, -1.7]))


class GivesUp:
    """A factor that fails for every matrix, and holds 7 bytes."""

    memory = 7

    def __init__(self, error: type[Exception]) -> None:
        self.error, self.forgot = error, 0

    def complement(self, upper: csr_matrix, border: csr_matrix) -> Any:
        raise self.error("status -4", upper, border)

    def solution(self, upper: csr_matrix, right: Array) -> Any:
        raise self.error("status -4", upper, right)

    def forget_numbers(self) -> None:
        self.forgot += 1


def test_superlu_takes_what_a_factor_gives_up() -> None:
    """K = [[4, 1], [1, 3]] as above, with a warning; a lack of memory is none of its business."""
    upper, border = csr_matrix([[4.0, 1.0], [0.0, 3.0]]), csr_matrix([[2.0], [5.0]])
    first = GivesUp(factor.LinAlgError)
    made = factor.FactorWithSubstitute(first, substitute=factor.SuperLUFactor())
    with pytest.warns(RuntimeWarning, match=r"PARDISO gave up a matrix \(.*status -4"):
        np.testing.assert_allclose(made.solution(upper, np.ones(2)), [2 / 11, 3 / 11], rtol=1e-14)
    with pytest.warns(RuntimeWarning, match="SuperLU"):
        # [2, 5] K^-1 [2, 5] by hand
        np.testing.assert_allclose(made.complement(upper, border), [[92 / 11]], rtol=1e-14)
    made.forget_numbers()
    assert (made.memory, first.forgot) == (7, 1)
    with pytest.raises(MemoryError):
        factor.FactorWithSubstitute(GivesUp(MemoryError), substitute=factor.SuperLUFactor()).solution(upper, np.ones(2))


@pytest.mark.parametrize("threads", [1, 2])
def test_threads_do_not_change_a_bit(threads: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Both bodies of a contact at once, and several contacts at once that share their topologies."""
    monkeypatch.setattr("fembearing.fem.solution.solver_threads", lambda: threads)
    chosen = [(CONTACTS[name], size) for name in ("inner", "outer") for size in SIZES]

    def solve(task: tuple[Contact, tuple[float, float]]) -> Array:
        contact, size = task
        return solve_on_mesh(contact, recipe=RECIPE, level=1, semi_axes=size).force

    alone = []
    for task in chosen:
        kept(monkeypatch)
        alone.append(solve(task))
    kept(monkeypatch)
    with ThreadPoolExecutor(len(chosen)) as pool:
        for one, together in zip(alone, pool.map(solve, chosen), strict=True):
            np.testing.assert_array_equal(together, one)


def test_other_held_nodes_are_another_topology(pairs: list[PairMesh], monkeypatch: pytest.MonkeyPatch) -> None:
    store = kept(monkeypatch)
    body = pairs[0].lower
    first = held_stiffness(body, material=STEEL, semi_axes=SIZES[0])
    other = held_stiffness(replace(body, far=body.far[1:]), material=STEEL, semi_axes=SIZES[0])
    assert other.topology is not first.topology
    assert held_stiffness(body, material=NITRIDE, semi_axes=SIZES[1]).topology is first.topology
    assert len(store) == 2


@has_pardiso
@pytest.mark.parametrize(("words", "error"), [("not enough memory", MemoryError), ("zero pivot", factor.LinAlgError)])
def test_pardisos_errors_get_a_kind(words: str, error: type[Exception], monkeypatch: pytest.MonkeyPatch) -> None:
    """PARDISO fails once, as the package says it."""

    class Failing(factor.PardisoSolver):
        fails = True

        def refactor(self, values: Array) -> None:
            if self.fails:
                self.fails = False
                raise RuntimeError(f"PARDISO phase 22 failed: {words}")
            super().refactor(values)

    monkeypatch.setattr(factor, "PardisoSolver", Failing)
    upper = csr_matrix([[4.0, 1.0], [0.0, 3.0]])
    made = factor.PardisoFactor(csr_matrix([[7.0, 1.0], [0.0, 5.0]]))
    with pytest.raises(error, match=words):
        made.solution(upper, np.ones(2))
    np.testing.assert_allclose(made.solution(upper, np.ones(2)), [2 / 11, 3 / 11], rtol=1e-14)  # as good as before


@has_pardiso
@pytest.mark.parametrize(
    ("given", "threads"),
    [
        ({"MKL_NUM_THREADS": "3", "OMP_NUM_THREADS": "5"}, 3),
        ({"OMP_NUM_THREADS": "5"}, 5),
        ({"MKL_NUM_THREADS": "0", "OMP_NUM_THREADS": " 2,4"}, 2),  # of nested threads the outer ones
        ({"MKL_NUM_THREADS": "many", "OMP_NUM_THREADS": "1"}, 1),
        ({}, None),
    ],
)
def test_threads_are_those_that_the_environment_gives(
    given: dict[str, str], threads: int | None, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("MKL_NUM_THREADS", "OMP_NUM_THREADS"):
        monkeypatch.delenv(name, raising=False)
    for name, value in given.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setattr("os.sched_getaffinity", lambda _: set(range(7)), raising=False)
    assert factor.solver_threads() == (7 if threads is None else threads)
    monkeypatch.setattr(factor, "PardisoSolver", None)
    assert factor.solver_threads() == 1
