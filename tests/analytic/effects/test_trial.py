"""Effects are decided by trial: shares are measured, few points compute all, long series keep their tolerance."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.effects import trial
from analytic.effects.table import TRIED
from analytic.effects.trial import FEW, growth_by_wedging, method_of_changes, rolls_otherwise, trial_of
from analytic.oil.variation import NOMINAL
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.sliding.judge import OVER_ELLIPSE, SINGLE_COEFFICIENT
from analytic.solve.records import BALL, POINT
from analytic.solve.solution import FAR, Solution
from analytic.torque import friction_torque
from tests.analytic.specimens import FINISH, OIL, drawn, idling, present, without
from tests.drawn_scenes import drawn_scene

# Parts of the torque that the same balls lose: contact angles and shares of load are solved to 1e-12 or better.
SAME = 1e-9
HAVE_PARTS = ("spin", "conformity")  # stated by their part of the torque, which is not what leaving them out changes


@pytest.fixture(scope="module")
def rich(bearing_6205: Bearing) -> Scene:
    """Every effect of balls and races has its input, and takes a visible share at one of these points."""
    return Scene(
        name="rich",
        tolerance=0.02,
        bearing=bearing_6205,
        contact_angle=idling(bearing_6205).contact_angle,
        operation=Operation(
            axial_load=np.array([310.0, 45.0, 890.0]),
            inner_speed=np.array([820.0, 37.0, 240.0]),
            radial_load=np.array([95.0, 170.0, 0.0]),
            moment=np.array([0.3, 0.0, 0.7]),
        ),
        down=(0.6, 0.0, -0.8),
        lubricant=OIL,
        surface=FINISH,
        hysteresis_loss=0.006,
        spin_rule="balanced",
        sliding="single_coefficient",  # by which shares are measured
        effects=dict.fromkeys(TRIED, "on"),
    )


def shares(found: FrictionTorque) -> dict[str, float | None]:
    return {effect.name: effect.share for effect in found.effects}


def share_of(found: FrictionTorque, name: str) -> float:
    return present(shares(found)[name])


def under_thrust(scene: Scene) -> Scene:
    operation = replace(scene.operation, radial_load=np.zeros(3), moment=np.zeros(3))
    return without(replace(scene, operation=operation), "load_distribution")


@pytest.mark.parametrize("name", sorted(set(TRIED) - {"unloaded_balls"}))  # here every ball is loaded
def test_an_effect_changes_the_torque_by_its_stated_share(rich: Scene, name: str) -> None:
    """Where it counts, and where the scene leaves it out."""
    for scene in (rich, under_thrust(rich)):
        if scene.effects[name] == "off":
            continue
        having, lacking = friction_torque(scene), friction_torque(without(scene, name))
        ratio = having.torque.total / lacking.torque.total
        assert np.abs(ratio - 1).max() > 1e-6  # far above round-off: the effect acts
        np.testing.assert_allclose(share_of(lacking, name), np.abs(ratio - 1).max(), rtol=SAME, atol=SAME)
        if name not in HAVE_PARTS:
            np.testing.assert_allclose(share_of(having, name), np.abs(1 / ratio - 1).max(), rtol=SAME, atol=SAME)


@pytest.mark.parametrize("name", HAVE_PARTS)
def test_what_slides_is_stated_by_its_part(rich: Scene, name: str) -> None:
    found = friction_torque(rich)
    part = np.asarray(getattr(found.torque, name)) / found.torque.total
    np.testing.assert_allclose(share_of(found, name), part.max(), rtol=SAME)


@pytest.mark.parametrize("points", [1, 2, FAR])
def test_few_points_compute_every_effect(bearing_6205: Bearing, points: int) -> None:
    scene = replace(idling(bearing_6205), down=(0.0, 0.6, 0.8))
    few = {name: getattr(scene.operation, name)[:points] for name in ("axial_load", "inner_speed")}
    aside = Operation(**few, radial_load=np.full(points, 0.3))
    found = friction_torque(replace(scene, tolerance=0.9, operation=aside))  # at which trial would leave all out
    on = {name for name in TRIED if found.is_on(name)}
    assert on == set(TRIED) - {"load_distribution", "weight"}  # which would cost a ring of all balls
    assert {effect.reason for effect in found.effects if effect.name in on} == {FEW}
    ring = friction_torque(replace(scene, operation=aside, tolerance=1e-7))  # nothing fits into it
    assert all(ring.is_on(name) for name in TRIED)


def test_a_longer_series_decides(bearing_6205: Bearing) -> None:
    scene = idling(bearing_6205)
    assert scene.operation.inner_speed.size == FAR + 1
    loose, strict = (friction_torque(replace(scene, tolerance=tolerance)) for tolerance in (0.9, 1e-9))
    assert {name for name in TRIED if loose.is_on(name)} <= {"rolling", "hysteresis"}  # nearly all of the torque
    assert loose.is_on("rolling")
    # No radial load, no direction, a finish far below the film, no ball without load
    idle = {"load_distribution", "weight", "asperities", "unloaded_balls"}
    assert {name for name in TRIED if strict.is_on(name)} == set(TRIED) - idle


def test_changes_of_spin_alone_are_tried_by_the_ellipse(rich: Scene) -> None:
    """Of both together one coefficient shows the change, since their torque follows the creep in second order."""
    assert method_of_changes(rich) == SINGLE_COEFFICIENT
    assert method_of_changes(replace(rich, effects={**rich.effects, "conformity": "off"})) == OVER_ELLIPSE


def test_asperities_that_carry_load_count_whatever_they_change(bearing_6205: Bearing) -> None:
    """Half of the load on asperities that resist as the oil does: else film and share would not be the contact's."""
    rough = replace(FINISH, rms_roughness=0.1e-6, boundary_friction=0.02)
    scene = replace(idling(bearing_6205), surface=rough)
    found = friction_torque(scene)
    asperities = next(effect for effect in found.effects if effect.name == "asperities")
    assert asperities.decision == "on"
    assert present(asperities.share) < scene.tolerance / 2  # which trial alone would leave out
    assert np.all(present(found.asperity_share.inner) > scene.tolerance)
    assert "asperities carry up to" in asperities.reason


def points_of(scene: Scene, chosen: NDArray[np.intp]) -> Operation:
    return Operation(**{name: values[chosen] for name, values in vars(scene.operation.as_series()).items()})


def spread(scene: Scene, seed: int, count: int) -> Scene:
    """The scene at unlike points: 1.5 decades of load, two of speed; radial loads on some where there were any."""
    random = np.random.default_rng(seed)
    load, speed = 10 ** random.uniform(1.6, 3.1, count), 10 ** random.uniform(0.3, 2.4, count)
    if scene.bearing.kind == "thrust":
        load, speed = 3 * load, speed / 10
    aside = 0.0 if scene.operation.is_thrust else load * random.uniform(0, 1.7, count) * (random.random(count) < 0.6)
    return replace(scene, operation=Operation(axial_load=load, inner_speed=speed, radial_load=aside))


def assert_auto_meets_everything_on(scene: Scene) -> None:
    """Auto is within its uncertainty, whatever it leaves out."""
    found = friction_torque(scene)
    whole = friction_torque(replace(scene, tolerance=1e-7))  # into which nothing fits
    error = np.abs(found.torque.total / whole.torque.total - 1)
    assert np.all(error <= found.numerical_uncertainty + whole.numerical_uncertainty)


LONG = 105, 111  # with all inputs, as 104 and 110, and slower


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=pytest.mark.nightly if seed in LONG else ()) for seed in range(100, 112)]
)
def test_auto_meets_everything_on_in_scenes_of_all_kinds(seed: int) -> None:
    scene = replace(drawn_scene(seed), tolerance=0.05, spin_rule="balanced")
    assert_auto_meets_everything_on(spread(scene, seed, 10 + seed % 9))


@pytest.mark.parametrize("seed", range(60, 66))
def test_auto_meets_everything_on_where_balls_turn_freely(bearing_6205: Bearing, seed: int) -> None:
    """Under thrust, whose free balls take little time; their creep has to settle to a tenth of the tolerance."""
    ruled = drawn(bearing_6205, np.random.default_rng(seed), points=12)
    thrust = replace(ruled.operation, radial_load=np.zeros(12))
    free = replace(ruled, tolerance=0.05, spin_rule="free", sliding="auto", effects={}, operation=thrust)
    found, whole = friction_torque(free), friction_torque(replace(free, tolerance=5e-3))
    error = np.abs(found.torque.total / whole.torque.total - 1)
    assert np.all(error <= found.numerical_uncertainty + whole.numerical_uncertainty)


@pytest.mark.parametrize("seed", range(3))
def test_a_point_has_its_torque_in_any_series(bearing_6205: Bearing, seed: int) -> None:
    """Of so many points each thread has some; few are solved by one."""
    random = np.random.default_rng(700 + seed)
    scene = drawn(bearing_6205, random, points=150)
    scene = friction_torque(scene).settled(scene)
    whole = friction_torque(scene).torque.total
    for chosen in (random.permutation(150), np.arange(17, 40), np.array([23]), np.array([5, 5, 131])):
        found = friction_torque(replace(scene, operation=points_of(scene, chosen)))
        np.testing.assert_allclose(found.torque.total, whole[chosen], rtol=SAME)


@pytest.mark.parametrize("seed", range(4))
def test_neither_order_nor_direction_changes_what_auto_decides(bearing_6205: Bearing, seed: int) -> None:
    random = np.random.default_rng(800 + seed)
    scene = replace(drawn(bearing_6205, random, points=26), tolerance=0.05, effects={}, sliding="auto")
    order = random.permutation(26)
    mixed = points_of(scene, order)
    found, other = (
        friction_torque(scene),
        friction_torque(replace(scene, operation=replace(mixed, inner_speed=-mixed.inner_speed))),
    )
    assert other.effects.decisions == found.effects.decisions
    assert other.sliding == found.sliding
    np.testing.assert_allclose(other.torque.total, found.torque.total[order], rtol=SAME)


@pytest.mark.parametrize("unlike", [(0.02, 0.0), (0.0, 300.0)])
def test_one_point_changes_no_other(rich: Scene, unlike: tuple[float, float]) -> None:
    """A light one, which trials see, and one under a radial load alone, which asks for a ring."""
    random = np.random.default_rng(8)
    load, speed = random.uniform(60, 1900, 40), random.uniform(3, 240, 40)
    thrust = Operation(axial_load=load, inner_speed=speed, radial_load=np.zeros(40))
    load, aside = load.copy(), np.zeros(40)
    load[19], aside[19] = unlike
    one = Operation(axial_load=load, inner_speed=speed, radial_load=aside)
    # Weight would load all balls unlike at every point.
    alike, mixed = (friction_torque(replace(without(rich, "weight"), operation=each)) for each in (thrust, one))
    others = np.arange(40) != 19
    np.testing.assert_allclose(mixed.torque.total[others], alike.torque.total[others], rtol=SAME)
    assert abs(mixed.torque.total[19] / alike.torque.total[19] - 1) > 0.1


@pytest.mark.parametrize(("power", "lean"), [(1.0, 0.02), (1.0, 0.04), (1.0, 0.09)])
def test_friction_across_the_grooves_softens_a_ball_as_in_the_triangle_of_centres(
    bearing_6205: Bearing, power: float, lean: float
) -> None:
    """By the change of the distance of the groove centres with the load, for a lean as the load to a power.

    A ball, both centres of curvature and two springs: the centres are apart as the third side of a triangle.
    """
    inner, outer = (
        groove.groove_radius - bearing_6205.ball_radius for groove in (bearing_6205.inner, bearing_6205.outer)
    )
    softness, load = (4.1e-7, 3.7e-7), 2.3  # m/N^(2/3), N

    def approaches(force: float) -> tuple[float, float]:
        return softness[0] * force ** (2 / 3), softness[1] * force ** (2 / 3)

    def distance(force: float, lean: float) -> float:
        arms = inner + approaches(force)[0], outer + approaches(force)[1]
        angle = 2 * lean * (force / load) ** power
        return float(np.sqrt(arms[0] ** 2 + arms[1] ** 2 + 2 * arms[0] * arms[1] * np.cos(angle)))

    step = 1e-3 * load
    soft, bare = (distance(load + step, each) - distance(load - step, each) for each in (lean, 0.0))
    expected = bare / soft if soft > 0 else np.inf
    balls, straight = (np.zeros((1, 1), BALL) for _ in range(2))
    for each, angles in ((straight, (0.31, 0.31)), (balls, (0.31 + lean, 0.31 - lean))):
        each["load"], each["approach"], each["angle"] = load, approaches(load), angles
    (found,) = growth_by_wedging(
        bearing_6205, *(Solution(points=np.zeros(1, POINT), balls=each) for each in (straight, balls))
    )
    np.testing.assert_allclose(found, expected, rtol=0.02)  # the arms are longer than l by the approach, 1 % of them
    assert (found == np.inf) == (lean == 0.09)
    assert found > 1.05


@pytest.mark.parametrize(
    ("inner_radius", "angle", "load", "needed"),
    [
        pytest.param(4.9e-3, 0.6, 2.0, "PER_ORBIT", id="grooves of unlike radii"),
        pytest.param(4.13e-3, 0.02, 900.0, "PER_CONFORMITY", id="a long contact"),
    ],
)
def test_how_fast_free_balls_roll_is_bounded(
    bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch, inner_radius: float, angle: float, load: float, needed: str
) -> None:
    """Without creep and inertia, and with friction enough, balls by rule differ from free ones by this alone."""
    scene = Scene(
        name="slow",
        tolerance=1e-6,
        bearing=replace(bearing_6205, inner=replace(bearing_6205.inner, groove_radius=inner_radius)),
        contact_angle=ContactAngle(rule="given", value=angle),
        operation=Operation(axial_load=np.array([load * np.sin(angle)]), inner_speed=np.array([0.3])),
        friction_coefficient=0.02,
        effects=dict.fromkeys(("creep", "centrifugal", "gyroscopic", "weight"), "off"),
    )
    ruled, free = (friction_torque(replace(scene, sliding=method)) for method in ("over_ellipse", "free_ball"))
    error = ruled.numerical_uncertainty[0] + free.numerical_uncertainty[0]
    apart = abs(free.torque.total[0] / ruled.torque.total[0] - 1) - error
    balls = trial_of(scene, scene.operation.as_series(), None, NOMINAL).under_thrust
    (bound,) = rolls_otherwise(scene.bearing, balls)
    assert 0 < apart < bound < 20 * apart
    monkeypatch.setattr(trial, needed, 0.0)
    (other,) = rolls_otherwise(scene.bearing, balls)
    assert other < apart  # each part is needed
