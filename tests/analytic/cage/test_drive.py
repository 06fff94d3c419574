"""How balls drive a cage: on both sides of each limit, and what its part of a torque says."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.cage.drive import LARGEST_GRIP, CageDrive, cage_drive
from analytic.cage.steady import hanging_torque, sliding_torque
from analytic.cage.torque import CageMoves, CagePart, cage_friction
from analytic.errors import InputError
from analytic.numerics.elements import mapped
from analytic.numerics.records import Records
from analytic.scene import ContactAngle, Land, Operation, Scene
from tests.analytic.cage.specimens import CAGED, RPM, with_cage
from tests.analytic.specimens import FINISH, OIL, balls_of, present

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


def test_a_ball_without_grip_is_named_unless_its_ring_stands_still() -> None:
    friction = np.full((2, 3, 9), 7.0)
    friction[:, 1, 6] = friction[:, 2, 3] = 0
    friction[0, 0, 2] = 0  # the other race holds this one
    drive = driven_by(AROUND)
    grip = replace(drive.grip, friction=friction)
    with pytest.raises(InputError, match=r"ball 7 of 9 has a load of 0 N on both races at -740 rpm"):
        grip.require_grip(SPEEDS)
    friction[:, 1, 6] = 7.0
    grip.require_grip(SPEEDS)
    replace(grip, friction=None).require_grip(SPEEDS)


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


def test_balls_squeeze_no_harder_than_their_races_hold_them_where_that_is_known() -> None:
    drive, mu = led(0.203, -0.21, 0.1), np.full(3, 0.1)
    free = replace(drive, grip=replace(drive.grip, friction=None)).squeezing_force(mu)
    held = drive.squeezing_force(mu)
    assert np.all(held[:2] < free[:2])
    np.testing.assert_array_equal(held, np.minimum(free, present(drive.grip.carried(mu))))


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
    (warning,) = part.warnings
    assert "at -740 rpm balls lead on one side of the bearing and lag on the other by 0.21 mm" in warning
    assert "that of a rigid cage, +- 100 %" in warning
    assert part.provenance == (
        "closed form at rest, squeezed by balls that lead at 2 of 3 points, friction by friction.coefficient"
    )
    assert [row["state"] for row in part.rows] == ["squeezed", "squeezed", "rest"]


def test_the_grip_of_a_race_counts_loads_above_0_alone() -> None:
    unloaded = AROUND.copy()
    unloaded["load"][:, 4] = 0.0
    friction = present(driven_by(unloaded, np.where(np.arange(9) == 4, np.nan, 0.07)).grip.friction)
    np.testing.assert_allclose(friction, 0.07 * np.moveaxis(unloaded["load"], -1, 0), rtol=1e-12)


OILED = replace(CAGED, friction_coefficient=None, lubricant=OIL, surface=FINISH, contact_angle=SOLVED)
