"""What follows from the nouns of a scene: geometry of a bearing, losses, operating points, an arrangement."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import (
    Operation,
    Scene,
)
from tests.analytic.specimens import BEARING_6205, OIL, thrust, with_clearance
from tests.analytic.test_thrust_bearing import BEARING as THRUST_BEARING
from tests.refusals import refused


def test_a_bearing_is_a_deep_groove_bearing_by_its_series() -> None:
    for series, is_deep in (("62", True), ("618", True), ("72 B", False), ("NSK 72 C", False)):
        assert replace(BEARING_6205, series=series).is_deep_groove == is_deep
        assert replace(with_clearance(BEARING_6205, 0.5e-3), series=series).is_deep_groove == is_deep
    assert not THRUST_BEARING.is_deep_groove


@pytest.mark.parametrize(("degrees", "is_deep"), [(19.9, True), (20.1, False)])
def test_without_a_series_a_deep_groove_bearing_leans_by_twenty_degrees_at_most(degrees: float, is_deep: bool) -> None:
    """The clearance lets the groove centres, A_0 apart, lean by the angle: P_d = 2 A_0 (1 - cos al)."""
    clearance = 2 * 0.40e-3 * (1 - np.cos(np.radians(degrees)))
    assert with_clearance(BEARING_6205, clearance).is_deep_groove == is_deep
    assert with_clearance(BEARING_6205, -clearance).is_deep_groove  # preload closes the angle


def test_grease_starves_as_measured_in_a_deep_groove_bearing_and_the_supply_where_nothing_else_is_known() -> None:
    grease, given = replace(OIL, supply="grease"), replace(OIL, starvation_degree=3.0)
    for oil, bearing, is_measured, by_supply in (
        (OIL, BEARING_6205, False, True),
        (grease, BEARING_6205, True, False),
        (grease, replace(BEARING_6205, series="72 B"), False, True),
        (given, BEARING_6205, False, False),
        (replace(given, supply="grease"), BEARING_6205, False, False),
        (OIL, replace(BEARING_6205, bore_diameter=None), False, False),
        (OIL, replace(BEARING_6205, outside_diameter=None), False, False),
    ):
        found = oil.starves_as_measured(bearing), oil.starves_by_replenishment(bearing)
        assert found == (is_measured, by_supply)


def test_a_series_has_arrays_of_one_length() -> None:
    series = Operation(axial_load=np.array([310.0, 470.0]), inner_speed=np.array(31.0), moment=0.7).as_series()
    for name, expected in (
        ("axial_load", [310.0, 470.0]),
        ("inner_speed", [31.0, 31.0]),
        ("radial_load", [0.0, 0.0]),
        ("moment", [0.7, 0.7]),
    ):
        np.testing.assert_array_equal(getattr(series, name), expected)
    one = Operation(axial_load=np.array(310.0), inner_speed=np.array(31.0)).as_series()
    assert one.axial_load.shape == (1,)
    unlike = Operation(axial_load=np.array([1.0, 2.0]), inner_speed=np.array([1.0, 2.0, 3.0]))
    refused(unlike.as_series, "shapes that do not fit")
    refused(Operation(axial_load=np.array([]), inner_speed=np.array([])).as_series, "is empty")


SCENE = Scene(bearing=BEARING_6205, operation=thrust(310.0, 89.0), friction_coefficient=0.08)


@pytest.mark.parametrize("tolerance", [0.0, 0, -0.03, float("nan"), float("inf"), "5 %", None])
def test_the_tolerance_of_a_scene_is_positive(tolerance: Any) -> None:
    refused(lambda: replace(SCENE, tolerance=tolerance), "Scene.tolerance must be")


@pytest.mark.parametrize("count", [9.5, float("nan"), float("inf"), "9", None])
def test_balls_are_counted_in_whole_numbers(count: Any) -> None:
    message = f"Bearing.ball_count must be a whole number, got {count!r}"
    refused(lambda: replace(BEARING_6205, ball_count=count), message)
    for whole in (9, 9.0, np.int64(9)):
        counted = replace(BEARING_6205, ball_count=whole).ball_count  # pyright: ignore[reportArgumentType]
        assert (counted, type(counted)) == (9, int)


@pytest.mark.parametrize(
    "down", [(0.0, 0.0, 0.0), [1, 0], "x", float("nan"), (float("nan"), 0.6, 0.8), (0.0, -9.81, 0.0), ("0", "0", "1")]
)
def test_down_is_a_unit_vector(down: Any) -> None:
    refused(lambda: replace(SCENE, down=down), "Scene.down must be a unit vector", f"got {down!r}", "(1.0, 0.0, 0.0)")


def test_a_unit_vector_may_be_rounded_to_two_digits() -> None:
    for down in (None, (0.6, -0.8, 0.0), [0.0, 0.0, -1.0], (0.58, 0.58, -0.58)):
        assert replace(SCENE, down=down).down == down  # pyright: ignore[reportArgumentType]
