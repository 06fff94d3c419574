"""The torque as a function for time steps: the same numbers as the series has, errors, and no memory that grows."""

import itertools
import tracemalloc
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque, load_scene, torque_function
from analytic.errors import FembearingError, InputError
from analytic.function import TorqueFunction
from analytic.scene import Arrangement, Operation, Scene

SCENES = Path(__file__).parents[2] / "validation" / "scenes"
ROUND_OFF = 1e-11  # the ring settles to 1e-12 of its load, from two different starts
LOADS = [(310.0, 0.0, 0.0), (120.0, 770.0, 0.0), (900.0, 130.0, 2.3), (45.0, 0.0, -0.7)]  # N, N, N m


def scene_of(name: str, **changed: object) -> Scene:
    """Its ring tilts freely, so that calls may have a moment."""
    scene = load_scene(SCENES / f"{name}.toml" if (SCENES / f"{name}.toml").exists() else name)
    free = replace(scene.operation, tilt="free")
    return replace(scene, **({"operation": free} | changed))  # pyright: ignore[reportArgumentType]


@pytest.fixture(scope="module")
def balanced() -> TorqueFunction:
    """Of balls without a memory of earlier calls; a bad number gives NaN."""
    return torque_function(scene_of("6205_physical", spin_rule="balanced"), invalid="nan")


def by_series(function: TorqueFunction, *, temperature: float | None = None, **operation: float) -> float:
    points = {name: np.array([value]) for name, value in operation.items()}
    scene = replace(function.scene, operation=Operation(tilt=function.scene.operation.tilt, **points))
    if temperature is not None:
        assert scene.lubricant is not None
        scene = replace(scene, lubricant=replace(scene.lubricant, temperature=temperature))
    return float(friction_torque(scene).torque.total[0])


@pytest.mark.parametrize("rule", ["balanced", "outer_control", "free"])
@pytest.mark.parametrize("name", ["6205-dry", "paper_6205", "6205_physical", "6205_hybrid"])
def test_the_torque_is_that_of_the_series(name: str, rule: str) -> None:
    function = torque_function(scene_of(name, spin_rule=rule))
    for (axial, radial, moment), speed in zip(LOADS, (17.0, -310.0, 3.0, 88.0), strict=True):
        given = {"axial_load": axial, "radial_load": radial, "moment": moment, "inner_speed": speed}
        np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=ROUND_OFF)


def test_a_thrust_bearing_and_a_given_angle() -> None:
    """Neither has a solved angle; the torque then takes no other load."""
    for name in ("thrust_rig_3mm", "6205_paper_calibrated"):
        function = torque_function(scene_of(name, spin_rule="balanced"))
        given = {"axial_load": 37.0, "inner_speed": 11.0}
        np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=ROUND_OFF)
        with pytest.raises(InputError, match="radial_load"):
            function(**given, radial_load=80.0)


PAIR = Arrangement(kind="X", preload=130.0, distance=0.03)
OTHERS: list[tuple[str, dict[str, Any], dict[str, float], float]] = [
    ("6205_physical", {"down": (0.6, -0.8, 0.0)}, {"radial_load": 60.0, "inner_speed": 140.0}, ROUND_OFF),
    ("6205_physical", {"down": (0.6, -0.8, 0.0)}, {"radial_load": 60.0, "inner_speed": 0.0}, ROUND_OFF),
    ("6205_physical", {"arrangement": PAIR}, {"inner_speed": 33.0}, 0.0),  # a series at each call
    ("6205_paper_as_printed", {}, {"inner_speed": 33.0}, 1e-9),
]


@pytest.mark.parametrize(("name", "changed", "loads", "close"), OTHERS)
def test_weight_pairs_and_printed_moments_are_those_of_the_series(
    name: str, changed: dict[str, Any], loads: dict[str, float], close: float
) -> None:
    rule = {} if "printed" in name else {"spin_rule": "balanced"}
    function, given = torque_function(scene_of(name, **rule, **changed)), {"axial_load": 230.0, **loads}
    np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=close)


def test_the_oil_s_temperature() -> None:
    """Cold oil resists more; the viscosity is that of the lubricant at that temperature."""
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"))
    given = {"axial_load": 410.0, "radial_load": 95.0, "inner_speed": 230.0}
    assert function.scene.lubricant is not None
    scene_s = function.scene.lubricant.temperature
    cold, own, warm = (function(**given, temperature=scene_s + change) for change in (-21.0, 0.0, 34.0))
    assert cold > own > warm > 0
    np.testing.assert_allclose(own, function(**given), rtol=0)
    np.testing.assert_allclose(cold, by_series(function, **given, temperature=scene_s - 21.0), rtol=ROUND_OFF)


@pytest.mark.parametrize("radial", [0.0, 320.0])
def test_what_was_called_before_moves_no_torque(radial: float) -> None:
    """Free balls begin each call by rule."""
    function = torque_function(scene_of("6205_physical", spin_rule="free"))
    first = {"axial_load": 600.0, "inner_speed": 41.0, "radial_load": radial}
    other = {"axial_load": 410.0, "inner_speed": 67.0, "radial_load": 1.3 * radial, "temperature": 317.0}
    cold = function(**first)
    away = function(**other)
    assert function(**first) == cold
    assert function.copy()(**other) == away
    assert abs(away / cold - 1) > 0.02


STEPS = {"axial_load": 8.0, "inner_speed": 0.9, "radial_load": 8.0, "moment": 0.05, "temperature": 1.5}


@pytest.mark.parametrize("rule", ["balanced", "free"])
def test_the_gradient_is_that_of_torques_of_the_series(rule: str) -> None:
    """Against wider differences; their error of third order is below 2 % of the slope, or 1e-4 of the torque a step."""
    # Of one level of nodes, which that tolerance leaves to all points; between two levels the torque jumps.
    function = torque_function(scene_of("6205_physical", spin_rule=rule, tolerance=0.3))
    at = {"axial_load": 520.0, "inner_speed": 61.0, "radial_load": 140.0, "moment": 0.4, "temperature": 334.0}
    slopes = function.gradient(**at)
    assert set(slopes) == set(at)
    for name, step in STEPS.items():
        ends = [by_series(function, **{**at, name: at[name] + sign * step}) for sign in (-1, 1)]
        np.testing.assert_allclose(
            slopes[name], (ends[1] - ends[0]) / (2 * step), rtol=0.02, atol=1e-4 * ends[1] / step
        )
    # Warm oil resists less to rolling, which is most of the torque here.
    assert slopes["axial_load"] > 0 > slopes["temperature"]


def test_a_torque_without_oil_has_no_slope_by_temperature() -> None:
    slopes = torque_function(scene_of("6205-dry")).gradient(axial_load=700.0, inner_speed=31.0)
    assert "temperature" not in slopes
    # The torque is even in it, and free balls leave 3e-7 of the torque over a step of 14 N.
    np.testing.assert_allclose(slopes["radial_load"], 0.0, atol=1e-4 * slopes["axial_load"])


def test_balls_that_squeeze_the_cage_have_the_series_closed_form() -> None:
    """Where balls lead farther than the pockets leave free, the point goes to the series."""
    scene = scene_of("6205-dry", spin_rule="balanced")
    assert scene.cage is not None
    function = torque_function(replace(scene, cage=replace(scene.cage, pocket_diameter=7.96e-3, pocket_depth=3.975e-3)))
    given = {"axial_load": 300.0, "radial_load": 700.0, "inner_speed": 90.0}
    np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=0)
    assert np.isnan(function.out["cage"][0])


@pytest.mark.parametrize("name", ["6205_physical", "thrust_rig_3mm"])
def test_numbers_are_refused_as_a_series_refuses_them(name: str) -> None:
    """Loads that press the wrong way, or too little for the speed, and what is no number."""
    function = torque_function(scene_of(name, spin_rule="balanced"))
    refused = answered = 0
    loads = itertools.product([-40.0, 0.0, 1e-6, 0.9, 230.0, np.nan], [0.0, -310.0, np.inf], [0.0, 1.7])
    for (axial, radial, moment), speed in itertools.product(loads, [0.0, -61.0, 2900.0]):
        given = {"axial_load": axial, "radial_load": radial, "moment": moment, "inner_speed": speed}
        try:
            expected = by_series(function, **given)
        except FembearingError:
            refused += 1
            with pytest.raises(FembearingError):
                function(**given)
        else:
            answered += 1
            # Hardly any thrust holds the ring along its axis, and settling leaves fewer digits.
            # Each takes its own nodes.
            np.testing.assert_allclose(function(**given), expected, rtol=1e-5)
    assert min(refused, answered) >= 5


@pytest.mark.parametrize("temperature", [np.nan, -np.inf, 0.0, 199.9, 600.1, np.inf])
def test_an_oil_that_no_scene_may_have_is_refused(balanced: TorqueFunction, temperature: float) -> None:
    with pytest.raises(InputError, match="temperature must be 200 to 600 K"):
        torque_function(balanced.scene)(axial_load=310.0, inner_speed=40.0, temperature=temperature)
    table = balanced.series(axial_load=310.0, inner_speed=40.0, temperature=[200.1, temperature, 599.9])
    np.testing.assert_array_equal(np.isnan(table), [False, True, False])


@pytest.mark.parametrize("wrong", ["300 N", "300", b"300", [300.0], np.array([300.0, 200.0]), 3 + 4j, 10**400])
@pytest.mark.parametrize("name", ["axial_load", "inner_speed", "radial_load", "moment", "temperature"])
def test_what_is_no_number_is_refused_in_one_line(balanced: TorqueFunction, name: str, wrong: Any) -> None:
    with pytest.raises(InputError, match=name) as problem:
        balanced(**{"axial_load": 310.0, "inner_speed": 40.0, name: wrong})
    assert len(str(problem.value).splitlines()) == 1


def test_numbers_of_every_kind_are_taken(balanced: TorqueFunction) -> None:
    given = {"axial_load": 310, "inner_speed": np.array(40.0), "radial_load": np.float32(17.0)}
    assert balanced(**given) == balanced(axial_load=310.0, inner_speed=40.0, radial_load=17.0)


def test_a_series_refuses_texts_and_shapes_that_do_not_fit() -> None:
    function = torque_function(scene_of("6205-dry", spin_rule="balanced"))
    with pytest.raises(InputError, match="axial_load must be a number"):
        function.series(axial_load=["300", "200"], inner_speed=40.0)  # pyright: ignore[reportArgumentType]
    with pytest.raises(InputError, match="shapes that do not fit"):
        function.series(axial_load=[300.0, 200.0], inner_speed=[1.0, 2.0, 3.0])


def test_nonsense_is_refused() -> None:
    with pytest.raises(InputError, match="invalid must be"):
        torque_function(scene_of("6205-dry"), invalid="ignore")  # pyright: ignore[reportArgumentType]
    moving = scene_of("paper_6205", effects={"cage_dynamics": "on"})
    with pytest.raises(InputError, match="moving cage"):
        torque_function(moving)


@pytest.mark.nightly
def test_calls_keep_no_memory(balanced: TorqueFunction) -> None:
    tracemalloc.start()
    kept = []
    for step in range(3000):  # Python itself keeps up to 2000 used tuples of each length
        balanced(axial_load=300.0 + step % 700, radial_load=20.0, inner_speed=40.0)
        if step in (2199, 2999):
            kept.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    assert kept[1] - kept[0] < 10_000  # bytes, of 800 calls: less than one number for each
