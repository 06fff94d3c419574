"""Rolling resistance: the printed formula in 40 digits, values of another program, its regimes, units; hysteresis."""

import hypothesis.strategies as st
import mpmath
import numpy as np
import pytest
from hypothesis import given
from scipy.integrate import dblquad

from analytic.contact.geometry import race_curvatures
from analytic.contact.hertz import hertz_contact
from analytic.errors import InputError
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.rolling import RollingResistance, hydrodynamic_rolling, hysteresis_moment, rolling_torque
from analytic.scene import Bearing
from tests.analytic.specimens import hertzian, rolling_contact

ROUND_OFF = 1e-13  # a few hundred roundings of a double
CASE = {
    "curvature_rolling": 310.0,
    "curvature_transverse": 14.7,
    "load": 613.0,
    "modulus": 1.13e11,
    "viscosity": 0.061,
    "entrainment_speed": 0.37,
}
loads = st.floats(-6, 5).map(lambda power: 10.0**power)
speeds = st.floats(-4, 2).map(lambda power: 10.0**power)
ratios = st.floats(0.003, 0.9)


def rolling(**changed: object) -> RollingResistance:
    contact, rest = hertzian(CASE | changed)
    return hydrodynamic_rolling(contact, **rest)


def groups(**changed: float) -> dict[str, mpmath.mpf]:
    """The printed quantities in 40 digits, the semi-axes from the ratio that defines Hertz's ellipse."""
    given = CASE | changed
    with mpmath.workdps(40):
        r_x, stiff = 1 / mpmath.mpf(given["curvature_rolling"]), 2 * mpmath.mpf(given["modulus"])
        ratio = mpmath.mpf(given["curvature_transverse"]) * r_x  # R_x/R_y, below 1 here

        def curvature_ratio(k: mpmath.mpf) -> mpmath.mpf:
            m = 1 - 1 / k**2
            return (k**2 * mpmath.ellipe(m) - mpmath.ellipk(m)) / (mpmath.ellipk(m) - mpmath.ellipe(m))

        start = ratio ** mpmath.mpf("-0.6366")
        k = mpmath.findroot(lambda k: curvature_ratio(k) - 1 / ratio, start)
        integral = mpmath.ellipe(1 - 1 / k**2)
        radius = r_x / (1 + ratio)
        semi_axis = mpmath.cbrt(
            3 * k**2 * integral * given["load"] * radius / (mpmath.pi * mpmath.mpf(given["modulus"]))
        )
        u = 2 * mpmath.mpf(given["viscosity"]) * abs(given["entrainment_speed"]) / (stiff * r_x)
        w = given["load"] / (stiff * r_x**2)
        beta = 4 / mpmath.pi * integral / (1 + ratio)
        rigid = mpmath.mpf("0.77") * beta ** (-mpmath.mpf(1) / 3) * (1 / k) ** mpmath.mpf("0.12")
        return {
            "scale": stiff * r_x**2 * 2 * semi_axis / r_x,
            "u": u,
            "m": mpmath.root(beta, 4) / k * w / u ** mpmath.mpf("0.75"),
            "rigid": rigid * u ** (-mpmath.mpf(1) / 12),
            "elastic": mpmath.mpf("1.8") / mpmath.root(beta, 4),
        }


def printed(**changed: float) -> float:
    g = groups(**changed)
    with mpmath.workdps(40):
        bracket = (g["rigid"] - g["elastic"]) / (1 + g["m"] / mpmath.mpf("6.6")) + g["elastic"]
        return float(g["scale"] * bracket * g["u"] ** mpmath.mpf("0.75"))


def both(bearing: Bearing, *, viscosity: float, speed: float) -> tuple[RollingResistance, RollingResistance, float]:
    """Inner and outer race of a 6205 at 0.18 rad under 1000 N, and u/w."""
    angle = 0.18
    motion = ball_kinematics(
        inner_speed=1.0,
        inner_angle=angle,
        outer_angle=angle,
        pitch_diameter=bearing.pitch_diameter,
        ball_diameter=bearing.ball_diameter,
    )
    inner, outer = (
        rolling(
            curvature_rolling=curvature_rolling,
            curvature_transverse=curvature_transverse,
            load=1000 / (9 * np.sin(angle)),
            modulus=206e9 / (2 * (1 - 0.3**2)),
            viscosity=viscosity,
            entrainment_speed=speed * motion.entrainment_speed,
        )
        for curvature_rolling, curvature_transverse in (
            race_curvatures(bearing, "inner", contact_angle=angle),
            race_curvatures(bearing, "outer", contact_angle=angle),
        )
    )
    return inner, outer, float(motion.entrainment_speed)


@pytest.mark.parametrize(
    ("viscosity", "rpm", "newton_millimetres"),
    [
        (0.0275, 100, 4.02),
        (0.0275, 300, 9.18),
        (0.0275, 500, 13.48),
        (0.0585, 100, 7.09),
        (0.0585, 300, 16.20),
        (0.0585, 500, 23.81),
    ],
)
def test_a_6205_by_another_program(
    bearing_6205: Bearing, viscosity: float, rpm: float, newton_millimetres: float
) -> None:
    speed = rpm * 2 * np.pi / 60
    inner, outer, rate = both(bearing_6205, viscosity=viscosity, speed=speed)
    torque = 9 * sum(rolling_torque(race, entrainment_rate=rate) for race in (inner, outer))
    np.testing.assert_allclose(torque * 1e3, newton_millimetres, atol=0.005)  # the last digit given
    np.testing.assert_allclose(9 * (inner.power + outer.power), torque * speed, rtol=ROUND_OFF)
    assert not inner.outside_range


@given(load=loads, speed=speeds, ratio=ratios)
def test_the_printed_formula_in_40_digits(load: float, speed: float, ratio: float) -> None:
    changed = {"load": load, "entrainment_speed": speed, "curvature_transverse": ratio * CASE["curvature_rolling"]}
    found = rolling(**changed)
    # round-off, of the semi-axes too
    np.testing.assert_allclose(found.force, printed(**changed), rtol=ROUND_OFF)
    np.testing.assert_allclose(found.power, 2 * speed * found.force, rtol=ROUND_OFF)


def test_light_load_is_that_of_rigid_bodies_and_heavy_of_elastic_ones() -> None:
    for load, name, power in ((1e-9, "rigid", 2 / 3), (1e12, "elastic", 3 / 4)):
        g = groups(load=load)
        expected = float(g["scale"] * g[name] * g["u"] ** mpmath.mpf("0.75"))
        np.testing.assert_allclose(rolling(load=load).force, expected, rtol=1e-4)  # what the other leaves there
        more, less = (rolling(load=load, entrainment_speed=0.37 * factor).force for factor in (1.1, 1 / 1.1))
        np.testing.assert_allclose(np.log(more / less) / (2 * np.log(1.1)), power, atol=1e-4)


def test_the_heavy_limit_depends_on_the_load_only_by_the_width() -> None:
    """1.8 beta^-1/4 U^3/4 times the width 2 b: the force per width is the same at 10 times the load."""
    light, heavy = (
        rolling(load=load).force
        / hertz_contact(curvature_x=310.0, curvature_y=14.7, load=load, modulus=1.13e11).semi_axis_y
        for load in (1e12, 1e13)
    )
    np.testing.assert_allclose(light, heavy, rtol=1e-4)  # 1/M left of the other regime


@given(load=loads, speed=speeds, ratio=ratios)
def test_more_speed_oil_and_load_resist_more(load: float, speed: float, ratio: float) -> None:
    here = {"load": load, "entrainment_speed": speed, "curvature_transverse": ratio * CASE["curvature_rolling"]}
    base = rolling(**here)
    assert not base.outside_range
    assert rolling(**(here | {"entrainment_speed": 1.3 * speed})).force > base.force
    assert rolling(**(here | {"viscosity": 1.3 * CASE["viscosity"]})).force > base.force
    g = groups(**here)
    if g["rigid"] <= 4 * g["elastic"]:
        assert rolling(**(here | {"load": 1.3 * load})).force > base.force


def test_a_thin_film_on_a_circle_falls_with_load_between_its_regimes() -> None:
    """Where the first term is more than four times the last, as the docstring says."""
    circle = {"curvature_transverse": 0.999 * 310.0, "entrainment_speed": 1e-6}
    g = groups(**circle, load=1e-9)
    assert g["rigid"] > 4.5 * g["elastic"]
    load = np.geomspace(1e-9, 1e3, 200)
    assert np.any(np.diff(rolling(**circle, load=load).force) < 0)


@given(metre=st.floats(1e-3, 1e3), newton=st.floats(1e-3, 1e3), second=st.floats(1e-3, 1e3))
def test_physics_does_not_depend_on_the_units(metre: float, newton: float, second: float) -> None:
    pascal = newton / metre**2
    scaled = rolling(
        curvature_rolling=CASE["curvature_rolling"] / metre,
        curvature_transverse=CASE["curvature_transverse"] / metre,
        load=CASE["load"] * newton,
        modulus=CASE["modulus"] * pascal,
        viscosity=CASE["viscosity"] * pascal * second,
        entrainment_speed=CASE["entrainment_speed"] * metre / second,
    )
    np.testing.assert_allclose(scaled.force, rolling().force * newton, rtol=ROUND_OFF)
    np.testing.assert_allclose(scaled.power, rolling().power * newton * metre / second, rtol=ROUND_OFF)


def test_standstill_no_load_and_backwards() -> None:
    for load in (0.0, 613.0):
        still = rolling(entrainment_speed=0.0, load=load)
        assert still.force == 0
        assert still.power == 0
        assert not still.outside_range
    slow = rolling(entrainment_speed=np.array([1e-60, 1e-40, 1e-20])).force
    assert np.all(np.diff(slow) > 0)
    assert slow[0] < 1e-30  # N: u^(2/3) or faster
    back = rolling(entrainment_speed=-0.37)
    assert back.force == rolling().force
    assert back.power == rolling().power
    unloaded = rolling(load=np.array([0.0, 1e-300, 1e-30])).force
    assert unloaded[0] == 0
    assert np.all(np.diff(unloaded) > 0)


def test_contacts_outside_the_range_of_the_formula_are_marked() -> None:
    assert rolling(curvature_transverse=311.0).outside_range  # longer in the direction of rolling
    assert not rolling(curvature_transverse=310.0).outside_range
    assert rolling(entrainment_speed=1e8).outside_range  # U = 2e-2: rigid bodies would resist less than elastic ones
    assert rolling(curvature_transverse=311.0).force > 0


def test_arguments_broadcast() -> None:
    load, speed = np.array([3.0, 613.0]), np.array([[0.1], [0.37], [0.9]])
    table = rolling(load=load, entrainment_speed=speed)
    assert table.force.shape == table.power.shape == table.outside_range.shape == (3, 2)
    for i, j in np.ndindex(3, 2):
        alone = rolling(load=float(load[j]), entrainment_speed=float(speed[i, 0])).force
        np.testing.assert_allclose(table.force[i, j], alone, rtol=ROUND_OFF)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"curvature_rolling": 0.0}, "curvature_rolling must be positive"),
        ({"load": -1.0}, "load must be at least 0"),
        ({"modulus": np.inf}, "modulus must be positive and finite"),
        ({"entrainment_speed": np.nan}, "entrainment_speed must be finite"),
        ({"viscosity": 0.0}, "viscosity must be positive"),
        ({"load": np.ones(3), "entrainment_speed": np.ones(2)}, "give equal lengths"),
    ],
)
def test_nonsense_is_refused(changed: dict[str, object], message: str) -> None:
    with pytest.raises(InputError, match=message):
        rolling(**changed)


def test_a_negative_rate_is_refused() -> None:
    with pytest.raises(InputError, match="entrainment_rate must be at least 0"):
        rolling_torque(rolling(), entrainment_rate=-0.01)


def test_hysteresis_takes_its_share_of_the_work_of_the_front_half() -> None:
    """Pressing down the surface ahead of the centre takes the moment of the pressure there, 3/16 Q a."""
    load, a, loss = 470.0, 0.12e-3, 0.0063

    def pressure_times_arm(x: float, y: float) -> float:
        return 3 * load / (2 * np.pi) * np.sqrt(max(0.0, 1 - x**2 - y**2)) * a * x  # unit disc: dA = a b dx dy

    moment, _ = dblquad(pressure_times_arm, -1, 1, 0, lambda y: np.sqrt(1 - y**2), epsabs=1e-12)
    found = hysteresis_moment(rolling_contact(load=load, semi_axis_rolling=a), hysteresis_loss=loss)
    np.testing.assert_allclose(found, loss * moment, rtol=1e-6)  # quadrature across the square-root edge
