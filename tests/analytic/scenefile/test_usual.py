"""The oil that is assumed for a bearing of the catalogue: kappa = 2 by the reference viscosity of ISO 281."""

import math
from typing import Any

import pytest

from analytic.catalog.bearing_rows import find_bearing
from analytic.scene import Lubricant
from analytic.scenefile.read import load_scene
from analytic.scenefile.usual import CLASSES, RATIO, reference_viscosity


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
    def name_at(speed: object) -> str:
        oil = load_scene("6206", radial_load="700 N", speed=speed).lubricant
        assert oil is not None
        return oil.name

    assert name_at(["200 rpm", "-7000 rpm", "3000 rpm"]) == name_at("7000 rpm") != name_at("200 rpm")
    assert name_at("0 rpm") == name_at("3 rpm") == "ISO VG 460 mineral"
    assert name_at("300000 rpm") == "ISO VG 10 mineral"
