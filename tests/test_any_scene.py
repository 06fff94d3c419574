"""Every public function takes a Scene, or a name with what `load_scene` takes beside it."""

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import analytic
import fembearing
from tests.refusals import refused

GIVEN: dict[str, Any] = {"axial_load": "310 N", "speed": "700 rpm", "settings": {"friction.spin_rule": "balanced"}}
FUNCTIONS: dict[str, Callable[..., Any]] = {
    "friction_torque": analytic.friction_torque,
    "torque_function": analytic.torque_function,
    "predict": analytic.predict,
    "steady_scene": analytic.steady_scene,
    "duty_cycle": lambda scene, **given: analytic.duty_cycle(scene, "examples/duty_cycle.csv", **given),
    "solve_contact": lambda scene, **given: fembearing.solve_contact(scene, pair="inner", **given),
    "solve_load_series": lambda scene, **given: fembearing.solve_load_series(scene, pair="inner", loads=[9.0], **given),
    "validate": fembearing.validate,
    "compare_measured": fembearing.compare_measured,
    "draw_bearing": fembearing.draw_bearing,
    "export": lambda scene, **given: fembearing.export(scene, to="csv", out="new.csv", **given),
    "torque_of_scene": fembearing.torque_of_scene,
}


@pytest.mark.parametrize("name", FUNCTIONS)
@pytest.mark.parametrize("given", [None, {"bearing": "6206"}, b"6206"], ids=repr)
def test_what_is_no_name_is_refused(name: str, given: Any) -> None:
    refused(lambda: FUNCTIONS[name](given), f"{given!r} is not the name of a bearing or a file", 'example "6206"')
    refused(lambda: FUNCTIONS[name](6206), "6206 is a number, not the name of a bearing or a file; write it in quotes")


@pytest.mark.parametrize("name", FUNCTIONS)
def test_a_name_is_read_and_nothing_goes_beside_a_scene(name: str) -> None:
    scene = analytic.load_scene("6206")
    refused(lambda: FUNCTIONS[name]("62067"), "'62067' is not in the catalogue")
    refused(lambda: FUNCTIONS[name]("6206", sped="3 rpm"), "sped is no option of a bearing", "did you mean speed?")
    refused(lambda: FUNCTIONS[name](scene, speed="3 rpm"), "speed goes with a designation")
    refused(lambda: FUNCTIONS[name](scene, tolernce=0.1), "tolernce is no argument")


def test_a_name_gives_what_its_scene_gives() -> None:
    scene = analytic.load_scene("6206", **GIVEN)
    torque = analytic.friction_torque(scene).torque.total
    np.testing.assert_array_equal(analytic.friction_torque("6206", **GIVEN).torque.total, torque)
    shown = fembearing.torque_of_scene("6206", estimate=False, **GIVEN)
    np.testing.assert_array_equal(shown.friction.torque.total, torque)
    call = analytic.torque_function("6206", **GIVEN)
    speed = 700 * np.pi / 30
    np.testing.assert_allclose(call(axial_load=310.0, inner_speed=speed), torque[0], rtol=1e-12)  # the same kernel
    samples = analytic.predict("6206", samples=64, workers=1, **GIVEN)
    np.testing.assert_array_equal(samples.nominal.torque.total, torque)
