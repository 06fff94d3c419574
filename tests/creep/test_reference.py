"""Value and uncertainty of a ball's friction from three grids."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.errors import ConvergenceError, InputError
from fembearing.creep import reference
from fembearing.creep.ball import Grid, TurningBall
from fembearing.creep.reference import GRIDS, creep_reference, estimate
from fembearing.creep.rolling import Creepages
from tests.creep.test_ball import thrust_ball


def test_a_sequence_of_second_order_has_its_limit_inside_and_half_of_the_error_left() -> None:
    sizes = 1 / 8, 1 / 12, 1 / 16
    first, middle, fine = (7.3 + 0.9 * size**2 for size in sizes)
    found = estimate((first, middle, fine), sizes)
    np.testing.assert_allclose(found.value - 7.3, 0.9 / 16**2 / 2, rtol=1e-9)  # round-off of 7.3
    np.testing.assert_allclose(found.uncertainty, 3 * 0.9 / 16**2 + 1e-4 * fine, rtol=1e-9)
    assert found.order == pytest.approx(2, rel=1e-9)


def test_two_grids_that_agree_by_chance_do_not_hide_the_change_before() -> None:
    found = estimate((7.1, 7.3, 7.3), (1 / 8, 1 / 12, 1 / 16))
    assert found.value == 7.3
    assert found.uncertainty > 0.1


def test_grids_become_finer_until_the_torque_is_certain() -> None:
    ball = thrust_ball(0.08, 250.0)
    rough, fine = creep_reference(ball, tolerance=0.05), creep_reference(ball, tolerance=1e-6)
    assert rough.grids == GRIDS[:3]
    assert fine.grids == GRIDS[-3:]  # the last grid ends it in any case
    assert rough.torque.uncertainty <= 0.05 * rough.torque.value
    truth = fine.finest  # two levels finer than the rough one
    assert abs(rough.torque.value - truth.torque) <= rough.torque.uncertainty
    assert abs(rough.inner.spin_moment.value - truth.races[0].spin_moment) <= rough.inner.spin_moment.uncertainty


def test_a_tolerance_of_nothing_is_refused() -> None:
    with pytest.raises(InputError, match="tolerance must be positive"):
        creep_reference(thrust_ball(0.08, 250.0), tolerance=0.0)


def scripted(monkeypatch: pytest.MonkeyPatch, *, without: tuple[Grid, ...] = ()) -> list[tuple[Grid, Any]]:
    """The torque of each ball is 2 N m and errs by 3/strips^2. Returns the grids and starts in use; some grids fail."""
    asked: list[tuple[Grid, Any]] = []

    def turn(_: TurningBall, grid: Grid, start: Any) -> Any:
        asked.append((grid, start))
        if grid in without:
            raise ConvergenceError(iterations=3, residual=0.1, tolerance=0.01)
        torque, friction = 2 + 3 / grid.strips**2, SimpleNamespace(creepages=Creepages(0.1, 0.2, 0.3), slip_share=0.7)
        race = SimpleNamespace(
            friction=friction, spin_moment=torque, rolling_moment=0.0, transverse_force=1.0, torque=torque / 2
        )
        return SimpleNamespace(torque=torque, races=(race, race), grid=grid)

    monkeypatch.setattr(reference, "turn_ball", turn)
    return asked


BALL: Any = None


def test_a_grid_on_which_the_ball_does_not_settle_is_left_out_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked = scripted(monkeypatch, without=(GRIDS[1],))
    found = creep_reference(BALL, tolerance=0.9)
    assert found.grids == (GRIDS[0], *GRIDS[2:4])
    assert [start and start.grid for _, start in asked] == [None, GRIDS[0], GRIDS[0], GRIDS[2]]
    scripted(monkeypatch, without=(GRIDS[1], GRIDS[3]))
    with pytest.raises(ConvergenceError):
        creep_reference(BALL, tolerance=1e-9)
    scripted(monkeypatch, without=(GRIDS[0],))
    assert creep_reference(BALL, tolerance=0.9).grids == GRIDS[1:4]
