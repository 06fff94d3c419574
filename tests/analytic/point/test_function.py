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
from analytic.point.function import TorqueFunction
from analytic.scene import Operation, Scene

SCENES = Path(__file__).parents[3] / "validation" / "scenes"
ROUND_OFF = 1e-11  # the ring settles to 1e-12 of its load, from two different starts
LOADS = [(310.0, 0.0, 0.0), (120.0, 770.0, 0.0), (900.0, 130.0, 2.3), (45.0, 0.0, -0.7)]  # N, N, N m


def scene_of(name: str, **changed: object) -> Scene:
    scene = load_scene(SCENES / f"{name}.toml" if (SCENES / f"{name}.toml").exists() else name)
    return replace(scene, **changed)  # pyright: ignore[reportArgumentType]


def by_series(function: TorqueFunction, *, temperature: float | None = None, **operation: float) -> float:
    points = {name: np.array([value]) for name, value in operation.items()}
    scene = replace(function.scene, operation=Operation(**points))
    if temperature is not None:
        assert scene.lubricant is not None
        scene = replace(scene, lubricant=replace(scene.lubricant, temperature=temperature))
    return float(friction_torque(scene).torque.total[0])


@pytest.mark.parametrize("sliding", ["auto", "along_axis", "over_ellipse"])
@pytest.mark.parametrize("rule", ["balanced", "outer_control"])
@pytest.mark.parametrize("name", ["6205-dry", "paper_6205", "6205_physical", "6205_hybrid"])
def test_the_torque_is_that_of_the_series(name: str, rule: str, sliding: str) -> None:
    function = torque_function(scene_of(name, spin_rule=rule, sliding=sliding))
    assert function.is_compiled
    for (axial, radial, moment), speed in zip(LOADS, (17.0, -310.0, 3.0, 88.0), strict=True):
        given = {"axial_load": axial, "radial_load": radial, "moment": moment, "inner_speed": speed}
        # The series may take more nodes over the ellipse than the first rule of that method has.
        close = 2e-3 if sliding == "over_ellipse" else ROUND_OFF
        np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=close)


def test_a_thrust_bearing_and_a_given_angle() -> None:
    """Neither has a solved angle; the torque then takes no other load."""
    for name in ("thrust_rig_3mm", "6205_paper_calibrated"):
        function = torque_function(scene_of(name, spin_rule="balanced"))
        given = {"axial_load": 37.0, "inner_speed": 11.0}
        np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=ROUND_OFF)
        with pytest.raises(InputError, match="radial_load"):
            function(**given, radial_load=80.0)


def test_the_oil_s_temperature() -> None:
    """Cold oil resists more; the viscosity is that of the lubricant at that temperature."""
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"))
    given = {"axial_load": 410.0, "radial_load": 95.0, "inner_speed": 230.0}
    assert function.scene.lubricant is not None
    scene_s = function.scene.lubricant.temperature
    cold, own, warm = (function(**given, temperature=scene_s + change) for change in (-21.0, 0.0, 34.0))
    assert cold > own > warm > 0
    np.testing.assert_allclose(own, function(**given), rtol=0)
    np.testing.assert_allclose(
        cold, by_series(function, **given, temperature=scene_s - 21.0), rtol=1e-9
    )  # of beta there


def test_the_weight_of_the_balls_and_standstill() -> None:
    function = torque_function(scene_of("6205_physical", spin_rule="balanced", down=(0.6, -0.8, 0.0)))
    for speed in (0.0, 140.0):
        given = {"axial_load": 230.0, "radial_load": 60.0, "inner_speed": speed}
        np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=ROUND_OFF)


def test_a_series_is_its_points() -> None:
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"))
    axial, radial = np.array([[310.0], [760.0]]), np.array([0.0, 55.0, 480.0])
    table = function.series(axial_load=axial, radial_load=radial, inner_speed=67.0)
    assert table.shape == (2, 3)
    for i, j in np.ndindex(2, 3):
        assert table[i, j] == function(axial_load=float(axial[i, 0]), radial_load=float(radial[j]), inner_speed=67.0)


def test_free_balls_are_computed_as_in_a_series() -> None:
    """They need creep, which is not compiled in one step: each call is a series of one point."""
    function = torque_function(scene_of("6205_physical", spin_rule="free", sliding="closed_creep"))
    assert not function.is_compiled
    given = {"axial_load": 600.0, "inner_speed": 41.0}
    np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=0)


def test_balls_that_squeeze_the_cage_have_the_series_closed_form() -> None:
    """Where balls lead farther than the pockets leave free, the point goes to the series."""
    scene = scene_of("6205-dry", spin_rule="balanced")
    assert scene.cage is not None
    function = torque_function(replace(scene, cage=replace(scene.cage, pocket_diameter=7.96e-3, pocket_depth=3.975e-3)))
    given = {"axial_load": 300.0, "radial_load": 700.0, "inner_speed": 90.0}
    assert function.is_compiled
    np.testing.assert_allclose(function(**given), by_series(function, **given), rtol=0)
    assert np.isnan(function.torques[0, 0])


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"axial_load": np.nan}, "axial_load must be positive and finite"),
        ({"inner_speed": np.inf}, "inner_speed must be finite"),
        ({"axial_load": -3.0}, "axial_load"),
        ({"axial_load": 9e6}, "shoulder|grooves"),
    ],
)
def test_bad_numbers_raise_or_give_nan(changed: dict[str, float], message: str) -> None:
    scene = scene_of("6205_physical", spin_rule="balanced")
    given = {"axial_load": 300.0, "inner_speed": 40.0} | changed
    with pytest.raises(FembearingError, match=message):
        torque_function(scene)(**given)
    assert np.isnan(torque_function(scene, invalid="nan")(**given))


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
            np.testing.assert_allclose(function(**given), expected, rtol=1e-8)
    assert min(refused, answered) >= 5


@pytest.mark.parametrize("temperature", [np.nan, -np.inf, 0.0, 199.9, 600.1, np.inf])
def test_an_oil_that_no_scene_may_have_is_refused(temperature: float) -> None:
    scene = scene_of("6205_physical", spin_rule="balanced")
    with pytest.raises(InputError, match="temperature must be 200 to 600 K"):
        torque_function(scene)(axial_load=310.0, inner_speed=40.0, temperature=temperature)
    table = torque_function(scene, invalid="nan").series(
        axial_load=310.0, inner_speed=40.0, temperature=[200.1, temperature, 599.9]
    )
    np.testing.assert_array_equal(np.isnan(table), [False, True, False])


@pytest.mark.parametrize("wrong", ["300 N", "300", b"300", [300.0], np.array([300.0, 200.0]), 3 + 4j, 10**400])
@pytest.mark.parametrize("name", ["axial_load", "inner_speed", "radial_load", "moment", "temperature"])
def test_what_is_no_number_is_refused_in_one_line(name: str, wrong: Any) -> None:
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"), invalid="nan")
    with pytest.raises(InputError, match=name) as problem:
        function(**{"axial_load": 310.0, "inner_speed": 40.0, name: wrong})
    assert len(str(problem.value).splitlines()) == 1


def test_numbers_of_every_kind_are_taken() -> None:
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"))
    given = {"axial_load": 310, "inner_speed": np.array(40.0), "radial_load": np.float32(17.0)}
    assert function(**given) == function(axial_load=310.0, inner_speed=40.0, radial_load=17.0)


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


def test_calls_keep_no_memory() -> None:
    function = torque_function(scene_of("6205_physical", spin_rule="balanced"))
    tracemalloc.start()
    kept = []
    for step in range(5000):  # Python itself keeps up to 2000 used tuples of each length
        function(axial_load=300.0 + step % 700, radial_load=20.0, inner_speed=40.0)
        if step % 2500 == 2499:
            kept.append(tracemalloc.get_traced_memory()[0])
    tracemalloc.stop()
    assert kept[1] - kept[0] < 10_000  # bytes, of 2500 calls: less than one number for each
