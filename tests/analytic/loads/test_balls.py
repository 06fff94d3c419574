"""The torque of unequal balls against slip power from a minimum, and balance, symmetry and limits."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize

from analytic.scene import (
    Array,
    Bearing,
    ContactAngle,
    Operation,
    Scene,
)
from analytic.torque import friction_torque
from tests.analytic.specimens import balls_of

MU = 0.083
FREE = 0.23
# All that is solved is solved to 1e-9 or better; nothing left out.
ALL: dict = {
    "hysteresis": "off",
    **dict.fromkeys(("load_distribution", "centrifugal", "gyroscopic", "finite_geometry", "spin", "conformity"), "on"),
    "rolling": "off",
    "weight": "off",
}


def operation(axial: float, radial: float, speed: float, moment: float = 0.0) -> Operation:
    return Operation(
        axial_load=np.array([axial]),
        inner_speed=np.array([speed]),
        radial_load=np.array([radial]),
        moment=np.array([moment]),
    )


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        tolerance=1e-5,  # the finest nodes at every point
        spin_rule="balanced",
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=FREE),
        operation=operation(310.0, 170.0, 900.0),
        friction_coefficient=MU,
        effects=ALL,
    )


def torque(scene: Scene, **change: float) -> float:
    asked = {name: np.array([value]) for name, value in change.items()}
    return float(friction_torque(replace(scene, operation=replace(scene.operation, **asked))).torque.total[0])


def slip_power(load: Array, axes: Array, radius: Array, roll: Array, spin: float) -> float:
    """Slip power of one ball on both races per mu, N m: the least over all creeps and shares of the spin.

    axes : (2, 2) a and b of each race
    Force and moment of a Coulomb contact are the derivatives of its power. There is no net force where the power does
    not change with the creep, and no net spin moment on the ball where it does not change with the share.
    """
    r, angle = np.sqrt((np.arange(60) + 0.5) / 60)[:, None], np.pi * ((np.arange(120) + 0.5) / 120 - 0.5)
    pressure = 1.5 * np.sqrt(1 - r**2) / r.size / angle.size + 0 * angle

    def power(unknown: Array) -> float:
        total = 0.0
        for race, share in ((0, unknown[0]), (1, unknown[0] - 1)):
            if load[race] == 0:
                continue
            (a, b), curved = axes[race], roll[race] / radius[race]
            x, y = a * r * np.cos(angle), b * r * np.sin(angle)
            slide = curved * y**2 / 2 + share * spin * y - unknown[1 + race] * curved * b**2 / 2
            total += load[race] * float(np.sum(pressure * np.hypot(slide, (share * spin + curved * y) * x)))
        return total

    found = minimize(
        power, [0.5, 0.1, 0.1], method="Nelder-Mead", options={"xatol": 1e-5, "fatol": 1e-12, "maxiter": 2000}
    )
    return float(found.fun)


def motion(bearing: Bearing, inner_angle: float, outer_angle: float) -> tuple[np.ndarray, float]:
    """Rolling on both races and the difference of spins per ring speed, of rigid bodies.

    Vectors with radial and axial parts (r, z); the ball turns about an axis in that plane, across the mean normal.
    """
    normals = [
        np.array([-np.cos(inner_angle), -np.sin(inner_angle)]),
        np.array([np.cos(outer_angle), np.sin(outer_angle)]),
    ]
    mean = (inner_angle + outer_angle) / 2
    axis = np.array([-np.sin(mean), np.cos(mean)])
    radius, orbit = bearing.ball_radius, bearing.pitch_diameter / 2

    def sliding(unknown: np.ndarray) -> list[float]:
        cage, turn = unknown  # both in the frame of the outer race; the tangential speed at each contact
        speeds = []
        for normal, ring in zip(normals, (1.0, 0.0), strict=True):
            own = turn * (axis[1] * normal[0] - axis[0] * normal[1]) * radius  # omega x r, along the tangent
            place = orbit + radius * normal[0]
            speeds.append(cage * place + own - ring * place)
        return speeds

    matrix = np.stack([np.subtract(sliding(unit), sliding(np.zeros(2))) for unit in np.eye(2)], axis=1)
    cage, turn = np.linalg.solve(matrix, -np.array(sliding(np.zeros(2))))
    rolls, spins = [], []
    for normal, ring in zip(normals, (1.0, 0.0), strict=True):
        relative = turn * axis + np.array([0.0, cage - ring])  # of ball to race
        rolls.append(abs(relative @ np.array([-normal[1], normal[0]])))
        spins.append(relative @ normal)
    return np.array(rolls), abs(spins[0] + spins[1])


@pytest.mark.parametrize(("axial", "radial"), [(310.0, 170.0), (0.7, 700.0)])
def test_the_torque_is_the_slip_power_of_every_ball(scene: Scene, axial: float, radial: float) -> None:
    """Loads and angles come from the ring. The second case has balls that only centrifugal force loads, on one race."""
    asked = replace(scene, operation=operation(axial, radial, 900.0), effects={**ALL, "finite_geometry": "off"})
    balls, bearing = balls_of(asked)[0], scene.bearing
    assert np.any(balls["load"][:, 0] == 0) == (radial > axial)
    grooves = np.array([bearing.inner.groove_radius, bearing.outer.groove_radius])
    deformed = 2 * grooves * bearing.ball_radius / (grooves + bearing.ball_radius)
    powers = []
    for ball in balls:
        rolls, spin = motion(bearing, *ball["angle"])
        axes = np.stack([ball["semi_axis_rolling"], ball["semi_axis_transverse"]], axis=1)
        powers.append(slip_power(ball["load"], axes, deformed, rolls, spin))
    assert max(powers) > 1.5 * min(powers)
    np.testing.assert_allclose(torque(asked), MU * sum(powers), rtol=2e-3)  # kinks of |v| between 60 times 120 nodes


def test_the_weight_of_the_balls_presses_the_lower_ones(scene: Scene) -> None:
    """Along the thrust it is carried by the outer race alone; m g of each ball."""
    upright = replace(scene, operation=operation(31.0, 0.0, 0.0), down=(0.0, 0.0, 1.0))
    balls = balls_of(upright, weight="on")
    along = balls["load"] * np.sin(balls["angle"])
    np.testing.assert_allclose(
        along[..., 1] - along[..., 0], 2.04e-3 * 9.80665, rtol=1e-6
    )  # a difference of 3.4 N each


def test_a_vanishing_radial_load_leaves_the_thrusts_torque(scene: Scene) -> None:
    """A load the other way is the bearing turned: the change goes with the square, but for the pattern of the balls."""
    thrust = torque(replace(scene, effects={**ALL, "load_distribution": "off"}), radial_load=0.0)
    changes = [torque(scene, radial_load=radial) - thrust for radial in (0.0, 1.0, 2.0)]
    np.testing.assert_allclose(changes[0], 0, atol=1e-9 * thrust)  # the ring's iteration
    np.testing.assert_allclose(changes[2] / changes[1], 4, rtol=0.01)  # the next term, of fourth order
