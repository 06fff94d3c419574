"""A body reduced to its contact nodes against the solution of the whole body, and one solver against the other."""

from collections import OrderedDict
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.sparse import csr_matrix, triu
from scipy.sparse.linalg import spsolve

from analytic.errors import ConvergenceError, SingularError
from analytic.scene import Contact
from fembearing.fem import factor, topology
from fembearing.fem.condensation import HeldBody, condense, held_stiffness
from fembearing.fem.factor import new_factor
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import STEEL
from tests.fem.assembly import symmetric

Array = NDArray[np.float64]
CASES = [("race", "upper"), ("race", "lower"), ("hertzian", "upper"), ("hertzian", "lower")]
SEMI_AXES = 0.10e-3, 0.93e-3  # m


@pytest.fixture(scope="module")
def pairs(contacts: dict[str, Contact]) -> dict[str, PairMesh]:
    return {
        recipe: pair_mesh(contacts["inner"], recipe=load_recipe(recipe), level=1, semi_axes=SEMI_AXES)
        for recipe in ("race", "hertzian")
    }


def pushed(pair: PairMesh, side: str) -> tuple[BodyMesh, Array]:
    return (pair.upper, -pair.normal) if side == "upper" else (pair.lower, pair.normal)


@pytest.mark.skipif(factor.PardisoSolver is None, reason="PARDISO is not available for this processor")
@pytest.mark.usefixtures("nothing_kept")
@pytest.mark.parametrize(("recipe", "side"), CASES)
def test_both_solvers_give_the_same(
    pairs: dict[str, PairMesh], recipe: str, side: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    body, force = pushed(pairs[recipe], side)
    by_pardiso = condense(body, material=STEEL, force=force, semi_axes=SEMI_AXES)
    monkeypatch.setattr(factor, "PardisoSolver", None)
    monkeypatch.setattr(topology, "_kept", OrderedDict())
    by_superlu = condense(body, material=STEEL, force=force, semi_axes=SEMI_AXES)
    size = np.abs(by_superlu.compliance).max()
    # Round-off times the condition of a mesh whose cells differ a hundredfold, about 1e6.
    np.testing.assert_allclose(by_pardiso.compliance, by_superlu.compliance, atol=1e-9 * size, rtol=0)
    drift = np.abs(by_superlu.drift).max()
    np.testing.assert_allclose(by_pardiso.drift, by_superlu.drift, atol=1e-9 * drift, rtol=0)
    assert by_pardiso.unknowns == by_superlu.unknowns


@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize(("recipe", "side"), CASES)
def test_condensed_nodes_move_as_in_the_whole_body(pairs: dict[str, PairMesh], recipe: str, side: str) -> None:
    """Random forces and a far field together; a wrong node order, sign or scale of the far field fails here."""
    body, force = pushed(pairs[recipe], side)
    condensed = condense(body, material=STEEL, force=force, semi_axes=SEMI_AXES)
    system = held_stiffness(body, material=STEEL, semi_axes=SEMI_AXES)
    random = np.random.default_rng(21)
    for load in (0.0, 153.0):
        pushes = random.uniform(0.3, 2.9, body.touching.size)
        right = np.zeros((3, body.mesh.doflocs.shape[1]))
        right[:, body.touching] = force * pushes
        displacement = np.zeros(right.size)
        displacement[system.free] = spsolve(
            symmetric(system.upper).tocsc(), right.ravel()[system.free] + load * system.far_force
        )
        moved = np.sum(displacement.reshape(3, -1)[:, body.touching] * force, axis=0)
        found = condensed.compliance @ pushes + condensed.drift * load
        np.testing.assert_allclose(found, moved, rtol=1e-9)  # as above
        assert found.min() > 0  # pushed nodes move with the push


@pytest.mark.parametrize(("recipe", "side"), CASES)
def test_compliance_is_symmetric_and_positive_definite(pairs: dict[str, PairMesh], recipe: str, side: str) -> None:
    body, force = pushed(pairs[recipe], side)
    condensed = condense(body, material=STEEL, force=force, semi_axes=SEMI_AXES)
    np.testing.assert_array_equal(condensed.compliance, condensed.compliance.T)
    spectrum = np.linalg.eigvalsh(condensed.compliance)
    assert spectrum[0] > 1e-9 * spectrum[-1]  # above its round-off
    if recipe == "race" and side == "upper":
        np.testing.assert_array_equal(condensed.drift, 0.0)  # a ball has no far field
    else:
        assert condensed.drift.min() > 0  # the far field moves with the load


@pytest.mark.parametrize("ratio", [0.0, 0.21, 0.45])
def test_two_half_spaces_are_mirror_images(pairs: dict[str, PairMesh], ratio: float) -> None:
    """The solver condenses only one of them, which is right because the far field of the other is its mirror image."""
    material = replace(STEEL, youngs_modulus=87e9, poisson_ratio=ratio)
    upper, lower = (
        condense(
            *pushed(pairs["hertzian"], side)[:1],
            material=material,
            force=pushed(pairs["hertzian"], side)[1],
            semi_axes=SEMI_AXES,
        )
        for side in ("upper", "lower")
    )
    np.testing.assert_allclose(upper.compliance, lower.compliance, atol=1e-9 * upper.compliance.max())  # as above
    np.testing.assert_allclose(upper.drift, lower.drift, rtol=1e-9)


NOTHING = np.array([], dtype=np.intp)


@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize(
    ("fault", "words"),
    [
        ("no far boundary", "have no single answer"),
        ("nothing held", "have no single answer"),
        ("modulus", "not finite and positive"),
        ("Poisson ratio", "not finite and positive"),
    ],
)
def test_a_body_without_a_unique_solution_is_named(pairs: dict[str, PairMesh], fault: str, words: str) -> None:
    body, force = pushed(pairs["hertzian"], "lower")
    material = STEEL
    if fault == "no far boundary":  # free to sink
        body = replace(body, far=NOTHING)
    elif fault == "nothing held":
        body = replace(body, far=NOTHING, planes=(NOTHING, NOTHING, NOTHING))
    elif fault == "modulus":
        material = replace(material, youngs_modulus=np.nan)
    else:
        material = replace(material, poisson_ratio=0.6)
    with pytest.raises(
        ConvergenceError, match=rf"half space: its \d+ equations .*{words}.*Check that it is held"
    ) as stop:
        condense(body, material=material, force=force, semi_axes=SEMI_AXES)
    assert "\n" not in str(stop.value)
    # and the solver is as good as before
    condense(pushed(pairs["hertzian"], "lower")[0], material=STEEL, force=force, semi_axes=SEMI_AXES)


def springs(matrix: list[list[float]]) -> HeldBody:
    """Three degrees of freedom of a body called "ball"."""
    upper = csr_matrix(triu(matrix))

    def solution(given: csr_matrix, right: Array) -> Array:
        return new_factor(upper, csr_matrix((3, 0))).solution(given, right)

    free: Any = SimpleNamespace(free=np.arange(3), solution=solution)
    return HeldBody(name="ball", topology=free, upper=upper, far_force=np.zeros(3), held=np.zeros((3, 1)))


@pytest.mark.usefixtures("solver")
@pytest.mark.parametrize(
    "matrix",
    [
        [[2.0, -2.0, 0.0], [-2.0, 2.0, 0.0], [0.0, 0.0, 3.0]],  # a spring between two points that nothing holds
        [[2.0, 0.5, 0.0], [0.5, 3.0, 0.0], [0.0, 0.0, 0.0]],  # a point without a spring
        [[2.0, 0.5, 0.0], [0.5, -3.0, 0.0], [0.0, 0.0, 1.5]],
        [[2.0, 0.5, 0.0], [0.5, np.inf, 0.0], [0.0, 0.0, 1.5]],
    ],
)
def test_loose_springs_are_refused_with_a_message(matrix: list[list[float]]) -> None:
    with pytest.raises(SingularError, match=r"ball: its 3 equations have no single answer: .* Check that it is held"):
        springs(matrix).displacement(np.array([0.3, 0.7, 1.1]), load=0.0)


def test_a_body_too_large_for_the_memory_gets_a_remedy() -> None:
    def without_memory(*_: object) -> None:
        raise MemoryError

    body = springs([[2.0, 0.5, 0.0], [0.5, 3.0, 0.0], [0.0, 0.0, 1.5]])
    full: Any = SimpleNamespace(free=np.arange(3), solution=without_memory)
    with pytest.raises(SingularError, match=r"ball: its 3 equations do not fit into memory\. Ask for"):
        replace(body, topology=full).displacement(np.array([0.3, 0.7, 1.1]), load=0.0)
