"""A numerical film beside the formulas of the torque: what is compared, its verdict, what it changes in the torque."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.errors import InputError
from analytic.oil.film import FILM_FACTORS
from analytic.scene import Operation, Scene
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.film.scene_film import ClosedForms, compare_film, problem_of
from fembearing.grid_convergence import Estimate
from tests.analytic.specimens import present

BALLS = 9  # of a 6205


def scene_text(formula: str) -> str:
    """Full film, isothermal and flooded: what the numerical solution is."""
    return f"""name = "test"
tolerance = "5 %"
[bearing]
catalog = "6205"
[operation]
axial_load = "730 N"
inner_speed = "640 rpm"
[friction]
coefficient = 0.05
spin_rule = "balanced"
[lubricant]
name = "ISO VG 46"
temperature = "52C"
rolling_formula = "{formula}"
[effects]
inlet_heating = "off"
starvation = "off"
centrifugal = "off"
gyroscopic = "off"
finite_geometry = "off"
weight = "off"
"""


@pytest.mark.parametrize("formula", ["numerical", "biboulet", "houpert"])
def test_the_rolling_force_is_that_of_the_torque(formula: str) -> None:
    """Both surfaces of a contact carry it at the entrainment speed: the power of all balls is 2 Z F V on each race."""
    scene = parse_scene(scene_text(formula), origin="here")
    power = 0.0
    for pair in ("inner", "outer"):
        closed = problem_of(scene, pair)
        force, _ = closed.model_force()
        power += 2 * BALLS * force * abs(closed.inflow.speed)
    rolling = friction_torque(scene).torque.rolling
    assert rolling is not None
    # The torque takes the oil's reach at the unloaded contact angle, and the fit alone depends on it: 0.09 % here.
    np.testing.assert_allclose(power / closed.inner_speed, rolling, rtol=2e-3 if formula == "numerical" else 1e-6)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return parse_scene(scene_text("numerical"), origin="here")


@pytest.fixture(scope="module")
def closed(scene: Scene) -> ClosedForms:
    return problem_of(scene, "outer")


def part(value: float, uncertainty: float) -> Estimate:
    """With 0.8 of its relative uncertainty from the grids and 0.6 from the region."""
    return Estimate(values=(value,), order=2.1, richardson=None, mesh=0.8 * uncertainty, domain=0.6 * uncertainty)


def compared(closed: ClosedForms, *, film: float = 1.0, force: float = 1.0, least: float = 1.0) -> Any:
    """With so many times the films and the force that production takes."""
    solution: Any = SimpleNamespace(
        central_film=part(film * closed.model_film(), 0.01),
        minimum_film=part(least * closed.minimum_ratio() * closed.model_film(), 0.02),
        rolling_force=part(force * closed.model_force()[0], 0.03),
        pressure_centre=part(-3e-6, 0.04),
        dissipated_force=part(0.013, 0.05),
        seconds=7.0,
    )
    return compare_film(replace(closed, inner_speed=-67.0), solution, tolerance=0.05).numbers


def test_each_quantity_stands_beside_its_formula_with_its_uncertainty(closed: ClosedForms) -> None:
    found = compared(closed, film=0.9, force=1.1)
    film, least, force = (found.quantities[name] for name in ("central_film", "minimum_film", "rolling_force"))
    assert (film.formula, film.production) == (closed.film(), closed.model_film())
    assert (force.formula, force.production) == (float(closed.resistance().force), closed.model_force()[0])
    assert film.discrepancy == pytest.approx(1 / 0.9 - 1, rel=1e-9)
    assert force.discrepancy == pytest.approx(1 / 1.1 - 1, rel=1e-9)
    assert least.formula / film.formula == pytest.approx(closed.minimum_ratio(), rel=1e-12)
    assert least.production / film.production == pytest.approx(closed.minimum_ratio(), rel=1e-12)
    for name, share in (("central_film", 0.01), ("rolling_force", 0.03), ("pressure_centre", 0.04)):
        each = found.quantities[name]
        assert each.relative_uncertainty == pytest.approx(share, rel=1e-12)
        assert each.uncertainty == pytest.approx(share * abs(each.reference), rel=1e-12)
    assert found.worst == ("rolling_force", pytest.approx(0.03, rel=1e-12))  # the centre of pressure is not judged
    assert (found.inner_speed, found.seconds, found.dissipated_force) == (-67.0, 7.0, 0.013)


def test_the_load_off_the_centre_balances_the_moment_of_the_rolling_forces(closed: ClosedForms) -> None:
    """Both surfaces roll with the same force at the radius of the undeformed gap: 2 F R_x = Q x."""
    found = compared(closed)
    for name in ("formula", "production"):
        force, centre = (
            getattr(found.quantities["rolling_force"], name),
            getattr(found.quantities["pressure_centre"], name),
        )
        assert centre * found.load == pytest.approx(2 * force * closed.problem.shape.radii[0], rel=1e-12)


@pytest.mark.parametrize(
    ("film", "force", "verdict"), [(1.0, 1.0, "pass"), (3.0, 1.0, "fail"), (1.0, 3.0, "fail"), (0.3, 1.0, "fail")]
)
def test_film_and_force_are_judged_by_the_stated_errors_of_the_model(
    closed: ClosedForms, film: float, force: float, verdict: str
) -> None:
    assert compared(closed, film=film, force=force).verdict == verdict


@pytest.mark.parametrize(("least", "verdict"), [(1.1, "pass"), (0.3, "fail"), (FILM_FACTORS[0], "undecided")])
def test_the_minimum_film_has_its_own_verdict(closed: ClosedForms, least: float, verdict: str) -> None:
    for film, common in ((1.0, "pass"), (3.0, "fail")):
        found = compared(closed, film=film, least=least)
        assert (found.quantities["minimum_film"].verdict, found.verdict) == (verdict, common)


def test_a_contact_takes_the_load_and_the_speed_that_are_asked_for(scene: Scene) -> None:
    own = problem_of(scene, "inner")
    speed = own.inner_speed
    assert speed == pytest.approx(640 * np.pi / 30, rel=1e-12)
    other = problem_of(scene, "inner", load=2.5 * own.contact.load, inner_speed=-3 * speed)
    assert other.contact.load == 2.5 * own.contact.load
    assert other.inner_speed == -3 * speed
    assert abs(other.problem.speed / own.problem.speed) == pytest.approx(3.0, rel=1e-9)
    oil, ball = present(scene.lubricant), scene.bearing.ball_diameter / 2
    for side in ("ahead", "behind"):
        assert getattr(own.problem.reach, side) == pytest.approx(getattr(oil.reach, side) * ball, rel=1e-12)


def test_without_oil_or_motion_there_is_no_film(scene: Scene) -> None:
    with pytest.raises(InputError, match=r"dry, without a film: add a table \[lubricant\]"):
        problem_of(replace(scene, lubricant=None), "inner")
    still = Operation(axial_load=np.array([730.0]), inner_speed=np.array([0.0]))
    with pytest.raises(InputError, match="at standstill there is no film"):
        problem_of(replace(scene, operation=still), "inner")
    with pytest.raises(InputError, match="at standstill"):
        problem_of(scene, "inner", inner_speed=0.0)
