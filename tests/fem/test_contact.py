"""The active set against the conditions of unilateral contact, against every subset of nodes, and a minimiser."""

from itertools import product

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from analytic.errors import ConvergenceError
from analytic.scene import Array
from fembearing.fem.contact import is_positive_definite, press


def problem(seed: int, nodes: int = 23) -> dict[str, np.ndarray]:
    """Nodes on a line with a decaying compliance, a curved gap, slanting normals."""
    rng = np.random.default_rng(seed)
    place = np.sort(rng.uniform(-1.4, 1.4, nodes))
    compliance = np.exp(-3.1 * np.abs(place[:, None] - place)) + 0.3 * np.eye(nodes)
    return {
        "compliance": compliance,
        "drift": rng.uniform(-0.01, 0.01, nodes),
        "gap": 0.9 * place**2 + 0.02 * rng.uniform(size=nodes),
        "lever": np.cos(0.3 * place),
    }


def pressed(case: dict[str, np.ndarray], load: float, start: np.ndarray) -> tuple[np.ndarray, float, int]:
    return press(**case, load=load, start=start)


def remaining_gap(case: dict[str, np.ndarray], force: np.ndarray, approach: float, load: float) -> np.ndarray:
    return case["gap"] + case["compliance"] @ force + case["drift"] * load - case["lever"] * approach


def exhaustive(compliance: Array, opened: Array, lever: Array, load: float) -> tuple[Array, float]:
    """The only set of touching nodes with pushing forces and open gaps at all other nodes."""
    answers = []
    for chosen in product((False, True), repeat=opened.size):
        touching = np.flatnonzero(chosen)
        if not touching.size:
            continue
        moved = np.linalg.inv(compliance[np.ix_(touching, touching)])
        to_load, to_gap = moved @ lever[touching], moved @ opened[touching]
        approach = (load + lever[touching] @ to_gap) / (lever[touching] @ to_load)
        force = np.zeros_like(opened)
        force[touching] = approach * to_load - to_gap
        gap = opened + compliance @ force - lever * approach
        if force.min() >= 0 and gap.min() > -1e-12 * abs(approach):
            answers.append((force, approach))
    assert len(answers) == 1
    return answers[0]


@pytest.mark.parametrize("seed", range(12))
def test_the_answer_is_that_of_a_search_through_all_subsets(seed: int) -> None:
    """Positive definite compliances with entries of either sign: the push on one node may open or close another."""
    random, nodes = np.random.default_rng(seed), 7
    root = random.normal(size=(nodes, nodes + 3)) * 3e-5
    case = {
        "compliance": root @ root.T,  # about 1e-8 m/N
        "drift": random.uniform(0.0, 2e-9, nodes),
        "gap": np.append(0.0, random.uniform(0.0, 1.5e-6, nodes - 1)),
        "lever": random.uniform(0.7, 0.99, nodes),
    }
    load = float(random.uniform(3.0, 300.0))
    expected, depth = exhaustive(case["compliance"], case["gap"] + load * case["drift"], case["lever"], load)
    for start in (np.zeros(nodes, bool), np.ones(nodes, bool), random.random(nodes) < 0.5):
        force, approach, rounds = press(**case, load=load, start=start)
        np.testing.assert_allclose(force, expected, atol=1e-9 * load)  # round-off of two methods
        np.testing.assert_allclose(approach, depth, rtol=1e-9)
        assert rounds <= 2**nodes


@pytest.mark.parametrize(("nodes", "seed"), [(4, 2644), (5, 1992), (6, 587), (7, 3712), (8, 3369)])
def test_sets_that_would_cycle_end_in_the_answer(nodes: int, seed: int) -> None:
    """Positive definite; but if all wrong nodes always change together, the same sets come back."""
    random = np.random.default_rng(seed)
    root = random.normal(size=(nodes, nodes))
    case = {"compliance": root @ root.T, "gap": random.uniform(0, 1, nodes), "lever": random.uniform(0.7, 1, nodes)}
    start = np.ones(nodes, bool)
    force, approach, _ = press(**case, drift=np.zeros(nodes), load=2.3, start=start)
    expected, depth = exhaustive(*case.values(), load=2.3)
    np.testing.assert_allclose(force, expected, atol=1e-8 * 2.3)  # round-off times conditions up to 1e6
    np.testing.assert_allclose(approach, depth, rtol=1e-8)


@given(seed=st.integers(0, 2**32 - 1), nodes=st.integers(2, 30), decades=st.floats(0, 9), bits=st.integers(0, 2**30))
def test_nearly_singular_compliances_from_any_start(seed: int, nodes: int, decades: float, bits: int) -> None:
    """The conditions that define contact have one answer, where the compliance is positive definite."""
    random = np.random.default_rng(seed)
    turn = np.linalg.qr(random.normal(size=(nodes, nodes)))[0]
    compliance = turn * np.geomspace(1, 10**-decades, nodes) @ turn.T
    case = {
        "compliance": (compliance + compliance.T) / 2,
        "drift": random.uniform(0.0, 0.1, nodes),
        "gap": random.uniform(0.0, 1.3, nodes),
        "lever": random.uniform(0.7, 0.99, nodes),
    }
    start = np.array([bool(bits >> node & 1) for node in range(nodes)])
    force, approach, _ = press(**case, load=2.3, start=start)
    gap = remaining_gap(case, force, approach, 2.3)
    round_off = 1e-10 * (abs(approach) + np.abs(case["compliance"]) @ force)
    assert (force >= 0).all()
    assert (gap > -round_off).all()
    assert (np.abs(gap) < round_off)[force > 0].all()
    np.testing.assert_allclose(force @ case["lever"], 2.3, rtol=1e-6)  # round-off times the condition, 1e9


@pytest.mark.parametrize(
    ("entry", "value"),
    [((2, 2), np.nan), ((0, 3), np.inf), ((slice(None), slice(None)), 0.0), ((4, 4), -0.3), ((1, 1), 0.0)],
)
def test_an_invalid_compliance_is_refused_with_a_message(entry: tuple, value: float) -> None:
    case = problem(2, nodes=6)
    case["compliance"][entry] = value
    case["compliance"][entry[::-1]] = value
    for start in (np.ones(6, bool), np.arange(6) == 5):
        with pytest.raises(ConvergenceError, match=r"of 6 nodes touching .* iterations: residual 1.7e\+00 N") as stop:
            pressed(case, 1.7, start)
        assert stop.value.residual == 1.7  # no part of the load is carried yet


@pytest.mark.parametrize("seed", range(8))
def test_nodes_that_just_touch_do_not_change_for_ever(seed: int) -> None:
    """All gaps closed and half of the forces 0: round-off decides which of those nodes touch, not the answer."""
    random, nodes = np.random.default_rng(seed), 14
    root = random.normal(size=(nodes, nodes + 3))
    compliance, lever = root @ root.T, random.uniform(0.7, 0.99, nodes)
    expected = np.where(np.arange(nodes) % 2, random.uniform(0.3, 1.7, nodes), 0.0)
    gap = 37.0 * lever - compliance @ expected
    for start in (np.ones(nodes, bool), np.zeros(nodes, bool)):
        force, approach, _ = press(
            compliance=compliance, drift=0 * gap, gap=gap, lever=lever, load=float(expected @ lever), start=start
        )
        np.testing.assert_allclose(force, expected, atol=1e-9)  # round-off times a condition of 1e3
        np.testing.assert_allclose(approach, 37.0, rtol=1e-9)


@pytest.mark.parametrize(("share", "holds"), [(1e-9, True), (1e-14, False)])
def test_two_nodes_may_move_almost_as_one(share: float, holds: bool) -> None:
    """A share of 2 * share of the second node's compliance is independent of the first node."""
    alike = 1 - share
    assert is_positive_definite(np.array([[1.0, alike], [alike, 1.0]])) == holds
