"""What nothing computes is listed with its number, and warned of past its limit and not before."""

import re
from dataclasses import replace

import numpy as np
import pytest

from analytic.effects.table import LIMITS, PER_CUT_SHARE
from analytic.loads.inertia import gyroscopic_slip_ratio
from analytic.loads.ring import ring_equilibrium
from analytic.result import FrictionTorque
from analytic.scene import Bearing, Cage, ContactAngle, Operation, Scene
from analytic.torque import friction_torque


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    """1000 N at 0.18 rad: b = 1.1222 mm, p0 = 2.1831 GPa inside, sliding number 6.459 outside (computed elsewhere)."""
    return Scene(
        name="test",
        tolerance=0.05,
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="given", value=0.18),
        operation=Operation(axial_load=np.array([300.0, 1000.0]), inner_speed=np.array([31.0, 52.36])),
        cage=Cage(
            pocket_diameter=8.14e-3,
            pocket_depth=4.07e-3,
            wall_thickness=0.9e-3,
            mass=6.58e-3,
            material=bearing_6205.ball_material,
        ),
        friction_coefficient=0.1,
        hysteresis_loss=0.007,
        effects={"finite_geometry": "off", "spin": "on"},
    )


def reason_of(found: FrictionTorque, name: str) -> str:
    effect = next(effect for effect in found.effects if effect.name == name)
    assert effect.decision == "off"
    return effect.reason


def numbers_in(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?", text)]


def test_every_checked_effect_is_listed_with_its_number(scene: Scene) -> None:
    found = friction_torque(scene)
    assert {effect.name for effect in found.effects} >= set(LIMITS)
    peak, share, limit = numbers_in(reason_of(found, "plasticity"))
    np.testing.assert_allclose([peak, share], [2.1831e9, 2.1831 / 4.2], rtol=5e-4)  # four and three digits
    assert limit == 4.2e9
    axis, distance = numbers_in(reason_of(found, "shoulder"))
    # r_g sin(asin(w/r_g) - al), inner: 4.13 sin(asin(3.1/4.13) - 0.18) = 2.561 mm
    np.testing.assert_allclose([axis, distance], [1.1222e-3, 2.561e-3], rtol=5e-4)
    # the sliding number falls with the load's cube root: least at 300 N
    number, limit = numbers_in(reason_of(found, "elastic_creep"))
    np.testing.assert_allclose(number, 6.459 * 0.3 ** (1 / 3), rtol=5e-3)  # three digits
    assert limit == 3
    words = " ".join(found.warnings)
    for word in ("static limit", "sliding number", "shoulder", "gyroscopic"):
        assert word not in words


def test_nothing_slides_and_no_cage(scene: Scene) -> None:
    found = friction_torque(replace(scene, cage=None, effects={"spin": "off", "conformity": "off"}))
    assert reason_of(found, "elastic_creep") == "nothing slides"
    assert reason_of(found, "cage") == "no cage is given: add a table [cage]"


def test_each_limit_is_warned_of_when_it_is_passed(scene: Scene) -> None:
    def warned(load: float, word: str, mu: float = 0.1) -> bool:
        series = Operation(axial_load=np.array([load]), inner_speed=np.array([31.0]))
        found = friction_torque(replace(scene, operation=series, friction_coefficient=mu))
        return any(word in warning for warning in found.warnings)

    # cube roots from 1000 N: p0 reaches 4.2 GPa at 1000 (4.2/2.1831)^3 = 7121 N, b the distance of 2.561 mm at 11885 N,
    # and the sliding number falls below 3 with mu above 0.1 x 6.459/3 = 0.2153
    assert [warned(load, "static limit") for load in (7100.0, 7140.0)] == [False, True]
    assert [warned(load, "inner race's shoulder") for load in (11840.0, 11930.0)] == [False, True]
    assert [warned(1000.0, "sliding number of the outer", mu) for mu in (0.2145, 0.216)] == [False, True]


def test_a_plastic_contact_has_no_known_uncertainty(scene: Scene) -> None:
    """At the point where it is plastic, past 7121 N, and with its reason."""
    series = Operation(axial_load=np.array([7100.0, 7140.0]), inner_speed=np.array([31.0, 31.0]))
    found = friction_torque(replace(scene, operation=series))
    np.testing.assert_array_equal(np.isinf(found.numerical_uncertainty), [False, True])
    (reason,) = found.unknown
    assert "static limit" in reason
    document = found.to_json()
    assert document["unknown"] == [reason]
    assert [point["uncertainty"]["numerical"] is None for point in document["points"]] == [False, True]
    assert friction_torque(scene).unknown == ()


def test_what_a_shoulder_cuts_off_is_uncertain_and_then_unknown(scene: Scene) -> None:
    """With b = 1.1222 mm inside at 1000 N and the room r_g sin(asin(w/r_g) - al) to a shoulder at w."""

    def narrowed(room: float) -> FrictionTorque:
        groove = scene.bearing.inner.groove_radius
        width = groove * np.sin(0.18 + np.arcsin(room / groove))
        bearing = replace(scene.bearing, inner=replace(scene.bearing.inner, shoulder_half_width=float(width)))
        return friction_torque(replace(scene, bearing=bearing))

    whole, cut, torn = (narrowed(t * 1.1222e-3) for t in (1.01, 0.75, 0.55))
    y = np.linspace(0.75, 1, 10001)
    beyond = 0.75 * np.trapezoid(1 - y**2, y)  # of Hertz's parabola with unit load
    grown = cut.numerical_uncertainty - whole.numerical_uncertainty
    np.testing.assert_allclose(
        grown, np.array([0.0, PER_CUT_SHARE * beyond]), rtol=2e-3, atol=1e-15
    )  # b has five digits
    assert whole.unknown == cut.unknown == ()
    assert np.isinf(torn.numerical_uncertainty[1])
    assert "shoulder cuts off 0.1" in torn.unknown[0]


def test_a_ball_that_friction_cannot_hold_is_warned_of(scene: Scene) -> None:
    """Against the moment of Euler's equation that the equilibrium of the ring returns, which friction with the arm r
    has to carry."""
    solved = replace(
        scene,
        contact_angle=ContactAngle(rule="solved", free=0.3),
        effects={"finite_geometry": "off", "centrifugal": "on", "gyroscopic": "on"},
        operation=Operation(axial_load=np.array([200.0]), inner_speed=np.array([2100.0])),
    )
    ring = ring_equilibrium(solved.bearing, solved.contact_angle, axial_load=200.0, inner_speed=2100.0)
    needed = np.max(ring.gyroscopic_moment / 3.97e-3 / (ring.inner_load + ring.outer_load))
    for factor, warned in ((1.02, False), (0.98, True)):
        found = friction_torque(replace(solved, friction_coefficient=float(factor * needed)))
        about = [warning for warning in found.warnings if "gyroscopic moment" in warning]
        assert bool(about) == warned
        if warned:
            np.testing.assert_allclose(numbers_in(about[0])[0], 1 / 0.98, rtol=5e-3)  # three digits


def test_gyroscopic_slip_is_moment_over_arm_times_friction() -> None:
    """By hand: J = 0.4 x 2.04e-3 x 3.97e-3^2 = 1.28609e-8 kg m^2."""
    ball = {"ball_mass": 2.04e-3, "ball_radius": 3.97e-3, "ball_speed": 5000.0, "cage_speed": 820.0}
    found = gyroscopic_slip_ratio(contact_angle=[0.0, 0.31], friction_force=7.3, **ball)
    moment = 1.28609e-8 * 5000 * 820 * 0.305059
    np.testing.assert_allclose(found, [0.0, moment / (3.97e-3 * 7.3)], rtol=1e-5)  # six digits
    assert gyroscopic_slip_ratio(contact_angle=0.31, friction_force=0.0, **ball) == np.inf
