"""A body reduced to its contact nodes against the solution of the whole body, and one solver against the other."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from scipy.sparse.linalg import spsolve

from analytic.errors import ConvergenceError, SingularError
from analytic.scene import Array
from fembearing.fem.condensation import condense, held_stiffness
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.pair import PairMesh, pair_mesh
from fembearing.mesh.recipe import load_recipe
from tests.contacts import INNER, STEEL
from tests.fem.assembly import symmetric

CASES = [("race", "upper"), ("race", "lower"), ("hertzian", "upper"), ("hertzian", "lower")]
SEMI_AXES = 0.10e-3, 0.93e-3  # m


@pytest.fixture(scope="module")
def pairs() -> dict[str, PairMesh]:
    return {
        recipe: pair_mesh(INNER, recipe=load_recipe(recipe), level=1, semi_axes=SEMI_AXES)
        for recipe in ("race", "hertzian")
    }


def pushed(pair: PairMesh, side: str) -> tuple[BodyMesh, Array]:
    return (pair.upper, -pair.normal) if side == "upper" else (pair.lower, pair.normal)


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


def test_a_body_too_large_for_the_memory_gets_a_remedy(pairs: dict[str, PairMesh]) -> None:
    def without_memory(*_: object) -> None:
        raise MemoryError

    held = held_stiffness(pairs["race"].upper, material=STEEL, semi_axes=SEMI_AXES)
    full: Any = SimpleNamespace(free=held.free, solution=without_memory)
    with pytest.raises(SingularError, match=r"ball: its \d+ equations do not fit into memory\. Ask for"):
        replace(held, topology=full).displacement(np.ones(held.free.size), load=0.0)
