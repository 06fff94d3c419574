"""What the balls' own forces can do in a thrust bearing, by vectors and by statics."""

from dataclasses import replace

import numpy as np

from analytic.effects.washers import held_in_the_middle
from analytic.scene import Scene
from analytic.solve.model import model_of
from analytic.solve.solution import Solution, points_of, solved
from tests.analytic.specimens import thrust
from tests.analytic.test_thrust_bearing import BALL, BEARING, COUNT, PITCH, scene_of


def loaded(scene: Scene) -> Solution:
    """The balls of a scene whose friction does not count."""
    return solved(model_of(scene, {}), points_of(scene.operation.as_series(), temperature=0.0))


def test_leaning_contacts_spin_more_as_the_bound_has_it() -> None:
    """By vectors: a ball that rolls without slip on two washers, on contacts that lean outwards by a small angle."""
    lean, radius, middle = 1e-4, BALL / 2, PITCH / 2
    normals = np.array([[0, np.sin(lean), np.cos(lean)], [0, np.sin(lean), -np.cos(lean)]])  # along, out, up
    washers = np.array([[0, 0, 0.5], [0, 0, -0.5]])  # against the orbit, which turns at half the speed
    # One unknown by symmetry, the ball's rotation about the radius; no slip along the track at the upper contact.
    track = np.cross(washers[0], [0, middle + radius * np.sin(lean), 0])[0]
    rotation = np.array([0, track / np.cross([0, 1, 0], radius * normals[0])[0], 0])
    lower = np.cross(washers[1], [0, middle + radius * np.sin(lean), 0])[0]
    np.testing.assert_allclose(np.cross(rotation, radius * normals[1])[0], lower, rtol=1e-12)  # nor at the lower one
    spins = [abs((rotation - washer) @ normal) for washer, normal in zip(washers, normals, strict=True)]
    more = np.array(spins) / 0.5 - 1
    np.testing.assert_allclose(more, lean * PITCH / BALL, rtol=1e-3)  # to first order in the lean
    # The bound: twice that, at the lean of F_c/(2 Q).
    axial, speed = 60.0, 90.0
    scene = scene_of(thrust(axial, speed=speed))
    total = np.array([3.0])
    bound = held_in_the_middle(
        replace(scene, effects={"weight": "off"}), loaded(scene), parts={"spin": total / 5}, total=total
    )
    centrifugal = BEARING.ball_mass * PITCH / 2 * (speed / 2) ** 2
    angle = centrifugal / (2 * axial / COUNT)
    np.testing.assert_allclose(bound, 2 * angle * PITCH / BALL / 5, rtol=1e-10)  # round-off


def test_the_weight_counts_on_one_washer() -> None:
    """A standing shaft: m g more on the lower washer, of which rolling takes a third, on half of the contacts."""
    axial = 25.0
    scene, total = scene_of(thrust(axial, speed=1.0)), np.array([2.0])
    bound = held_in_the_middle(
        replace(scene, effects={"centrifugal": "off"}), loaded(scene), parts={"rolling": total}, total=total
    )
    np.testing.assert_allclose(bound, BEARING.ball_mass * 9.80665 * COUNT / axial / 3 / 2, rtol=1e-12)  # round-off
