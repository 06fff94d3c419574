"""Friction torque of a scene: numbers of an independent calculation, limits, corrections, and what the result says."""

import json
from dataclasses import replace

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import example, given
from scipy.optimize import brentq

import analytic
from analytic.correction import ContactCorrection, ContactFactors
from analytic.effects import EFFECTS
from analytic.equilibrium import thrust_equilibrium
from analytic.errors import InputError
from analytic.scene import Bearing, ContactAngle, Decision, Operation, Scene, SpinRule
from analytic.scenefile import builtin_scene, load_scene, parse_scene
from analytic.torque import friction_torque
from analytic.torque_result import FrictionTorque, TorqueParts

GIVEN = ContactAngle(rule="given", value=0.18)
SOLVED = ContactAngle(rule="solved", free=0.18)
PARTS = ("spin", "conformity", "hysteresis")
SLOW: dict[str, Decision] = {
    "centrifugal": "off",
    "gyroscopic": "off",
}  # a load may be as light as one likes, at any speed
AS_HERTZ: dict[str, Decision] = {
    "finite_geometry": "off",
    "spin": "on",
}  # the closed forms of text books, whatever the tolerance


def operation(*loads: float, speed: float | list[float] = 31.0) -> Operation:
    load, speeds = np.broadcast_arrays(np.array(loads), np.array(speed, dtype=float))
    return Operation(axial_load=load, inner_speed=speeds)


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    """1000 N at 0.18 rad held fixed, mu = 0.1, alpha' = 0.007."""
    return Scene(
        name="test",
        tolerance=0.05,
        bearing=bearing_6205,
        contact_angle=GIVEN,
        operation=operation(1000.0),
        friction_coefficient=0.1,
        hysteresis_loss=0.007,
        effects=AS_HERTZ,
    )


def part(found: TorqueParts, name: str) -> np.ndarray:
    values = getattr(found, name)
    assert values is not None
    return values


@pytest.mark.parametrize(
    ("angle", "rule", "race"),
    [
        (GIVEN, "balanced", 71.5e-3),
        (GIVEN, "outer_control", 75.9e-3),
        (GIVEN, "inner_control", 81.2e-3),
        (SOLVED, "balanced", 39.1e-3),
    ],
)
def test_race_torque_of_the_6205(scene: Scene, angle: ContactAngle, rule: SpinRule, race: float) -> None:
    """Of an independent calculation; three digits, the last rounded."""
    found = friction_torque(replace(scene, contact_angle=angle, spin_rule=rule)).torque
    np.testing.assert_allclose(found.race, race, atol=0.051e-3)
    np.testing.assert_allclose(found.total, found.race, rtol=0)
    np.testing.assert_allclose(sum(part(found, name) for name in PARTS), found.race, rtol=1e-15)  # round-off
    if angle is GIVEN:
        np.testing.assert_allclose(part(found, "hysteresis"), 4.949e-3, atol=0.5e-6)


def test_torque_is_the_same_at_any_speed_either_way_and_at_standstill(scene: Scene) -> None:
    series = friction_torque(replace(scene, operation=operation(870.0, speed=[0.0, 1e-300, 3.7, -3.7, 5e3])))
    for name in ("total", "race", *PARTS):
        values = part(series.torque, name)
        assert values.shape == (5,)
        assert np.all(values == values[0])
        assert values[0] > 0
    np.testing.assert_array_equal(series.inner_speed, [0.0, 1e-300, 3.7, -3.7, 5e3])


def order(scene: Scene, name: str, load: float) -> float:
    """Local exponent of a part in the load."""
    low, high = part(friction_torque(replace(scene, operation=operation(load, 2 * load))).torque, name)
    return float(np.log2(high / low))


def without(scene: Scene, *names: str) -> Scene:
    return replace(scene, effects={**scene.effects, **dict.fromkeys(names, "off")})


def test_exponents_as_the_load_vanishes(scene: Scene) -> None:
    """a, b as Q^1/3. Free angle above 0: al stays, Q as Fa. Free angle 0: Q as Fa^3/4, al as Fa^1/4, eps stays."""
    slow = replace(scene, effects=AS_HERTZ | SLOW)
    open_angle = replace(slow, contact_angle=SOLVED)
    closed = replace(slow, contact_angle=ContactAngle(rule="solved", free=0.0))
    load = 1e-9  # N: the next term of the equilibrium is 1e-4 to 1e-6 of the first
    for name, expected in (("spin", 4 / 3), ("hysteresis", 4 / 3)):
        np.testing.assert_allclose(order(open_angle, name, load), expected, atol=1e-4)
    np.testing.assert_allclose(order(without(open_angle, "spin"), "conformity", load), 5 / 3, atol=1e-4)
    for name, expected in (("spin", 5 / 4), ("conformity", 5 / 4), ("hysteresis", 1.0)):
        np.testing.assert_allclose(order(closed, name, load), expected, atol=1e-3)


@pytest.mark.parametrize(("rule", "left"), [("balanced", None), ("inner_control", "inner"), ("outer_control", "outer")])
def test_conformity_never_ends_on_the_race_that_spins_less(scene: Scene, rule: SpinRule, left: str | None) -> None:
    """At a light load one race spins in full and its conformity is gone. The other keeps its own: all of it where it
    does not spin, and under balance what the moment of the first, 3/8 mu Q b, leaves on the longer contact."""
    light = replace(scene, operation=operation(1e-6), spin_rule=rule)
    found = friction_torque(light)
    np.testing.assert_allclose(order(light, "conformity", 1e-6), 5 / 3, atol=1e-9)  # Q b^2 at a fixed angle
    size = {"inner": 1.1222, "outer": 0.92500}  # mm at 620.63 N
    share = 0.375 * size["outer"] / size["inner"] if left is None else 0.0
    eps = brentq(lambda eps: 3 * eps * (d := distance(eps)) * (1 - eps**2 - d**2) - share, 0.0, 0.49)
    g1, g2 = -eps - distance(eps), -eps + distance(eps)
    rolling = (0.4 + g1**3 * (1 - 0.6 * g1**2) - g2**3 * (1 - 0.6 * g2**2)) / 4
    race = left or "inner"
    b, groove = getattr(found, race).semi_axis_transverse, getattr(scene.bearing, race).groove_radius
    moment = rolling * 0.1 * found.ball_load * b**2 / (2 * groove * 3.97e-3 / (groove + 3.97e-3))
    lever = 19.505e-3 + (1 if race == "inner" else -1) * 3.97e-3 * np.cos(0.18)
    np.testing.assert_allclose(
        part(found.torque, "conformity"), 9 * moment * lever / 7.94e-3, rtol=5e-4
    )  # of b's ratio


def distance(eps: float) -> float:
    """Half the distance of the pure-rolling lines over b, from their cubic d^3 - 3 (1 - eps^2) d + 1 = 0."""
    return float(brentq(lambda d: d**3 - 3 * (1 - eps**2) * d + 1, 0.0, 0.6))


def test_preload_leaves_a_torque_without_thrust(scene: Scene, bearing_6205: Bearing) -> None:
    tight = bearing_6205.inner.bottom_radius + bearing_6205.ball_diameter - 3e-6
    preloaded = replace(
        scene,
        bearing=replace(bearing_6205, outer=replace(bearing_6205.outer, bottom_radius=tight)),
        contact_angle=ContactAngle(rule="solved"),
        operation=operation(1e-3, 1e-9),
        effects=AS_HERTZ | SLOW,
    )
    found = friction_torque(preloaded).torque
    assert found.total[1] > 1e-4
    np.testing.assert_allclose(*found.total, rtol=1e-5)
    assert part(found, "spin")[1] < 1e-12 * found.total[1]  # al goes with the load, and spin with al


def test_without_friction_only_hysteresis_is_left(scene: Scene) -> None:
    found = friction_torque(replace(scene, friction_coefficient=0.0))
    assert part(found.torque, "spin") == 0
    assert part(found.torque, "conformity") == 0
    assert found.torque.total == part(found.torque, "hysteresis") > 0
    nothing = friction_torque(replace(scene, friction_coefficient=0.0, hysteresis_loss=0.0))
    assert nothing.torque.total == 0
    assert all(effect.share == 0 for effect in nothing.effects if effect.decision == "on")


@given(
    log_load=st.floats(-12, 4),
    speed=st.floats(-1e4, 1e4),
    mu=st.one_of(st.just(0.0), st.floats(1e-6, 2)),
    clearance=st.floats(-20e-6, 60e-6),
    rule=st.sampled_from(["balanced", "inner_control", "outer_control"]),
)
@example(log_load=3.0, speed=0.0, mu=0.0, clearance=0.0, rule="balanced")
def test_every_scene_gives_finite_numbers(
    bearing_6205: Bearing, log_load: float, speed: float, mu: float, clearance: float, rule: SpinRule
) -> None:
    touching = bearing_6205.inner.bottom_radius + bearing_6205.ball_diameter
    outer = replace(bearing_6205.outer, bottom_radius=touching + clearance / 2)
    found = friction_torque(
        Scene(
            name="any",
            tolerance=0.05,
            bearing=replace(bearing_6205, outer=outer),
            contact_angle=ContactAngle(rule="solved"),
            operation=operation(10.0**log_load, speed=speed),
            friction_coefficient=mu,
            hysteresis_loss=0.006,
            spin_rule=rule,
            effects=AS_HERTZ | SLOW,
        )
    )
    text = json.dumps(found.to_json(), allow_nan=False)  # raises for a number that is not finite
    assert json.loads(text) == found.to_json()
    assert found.torque.total > 0
    assert all(part(found.torque, name) >= 0 for name in PARTS)


def same(first: FrictionTorque, second: FrictionTorque) -> bool:
    return first.to_json()["points"] == second.to_json()["points"]


@pytest.mark.parametrize("angle", [GIVEN, SOLVED, ContactAngle(rule="solved")])
def test_factors_of_one_change_no_bit(scene: Scene, angle: ContactAngle) -> None:
    asked = replace(scene, contact_angle=angle, operation=operation(0.2, 30.0, 870.0))
    plain = friction_torque(asked)
    assert same(friction_torque(asked, correction=ContactCorrection()), plain)
    changed = friction_torque(asked, correction=ContactCorrection(outer=ContactFactors(semi_axis_rolling=1 + 1e-9)))
    assert not same(changed, plain)
    assert changed.provenance["contacts"] == "Hertz with given factors"


def test_a_corrected_approach_moves_the_equilibrium(scene: Scene) -> None:
    """The grooves' centres still have to be where both contacts, each softer by its factor, let them be."""
    factors = {"inner": 1.08, "outer": 0.93}
    correction = ContactCorrection(
        **{race: ContactFactors(approach=factor) for race, factor in factors.items()}  # pyright: ignore[reportArgumentType]
    )
    asked = replace(scene, contact_angle=SOLVED, operation=operation(430.0))
    found = friction_torque(asked, correction=correction)
    al, bearing = float(found.contact_angle[0]), asked.bearing
    np.testing.assert_allclose(bearing.ball_count * found.ball_load * np.sin(al), 430.0, rtol=1e-13)  # round-off
    hertz = thrust_equilibrium(bearing, ContactAngle(rule="given", value=al), axial_load=430.0)
    approach = factors["inner"] * hertz.inner.approach + factors["outer"] * hertz.outer.approach
    distance = bearing.groove_centre_distance
    np.testing.assert_allclose((distance + approach) * np.cos(al), distance * np.cos(0.18), rtol=1e-13)  # round-off
    np.testing.assert_allclose(found.inner.approach, 1.08 * hertz.inner.approach, rtol=1e-13)
    assert abs(al - friction_torque(asked).contact_angle[0]) > 1e-5
    stiffness = thrust_equilibrium(bearing, SOLVED, axial_load=430.0, correction=correction).outer.stiffness
    np.testing.assert_allclose(stiffness, found.outer.load / found.outer.approach**1.5, rtol=1e-13)


def test_corrected_semi_axes_reach_the_torque(scene: Scene) -> None:
    """Without spin conformity goes with b^2 and hysteresis with a, on each race by its own factor."""
    plain = without(scene, "spin")

    def parts(correction: ContactCorrection | None) -> tuple[float, float]:
        found = friction_torque(plain, correction=correction).torque
        return float(part(found, "conformity")[0]), float(part(found, "hysteresis")[0])

    inner = parts(ContactCorrection(inner=ContactFactors(semi_axis_rolling=1.07, semi_axis_transverse=1.04)))
    outer = parts(ContactCorrection(outer=ContactFactors(semi_axis_rolling=1.07, semi_axis_transverse=1.04)))
    for index, growth in enumerate((1.04**2, 1.07)):
        whole = parts(None)[index]
        # what the inner race adds and what the outer adds are together what both add
        np.testing.assert_allclose(inner[index] + outer[index], (1 + growth) * whole, rtol=1e-13)  # round-off
        assert whole < outer[index] < growth * whole
    pressed = friction_torque(
        plain, correction=ContactCorrection(inner=ContactFactors(semi_axis_rolling=1.07, semi_axis_transverse=1.04))
    ).inner
    product = 2 * np.pi * pressed.semi_axis_rolling * pressed.semi_axis_transverse * pressed.peak_pressure / 3
    np.testing.assert_allclose(product, pressed.load, rtol=1e-14)  # the pressure still carries the load


def test_a_factor_must_be_a_positive_number() -> None:
    with pytest.raises(InputError, match="approach must be positive"):
        ContactFactors(approach=-1.1)


def test_what_is_left_out_is_none_and_said(scene: Scene) -> None:
    found = friction_torque(replace(scene, hysteresis_loss=None, effects={"conformity": "off", "spin": "on"}))
    assert found.torque.conformity is None
    assert found.torque.hysteresis is None
    assert found.torque.rolling is None
    assert found.torque.cage is None
    np.testing.assert_array_equal(found.torque.total, part(found.torque, "spin"))
    told = {effect.name: effect for effect in found.effects}
    assert list(told) == list(EFFECTS)
    assert (told["spin"].decision, told["spin"].share, told["spin"].reason) == ("on", 1.0, "the scene says on")
    assert (told["conformity"].decision, told["conformity"].share) == ("off", None)
    assert "says off" in told["conformity"].reason
    assert "friction.hysteresis_loss" in told["hysteresis"].reason
    assert "no lubricant is given" in told["rolling"].reason
    assert "no cage is given" in told["cage"].reason
    nothing = friction_torque(without(scene, *PARTS)).torque
    assert nothing.total == 0


def test_without_spin_the_balls_only_roll(scene: Scene) -> None:
    whole, rolling = friction_torque(scene).torque, friction_torque(without(scene, "spin")).torque
    assert rolling.spin is None
    assert part(rolling, "conformity") > part(whole, "conformity")  # spin takes from conformity
    # All of it: 0.0806 mu Q b^2/R on each race, at the numbers of the fixed angle.
    b, groove = np.array([1.1222e-3, 0.92500e-3]), np.array([4.13e-3, 4.21e-3])
    moment = 0.0805712 * 0.1 * 620.630 * b**2 / (2 * groove * 3.97e-3 / (groove + 3.97e-3))
    reach = 3.97e-3 * np.cos(0.18)
    expected = 9 * moment @ (19.505e-3 + reach, 19.505e-3 - reach) / 7.94e-3
    np.testing.assert_allclose(part(rolling, "conformity"), expected, rtol=2e-4)  # five digits of b, squared


def test_shares_are_the_largest_of_the_series(scene: Scene) -> None:
    found = friction_torque(replace(scene, contact_angle=SOLVED, operation=operation(1.0, 40.0, 900.0)))
    for effect in (effect for effect in found.effects if effect.name in PARTS):
        assert effect.share == np.max(part(found.torque, effect.name) / found.torque.total)


DESIGN = {
    "inner_speed": None,
    "axial_load": None,
    "contact_angle": None,
    "torque": ["total", "race", "spin", "conformity", "hysteresis", "rolling", "cage", "declared"],
    "friction_coefficient": ["inner", "outer", "pocket"],
    "film": ["inner", "outer"],
    "asperity_share": ["inner", "outer"],
    "contact": ["inner", "outer"],
    "uncertainty": ["numerical", "model"],
    "cage": ["mean_force", "max_force", "interval", "duration", "state", "signed_moment"],
}


def test_the_json_has_the_keys_of_the_design(scene: Scene) -> None:
    result = friction_torque(replace(scene, operation=operation(500.0, 900.0)))
    found = result.to_json()
    assert list(found) == ["points", "effects", "warnings", "provenance", "seconds"]
    assert len(found["points"]) == 2
    for index, point in enumerate(found["points"]):
        assert {key: list(value) if isinstance(value, dict) else None for key, value in point.items()} == DESIGN
        for contact in point["contact"].values():
            names = ["load", "semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach"]
            assert list(contact) == names
        for race in ("inner", "outer"):
            shown = {name: values[index] for name, values in vars(getattr(result, race)).items()}
            assert point["contact"][race] == shown
        assert point["torque"]["rolling"] is None
    assert [point["axial_load"] for point in found["points"]] == [500.0, 900.0]
    assert set(found["effects"][0]) == {"name", "decision", "share", "reason"}
    assert found["provenance"]["scene"] == "test"
    assert found["provenance"]["contact_angle"] == "given"
    assert found["provenance"]["contacts"] == "Hertz"
    assert {"fembearing", "numpy", "scipy"} <= set(found["provenance"])
    assert found["seconds"] > 0


def test_the_result_says_where_its_friction_comes_from(scene: Scene) -> None:
    found = friction_torque(replace(scene, warnings=("a doubt",)))
    assert found.warnings[0] == "a doubt"
    assert any("friction coefficient 0.1 comes from the scene" in warning for warning in found.warnings)
    assert any("cage is not modelled" in warning for warning in found.warnings)
    assert any("rolling needs [lubricant]" in warning for warning in found.warnings)
    assert len(found.warnings) == 4  # nothing else is doubtful here


@pytest.mark.parametrize(
    ("load", "mu", "words"),
    [
        (14e3, 0.1, ["ellipse passes the inner race's shoulder", "semi-axis 0.002705 m, room 0.002561 m"]),
        (8e3, 0.1, ["peak pressure on the inner race 4.366e+09 Pa", "4.2e+09 Pa"]),
        (1e3, 0.3, ["sliding number of the outer contact is 0.669", "elastic creep"]),
    ],
)
def test_a_doubtful_contact_is_flagged_with_its_numbers(scene: Scene, load: float, mu: float, words: list[str]) -> None:
    """Hertz's cube root of the load from 1000 N, where b = 1.1222 mm, p0 = 2.1831 GPa, outer sliding number 6.459.

    The room is r_g sin(asin(w/r_g) - al) = 4.13 sin(asin(3.1/4.13) - 0.18) = 2.561 mm; sliding is least at 30 N.
    """
    asked = replace(scene, operation=operation(40.0, load, 30.0), friction_coefficient=mu)
    found = friction_torque(asked).warnings
    assert any(all(word in warning for word in words) for warning in found), found


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"friction_coefficient": None}, r"friction\.coefficient is missing.*\[friction\] coefficient = 0\.1"),
        ({"friction_coefficient": -0.1}, r"friction\.coefficient must be at least 0"),
        ({"friction_coefficient": float("nan")}, r"friction\.coefficient must be at least 0"),
        ({"hysteresis_loss": -0.01}, "hysteresis_loss must be at least 0"),
        ({"operation": operation(900.0, speed=float("nan"))}, r"operation\.inner_speed must be finite"),
        ({"operation": operation()}, r"operation\.axial_load is empty"),
        ({"operation": operation(0.0)}, "axial_load must be positive"),
        ({"operation": operation(40.0, 1e7), "contact_angle": SOLVED}, "beyond the inner race's shoulder"),
        ({"effects": {"rolling": "on"}}, r'effects\.rolling = "on" cannot be had: no lubricant'),
        ({"effects": {"cage": "on"}}, r'effects\.cage = "on" cannot be had'),
        ({"effects": {"seals": "off"}}, r"effects\.seals is not an effect to choose"),
        (
            {"effects": {"hysteresis": "on"}, "hysteresis_loss": None},
            r"friction\.hysteresis_loss is not given",
        ),
        ({"spin_rule": "race_control"}, "spin_rule must be"),
    ],
)
def test_what_cannot_be_answered_is_refused(scene: Scene, change: dict, words: str) -> None:
    with pytest.raises(InputError, match=words):
        friction_torque(replace(scene, **change))


def test_the_builtin_scene_from_its_file() -> None:
    scene = load_scene(builtin_scene("6205"))
    found = analytic.friction_torque(replace(scene, effects={"finite_geometry": "off"}))
    np.testing.assert_allclose(found.torque.race, [39.1e-3] * 5, atol=0.051e-3)  # three digits
    np.testing.assert_allclose(found.contact_angle, [0.3031] * 5, atol=0.5e-4)


def test_a_scene_file_names_loss_and_spin_rule() -> None:
    text = builtin_scene("6205").read_text("utf-8")
    assert parse_scene(text, origin="here").hysteresis_loss == 0.007
    given, _ = text.split("[friction]")
    table = '[friction]\ncoefficient = 0.08\nspin_rule = "outer_control"\n'
    found = parse_scene(given + table, origin="here")
    assert (found.friction_coefficient, found.hysteresis_loss, found.spin_rule) == (0.08, None, "outer_control")
    with pytest.raises(InputError, match=r"friction\.hysteresis_loss = -0\.2"):
        parse_scene(given + table + "hysteresis_loss = -0.2\n", origin="here")
    with pytest.raises(InputError, match=r"friction\.spin_rule = 'race'.*'balanced'"):
        parse_scene(given + '[friction]\ncoefficient = 0.1\nspin_rule = "race"\n', origin="here")
