"""Three rungs of one ball's friction: Coulomb's closed forms, exact sums, the power lost, and values from elsewhere."""

from dataclasses import dataclass, replace

import hypothesis.strategies as st
import numpy as np
import pytest
from hypothesis import given, settings
from scipy.optimize import brentq

from analytic.contact.hertz import hertz_contact
from analytic.errors import InputError
from analytic.loads.kinematics import ball_kinematics
from analytic.oil.mixed import MixedContact, mixed_contact
from analytic.oil.traction import CoulombTraction, MixedTraction, Traction
from analytic.scene import Array, Autocorrelation, Lubricant
from analytic.sliding.ball import RaceContact, Rung, SlipFriction, slip_friction
from analytic.sliding.long_ellipse import SlidingContact, deformed_radius, hysteresis_moment, microslip_torque
from analytic.surface.asperity_table import tabulated_asperities
from analytic.surface.moments import mccool_summits
from analytic.surface.roughness import spectral_moments

RUNGS: tuple[Rung, ...] = ("single_coefficient", "along_axis", "over_ellipse")
QUADRATURE = 1e-5  # the integrals over a contact claim 1e-6 for smooth laws; the kink at zeta p costs some more
BALLS, BALL, PITCH = 9, 7.94e-3, 39.01e-3  # m, of a 6205
STEEL, HARDNESS = 206e9 / (2 * (1 - 0.3**2)), 7.8e9  # Pa
OIL = Lubricant(
    viscosity=0.06,
    pressure_viscosity=2e-8,
    viscosity_temperature=0.03,
    reference_temperature=313.0,
    temperature=313.0,
    thermal_conductivity=0.14,
    density=870.0,
    eyring_stress=5e6,
    limiting_shear=0.06,
    traction="eyring_constant",
)


@dataclass(frozen=True)
class Running:
    inner: RaceContact
    outer: RaceContact
    ring_speed: Array
    spin_difference: Array
    shared: MixedContact

    def friction(self, rung: Rung, spin_rule: str = "balanced") -> SlipFriction:
        return slip_friction(
            self.inner,
            self.outer,
            ring_speed=self.ring_speed,
            spin_difference=self.spin_difference,
            spin_rule=spin_rule,  # pyright: ignore[reportArgumentType]
            rung=rung,
        )


def running(
    *,
    rpm: object,
    sq: float,
    length: float = 150e-6,
    angle: float = 0.18,
    load: float = 1000.0,
    traction: str = "eyring_constant",
) -> Running:
    """A ball of a 6205 under thrust at a given contact angle."""
    speed, ball_load = np.asarray(rpm, dtype=np.float64) * np.pi / 30, load / (BALLS * np.sin(angle))
    geometry = {"inner_angle": angle, "outer_angle": angle, "pitch_diameter": PITCH, "ball_diameter": BALL}
    rates, motion = ball_kinematics(inner_speed=1.0, **geometry), ball_kinematics(inner_speed=speed, **geometry)
    grooves, sides = np.array([4.13e-3, 4.21e-3]), np.array([1.0, -1.0])
    radii = np.array([rates.inner_radius, rates.outer_radius])
    curvature_x, curvature_y = 2 / BALL + sides * np.cos(angle) / radii, 2 / BALL - 1 / grooves
    ellipse = hertz_contact(curvature_x=curvature_x, curvature_y=curvature_y, load=ball_load, modulus=STEEL)
    correlation = Autocorrelation(kind="gaussian", length=length, spacing=length / 20)
    moments = spectral_moments(rms_roughness=sq, autocorrelation=correlation)
    summits = mccool_summits(moments + moments)
    columns = (slice(None), *(None,) * np.ndim(speed))
    shared = mixed_contact(
        curvature_x=curvature_x[columns],
        curvature_y=curvature_y[columns],
        load=ball_load,
        modulus=STEEL,
        contact_area=np.pi * (ellipse.semi_axis_x * ellipse.semi_axis_y)[columns],
        entrainment_speed=motion.entrainment_speed,
        viscosity=OIL.viscosity,
        pressure_viscosity=OIL.pressure_viscosity,
        asperities=tabulated_asperities(summits=summits, modulus=STEEL, hardness=HARDNESS),
    )
    races = [
        RaceContact(
            traction=MixedTraction(
                lubricant=replace(OIL, traction=traction),  # pyright: ignore[reportArgumentType]
                boundary_friction=0.12,
                asperity_share=shared.asperity_share[k],
                area_fraction=shared.area_fraction[k],
                film_thickness=shared.film_thickness[k],
            ),
            load=ball_load,
            semi_axis_rolling=float(ellipse.semi_axis_x[k]),
            semi_axis_transverse=float(ellipse.semi_axis_y[k]),
            deformed_radius=deformed_radius(groove_radius=grooves[k], ball_diameter=BALL),
            rolling_rate=float(rate),
        )
        for k, rate in enumerate((rates.inner_rolling_rate, rates.outer_rolling_rate))
    ]
    return Running(races[0], races[1], speed, rates.spin_difference, shared)


def race_torque(case: Running, rung: Rung, hysteresis_loss: float) -> Array:
    """Slip and hysteresis of all balls, N mm."""
    slip = case.friction(rung).torque
    hysteresis = sum(
        hysteresis_moment(hysteresis_loss=hysteresis_loss, load=race.load, semi_axis_rolling=race.semi_axis_rolling)
        * race.rolling_rate
        for race in (case.inner, case.outer)
    )
    return 1e3 * BALLS * (slip.spin + slip.conformity + hysteresis)


@pytest.mark.parametrize(
    ("sq", "at_100_rpm", "at_500_rpm"), [(1e-6, (17.9, 16.1), (17.1, 15.4)), (0.1e-6, (7.8, 7.8), (7.4, 7.4))]
)
def test_the_calibrated_race_torque(sq: float, at_100_rpm: tuple, at_500_rpm: tuple) -> None:
    """Computed elsewhere with correlation lengths of 150 and 180 um; at 0.1 um only one digit of both was kept."""
    torques = np.array(
        [race_torque(running(rpm=[100, 500], sq=sq, length=b), RUNGS[0], 0.007) for b in (150e-6, 180e-6)]
    )
    printed = np.array([at_100_rpm, at_500_rpm]).T
    last_digit = 0.05 if sq == 1e-6 else 0.1  # N mm
    np.testing.assert_allclose(torques, printed, rtol=0, atol=last_digit)


def contact(traction: Traction, **changed: object) -> RaceContact:
    given = {
        "load": 613.0,
        "semi_axis_rolling": 0.12e-3,
        "semi_axis_transverse": 1.1e-3,
        "deformed_radius": 4.05e-3,
        "rolling_rate": 2.45,
    } | changed
    return RaceContact(traction=traction, **given)  # pyright: ignore[reportArgumentType]


def pair(traction: Traction, **changed: object) -> tuple[RaceContact, RaceContact]:
    """Inner and outer contact."""
    outer = {"semi_axis_rolling": 0.16e-3, "semi_axis_transverse": 0.93e-3, "deformed_radius": 4.1e-3}
    return contact(traction, **changed), contact(traction, **(outer | {"rolling_rate": 1.93} | changed))


def friction(races: tuple[RaceContact, RaceContact], rung: Rung, **changed: object) -> SlipFriction:
    given = {"ring_speed": 31.0, "spin_difference": 0.179, "spin_rule": "balanced"} | changed
    return slip_friction(*races, rung=rung, **given)  # pyright: ignore[reportArgumentType]


def both(found: SlipFriction) -> Array:
    return np.asarray(found.torque.spin + found.torque.conformity)


@pytest.mark.parametrize("rule", ["balanced", "inner_control", "outer_control"])
def test_coulomb_friction_is_what_it_was(rule: str) -> None:
    load = np.array([3.0, 613.0])
    races = pair(CoulombTraction(friction_coefficient=0.083), load=load)
    found = friction(races, "single_coefficient", spin_rule=rule)
    names = ("load", "semi_axis_rolling", "semi_axis_transverse", "deformed_radius", "rolling_rate")
    sliding = (
        SlidingContact(friction_coefficient=0.083, **{name: getattr(race, name) for name in names}) for race in races
    )
    expected = microslip_torque(*sliding, spin_difference=0.179, spin_rule=rule)  # pyright: ignore[reportArgumentType]
    for name in vars(expected):
        np.testing.assert_array_equal(getattr(found.torque, name), getattr(expected, name))
    np.testing.assert_allclose(found.inner_coefficient, 0.083, rtol=1e-15)
    # The line form of the integral is the same thing, and a long ellipse comes to it.
    along = friction(races, "along_axis", spin_rule=rule)
    np.testing.assert_allclose(both(along), both(found), rtol=QUADRATURE)
    np.testing.assert_allclose(along.torque.inner_spin_moment, expected.inner_spin_moment, rtol=QUADRATURE)
    np.testing.assert_allclose([along.inner_coefficient, along.outer_coefficient], 0.083, rtol=1e-12)
    np.testing.assert_allclose(along.inner_slip_speed, found.inner_slip_speed, rtol=QUADRATURE)
    narrow = friction(pair(CoulombTraction(friction_coefficient=0.083), semi_axis_rolling=1e-6), "over_ellipse")
    long = friction(pair(CoulombTraction(friction_coefficient=0.083), semi_axis_rolling=1e-6), "along_axis")
    np.testing.assert_allclose(both(narrow), both(long), rtol=1e-4)  # as (a/b)^2 ln(b/a)


def test_a_constant_stress_in_full_spin_is_a_plain_sum() -> None:
    """Spin so fast that rolling does not count: tau over the chords 2 a sqrt(1 - y^2/b^2), or over a circle."""
    dry = MixedTraction(
        lubricant=OIL, boundary_friction=0.0, asperity_share=0.0, area_fraction=0.0, film_thickness=1e-7
    )
    fast = {"spin_difference": 1e6, "spin_rule": "outer_control"}
    a, b = 0.12e-3, 1.1e-3
    along = friction(pair(dry), "along_axis", **fast).torque.inner_spin_moment
    np.testing.assert_allclose(along, 5e6 * 4 / 3 * a * b**2, rtol=QUADRATURE)
    circle = friction(pair(dry, semi_axis_rolling=b, semi_axis_transverse=b), "over_ellipse", **fast)
    np.testing.assert_allclose(circle.torque.inner_spin_moment, 5e6 * 2 * np.pi / 3 * b**3, rtol=QUADRATURE)
    single = friction(pair(dry), "single_coefficient", **fast)
    np.testing.assert_allclose(single.torque.inner_spin_moment, 3 / 8 * 5e6 * np.pi * a * b * b, rtol=1e-12)
    np.testing.assert_allclose(single.inner_coefficient, 5e6 * np.pi * a * b / 613.0, rtol=1e-12)


@pytest.mark.parametrize("traction", ["eyring_constant", "eyring_sinh"])
@pytest.mark.parametrize("rung", ["along_axis", "over_ellipse"])
def test_the_torque_is_the_power_lost_at_every_point(rung: Rung, traction: str) -> None:
    """Against a plain midpoint sum over polar cells, with its own c of no net force."""
    case = running(rpm=230.0, sq=0.4e-6, traction=traction)
    found = case.friction(rung)
    r, angle = np.sqrt((np.arange(800) + 0.5) / 800)[:, None], 2 * np.pi * (np.arange(1440) + 0.5) / 1440  # equal areas
    total = 0.0
    rates = (found.torque.inner_spin_rate, found.torque.outer_spin_rate)
    for race, spin in zip((case.inner, case.outer), rates, strict=True):
        a, b = float(race.semi_axis_rolling), float(race.semi_axis_transverse)
        x, y = a * r * np.cos(angle), b * r * np.sin(angle)
        pressure = 1.5 * race.load / (np.pi * a * b) * np.sqrt(1 - r**2) + 0 * x
        across = -spin * x if rung == "over_ellipse" else np.zeros_like(x)
        slide = race.rolling_rate * y**2 / (2 * race.deformed_radius) + spin * y

        def stress(c: float) -> tuple[Array, Array]:
            speed = np.hypot(slide - c, across)  # noqa: B023
            return race.traction.stress(pressure, case.ring_speed * speed), speed  # noqa: B023

        def force(c: float) -> float:
            tau, speed = stress(c)
            along = np.divide(slide - c, speed, out=np.zeros_like(speed), where=speed > 0)  # noqa: B023
            return float(np.sum(tau * along))

        tau, speed = stress(brentq(force, slide.min(), slide.max(), xtol=1e-16))  # pyright: ignore[reportArgumentType]
        total += np.pi * a * b * float(np.mean(tau * speed))
    np.testing.assert_allclose(both(found), total, rtol=2e-4)  # a thousand cells across, kinks where slide changes sign


@pytest.mark.parametrize("rung", RUNGS)
def test_a_balanced_ball_feels_no_spin_moment(rung: Rung) -> None:
    found = running(rpm=[0.0, 90.0, 500.0], sq=0.3e-6, traction="eyring_sinh").friction(rung).torque
    np.testing.assert_allclose(found.inner_spin_moment, -found.outer_spin_moment, rtol=1e-6)  # 1e-9 of the share
    np.testing.assert_allclose(found.inner_spin_rate - found.outer_spin_rate, np.sin(0.18), rtol=1e-14)


@pytest.mark.parametrize("traction", ["eyring_constant", "eyring_sinh"])
def test_the_single_coefficient_belongs_to_its_own_speed(traction: str) -> None:
    case = running(rpm=[40.0, 400.0], sq=0.2e-6, traction=traction)
    found = case.friction("single_coefficient")
    for race, mu, speed in (
        (case.inner, found.inner_coefficient, found.inner_slip_speed),
        (case.outer, found.outer_coefficient, found.outer_slip_speed),
    ):
        force = race.traction.force(load=race.load, area=race.area)(speed)
        np.testing.assert_allclose(mu * race.load, force, rtol=1e-12)  # round-off
    # Torque times w is the power of friction force times mean speed.
    power = sum(
        mu * race.load * speed
        for race, mu, speed in (
            (case.inner, found.inner_coefficient, found.inner_slip_speed),
            (case.outer, found.outer_coefficient, found.outer_slip_speed),
        )
    )
    np.testing.assert_allclose(both(found) * case.ring_speed, power, rtol=1e-12)


@pytest.mark.parametrize("rung", RUNGS)
def test_roughness_and_slowness_raise_friction(rung: Rung) -> None:
    for sq in (0.05e-6, 0.3e-6, 1.2e-6):
        case = running(rpm=[30.0, 130.0, 700.0], sq=sq)
        found = case.friction(rung)
        assert np.all(np.diff(found.inner_coefficient) < 0)
        assert np.all(np.diff(both(found)) < 0)
    smoother, rougher = (both(running(rpm=130.0, sq=sq).friction(rung)) for sq in (0.3e-6, 1.2e-6))
    assert rougher > smoother


@pytest.mark.parametrize("rung", RUNGS)
@pytest.mark.parametrize("edge", [0.0, 0.5])
def test_no_jump_where_spin_begins_and_where_it_is_full(rung: Rung, edge: float) -> None:
    case = running(rpm=200.0, sq=0.3e-6, traction="eyring_sinh")
    ratio = float(case.inner.deformed_radius / (case.inner.rolling_rate * case.inner.semi_axis_transverse))
    spins = edge / ratio + np.array([0.0, 1.0, 2.0]) * 1e-4
    found = replace(case, spin_difference=spins).friction(rung, "outer_control")
    step = np.diff(both(found))
    assert np.all(np.abs(step) < 2e-3 * both(found)[:-1])  # 1e-4 of rates near 0.1 to 1
    assert np.all(np.isfinite(both(found)))
    if edge == 0:
        assert found.torque.inner_spin_moment[0] == 0
        assert found.torque.spin[0] == 0


@pytest.mark.parametrize("rung", RUNGS)
def test_standstill_and_direction(rung: Rung) -> None:
    """At rest everything is boundary friction; with oil that shears as it is asked to, slow sliding has no oil part."""
    still = running(rpm=np.array([0.0, 1e-9]), sq=0.3e-6, traction="eyring_sinh")
    found = still.friction(rung)
    np.testing.assert_allclose(found.inner_coefficient[0], 0.12, rtol=1e-12)
    assert np.all(np.isfinite(both(found)))
    case = running(rpm=300.0, sq=0.3e-6, traction="eyring_sinh")
    back = replace(case, ring_speed=-case.ring_speed).friction(rung)
    assert both(back) == both(case.friction(rung))


def test_a_film_without_asperities_is_joined() -> None:
    """s -> 0 is reached without a step."""
    smooth, almost = (both(running(rpm=400.0, sq=sq).friction("over_ellipse")) for sq in (1e-10, 8e-9))
    np.testing.assert_allclose(almost, smooth, rtol=1e-6)


@pytest.mark.parametrize("rung", RUNGS)
def test_without_load_there_is_no_friction(rung: Rung) -> None:
    point = {"load": np.array([0.0, 613.0]), "semi_axis_rolling": np.array([0.0, 0.12e-3])}
    point["semi_axis_transverse"] = np.array([0.0, 1.1e-3])
    law = MixedTraction(
        lubricant=OIL, boundary_friction=0.11, asperity_share=0.2, area_fraction=0.01, film_thickness=90e-9
    )
    found = friction(pair(law, **point), rung)
    assert both(found)[0] == found.inner_coefficient[0] == found.outer_slip_speed[0] == 0
    assert both(found)[1] > 0
    inner, outer = pair(law, **{name: values[1] for name, values in point.items()})
    lifted = replace(inner, load=0.0, semi_axis_rolling=0.0, semi_axis_transverse=0.0)
    # Free to follow, to what the balance of spin leaves of its share; 0.1 N mm is what the contact can hold.
    assert friction((lifted, outer), rung).torque.outer_spin_moment == pytest.approx(0, abs=1e-8)


@settings(max_examples=25)
@given(
    load=st.floats(-6, 5),
    speed=st.floats(-6, 5),
    spin=st.floats(-8, 3),
    share=st.floats(0, 1),
    film=st.floats(-12, -4),
    traction=st.sampled_from(["eyring_constant", "eyring_sinh"]),
    rung=st.sampled_from(RUNGS),
)
def test_always_a_number(
    load: float, speed: float, spin: float, share: float, film: float, traction: str, rung: Rung
) -> None:
    law = MixedTraction(
        lubricant=replace(OIL, traction=traction),  # pyright: ignore[reportArgumentType]
        boundary_friction=0.12,
        asperity_share=share,
        area_fraction=share / 9,
        film_thickness=10.0**film,
    )
    size = np.cbrt(10.0**load / 613.0)
    races = pair(law, load=10.0**load, semi_axis_rolling=0.13e-3 * size, semi_axis_transverse=1.04e-3 * size)
    found = friction(races, rung, ring_speed=10.0**speed, spin_difference=10.0**spin)
    for value in (*vars(found.torque).values(), found.inner_coefficient, found.outer_slip_speed):
        assert np.isfinite(value)
    balance = found.torque.inner_spin_moment + found.torque.outer_spin_moment
    assert abs(balance) <= 1e-5 * abs(found.torque.inner_spin_moment) + 1e-300  # 1e-9 of a share, at up to 1e3 rad/s
    assert found.torque.spin >= 0
    assert found.torque.conformity >= -1e-9 * found.torque.spin  # round-off of the sums where spin is full


@settings(max_examples=5)
@given(metre=st.floats(1e-2, 1e2), newton=st.floats(1e-2, 1e2))
def test_physics_does_not_depend_on_the_units(metre: float, newton: float) -> None:
    def law(stress: float, length: float) -> MixedTraction:
        oil = replace(OIL, eyring_stress=stress)
        return MixedTraction(
            lubricant=oil, boundary_friction=0.12, asperity_share=0.1, area_fraction=0.01, film_thickness=length
        )

    sizes = {"semi_axis_rolling": 0.14e-3, "semi_axis_transverse": 1.2e-3, "deformed_radius": 4e-3}
    base = friction(pair(law(5e6, 1e-7), **sizes), "along_axis")
    scaled = {name: value * metre for name, value in sizes.items()} | {"load": 613.0 * newton}
    found = friction(pair(law(5e6 * newton / metre**2, 1e-7 * metre), **scaled), "along_axis")
    np.testing.assert_allclose(both(found), both(base) * newton * metre, rtol=1e-8)  # tolerance of the balance
    np.testing.assert_allclose(found.inner_slip_speed, base.inner_slip_speed * metre, rtol=1e-8)


def test_shapes_and_nonsense() -> None:
    races = pair(CoulombTraction(friction_coefficient=0.08), load=np.array([[100.0], [613.0]]))
    for rung in RUNGS:
        found = friction(races, rung, ring_speed=np.array([3.0, 30.0, 300.0]))
        assert both(found).shape == found.outer_coefficient.shape == found.inner_slip_speed.shape == (2, 3)
        assert np.all(np.diff(found.inner_slip_speed, axis=1) > 0)
    with pytest.raises(InputError, match='rung must be "single_coefficient"'):
        friction(races, "free")  # pyright: ignore[reportArgumentType]
    for rung in RUNGS:
        with pytest.raises(InputError, match='spin_rule must be "balanced"'):
            friction(races, rung, spin_rule="free")
    with pytest.raises(InputError, match="ring_speed must be finite"):
        friction(races, "along_axis", ring_speed=np.nan)
    with pytest.raises(InputError, match="give equal lengths"):
        friction(pair(CoulombTraction(friction_coefficient=0.08), load=np.ones(2)), "along_axis", ring_speed=np.ones(3))
    with pytest.raises(InputError, match="rolling_rate must be positive"):
        contact(CoulombTraction(friction_coefficient=0.08), rolling_rate=0.0)
