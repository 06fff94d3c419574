"""The cage in the torque of a bearing: its method and the reason, what it adds, and what the JSON says of it."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic import friction_torque
from analytic.cage.pocket import friction_in_pocket
from analytic.cage.steady import DrivenCage
from analytic.cage.torque import driven_cage
from analytic.errors import InputError
from analytic.scene import Bearing, Land, Scene
from fembearing.plain_types import plain
from tests.analytic.cage.specimens import CAGED, with_cage
from tests.analytic.specimens import FINISH, OIL, present


def test_the_closed_form_adds_the_torque_of_a_resting_cage() -> None:
    result = friction_torque(CAGED)
    # mu m g r w_b/w by hand: 0.0604 N mm; friction that leans out of the plane takes less than 2 % of it
    by_hand = 0.1 * 6.58e-3 * 9.80665 * 15.599e-3 * 23.411 / 39.01
    np.testing.assert_allclose(present(result.torque.cage), by_hand, rtol=0.02)
    np.testing.assert_allclose(result.torque.total, result.torque.race + present(result.torque.cage), rtol=1e-12)
    # The cage hangs off the vertical by the angle of friction.
    np.testing.assert_allclose(present(result.cage).mean_force, 6.58e-3 * 9.80665 * np.cos(np.arctan(0.1)), rtol=1e-9)
    assert present(result.cage).rows[1]["state"] == "rest"


def test_the_closed_form_includes_drag() -> None:
    """Against motions from rest, for a cage whose weight is small next to the drag and one whose weight is not."""
    for drag in (1e-3, 2e-6):
        scene_of = with_cage(replace(CAGED, tolerance=0.9), drag=drag, start="rest", duration=0.05)
        closed = friction_torque(replace(scene_of, effects={**CAGED.effects, "cage_dynamics": "off"})).cage
        moved = friction_torque(replace(scene_of, effects={**CAGED.effects, "cage_dynamics": "on"})).cage
        assert closed is not None
        assert moved is not None
        # The part of the weight, 0.0604 N mm and 0.0642 N, is less where the same forces carry and push. The cage
        # swings: 2 %.
        beyond = closed.torque - moved.torque
        assert np.all((-0.02 * moved.torque < beyond) & (beyond < 0.0604e-3 + 0.02 * moved.torque))
        pressed = closed.mean_force - moved.mean_force
        assert np.all((-0.02 * moved.mean_force < pressed) & (pressed < 0.0642 + 0.02 * moved.mean_force))
        np.testing.assert_allclose(closed.signed_moment, moved.signed_moment, rtol=0.02)
        assert closed.rows[1]["signed_moment"] == closed.signed_moment[1]
        back = replace(scene_of.operation, inner_speed=-CAGED.operation.inner_speed)
        mirrored = friction_torque(
            replace(scene_of, operation=back, effects={**CAGED.effects, "cage_dynamics": "off"})
        ).cage
        np.testing.assert_allclose(present(mirrored).signed_moment, -closed.signed_moment, rtol=1e-12)


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_the_motion_is_that_of_the_scene(ring: Any) -> None:
    """Every key of the cage reaches the motion. The land is where the circle of the groove reaches the shoulder."""
    change: dict[str, Any] = {"restitution": 0.37, "drag": 3e-6, "pocket_stiffness": 7.7e9, "sheet_stiffness": 1.3e8}
    change |= {"pocket_axis": "radial", "gravity": "along", "pocket_depth": 4.05e-3}
    driven = driven_with(CAGED.bearing, with_cage(CAGED, land=Land(ring=ring, clearance=0.3e-3, width=9e-3), **change))
    assert (driven.restitution, driven.drag, driven.pocket_axis) == (0.37, 3e-6, "radial")
    assert (driven.stiffness, driven.sheet_softness, driven.gravity) == (7.7e9, 1 / 1.3e8, (0.0, 0.0, -9.80665))
    np.testing.assert_allclose([driven.ball_radius, driven.pitch_radius], [3.97e-3, 19.505e-3], rtol=1e-12)
    np.testing.assert_allclose([driven.half_clearance, driven.centre_offset], [0.1e-3, 0.02e-3], rtol=1e-9)
    land, bearing = present(driven.land), CAGED.bearing
    groove = bearing.inner if ring == "inner" else bearing.outer
    assert (land.outside, land.speed) == (ring == "outer", -41.0 if ring == "inner" else 0.0)
    np.testing.assert_allclose([land.half_clearance, land.half_width], [0.15e-3, 4.5e-3], rtol=1e-12)
    # The shoulder is on the groove's circle, towards the balls.
    towards = 1 if ring == "inner" else -1
    middle = groove.bottom_radius + towards * groove.groove_radius
    half_width = present(groove.shoulder_half_width)
    np.testing.assert_allclose(np.hypot(land.radius - middle, half_width), groove.groove_radius, rtol=1e-12)
    assert 0 < towards * (land.radius - groove.bottom_radius) < groove.groove_radius


def driven_with(bearing: Bearing, scene: Scene) -> DrivenCage:
    speeds = {"inner_speed": -41.0, "orbit_speed": -16.0, "ball_speed": -95.0}
    return driven_cage(bearing, present(scene.cage), friction_coefficient=0.13, contact_angle=0.21, **speeds)


def test_a_land_needs_the_height_of_its_shoulder() -> None:
    """The higher shoulder guides; an unknown one is asked for."""
    scene = with_cage(CAGED, start="rest", land=Land(ring="outer", clearance=0.3e-3, width=9e-3))

    def radius(near: float | None, far: float | None) -> float:
        outer = replace(scene.bearing.outer, shoulder_half_width=near, far_shoulder_half_width=far)
        return present(driven_with(replace(scene.bearing, outer=outer), scene).land).radius

    assert radius(3.3e-3, 1.2e-3) == radius(1.2e-3, 3.3e-3) == radius(3.3e-3, None) < radius(1.2e-3, None)
    with pytest.raises(InputError, match=r"bearing\.outer\.shoulder_height, usual are 0\.15 to 0\.25"):
        radius(None, None)


def test_a_start_calls_for_the_motion() -> None:
    result = friction_torque(with_cage(CAGED, start="whirl"))
    cage, torque = present(result.cage), present(result.torque.cage)
    slow, fast = cage.motion[0], present(cage.motion[1])
    assert slow is None  # below a whirl number of 1
    assert fast.state == "whirl"
    assert torque[1] == fast.torque
    np.testing.assert_allclose(cage.half_interval, [0.0, np.diff(fast.torque_interval)[0] / 2])
    assert np.all(result.numerical_uncertainty >= cage.half_interval / result.torque.total)
    point = plain(cage.rows[1])
    assert point["interval"] == {"torque": list(fast.torque_interval), "max_force": list(fast.max_force_interval)}
    np.testing.assert_allclose(point["mean_force"], 15.95, rtol=0.02)  # m (w_b r/nabla + w_c)^2 nabla by hand
    assert any('"whirl" leads to whirl' in warning for warning in result.warnings)
    back = replace(CAGED.operation, inner_speed=-CAGED.operation.inner_speed)
    mirrored = friction_torque(with_cage(replace(CAGED, operation=back), start="whirl"))
    # The disturbance is not mirrored, as with other seeds. The slow cage is not steady after so short a time.
    np.testing.assert_allclose(present(mirrored.torque.cage)[1], torque[1], rtol=0.03)


@pytest.mark.parametrize(("gravity", "part"), [("along", 0.179), ("off", 0.0)])
def test_the_closed_form_follows_gravity(gravity: Any, part: float) -> None:
    """Along the axis the ball surfaces slide with the share sin(0.18) = 0.179; without gravity nothing is pressed."""
    ruled = replace(CAGED, spin_rule="balanced")  # the speed by hand is that of closed kinematics
    result = present(friction_torque(with_cage(ruled, gravity=gravity)).torque.cage)
    np.testing.assert_allclose(result, part * 0.0604e-3, rtol=2e-3)


def test_the_friction_of_a_resting_cage_is_that_of_its_share_of_the_weight() -> None:
    oiled = replace(CAGED, friction_coefficient=None, lubricant=OIL, surface=FINISH)
    still = friction_in_pocket(oiled, load=0.5, surface_speed=0.0)
    np.testing.assert_allclose(still.coefficient, 0.11, rtol=1e-6)  # asperities carry all
    resting = friction_torque(replace(oiled, spin_rule="balanced"))
    # By closed kinematics, by hand: w R_i R_o/(d_m cos(al - B)) with the pitch of outer control, B = 0.14965 rad
    one = friction_in_pocket(oiled, load=6.58e-3 * 9.80665 / 9, surface_speed=0.49039 * np.array([0.04, 1.0]))
    # Tolerance: the digits of the speed
    np.testing.assert_allclose(present(resting.friction_coefficient.pocket), one.coefficient, rtol=1e-4)
    assert "thicker than their clearance" in one.warnings[0]
