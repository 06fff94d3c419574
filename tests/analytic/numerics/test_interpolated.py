"""A series from a sample of its points: functions that are known everywhere, and the torque of a long series."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.numerics.interpolated import FIRST, MORE, MOST, SampledSeries, far_points, sampled_series
from analytic.scene import Array, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque

POINTS = 3000
rng = np.random.default_rng(61)
PLANE = rng.uniform([-1.0, 2.0], [2.0, 7.0], (POINTS, 2))


def smooth(at: Array) -> Array:
    return np.stack([np.sin(at[:, 0]) * np.exp(-0.2 * at[:, 1]), at[:, 0] + 0.3 * at[:, 1] ** 2], axis=1)


def cliff(at: Array) -> Array:
    return np.stack([np.where(at[:, 0] > 0.4, 0.3, 0.0), at[:, 1]], axis=1)


def sampled(quantity, coordinates: Array, allowed: float) -> tuple[SampledSeries | None, list[int]]:
    """The sample, and all indices that were evaluated."""
    evaluated: list[int] = []

    def evaluate(points: NDArray[np.intp]) -> Array:
        evaluated.extend(points)
        return quantity(coordinates[points])

    def missed(interpolated: Array, true: Array, points: NDArray[np.intp]) -> Array:  # noqa: ARG001
        return np.abs(interpolated - true).max(axis=1)

    return sampled_series(evaluate, coordinates, missed=missed, allowed=lambda: allowed), evaluated


@pytest.mark.parametrize("allowed", [1e-1, 3e-2, 6e-3])
def test_the_error_is_within_the_bound_everywhere(allowed: float) -> None:
    sample, evaluated = sampled(smooth, PLANE, allowed)
    assert sample is not None
    missed = np.abs(sample.values - smooth(PLANE)).max()
    assert missed <= sample.error <= allowed
    assert FIRST < len(evaluated) == sample.at.size <= MOST + 40  # no point twice
    np.testing.assert_array_equal(sample.values[sample.at], smooth(PLANE[sample.at]))


def test_a_bound_that_no_sample_meets_ends_the_search() -> None:
    sample, evaluated = sampled(smooth, PLANE, -0.01)
    assert sample is None
    assert len(evaluated) <= FIRST + 2 * MORE


def test_far_points_leave_no_larger_gap_than_between_them() -> None:
    """What defines them: no point of the cloud is farther from all of them than they are from each other."""
    cloud = np.random.default_rng(7).uniform([0.0, -2.0], [3.0, 2.5], (700, 2))
    far = cloud[far_points(cloud, 9)]
    apart = np.linalg.norm(far[:, None] - far[None], axis=-1)[np.triu_indices(9, 1)].min()
    gap = np.linalg.norm(cloud[:, None] - far[None], axis=-1).min(axis=1).max()
    assert 0.5 < gap <= apart


@pytest.mark.parametrize("slope", [0.0, -0.7])
def test_far_points_of_a_line_begin_with_its_ends(slope: float) -> None:
    """One coordinate is constant, or follows the other."""
    first = far_points(np.stack([PLANE[:, 0], 3 + slope * PLANE[:, 0]], axis=1), 5)[:2]
    assert set(first) == {PLANE[:, 0].argmin(), PLANE[:, 0].argmax()}


@pytest.mark.parametrize("different", [4, 1])
def test_no_far_point_comes_twice(different: int) -> None:
    """Two loads at two speeds, over and over, or one point alone."""
    corners = np.array([[1.2, 3.1], [0.0, 2.0], [0.0, 3.1], [1.2, 2.0]])
    found = far_points(corners[np.arange(300) % different], 9)
    assert sorted(found % different) == list(range(different))


def test_few_different_points_are_no_sample() -> None:
    """Two loads at two speeds, over and over: an interpolation through points that coincide would be singular."""
    few = np.array([[0.0, 2.0], [0.0, 3.1], [1.2, 2.0], [1.2, 3.1]])[np.arange(POINTS) % 4]
    assert sampled(smooth, few, 0.1) == (None, [])


def test_a_function_that_jumps_is_not_interpolated() -> None:
    sample, evaluated = sampled(cliff, PLANE, 0.02)
    assert sample is None
    assert len(evaluated) <= MOST + 40


@pytest.mark.parametrize("slope", [0.0, -0.7])
def test_points_on_a_line(slope: float) -> None:
    """One coordinate is constant, or follows the other: the points extend in one direction."""
    line = np.stack([PLANE[:, 0], 3 + slope * PLANE[:, 0]], axis=1)
    sample, _ = sampled(smooth, line, 1e-4)
    assert sample is not None
    assert np.abs(sample.values - smooth(line)).max() <= sample.error


def test_one_point_repeated_has_no_sample() -> None:
    assert sampled(smooth, np.full((POINTS, 2), 1.7), 1e-2)[0] is None


@pytest.mark.parametrize("points", [FIRST + 9, 200])
def test_few_points_are_all_computed_at_most_once(points: int) -> None:
    sample, evaluated = sampled(smooth, PLANE[:points], 1e-12)
    assert len(set(evaluated)) == len(evaluated) <= points
    assert sample is None or np.abs(sample.values - smooth(PLANE[:points])).max() <= 1e-12


@pytest.fixture(scope="module")
def series() -> Scene:
    """A map of load and speed, with standstill; balls turn by rule, and oil needs the accurate methods of sliding."""
    load, speed = np.meshgrid(np.geomspace(90, 2100, 27), np.linspace(0.0, 290.0, 41))
    scene = load_scene("validation/scenes/6205_physical.toml")
    operation = Operation(axial_load=load.ravel(), inner_speed=speed.ravel())
    return replace(scene, operation=operation, spin_rule="balanced")


@pytest.mark.parametrize("tolerance", [0.05, 0.02])
def test_a_long_series_agrees_with_its_points(series: Scene, tolerance: float) -> None:
    whole = friction_torque(replace(series, tolerance=tolerance))
    assert " of 1107 points" in whole.provenance["sliding"]
    some = np.random.default_rng(7).choice(1107, 25, replace=False)
    some[0] = 0  # at standstill, where logarithms end
    few = Operation(axial_load=series.operation.axial_load[some], inner_speed=series.operation.inner_speed[some])
    alone = friction_torque(replace(whole.settled(series), tolerance=tolerance, operation=few))
    assert "points" not in alone.provenance["sliding"]
    # The quadrature follows the points that are computed together: the two results differ by what both leave open.
    both = whole.numerical_uncertainty[some] + alone.numerical_uncertainty
    assert np.all(np.abs(whole.torque.total[some] / alone.torque.total - 1) <= both)
    assert np.all(whole.numerical_uncertainty <= tolerance)
    for race in ("inner", "outer"):
        mine, theirs = (getattr(result.friction_coefficient, race) for result in (whole, alone))
        np.testing.assert_allclose(mine[some], theirs, rtol=tolerance)  # not bounded itself, but as smooth
