"""Operating points without a torque keep their places in columns and in JSON."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.columns import rows_of
from analytic.errors import FembearingError, InputError
from analytic.left_out import Places
from analytic.scene import Operation, Scene
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene

POINTS = Operation(
    axial_load=np.array([100.0, 5e9, 300.0, 700.0]),
    inner_speed=np.array([20.0, 30.0, 20.0, 20.0]),
    radial_load=np.array([0.0, 2.0, 0.0, 0.0]),
    moment=np.array([0.0, 0.3, 0.0, 0.0]),
)
PLACES = Places(operation=POINTS, failures={1: InputError("too heavy")})


def test_columns_know_the_loads_of_every_point_and_nothing_else_of_a_lost_one() -> None:
    """Also of lists, and of texts."""
    whole = PLACES.columns(
        {
            "axial_load": np.array([100.0, 300.0, 700.0]),
            "moment": np.zeros(3),
            "torque_total": np.array([3e-3, 5e-3, 8e-3]),
            "state": np.array(["rest", "whirl", "rest"]),
            "balls/load": np.arange(6.0).reshape(3, 2),
        }
    )
    assert whole["axial_load"].tolist() == [100.0, 5e9, 300.0, 700.0]
    assert whole["moment"].tolist() == [0.0, 0.3, 0.0, 0.0]
    assert whole["torque_total"].tolist() == pytest.approx([3e-3, np.nan, 5e-3, 8e-3], nan_ok=True)
    assert rows_of(whole)[1:3] == (
        {"axial_load": 5e9, "moment": 0.3, "torque_total": None, "state": None, "balls": None},
        {"axial_load": 300.0, "moment": 0.0, "torque_total": 5e-3, "state": "whirl", "balls": {"load": [2.0, 3.0]}},
    )


def series_of(*loads: float) -> Scene:
    """A dry 6205 that pulls back at a thrust below 0: no torque there."""
    operation = Operation(axial_load=np.array(loads), inner_speed=np.arange(10.0, 10.0 + len(loads)))
    return replace(load_scene("6205-dry"), friction_coefficient=0.07, cage=None, operation=operation)


def test_every_point_that_has_a_torque_keeps_it_and_the_others_have_a_reason() -> None:
    heavy = 5e12
    found = torque_of_scene(series_of(300.0, heavy, 500.0, 2 * heavy, 700.0), keep_going=True)
    assert found.scene.operation.axial_load.tolist() == [300.0, 500.0, 700.0]
    assert [(each["point"], each["axial_load"], each["inner_speed"]) for each in found.places.left_out] == [
        (1, heavy, 11.0),
        (3, 2 * heavy, 13.0),
    ]
    assert all(each["reason"] for each in found.places.left_out)
    alone = torque_of_scene(series_of(300.0, 500.0, 700.0), keep_going=True)
    assert alone.places.left_out == ()
    np.testing.assert_allclose(  # each point starts from its neighbour
        found.friction.torque.total, alone.friction.torque.total, rtol=1e-5
    )
    with pytest.raises(FembearingError):
        torque_of_scene(series_of(heavy, 2 * heavy), keep_going=True)
