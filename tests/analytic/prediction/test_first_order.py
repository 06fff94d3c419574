"""The interval to first order: against a law whose interval is known, and against samples."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.oil.variation import Variation
from analytic.prediction.first_order import end_factors, first_order_ends
from analytic.prediction.prediction import predict
from analytic.scene import Array, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque

ONE_INPUT = dict.fromkeys(
    (
        "bearing.inner.conformity", "bearing.outer.conformity", "bearing.contact_angle.free", "operation.axial_load",
    ),
    0.0,
)  # fmt: skip


@pytest.fixture(scope="module")
def dry() -> Scene:
    return load_scene("6205-dry")


def test_one_input_in_proportion_gives_its_own_interval(dry: Scene) -> None:
    """The torque of gross sliding goes with the friction coefficient, which is lognormal."""
    scene = replace(
        dry,
        uncertainty=ONE_INPUT | {"friction.coefficient": 0.02},  # a fifth of 0.1
        effects={"hysteresis": "off", "cage": "off", "cage_dynamics": "off", "creep": "off"},
        spin_rule="balanced",
    )
    nominal = friction_torque(scene)
    ends = first_order_ends(scene, nominal)
    assert ends is not None
    # 1e-3: the balls' numerical uncertainty, two deviations of the total, is another input
    spread = np.hypot(0.2, nominal.numerical_uncertainty / 2)
    np.testing.assert_allclose(ends, nominal.torque.total * np.exp(1.959964 * np.array([-spread, spread])), rtol=1e-3)


@pytest.mark.nightly
@pytest.mark.parametrize("name", ["paper_6205", "6205-dry"])
def test_the_ends_are_those_of_samples(name: str) -> None:
    """Within a fifth, the largest difference in 100 random scenes of validation/intervals: products of two inputs are
    neglected."""
    scene = load_scene(name)
    ends = first_order_ends(scene, friction_torque(scene))
    assert ends is not None
    np.testing.assert_allclose(ends, predict(scene, samples=1024).total.ends, rtol=0.2)


def test_an_input_that_leaves_no_torque_leaves_no_interval(dry: Scene) -> None:
    """Conformity below a half is no groove: an end of its spread has no torque."""
    wild = replace(dry, uncertainty={"operation.axial_load": 900.0, "bearing.contact_angle.free": 0.6})
    assert first_order_ends(wild, friction_torque(dry)) is None


def test_the_interval_of_a_cold_bearing_contains_the_starved_and_the_flooded_torque() -> None:
    """At -20 degC the factor leaves a thousandth of rolling; the torque of a start is that of a flooded bearing."""
    scene = load_scene("6206", radial_load="1.2 kN", speed="2400 rpm", oil="ISO VG 46", temperature="-20 degC")
    nominal = friction_torque(scene)
    ends = first_order_ends(scene, nominal)
    assert ends is not None
    starved, flooded = (friction_torque(scene, variation=Variation(starvation=step)).torque.total for step in (-1, 1))
    assert np.all((ends[0] < starved) & (starved < nominal.torque.total) & (flooded < ends[1]))
    assert np.all(flooded > 10 * nominal.torque.total)


def test_the_interval_does_not_jump_over_the_temperature() -> None:
    """From a bath that is all but flooded to one that starves: no threshold."""

    def at(celsius: float) -> Array:
        scene = load_scene(
            "6206", axial_load="700 N", speed="1500 rpm", oil="ISO VG 150", temperature=f"{celsius} degC"
        )
        ends = first_order_ends(scene, friction_torque(scene))
        assert ends is not None
        return np.log(ends[:, 0])

    for celsius in (40.0, 21.0, 5.0):  # the end of the oil's line, half of rolling, and less
        below, here, above = (at(celsius + step) for step in (-0.1, 0.0, 0.1))
        # 0.1 K changes the viscosity by a percent, and this change by far less.
        np.testing.assert_allclose(below - here, here - above, atol=2e-3)


def test_independent_inputs_add_their_squares_at_the_end_that_they_move() -> None:
    """One moves both ends, one the upper end alone; what both ends of an input raise counts once."""
    base = np.array([2.0, 3.0])
    both = base * np.exp([[-0.3, -0.1], [0.3, 0.2]])
    up = base * np.exp([[0.4, 0.05], [0.1, 0.02]])
    expected = np.exp([[-0.3, -0.1], [0.5, np.hypot(0.2, 0.05)]])
    np.testing.assert_allclose(end_factors(base, [both, up]), expected, rtol=1e-12)
    np.testing.assert_allclose(end_factors(base, [both[::-1], up]), expected, rtol=1e-12)
    nothing = end_factors(np.array([0.0, 3.0]), [np.array([[0.0, 1.5], [1.0, 0.0]])])
    np.testing.assert_allclose(nothing, [[1.0, 0.5], [1.0, 1.0]], rtol=1e-12)
