"""Torques by a user's law of traction: Eyring's as a user's, and any law against an integral of its definition."""

import math
import pickle
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from scipy.integrate import dblquad

from analytic.function import torque_function
from analytic.numerics.records import copied, record_in
from analytic.oil.law_table import law_address
from analytic.oil.own_law import ACCURACY, own_traction
from analytic.oil.traction import PointLaw
from analytic.scene import Bearing, ContactAngle, Operation, OwnTraction, Scene
from analytic.sliding.ellipse import Slider, quadrature_of, slip_sums
from analytic.torque import friction_torque
from tests.analytic.specimens import FINISH, OIL, present

EYRING = own_traction("eyring", math.asinh)
CARREAU = own_traction("carreau", lambda x: x * (1 + x * x) ** ((0.46 - 1) / 2))


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    return Scene(
        tolerance=0.01,
        bearing=bearing_6205,
        contact_angle=ContactAngle(rule="solved", free=0.31),
        operation=Operation(axial_load=np.array([410.0]), inner_speed=np.array([83.0])),
        lubricant=OIL,
        surface=replace(FINISH, rms_roughness=0.03e-6),  # the oil carries most of the load
        effects={"finite_geometry": "off"},
    )


def by(scene: Scene, law: OwnTraction) -> Scene:
    return replace(scene, lubricant=replace(OIL, traction=law))


CASES: dict[str, dict[str, Any]] = {
    "over the ellipse": {"spin_rule": "balanced"},
    "of one race": {"spin_rule": "outer_control"},
    "free": {"effects": {"finite_geometry": "off", "creep": "off"}},
    "creep, marched": {},
}


@pytest.mark.parametrize("name", CASES)
def test_eyrings_law_as_a_users_law_gives_the_torque_of_the_built_in_one(scene: Scene, name: str) -> None:
    one = replace(scene, **CASES[name])
    built_in, own = friction_torque(one), friction_torque(by(one, EYRING))
    # The stress errs by ACCURACY, the torque by less; free balls settle to 3e-7 from any start.
    np.testing.assert_allclose(own.torque.total, built_in.torque.total, rtol=ACCURACY)
    assert own.torque.total != built_in.torque.total  # else the table was not used
    other = friction_torque(by(one, CARREAU))
    assert abs(other.torque.race[0] / built_in.torque.race[0] - 1) > 1e-3
    assert built_in.provenance["traction"] == "eyring_sinh"
    assert own.provenance["traction"] == f"eyring, SHA-256 {EYRING.sha256[:12]}"


def test_a_function_of_time_steps_has_the_law(scene: Scene) -> None:
    functions = {name: torque_function(each) for name, each in (("eyring", scene), ("carreau", by(scene, CARREAU)))}
    point = {"axial_load": 410.0, "inner_speed": 83.0}
    for name, given in (("carreau", by(scene, CARREAU)), ("eyring", scene)):  # each keeps its own
        expected = friction_torque(given).torque.total[0]
        assert functions[name](**point) == pytest.approx(expected, rel=1e-6)  # of free balls from other starts
    assert functions["eyring"](**point) != pytest.approx(functions["carreau"](**point), rel=1e-4)
    sent = pickle.loads(pickle.dumps(functions["carreau"]))  # as to another process, where the table lies elsewhere
    numbers = copied(present(sent.model).numbers)
    numbers["warm"]["own"] = 0.0
    elsewhere = replace(sent, model=replace(present(sent.model), numbers=record_in(numbers)))
    assert elsewhere(**point) == pytest.approx(functions["carreau"](**point), rel=1e-6)


@pytest.mark.parametrize("law", [CARREAU, own_traction("newton", lambda x: x)], ids=lambda law: law.name)
def test_a_contact_that_slides_by_an_integral_of_its_definition(law: OwnTraction) -> None:
    """Power int tau |v| dA by an adaptive quadrature of min(S f(phi |v|), zeta p), with f as the user writes it."""
    functions = {"carreau": lambda x: x * (1 + x * x) ** ((0.46 - 1) / 2), "newton": lambda x: x}
    a, b, peak, roll, spin, creep = 0.13e-3, 1.2e-3, 0.9e9, 0.8e-3, 2.1e-3, 0.9e-3
    point = PointLaw(limit=0.055, eyring=5e6, fluidity=4e3, own=law_address(law))
    found = slip_sums(Slider(peak, a, b, roll), point, creep, spin, quadrature_of((96, 96)))

    def power(r: float, angle: float) -> float:
        x, y = r * math.cos(angle), r * math.sin(angle)
        speed = math.hypot((roll * y + spin) * y - creep, (spin + 2 * roll * y) * a / b * x)
        stress = min(5e6 * functions[law.name](4e3 * speed), 0.055 * peak * math.sqrt(max(1 - r * r, 0.0)))
        return stress * speed * a * b * r

    expected, _ = dblquad(power, 0, 2 * math.pi, 0, 1, epsabs=0, epsrel=1e-6)
    assert found.power == pytest.approx(expected, rel=2e-5)  # of the table, and the kinks at the limit between nodes
