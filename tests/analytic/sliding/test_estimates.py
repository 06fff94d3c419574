"""Estimates of the errors of sliding against the torque by many more nodes."""

from dataclasses import replace
from inspect import unwrap
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.numerics.records import Records
from analytic.oil.traction import PointLaw
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.sliding import judge
from analytic.sliding.ellipse import NO_SUMS, SlipSums, quadrature_of
from analytic.sliding.judge import (
    ALONG_AXIS,
    FINE,
    LEAST,
    METHODS,
    OVER_ELLIPSE,
    OWN_NODES,
    SINGLE_COEFFICIENT,
    error_of,
)
from analytic.sliding.long_ellipse import Slip
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

    With v_y it loses g A w_roll^2 a^2 b^2/(24 R^2) more. It rubs so little that a first step by a usual coefficient
    would be taken for the last.
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
        across = 0.0 if method == ALONG_AXIS else a**2 / 24
        power += viscosity * speed / h * np.pi * a * b * (roll * b / radius) ** 2 * (b**2 / 64 + across)
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


@pytest.mark.parametrize(("tolerance", "is_cheapest"), [(0.3, True), (0.001, False)])
def test_auto_takes_the_cheapest_method_that_is_accurate_enough(tolerance: float, is_cheapest: bool) -> None:
    """One coefficient is some per cent of the torque off by its own estimate."""
    scene = replace(load_scene("6206"), spin_rule="balanced", tolerance=tolerance)
    found = friction_torque(scene)
    assert (found.sliding == "single_coefficient") == is_cheapest
    assert float(found.numerical_uncertainty.max()) < tolerance


SLIPS = Slip(0.31, 2.3, 0.7, 0.1, 0.0, 1.7), Slip(-0.19, -3.1, 0.4, 0.1, 0.0, 2.9)  # creep is the last one
OWN = 2.3 * 0.31 + 0.7 * 2.0, 3.1 * 0.19 + 0.4 * 3.0  # powers, with rolling rates of 2 and 3
LAW = PointLaw(boundary=0.05, limit=0.06, eyring=5e6, fluidity=1e3)


class Judged:
    """`judged` with sums that are drawn for each race and each set of nodes."""

    def __init__(self, patch: pytest.MonkeyPatch, method: int, law: PointLaw = LAW, *, force: float = 0.1) -> None:
        random = np.random.default_rng(method)
        self.powers = random.uniform(0.7, 1.3, (2, 5, 3))
        self.forces = force * random.normal(size=(2, 5))
        self.calls: list[tuple[int, int, bool, float]] = []

        def sums(slider: Any, _law: Any, creep: float, spin: float, nodes: int, sideways: bool) -> SlipSums:
            assert creep == SLIPS[slider.race].creep
            self.calls.append((slider.race, nodes, sideways, spin))
            far, middle, near = self.powers[slider.race, nodes].tolist()
            force = float(self.forces[slider.race, nodes])
            return NO_SUMS._replace(far_power=far, middle_power=middle, near_power=near, force=force)

        patch.setattr(judge, "slip_sums", sums)
        patch.setattr(judge, "slider_of", lambda contact: SimpleNamespace(race=contact.race, transverse=1e-3))
        patch.setattr(judge, "at_ring_speed", lambda law, _: law)
        contacts: Any = tuple(SimpleNamespace(race=race, rolling_rate=2.0 + race) for race in range(2))
        self.missed, self.whole = unwrap(judge.judged)(contacts, (law, law), SLIPS, 31.0, method, range(5))

    def off(self, own: int, other: int) -> Any:
        """(2, 3) of two sets of nodes, by panels."""
        return np.abs(self.powers[:, own] - self.powers[:, other])

    def pulls(self, own: int, other: int) -> float:
        """Power by the difference of the net forces."""
        return float(np.abs(self.forces[:, own] - self.forces[:, other]) @ [slip.creep for slip in SLIPS])


@pytest.mark.parametrize("force", [0.001, 3.0])  # less, or more, than the power's differences
@pytest.mark.parametrize(
    ("method", "own", "judges"), [(ALONG_AXIS, 0, (1, 1)), (OVER_ELLIPSE, 0, (2, 1)), (FINE, 1, (3, 4))]
)
def test_other_nodes_judge_panel_by_panel(
    monkeypatch: pytest.MonkeyPatch, method: int, own: int, judges: tuple[int, int], force: float
) -> None:
    """Differences of powers, or of the net force times the creep; twice the only one, three times the larger of two."""
    found = Judged(monkeypatch, method, force=force)
    slipped = np.maximum(*(found.off(own, other) for other in judges)).sum()
    pulled = max(found.pulls(own, other) for other in judges)
    assert (pulled > slipped) == (force > 1)
    assert found.missed == pytest.approx((2 if method == ALONG_AXIS else 3) * max(slipped, pulled), rel=1e-12)
    assert found.whole == pytest.approx(found.powers[:, own].sum(), rel=1e-12)
    sideways = {(nodes, sideways) for _, nodes, sideways, _ in found.calls}
    assert sideways == {(own, method != ALONG_AXIS), *((other, True) for other in judges)}
    assert {spin for race, _, _, spin in found.calls if race == 1} == {0.19e-3}


@pytest.mark.parametrize("force", [0.001, 3.0])
def test_a_single_coefficient_is_judged_by_the_whole_power(monkeypatch: pytest.MonkeyPatch, force: float) -> None:
    found = Judged(monkeypatch, SINGLE_COEFFICIENT, force=force)
    each = np.maximum(
        np.abs(found.powers[:, 0].sum(axis=1) - OWN), np.abs(found.forces[:, 0]) * [slip.creep for slip in SLIPS]
    )
    assert found.missed == pytest.approx(2 * each.sum(), rel=1e-12)
    assert found.whole == pytest.approx(sum(OWN), rel=1e-12)
    assert [(nodes, sideways) for _, nodes, sideways, _ in found.calls] == [(0, True)] * 2


@pytest.mark.parametrize(
    ("method", "numbers", "factors"),
    [
        (SINGLE_COEFFICIENT, (1, 2), (2, 2)),
        (ALONG_AXIS, (1, 2), (2, 2)),
        (OVER_ELLIPSE, (1, 2), (3, 3)),
        (FINE, (2, 3, 4), (0.25, 3, 3)),
    ],
)
@pytest.mark.parametrize("worst", [1, 2, 3, 4])
def test_spin_alone_is_judged_by_nodes_with_a_share_of_their_own(
    monkeypatch: pytest.MonkeyPatch, method: int, numbers: tuple[int, ...], factors: tuple[float, ...], worst: int
) -> None:
    """Coarser nodes than the finest count a quarter; the largest of all counts."""
    tried: list[tuple[int, float, int]] = []

    def slips(
        _contacts: Any, _laws: Any, _speed: float, difference: float, rule: int, nodes: int, sideways: bool
    ) -> Any:
        tried.append((nodes, difference, rule))
        assert sideways
        more = 5.0 if nodes == worst else 1.0
        inner = SLIPS[0]._replace(spin_moment=2.3 - 0.02 * more, spin_rate=0.30)
        outer = SLIPS[1]._replace(spin_moment=-3.1 - 0.05 * more, spin_rate=-0.20)
        return inner, outer, 7 if nodes != broken else 0

    monkeypatch.setattr(judge, "slips_over_contacts", slips)
    powers, broken = (2.3 * 0.31, 3.1 * 0.19), 0

    def changed(more: float) -> float:
        return abs((2.3 - 0.02 * more) * 0.30 - powers[0]) + abs((3.1 + 0.05 * more) * 0.20 - powers[1])

    by_spin = unwrap(judge.judged_spin)
    missed, whole = by_spin(None, None, SLIPS, 31.0, 2, method, range(5))
    expected = max(f * changed(5.0 if n == worst else 1.0) for n, f in zip(numbers, factors, strict=True))
    assert missed == pytest.approx(expected, rel=1e-12)
    assert whole == pytest.approx(sum(powers), rel=1e-12)
    assert tried == [(number, pytest.approx(0.5), 2) for number in numbers]
    broken = numbers[-1]
    assert by_spin(None, None, SLIPS, 31.0, 2, method, range(5)) == (np.inf, 0.0)


def test_a_small_share_of_the_power_is_the_least_error() -> None:
    assert error_of(0.0, 3.0) == pytest.approx(3e-6, rel=1e-12)
    assert error_of(0.2, 3.0) == pytest.approx(0.2 + 3e-6, rel=1e-12)
    assert error_of(0.2, 0.0) == error_of(0.2, -1e-20) == 0.0
