"""Free balls against two other programs, closed forms of creep, limits, and the equations that define them."""

import math
import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize

from analytic.errors import ConvergenceError
from analytic.free_ball import kernel, strips
from analytic.free_ball.rotation import free_quadratures
from analytic.free_ball.state import PITCH, ROWS, contact_states, scratch
from analytic.loads.state import ball_states
from analytic.numerics.records import Record, as_record
from analytic.oil.law_table import law_address
from analytic.oil.own_law import own_traction
from analytic.oil.traction import PointLaw, stress_and_slope
from analytic.scene import Array
from analytic.solve.model import model_of
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from tests.analytic.free_ball.specimens import COUNTED, angular_contact, dry_scene, under_thrust
from tests.analytic.specimens import BEARING_6205

NODES = as_record(free_quadratures()[5])  # 64 strips with 47 nodes
DEEP, STEEP = (BEARING_6205, 0.18), (angular_contact(), None)
# Bearing, Fa N, w rad/s, mu; then Q_i, Q_o N, al_i, al_o rad by two programs that agree to 1e-3 in loads, to 0.6 % in
# the last scene.
CLOSED = (
    (DEEP, (1000.0, 1e-6, 0.1), (372.2196, 372.2196, 0.30313, 0.30313)),
    (DEEP, (1000.0, 523.6, 0.05), (370.89, 372.58, 0.30398, 0.30242)),
    (DEEP, (100.0, 1500.0, 0.05), (41.627, 55.682, 0.26572, 0.18160)),
    (DEEP, (20.0, 3000.0, 0.05), (6.7702, 67.616, 0.33351, 0.02381)),
    (DEEP, (20.0, 3000.0, 0.1), (6.7608, 67.589, 0.33351, 0.02381)),
    (DEEP, (100.0, 3000.0, 0.05), (33.299, 91.962, 0.33718, 0.09433)),
    (STEEP, (500.0, 628.3, 0.1), (51.394, 62.672, 0.8326, 0.6066)),
    (STEEP, (50.0, 628.3, 0.1), (4.2258, 32.980, 1.14239, 0.08453)),
)
MARCHED = (  # torque, N mm, to 1 %, of balls whose turn by conformity matters little
    (STEEP, (2000.0, 31.416, 0.1), 67.7),
    (DEEP, (100.0, 1500.0, 0.05), 1.540),
    (STEEP, (500.0, 628.3, 0.1), 18.84),
    (STEEP, (50.0, 628.3, 0.1), 2.081),
)


@pytest.mark.parametrize(("bearing", "running", "loads"), CLOSED)
def test_loads_without_creep_against_two_programs(
    bearing: tuple, running: tuple[float, float, float], loads: tuple[float, ...]
) -> None:
    load, speed, friction = running
    balls = under_thrust(*bearing, load=load, speed=speed, friction=friction, creeps=False)
    loose = 6e-3 if load == 50 else 1.5e-3  # what the programs agree to, and half as much by the turn
    np.testing.assert_allclose(balls.load, loads[:2], rtol=loose)
    np.testing.assert_allclose(balls.angle, loads[2:], atol=2e-3)  # those programs have some creep


@pytest.mark.parametrize(("bearing", "running", "expected"), MARCHED)
def test_marched_creep_against_another_program(
    bearing: tuple, running: tuple[float, float, float], expected: float
) -> None:
    """That program marches one flexibility, that of a long ellipse."""
    load, speed, friction = running
    balls = under_thrust(*bearing, load=load, speed=speed, friction=friction, as_long=True)
    assert 1e3 * balls.torque == pytest.approx(expected, rel=1e-2)


def test_without_creep_a_slow_ball_balances_its_spin() -> None:
    """The rule `balanced`, each contact without net force, is the limit of low speed: 1e-4 by another program."""
    free = under_thrust(*DEEP, load=1000.0, speed=1e-6, friction=0.1, creeps=False)
    scene = dry_scene(*DEEP, 0.1, load=np.array([1000.0]), speed=np.array([1e-6]))
    ruled = model_of(replace(scene, spin_rule="balanced", tolerance=1e-4), COUNTED, free=False)
    expected = float(solved(ruled, points_of(scene.operation, 0.0)).points[0]["total"])
    assert free.torque == pytest.approx(expected, rel=1e-3)  # surfaces a thousand times as stiff still creep


def rigid_slip(state: Record, size: float, orbit: float, x: Array, y: Array) -> tuple[Array, Array]:
    """Slip of points in the plane that touches the curved contact: (..., 2, 4) by the ball's velocity, (..., 2) there.

    size, orbit : radius of the ball and of its orbit, m;  x, y : along the orbit and across, m
    """
    normal, along = np.array([state["normal_radial"], 0.0, state["normal_axial"]]), np.array([0.0, 1.0, 0.0])
    across, bend = np.cross(along, normal), (y / state["radius"])[..., None]
    tangent = (across - bend * normal) / np.sqrt(1 + bend**2)
    arm = (size - y**2 / (2 * state["radius"]))[..., None] * normal + y[..., None] * across + x[..., None] * along
    moves = [along + 0 * arm, *(np.cross(np.eye(3)[axis], arm) / size for axis in (1, 0, 2))]
    ring = state["ring_rate"] * np.cross([0.0, 0.0, 1.0], arm + np.array([orbit, 0.0, 0.0]))
    rates = np.stack([np.stack([each @ along, np.sum(each * tangent, axis=-1)], axis=-1) for each in moves], axis=-1)
    return rates, -np.stack([ring @ along, np.sum(ring * tangent, axis=-1)], axis=-1)


@pytest.mark.parametrize(("bearing", "load"), [(DEEP, 1000.0), (DEEP, 100.0), (STEEP, 500.0)])
def test_a_slow_ball_without_creep_loses_the_least_power(bearing: tuple, load: float) -> None:
    """Of two rigid bodies, over all four speeds of the ball; the turn by conformity is 1.3 % of it in the first."""
    free = under_thrust(*bearing, load=load, speed=1e-6, friction=0.1, creeps=False)
    ball, balls = free.work.balls[0], bearing[0].ball_count
    r, weight = np.polynomial.legendre.leggauss(160)
    angle, r, weight = np.pi * (np.arange(320) + 0.5) / 160, (1 - ((1 - r) / 2) ** 2)[:, None], weight * (1 - r) / 2
    share = 1.5 * np.sqrt(1 - r**2) * r * weight[:, None] / 160 + 0 * angle
    parts = []
    for state in free.work.contacts[0]:
        x, y = (
            state[f"semi_axis_{name}"] * r * turn(angle) for name, turn in (("rolling", np.cos), ("transverse", np.sin))
        )
        parts.append((0.1 * state["load"] * share, *rigid_slip(state, ball["radius"], ball["orbit_radius"], x, y)))

    def power(change: Array) -> tuple[float, Array]:
        """N mm, and its slopes by micrometres."""
        lost, slope = 0.0, np.zeros(4)
        for friction, rates, given in parts:
            slip = rates @ (ball["velocity"] + 1e-6 * change) + given
            size = np.linalg.norm(slip, axis=-1)
            lost += float(np.sum(friction * size))
            slope += np.einsum("ij,ijk,ijkl->l", friction / size, slip, rates)
        return 1e3 * balls * lost, 1e-3 * balls * slope

    least = minimize(power, np.array([3.0, -2.0, 2.5, -1.5]), jac=True, method="BFGS")
    # The bodies of production are flat to the square of the contact's width over its radius, 1e-2 of small terms.
    assert 1e3 * free.torque == pytest.approx(least.fun, rel=2e-3)


def test_a_ball_without_a_steady_rotation_is_named() -> None:
    """In a series that of the first point that has none, as if it were alone."""
    grooves = {race: replace(getattr(BEARING_6205, race), shoulder_half_width=None) for race in ("inner", "outer")}
    load, speed = np.array([55.0, 500.0, 410.0, 77.0]), np.array([83.0, 1e5, 1e5, 90.0])
    series, alone = (
        dry_scene(replace(BEARING_6205, **grooves), 0.31, 0.07, load=load[some], speed=speed[some])
        for some in (slice(None), slice(1, 2))
    )
    named = r"rotation of ball 0 under 7\d\.\d+ N on the inner and \d+ N on the outer race"
    told = str(friction_torque(series).failures[1])
    assert re.search(named, told), told
    with pytest.raises(ConvergenceError) as of_point:
        friction_torque(alone)
    assert told == str(of_point.value)


def contact(**changed: float) -> Record:
    """An inner contact of a ball of 4 mm that orbits at 20 mm, far longer across rolling than along it."""
    values = {
        "load": 300.0, "semi_axis_rolling": 2e-5, "semi_axis_transverse": 1.1e-3, "radius": 4.1e-3,
        "normal_radial": -0.96, "normal_axial": -0.28, "ring_rate": 0.0, "flexibility": 9.5e-12, "lean": 0.63,
        "boundary": 0.07,
    } | changed  # fmt: skip
    state = contact_states(1)[0, 0]
    for name, value in values.items():
        state[name] = value
    return state


def ball_of(velocity: tuple[float, ...], inertia: float = 0.0) -> Record:
    """The ball of these contacts."""
    ball = as_record(ball_states(1)[0])
    ball.radius, ball.orbit_radius, ball.inertia, ball.velocity = 4e-3, 0.02, inertia, velocity
    return ball


def forces(contact: Record, slip: tuple[float, float, float], passing: float) -> Array:
    """Along rolling, across it and by spin, of a contact on a flat surface that slips alike everywhere."""
    contact, state, flows = as_record(contact.copy()), np.zeros(ROWS * PITCH), scratch().flows[0]
    strips.clear_strips(state, NODES.strips)
    for row, each in zip((strips.SLIDE, strips.LATERAL, strips.SPIN), slip, strict=True):
        state[row : row + NODES.strips] = each
    strips.hold_flows(contact, NODES, flows)
    strips.march_strips(
        contact, (1.0, contact.flexibility * passing * contact.semi_axis_rolling, contact.lean), NODES, flows, state
    )
    width = contact.semi_axis_transverse * (NODES.across[1] * NODES.across[2])[: NODES.strips]
    return width @ [strips.marched_strip(state, j)[0] for j in range(NODES.strips)]


@pytest.mark.parametrize("times", [0.3, 1.0, 4.0])
def test_an_even_slip_gives_the_force_of_a_strip(times: float) -> None:
    """mu Q f(k), f = (2/pi)[atan k + k/(1 + k^2)], k the slip over s_c = L p0 mu u/a, by Polach."""
    row, passing = contact(), 0.01
    peak = 1.5 * row["load"] / (np.pi * row["semi_axis_rolling"] * row["semi_axis_transverse"])
    slip = times * row["flexibility"] * peak * row["boundary"] * passing
    share = 2 / np.pi * (np.arctan(times) + times / (1 + times**2))
    expected = row["boundary"] * row["load"] * share
    assert forces(row, (slip, 0.0, 0.0), passing)[0] == pytest.approx(expected, rel=2e-3)  # second order in 48 steps


def test_slight_spin_pushes_across_the_groove() -> None:
    """Where nothing slides the stress is int w_s x dx/(L u) from the leading edge, and its sum pi a^3 b w_s/(4 L u)."""
    row, passing, spin = contact(semi_axis_rolling=2e-4), 0.01, 1e-6
    a, b = row["semi_axis_rolling"], row["semi_axis_transverse"]
    expected = np.pi / 4 * a**3 * b * spin / (row["lean"] * row["flexibility"] * a * passing)
    across = -forces(row, (0.0, 0.0, spin), passing)[1]
    assert across == pytest.approx(expected, rel=2e-3)  # second order in 48 steps


OILED = {
    "boundary": 0.02, "eyring": 4.7e6, "fluidity": 3e3, "limit": 0.05, "share": 0.9, "alpha": 7.0 * 0.6 * 5.1e-9,
    "exponent": 0.6,
}  # fmt: skip


def test_a_slanting_slip_is_resisted_by_both_flexibilities_or_by_none() -> None:
    """Slight, each direction has its own stiffness, 8 a^2 b/(3 L u); large, all stress opposes the slip."""
    row, passing = contact(), 0.01
    a, b = row["semi_axis_rolling"], row["semi_axis_transverse"]
    stiffness = 8 / 3 * a**2 * b / (row["flexibility"] * a * passing)
    slight = forces(row, (3e-10, 2e-10, 0.0), passing)[:2] / [3e-10, 2e-10]
    # Near the ends stress grows at once to its limit: of second order in 48 steps, and 0.3 % slides.
    assert slight == pytest.approx([stiffness, stiffness / row["lean"]], rel=0.01)
    whole = row["boundary"] * row["load"] / np.hypot(3, 2)
    large = forces(row, (3e-3, 2e-3, 0.0), passing)[:2]
    assert large == pytest.approx([3 * whole, 2 * whole], rel=3e-3)  # likewise


def with_fields(state: Record, **changed: float) -> Record:
    other = state.copy()
    for name, value in changed.items():
        other[name] = value
    return other


def point_law(state: Record) -> PointLaw:
    return PointLaw(*(float(state[name]) for name in PointLaw._fields))


@pytest.mark.parametrize(("law", "own"), [({}, False), (OILED, False), (OILED, True)])
def test_the_powers_of_the_law_are_integrals_over_the_contact(law: dict[str, float], own: bool) -> None:
    """Of stress times slip without creep, and of pressure times slip, on a curved surface; one race has no load."""
    address = law_address(own_traction("eyring", math.asinh)) if own else 0.0
    row = contact(ring_rate=1.0, semi_axis_rolling=3e-4, own=address, **law)
    contacts = np.stack([row, with_fields(row, load=0.0)]).view(np.recarray)
    velocity = np.array([8.03e-3, 2e-5, 1.7e-3, -8.2e-3])
    kernel.add_law_powers(contacts, ball_of(tuple(velocity)), NODES, scratch())
    a, b, size = row["semi_axis_rolling"], row["semi_axis_transverse"], 4e-3
    r, angle = np.sqrt((np.arange(60) + 0.5) / 60)[:, None], 2 * np.pi * (np.arange(160) + 0.5) / 160
    x, y = np.broadcast_arrays(a * r * np.cos(angle), b * r * np.sin(angle))
    pressure = 1.5 * row["load"] / (np.pi * a * b) * np.sqrt(1 - r**2) + 0 * x
    rates, given = rigid_slip(row, size, 0.02, x, y)
    sliding = np.linalg.norm(rates @ velocity + given, axis=-1)
    each = zip(pressure.ravel().tolist(), sliding.ravel().tolist(), strict=True)
    stresses = np.array([stress_and_slope(point_law(row), *point)[0] for point in each])
    area = np.pi * a * b / x.size
    assert contacts[0].law_power == pytest.approx(area * float(stresses @ sliding.ravel()), rel=3e-3)  # of the cells
    assert contacts[0].unit_power == pytest.approx(area * float(np.sum(pressure * sliding)), rel=3e-3)
    assert contacts[1].law_power == contacts[1].unit_power == 0


@pytest.mark.parametrize("race", [0, 1])
def test_a_ball_on_one_race_rolls_there_and_keeps_its_orbit_and_its_spin(race: int) -> None:
    """Friction balances the gyroscopic moment about the axis of rolling; on a curved surface some slides back."""
    loaded = contact(ring_rate=1.0 - race, radius=4.1e-3, semi_axis_rolling=2e-4)
    contacts = np.stack([with_fields(loaded, load=0.0, across=7.0)] * 2)
    contacts[race] = loaded
    before = (8.1e-3, 3e-5, 1.1e-3, -6e-3)
    ball = ball_of(before, inertia=7e5)
    assert kernel.turn_ball(contacts, ball, NODES, 1e-10, scratch()) <= 1e-10
    assert contacts["across"].tolist() == [0.0, 0.0]
    assert contacts["friction"][1 - race] == contacts["power"][1 - race] == 0
    assert tuple(ball.velocity[:2]) == before[:2]
    normal = np.array([loaded["normal_radial"], loaded["normal_axial"]])
    assert normal @ ball.velocity[2:] == pytest.approx(normal @ before[2:], rel=1e-9)
    across = np.array([-normal[1], normal[0]])
    gyroscopic = 7e5 / 0.02 * ball.velocity[0] * ball.velocity[1] * across[0]  # N, of the inertia above
    # The arm of what acts off the middle is shorter, by y^2/(2 R) of the ball's radius: 3.7 % at the ends.
    assert contacts["along"][race] == pytest.approx(-gyroscopic, rel=0.04)
    slide = before[0] + across @ ball.velocity[2:] - loaded["ring_rate"] * (0.02 + 4e-3 * normal[0])
    # It slides by more than nothing, and by less than the surface curves away at the ends.
    assert 0 < abs(slide) / abs(across @ ball.velocity[2:] / 4e-3 * 1.1e-3**2 / (2 * 4.1e-3)) < 1
