"""Physical limits approached from both sides, by other formulas, and what is not in the scene is not checked."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from mpmath import mpf
from scipy.optimize import bisect

from analytic.result import FrictionTorque
from analytic.scene import Arrangement, ContactAngle, Operation, Scene
from analytic.torque import friction_torque
from analytic.verdicts import NumericalCheck, PhysicalCheck, Verdicts, numerical_check, physical_checks
from tests.analytic.specimens import BEARING_6205, OIL, STAMPED_CAGE, present
from tests.validation.hard.hertz_exact import hertz as exact_hertz

ANGLE = 0.23  # rad, given: then the load of each ball is known
PLAIN = {"finite_geometry": "off", "load_distribution": "off", "centrifugal": "off", "weight": "off"}


def scene(load: Any, speed: float = 37.0, **given: Any) -> Scene:
    loads = np.array(load, ndmin=1)
    known: dict[str, Any] = {
        "bearing": BEARING_6205,
        "contact_angle": ContactAngle(rule="given", value=ANGLE),
        "operation": Operation(axial_load=loads, inner_speed=np.full(loads.shape, speed)),
        "friction_coefficient": 0.083,
        "effects": PLAIN,
    }
    return Scene(**(known | given))


def check(found: FrictionTorque, name: str, where: str) -> PhysicalCheck:
    (one,) = [each for each in physical_checks(found) if (each.name, each.where) == (name, where)]
    return one


def hertz(load: float, race: str) -> tuple[float, float]:
    """(peak pressure, b) of one ball by Hertz."""
    bearing, sign = BEARING_6205, {"inner": 1.0, "outer": -1.0}[race]
    groove, r = getattr(bearing, race), bearing.ball_radius
    middle, reach = bearing.pitch_diameter / 2, r * np.cos(ANGLE)
    rolling = 1 / r + sign * np.cos(ANGLE) / (middle - sign * reach)
    across = 1 / r - 1 / groove.groove_radius
    modulus = 1 / sum(
        (1 - body.poisson_ratio**2) / body.youngs_modulus for body in (bearing.ball_material, groove.material)
    )
    found = exact_hertz(*map(mpf, (rolling, across, load, modulus)))
    return float(found["pressure"]), float(found["major"])


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_a_race_fails_where_hertz_reaches_the_static_limit(race: str) -> None:
    """ISO 76: 4.2 GPa. Nine balls share the thrust, Q = Fa/(9 sin al)."""
    each = 9 * np.sin(ANGLE)
    limit = bisect(lambda load: hertz(load / each, race)[0] - 4.2e9, 1e3, 1e5)
    verdicts = []
    for load in (limit * (1 - 1e-5), limit * (1 + 1e-5)):
        found = check(friction_torque(scene([0.3 * limit, load, 0.2 * limit])), "peak_pressure", f"{race} race")
        assert (found.point, found.limit, found.unit) == (1, 4.2e9, "Pa")
        assert found.value == pytest.approx(hertz(load / each, race)[0], rel=1e-6)  # both roots are closer
        verdicts.append(found.verdict)
    assert verdicts == ["pass", "fail"]


def cut(load: float, race: str, half_width: float) -> float:
    """Share of the load beyond the shoulder: Hertz's pressure over strips along rolling, integrated by Gauss."""
    groove = getattr(BEARING_6205, race)
    distance = groove.groove_radius * np.sin(np.arcsin(half_width / groove.groove_radius) - ANGLE)
    t = min(distance / hertz(load / (9 * np.sin(ANGLE)), race)[1], 1.0)
    x, weight = np.polynomial.legendre.leggauss(4)
    y = t + (1 - t) * (x + 1) / 2
    return float(np.sum(weight * (1 - y**2)) * (1 - t) / 2 * 3 / 4)


@pytest.mark.parametrize(("race", "word"), [("inner", "fail"), ("outer", "fail"), ("inner", "unknown")])
def test_a_shoulder_fails_where_it_cuts_off_a_tenth_of_the_load(race: str, word: str) -> None:
    """Where it is not known, one of 0.1 ball diameters counts, and beyond the limit the verdict is unknown."""
    groove, height = getattr(BEARING_6205, race), 0.1 * BEARING_6205.ball_diameter
    half_width = 2.2e-3
    if word == "unknown":
        half_width = float(np.sqrt(groove.groove_radius**2 - (groove.groove_radius - height) ** 2))
    limit = bisect(lambda load: cut(load, race, half_width) - 0.1, 10.0, 1e6)
    changed = replace(groove, shoulder_half_width=None if word == "unknown" else half_width)
    bearing = replace(BEARING_6205, **{race: changed})
    verdicts = []
    for load in (0.999 * limit, 1.001 * limit):
        found = check(friction_torque(scene(load, bearing=bearing)), "shoulder", f"{race} race")
        assert found.value == pytest.approx(cut(load, race, half_width), rel=1e-6)
        verdicts.append(found.verdict)
        assert ("not known" in found.note) == (word == "unknown")
    assert verdicts == ["pass", word]


def test_the_gyroscopic_moment_is_held_until_coulomb_friction_ends() -> None:
    """J w_b w_m sin(beta) against mu (Q_i + Q_o) r: so slow that no inertia moves the loads.

    The axis of balls that turn freely follows as friction lets go.
    """
    slow = 0.023
    given = scene(40.0, speed=slow, contact_angle=ContactAngle(rule="solved"), spin_rule="balanced")

    def hold(speed: float, coefficient: float) -> PhysicalCheck:
        operation = replace(given.operation, inner_speed=np.array([speed]))
        found = friction_torque(replace(given, operation=operation, friction_coefficient=coefficient))
        return check(found, "gyroscopic_hold", "ball")

    one = hold(slow, 0.083)
    assert one.value is not None
    assert hold(2 * slow, 0.083).value == pytest.approx(4 * one.value, rel=1e-9)  # round-off
    limit = 0.083 * one.value
    assert [hold(slow, factor * limit).verdict for factor in (1.001, 0.999)] == ["pass", "fail"]
    result = friction_torque(given)
    hold_by_hand = outer_control_hold(slow, result.contact_angle, result.ball_load)[0]
    assert one.value == pytest.approx(hold_by_hand, rel=1e-9)  # round-off


def outer_control_hold(speed: float, angle: np.ndarray, load: np.ndarray) -> np.ndarray:
    """For one load and angle on both races; tan(beta) = sin(al)/(cos(al) + D/d_m) [Harris2007]."""
    bearing = BEARING_6205
    r, middle = bearing.ball_radius, bearing.pitch_diameter / 2
    lean = np.arctan2(np.sin(angle), np.cos(angle) + r / middle)
    orbit = speed * (1 - r * np.cos(angle) / middle) / 2
    ball = orbit * (middle + r * np.cos(angle)) / (r * np.cos(angle - lean))
    moment = 0.4 * bearing.ball_mass * r**2 * orbit * ball * np.sin(lean)
    return moment / (2 * 0.083 * load * r)


def lubricated(speed: float, load: float, **given: Any) -> Scene:
    return scene(load, speed, lubricant=OIL, **given)


def test_the_sliding_number_is_the_rolling_force_over_coulomb_friction() -> None:
    """From the part of the torque: both races lose 2 f u per ball and race, and pure rolling has u known.

    At a held angle both loads are alike, and mu enters the friction alone: a number of 1 in between.
    """
    ruled = replace(lubricated(190.0, 60.0), spin_rule="balanced")  # balls that roll by closed kinematics
    found = friction_torque(ruled)
    numbers = [check(found, "sliding", f"{race} race") for race in ("inner", "outer")]
    values = np.array([one.value for one in numbers], dtype=float)
    r, middle = BEARING_6205.ball_radius, BEARING_6205.pitch_diameter / 2
    entrainment = (middle**2 - (r * np.cos(ANGLE)) ** 2) / (2 * middle)  # u/w of a ball that rolls, outer ring at rest
    friction = 0.083 * 60.0 / np.sin(ANGLE)  # of all balls on one race
    assert found.torque.rolling is not None
    assert values.sum() * friction * 2 * entrainment == pytest.approx(found.torque.rolling[0], rel=1e-6)
    assert [one.verdict for one in numbers] == ["pass", "pass"]
    assert values.min() > 0
    for factor, verdict in ((1.001, "pass"), (0.999, "fail")):
        mu = 0.083 * values[0] * factor
        slippery = friction_torque(lubricated(190.0, 60.0, friction_coefficient=mu))
        assert check(slippery, "sliding", "inner race").verdict == verdict


def test_the_oil_starves_to_flooded_where_half_of_rolling_is_left() -> None:
    """The speed at which SKF's factor is a half: beyond it the limit is not known, and a warning has the speed."""

    def at(speed: float, **oil: Any) -> FrictionTorque:
        return friction_torque(scene(60.0, speed, lubricant=replace(OIL, **oil)))

    thick = {"viscosity": 1.3}
    first = check(at(150.0, **thick), "replenishment", "oil")
    limit = 150.0 * np.log(2) / present(first.value)
    for factor, verdict in ((0.99, "pass"), (1.01, "unknown")):
        found = at(factor * limit, **thick)
        assert check(found, "replenishment", "oil").verdict == verdict
        said = [warning for warning in found.warnings if "starved to flooded" in warning]
        assert len(said) == (verdict == "unknown")
    assert "50 % of rolling" in said[0]  # 0.5 to the power of 1.01
    given = at(2 * limit, **thick, starvation_degree=1.4)
    assert "replenishment" not in {each.name for each in physical_checks(given)}


@pytest.mark.parametrize(
    ("given", "absent"),
    [
        ({}, {"sliding", "gyroscopic_hold", "cage_force"}),  # neither oil nor cage, and the angle is held
        ({"lubricant": OIL, "effects": PLAIN | {"rolling": "off"}}, {"sliding"}),
        ({"lubricant": OIL, "effects": PLAIN | {"spin": "off", "conformity": "off"}}, {"sliding", "gyroscopic_hold"}),
        ({"cage": STAMPED_CAGE, "effects": PLAIN | {"cage": "off"}}, {"cage_force"}),
        ({"contact_angle": ContactAngle(rule="solved"), "effects": PLAIN | {"gyroscopic": "off"}}, {"gyroscopic_hold"}),
    ],
)
def test_what_is_not_there_is_not_checked(given: dict[str, Any], absent: set[str]) -> None:
    assert not absent & {one.name for one in physical_checks(friction_torque(scene(300.0, **given)))}


def test_the_cage_fails_where_it_needs_more_grip_than_given_balls_have() -> None:
    """A cage at rest: its force does not depend on the friction of the races, and their grip goes with it."""
    held = scene(3.0, cage=replace(STAMPED_CAGE, friction_coefficient=0.2))

    def grip(coefficient: float) -> PhysicalCheck:
        return check(friction_torque(replace(held, friction_coefficient=coefficient)), "cage_force", "cage")

    first = grip(0.083)
    assert first.value is not None
    limit = 0.083 * first.value / 0.9
    assert [grip(factor * limit).verdict for factor in (1.001, 0.999)] == ["pass", "fail"]


def test_of_a_pair_the_worse_bearing_counts() -> None:
    """At 60 N both bearings are pressed, the first one harder; at 900 N the first one alone."""
    both = replace(
        scene([60.0, 900.0], contact_angle=ContactAngle(rule="solved")),
        bearing=replace(BEARING_6205, width=15e-3),
        arrangement=Arrangement(kind="O", preload=150.0),
    )
    found = friction_torque(both)
    assert found.pair is not None
    first, second = found.pair.bearings
    assert first is not None
    assert second is not None
    assert [points.tolist() for points in found.pair.points] == [[0, 1], [0]]
    np.testing.assert_array_equal(found.limits.peak_pressure, first.limits.peak_pressure)
    assert np.all(second.limits.peak_pressure[:, 0] < first.limits.peak_pressure[:, 0])
    assert check(found, "peak_pressure", "inner race").point == 1


def test_accuracy_is_a_verdict_of_its_own() -> None:
    found = friction_torque(scene([200.0, 300.0]))
    sure = replace(found, numerical_uncertainty=np.array([0.031, 0.012]))
    assert numerical_check(sure, tolerance=0.031).verdict == "pass"
    short = numerical_check(sure, tolerance=0.0309)
    assert (short.verdict, short.uncertainty) == ("not reached", 0.031)


def physical(verdict: Any, name: Any = "peak_pressure", where: Any = "inner race") -> PhysicalCheck:
    return PhysicalCheck(name=name, where=where, point=0, value=1.7e9, limit=4.2e9, unit="Pa", verdict=verdict, note="")


SOLVED = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.05)
LOOSE = NumericalCheck(verdict="not reached", uncertainty=0.083, tolerance=0.05)
GOOD, BAD = physical("pass"), physical("fail", "sliding", "outer race")
OPEN = physical("unknown", "cage_force", "cage")


@pytest.mark.parametrize(
    ("compared", "numerical", "checks", "overall", "causes"),
    [
        ({}, SOLVED, (GOOD,), "pass", 1),
        ({"contacts": "pass", "film": "pass"}, None, (GOOD, GOOD), "pass", 1),
        ({"contacts": "outside validity"}, SOLVED, (GOOD,), "fail", 1),
        ({"contacts": "undecided"}, SOLVED, (GOOD,), "undecided", 1),
        ({"contacts": "pass", "film": "undecided"}, SOLVED, (GOOD,), "undecided", 1),
        ({"contacts": "undecided", "film": "pass", "friction": "fail"}, SOLVED, (GOOD,), "fail", 1),
        ({}, LOOSE, (GOOD,), "undecided", 1),
        ({}, SOLVED, (OPEN, GOOD), "undecided", 1),
        ({"contacts": "fail"}, LOOSE, (GOOD, BAD, OPEN, BAD), "fail", 2),  # the failures alone, each once
        ({"contacts": "undecided", "film": "undecided"}, LOOSE, (GOOD, OPEN), "undecided", 4),
    ],
)
def test_the_most_serious_verdict_counts_with_its_causes(
    compared: Any, numerical: NumericalCheck | None, checks: tuple[PhysicalCheck, ...], overall: str, causes: int
) -> None:
    found = Verdicts(numerical=numerical, physical=checks, compared=compared)
    assert found.overall == overall
    assert len(found.reason.split("; ")) == causes
