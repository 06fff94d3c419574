"""What is assumed for a bearing of the catalogue: its oil, kappa = 2 by ISO 281, and its cage."""

import math
from typing import Any

import numpy as np
import pytest

from analytic import catalog, friction_torque
from analytic.catalog.bearing_rows import find_bearing
from analytic.errors import InputError
from analytic.prediction.spreads import uncertain_inputs
from analytic.scene import Lubricant
from analytic.scenefile.inputs import stated_inputs
from analytic.scenefile.read import load_scene
from analytic.scenefile.usual import CLASSES, RATIO, cage_sizes, reference_viscosity
from tests.analytic.specimens import BEARING_6205, effect_of, present


def oil_of(name: str, **given: Any) -> Lubricant:
    oil = load_scene(name, **given).lubricant
    assert oil is not None
    return oil


@pytest.mark.parametrize(
    ("rpm", "mean", "printed"),
    [(100.0, 50.0, 139.0), (500.0, 100.0, 25.9), (1500.0, 65.0, 14.4), (12000.0, 90.0, 4.33)],
)
def test_the_reference_viscosity_by_hand(rpm: float, mean: float, printed: float) -> None:
    """mm^2/s, by a pocket calculator."""
    found = reference_viscosity(ring_speed=-rpm * math.pi / 30, mean_diameter=1e-3 * mean)
    assert 1e6 * found == pytest.approx(printed, rel=3e-3)  # three digits


@pytest.mark.parametrize(
    ("name", "speed", "temperature"),
    [("6308", "1000 rpm", "60 degC"), ("7014C", "12000 rpm", "60 degC"), ("6206", "3000 rpm", "85 degC")],
)
def test_no_other_class_is_nearer(name: str, speed: str, temperature: str) -> None:
    given = {"speed": speed, "temperature": temperature, "axial_load": "700 N"}
    wanted = RATIO * reference_viscosity(
        ring_speed=float(speed.split()[0]) * math.pi / 30, mean_diameter=find_bearing(name).pitch_diameter
    )
    chosen = oil_of(name, **given)

    def distance(oil: Lubricant) -> float:
        return abs(math.log(oil.viscosity / oil.density / wanted))

    others = [oil_of(name, oil=f"ISO VG {grade}", **given) for grade in CLASSES]
    assert distance(chosen) == min(map(distance, others))
    assert distance(chosen) < 0.5 * math.log(1.6)  # neighbours of ISO 3448 are 1.4 to 1.5 apart at 40 degC


def test_the_highest_speed_of_a_series_counts_and_the_classes_end() -> None:
    def name_at(speed: str | list[str]) -> str:
        oil = load_scene("6206", radial_load="700 N", speed=speed).lubricant
        assert oil is not None
        return oil.name

    assert name_at(["200 rpm", "-7000 rpm", "3000 rpm"]) == name_at("7000 rpm") != name_at("200 rpm")
    assert name_at("0 rpm") == name_at("3 rpm") == "ISO VG 460 mineral"
    assert name_at("300000 rpm") == "ISO VG 10 mineral"


LOADED: dict[str, Any] = {"radial_load": "2.3 kN", "speed": "1700 rpm"}


def test_of_the_bearing_of_the_paper_it_is_the_cage_of_the_paper() -> None:
    """Clearance 0.2 mm, sheet 0.9 mm and 6.58 g; moulded 1.5 mm and 1.8 g."""
    paper = catalog.entry("bearings", "paper_6205")["cage"]
    assert (paper["pocket_clearance"], paper["wall_thickness"], paper["mass"]) == ("0.2 mm", "0.9 mm", "6.58 g")
    pressed, moulded = (cage_sizes(BEARING_6205, material=name) for name in ("steel", "peek"))
    # the factors have two or three digits, and so has the mass of the moulded one
    assert [*pressed.values()] == pytest.approx([0.2e-3, 0.9e-3, 6.58e-3], rel=0.02)
    assert [*moulded.values()] == pytest.approx([0.2e-3, 1.5e-3, 1.8e-3], rel=0.02)


def test_balls_without_a_web_between_them_have_none() -> None:
    full = load_scene("6206", settings={"bearing.ball_count": 15})
    assert full.cage is None
    assert not any("cage" in words for words in friction_torque(full).warnings)


def test_it_rests_in_the_total_without_a_word() -> None:
    """T = mu m g r (w_b/w)/sqrt(1 + mu^2) at a contact angle of 0, where w_b/w = R_i R_o/(d_m r) [Harris2007]."""
    scene = load_scene("6206", **LOADED)
    found, bare = friction_torque(scene), friction_torque(load_scene("6206", settings={"cage": "none"}, **LOADED))
    bearing, cage = scene.bearing, present(scene.cage)
    reach = bearing.ball_radius, bearing.pitch_diameter
    rate = (reach[1] / 2 - reach[0]) * (reach[1] / 2 + reach[0]) / (reach[1] * reach[0])
    torque = 0.1 * cage.mass * 9.80665 * reach[0] * rate / np.sqrt(1.01)
    np.testing.assert_allclose(present(found.torque.cage), torque, rtol=2e-3)  # the orbit is by loaded, lagging balls
    np.testing.assert_allclose(
        found.torque.total, bare.torque.total + present(found.torque.cage), rtol=1e-9
    )  # same races
    assert found.warnings == bare.warnings
    assert 0 < present(effect_of(found, "cage").share) < 0.01
    assert effect_of(found, "cage_dynamics").share is effect_of(found, "ball_dynamics").share is None
    assert not any("cage" in words for words in bare.warnings)
    assert bare.cage is None


def test_its_keys_are_assumed_and_its_friction_is_uncertain() -> None:
    scene = load_scene("6206", **LOADED)
    stated = {each.key: each.status for each in stated_inputs(scene) if each.key.startswith("cage.")}
    keys = ("pocket_clearance", "wall_thickness", "mass", "material", "friction_coefficient")
    assert stated == dict.fromkeys([f"cage.{key}" for key in keys], "assumed")
    (friction,) = (each for each in uncertain_inputs(scene) if each.key == "cage.friction_coefficient")
    assert friction.deviation == pytest.approx(0.05, rel=1e-12)
    own = load_scene("6206", settings={"cage.mass": "9 g"}, **LOADED)
    assert present(own.cage).mass == pytest.approx(9e-3, rel=1e-12)
    assert {each.key for each in stated_inputs(own) if each.key.startswith("cage.")} == {
        f"cage.{key}" for key in keys if key not in ("mass", "friction_coefficient")
    }


def test_a_suffix_of_a_plastic_makes_it_moulded() -> None:
    for designation, material in (("6206", "steel"), ("6206 TN9", "peek"), ("6206 M", "steel"), ("7208 BEP", "peek")):
        assert present(load_scene(designation).cage).material.name == material


def test_balls_that_lead_farther_than_its_pockets_leave_it_at_rest() -> None:
    """Nobody knows its pockets, which a given cage with the same sizes holds the balls by."""
    loads: dict[str, Any] = {"axial_load": "1 kN", "radial_load": "0.9 kN"}
    free = {"operation.tilt": "free"}
    assumed = load_scene("6205", settings=free, **loads)
    given = load_scene("6205", settings=free | {"cage.pocket_clearance": "0.05 mm"}, **loads)
    assert present(friction_torque(given).cage).is_squeezed.all()
    found = friction_torque(assumed)
    assert not present(found.cage).is_squeezed.any()
    assert np.isfinite(found.numerical_uncertainty).all()


@pytest.mark.parametrize(
    "settings",
    [
        {"friction.coefficient": 0.0},
        {"effects.spin": "off", "effects.conformity": "off"},
        {"effects.centrifugal": "off"},
    ],
)
def test_it_refuses_and_doubts_nothing(settings: dict[str, Any]) -> None:
    """Races without friction, or a friction that is not known, and balls without load."""
    found = friction_torque(load_scene("6206", settings=settings, **LOADED))
    assert present(found.torque.cage)[0] > 0
    assert found.limits.cage_grip is None
    assert np.isfinite(found.numerical_uncertainty).all()


def test_another_word_than_none_is_refused() -> None:
    with pytest.raises(InputError, match=r"cage = 'off' is no cage; give a table \[cage\] .* or cage = \"none\""):
        load_scene("6206", settings={"cage": "off"})
    with pytest.raises(InputError, match=r"effects\.cage = 'on' needs a table"):
        load_scene("6206", settings={"cage": "none", "effects.cage": "on"})
