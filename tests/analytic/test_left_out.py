"""Operating points without a torque keep their places in columns and in JSON."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.errors import FembearingError
from analytic.left_out import LeftOut, Places, torque_where_it_is
from analytic.scene import Operation, Scene
from analytic.scenefile.read import load_scene

LOST = LeftOut(point=1, inner_speed=30.0, axial_load=5e9, radial_load=2.0, moment=0.3, reason="too heavy")
PLACES = Places(size=4, left_out=(LOST,))


def test_columns_know_the_loads_of_every_point_and_nothing_else_of_a_lost_one() -> None:
    loads = {"axial_load": np.array([100.0, 300.0, 700.0]), "radial_load": np.zeros(3)}
    still = {"inner_speed": np.full(3, 20.0), "moment": np.zeros(3)}
    whole = PLACES.columns(loads | still | {"torque_total": np.array([3e-3, 5e-3, 8e-3])})
    assert whole["axial_load"].tolist() == [100.0, 5e9, 300.0, 700.0]
    assert whole["moment"].tolist() == [0.0, 0.3, 0.0, 0.0]
    assert whole["torque_total"].tolist() == pytest.approx([3e-3, np.nan, 5e-3, 8e-3], nan_ok=True)


def series_of(*loads: float) -> Scene:
    """A dry 6205 that pulls back at a thrust below 0: no torque there."""
    operation = Operation(axial_load=np.array(loads), inner_speed=np.arange(10.0, 10.0 + len(loads)))
    return replace(load_scene("6205-dry"), friction_coefficient=0.07, cage=None, operation=operation)


def test_every_point_that_has_a_torque_keeps_it_and_the_others_have_a_reason() -> None:
    heavy = 5e12
    scene, friction, left_out = torque_where_it_is(series_of(300.0, heavy, 500.0, 2 * heavy, 700.0))
    assert scene.operation.axial_load.tolist() == [300.0, 500.0, 700.0]
    assert [(each.point, each.axial_load, each.inner_speed) for each in left_out] == [
        (1, heavy, 11.0),
        (3, 2 * heavy, 13.0),
    ]
    assert all(each.reason for each in left_out)
    whole, alone, none = torque_where_it_is(series_of(300.0, 500.0, 700.0))
    assert none == ()
    assert whole.operation.axial_load.size == 3
    np.testing.assert_allclose(
        friction.torque.total, alone.torque.total, rtol=1e-5
    )  # each point starts from its neighbour
    with pytest.raises(FembearingError):
        torque_where_it_is(series_of(heavy, 2 * heavy))
