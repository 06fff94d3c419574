"""How far inputs spread: the scene's own standard deviation, else that of their origin, else a default."""

from dataclasses import replace

import numpy as np
import pytest

from analytic.prediction.spreads import DEFAULTS, UncertainInput, uncertain_inputs
from analytic.scene import Losses, Operation, Origin, Scene
from analytic.scenefile.keys import UNCERTAIN
from tests.analytic.specimens import BEARING_6205, FINISH, OIL
from tests.refusals import refused

SCENE = Scene(
    bearing=BEARING_6205,
    operation=Operation(axial_load=np.array([310.0, 470.0]), inner_speed=np.array([31.0, 47.0])),
    lubricant=OIL,
    surface=FINISH,
    losses=Losses(oil_flow=7e-6),
)
MEASURED = Origin(status="printed", uncertainty=0.0021, source="a data sheet")


def by_key(scene: Scene) -> dict[str, UncertainInput]:
    return {each.key: each for each in uncertain_inputs(scene)}


def evenly(low: float, high: float) -> float:
    """Standard deviation of numbers that lie evenly in a range."""
    return float(np.linspace(low, high, 100_001).std())


def test_every_input_with_a_spread_varies_by_default() -> None:
    found = by_key(SCENE)
    assert set(found) - {"model.traction"} <= set(DEFAULTS) <= set(UNCERTAIN)  # that of traction is the oil's own
    assert "bearing.ball_diameter" not in found  # without an origin it is known
    for key, deviation in (
        ("operation.axial_load", 0.01 * 470.0),
        ("lubricant.viscosity", 0.06 * 0.043),
        ("lubricant.temperature", 2.0),
        ("bearing.clearance", 2.5e-6),
    ):
        assert found[key].deviation == pytest.approx(deviation, rel=1e-12), key
        assert found[key].kind == "input"
    assert found["model.film"].kind == "model"
    # Rounded to 0.01 mm of a ball of 8 mm, and within a factor of 2: both evenly.
    np.testing.assert_allclose(found["bearing.inner.conformity"].deviation, evenly(-0.0006, 0.0006), rtol=1e-4)
    np.testing.assert_allclose(found["model.oil_losses"].deviation, evenly(-np.log(2), np.log(2)), rtol=1e-4)


def test_an_origin_goes_before_a_default_and_the_scene_before_both() -> None:
    stated = replace(SCENE, lubricant=replace(OIL, origins={"viscosity": MEASURED}))
    found = by_key(stated)["lubricant.viscosity"]
    assert (found.deviation, found.source) == (0.0021, "printed: a data sheet")
    said = by_key(replace(stated, uncertainty={"lubricant.viscosity": 0.0033}))["lubricant.viscosity"]
    assert (said.deviation, said.source) == (0.0033, "the scene")
    silent = replace(MEASURED, uncertainty=None)
    usual = by_key(replace(SCENE, lubricant=replace(OIL, origins={"viscosity": silent})))["lubricant.viscosity"]
    assert usual.deviation == pytest.approx(0.06 * 0.043, rel=1e-12)
    assert by_key(replace(SCENE, bearing=replace(BEARING_6205, origins={"ball_diameter": MEASURED})))[
        "bearing.ball_diameter"
    ].deviation == pytest.approx(0.0021, rel=1e-12)


def test_a_spread_of_no_input_is_refused() -> None:
    for key, words in (("lubricant.colour", "no input that varies"), ("friction.coefficient", "does not have")):
        refused(lambda: uncertain_inputs(replace(SCENE, uncertainty={key: 0.01})), f"uncertainty.{key}", words)  # noqa: B023
    refused(lambda: uncertain_inputs(replace(SCENE, uncertainty={"lubricant.viscosity": 0.2})), "300 %")


@pytest.mark.parametrize(("value", "floor"), [(0.043, 0.0), (0.52, 0.5)])
def test_what_lies_above_the_floor_is_lognormal(value: float, floor: float) -> None:
    """The median is the value; a small step of the score moves it by a small deviation; nothing is below the floor."""
    deviation = 0.003
    one = UncertainInput(
        key="lubricant.viscosity", kind="input", value=value, unit="", deviation=deviation, source="", floor=floor
    )
    assert one.at(np.array(0.0)) == pytest.approx(value, rel=1e-14)
    step = 1e-4
    slope = (one.at(np.array(step)) - one.at(np.array(-step))) / (2 * step)
    np.testing.assert_allclose(slope, deviation, rtol=1e-6)  # of the difference
    up, down = one.at(np.array([1.7, -1.7])) - floor
    np.testing.assert_allclose(up * down, (value - floor) ** 2, rtol=1e-12)  # round-off
    assert one.at(np.array(-40.0)) >= floor


def test_oil_fills_at_most_the_whole_space() -> None:
    """A lognormal share of 0.7 with half of it as its deviation exceeds 1 at a score of 0.72."""
    found = by_key(replace(SCENE, losses=Losses(oil_share=0.7)))["losses.oil_share"]
    np.testing.assert_allclose(
        found.at(np.array([-1.3, 0.0, 0.9, 4.0])), [0.7 * np.exp(-0.65), 0.7, 1.0, 1.0], rtol=1e-14
    )
