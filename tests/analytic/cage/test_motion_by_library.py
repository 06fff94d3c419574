"""The motion of the cage against a solver of SciPy for the same equations, and against conservation laws."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from analytic.cage.motion import CageMotion
from analytic.cage.steady import DrivenCage, LandGuidance
from tests.analytic.cage.pocket_by_vectors import friction_force, normal_force, penetration
from tests.analytic.cage.specimens import CAGE, RATE, WEIGHTLESS, W


def ball_forces(cage: DrivenCage, time: float, y: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(Z, 2, 3) forces of both shells without losses and their lever arms, by the formulas of the pocket in its frame.

    y : place, velocity, quaternion with the scalar last, angular velocity in the frame of the cage
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
    frames = turn @ np.stack([first, along, np.cross(first, along)], axis=2)  # columns: axes of the pocket
    offset = np.einsum("ijk,ij->ik", frames, centre - y[:3] - cage.pitch_radius * home @ turn.T)
    depths, normals = penetration(offset, half_clearance=cage.half_clearance, centre_offset=cage.centre_offset)
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
    """State at the end, by the equations of Newton and Euler with LSODA."""
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
    solution = solve_ivp(rhs, (0, duration), y, method="LSODA", rtol=1e-9, atol=1e-13, max_step=cage.contact_time / 4)
    return solution.y[:, -1]


def thrown(cage: DrivenCage, **kwargs: Any) -> CageMotion:
    """A cage that moves towards the balls in all six degrees of freedom."""
    motion = CageMotion(cage, begin="sudden", **kwargs)
    motion.launch(velocity=np.array([0.31, -0.22, 0.17]), angular_velocity=np.array([6.0, -9.0, 14.0]))
    return motion


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"centre_offset": 0.03e-3, "pocket_axis": "radial"},
        {"ball_lead": 0.06e-3, "ball_speed": -W * RATE, "orbit_speed": -31.0},
    ],
)
def test_motion_agrees_with_a_library_solver(change: dict[str, Any]) -> None:
    """Without losses in impacts: their force depends on the history of a contact, which the solver cannot have."""
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
    assert errors[0] < 5e-3  # default step; each of the impacts increases the difference
    assert errors[1] < 0.4 * errors[0]  # second order, or slightly less where friction changes its direction


def test_energy_balance() -> None:
    """The work of the balls is the energy of the cage and the losses by friction, impacts, drag and land."""
    land = LandGuidance(radius=17e-3, half_clearance=0.08e-3, outside=False, speed=0.0, half_width=5e-3)
    cage = replace(CAGE, drag=3e-6, land=land, gravity=WEIGHTLESS, ball_lead=0.03e-3)
    motion = thrown(cage)
    before = motion.kinetic_energy
    passed = [motion.advance(0.02)]
    while motion.forces().any():  # so that no energy is in the contacts but 1e-5 at the land
        passed.append(motion.advance(1e-5))
    powers = ("slip_power", "land_power", "damping_power", "drag_power")
    lost = [sum(getattr(each, power) * each.duration for each in passed) for power in powers]
    given = sum(each.ball_power * each.duration for each in passed)
    assert min(lost) > 0
    gained = motion.kinetic_energy - before
    np.testing.assert_allclose(gained, given - sum(lost), atol=5e-3 * given)  # error of the step


@pytest.mark.parametrize("axis", ["axial", "radial"])
@pytest.mark.parametrize("begin", ["rest", "whirl"])
def test_a_motion_begins_where_the_first_ball_touches(axis: Any, begin: Any) -> None:
    """By the formulas of the pocket, with two half-shells and leading balls."""
    cage = replace(CAGE, centre_offset=0.03e-3, pocket_axis=axis, ball_lead=0.06e-3, friction_coefficient=0.0)
    motion = CageMotion(cage, begin=begin)
    still = np.array([0.0, 0.0, 0.0, 1.0])
    at, middle = motion.centre, np.array([-0.03e-3, 0.0, 0.0])

    def pressed(share: float) -> np.ndarray:
        y = np.concatenate([middle + share * (at - middle), np.zeros(3), still, np.zeros(3)])
        return ball_forces(cage, 0.0, y)[0]

    assert not pressed(0.98).any()  # 2 % is more than the elastic sag
    assert pressed(1.02).any()
    if begin == "whirl":
        distance = at[0] - middle[0]
        rolling = cage.ball_speed * cage.ball_radius * np.cos(0.18) + cage.orbit_speed * distance
        np.testing.assert_allclose(motion.velocity, [0, rolling, 0], rtol=1e-12, atol=1e-15)
