"""What nothing computes is listed with its number, and warned of past its limit and not before."""

import re
from dataclasses import replace

import numpy as np
import pytest

from analytic.effects.limits import LimitNumbers
from analytic.effects.table import LIMITS, PER_CUT_SHARE
from analytic.result import FrictionTorque
from analytic.scene import Bearing, ContactAngle, Operation, Scene
from analytic.torque import friction_torque
from tests.analytic.specimens import STAMPED_CAGE, effect_of


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    """1000 N at 0.18 rad: b = 1.1222 mm, p0 = 2.1831 GPa inside, sliding number 6.459 outside (computed elsewhere)."""
    return Scene(
        name="test",
        tolerance=0.05,
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="given", value=0.18),
        operation=Operation(axial_load=np.array([300.0, 1000.0]), inner_speed=np.array([31.0, 52.36])),
        cage=STAMPED_CAGE,
        friction_coefficient=0.1,
        hysteresis_loss=0.007,
        effects={"finite_geometry": "off", "spin": "on"},
    )


def reason_of(found: FrictionTorque, name: str) -> str:
    effect = effect_of(found, name)
    assert effect.decision == "off"
    return effect.reason


def numbers_in(text: str) -> list[float]:
    return [float(number) for number in re.findall(r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?", text)]


def test_every_checked_effect_is_listed_with_its_number(scene: Scene) -> None:
    found = friction_torque(scene)
    assert {effect.name for effect in found.effects} >= set(LIMITS)
    peak, share, limit = numbers_in(reason_of(found, "plasticity"))
    np.testing.assert_allclose([peak, share], [2.1831, 100 * 2.1831 / 4.2], rtol=5e-4)  # GPa, %; four, three digits
    assert limit == 4.2
    axis, distance = numbers_in(reason_of(found, "shoulder"))
    # r_g sin(asin(w/r_g) - al), inner: 4.13 sin(asin(3.1/4.13) - 0.18) = 2.561 mm
    np.testing.assert_allclose([axis, distance], [1.1222, 2.561], rtol=5e-4)  # mm
    words = " ".join(found.warnings)
    for word in ("static limit", "shoulder"):
        assert word not in words


def test_each_limit_is_warned_of_when_it_is_passed(scene: Scene) -> None:
    def warned(load: float, word: str) -> bool:
        series = Operation(axial_load=np.array([load]), inner_speed=np.array([31.0]))
        found = friction_torque(replace(scene, operation=series))
        return any(word in warning for warning in found.warnings)

    # cube roots from 1000 N: p0 reaches 4.2 GPa at 1000 (4.2/2.1831)^3 = 7121 N, b the distance of 2.561 mm at 11885 N
    assert [warned(load, "static limit") for load in (7100.0, 7140.0)] == [False, True]
    assert [warned(load, "shoulder of the inner race") for load in (11840.0, 11930.0)] == [False, True]


def test_a_plastic_contact_has_no_known_uncertainty(scene: Scene) -> None:
    """At the point where it is plastic, past 7121 N, and with its reason."""
    series = Operation(axial_load=np.array([7100.0, 7140.0]), inner_speed=np.array([31.0, 31.0]))
    found = friction_torque(replace(scene, operation=series))
    np.testing.assert_array_equal(np.isinf(found.numerical_uncertainty), [False, True])
    (reason,) = found.unknown
    assert "static limit" in reason
    assert [point.uncertainty.numerical is None for point in found.rows] == [False, True]
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
    assert "shoulder cuts off 1" in torn.unknown[0]


def shouldered(scene: Scene, near: float | None, far: float | None = None) -> Scene:
    inner, outer = (
        replace(groove, shoulder_half_width=near, far_shoulder_half_width=far)
        for groove in (scene.bearing.inner, scene.bearing.outer)
    )
    return replace(scene, bearing=replace(scene.bearing, inner=inner, outer=outer))


def test_an_unknown_shoulder_is_said_and_undecided_where_a_low_one_would_cut(scene: Scene) -> None:
    """One of 0.1 ball diameters stands r_g sin(acos(1 - 0.1 D/r_g) - al) away: 1.81 mm inside at 0.18 rad."""
    light = friction_torque(shouldered(scene, None))
    reason = reason_of(light, "shoulder")
    assert "shoulder not known: give bearing.inner.shoulder_height and bearing.outer.shoulder_height" in reason
    assert light.unknown == ()  # b = 1.1222 mm ends before the lowest
    np.testing.assert_allclose(light.numerical_uncertainty, friction_torque(scene).numerical_uncertainty, rtol=1e-12)
    given = replace(scene, contact_angle=ContactAngle(rule="given", value=0.42))
    steep = friction_torque(shouldered(given, None))  # 0.96 mm inside, and b = 0.845 mm at 1000 N
    assert steep.unknown == ()
    heavy = replace(
        given, operation=Operation(axial_load=np.array([300.0, 5500.0]), inner_speed=np.array([31.0, 31.0]))
    )
    torn = friction_torque(shouldered(heavy, None))  # b = 1.49 mm
    np.testing.assert_array_equal(np.isinf(torn.numerical_uncertainty), [False, True])
    (why,) = torn.unknown
    assert why.startswith("shoulder not known: a low one, 0.1 ball diameters high, cuts off 1")
    assert torn.row(1).uncertainty.numerical is None


def test_the_far_shoulder_cuts_too(scene: Scene) -> None:
    """A groove that is cylindrical from its bottom on: r_g sin(0.18) = 0.739 mm away inside, b = 1.1222 mm."""
    found = friction_torque(shouldered(scene, 3.1e-3, 0.0))
    axis, distance = numbers_in(reason_of(found, "shoulder"))
    np.testing.assert_allclose([axis, distance], [1.1222, 4.13 * np.sin(0.18)], rtol=5e-4)  # mm
    t = 4.13e-3 * np.sin(0.18) / 1.1222e-3
    grown = found.numerical_uncertainty[1] - friction_torque(scene).numerical_uncertainty[1]
    np.testing.assert_allclose(grown, PER_CUT_SHARE * (2 - 3 * t + t**3) / 4, rtol=2e-3)  # b has five digits
    assert any("exceeds the shoulder of the inner race" in warning for warning in found.warnings)


def test_the_torque_with_unknown_shoulders_is_more_uncertain(scene: Scene) -> None:
    """By what a contact corrected for other shoulders does: they move its approach, and so the angle that it takes."""
    solved = ContactAngle(rule="solved", free=0.18)
    ruled = replace(scene, contact_angle=solved, spin_rule="balanced", sliding="over_ellipse", effects={})
    known, unknown = friction_torque(ruled), friction_torque(shouldered(ruled, None))
    grown = unknown.numerical_uncertainty - known.numerical_uncertainty
    assert ((grown > 0) & (grown < 0.01)).all()
    apart = []
    for height in (0.1, 0.25):  # of ball diameters: the lowest and the highest usual ones
        rings = {}
        for name in ("inner", "outer"):
            groove = getattr(ruled.bearing, name)
            depth = 1 - height * ruled.bearing.ball_diameter / groove.groove_radius
            rings[name] = replace(groove, shoulder_half_width=groove.groove_radius * np.sqrt(1 - depth**2))
        other = friction_torque(replace(ruled, bearing=replace(ruled.bearing, **rings)))
        apart.append(np.abs(unknown.torque.total / other.torque.total - 1))
    # The farther one is the uncertainty, which is of the unknown torque: apart itself in the second order.
    np.testing.assert_allclose(grown, np.max(apart, axis=0), rtol=0.1, atol=1e-6)


def test_of_several_bearings_the_worst_counts_at_each_point() -> None:
    numbers = LimitNumbers(
        peak_pressure=np.array([[1.0e9, 2.0e9, 3.0e9], [1.5e9, 0.5e9, 2.5e9]]),
        cut_off=np.array([[0.0, 0.02, 0.01], [0.03, 0.0, 0.0]]),
        knows_shoulder=np.array([True, False]),
        gyroscopic_hold=np.array([0.2, 0.7, 0.4]),
    )
    rows, points = (np.array([0, 2]), np.array([1])), (np.array([0, 1]), np.array([1]))
    worst = numbers.worst(rows, points, 3)
    np.testing.assert_array_equal(worst.peak_pressure, [[1.0e9, 3.0e9, 0.0], [1.5e9, 2.5e9, 0.0]])
    np.testing.assert_array_equal(worst.cut_off, [[0.0, 0.02, 0.0], [0.03, 0.0, 0.0]])
    np.testing.assert_array_equal(worst.gyroscopic_hold, [0.2, 0.7, 0.0])  # pyright: ignore[reportArgumentType]
    assert worst.sliding_number is None
    np.testing.assert_array_equal(worst.knows_shoulder, [True, False])
    some = numbers.at(np.array([2, 0]))
    np.testing.assert_array_equal(some.peak_pressure, [[3.0e9, 1.0e9], [2.5e9, 1.5e9]])
    np.testing.assert_array_equal(some.knows_shoulder, [True, False])


@pytest.mark.parametrize("race", ["inner", "outer"])
def test_the_race_past_a_limit_is_named(scene: Scene, race: str) -> None:
    """Under 7140 N the inner race is plastic; of a bearing with a tight outer groove the outer one is."""
    bearing = scene.bearing
    if race == "outer":
        wide, tight = replace(bearing.outer, groove_radius=4.8e-3), replace(bearing.inner, groove_radius=4.0e-3)
        bearing = replace(bearing, outer=wide, inner=tight)
    series = Operation(axial_load=np.array([7140.0]), inner_speed=np.array([31.0]))
    found = friction_torque(replace(scene, bearing=bearing, operation=series))
    peaks = {name: float(getattr(found, name).peak_pressure[0]) for name in ("inner", "outer")}
    for name, peak in peaks.items():
        told = any(f"the peak pressure on the {name} race" in warning for warning in found.warnings)
        assert told == (peak > 4.2e9)
    assert peaks[race] == max(peaks.values()) > 4.2e9


def test_one_unknown_shoulder_is_told_beside_the_known_one(scene: Scene) -> None:
    outer = replace(scene.bearing.outer, shoulder_half_width=None)
    found = friction_torque(replace(scene, bearing=replace(scene.bearing, outer=outer)))
    reason = reason_of(found, "shoulder")
    assert "shoulder not known: give bearing.outer.shoulder_height; semi-axis 1.12" in reason
    assert "inner race's shoulder" in reason
