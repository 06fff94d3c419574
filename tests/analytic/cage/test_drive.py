"""How balls drive a cage: on both sides of each limit, and what its part of a torque says."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.cage.drive import LARGEST_GRIP, CageDrive, cage_drive
from analytic.cage.steady import hanging_torque, sliding_torque
from analytic.cage.torque import CageMoves, CagePart, cage_friction
from analytic.numerics.elements import mapped
from analytic.numerics.records import Records
from analytic.scene import ContactAngle, Land, Operation, Scene
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import balls_of, present

SPEEDS = np.array([500.0, -740.0, 0.0]) * RPM
SOLVED = ContactAngle(rule="solved", free=0.18)


def scene_under(radial: list[float]) -> Scene:
    """At SPEEDS; without radial load balls are alike."""
    thrust = np.array([1000.0, 800.0, 900.0])
    operation = Operation(axial_load=thrust, inner_speed=SPEEDS, radial_load=np.array(radial))
    return replace(CAGED, contact_angle=SOLVED, operation=operation)


SCENES = scene_under([0.0, 0.0, 0.0]), scene_under([500.0, 330.0, 140.0])
ALIKE, AROUND = (balls_of(scene) for scene in SCENES)


def driven_by(balls: Records, friction: Any = 0.1, **cage: Any) -> CageDrive:
    return cage_drive(with_cage(CAGED, **cage), balls, friction, SPEEDS)


def led(*lead: float) -> CageDrive:
    """In 0.2 mm of clearance; lead : mm."""
    drive = driven_by(ALIKE)
    return replace(drive, grip=replace(drive.grip, ball_lead=1e-3 * np.array(lead)))


@pytest.mark.parametrize(("scene", "balls"), [(SCENES[0], ALIKE), (SCENES[1], AROUND)])
def test_free_balls_get_the_friction_of_their_load_and_the_loads_of_their_point(scene: Scene, balls: Records) -> None:
    load = np.moveaxis(balls["load"], -1, 0)
    mu = np.random.default_rng(3).uniform(0.05, 0.15, load.shape)
    races = driven_by(balls, mu).races(scene, 1)
    pulled = np.sum((mu * load)[:, 1], axis=-1)
    np.testing.assert_allclose(races.friction, pulled / load[:, 1].sum(axis=-1), rtol=1e-12)
    assert races.inner_speed == SPEEDS[1]
    each = races.contacts.load.shape[1] // load.shape[2]
    np.testing.assert_allclose(races.contacts.load[:, ::each], load[:, 1], rtol=1e-9)


def test_balls_slide_from_the_largest_grip_number_on() -> None:
    mu = np.full(3, 0.1)
    number = driven_by(ALIKE).grip_number(mu)
    # The number goes with 1/mu of the races.
    for share in (0.999, 1.001):
        grip = driven_by(ALIKE, 0.1 * np.reshape(number, (3, 1)) / (share * LARGEST_GRIP))
        sliding = grip.slides(mu)
        np.testing.assert_array_equal(sliding[:2], share > 1)


def test_a_cage_is_squeezed_where_the_lead_reaches_its_room() -> None:
    assert led(0.1999, -0.2001, -0.1999).is_squeezed.tolist() == [False, True, False]
    drive = driven_by(ALIKE, land=Land(ring="outer", clearance=0.03e-3, width=9e-3))
    np.testing.assert_allclose(drive.room, 0.115e-3, rtol=1e-9)


def part_of(drive: CageDrive) -> CagePart:
    return cage_friction(CAGED, drive, CageMoves(given=np.zeros(3, bool), freely=np.zeros(3, bool), reasons={}))


def test_a_squeezed_cage_also_carries_its_weight() -> None:
    drive = led(0.203, -0.21, 0.1)
    part, mu = part_of(drive), np.full(3, 0.1)
    surfaces = 3.97e-3 * drive.ball_rate
    rest = mapped(hanging_torque, 0.1, 6.58e-3 * 9.80665, surfaces, drive.contact_angle)
    force = 9 * drive.squeezing_force(mu)[:, 0]
    squeezed = sliding_torque(friction_coefficient=0.1, force=force, ball_rate=drive.ball_rate, ball_radius=3.97e-3)
    np.testing.assert_allclose(part.torque, rest + squeezed, rtol=1e-9)
    np.testing.assert_allclose(part.mean_force, 6.58e-3 * 9.80665 / np.hypot(1, 0.1) + force, rtol=1e-9)
    carried = present(drive.grip.carried(mu))[:, 0]
    np.testing.assert_allclose(part.grip_share, part.mean_force / (9 * carried), rtol=1e-12)
    assert "at -740 rpm balls lead on one side of the bearing and lag on the other by 0.21 mm" in part.warnings[0]
    assert [part.rows[point]["state"] for point in range(3)] == ["squeezed", "squeezed", "rest"]


def test_the_grip_of_a_race_counts_loads_above_0_alone() -> None:
    unloaded = AROUND.copy()
    unloaded["load"][:, 4] = 0.0
    friction = present(driven_by(unloaded, np.where(np.arange(9) == 4, np.nan, 0.07)).grip.friction)
    np.testing.assert_allclose(friction, 0.07 * np.moveaxis(unloaded["load"], -1, 0), rtol=1e-12)
