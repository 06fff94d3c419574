"""Estimates of the errors of sliding, from several rules at the sliding that a method found."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.loads.balls import LoadEffects, ring_balls, thrust_balls
from analytic.oil.lubricated_races import lubricate_races
from analytic.oil.traction import CoulombTraction
from analytic.oil.variation import Variation
from analytic.scene import Bearing, ContactAngle, Lubricant, Operation
from analytic.sliding import methods
from analytic.sliding.ball import SlipFriction, SlipRule
from analytic.sliding.ellipse import SlipMoments, slip_over_ellipse
from analytic.sliding.judge import LEAST
from analytic.sliding.methods import QUADRATURES, Sliders, SlidingModel
from tests.analytic.specimens import FINISH, OIL

FAST = LoadEffects(load_distribution=False, centrifugal=True, gyroscopic=False)
MODEL = SlidingModel(spins=True, conforms=True, spin_rule="balanced", microslip="derived", method="auto")
REFERENCE = (96, 96)  # nodes: 16 times as many as the finest method has


def sliders(bearing: Bearing, *, load: float, rpm: np.ndarray, oil: Lubricant | None) -> Sliders:
    """An angular contact bearing of 15 degrees like a 7205C; without oil by Coulomb friction."""
    rings = {
        race: replace(getattr(bearing, race), groove_radius=conformity * bearing.ball_diameter)
        for race, conformity in {"inner": 0.52, "outer": 0.53}.items()
    }
    speed = rpm * np.pi / 30
    operation = Operation(axial_load=np.full_like(speed, load), inner_speed=speed)
    angle = ContactAngle(rule="solved", free=np.deg2rad(15))
    balls = thrust_balls(replace(bearing, **rings), angle, operation, FAST)
    if oil is None:
        law = CoulombTraction(friction_coefficient=0.07)
        return Sliders(balls=balls, traction=(law, law), model=MODEL, ring_speed=speed)
    races = lubricate_races(
        replace(bearing, **rings), balls, lubricant=oil, surface=FINISH, ring_speed=speed, variation=Variation()
    )
    mixed = races.mixed(asperities=True, film_factor=1.0)
    laws = races.traction(mixed.race(0)), races.traction(mixed.race(1))
    return Sliders(balls=balls, traction=laws, model=MODEL, ring_speed=speed)


def by_itself(case: Sliders, result: SlipFriction, nodes: tuple[int, int]) -> list[SlipMoments]:
    """Each race at the spin that a method found, with a creep of its own."""
    rates = result.torque.inner_spin_rate, result.torque.outer_spin_rate
    found = []
    for contact, traction, rate in zip(case.balls.races, case.traction, rates, strict=True):
        law = traction.point_law
        with np.errstate(invalid="ignore"):  # at standstill the film is 0 too
            fluidity = np.asarray(law.fluidity) * np.abs(case.ring_speed[:, None])
        found.append(slip_over_ellipse(contact, law=law._replace(fluidity=fluidity), spin_rate=rate, nodes=nodes))
    return found


def errors(case: Sliders, quadrature: SlipRule) -> tuple[np.ndarray, np.ndarray]:
    """True and estimated, relative to the power of the method."""
    result = case.slide(quadrature)
    true = sum(each.slip_power.sum(axis=1) for each in by_itself(case, case.slide(QUADRATURES[-1]), REFERENCE))
    own = np.sum(result.torque.spin + result.torque.conformity, axis=1)
    return np.abs(true / own - 1), case.errors_at(result)(quadrature)


@pytest.mark.parametrize("quadrature", QUADRATURES, ids=lambda each: f"{each.method}{each.nodes}")
@pytest.mark.parametrize("load", [0.3, 97.0, 900.0])
@pytest.mark.parametrize("viscosity", [0.01, 1.0])
def test_the_estimate_is_above_the_error_and_not_far(
    bearing_6205: Bearing, quadrature: SlipRule, load: float, viscosity: float
) -> None:
    """At 16 290 1/min and other speeds, where the position of the kink makes the error change sign."""
    case = sliders(
        bearing_6205,
        load=load,
        rpm=np.array([0.01, 30.0, 1000.0, 6000.0, 16290.0]),
        oil=replace(OIL, viscosity=viscosity),
    )
    true, stated = errors(case, quadrature)
    assert np.all(true <= stated)
    matters = true > 1e-4  # a tenth of the strictest tolerance that is promised
    assert not matters.any() or np.median(stated[matters] / true[matters]) < 10  # of few; 3 in the median of many


def test_rules_agree_where_the_stress_is_smooth(bearing_6205: Bearing) -> None:
    case = sliders(bearing_6205, load=97.0, rpm=np.array([700.0]), oil=None)
    _, stated = errors(case, QUADRATURES[-1])
    np.testing.assert_allclose(stated, LEAST, rtol=0.1)  # the rules themselves differ by 1e-9


def test_viscous_contacts_find_their_creep(bearing_6205: Bearing) -> None:
    """Friction of 1e-9 of the load: a first step by a usual coefficient would be taken for the last."""
    thin = replace(OIL, viscosity=1.0, pressure_viscosity=1e-9)
    case = sliders(bearing_6205, load=0.1, rpm=np.array([0.01]), oil=thin)
    result = case.slide(QUADRATURES[2])
    inner, outer = by_itself(case, result, (12, 8))  # from another start
    np.testing.assert_allclose(result.inner_creep, inner.creep_speed, rtol=1e-9)  # round-off of a sum of few parts
    np.testing.assert_allclose(result.outer_creep, outer.creep_speed, rtol=1e-9)


def test_a_long_series_is_estimated_again_where_its_sample_is_not_good_enough(
    bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(methods, "SERIES", 9)
    monkeypatch.setattr(methods, "JUDGED", 4)
    load, speed = np.linspace(230.0, 1900.0, 9), np.linspace(11.0, 97.0, 9)
    operation = Operation(axial_load=load, radial_load=0.7 * load[::-1], inner_speed=speed)
    balls = ring_balls(bearing_6205, ContactAngle(rule="solved"), operation, LoadEffects(gyroscopic=False))
    law = CoulombTraction(friction_coefficient=0.07)
    case = Sliders(balls=balls, traction=(law, law), model=MODEL, ring_speed=speed)
    along_axis = QUADRATURES[1]
    own = case.errors_at(case.slide(along_axis))(along_axis)
    strict = np.array([True, False, False, True, True, False, True, False, False])
    found = case.result(along_axis, np.where(strict, 0.5 * own.min(), 2 * own.max()))
    assert found is not None
    np.testing.assert_array_equal(found.error[strict], own[strict])
    bound = found.error[~strict]
    assert np.ptp(bound) == 0
    assert own.max() < bound[0] < 1.25 * own.max() * (1 + 1e-12)  # the sample has nearly the largest of all
