"""A ball in two half-shells: against geometry by points, the equation of motion of an impact, and Hertz."""

import mpmath
import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.spatial.transform import Rotation

from analytic.cage.motion import CAGE
from analytic.cage.pocket import (
    BallInPocket,
    Body,
    elastic_force,
    impact,
    impact_damping,
    is_clear,
    pocket_shape,
    pocket_stiffness,
    pushed,
)
from analytic.contact.hertz import hertz_contact
from analytic.numerics.records import Record, as_record
from analytic.scene import Array
from tests.analytic.cage.pocket_by_vectors import friction_force, normal_force, penetration
from tests.refusals import refused

BALL, POCKET, DEPTH = 7.94e-3, 13.9e-3, 6.81e-3  # m: Table 1 of the paper
NABLA, OFF = pocket_shape(ball_diameter=BALL, pocket_diameter=POCKET, pocket_depth=DEPTH)


def test_stiffness_is_that_of_hertz() -> None:
    curvature = 2 / 7.94e-3 - 2 / 8.14e-3
    hertz = hertz_contact(curvature_x=curvature, curvature_y=curvature, load=28.0, modulus=1.13e11)
    computed = pocket_stiffness(ball_diameter=7.94e-3, pocket_diameter=8.14e-3, modulus=1.13e11)
    np.testing.assert_allclose(computed, hertz.stiffness, rtol=1e-12)  # round-off


@pytest.mark.parametrize("offset", [(1.7e-3, 2.1e-3, -1.9e-3), (-0.09e-3, 2.4e-3, 1.8e-3), (0.05e-3, 0.3e-3, 0.2e-3)])
def test_penetration_is_how_far_the_shell_reaches_into_the_ball(offset: tuple[float, float, float]) -> None:
    """Each shell is represented by points of its half sphere; the nearest one to the centre of the ball counts."""
    still, level = (0.0, 0.0, 0.0), (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0)
    pocket = cage_of(half_clearance=NABLA, centre_offset=OFF, damping=0.0, friction=0.0)
    found = pushed(
        pocket, BallInPocket(offset, level[:3], still, still, still), Body(still, still, level, still), np.zeros(2)
    )
    depths, normals = penetration(offset, half_clearance=NABLA, centre_offset=OFF)
    polar, around = np.meshgrid(np.linspace(0, np.pi / 2, 601), np.linspace(0, 2 * np.pi, 1201))
    for index, side in enumerate((1, -1)):
        cap = [side * np.cos(polar), np.sin(polar) * np.cos(around), np.sin(polar) * np.sin(around)]
        points = POCKET / 2 * np.stack(cap, axis=-1) - [side * (POCKET / 2 - DEPTH), 0, 0]
        distance = np.linalg.norm(points - offset, axis=-1)
        reach = BALL / 2 - distance.min()
        nearest = points.reshape(-1, 3)[distance.argmin()] - offset
        np.testing.assert_allclose(depths[index], max(reach, 0.0), atol=4e-8)  # m: the spacing of 18 um, squared
        if depths[index] > 0:
            np.testing.assert_allclose(normals[index], nearest / np.linalg.norm(nearest), atol=8e-3)  # spacing/radius
    force = 6.1e10 * (depths**1.5) @ normals
    np.testing.assert_allclose(found.force, force, rtol=0, atol=1e-9 * max(float(np.abs(force).max()), 1.0))
    assert found.deepest == pytest.approx(depths.max(), rel=1e-9)


CLEARANCE, ASIDE = 0.1e-3, 0.03e-3  # m: nabla, and D_p/2 - k
LOSS = 0.43  # damping of an impact
IMPACT = {"impact_speed": 0.05, "least": 0.02}  # m/s: the fastest so far of the present contacts, and the least one


def cage_of(**changed: float) -> Record:
    cage = as_record(np.zeros(1, CAGE)[0])
    cage.half_clearance, cage.centre_offset, cage.ball_radius = CLEARANCE, ASIDE, BALL / 2
    cage.stiffness, cage.damping, cage.least_impact = 6.1e10, LOSS, IMPACT["least"]
    cage.friction, cage.smoothing = 0.13, 0.2
    for name, value in changed.items():
        cage[name] = value
    return cage


@pytest.mark.parametrize("aside", [ASIDE, 0.0])
def test_a_ball_is_clear_up_to_the_place_where_a_shell_is_penetrated(aside: float) -> None:
    random, cage = np.random.default_rng(3), cage_of(centre_offset=aside)
    for turn in Rotation.random(60, rng=random).as_matrix():
        direction = random.normal(size=3)
        direction /= np.linalg.norm(direction)
        towards = abs(direction[0]) * aside
        touching = np.sqrt(CLEARANCE**2 - aside**2 + towards**2) - towards  # where |u_s| = nabla for the shell ahead
        for share in (0.9999, 1.0001):
            offset = share * touching * direction
            depths, _ = penetration(offset, half_clearance=CLEARANCE, centre_offset=aside)
            x, y, z = turn @ offset
            assert is_clear(cage, (x, y, z), tuple(turn[:, 0])) == (share < 1) == (not depths.any())


PLACES = [(0.09e-3, 0.05e-3, 0.03e-3), (0.008e-3, 0.09e-3, -0.055e-3), (-0.02e-3, -0.06e-3, 0.075e-3)]  # m


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("closing", [0.31, 0.03, -0.04, -0.9])  # m/s
def test_a_push_is_that_of_the_formulas(place: tuple[float, float, float], closing: float) -> None:
    """In a pocket that leans, on a cage that moves; both shells or one, as contacts close, open, and pull away."""
    turn = Rotation.from_rotvec([0.4, -0.7, 0.2]).as_matrix()
    depths, normals = penetration(np.array(place), half_clearance=CLEARANCE, centre_offset=ASIDE)
    normals, pressed = normals @ turn.T, depths > 0
    centre, rotation = np.array([17.1e-3, -8.3e-3, 0.6e-3]), np.array([31.0, -17.0, 42.0])
    velocity, spin = np.array([0.02, -0.03, 0.01]), np.array([3.0, -2.0, 7.0])
    arms = centre + BALL / 2 * normals
    deeper = int(depths.argmax())
    of_ball = BALL / 2 * np.cross(rotation, normals[deeper]) - velocity - np.cross(spin, arms[deeper])
    going = (closing - of_ball @ normals[deeper]) * normals[deeper] + 0.07 * np.cross(normals[deeper], [0.6, 0.0, 0.8])
    surface = going + BALL / 2 * np.cross(rotation, normals)
    past = surface - velocity - np.cross(spin, arms)
    rate = np.sum(past * normals, axis=1)
    fastest = np.maximum(np.maximum([IMPACT["impact_speed"], 0.0], rate), IMPACT["least"])
    normal, elastic = (
        normal_force(depths, rate=rate, impact_speed=fastest, stiffness=6.1e10, damping=damping)
        for damping in (LOSS, 0.0)
    )
    sliding = past - rate[:, None] * normals
    friction = friction_force(normal, sliding, friction_coefficient=0.13, smoothing=0.2)
    force = normal[:, None] * normals + friction
    speeds = np.array([IMPACT["impact_speed"], 0.0])
    found = pushed(
        cage_of(),
        BallInPocket(vector(turn @ place), vector(turn[:, 0]), vector(centre), vector(going), vector(rotation)),
        Body((0.2e-3, 0.1e-3, -0.3e-3), vector(velocity), tuple(turn.ravel()), vector(spin)),
        speeds,
    )
    # Tolerance: depths of um are differences of places of 0.1 mm
    close = 1e-9 * max(normal.max(), 1.0)
    np.testing.assert_allclose(found.force, force.sum(axis=0), rtol=0, atol=close)
    np.testing.assert_allclose(found.moment, np.cross(arms, force).sum(axis=0), rtol=0, atol=0.02 * close)
    powers = np.sum(friction * sliding), np.sum((normal - elastic) * rate), np.sum(force * surface)
    np.testing.assert_allclose([found.slip, found.damping, found.work], powers, rtol=0, atol=close)
    np.testing.assert_allclose([found.normal, found.largest], [normal.sum(), normal.max()], rtol=0, atol=close)
    np.testing.assert_allclose(found.deepest, depths.max(), rtol=1e-9)
    np.testing.assert_allclose(speeds, np.where(pressed, fastest, 0.0), rtol=1e-12)


def vector(values: Array) -> tuple[float, float, float]:
    x, y, z = values
    return float(x), float(y), float(z)


@pytest.mark.parametrize("softness", [1.3e-14, 7.7e-9, 4.1e-5])
@pytest.mark.parametrize("force", [1.9e-9, 0.31, 28.0, 4.7e4])
def test_contact_and_sheet_are_springs_in_series(softness: float, force: float) -> None:
    """From a rigid sheet to one that takes all of the deformation."""
    depth = (force / 6.1e10) ** (2 / 3) + force * softness
    np.testing.assert_allclose(elastic_force(6.1e10, softness, depth), force, rtol=1e-12)  # of the last Newton step


def bounce(mass: float, speed: float, stiffness: float, damping: float) -> tuple[float, float, float, float]:
    """Indentation, its elastic force, duration and final speed, by the equation of motion."""

    def rhs(_: float, y: np.ndarray) -> list[float]:
        force = normal_force(max(y[0], 0.0), rate=y[1], impact_speed=speed, stiffness=stiffness, damping=damping)
        return [y[1], -float(force) / mass]

    def leaves(_: float, y: np.ndarray) -> float:
        return y[0]

    leaves.terminal, leaves.direction = True, -1  # type: ignore[attr-defined]
    guess = impact(mass=mass, speed=speed, stiffness=stiffness)
    end = 20 * guess.duration
    computed = solve_ivp(
        rhs, (0, end), [1e-14, speed], events=leaves, method="DOP853", rtol=1e-11, atol=1e-16, max_step=end / 2000
    )
    deepest = computed.y[0].max()
    return deepest, stiffness * deepest**1.5, computed.t_events[0][0], -computed.y_events[0][0, 1]


def test_impact_agrees_with_its_equation_of_motion() -> None:
    mass, speed, stiffness = 3.1e-3, 0.47, 5.3e10
    deepest, force, duration, leaving = bounce(mass, speed, stiffness, 0.0)
    computed = impact(mass=mass, speed=speed, stiffness=stiffness)
    np.testing.assert_allclose(computed.indentation, deepest, rtol=1e-5)  # the largest of 100 points of the contact
    np.testing.assert_allclose(computed.force, force, rtol=1e-5)
    np.testing.assert_allclose(computed.duration, duration, rtol=1e-7)
    np.testing.assert_allclose(leaving, speed, rtol=1e-8)
    faster = impact(mass=mass, speed=3.7 * speed, stiffness=stiffness)
    np.testing.assert_allclose(faster.force / computed.force, 3.7**1.2, rtol=1e-12)


@pytest.mark.parametrize("restitution", [0.05, 0.31, 0.9416, 0.9419, 1 - 2.0**-10, 1 - 2.0**-16, 1 - 2.0**-33])
def test_damping_solves_its_equation(restitution: float) -> None:
    """With 60 digits, on both sides of the switch to a series; near 1 both sides of the equation nearly cancel."""
    with mpmath.workdps(60):
        e = mpmath.mpf(restitution)

        def excess(factor: mpmath.mpf) -> mpmath.mpf:
            return (mpmath.log1p(factor) - mpmath.log1p(-factor * e) - factor * (1 + e)) / factor**2

        bounds = 0.1 * (1 - e), (1 - mpmath.mpf(10) ** -12) / e
        exact = mpmath.findroot(excess, bounds, solver="anderson", tol=mpmath.mpf(10) ** -70, maxsteps=500)
    assert impact_damping(restitution) == pytest.approx(float(exact), rel=1e-12)  # the series' fifth term: 4e-13


def test_impossible_input_is_refused() -> None:
    """What a pocket cannot be, the hard cases have (validation/hard/cage.py)."""
    refused(lambda: pocket_stiffness(ball_diameter=8e-3, pocket_diameter=8e-3, modulus=1e11), "no clearance")
    sizes = {"ball_diameter": 8.1e-3, "pocket_diameter": 8e-3}
    refused(lambda: pocket_stiffness(**sizes, modulus=1e11), "0.008 m must exceed ball_diameter 0.0081 m")
    refused(lambda: impact_damping(float("nan")), "restitution")
    refused(lambda: impact(mass=2.0, speed=-3.0, stiffness=4.0), "speed")
