"""The cage in motion, against closed forms, a library's solver of the same equations, and what must be conserved."""

import subprocess
import sys
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from analytic.cage import DrivenCage, LandGuidance, rest_torque, whirl_force, whirl_speed, whirl_torque
from analytic.cage_motion import CageMotion, MotionError
from analytic.errors import InputError
from analytic.pocket import friction_force, impact, normal_force, penetration

W = 52.36  # rad/s: 500 rpm
RATE = 15.599 * 23.411 / (39.01 * 3.97)  # w_b/w of a 6205 at 0.18 rad
CAGE = DrivenCage(
    mass=6.58e-3,
    ball_count=9,
    ball_radius=3.97e-3,
    pitch_radius=19.505e-3,
    room=0.1e-3,
    stiffness=6.0e10,
    restitution=0.8,
    friction_coefficient=0.1,
    orbit_speed=W * 15.599 / 39.01,
    ball_speed=W * RATE,
    contact_angle=0.18,
    ring_speed=W,
)
NOWHERE = (0.0, 0.0, 0.0)
TABLE_1: dict[str, Any] = {"room": 2.98e-3, "centre_offset": 0.14e-3}  # the paper's pocket


def ball_forces(cage: DrivenCage, time: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(Z, 2, 3) forces of both shells, without losses, and where they act, by the formulas of the pocket in its frame.

    y : place, velocity, quaternion with the scalar last, angular velocity in the cage's own frame
    """
    phi = 2 * np.pi * np.arange(cage.ball_count) / cage.ball_count
    home, theta = np.stack([np.cos(phi), np.sin(phi), 0 * phi], axis=1), phi + cage.orbit_speed * time
    theta = theta + cage.ball_lead / cage.pitch_radius * np.sin(theta)
    out = np.stack([np.cos(theta), np.sin(theta), 0 * phi], axis=1)
    rate = cage.orbit_speed * (1 + cage.ball_lead / cage.pitch_radius * np.cos(phi + cage.orbit_speed * time))
    centre, turn = cage.pitch_radius * out, Rotation.from_quat(y[6:10]).as_matrix()
    up = np.array([0, 0, 1.0])
    spin = cage.ball_speed * (np.sin(cage.contact_angle) * out - np.cos(cage.contact_angle) * up)
    spin = (spin + rate[:, None] * up)[:, None]
    along = np.cross(up, home)
    first = np.broadcast_to(up, home.shape) if cage.pocket_axis == "axial" else home
    frames = turn @ np.stack([first, along, np.cross(first, along)], axis=2)  # columns: the pocket's axes
    offset = np.einsum("ijk,ij->ik", frames, centre - y[:3] - cage.pitch_radius * home @ turn.T)
    depths, normals = penetration(offset, room=cage.room, centre_offset=cage.centre_offset)
    normals = np.einsum("ijk,isk->isj", frames, normals)
    arms = centre[:, None] + cage.ball_radius * normals - y[:3]
    surface = np.cross(rate[:, None] * up, centre)[:, None] + cage.ball_radius * np.cross(spin, normals)
    past = surface - y[3:6] - np.cross(turn @ y[10:13], arms)
    closing = np.sum(past * normals, axis=-1)
    pressed = normal_force(depths, rate=closing, impact_speed=2.0, stiffness=cage.stiffness, damping=0.0)
    rubbed = friction_force(
        pressed,
        past - closing[..., None] * normals,
        friction_coefficient=cage.friction_coefficient,
        smoothing=cage.smoothing,
    )
    return pressed[..., None] * normals + rubbed, arms


def by_library(cage: DrivenCage, start: CageMotion, duration: float) -> np.ndarray:
    """Newton's and Euler's equations by LSODA."""
    axial, transverse = cage.inertia
    inertia = np.array([transverse, transverse, axial])

    def rhs(time: float, y: np.ndarray) -> np.ndarray:
        forces, arms = ball_forces(cage, time, y)
        turn, w = Rotation.from_quat(y[6:10]), y[10:13]
        moment = turn.inv().apply(np.cross(arms, forces).sum(axis=(0, 1)))
        a, b, c, d = y[9], *y[6:9]
        spun = 0.5 * np.array(
            [a * w[0] + c * w[2] - d * w[1], a * w[1] + d * w[0] - b * w[2], a * w[2] + b * w[1] - c * w[0],
             -b * w[0] - c * w[1] - d * w[2]]
        )  # fmt: skip
        pull = np.array(cage.gravity) + forces.sum(axis=(0, 1)) / cage.mass
        return np.concatenate([y[3:6], pull, spun, (moment - np.cross(w, inertia * w)) / inertia])

    turn = Rotation.from_matrix(start.orientation)
    y = np.concatenate([start.centre, start.velocity, turn.as_quat(), turn.inv().apply(start.angular_velocity)])
    found = solve_ivp(rhs, (0, duration), y, method="LSODA", rtol=1e-9, atol=1e-13, max_step=cage.contact_time / 4)
    return found.y[:, -1]


def thrown(cage: DrivenCage, **kwargs: Any) -> CageMotion:
    """Towards the balls, with all six freedoms under way."""
    motion = CageMotion(cage, begin="sudden", **kwargs)
    motion.launch(velocity=np.array([0.31, -0.22, 0.17]), angular_velocity=np.array([6.0, -9.0, 14.0]))
    return motion


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"centre_offset": 0.03e-3},
        {"centre_offset": 0.03e-3, "pocket_axis": "radial"},
        {"ball_lead": 0.06e-3, "ball_speed": -W * RATE, "orbit_speed": -31.0},
    ],
)
def test_motion_is_that_of_a_library_solver(change: dict[str, Any]) -> None:
    """Without impact losses, whose memory of each impact no library's solver has. Some impacts, then they part."""
    cage = replace(CAGE, restitution=1.0, **change)
    duration, errors = 0.6e-3, []
    exact = by_library(cage, thrown(cage), duration)
    for steps in (40, 80):
        motion = thrown(cage, steps_per_contact=steps)
        motion.step = duration / round(duration / motion.step)
        passed = motion.advance(duration)
        assert passed.max_force > 10  # there were impacts
        errors.append(np.abs(motion.velocity - exact[3:6]).max() / np.linalg.norm(exact[3:6]))
        turned = Rotation.from_matrix(motion.orientation).inv().apply(motion.angular_velocity)
        np.testing.assert_allclose(turned, exact[10:13], rtol=0, atol=0.01 * np.abs(exact[10:13]).max())
    assert errors[0] < 5e-3  # the default step over some impacts, each of which enlarges what differs before it
    assert errors[1] < 0.4 * errors[0]  # second order, or a little less where friction turns


@pytest.mark.parametrize("pocket", [TABLE_1, {"room": 0.1e-3, "centre_offset": 0.4e-6}])
def test_forces_now_are_those_of_the_formulas(pocket: dict[str, Any]) -> None:
    """Both shells of some balls at once, in a turned cage; and of one where the far side of both is within reach."""
    cage = replace(CAGE, restitution=1.0, **pocket)
    motion = thrown(cage)
    deepest = 0.0
    while deepest < 1.0:
        motion.advance(2e-5)
        deepest = np.abs(motion.forces()).max()
    turn = Rotation.from_matrix(motion.orientation)
    y = np.concatenate([motion.centre, motion.velocity, turn.as_quat(), turn.inv().apply(motion.angular_velocity)])
    expected, _ = ball_forces(cage, motion.time, y)
    np.testing.assert_allclose(
        motion.forces(), expected.sum(axis=1), atol=1e-6 * deepest
    )  # depths of um from places of cm


def test_energy_of_a_cage_without_losses_stays_over_fifty_bounces() -> None:
    """Balls that stand still; the drift is told where the cage flies freely."""
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=1.0, gravity=NOWHERE, orbit_speed=0.0, ball_speed=0.4 / 3.97e-3
    )
    motion = thrown(cage)
    energy, bounces, touching, drift = motion.kinetic_energy, 0, False, []
    while bounces < 50:
        motion.advance(cage.contact_time / 4)
        before, touching = touching, bool(motion.forces().any())
        bounces += touching and not before
        if not touching:
            drift.append(motion.kinetic_energy / energy - 1)
    assert np.abs(drift).max() < 1e-3


def test_energy_is_accounted_for() -> None:
    """What balls and gravity give is what the cage has, and what friction, impacts, drag and land took."""
    land = LandGuidance(radius=17e-3, room=0.08e-3, outside=False, speed=0.0, half_width=5e-3)
    cage = replace(CAGE, drag=3e-6, land=land, gravity=NOWHERE, ball_lead=0.03e-3)
    motion = thrown(cage)
    before = motion.kinetic_energy
    passed = motion.advance(0.02)
    while motion.forces().any():  # no energy in springs, but for the land's, of which some 1e-5 may be left
        pytest.fail("choose a time at which nothing touches")
    lost = passed.slip_power + passed.land_power + passed.damping_power + passed.drag_power
    given = passed.ball_power * passed.duration
    gained = motion.kinetic_energy - before
    assert min(passed.slip_power, passed.land_power, passed.damping_power, passed.drag_power) > 0
    np.testing.assert_allclose(gained, given - lost * passed.duration, atol=5e-3 * given)  # the step's error


def test_balls_and_cage_at_one_speed_never_touch_without_gravity() -> None:
    motion = CageMotion(replace(CAGE, gravity=NOWHERE), begin="rest")
    passed = motion.advance(0.05)
    assert passed.max_force == 0
    assert passed.slip_power == 0
    np.testing.assert_allclose(motion.centre, 0, atol=1e-15)


@pytest.mark.parametrize("begin", ["rest", "ramp"])
def test_a_cage_that_rests_slides_with_its_weight(begin: Any) -> None:
    motion = CageMotion(CAGE, begin=begin, ramp=0.2, seed=5)  # so slow that gravity prevails
    motion.advance(0.2)
    passed = motion.advance(0.1)
    closed = rest_torque(
        friction_coefficient=0.1, cage_mass=CAGE.mass, ball_rate=RATE, ball_radius=3.97e-3, contact_angle=0.18
    )
    np.testing.assert_allclose(passed.slip_power / W, closed, rtol=0.02)  # it swings a little, undamped
    np.testing.assert_allclose(passed.force, CAGE.mass * 9.80665 / np.hypot(1, 0.1), rtol=0.02)
    assert abs(passed.moment) < 1e-3 * passed.slip_power / W  # the signed moment averages to nothing


@pytest.mark.parametrize("sign", [1, -1])
def test_rest_begins_where_friction_and_weight_balance(sign: int) -> None:
    """Off the vertical by atan(mu), against the drive; begun elsewhere it would swing by as much."""
    cage = replace(CAGE, orbit_speed=sign * CAGE.orbit_speed, ball_speed=sign * CAGE.ball_speed)
    motion = CageMotion(cage, begin="rest")
    x, y, _ = motion.centre
    np.testing.assert_allclose(x / -y, sign * 0.1, rtol=1e-9)
    motion.advance(0.005)
    assert motion.advance(0.02).unrest < 0.01 * cage.room


@pytest.mark.parametrize("locked", [True, False])
def test_a_cage_that_whirls_rolls_in_its_pockets(locked: bool) -> None:
    cage = replace(CAGE, transverse_inertia=0.7) if locked else CAGE
    motion = CageMotion(cage, begin="whirl", seed=5)
    motion.advance(0.05)
    passed = motion.advance(0.05)
    leaning = 0.18 if locked else 0.0
    whirl = whirl_speed(ball_speed=cage.ball_speed, ball_radius=3.97e-3, contact_angle=leaning, room=cage.room)
    force = whirl_force(cage_mass=cage.mass, whirl=whirl, orbit_speed=cage.orbit_speed, room=cage.room)
    np.testing.assert_allclose(passed.circling, whirl + cage.orbit_speed, rtol=0.02)
    np.testing.assert_allclose(passed.force, force, rtol=0.02)
    torque = whirl_torque(
        friction_coefficient=0.1, force=force, ball_rate=RATE, ball_radius=3.97e-3, contact_angle=0.18
    )
    if locked:
        np.testing.assert_allclose(passed.slip_power / W, torque, rtol=0.02)
    else:
        assert passed.slip_power / W < 0.3 * torque


def test_impact_force_is_the_closed_form() -> None:
    """A cage thrown straight at its balls hits all of them at once; frictionless, at two speeds."""
    cage = replace(CAGE, friction_coefficient=0.0, restitution=1.0, gravity=NOWHERE, orbit_speed=0.0)
    forces = []
    for speed in (0.11, 0.43):
        motion = CageMotion(cage, begin="sudden")
        motion.launch(velocity=np.array([0.6 * speed, 0.8 * speed, 0.0]), angular_velocity=np.zeros(3))
        largest = motion.advance(1.9 * cage.room / speed).max_force
        exact = impact(mass=cage.mass / 9, speed=speed, stiffness=cage.stiffness)
        np.testing.assert_allclose(largest, exact.force, rtol=3e-3)  # the largest of 40 points
        forces.append(largest)
    np.testing.assert_allclose(np.log(forces[1] / forces[0]) / np.log(43 / 11), 1.2, atol=3e-3)


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_a_bounce_keeps_the_restitution(restitution: float) -> None:
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=restitution, gravity=NOWHERE, orbit_speed=0.0, ball_speed=100.0
    )
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array([0.0, 0.0, 0.37]), angular_velocity=np.zeros(3))
    motion.advance(1.9 * cage.room / 0.37)
    np.testing.assert_allclose(motion.velocity[2], -0.37 * restitution, rtol=5e-3)  # the step's error


@pytest.mark.parametrize("restitution", [0.3, 0.8])
def test_a_blow_on_what_touches_already_keeps_the_restitution(restitution: float) -> None:
    """A cage that lies on its balls is hit: the damping is by the blow, not by how gently the contact once began."""
    cage = replace(
        CAGE, friction_coefficient=0.0, restitution=restitution, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0
    )
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-4)
    assert motion.forces().any()
    motion.launch(velocity=np.array([0.0, 0.0, -0.37]), angular_velocity=np.zeros(3))
    hit = motion.advance(1.5 * cage.contact_time)
    np.testing.assert_allclose(motion.velocity[2], 0.37 * restitution, rtol=0.01)  # the step's error, and its weight
    elastic = impact(mass=cage.mass / 9, speed=0.37, stiffness=cage.stiffness)
    assert hit.max_force < 1.1 * elastic.force  # a blow that is damped has about the same force


def test_torque_does_not_depend_on_how_friction_is_smoothed() -> None:
    found = []
    for smoothing in (0.25e-3, 0.5e-3, 1e-3):  # more is cut off at a share of the balls' speed
        motion = CageMotion(replace(CAGE, smoothing=smoothing), begin="whirl")
        motion.advance(0.03)
        found.append(motion.advance(0.03).slip_power)
    assert np.ptp(found) < 5e-3 * found[1]


def test_running_backwards_is_the_mirror_image() -> None:
    """y turns round, and with it the bearing; gravity is along x, where the first ball is."""
    cage = replace(CAGE, gravity=(-9.80665, 0.0, 0.0))
    found = []
    for sign in (1, -1):
        motion = CageMotion(
            replace(cage, orbit_speed=sign * cage.orbit_speed, ball_speed=sign * cage.ball_speed), begin="sudden"
        )
        motion.launch(velocity=np.array([0.11, sign * 0.2, 0.05]), angular_velocity=np.array([sign * 3.0, 4.0, 0.0]))
        found.append((motion.advance(2e-3), motion.centre * [1, sign, 1]))
    (ahead, there), (back, mirrored) = found
    assert ahead.max_force > 1
    np.testing.assert_allclose(mirrored, there, atol=1e-6 * cage.room)  # round-off grows from impact to impact
    np.testing.assert_allclose([back.slip_power, -back.moment], [ahead.slip_power, ahead.moment], rtol=1e-6)


@pytest.mark.parametrize("duration", [float("nan"), float("inf"), -0.1, 0.0])
def test_no_motion_without_end_or_backwards(duration: float) -> None:
    with pytest.raises(InputError, match="duration must be positive and finite"):
        CageMotion(CAGE, begin="rest").advance(duration)


def test_a_contact_that_opens_fast_does_not_pull() -> None:
    """Balls that run away from a cage that lies on them, much faster than the blow that the damping is for."""
    cage = replace(CAGE, friction_coefficient=0.0, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-4)
    assert motion.forces().any()
    motion.launch(velocity=np.array([0.0, 0.0, 0.4]), angular_velocity=np.zeros(3))
    opened = motion.advance(motion.step)
    assert opened.force == 0
    assert motion.velocity[2] > 0.3999


def test_friction_fades_as_the_pocket_formula_does() -> None:
    """Forces of a cage that slides past its balls at about v0, where none of them is out of the curve of tanh."""
    cage = replace(CAGE, restitution=1.0, gravity=(0.0, 0.0, -9.80665), orbit_speed=0.0, ball_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    for sliding in (0.3e-3, 0.8e-3, 2.9e-3):
        motion.launch(velocity=np.array([0.6 * sliding, 0.8 * sliding, 0.0]), angular_velocity=np.zeros(3))
        turn = Rotation.from_matrix(motion.orientation)
        y = np.concatenate([motion.centre, motion.velocity, turn.as_quat(), turn.inv().apply(motion.angular_velocity)])
        expected, _ = ball_forces(cage, motion.time, y)
        np.testing.assert_allclose(motion.forces(), expected.sum(axis=1), atol=1e-6 * np.abs(expected).max())


@pytest.mark.parametrize("axis", ["axial", "radial"])
@pytest.mark.parametrize("begin", ["rest", "whirl"])
def test_a_motion_begins_where_the_first_ball_touches(axis: Any, begin: Any) -> None:
    """Of two half-shells with leading balls, by the formulas of the pocket: just short of a contact, or in one."""
    cage = replace(CAGE, centre_offset=0.03e-3, pocket_axis=axis, ball_lead=0.06e-3, friction_coefficient=0.0)
    motion = CageMotion(cage, begin=begin)
    still = np.array([0.0, 0.0, 0.0, 1.0])
    at, middle = motion.centre, np.array([-0.03e-3, 0.0, 0.0])

    def pressed(share: float) -> np.ndarray:
        y = np.concatenate([middle + share * (at - middle), np.zeros(3), still, np.zeros(3)])
        return ball_forces(cage, 0.0, y)[0]

    assert not pressed(0.98).any()  # with the sag taken off
    assert pressed(1.02).any()
    if begin == "whirl":
        distance = at[0] - middle[0]
        rolling = cage.ball_speed * cage.ball_radius * np.cos(0.18) + cage.orbit_speed * distance
        np.testing.assert_allclose(motion.velocity, [0, rolling, 0], rtol=1e-12, atol=1e-15)


def test_a_land_that_starts_with_the_ring_turns_no_faster() -> None:
    """Ramped over half a second, a land at 1 ms has hardly left its standstill."""
    land = LandGuidance(radius=17e-3, room=0.05e-3, outside=False, speed=2.0, half_width=5e-3)
    found = []
    for ramp in (0.5, 1e-4):
        cage = replace(CAGE, land=land, room=1e-3, orbit_speed=0.0, ball_speed=0.0)
        motion = CageMotion(cage, begin="ramp", ramp=ramp)
        found.append(motion.advance(1e-3).land_power)
    assert found[0] < 0.02 * found[1]  # it has come to 2 per mille of 34 mm/s by then


def test_one_ball_and_a_still_bearing() -> None:
    passed = CageMotion(replace(CAGE, ball_count=1), begin="sudden", seed=3).advance(0.01)
    assert np.isfinite(passed.slip_power)
    still = replace(CAGE, ball_speed=0.0, orbit_speed=0.0, ring_speed=0.0, gravity=NOWHERE)
    assert CageMotion(still, begin="whirl").advance(0.01).max_force == 0


def test_the_same_seed_gives_the_same_numbers() -> None:
    found = [CageMotion(CAGE, begin="sudden", seed=seed).advance(2e-3) for seed in (3, 3, 4)]
    assert found[0] == found[1]
    assert found[0] != found[2]


def test_both_shells_hold_a_ball_between_them() -> None:
    """Table 1's pocket: a cage that hangs in it touches each ball with both shells, across the axis."""
    cage = replace(CAGE, **TABLE_1)
    motion = CageMotion(cage, begin="rest")
    hanging = np.sqrt(2.98**2 - 0.14**2) * 1e-3
    np.testing.assert_allclose(np.linalg.norm(motion.centre), hanging, rtol=1e-4)  # the sag under its weight
    assert motion.forces().any()


def test_land_guides_the_cage_before_its_pockets_do() -> None:
    land = LandGuidance(radius=17e-3, room=0.05e-3, outside=False, speed=W, half_width=5e-3)
    motion = CageMotion(replace(CAGE, land=land), begin="rest", seed=2)
    motion.advance(0.05)
    passed = motion.advance(0.05)
    assert passed.land_power > 0
    assert passed.distance < 0.06e-3


def test_a_motion_that_comes_apart_says_when_and_how() -> None:
    motion = CageMotion(CAGE, begin="sudden", steps_per_contact=0.02)
    with pytest.raises(
        MotionError, match=r"came apart at .* s: centre at .* m, speed .* m/s, with a step of .* s\. Raise cage\.steps"
    ):
        motion.advance(1.0)


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({"begin": "sideways"}, 'start must be "rest", "ramp", "sudden" or "whirl"'),
        ({"begin": "ramp"}, "needs the time"),
        ({"begin": "rest", "steps_per_contact": 0.0}, "steps_per_contact must be positive"),
    ],
)
def test_what_cannot_be_is_refused(options: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError, match=words):
        CageMotion(CAGE, **options)


def test_a_read_only_installation_without_a_home_compiles_each_time() -> None:
    show = """
import numba.core.caching
def refuse(*_): raise OSError(30, "Read-only file system")
for locator in [*numba.core.caching._CacheLocator.__subclasses__(), numba.core.caching._CacheLocator]:
    locator.ensure_cache_path = refuse
import analytic.cage_kernel
print(type(analytic.cage_kernel.advance).__name__)
"""
    assert subprocess.run([sys.executable, "-c", show], capture_output=True, check=True, text=True).stdout != ""


def test_no_compiler_is_loaded_before_the_first_motion() -> None:
    show = "import sys, analytic, analytic.torque, analytic.cage_motion; print('numba' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", show], capture_output=True, check=True, text=True).stdout == "False\n"


@pytest.mark.parametrize(("outside", "speed"), [(False, 50.0), (True, -40.0)])
def test_a_turning_land_takes_the_cage_along(outside: bool, speed: float) -> None:
    """A cage at standstill that hangs on its land, clear of its balls: mu m g times the land's radius turns it."""
    land = LandGuidance(radius=17e-3, room=0.05e-3, outside=outside, speed=speed, half_width=5e-3)
    cage = replace(CAGE, land=land, room=1e-3, orbit_speed=0.0, ball_speed=0.0)
    motion = CageMotion(cage, begin="rest")
    motion.advance(1e-3)  # of its swing of 14 ms, in which friction also pushes it aside
    turned = 0.1 * cage.mass * 9.80665 * 17e-3 * np.sign(speed) / cage.inertia[0] * motion.time
    np.testing.assert_allclose(motion.angular_velocity[2], turned, rtol=0.05)


def test_a_land_holds_a_cage_whose_balls_lead() -> None:
    """The motion begins within land and pockets, and no force of one ball on its pocket counts the land's."""
    land = LandGuidance(radius=17e-3, room=0.05e-3, outside=False, speed=W, half_width=5e-3)
    cage = replace(CAGE, land=land, ball_lead=0.14e-3, gravity=NOWHERE)
    for begin in ("rest", "sudden", "whirl"):
        motion = CageMotion(cage, begin=begin)
        assert np.linalg.norm(motion.centre) < 1.001 * land.room
        assert not motion.forces().any()
    hanging = CageMotion(replace(cage, ball_lead=0.06e-3, gravity=CAGE.gravity), begin="rest")
    np.testing.assert_allclose(np.linalg.norm(hanging.centre), land.room, rtol=0.01)  # and the sag
    motion = CageMotion(replace(cage, ball_lead=0.0, friction_coefficient=0.0, orbit_speed=0.0), begin="sudden")
    motion.launch(velocity=np.array([0.0, 0.37, 0.0]), angular_velocity=np.zeros(3))
    passed = motion.advance(3 * land.room / 0.37)
    assert motion.velocity[1] < 0
    assert passed.max_force == 0


def test_a_cage_that_tilts_meets_its_land_with_both_rims() -> None:
    """Without friction they throw it back as fast: 0.01 rad after a millisecond, its centre at rest."""
    land = LandGuidance(radius=17e-3, room=0.05e-3, outside=True, speed=W, half_width=5e-3)
    cage = replace(CAGE, land=land, room=1e-3, friction_coefficient=0.0, gravity=NOWHERE, orbit_speed=0.0)
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.zeros(3), angular_velocity=np.array([6.0, 8.0, 0.0]))
    motion.advance(0.9e-3)
    np.testing.assert_allclose(motion.angular_velocity, [6.0, 8.0, 0.0], atol=1e-9)
    motion.advance(0.4e-3)
    np.testing.assert_allclose(motion.angular_velocity, [-6.0, -8.0, 0.0], rtol=1e-3, atol=1e-9)  # the step's error
    np.testing.assert_allclose(motion.velocity, 0, atol=1e-9)


@pytest.mark.parametrize("outside", [False, True])
def test_friction_of_the_land_has_the_arm_of_the_rim(outside: bool) -> None:
    """Where the rim meets the land, from the cage's own centre: its moment is what speeds the cage up."""
    radius, room = 1.7e-3, 0.9e-3  # a small land with much room: the rim's radius is 2.6 mm in the bore, 0.8 mm outside
    land = LandGuidance(radius=radius, room=room, outside=outside, speed=900.0, half_width=5e-3)
    cage = replace(CAGE, land=land, room=2e-3, orbit_speed=0.0, ball_speed=0.0, axial_inertia=1e-3)
    motion = CageMotion(cage, begin="rest")
    passed = motion.advance(2e-4)
    arm = radius - room if outside else radius + room
    push = passed.land_power / (900.0 * radius)  # of friction: the cage hardly moves
    np.testing.assert_allclose(motion.angular_velocity[2] * 1e-3, push * arm * motion.time, rtol=0.02)


def test_drag_takes_what_a_free_cage_loses() -> None:
    """In free flight, long enough to lose a tenth and too short to reach a ball."""
    cage = replace(CAGE, drag=0.1, gravity=NOWHERE, axial_inertia=3e-6, friction_coefficient=0.0)
    motion = CageMotion(cage, begin="sudden")
    motion.launch(velocity=np.array([0.11, -0.07, 0.05]), angular_velocity=np.array([0.0, 0.0, 1.7]))
    before, velocity = motion.kinetic_energy, motion.velocity
    passed = motion.advance(2e-6)
    assert passed.max_force == 0
    np.testing.assert_allclose(
        before - motion.kinetic_energy, passed.drag_power * passed.duration, rtol=0.02
    )  # one-sided sum
    decay = np.exp(-0.1 / cage.pitch_radius**2 / cage.mass * passed.duration)
    np.testing.assert_allclose(motion.velocity, velocity * decay, rtol=2e-3)  # second order in the step
