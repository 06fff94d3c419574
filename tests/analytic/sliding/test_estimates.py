"""Estimates of the errors of sliding against the torque by many more nodes."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.special import ellipe

from analytic.numerics.records import Records
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.sliding.ellipse import quadrature_of
from analytic.sliding.judge import (
    ALONG_AXIS,
    BELOW_FULL_SPIN,
    FINE,
    LEAST,
    METHODS,
    OVER_ELLIPSE,
    OWN_NODES,
    SINGLE_COEFFICIENT,
    error_of_long_ellipse,
)
from analytic.solve.model import Model, model_of
from analytic.solve.records import SETTLED
from analytic.solve.solution import points_of, solved
from analytic.torque import friction_torque
from tests.analytic.specimens import FINISH, OIL, drawn, without

KINDS = (SINGLE_COEFFICIENT, ALONG_AXIS, OVER_ELLIPSE, FINE)
COUNTED: dict[str, bool] = dict.fromkeys(("centrifugal", "asperities", "spin", "conformity"), True)
MANY = (96, 96)  # nodes: 16 times as many as the finest method has
BY_LOADS = ("load_distribution", "centrifugal", "gyroscopic", "weight", "finite_geometry")


def angular_contact(bearing: Bearing, *, load: float, rpm: Array, **friction: Any) -> Scene:
    """A bearing of 15 degrees like a 7205C; friction : fields of the scene that set it"""
    rings = {
        race: replace(getattr(bearing, race), groove_radius=conformity * bearing.ball_diameter)
        for race, conformity in {"inner": 0.52, "outer": 0.53}.items()
    }
    return Scene(
        name="sliding",
        bearing=replace(bearing, **rings),
        contact_angle=ContactAngle(rule="solved", free=np.deg2rad(15)),
        operation=Operation(axial_load=np.full_like(rpm, load), inner_speed=rpm * np.pi / 30),
        spin_rule="balanced",
        **friction,
    )


def oiled(**changed: Any) -> dict[str, Any]:
    return {"lubricant": replace(OIL, **changed), "surface": FINISH}


def slid(scene: Scene, model: Model) -> Records:
    found = solved(model, points_of(scene.operation, model.temperature)).points
    np.testing.assert_array_equal(found["status"], SETTLED)
    return found


def by_many_nodes(scene: Scene, counted: dict[str, bool]) -> Records:
    """The whole solution by the finest method, with other nodes."""
    model = model_of(scene, counted, method=FINE, judges=False)
    nodes = model.tables.nodes.copy()
    nodes[OWN_NODES[FINE]] = quadrature_of(MANY)
    return slid(scene, replace(model, tables=model.tables._replace(nodes=nodes)))


def sliding_of(points: Records) -> Array:
    return points["spin"] + points["conformity"]


FRICTIONS = {
    "thin": oiled(viscosity=0.01),
    "thick": oiled(viscosity=1.0),
    "even": oiled(viscosity=0.1, traction="eyring_constant"),
    "dry": {"friction_coefficient": 0.07},
}


@pytest.mark.parametrize("friction", FRICTIONS)
@pytest.mark.parametrize("load", [0.3, 97.0, 900.0])
@pytest.mark.parametrize("conforms", [True, False], ids=["both", "spin alone"])
def test_the_estimate_is_above_the_error_and_not_far(
    bearing_6205: Bearing, load: float, friction: str, conforms: bool
) -> None:
    """At 16 290 1/min and other speeds, where the position of the kink makes the error change sign.

    An error of the creep changes spin and conformity together in second order, and spin alone in first order.
    """
    rpm, counted = np.array([0.01, 30.0, 1000.0, 6000.0, 16290.0]), COUNTED | {"conformity": conforms}
    scene = angular_contact(bearing_6205, load=load, rpm=rpm, **FRICTIONS[friction])
    true = sliding_of(by_many_nodes(scene, counted))
    for method in KINDS:
        found = slid(scene, model_of(scene, counted, method=method))
        error, stated = np.abs(sliding_of(found) - true), found["sliding_error"]
        assert np.all(error <= stated)
        matters = error > 1e-4 * true  # a tenth of the strictest tolerance that is promised
        assert not matters.any() or np.median(stated[matters] / error[matters]) < 10  # of few; 3 in the median of many


def test_nodes_agree_where_the_stress_is_smooth(bearing_6205: Bearing) -> None:
    scene = angular_contact(bearing_6205, load=97.0, rpm=np.array([700.0]), friction_coefficient=0.07)
    found = slid(scene, model_of(scene, COUNTED, method=FINE))
    least = LEAST * sliding_of(found)
    np.testing.assert_allclose(found["sliding_error"], least, rtol=0.1)  # the nodes themselves differ by 1e-9


@pytest.mark.parametrize("method", [ALONG_AXIS, OVER_ELLIPSE, FINE])
def test_viscous_contacts_find_their_creep(bearing_6205: Bearing, method: int) -> None:
    """A Newtonian film without spin, tau = g v over the area A: each contact loses g A w_roll^2 b^4/(64 R^2).

    It rubs so little that a first step by a usual coefficient would be taken for the last.
    """
    viscosity, speed = 0.9, 0.7  # Pa s, rad/s
    oil = oiled(viscosity=viscosity, pressure_viscosity=1e-13)
    oil["surface"] = replace(FINISH, boundary_friction=0.0)
    scene = angular_contact(bearing_6205, load=0.1, rpm=np.array([speed * 30 / np.pi]), **oil)
    model = model_of(scene, dict.fromkeys(("centrifugal", "conformity"), True), method=method)
    found = solved(model, points_of(scene.operation, model.temperature))
    ball, bearing, power = found.balls[0, 0], scene.bearing, 0.0
    for race, groove in enumerate((bearing.inner, bearing.outer)):
        a, b, h = (ball[name][race] for name in ("semi_axis_rolling", "semi_axis_transverse", "film"))
        roll = ball["motion"][("inner_rolling_rate", "outer_rolling_rate")[race]]
        radius = 2 / (1 / groove.groove_radius + 1 / bearing.ball_radius)
        power += viscosity * speed / h * np.pi * a * b * (roll * b**2 / (8 * radius)) ** 2
    assert ball["friction_coefficient"].max() < 1e-9
    # At 1e-13 of the viscosity for each Pa the oil is 1e-5 thicker in the middle of the contact.
    np.testing.assert_allclose(found.points["conformity"], bearing.ball_count * power, rtol=2e-5)


@pytest.mark.parametrize("method", [METHODS[SINGLE_COEFFICIENT], METHODS[ALONG_AXIS]])
@pytest.mark.parametrize("seed", range(40, 44))
def test_the_error_of_a_method_is_within_the_uncertainty_that_the_result_states(
    bearing_6205: Bearing, seed: int, method: Any
) -> None:
    drawn_scene = drawn(bearing_6205, np.random.default_rng(seed), points=6)
    still = replace(drawn_scene.operation, radial_load=0.0)
    without_use = ("starvation",) if drawn_scene.surface else ("starvation", "inlet_heating")  # without rolling
    others = ("hysteresis", "rolling", "creep")  # of closed kinematics, as the rules of `drawn`
    plain = without(replace(drawn_scene, operation=still), *BY_LOADS, *others, *without_use)
    exact = friction_torque(replace(plain, sliding="over_ellipse")).torque.total
    found = friction_torque(replace(plain, sliding=method))
    assert np.all(np.abs(found.torque.total / exact - 1) <= found.numerical_uncertainty)


@pytest.mark.parametrize(("tolerance", "method"), [(0.3, "single_coefficient"), (0.003, "along_axis")])
def test_auto_takes_the_cheapest_method_that_is_accurate_enough(tolerance: float, method: str) -> None:
    """One coefficient is 5 % off by its own estimate (2.8 % by the other method), the sum along the axis far less."""
    scene = replace(load_scene("6206"), spin_rule="balanced", tolerance=tolerance)
    found = friction_torque(scene)
    assert found.sliding == method
    assert float(found.numerical_uncertainty.max()) < tolerance


@pytest.mark.parametrize("ratio", [0.0, 1e-9, 3e-3, 0.21, 0.98, 1.0, 1.7])  # the last one is longer along rolling
def test_the_error_of_a_long_ellipse_is_that_of_its_perimeter(ratio: float) -> None:
    b = 0.83e-3
    expected = BELOW_FULL_SPIN * (ellipe(1 - min(ratio, 1.0) ** 2) - 1)
    assert error_of_long_ellipse(ratio * b, b) == pytest.approx(expected, rel=1e-12, abs=1e-14)  # round-off of E(m) - 1
