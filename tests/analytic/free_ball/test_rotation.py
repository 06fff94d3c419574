"""Free balls against two other programs, closed forms of creep, limits, and the equations that define them."""

import numpy as np
import pytest

from analytic.errors import ConvergenceError
from analytic.free_ball import kernel, layout, sliding, strips
from analytic.free_ball.layout import (
    ACROSS,
    ALONG,
    BALL,
    BALL_RADIUS,
    BOUNDARY,
    CONTACT,
    FLEXIBILITY,
    LOAD,
    NORMAL_R,
    NORMAL_Z,
    ORBIT_RADIUS,
    OUTCOME,
    ROLLING,
    SPIN_POWER,
    TRANSVERSE,
)
from analytic.free_ball.passes import settle_thrust_points
from analytic.free_ball.rotation import Nodes, quadrature_of
from analytic.free_ball.rounds import SKIDS
from analytic.loads.balls import LoadEffects, loaded_balls
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.traction import CoulombTraction
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.sliding.ball import SlipRule, slip_friction
from analytic.torque import friction_torque
from tests.analytic.free_ball.specimens import FINE, angular_contact, under_thrust
from tests.analytic.specimens import BEARING_6205

DEEP, STEEP = (BEARING_6205, 0.18), (angular_contact(), None)
# Bearing, Fa N, w rad/s, mu; then Q_i, Q_o N, al_i, al_o rad, torque N mm by two programs that agree to 0.3 % in torque
# and 1e-3 in loads, to 0.6 % in the last scene
CLOSED = (
    (DEEP, (1000.0, 1e-6, 0.1), (372.2196, 372.2196, 0.30313, 0.30313), 36.629),
    (DEEP, (1000.0, 523.6, 0.05), (370.89, 372.58, 0.30398, 0.30242), 18.737),
    (DEEP, (100.0, 1500.0, 0.05), (41.627, 55.682, 0.26572, 0.18160), 1.4810),
    (DEEP, (20.0, 3000.0, 0.05), (6.7702, 67.616, 0.33351, 0.02381), 0.50051),
    (DEEP, (20.0, 3000.0, 0.1), (6.7608, 67.589, 0.33351, 0.02381), 0.94531),
    (DEEP, (100.0, 3000.0, 0.05), (33.299, 91.962, 0.33718, 0.09433), 2.4014),
    (STEEP, (500.0, 628.3, 0.1), (51.394, 62.672, 0.8326, 0.6066), 18.475),
    (STEEP, (50.0, 628.3, 0.1), (4.2258, 32.980, 1.14239, 0.08453), 2.0924),
)
MARCHED = (  # torque, N mm, to 1 %
    (STEEP, (2000.0, 31.416, 0.1), 67.7),
    (DEEP, (1000.0, 523.6, 0.05), 20.13),
    (DEEP, (100.0, 1500.0, 0.05), 1.540),
    (DEEP, (20.0, 3000.0, 0.05), 0.502),
    (STEEP, (500.0, 628.3, 0.1), 18.84),
    (STEEP, (50.0, 628.3, 0.1), 2.081),
)


@pytest.mark.parametrize(("bearing", "running", "loads", "expected"), CLOSED)
def test_the_closed_law_against_two_programs(
    bearing: tuple, running: tuple[float, float, float], loads: tuple[float, ...], expected: float
) -> None:
    load, speed, friction = running
    balls = under_thrust(*bearing, load=load, speed=speed, friction=friction, creep="closed")
    loose = 6e-3 if load == 50 else 1e-3  # what the programs agree to
    np.testing.assert_allclose(balls.load, loads[:2], rtol=loose)
    np.testing.assert_allclose(balls.angle, loads[2:], atol=1e-3)
    assert 1e3 * balls.torque == pytest.approx(expected, rel=5e-3)


@pytest.mark.parametrize(("bearing", "running", "expected"), MARCHED)
def test_marched_creep_against_another_program(
    bearing: tuple, running: tuple[float, float, float], expected: float
) -> None:
    load, speed, friction = running
    balls = under_thrust(*bearing, load=load, speed=speed, friction=friction, creep="marched")
    assert 1e3 * balls.torque == pytest.approx(expected, rel=1e-2)


def test_without_creep_a_slow_ball_balances_its_spin() -> None:
    """The rule `balanced`, each contact without net force, is the limit of low speed: 1e-4 by another program."""
    free = under_thrust(*DEEP, load=1000.0, speed=1e-6, friction=0.1, creep="none")
    bearing, angle = DEEP
    at_rest = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([1e-6])).as_series()
    balls = loaded_balls(bearing, ContactAngle(rule="solved", free=angle), at_rest, LoadEffects())
    law = CoulombTraction(friction_coefficient=0.1)
    ruled = slip_friction(
        balls.races,
        (law, law),
        ring_speed=np.array([[1e-6]]),
        spin_difference=balls.motion.spin_difference,
        spin_rule="balanced",
        rule=SlipRule("over_ellipse", (24, 24)),
    ).torque
    expected = 9 * float((ruled.spin + ruled.conformity)[0, 0])
    assert free.torque == pytest.approx(expected, rel=1e-3)  # surfaces a thousand times as stiff still creep


@pytest.mark.parametrize(
    ("load", "speed", "friction"), [(100.0, 1500.0, 0.05), (50.0, 628.3, 0.1), (50.0, 628.3, 0.02)]
)
def test_a_fast_ball_obeys_the_closed_kinematics_at_its_own_pitch(load: float, speed: float, friction: float) -> None:
    """It nearly obeys those of outer control too where one race presses far harder."""
    bearing, free = STEEP
    balls = under_thrust(bearing, free, load=load, speed=speed, friction=friction, creep="closed")
    angles = {"inner_angle": balls.angle[0], "outer_angle": balls.angle[1]}
    radius = balls.motion["inner_radius"] + bearing.ball_radius * np.cos(balls.angle[0])
    sizes = {"pitch_diameter": 2 * float(radius), "ball_diameter": bearing.ball_diameter}
    own = ball_kinematics(inner_speed=1.0, **angles, **sizes, pitch=balls.motion["pitch"])
    np.testing.assert_allclose(balls.motion["cage_speed"], own.cage_speed, rtol=3e-3)  # what slip leaves
    if load == 50.0 and friction == 0.1:
        outer = ball_kinematics(inner_speed=1.0, **angles, **sizes)
        np.testing.assert_allclose(balls.motion["cage_speed"], outer.cage_speed, rtol=3e-3)


def test_a_ball_near_its_limit_pitches_down_and_does_not_turn_across() -> None:
    """Where friction cannot hold the gyroscopic moment the axis follows, below that of outer control."""
    balls = under_thrust(*STEEP, load=50.0, speed=628.3, friction=0.02, creep="closed")
    angle, (bearing, _) = balls.angle[1], STEEP
    control = np.arctan2(np.sin(angle), np.cos(angle) + DIAMETER_OVER_PITCH)
    assert 0 < balls.motion["pitch"] < 0.5 * control
    assert abs(balls.rows.velocity[0, 0, 1]) < 1e-2 * bearing.ball_radius * balls.motion["ball_speed"]


DIAMETER_OVER_PITCH = 11.906 / 60


def test_any_start_leads_to_one_rotation() -> None:
    rows = under_thrust(*STEEP, load=500.0, speed=628.3, friction=0.1, creep="marched").rows
    found, random, nodes = rows.velocity[0, 0], np.random.default_rng(8), quadrature_of(FINE, marched=True)
    for _ in range(18):
        pitch, across = random.uniform(-0.3, 1.3), random.uniform(-0.3, 0.3)
        speed = float(np.linalg.norm(found[1:]))
        again = np.array([found[0], across * speed, speed * np.sin(pitch), -speed * np.cos(pitch)])
        for _ in range(20):  # each takes the speed of the surfaces through the contacts from the last
            kernel.turn_ball(rows.contacts[0, 0], rows.bodies[0, 0], again, nodes, 1e-10, np.zeros((2, OUTCOME)))
        np.testing.assert_allclose(again, found, rtol=1e-6, atol=1e-6 * speed)  # of a residual of 1e-10


def test_a_ball_without_a_steady_rotation_is_named(bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch) -> None:
    def skid(model, loads, oil, space, allowed, ends) -> None:
        settle_thrust_points(model, loads, oil, space, allowed, ends)
        ends[:, 0], ends[:, 2], space.balls.residual[:] = SKIDS, 0.3, 0.3

    monkeypatch.setattr(sliding, "settle_thrust_points", skid)
    running = Operation(axial_load=np.array([1000.0]), inner_speed=np.array([31.0]))
    scene = Scene(
        name="skids",
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.18),
        operation=running,
        friction_coefficient=0.1,
        sliding="marched_creep",
    )
    with pytest.raises(
        ConvergenceError, match=r"rotation of ball 0 under 37\d\.\d N on the inner .* residual 3\.0e-01"
    ):
        friction_torque(scene)


def contact(**changed: float) -> np.ndarray:
    """An inner contact of a ball of 4 mm that orbits at 20 mm, far longer across rolling than along it."""
    values = {
        "LOAD": 300.0, "ROLLING": 2e-5, "TRANSVERSE": 1.1e-3, "RADIUS": 4.1e-3, "NORMAL_R": -0.96, "NORMAL_Z": -0.28,
        "RING": 0.0, "FLEXIBILITY": 9.5e-12, "BOUNDARY": 0.07,
    } | changed  # fmt: skip
    row = np.zeros(CONTACT)
    for name, value in values.items():
        row[getattr(layout, name)] = value
    return row


def one_contact(row: np.ndarray, slip: tuple[float, float, float], *, passing: float, marched: bool, nodes: Nodes):
    """Outcome of a contact on a flat surface that slides along rolling, across it and by spin, over a ball that does
    not turn else; the ball is so large that its own rotation does not matter."""
    along, _, spin = slip
    size = 4e-3
    ball = np.zeros(BALL)
    ball[BALL_RADIUS], ball[ORBIT_RADIUS] = size, 0.02
    n_r, n_z = row[NORMAL_R], row[NORMAL_Z]
    velocity = np.array([along, -slip[1], size * spin * n_r, size * spin * n_z])
    outcome, force, tangent = np.zeros(OUTCOME), np.zeros(4), np.zeros((4, 4))
    quadrature = quadrature_of(nodes, marched=marched)
    flows = np.empty((quadrature.across.shape[1], 2, quadrature.along.shape[1]))
    strips.hold_flows(row, quadrature, flows)
    kernel._contact(row, ball, velocity, passing, quadrature, flows, (force, tangent, outcome, np.zeros((3, 4))))
    return outcome, force, tangent


def test_a_ball_that_rolls_does_not_slide_at_the_middle_of_its_contact() -> None:
    """Its surface and that of a ring that turns at 0.37 move alike there; it keeps its orbit and its spin."""
    row = contact(RING=0.37)
    ball = np.zeros(BALL)
    ball[BALL_RADIUS], ball[ORBIT_RADIUS] = 4e-3, 0.02
    before = np.array([0.0021, 0.0, -0.0043, 0.0017])
    velocity = before.copy()
    kernel._roll(row, ball, velocity)
    n_r, n_z = row[NORMAL_R], row[NORMAL_Z]
    of_ball, of_ring = velocity[0] - n_z * velocity[2] + n_r * velocity[3], 0.37 * (0.02 + 4e-3 * n_r)
    assert of_ball == pytest.approx(of_ring, rel=1e-12)  # round-off
    spin, spin_before = (n_r * each[2] + n_z * each[3] for each in (velocity, before))
    assert spin == pytest.approx(spin_before, rel=1e-12)
    assert tuple(velocity[:2]) == tuple(before[:2])


@pytest.mark.parametrize("marched", [False, True])
@pytest.mark.parametrize("times", [0.3, 1.0, 4.0])
def test_an_even_slip_gives_the_force_of_a_strip(times: float, marched: bool) -> None:
    """mu Q f(k), f = (2/pi)[atan k + k/(1 + k^2)], k the slip over s_c = L p0 mu u/a: both laws, by Polach."""
    row, passing = contact(RADIUS=1e9), 0.01
    peak = 1.5 * row[LOAD] / (np.pi * row[ROLLING] * row[TRANSVERSE])
    slip = times * row[FLEXIBILITY] * peak * row[BOUNDARY] * passing
    outcome, _, _ = one_contact(row, (slip, 0.0, 0.0), passing=passing, marched=marched, nodes=Nodes(40, 60))
    share = 2 / np.pi * (np.arctan(times) + times / (1 + times**2))
    assert -outcome[ALONG] == pytest.approx(row[BOUNDARY] * row[LOAD] * share, rel=2e-3)  # second order in 60 steps


SPUN = {30.0: 0.374212, 10.0: 0.368666, 5.0: 0.353548, 3.0: 0.326983, 2.0: 0.291488, 1.0: 0.204930, 0.5: 0.119219}


@pytest.mark.parametrize(("ratio", "expected"), SPUN.items())
def test_spin_of_a_long_ellipse_by_the_closed_law(ratio: float, expected: float) -> None:
    """M_spin/(mu Q b) over w_s b/s_c, from another program."""
    row, passing = contact(RADIUS=1e9), 0.01
    peak = 1.5 * row[LOAD] / (np.pi * row[ROLLING] * row[TRANSVERSE])
    spin = ratio * row[FLEXIBILITY] * peak * row[BOUNDARY] * passing / row[TRANSVERSE]
    outcome, _, _ = one_contact(row, (0.0, 0.0, spin), passing=passing, marched=False, nodes=Nodes(60, 12))
    moment = outcome[SPIN_POWER] / spin
    # the ellipse is 55 times as long as wide, and not endless: 1e-3
    assert moment / (row[BOUNDARY] * row[LOAD] * row[TRANSVERSE]) == pytest.approx(expected, rel=2e-3)


def test_slight_spin_pushes_across_the_groove_only_when_marched() -> None:
    """Where nothing slides the stress is int w_s x dx/(L u) from the leading edge, and its sum pi a^3 b w_s/(4 L u)."""
    row, passing, spin = contact(RADIUS=1e9, ROLLING=2e-4), 0.01, 1e-6
    marched, _, _ = one_contact(row, (0.0, 0.0, spin), passing=passing, marched=True, nodes=Nodes(24, 48))
    closed, _, _ = one_contact(row, (0.0, 0.0, spin), passing=passing, marched=False, nodes=Nodes(24, 48))
    a, b = row[ROLLING], row[TRANSVERSE]
    expected = np.pi / 4 * a**3 * b * spin / (row[FLEXIBILITY] * a * passing)
    assert marched[ACROSS] == pytest.approx(expected, rel=2e-3)  # second order in 48 steps
    assert abs(closed[ACROSS]) < 1e-10 * expected


OILED = {
    "BOUNDARY": 0.02, "EYRING": 4.7e6, "FLUIDITY": 3e3, "LIMIT": 0.05, "SHARE": 0.9, "GROWTH": 7.0, "EXPONENT": 0.6,
}  # fmt: skip


@pytest.mark.parametrize("marched", [False, True])
@pytest.mark.parametrize("law", [{}, OILED])
def test_the_tangent_is_the_derivative_of_the_force(law: dict[str, float], marched: bool) -> None:
    inner = contact(RING=1.0, ROLLING=2e-4, **law)
    outer = contact(NORMAL_R=0.97, NORMAL_Z=0.243, ROLLING=2.2e-4, LOAD=340.0, **law)
    contacts, ball = np.stack([inner, outer]), np.array([4e-3, 0.02, 3.0])
    quadrature = quadrature_of(Nodes(12, 10), marched=marched)
    flows = np.empty((2, quadrature.across.shape[1], 2, quadrature.along.shape[1]))
    for race in range(2):
        strips.hold_flows(contacts[race], quadrature, flows[race])
    start = np.array([8.03e-3, 2e-5, 1.7e-3, -8.2e-3])
    passing = np.array([kernel._passing(each, ball, start) for each in contacts])

    def residual(velocity: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        force, tangent = np.zeros(4), np.zeros((4, 4))
        sums = (force, tangent, np.zeros((2, OUTCOME)), np.zeros((3, 4)))
        kernel._residual(contacts, ball, velocity, passing, quadrature, flows, sums)
        return force, tangent

    _, tangent = residual(start)
    for column in range(4):
        step = 1e-10 * np.eye(4)[column]
        slope = (residual(start + step)[0] - residual(start - step)[0]) / 2e-10
        # differences of a force with kinks between nodes
        np.testing.assert_allclose(tangent[:, column], slope, atol=2e-5 * np.abs(tangent).max())


def test_oil_in_series_with_the_surfaces_is_softer_than_either() -> None:
    row, slip, passing = contact(**(OILED | {"RADIUS": 1e9, "BOUNDARY": 0.0, "FLUIDITY": 1e7})), (3e-9, 0.0, 0.0), 0.01
    along = {}
    for name, changed in (("both", {}), ("oil", {"FLEXIBILITY": 1e-18}), ("surfaces", {"FLUIDITY": 1e30})):
        softened = row.copy()
        for key, value in changed.items():
            softened[getattr(layout, key)] = value
        outcome, _, _ = one_contact(softened, slip, passing=passing, marched=True, nodes=Nodes(16, 16))
        along[name] = -outcome[ALONG]
    assert 0 < along["both"] < min(along["oil"], along["surfaces"])
