"""A long series by a sample of its points: what the cheap method misses is interpolated, with its error."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.scene import Array
from analytic.solve import sample
from analytic.solve.freely import BETWEEN
from analytic.solve.records import BALL, NO_SPIN_BALANCE, POINT
from analytic.solve.sample import slide_by_sample
from analytic.solve.solution import Solution

COUNT = 60


def points_of() -> Array:
    points = np.zeros((COUNT, 5))
    points[:, 0] = np.geomspace(90.0, 2100.0, COUNT)
    points[:, 3] = np.linspace(-3.0, 290.0, COUNT)
    points[7, 3] = 0.0  # at standstill
    return points


def by_method(points: Array, accurate: bool) -> Solution:
    """Torques and coefficients that are smooth in load and speed; the accurate ones are some per cent larger."""
    found = Solution(points=np.zeros(len(points), POINT), balls=np.zeros((len(points), 1), BALL))
    load, more = np.log(points[:, 0]), 1.03 if accurate else 1.0
    found.points["spin"], found.points["conformity"] = load * more, 0.4 * load * more**2
    found.points["sliding_error"] = 0.004 * found.sliding_torque if accurate else 0.0
    found.balls["friction_coefficient"][:, 0] = np.stack([0.05 * load * more, 0.07 * load / more], axis=1)
    return found


class Numbers:
    def __init__(self, accurate: bool = True) -> None:
        self.accurate = accurate

    def with_numbers(self, *, judges: bool, method: int | None = None) -> "Numbers":
        assert judges == (method is None)
        return Numbers(accurate=method is None)


def sampled(
    *, allowed: float = 0.02, at: tuple[int, ...] = (0, 9, 33, 58), error: float = 0.001, change: Any = None
) -> tuple[Any, list[float]]:
    """The series through a sample of the moving points; and what the sample was allowed, and measured."""
    told: list[float] = []

    def solved(model: Numbers, points: Array) -> Solution:
        found = by_method(points, model.accurate)
        if change is not None:
            change(found, model.accurate, points)
        return found

    def sampled_series(evaluate: Any, coordinates: Array, *, missed: Any, allowed: Any) -> Any:
        moving = np.delete(np.arange(COUNT), 7)
        points = points_of()[moving]
        np.testing.assert_allclose(np.exp(coordinates), np.abs(points[:, [0, 3]]), rtol=1e-12)
        told.append(allowed())
        chosen: NDArray[np.intp] = np.array(at)
        there = evaluate(chosen)
        told.append(allowed())
        base, fine = (by_method(points[chosen], accurate) for accurate in (False, True))
        # Twice the share by which a method changes the torque: 1 % of an interpolated torque is 1 % of the whole.
        missing = there + 0.01 * np.array([[1.0, 0.0, 5.0, 5.0]])
        told.append(float(missed(missing, there, chosen).max()))
        whole, true = base.sliding_torque, fine.sliding_torque
        np.testing.assert_allclose(told[-1], np.max(0.01 * whole / true), rtol=1e-9)
        return SimpleNamespace(values=np.repeat(there[:1], COUNT - 1, axis=0), at=chosen, error=error)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sample, "solved", solved)
        patch.setattr(sample, "sampled_series", sampled_series)
        limits = np.full(COUNT, 2 * allowed)
        limits[5] = allowed  # the point that allows least decides
        return slide_by_sample(Numbers(), points_of(), limits), told  # pyright: ignore[reportArgumentType]


def test_what_a_method_changes_is_interpolated_and_added() -> None:
    """Here by the same share of the torque everywhere, so that every point has its own accurate torque."""
    found, told = sampled()
    true = by_method(points_of(), accurate=True)
    for name in ("spin", "conformity"):
        np.testing.assert_allclose(found.found.points[name], true.points[name], rtol=1e-12)
    own, its = (each.balls["friction_coefficient"] for each in (found.found, true))
    np.testing.assert_allclose(own, its, rtol=1e-12)
    assert found.computed == 4 + 1  # with the one at standstill
    np.testing.assert_allclose(found.error, BETWEEN * 0.004 + 0.001, rtol=1e-12)
    np.testing.assert_allclose(told[:2], [0.02, 0.02 - BETWEEN * 0.004], rtol=1e-12)


def test_the_worst_error_of_the_method_counts() -> None:
    def worse(found: Solution, accurate: bool, points: Array) -> None:
        if accurate:
            found.points["sliding_error"] *= np.where(points[:, 0] > 1000.0, 3.0, 1.0)

    assert sampled(change=worse)[0].error == pytest.approx(BETWEEN * 0.012 + 0.001, rel=1e-9)


@pytest.mark.parametrize("field", ["status", "spin", "inner", "outer"])
def test_a_point_without_a_torque_or_friction_has_no_sample(field: str) -> None:
    def without(found: Solution, accurate: bool, _points: Array) -> None:
        if not accurate:
            if field == "status":
                found.points["status"][41] = NO_SPIN_BALANCE
            elif field == "spin":
                found.points["spin"][41] = -found.points["conformity"][41]
            else:
                found.balls["friction_coefficient"][41, 0, ("inner", "outer").index(field)] = 0.0

    assert sampled(change=without) == (None, [])


def test_a_point_at_standstill_is_computed_by_itself() -> None:
    def stuck(found: Solution, accurate: bool, points: Array) -> None:
        if accurate and len(points) == 1:
            found.points["status"] = NO_SPIN_BALANCE

    assert sampled(change=stuck)[0] is None
    assert sampled()[0] is not None


def test_a_series_that_stands_still_has_no_sample(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sample, "solved", lambda model, points: by_method(points, model.accurate))
    still = points_of() * np.array([1.0, 1.0, 1.0, 0.0, 1.0])
    assert slide_by_sample(Numbers(), still, np.full(COUNT, 0.02)) is None  # pyright: ignore[reportArgumentType]
