"""What the kernel sums over balls and races: powers, shares and limits, against the balls themselves."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad
from scipy.optimize import brentq
from scipy.special import ellipe

from analytic.cage.drive import ball_lead, resting_cage
from analytic.contact.geometry import cut_off_share
from analytic.loads.kinematics import ball_kinematics
from analytic.loads.thrust import thrust_equilibrium
from analytic.scene import STANDARD_GRAVITY, Array, Bearing, ContactAngle, Losses, Operation, Scene
from analytic.solve.model import model_of
from analytic.solve.records import NO_DISTRIBUTION, NO_THRUST, POINT, SETTLED, THROWN, THROWN_WASHERS
from analytic.solve.solution import Solution, points_of, solved
from analytic.torque import friction_torque
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, STAMPED_CAGE, present, with_clearance
from tests.analytic.test_thrust_bearing import BEARING as THRUST_BEARING
from tests.analytic.test_thrust_bearing import RIGHT

STEEP = ContactAngle(rule="solved", free=0.52)
ROLLING = {"spin": True, "conformity": True, "hysteresis": True, "rolling": True, "load_distribution": True}
UNEQUAL: dict[str, Any] = {"axial_load": 640.0, "radial_load": 170.0, "moment": 0.9, "inner_speed": 210.0}


def scene_of(bearing: Bearing = BEARING_6205, *, angle: ContactAngle = STEEP, **operation: Any) -> Scene:
    """A bearing with a coefficient of 0.07 and oil."""
    return Scene(
        bearing=bearing,
        contact_angle=angle,
        operation=Operation(**operation).as_series(),
        lubricant=OIL,
        friction_coefficient=0.07,
        hysteresis_loss=0.0085,
        spin_rule="outer_control",
    )


def found_at(scene: Scene, counted: dict[str, bool]) -> Solution:
    model = model_of(scene, counted, free=False)
    return solved(model, points_of(scene.operation, model.temperature))


@pytest.fixture(scope="module")
def unequal() -> Solution:
    return found_at(scene_of(**UNEQUAL), ROLLING)


def test_a_ring_of_equal_balls_is_one_ball_that_stands_for_all() -> None:
    """Every sum and every limit; a radial load that is nothing asks for the ring."""
    scene = scene_of(axial_load=np.array([430.0, 900.0]), inner_speed=np.array([61.0, -350.0]))
    slight = scene_of(axial_load=scene.operation.axial_load, inner_speed=scene.operation.inner_speed, radial_load=1e-12)
    alone, ring = found_at(scene, ROLLING), found_at(slight, ROLLING)
    assert (alone.balls.shape, ring.balls.shape) == ((2, 1), (2, 9))
    for name in present(POINT.names):
        # Of one ball, of the way, and the number of the heaviest of equal balls, which rounding decides.
        if name not in (
            "lead_across",
            "slowness",
            "steps",
            "left",
            "tolerance",
            "residual",
            "holding_moment",
            "heaviest",
        ):
            # The ring settles to 1e-11 of its forces; balls that are alike lead by rounding of the pitch diameter, and
            # hold the ring by that of their forces.
            np.testing.assert_allclose(ring.points[name], alone.points[name], rtol=1e-7, atol=1e-14, err_msg=name)
    np.testing.assert_allclose(ring.points["slowness"], 9 * alone.points["slowness"], rtol=1e-9)


@pytest.mark.parametrize("out", ["spin", "conformity", "hysteresis", "rolling"])
def test_the_total_is_the_sum_of_what_counts(out: str) -> None:
    scene = replace(scene_of(**UNEQUAL), losses=Losses(seals=3e-3, drag=0.8e-3))
    point = found_at(scene, {**ROLLING, out: False}).points[0]
    assert point[out] == 0
    parts = [name for name in ("spin", "conformity", "hysteresis", "rolling") if name != out]
    assert all(point[name] > 0 for name in parts)
    np.testing.assert_allclose(point["total"], sum(point[name] for name in parts) + 3.8e-3, rtol=1e-14)


def test_rates_are_means_over_the_balls(unequal: Solution) -> None:
    point, balls = unequal.points[0], unequal.balls[0]
    orbit = balls["motion"]["cage_speed"]
    np.testing.assert_allclose(point["orbit_rate"], orbit.mean(), rtol=1e-14)
    np.testing.assert_allclose(point["ball_rate"], balls["motion"]["ball_speed"].mean(), rtol=1e-14)
    np.testing.assert_allclose(point["contact_angle"], balls["angle"].mean(), rtol=1e-14)
    lead = ball_lead(orbit, pitch_radius=BEARING_6205.pitch_diameter / 2)
    np.testing.assert_allclose(point["ball_lead"], lead, rtol=1e-9)  # of a small difference
    assert abs(lead) > 1e-6
    assert point["heaviest"] == balls["load"].max(axis=1).argmax()


def test_balls_lead_along_the_whole_first_harmonic() -> None:
    """A weight across the radial load has its part in cos(psi), which no load along x has."""
    light = scene_of(axial_load=31.0, radial_load=0.13, inner_speed=210.0)
    scene = replace(light, down=(0.0, 0.6, 0.8))
    found = found_at(scene, ROLLING | {"weight": True})
    orbit = found.balls["motion"]["cage_speed"][0]
    radius = BEARING_6205.pitch_diameter / 2
    lead = ball_lead(orbit, pitch_radius=radius)
    np.testing.assert_allclose(found.points["ball_lead"][0], lead, rtol=1e-9)  # of a small difference
    azimuth = 2 * np.pi * np.arange(orbit.size) / orbit.size
    along = 2 * radius * abs(np.sum(np.cos(azimuth) / orbit) / np.sum(1 / orbit))
    assert along < (1 - 1e-6) * abs(lead)  # else the part across would not show; 5e-6 here


def test_limits_are_those_of_the_worst_ball(unequal: Solution) -> None:
    point, balls = unequal.points[0], unequal.balls[0]
    assert np.ptp(balls["peak_pressure"], axis=0).min() > 1e7
    np.testing.assert_array_equal(point["peak_pressure"], balls["peak_pressure"].max(axis=0))
    narrow = replace(
        BEARING_6205,
        inner=replace(BEARING_6205.inner, shoulder_half_width=2.8e-3),
        outer=replace(BEARING_6205.outer, shoulder_half_width=2.9e-3),
    )
    cut = found_at(scene_of(narrow, **UNEQUAL), ROLLING)
    pairs = cut.balls[0][["shoulder_distance", "semi_axis_transverse"]]
    shares = [[cut_off_share(float(d), float(b)) for d, b in zip(*map(tuple, each), strict=True)] for each in pairs]
    assert np.ptp(shares, axis=0).min() > 0.01
    np.testing.assert_allclose(cut.points["cut_off"][0], np.max(shares, axis=0), rtol=1e-14)


def test_forces_of_a_ball_are_compared_with_the_smaller_of_its_loads() -> None:
    """That on the inner race, from which the centrifugal force lifts it."""
    fast: dict[str, Any] = UNEQUAL | {"inner_speed": 900.0}
    found = found_at(scene_of(**fast), {**ROLLING, "centrifugal": True})
    point, balls, bearing = found.points[0], found.balls[0], BEARING_6205
    least, most = balls["load"].min(axis=1), balls["load"].max(axis=1)
    assert np.min(least / most) < 0.95
    orbit = 900.0 * balls["motion"]["cage_speed"]
    outward = bearing.ball_mass * bearing.pitch_diameter / 2 * orbit**2
    np.testing.assert_allclose(point["centrifugal_share"], np.max(outward / least), rtol=1e-12)
    np.testing.assert_allclose(point["weight_share"], np.max(bearing.ball_mass * STANDARD_GRAVITY / least), rtol=1e-12)


def test_spin_alone_is_the_pivoting_of_every_ball_on_its_inner_race() -> None:
    """3/8 mu Q b E(m), at the whole difference of spin where the outer race controls the balls."""
    found = found_at(scene_of(**UNEQUAL), {"spin": True, "load_distribution": True})
    balls = found.balls[0]
    a, b = balls["semi_axis_rolling"][:, 0], balls["semi_axis_transverse"][:, 0]
    moments = 3 / 8 * 0.07 * balls["load"][:, 0] * b * ellipe(1 - (a / b) ** 2)
    power = np.sum(moments * np.abs(balls["motion"]["spin_difference"]))
    # The curvature of the contact adds slip across that of spin, and takes from it where spin is slow.
    np.testing.assert_allclose(found.points["spin"], power, rtol=0.05)


def test_conformity_alone_is_the_slip_of_curved_contacts_without_a_net_force() -> None:
    """Heathcote's slip of long ellipses: mu p w_r |y^2 - y_0^2|/(2 R), where as much pulls forwards as backwards."""
    found = found_at(scene_of(**UNEQUAL), {"conformity": True, "load_distribution": True})
    still = brentq(lambda share: share - share**3 / 3 - 1 / 3, 0.0, 1.0)  # y_0/b, which halves the load
    slides, _ = quad(lambda share: 1.5 * (1 - share**2) * abs(share**2 - still**2), 0.0, 1.0, points=[still])
    balls, power = found.balls[0], 0.0
    for race, ring in enumerate((BEARING_6205.inner, BEARING_6205.outer)):
        radius = 2 / (1 / BEARING_6205.ball_radius + 1 / ring.groove_radius)
        rate = np.abs(balls["motion"][f"{'inner' if race == 0 else 'outer'}_rolling_rate"])
        slip = rate * balls["semi_axis_transverse"][:, race] ** 2 / (2 * radius) * slides
        power += np.sum(0.07 * balls["load"][:, race] * slip)
    # The turn by conformity adds 15 % at most where contacts are four times as long as wide (test_ellipse.py).
    assert 1 < found.points["conformity"][0] / power < 1.15


def moment_of(balls: Any, bearing: Bearing, speed: float) -> Array:
    """Gyroscopic moment 2/5 m r^2 w_b w_c sin(pitch) of each ball, N m."""
    motion = balls["motion"]
    inertia = 2 / 5 * bearing.ball_mass * bearing.ball_radius**2
    return np.abs(inertia * motion["ball_speed"] * motion["cage_speed"] * speed**2 * np.sin(motion["pitch"]))


def test_a_ball_is_held_by_the_friction_of_both_races(unequal: Solution) -> None:
    balls, bearing = unequal.balls[0], BEARING_6205
    arm = bearing.ball_radius * 0.07 * balls["load"].sum(axis=1)
    np.testing.assert_allclose(balls["gyroscopic_hold"], moment_of(balls, bearing, 210.0) / arm, rtol=1e-9)
    smooth = replace(scene_of(**UNEQUAL), friction_coefficient=0.0)
    nothing = found_at(smooth, ROLLING).balls[0]
    assert np.all(np.isinf(nothing["gyroscopic_hold"]))
    still = found_at(replace(smooth, operation=replace(smooth.operation, inner_speed=np.zeros(1))), ROLLING).balls[0]
    assert not np.any(still["gyroscopic_hold"])


def test_balls_at_the_edge_of_the_loaded_zone_need_no_hold() -> None:
    """Of balls with less than a tenth of the heaviest load, which hardly anything holds, none decides."""
    found = found_at(scene_of(axial_load=210.0, radial_load=150.0, inner_speed=400.0, tilt="free"), ROLLING)
    point, balls = found.points[0], found.balls[0]
    load = balls["load"].max(axis=1)
    light = load < 0.1 * load.max()
    assert 0 < np.count_nonzero(light) < 9
    inside = balls["gyroscopic_hold"][~light].max()
    assert balls["gyroscopic_hold"][light].max() > inside
    assert point["gyroscopic_hold"] == inside


@pytest.mark.parametrize("factor", [0.999, 1.001])
def test_balls_are_thrown_beyond_a_thousand_times_their_load(factor: float) -> None:
    """By the speed at which the centrifugal force of a ball is that many times its load at rest."""
    axial, angle = 0.31, ContactAngle(rule="solved", free=0.26)
    rest = thrust_equilibrium(BEARING_6205, angle, axial_load=axial)
    al = float(rest["angle"][0])
    motion = ball_kinematics(1.0, al, al, BEARING_6205.pitch_diameter, BEARING_6205.ball_diameter)
    unit = BEARING_6205.ball_mass * BEARING_6205.pitch_diameter / 2 * float(motion.cage_speed) ** 2
    speed = factor * np.sqrt(1000 * float(rest["load"][0]) / unit)
    point = found_at(scene_of(angle=angle, axial_load=axial, inner_speed=speed), {"centrifugal": True}).points[0]
    assert (point["status"] == THROWN) == (factor > 1)
    if factor > 1:
        np.testing.assert_allclose(point["left"], 1000 * factor**2, rtol=1e-8)  # of the equilibrium at rest
    without = found_at(scene_of(angle=angle, axial_load=axial, inner_speed=speed), {}).points[0]
    assert without["status"] == SETTLED


@pytest.mark.parametrize("factor", [0.999, 1.001])
def test_balls_leave_the_middle_of_washers_beyond_a_tenth_of_their_load(factor: float) -> None:
    bearing, axial = THRUST_BEARING, 45.0
    unit = bearing.ball_mass * bearing.pitch_diameter / 2 / 4  # at half of the washer's speed
    speed = factor * np.sqrt(0.1 * axial / bearing.ball_count / unit)
    point = found_at(scene_of(bearing, angle=RIGHT, axial_load=axial, inner_speed=speed), {}).points[0]
    assert (point["status"] == THROWN_WASHERS) == (factor > 1)


@pytest.mark.parametrize("factor", [0.999, 1.001])
@pytest.mark.parametrize("name", ["radial_load", "moment"])
def test_unequal_loads_press_the_heaviest_ball_as_stribeck_has_it(factor: float, name: str) -> None:
    """4.37 Fr/Z, of a moment M the force M/d_m; without thrust at the angle of the unloaded bearing."""
    load: Any = {"radial_load": 2.3, "moment": 2.3 * BEARING_6205.pitch_diameter}[name]
    pressing = 4.37 * 2.3 / BEARING_6205.ball_count
    reach = BEARING_6205.ball_radius * 2 * np.cos(STEEP.free or 0.0)
    orbit = (1 - reach / BEARING_6205.pitch_diameter) / 2
    unit = BEARING_6205.ball_mass * BEARING_6205.pitch_diameter / 2 * orbit**2
    speed = factor * np.sqrt(1000 * pressing / unit)
    scene = scene_of(**{"axial_load": 0.0, "inner_speed": speed, name: load})
    point = found_at(scene, {"centrifugal": True, "load_distribution": True}).points[0]
    assert (point["status"] == THROWN) == (factor > 1)


def test_a_ball_on_the_outer_race_alone_does_not_come_off() -> None:
    """Its centrifugal force holds it there in the unloaded half of a bearing with clearance."""
    loads = {"axial_load": 0.0, "radial_load": 900.0, "inner_speed": 400.0}
    scene = scene_of(with_clearance(BEARING_6205, 40e-6), angle=ContactAngle(rule="solved"), **loads)
    found = found_at(scene, ROLLING | {"centrifugal": True})
    inner, outer = found.balls["load"][0].T
    assert found.points["status"][0] == SETTLED
    assert (outer > 0).all()
    assert (inner == 0).any()
    assert inner[inner > 0].min() > 1.5 * BEARING_6205.ball_mass * STANDARD_GRAVITY


def test_a_temperature_belongs_to_its_point() -> None:
    """Each point has the viscosity of its own oil, whatever stood before it."""
    scene = replace(
        scene_of(axial_load=np.array([310.0, 310.0, 470.0]), inner_speed=np.array([31.0, 31.0, 47.0])),
        surface=FINISH,
        friction_coefficient=None,
    )
    model = model_of(scene, ROLLING | {"asperities": True}, free=False)
    points = points_of(scene.operation, model.temperature)
    points[1:, 4] += [21.0, -13.0]
    together = solved(model, points).points["total"]
    apart = [
        solved(model_of(scene, ROLLING | {"asperities": True}, free=False), points[[i]]).points["total"][0]
        for i in range(3)
    ]
    np.testing.assert_allclose(together, apart, rtol=1e-9)  # of fits that begin where the last point was
    assert together[0] != together[1]


def test_grease_starves_by_the_share_of_thrust_in_the_load_of_a_point() -> None:
    grease = replace(OIL, supply="grease")
    loads: dict[str, Any] = {"axial_load": np.array([310.0, 310.0]), "radial_load": np.array([20.0, 290.0])}
    scene = replace(scene_of(**loads, inner_speed=63.0), lubricant=grease)
    counted = ROLLING | {"starvation": True}
    together = found_at(scene, counted).points["rolling"]
    alone = [
        found_at(replace(scene, operation=Operation(
            axial_load=loads["axial_load"][[i]], radial_load=loads["radial_load"][[i]], inner_speed=np.array([63.0])
        )), counted).points["rolling"][0]
        for i in range(2)
    ]  # fmt: skip
    np.testing.assert_allclose(together, alone, rtol=1e-12)


@pytest.mark.parametrize("coefficient", [0.13, None])  # None: of the film in its pockets, at the speed of the balls
def test_a_cage_at_rest_on_its_balls_is_that_beside_the_kernel(coefficient: float | None) -> None:
    """And it has no torque once balls lead as far as its pockets leave free."""
    light: dict[str, Any] = UNEQUAL | {"radial_load": 40.0, "moment": 0.3}
    cage = replace(STAMPED_CAGE, friction_coefficient=coefficient)
    scene = replace(scene_of(**light), cage=cage, friction_coefficient=None, surface=FINISH)
    out = ("cage_dynamics", "ball_dynamics", "centrifugal", "gyroscopic", "finite_geometry", "weight", "unloaded_balls")
    effects: dict[str, Any] = dict.fromkeys(out, "off")
    effects |= {"inlet_heating": "off", "starvation": "off", "creep": "off"}
    series = friction_torque(replace(scene, effects=effects))
    counted = ROLLING | {"cage": True}
    point = found_at(scene, counted).points[0]
    np.testing.assert_allclose(point["cage"], present(series.torque.cage)[0], rtol=1e-8)  # of the ring's balance
    np.testing.assert_allclose(
        point["total"], sum(point[name] for name in ("spin", "conformity", "hysteresis", "rolling", "cage")), rtol=1e-14
    )
    lead = abs(float(point["ball_lead"]))
    for factor, is_squeezed in ((0.999, True), (1.001, False)):
        pocket = BEARING_6205.ball_diameter + factor * lead
        tight = replace(present(scene.cage), pocket_diameter=pocket, pocket_depth=pocket / 2)
        np.testing.assert_allclose(resting_cage(BEARING_6205, tight).room, factor * lead, rtol=1e-9)
        found = found_at(replace(scene, cage=tight), counted).points[0]
        assert np.isnan(found["cage"]) == np.isnan(found["total"]) == is_squeezed


def test_loads_of_no_thrust_are_told_apart(bearing_6205: Bearing) -> None:
    cases: tuple[tuple[dict[str, Any], dict[str, bool], int], ...] = (
        ({"axial_load": 0.0}, {}, NO_THRUST),
        ({"axial_load": 0.0, "radial_load": 30.0}, {}, NO_DISTRIBUTION),
        ({"axial_load": 0.0, "moment": -0.3}, {}, NO_DISTRIBUTION),
        ({"axial_load": 0.0, "radial_load": 30.0}, {"load_distribution": True}, SETTLED),
    )
    for loads, counted, status in cases:
        point = found_at(scene_of(bearing_6205, **loads, inner_speed=7.0), counted).points[0]
        assert point["status"] == status
        assert np.isnan(point["total"]) == (status != SETTLED)
