"""Which inputs of a scene a prediction varies, about which value, and what the scene says of their origin."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Arrangement, Clearances, ContactAngle, Losses, Operation, Origin, Scene, ShearedPockets
from analytic.scenefile.inputs import checked_deviation, known_inputs, stated_inputs, uncertain_value
from analytic.scenefile.keys import UNCERTAIN
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, STAMPED_CAGE, present
from tests.analytic.test_thrust_bearing import BEARING as THRUST_BEARING
from tests.refusals import refused

GREASE = replace(OIL, supply="grease", surface_tension=0.027)
WHOLE = Scene(
    bearing=BEARING_6205,
    operation=Operation(
        axial_load=np.array([310.0, 470.0]), inner_speed=np.array([31.0, 47.0]), radial_load=np.array([60.0, -95.0])
    ),
    cage=replace(STAMPED_CAGE, friction_coefficient=0.13, start="whirl"),
    lubricant=OIL,
    surface=FINISH,
    hysteresis_loss=0.0085,
    losses=Losses(seals=5e-3, oil_share=0.03),
)
VALUES = {  # of this scene, typed in a second time; the clearance is 2 (23.48 - 15.53 - 7.94) mm
    "bearing.ball_diameter": 7.94e-3,
    "bearing.pitch_diameter": 39.01e-3,
    "bearing.clearance": 20e-6,
    "bearing.inner.conformity": 4.13 / 7.94,
    "bearing.outer.conformity": 4.21 / 7.94,
    "operation.axial_load": 470.0,
    "operation.radial_load": 95.0,
    "lubricant.viscosity": 0.043,
    "lubricant.temperature": 313.15,
    "lubricant.pressure_viscosity": 1.9e-8,
    "lubricant.eyring_stress": 4.7e6,
    "lubricant.limiting_shear": 0.06,
    "lubricant.reach.ahead": 0.9,
    "surface.rms_roughness": 0.21e-6,
    "surface.autocorrelation.length": 43e-6,
    "surface.boundary_friction": 0.11,
    "surface.hardness": 7.3e9,
    "friction.hysteresis_loss": 0.0085,
    "losses.seals": 5e-3,
    "losses.oil_share": 0.03,
    "cage.friction_coefficient": 0.13,
    "model.film": 1.0,
    "model.traction": 1.0,
    "model.gap": 0.0,
    "model.surfaces": 1.0,
    "model.rolling": 1.0,
    "model.heating": 1.0,
    "model.starvation": 0.0,
    "model.elastic_rolling": 0.0,
    "model.unloaded_balls": 1.0,
    "model.oil_losses": 1.0,
}
MIXED = ("film", "traction", "gap", "surfaces")  # factors on formulas of mixed lubrication
LAW = ("pressure_viscosity", "eyring_stress", "limiting_shear")  # of the oil, which traction alone asks for
ROUGH = ("rms_roughness", "autocorrelation.length", "boundary_friction", "hardness")


def none_of(table: str, *names: str) -> dict[str, None]:
    return dict.fromkeys(f"{table}.{name}" for name in names)


def values_of(scene: Scene) -> dict[str, float]:
    return {key: value for key in UNCERTAIN if (value := uncertain_value(scene, key)) is not None}


def test_a_scene_varies_what_its_torque_asks_for() -> None:
    found = values_of(WHOLE)
    assert set(found) == set(VALUES)
    for key, value in VALUES.items():
        assert found[key] == pytest.approx(value, rel=1e-11), key  # round-off of the clearance


SMOOTH_MIXED = none_of("model", *MIXED) | none_of("surface", *ROUGH) | none_of("lubricant", *LAW)
OTHERWISE = {"model.unloaded_balls": None, "model.starvation": None}  # in a grease, or by a degree
STARVED = {"lubricant.surface_tension": 0.027, "model.grease_film": 1.0} | OTHERWISE
NO_LOSS = {"friction.hysteresis_loss": None, "model.elastic_rolling": None}


@pytest.mark.parametrize(
    ("changed", "expected"),
    [
        ({"operation": replace(WHOLE.operation, moment=np.array([0.4, -0.7]))}, {"operation.moment": 0.7}),
        (
            {"operation": replace(WHOLE.operation, radial_load=0.0)},
            {"operation.radial_load": None, "model.unloaded_balls": None},
        ),
        (
            {"contact_angle": ContactAngle(rule="solved", free=0.26)},
            {"bearing.contact_angle.free": 0.26, "bearing.clearance": None},
        ),
        (
            {"contact_angle": ContactAngle(rule="given", value=0.31, free=0.26)},
            {"bearing.contact_angle.value": 0.31, "bearing.clearance": None},
        ),
        (
            {"arrangement": Arrangement(kind="O", preload=130.0, distance=0.03)},
            {"arrangement.preload": 130.0},
        ),
        ({"cage": None}, {"cage.friction_coefficient": None}),
        ({"losses": Losses(drag=2e-3)}, {"losses.seals": None, "losses.oil_share": None, "losses.drag": 2e-3,
                                         "model.oil_losses": None}),
        ({"losses": Losses(seals=0.0, pockets=ShearedPockets(clearance=2e-4, thickness=9e-4))},
            {"losses.seals": None, "losses.oil_share": None}),
        ({"elastic_rolling": "houpert"}, {"friction.hysteresis_loss": None}),
        ({"hysteresis_loss": None}, {"friction.hysteresis_loss": 0.007}),  # the usual one
        ({"hysteresis_loss": 0.0}, NO_LOSS),
        ({"effects": {"hysteresis": "off"}}, NO_LOSS),
        ({"effects": {"unloaded_balls": "off"}}, {"model.unloaded_balls": None}),
        ({"lubricant": replace(OIL, supply="oil_jet")}, {"model.unloaded_balls": None}),
        # A coefficient takes the place of the surface; the oil still rolls.
        ({"surface": None, "friction_coefficient": 0.07}, SMOOTH_MIXED | {"friction.coefficient": 0.07}),
        ({"friction_coefficient": 0.07}, SMOOTH_MIXED | {"friction.coefficient": 0.07}),
        ({"surface": None, "friction_coefficient": 0.0}, SMOOTH_MIXED),
        ({"surface": None}, SMOOTH_MIXED | NO_LOSS),
        ({"surface": replace(FINISH, autocorrelation=None, rms_roughness=0.0)},
            none_of("surface", "autocorrelation.length", "rms_roughness")),
        ({"lubricant": GREASE}, STARVED),
        ({"lubricant": replace(GREASE, starvation_degree=3.0)}, OTHERWISE),
        ({"lubricant": GREASE, "effects": {"starvation": "off"}}, OTHERWISE),
        ({"effects": {"starvation": "off"}}, {"model.starvation": None}),
        ({"lubricant": GREASE, "surface": None, "friction_coefficient": 0.07},
            SMOOTH_MIXED | STARVED | {"friction.coefficient": 0.07}),
    ],
)  # fmt: skip
def test_what_the_torque_does_not_ask_for_is_not_varied(
    changed: dict[str, Any], expected: dict[str, float | None]
) -> None:
    """Beside these inputs all others stay as they are."""
    found, before = values_of(replace(WHOLE, **changed)), values_of(WHOLE)
    different = {key: found.get(key) for key in {*found, *before} if found.get(key) != before.get(key)}
    assert different == expected


def test_a_thrust_bearing_has_one_groove_and_no_angle_of_its_own() -> None:
    """Both washers are equal, and 90 degrees are its kind."""
    angle = ContactAngle(rule="given", value=np.pi / 2)
    keys = set(values_of(replace(WHOLE, bearing=THRUST_BEARING, contact_angle=angle)))
    assert "bearing.inner.conformity" in keys
    assert not keys & {"bearing.outer.conformity", "bearing.contact_angle.value", "bearing.clearance"}


@pytest.mark.parametrize(
    ("key", "value", "most"),
    [
        ("bearing.ball_diameter", 7.94e-3, 3 * 7.94e-3),
        ("bearing.inner.conformity", 0.52, 3 * 0.02),  # of what exceeds a groove that fits the ball
        ("lubricant.temperature", 313.0, 1e9),  # a normal distribution has no end
    ],
)
def test_a_deviation_is_at_least_0_and_at_most_three_times_the_value(key: str, value: float, most: float) -> None:
    for deviation in (0.0, 0.99 * most):
        assert checked_deviation(key, value, deviation) == deviation
    for deviation in (-0.01, np.inf, np.nan):
        refused(lambda: checked_deviation(key, value, deviation), f"uncertainty.{key}", "at least 0")  # noqa: B023


def test_an_input_without_an_origin_is_given_by_the_scene() -> None:
    known = known_inputs(WHOLE)
    for key, value, unit in (
        ("operation.axial_load", 470.0, "N"),
        ("cage.pocket_clearance", 0.2e-3, "m"),
        ("cage.wall_thickness", 0.9e-3, "m"),
        ("cage.material", STAMPED_CAGE.material.name, ""),
        ("cage.start", "whirl", ""),
        ("friction.hysteresis_loss", 0.0085, "1"),
    ):
        stated = known[key]
        assert stated.value == (pytest.approx(value, rel=1e-12) if isinstance(value, float) else value)  # round-off
        assert (stated.unit, stated.status, stated.uncertainty) == (unit, "given", None)
    assert "operation.moment" not in known
    assert not any(key.startswith("model.") for key in known)
    assert not any(key.startswith("cage.") for key in known_inputs(replace(WHOLE, cage=None)))


def test_the_usual_loss_factor_is_an_assumption_of_half_its_value() -> None:
    """It is stated where the torque asks for it and the scene does not give it."""
    usual = {each.key: each for each in stated_inputs(replace(WHOLE, hysteresis_loss=None))}
    loss = usual["friction.hysteresis_loss"]
    assert (loss.status, loss.value, loss.unit) == ("assumed", 0.007, "1")
    assert present(loss.uncertainty) == pytest.approx(0.0035, rel=1e-12)
    for scene in (WHOLE, replace(WHOLE, hysteresis_loss=None, effects={"hysteresis": "off"})):
        assert "friction.hysteresis_loss" not in {each.key for each in stated_inputs(scene)}


def test_what_is_stated_has_value_unit_and_origin() -> None:
    """The clearance is that before mounting, a material its name; what the scene assumes has its own source."""
    derived = Origin(status="derived", uncertainty=3e-6, source="a catalogue")
    bearing = replace(WHOLE.bearing, origins={"clearance": derived, "ball_material": derived, "ball_count": derived})
    oil = replace(OIL, origins={"viscosity": replace(derived, status="printed", uncertainty=None)})
    clearances = Clearances(
        unmounted=17e-6, mounted=11e-6, operating=9e-6, shaft_interference=3e-6, housing_interference=-2e-6,
        shaft_pressure=4e6, housing_pressure=0.0, ball_load=0.0,
    )  # fmt: skip
    scene = replace(
        WHOLE,
        bearing=bearing,
        lubricant=oil,
        assumed={"operation.axial_load": "a guess", "bearing.clearance": "another"},
    )
    found = {each.key: each for each in stated_inputs(scene)}
    assert found["bearing.clearance"].value == pytest.approx(20e-6, rel=1e-11)  # round-off of the clearance
    assert (found["bearing.clearance"].status, found["bearing.clearance"].source) == ("assumed", "another")
    assert found["bearing.ball_material"].value == bearing.ball_material.name
    assert found["bearing.ball_count"].value == 9
    assert (found["bearing.ball_count"].source, found["bearing.ball_count"].unit) == ("a catalogue", "1")
    assert (found["lubricant.viscosity"].status, found["lubricant.viscosity"].unit) == ("printed", "Pa s")
    assert (found["operation.axial_load"].value, found["operation.axial_load"].source) == (470.0, "a guess")
    mounted = {each.key: each for each in stated_inputs(replace(scene, clearances=clearances))}
    assert mounted["bearing.clearance"].value == 17e-6
