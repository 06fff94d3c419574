"""The races as free balls feel them: creep against a marched strip, derivatives against equilibria, balls alone."""

import numpy as np
import pytest

from analytic.cage.raceways import (
    AZIMUTH,
    BALL,
    LARGEST_TURN,
    LEAST_CREEP,
    SPEEDS,
    STRIPS,
    PocketPush,
    Raceways,
    interpolate,
    pressed_contacts,
    ring_raceways,
    step_ball,
    traction,
)
from analytic.contact.geometry import RACES
from analytic.errors import InputError
from analytic.loads.ball_balance import grooves_of, settled_ball
from analytic.loads.turning import Inertia
from analytic.scene import Array, Operation
from tests.analytic.cage.specimens import ANGLE, W, races_under
from tests.analytic.specimens import BEARING_6205

RADIUS, PITCH = BEARING_6205.ball_radius, BEARING_6205.pitch_diameter / 2
STANDING = Inertia(centrifugal=False, gyroscopic=False)


def carried(k: Array) -> Array:
    """f(k): share of its limit that a strip carries at the slip k s_c."""
    return 2 / np.pi * (np.arctan(k) + k / (1 + k**2))


def at(*, load: float, moment: float = 0.0, axial: float = 1000.0) -> Operation:
    speed, thrust = np.array([W]), np.array([axial])
    return Operation(axial_load=thrust, inner_speed=speed, radial_load=load, moment=moment, tilt="free")


def balance(races: Raceways, speeds: Array, strips: int, *, azimuth: int = 0) -> tuple[Array, float]:
    """Force on a ball by its four speeds, N, and power of slip, W; by NumPy and its own arctan, from the formulas."""
    nodes, weights = np.polynomial.legendre.leggauss(strips)
    phi, weight = np.pi / 2 * nodes, np.pi / 2 * weights * 0.75 * np.cos(np.pi / 2 * nodes) ** 3
    total, lost = np.zeros(4), 0.0
    grooves = (BEARING_6205.inner, BEARING_6205.outer)
    for race, (groove, ring) in enumerate(zip(grooves, (races.inner_speed, 0.0), strict=True)):
        load = races.contacts.load[race, azimuth]
        angle = races.contacts.contact_angle[race, azimuth] + np.pi * (1 - race)  # of the normal out of the ball
        width = races.contacts.contact.semi_axis_y[race, azimuth]
        conformity = groove.groove_radius / (2 * RADIUS)
        depth = width**2 * np.sin(phi) ** 2 / (2 * 2 * conformity * 2 * RADIUS / (2 * conformity + 1))
        creep = races.table[azimuth][RACES[race]]["creep"] * np.cbrt(load) + LEAST_CREEP
        outward, axial = speeds[2] / RADIUS, speeds[3] / RADIUS - ring
        across = -np.sin(angle) * outward + np.cos(angle) * axial
        normal = np.cos(angle) * outward + np.sin(angle) * axial
        arm, side = RADIUS - depth, width * np.sin(phi)
        slip = np.stack([speeds[0] - PITCH * ring + across * arm - normal * side, -speeds[1] / RADIUS * arm])
        speed = np.hypot(*slip)
        force = -races.friction[race] * load * weight * carried(speed / creep) * slip / speed
        lost -= np.sum(force * slip)
        turning, spinning, about = np.sum(force[0] * arm), -np.sum(force[0] * side), -np.sum(force[1] * arm)
        total += [
            np.sum(force[0]),
            about / RADIUS,
            (np.cos(angle) * spinning - np.sin(angle) * turning) / RADIUS,
            (np.sin(angle) * spinning + np.cos(angle) * turning) / RADIUS,
        ]
    gyroscopic = 0.4 * BEARING_6205.ball_mass * speeds[0] / PITCH
    return total + gyroscopic * np.array([0, -speeds[2], speeds[1], 0]), lost


def test_the_compiled_tractions_are_those_of_the_formulas() -> None:
    """At speeds that no symmetry favours; and they fall with the speeds by their derivative."""
    races = races_under((381.0, 297.0), (0.31, 0.22), inner_speed=W, friction=0.13)
    speeds = races.alone.speeds[0] + [1.1e-3, -0.7e-3, 1.9e-3, -2.3e-3]
    constants = races.constants

    def both(v: Array) -> tuple[Array, Array]:
        inner, outer = pressed_contacts(constants, races.table[0], 0.0, 0.0, 1.0)
        first = traction(inner, v[0] - W * PITCH, v[1], v[2], v[3] - W * RADIUS)
        total = np.add(first, traction(outer, *v))
        fall = np.zeros((4, 4))
        fall[np.triu_indices(4)] = total[4:]
        return total[:4], fall + np.triu(fall, 1).T

    force, fall = both(speeds)
    gyroscopic = 0.4 * constants["ball_mass"] * speeds[0] / PITCH * np.array([0, -speeds[2], speeds[1], 0])
    exact, _ = balance(races, speeds, STRIPS)
    np.testing.assert_allclose(force, exact - gyroscopic, rtol=0, atol=1e-9 * max(abs(exact)))  # arctan to 2e-13
    for index, change in enumerate(1e-8 * np.eye(4)):
        difference = (both(speeds - change)[0] - both(speeds + change)[0]) / 2e-8
        np.testing.assert_allclose(fall[index], difference, rtol=0, atol=1e-6 * abs(fall).max())  # of differences


def test_between_azimuths_a_contact_is_on_the_straight_line() -> None:
    """Of all its numbers; also from the last azimuth to the first, and after turns back and forth."""
    table, ball = np.zeros(5, AZIMUTH), np.zeros(1, BALL)[0]
    numbers = table.view(np.float64).reshape(5, -1)
    numbers[:] = np.random.default_rng(8).normal(size=numbers.shape)
    for place in (1.3, 4.6, 13.2, -2.9):
        ball["azimuth"] = 2 * np.pi * place / 5
        interpolate(table, ball)
        found = np.array([ball["contacts"]]).view(np.float64)
        expected = [np.interp(place, np.arange(5), column, period=5) for column in numbers.T]
        np.testing.assert_allclose(found, expected, rtol=0, atol=1e-12)  # round-off


@pytest.mark.parametrize("push", [(17.0, -9.0), (-14.0, 52.0)])  # N; the second turns the normals too far
def test_a_push_turns_the_contacts_and_changes_their_size(push: tuple[float, float]) -> None:
    races = races_under((140.0, 290.0), (0.31, 0.22), inner_speed=W, friction=0.13)
    found = pressed_contacts(races.constants, races.table[0], *push, 0.37)
    more, turns = (
        [np.dot([races.table[0][race][f"{what}_by_{way}"] for way in ("radial", "axial")], push) for race in RACES]
        for what in ("load", "turn")
    )
    loads = 140.0 + more[0], 290.0 + more[1]
    assert min(loads) > 0
    assert (max(map(abs, turns)) > LARGEST_TURN) == (push[0] < 0)
    hertz = races_under(loads, (0.31, 0.22), inner_speed=W, friction=0.13)
    for number, (contact, race) in enumerate(zip(found, RACES, strict=True)):
        assert contact.limit == pytest.approx(0.13 * loads[number], rel=1e-12)
        angle = (0.31 + np.pi, 0.22)[number] + np.arctan(np.clip(turns[number], -LARGEST_TURN, LARGEST_TURN))
        normal = contact.normal_radial, contact.normal_axial
        np.testing.assert_allclose(normal, [np.cos(angle), np.sin(angle)], rtol=0, atol=1e-12)
        width = hertz.contacts.contact.semi_axis_y[number, 0] / RADIUS
        assert contact.width == pytest.approx(width, rel=1e-9)  # of Hertz's root
        creep = hertz.table[0][race]["creep"] * np.cbrt(loads[number])
        assert contact.creep == pytest.approx(0.37 * creep + LEAST_CREEP, rel=1e-9)


def test_a_step_of_a_ball_keeps_its_energy_accounts() -> None:
    """The energy of its motion grows by what ring and pocket give, less what slip and the method itself lose."""
    races = races_under((381.0, 297.0), (0.31, 0.22), inner_speed=W, friction=0.13)
    ball, step = np.zeros(1, BALL)[0], 3.1e-8
    ball["contacts"] = races.table[0]
    for name, speed, more in zip(SPEEDS, races.alone.speeds[0], (0.011, -0.007, 0.019, -0.023), strict=True):
        ball[name] = speed + more
    before = np.array([ball[name] for name in SPEEDS])
    mass = BEARING_6205.ball_mass * np.array([1.0, 0.4, 0.4, 0.4])
    impulses = mass * (0.031, -0.017, 0.023, 0.029)
    done = step_ball(races.constants, ball, PocketPush(0.0, 0.0, tuple(impulses.tolist())), step, 1.0)
    after = np.array([ball[name] for name in SPEEDS])
    assert done.settled
    given = done.ring_work - done.slip
    by_pocket = impulses @ (before + after) / 2
    grown = mass @ (after**2 - before**2) / 2
    # Of m (after - before) less the impulses, at the end of the step in place of its mean
    lost = (after - before) @ (mass * (after - before) - impulses) / 2
    assert done.numerical == pytest.approx(lost, rel=1e-6)  # sums of single products
    assert abs(done.numerical) > 1e-3 * abs(given)
    assert grown == pytest.approx(given + by_pocket - done.numerical, rel=1e-6)


def test_a_ball_alone_is_in_balance() -> None:
    """By many strips, where creep is so wide that the kernel's few resolve it."""
    races = races_under((41.6, 55.7), (0.266, 0.182), inner_speed=1500.0, friction=3.0)
    force, lost = balance(races, races.alone.speeds[0], 400)
    assert np.abs(force).max() < 1e-5 * races.limits.min()
    np.testing.assert_allclose(races.alone.slip_power, lost, rtol=1e-5)  # of the strips


def test_a_force_on_a_ball_changes_its_loads_as_the_equilibrium_says() -> None:
    """Against the ball settled between grooves that stand still, by differences; with centrifugal force."""
    races = ring_raceways(BEARING_6205, ANGLE, at(load=310.0), friction=(0.1, 0.1), inertia=Inertia(gyroscopic=False))
    contacts, point = races.contacts, 17
    load, angle = contacts.load[:, point], contacts.contact_angle[:, point]
    stiffness = contacts.contact.stiffness[:, point]
    free = np.array([g.groove_radius - RADIUS for g in (BEARING_6205.inner, BEARING_6205.outer)])
    length = free + (load / stiffness) ** (2 / 3)
    own = np.array([load[0] * np.cos(angle[0]), load[0] * np.sin(angle[0])])
    own = load[1] * np.array([np.cos(angle[1]), np.sin(angle[1])]) - own  # what the ball bears already
    span = length @ np.stack([np.cos(angle), np.sin(angle)], axis=1)

    def settled(force: Array) -> Array:
        place = (float(span[0] - BEARING_6205.groove_centre_distance), float(span[1]))
        softness = (float(stiffness[0] ** (-2 / 3)), float(stiffness[1] ** (-2 / 3)))
        radial, axial = (own + force).tolist()
        ball = settled_ball(grooves_of(BEARING_6205, 0.0), place, softness, (radial, axial), (0.0, 0.0))
        angles = [np.arctan2(arm[1], arm[0]) for arm in (ball.inner_arm, ball.outer_arm)]
        return np.array([ball.inner_load, ball.outer_load, *angles])

    contact = races.table[point]
    for direction, force in zip(("radial", "axial"), 1e-3 * np.eye(2), strict=True):
        by_force = (settled(force) - settled(-force)) / 2e-3
        table = [contact[race][f"{what}_by_{direction}"] for what in ("load", "turn") for race in RACES]
        np.testing.assert_allclose(table, by_force, rtol=1e-5)  # of differences
    # Across the bearing both races share the force, but for the turn of their normals.
    shared = contact["outer"]["load_by_radial"] - contact["inner"]["load_by_radial"]
    np.testing.assert_allclose(shared, np.cos(angle.mean()), rtol=0.01)


def test_a_race_that_the_pocket_unloads_leaves_its_share_to_the_other() -> None:
    races = races_under((40.0, 40.0), (0.3, 0.3), inner_speed=W, friction=0.1)
    constants, at = races.constants, races.table[0]
    light, pressed = pressed_contacts(constants, at, 60.0, 0.0, 1.0)
    lifted = pressed_contacts(constants, at, 200.0, 0.0, 1.0)
    assert 0 < light.limit < 0.1 * 40 < pressed.limit
    assert lifted[0].limit == 0
    # The other race bears what the derivatives give both: the force across the bearing, less what angles turn.
    shared = at["outer"]["load_by_radial"] - at["inner"]["load_by_radial"]
    np.testing.assert_allclose(lifted[1].limit, 0.1 * 200 * shared, rtol=1e-12)
    inward = pressed_contacts(constants, at, -230.0, 0.0, 1.0)
    assert inward[1].limit == 0
    np.testing.assert_allclose(inward[0].limit, 0.1 * 230 * shared, rtol=1e-12)


def test_a_ball_without_any_load_is_refused() -> None:
    with pytest.raises(InputError, match=r"degrees from the radial load is pressed by 0 N: it needs more than 0 N"):
        ring_raceways(BEARING_6205, ANGLE, at(load=700.0, axial=20.0), friction=(0.1, 0.1), inertia=STANDING)


@pytest.mark.parametrize("race", [0, 1])
def test_a_race_without_load_has_the_contact_of_a_slight_one(race: int) -> None:
    """And a force on the ball leaves it without load."""
    loads = [(load, 70.0) if race == 0 else (70.0, load) for load in (0.0, 1e-9)]
    none, slight = (
        races_under(each, (0.31, 0.31), inner_speed=W, friction=0.1).table[0][RACES[race]] for each in loads
    )
    for name in ("width", "creep", "normal_radial", "normal_axial"):
        np.testing.assert_allclose(none[name], slight[name], rtol=1e-6, err_msg=name)
    assert none["load_by_radial"] == none["load_by_axial"] == 0
