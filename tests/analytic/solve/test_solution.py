"""Records of operating points: sums and ratios of them, the points that are tried, and many points on several cores."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.solve import freely, solution
from analytic.solve.freely import BETWEEN, error_of_sliding, other_states, part_by_sliding, slide_freely
from analytic.solve.model import model_of
from analytic.solve.records import BALL, NO_STEADY_ROTATION, POINT
from analytic.solve.solution import FAR, Solution, _logarithm, points_of, solved, tried_points

PARTS = {
    "spin": [3.0, 0.0, 7.0],
    "conformity": [0.5, 0.0, 1.1],
    "hysteresis": [0.2, 0.0, 0.3],
    "rolling": [2.0, 0, 5.0],
}
ARM = 0.021  # m


def forged(count: int = 3, **fields: Any) -> Solution:
    """A record with these fields of its points."""
    found = Solution(points=np.zeros(count, POINT), balls=np.zeros((count, 2), BALL))
    for name, values in fields.items():
        found.points[name] = values
    return found


def test_sums_have_the_parts_of_sliding_and_of_the_races() -> None:
    found = forged(**PARTS, cage=17.0, total=99.0)  # of which neither is of balls and races
    np.testing.assert_allclose(found.sliding_torque, [3.5, 0.0, 8.1], rtol=1e-15)
    np.testing.assert_allclose(found.race_torque, [5.7, 0.0, 13.4], rtol=1e-15)
    np.testing.assert_allclose(part_by_sliding(found), [3.5 / 5.7, 0.0, 8.1 / 13.4], rtol=1e-15)
    lost = forged(spin=[np.nan, 2.0, 3.0], rolling=[1.0, 6.0, 0.0])
    np.testing.assert_array_equal(part_by_sliding(lost), [1.0, 0.25, 1.0])  # a point without a torque slides


def test_the_sliding_number_is_force_over_friction_on_each_race() -> None:
    found = forged(
        rolling_force=[[3.0, 5.0], [0.0, 2.0], [0.7, 0.0]], most_friction=[[12.0, 4.0], [0.0, 0.0], [1.4, 6.0]]
    )
    np.testing.assert_array_equal(found.sliding_number, [[0.25, 0.0, 0.5], [1.25, np.inf, 0.0]])


def test_the_error_of_sliding_is_relative_and_infinite_without_a_torque() -> None:
    found = forged(**PARTS, sliding_error=[0.07, 0.0, 0.3], status=[0, 0, NO_STEADY_ROTATION])
    np.testing.assert_allclose(error_of_sliding(found), [0.07 / 3.5, 0.0, np.inf], rtol=1e-15)
    np.testing.assert_array_equal(error_of_sliding(forged(sliding_error=[np.inf] * 3)), [np.inf] * 3)


def test_points_have_loads_speed_and_temperature() -> None:
    operation = Operation(
        axial_load=np.array([310.0, 470.0]), inner_speed=np.array([31.0, 47.0]), radial_load=np.array([60.0, 0.0])
    )
    np.testing.assert_array_equal(
        points_of(operation, 313.0), [[310.0, 60.0, 0.0, 31.0, 313.0], [470.0, 0.0, 0.0, 47.0, 313.0]]
    )


def many_points(count: int = 40) -> Array:
    """Points that hardly differ."""
    points = np.zeros((count, 5))
    points[:, 0] = 500.0 + np.arange(count)
    points[:, 3] = 60.0 + 0.1 * np.arange(count)
    return points


def test_few_points_are_all_tried() -> None:
    np.testing.assert_array_equal(tried_points(many_points(FAR), ARM), np.arange(FAR))
    more = tried_points(many_points(FAR + 1), ARM)
    assert more.size <= FAR
    assert np.all(np.diff(more) > 0)


@pytest.mark.parametrize(
    ("column", "value", "is_end"),
    [
        (0, 90.0, True),  # the lightest, where inertia counts most
        (0, 4000.0, True),  # the heaviest, where it counts least
        (3, 900.0, True),  # the fastest
        (3, 2.0, True),  # the slowest
        (3, 0.0, True),  # at rest
        (1, 300.0, True),  # the most unequal
        (2, 9.0, True),  # likewise by a moment
        (4, 390.0, False),  # the oil is that of the scene
    ],
)
@pytest.mark.parametrize("place", [11, 26])
def test_the_ends_of_a_series_are_tried(column: int, value: float, is_end: bool, place: int) -> None:
    points = many_points()
    without = tried_points(points, ARM)
    points[place, column] = value
    tried = tried_points(points, ARM)
    assert (place in tried) == is_end
    assert place not in without


def test_the_ends_of_inertia_load_speed_and_share_come_first() -> None:
    """Of a round cloud, whose farthest points are others: speed squared over load counts as inertia."""
    random = np.random.default_rng(23)
    ball = random.normal(size=(500, 3))
    ball *= (random.random((500, 1)) ** (1 / 3)) / np.linalg.norm(ball, axis=1, keepdims=True)
    load, speed, share = 500 * np.exp(ball[:, 0]), 60 * np.exp(ball[:, 1]), 0.4 + 0.3 * ball[:, 2]
    points = np.zeros((500, 5))
    points[:, 0], points[:, 1], points[:, 3] = load * (1 - share), -load * share, -speed
    tried = set(tried_points(points, ARM).tolist())
    inertia = speed**2 / load
    ends = {int(at) for at in (inertia.argmax(), inertia.argmin(), load.argmin(), speed.argmin(), share.argmax())}
    assert len(ends) == 5
    assert ends <= tried
    assert len(tried) == FAR
    # Each column counts over its own extent: loads and speeds that extend twice as far in logarithms choose alike.
    wide = points.copy()
    wide[:, :2], wide[:, 3] = points[:, :2] * load[:, None], points[:, 3] * speed
    assert set(tried_points(wide, ARM).tolist()) == tried


def test_standstill_lies_a_decade_below_the_slowest_point() -> None:
    np.testing.assert_allclose(_logarithm(np.array([0.0, 3.0, 30.0])), np.log([0.3, 3.0, 30.0]), rtol=1e-14)
    np.testing.assert_array_equal(_logarithm(np.zeros(2)), np.zeros(2))


def test_a_moment_counts_as_the_load_that_balls_carry_at_their_arm() -> None:
    """A radial load and a moment of the same force at the arm are as far from thrust."""
    points = many_points()
    points[13, 1], points[29, 2] = 200.0, 200.0 * ARM
    swapped = points.copy()
    swapped[13, 1], swapped[13, 2] = 0.0, 200.0 * ARM
    swapped[29, 1], swapped[29, 2] = 200.0, 0.0
    np.testing.assert_array_equal(tried_points(points, ARM), tried_points(swapped, ARM))
    mirrored = points * np.array([1.0, -1.0, -1.0, -1.0, 1.0])
    np.testing.assert_array_equal(tried_points(mirrored, ARM), tried_points(points, ARM))


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.26),
        operation=Operation(
            axial_load=np.linspace(310.0, 970.0, 7), inner_speed=np.linspace(13.0, 91.0, 7), radial_load=0.0
        ).as_series(),
        friction_coefficient=0.07,
        spin_rule="balanced",
    )


@pytest.mark.parametrize("has_factors", [False, True])
def test_points_on_several_cores_are_those_on_one(
    scene: Scene, has_factors: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Factors that are given belong to their points, in every part of the series."""
    wide = ContactFactors(semi_axis_transverse=np.linspace(1.01, 1.3, 7))
    correction = ContactCorrection(inner=wide) if has_factors else None
    model = model_of(scene, {"spin": True, "conformity": True}, correction=correction)
    points, used = points_of(scene.operation, 0.0), []
    one = solved(model, points)
    each = [solved(model.at(np.array([i])), points[[i]]).points["total"][0] for i in range(7)]
    np.testing.assert_array_equal(one.points["total"], each)
    assert one.balls.shape == (7, 1)
    assert solved(model, points, keeps_balls=False).balls.size == 0
    make = solution.ThreadPoolExecutor

    def pool(threads: int) -> Any:
        used.append(threads)
        return make(threads)

    monkeypatch.setattr(solution, "ThreadPoolExecutor", pool)
    for least, cores, threads in ((3, 8, [2]), (2, 2, [2]), (4, 8, []), (3, None, [])):
        used.clear()
        monkeypatch.setattr(solution, "LEAST_SLICE", least)
        monkeypatch.setattr(solution, "os", SimpleNamespace(cpu_count=lambda cores=cores: cores))
        found = solved(model, points)
        assert used == threads
        np.testing.assert_array_equal(found.points["total"], one.points["total"])
        np.testing.assert_array_equal(found.balls["load"], one.balls["load"])


def scripted(monkeypatch: pytest.MonkeyPatch, torque: Any) -> list[Any]:
    """Solutions whose spin is a function of model, points and whether a start is known; the calls."""
    calls: list[Any] = []

    def answer(model: Any, points: Array, **options: Any) -> Solution:
        calls.append((model, points.copy(), options.get("work") is not None))
        return forged(len(points), **torque(model, points, "work" in options))

    monkeypatch.setattr(freely, "solved", answer)
    return calls


@pytest.fixture(scope="module")
def free(scene: Scene) -> Any:
    return model_of(scene, {"spin": True, "centrifugal": True}, creep="marched")


def test_a_long_series_takes_the_finest_quadrature_of_its_far_points(
    scene: Scene, free: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its error is what the far points have, and more between them; where sliding is a small part, more of it."""
    points = many_points()
    far = tried_points(points, float(free.numbers.arm))

    def torque(_model: Any, points: Array, _has_work: bool) -> dict[str, Any]:
        slides = np.linspace(2.0, 0.1, len(points))
        errors = slides * np.linspace(0.01, 0.04, len(points))
        return {"spin": slides, "rolling": 4.0, "sliding_error": errors, "passes": np.arange(len(points)) % 3 + 1}

    calls = scripted(monkeypatch, torque)
    found, error = slide_freely(scene, free.with_numbers(allowed=0.05), points)
    (strict, tried, _), (series, every, _) = calls
    np.testing.assert_array_equal(tried, points[far])
    np.testing.assert_allclose(float(strict.numbers.allowed), 0.05 / BETWEEN, rtol=1e-15)
    assert (int(series.numbers.passes), bool(series.numbers.cold)) == (3, False)
    np.testing.assert_array_equal(every, points)
    slides, shares = np.linspace(2.0, 0.1, len(far)), np.linspace(0.01, 0.04, len(far))
    whole = (shares * slides / (slides + 4.0)).max()
    part = found.points["spin"] / (found.points["spin"] + 4.0)
    np.testing.assert_allclose(error, 1.25 * np.minimum(0.04, whole / part), rtol=1e-12)
    few, own = slide_freely(scene, free, points[:FAR])
    np.testing.assert_allclose(own, few.points["sliding_error"] / few.points["spin"], rtol=1e-12)


POINT_OF = np.array([[410.0, 0.0, 0.0, 83.0, 0.0]])


def one_state(**fields: Any) -> Solution:
    """A point whose balls press on both races with 90 N, and turn at 0.4 of the ring's speed."""
    found = forged(1, **({"spin": 2.0, "passes": 5} | fields))
    found.balls["load"], found.balls["motion"]["cage_speed"] = 90.0, 0.4
    return found


def test_other_states_are_searched_where_balls_can_have_them(
    free: Any, bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Where centrifugal force presses as hard as the rings, the oil's force exceeds friction, or balls are wedged."""
    calls = scripted(monkeypatch, lambda *_: {"spin": 2.0})

    def searched(found: Solution, *, wedged: bool = False, speed: float = 83.0, model: Any = free) -> bool:
        calls.clear()
        points = POINT_OF.copy()
        points[0, 3] = speed
        other = other_states(model, points, found, np.array([wedged]))
        assert np.isnan(other).all()  # each run ends at the same torque
        return bool(calls)

    limit = np.sqrt(90.0 / (bearing_6205.ball_mass * bearing_6205.pitch_diameter / 2)) / 0.4
    assert [searched(one_state(), speed=share * limit) for share in (0.999, 1.001)] == [False, True]
    without = free.counting({"spin": True})
    assert not searched(one_state(), speed=1.001 * limit, model=without)
    lags = [one_state(rolling_force=[[1.0, force]], most_friction=[[7.0, 7.0]]) for force in (6.9, 7.1)]
    assert [searched(each) for each in lags] == [False, True]
    assert [searched(one_state(), wedged=wedged) for wedged in (False, True)] == [False, True]
    assert not searched(one_state(spin=0.0), wedged=True)  # there is no torque to compare with


@pytest.mark.parametrize(("wedged", "changed"), [(False, [3]), (True, [0, 1, 2])])
def test_runs_come_from_half_and_from_twice(
    free: Any, monkeypatch: pytest.MonkeyPatch, wedged: bool, changed: list[int]
) -> None:
    """Of the speed, or of the loads of wedged balls, and end at the point itself, by the second quadrature."""
    calls = scripted(monkeypatch, lambda *_: {"spin": 2.0})
    points = np.array([[410.0, 120.0, 0.7, 830.0, 0.0]])
    lagging = one_state(rolling_force=[[9.0, 9.0]], most_friction=[[7.0, 7.0]])
    other_states(free, points, lagging, np.array([wedged]))
    runs = [
        (model, given[0] / np.where(points[0] == 0, 1.0, points[0])) for model, given, has_work in calls if has_work
    ]
    kept = [place for place in range(4) if place not in changed]
    for model, share in runs:
        assert int(model.numbers.passes) == 2
        assert bool(model.numbers.nearly) == (share[changed[0]] != 1.0)
        assert np.all(share[kept] == 1.0)
        np.testing.assert_allclose(share[changed], share[changed[0]], rtol=1e-15)  # round-off
    shares = np.array([share[changed[0]] for _, share in runs])
    assert [shares.min(), shares.max()] == [0.5, 2.0]
    assert np.count_nonzero(shares == 1.0) == 4
    assert len(shares) == 2 * (3 + 8)


@pytest.mark.parametrize(
    ("ends", "expected"),
    [
        ((1.0, 1.0, 1.0, 1.0), np.nan),
        ((1.0009, 0.9991, 1.0, 1.0), np.nan),  # one that prints alike
        ((1.0, 1.3, 1.0, 1.1), 1.3),
        ((1.2, 0.7, 1.1, 1.0), 0.7),  # the farthest, of either side
    ],
)
def test_the_farthest_other_state_is_told(
    free: Any, monkeypatch: pytest.MonkeyPatch, ends: tuple[float, ...], expected: float
) -> None:
    """Relative to the point by the same quadrature, whose error is common to both."""
    left = iter(ends)

    def torque(model: Any, points: Array, has_work: bool) -> dict[str, Any]:
        if not has_work:  # by the second quadrature, or anew by the finest
            return {"spin": 2.02 if int(model.numbers.passes) == 2 else 2.0}
        return {"spin": 2.02 * next(left) if points[0, 3] == 83.0 else 1.9}

    scripted(monkeypatch, torque)
    lagging = one_state(rolling_force=[[9.0, 9.0]], most_friction=[[7.0, 7.0]])
    other = other_states(free, POINT_OF, lagging, np.array([False]))
    np.testing.assert_allclose(other, [2.0 * expected], rtol=1e-12)


@pytest.mark.parametrize(
    ("coarse", "anew", "expected"),
    [
        (2.1, 2.001, np.nan),
        (2.1, 2.5, 2.5),
        (2.1, 1.7, 1.7),
        (2.001, 2.5, np.nan),  # alike by the second quadrature: the finest is not asked
        (1.999, 2.5, np.nan),
        (1.9, 2.5, 2.5),
    ],
)
def test_a_point_that_settles_otherwise_from_closed_kinematics_has_two_states(
    free: Any, monkeypatch: pytest.MonkeyPatch, coarse: float, anew: float, expected: float
) -> None:
    """Its torque is 2 N m where the balls began elsewhere."""

    def torque(model: Any, _points: Array, has_work: bool) -> dict[str, Any]:
        return {"spin": coarse if has_work or int(model.numbers.passes) == 2 else anew}

    scripted(monkeypatch, torque)
    lagging = one_state(rolling_force=[[9.0, 9.0]], most_friction=[[7.0, 7.0]])
    np.testing.assert_allclose(other_states(free, POINT_OF, lagging, np.array([False])), [expected], rtol=1e-12)


def test_a_pattern_of_given_factors_stays_with_its_points(scene: Scene) -> None:
    """Some of the points, in another order, have their own factors."""
    wide = ContactFactors(semi_axis_rolling=np.linspace(1.02, 1.4, 7))
    model = model_of(scene, {"hysteresis": True}, correction=ContactCorrection(outer=wide))
    points, chosen = points_of(scene.operation, 0.0), np.array([5, 1, 3])
    every, some = solved(model, points), solved(model.at(chosen), points[chosen])
    np.testing.assert_array_equal(some.points["total"], every.points["total"][chosen])
    np.testing.assert_array_equal(every.at(chosen).points["total"], some.points["total"])
    bare = solved(replace(model, tables=model_of(scene, {"hysteresis": True}).tables), points)
    assert np.all(every.points["hysteresis"] > bare.points["hysteresis"])
