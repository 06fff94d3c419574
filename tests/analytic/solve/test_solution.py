"""Records of operating points: sums and ratios of them, and many points on several cores."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.contact.factors import ContactCorrection, ContactFactors
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.solve.model import model_of
from analytic.solve.solution import LEAST_SLICE, points_of, solved


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
def test_many_points_are_those_of_one_at_a_time(scene: Scene, has_factors: bool) -> None:
    """Two slices for two threads, where there are two cores; factors that are given belong to their points."""
    count = 2 * LEAST_SLICE
    loads = Operation(axial_load=np.linspace(310.0, 970.0, count), inner_speed=np.linspace(13.0, 91.0, count))
    wide = ContactFactors(semi_axis_transverse=np.linspace(1.01, 1.3, count))
    correction = ContactCorrection(inner=wide) if has_factors else None
    model = model_of(scene, {"spin": True, "conformity": True}, free=False, correction=correction)
    points = points_of(loads.as_series(), 0.0)
    each = [solved(model.at(np.array([i])), points[[i]]).points["total"][0] for i in range(count)]
    np.testing.assert_array_equal(solved(model, points).points["total"], each)
    assert solved(model, points, keeps_balls=False).balls.size == 0


def test_a_pattern_of_given_factors_stays_with_its_points(scene: Scene) -> None:
    """Some of the points, in another order, have their own factors."""
    wide = ContactFactors(semi_axis_rolling=np.linspace(1.02, 1.4, 7))
    model = model_of(scene, {"hysteresis": True}, free=False, correction=ContactCorrection(outer=wide))
    points, chosen = points_of(scene.operation, 0.0), np.array([5, 1, 3])
    every, some = solved(model, points), solved(model.at(chosen), points[chosen])
    np.testing.assert_array_equal(some.points["total"], every.points["total"][chosen])
    np.testing.assert_array_equal(every.at(chosen).points["total"], some.points["total"])
    bare = solved(replace(model, tables=model_of(scene, {"hysteresis": True}, free=False).tables), points)
    assert np.all(every.points["hysteresis"] > bare.points["hysteresis"])
