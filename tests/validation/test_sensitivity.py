"""The sensitivity study: changes with a second calculation, ranges that follow from the paper, and its files."""

import csv
from collections.abc import Callable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.oil.rolling import HYSTERESIS_LOSS
from analytic.scene import Scene
from analytic.torque import friction_torque


@pytest.fixture(scope="module")
def study(script: Callable[[str], ModuleType]) -> ModuleType:
    return script("sensitivity")


@pytest.fixture(scope="module")
def scene(study: ModuleType) -> Scene:
    return study.slowest_and_fastest(study.load_scene(study.SCENE))


@pytest.fixture(scope="module")
def swings(study: ModuleType, scene: Scene) -> dict[str, Any]:
    return {swing.variation.name: swing for swing in study.swings(scene)}


def test_the_slowest_and_the_fastest_point_are_studied(scene: Scene) -> None:
    np.testing.assert_allclose(scene.operation.inner_speed * 30 / np.pi, [100, 500])
    assert friction_torque(scene).torque.total.shape == (2,)


def test_the_hysteresis_part_is_proportional_to_its_loss(scene: Scene, swings: dict[str, Any]) -> None:
    torque = friction_torque(scene).torque
    assert torque.hysteresis is not None
    for change, loss in zip(swings["hysteresis loss"].changes, HYSTERESIS_LOSS, strict=True):
        np.testing.assert_allclose(
            change, torque.hysteresis / torque.total * (loss / 0.007 - 1), rtol=1e-9
        )  # round-off


def test_the_boundary_part_is_what_asperities_carry(swings: dict[str, Any]) -> None:
    """Torque by slip is a straight line over the coefficient of boundary friction, so both ends lie on it."""
    low, high = swings["boundary friction"].changes
    # The share of spin changes slightly with the coefficients: 5 % is far above that, and far below any other law.
    np.testing.assert_allclose(low / (0.08 - 0.12), high / (0.15 - 0.12), rtol=0.05)
    assert np.all(low < 0)


def test_one_input_moves_at_a_time(study: ModuleType, scene: Scene) -> None:
    """A changed scene differs from the original in one noun only, the one that holds the input."""
    nouns = {"Young's modulus": "bearing", "Poisson's ratio": "bearing", "viscosity": "lubricant",
             "pressure-viscosity": "lubricant", "Eyring stress": "lubricant", "limiting shear": "lubricant",
             "shear of the oil": "lubricant", "hysteresis loss": "hysteresis_loss", "spin rule": "spin_rule",
             "contact angle": "contact_angle", "clearance": "contact_angle", "film formula": None}  # fmt: skip
    for variation in study.variations(scene):
        expected = nouns.get(variation.name, "surface")
        for end in variation.ends:
            moved = {name for name, value in vars(scene).items() if getattr(end.scene, name) != value}
            assert moved - {"operation"} == ({expected} if expected else set()), variation.name
            assert (end.film_factor != 1) == (variation.name == "film formula")
            assert end.scene.operation is scene.operation


def test_the_largest_swing_comes_first(swings: dict[str, Any]) -> None:
    largest = [swing.largest for swing in swings.values()]
    assert all(first >= second for first, second in pairwise(largest))
    assert len(largest) == 18
    np.testing.assert_allclose(largest[0], max(np.abs(c).max() for s in swings.values() for c in s.changes))


def test_the_free_angle_within_the_rounding(study: ModuleType, scene: Scene) -> None:
    """An independent calculation of the angles within 10 um of rounding: 5 to 17 degrees, rounded; at most 20.5."""
    low, high = np.degrees(study.free_angles_within_rounding(scene))
    np.testing.assert_allclose([low, high], [5, 17], atol=0.5)
    # The worst case has all dimensions at one end; by hand: arccos(1 - 0.050/(2 x 0.395)), mm.
    bearing = scene.bearing
    outer, inner = bearing.outer, bearing.inner
    wide = replace(
        bearing,
        outer=replace(outer, bottom_radius=outer.bottom_radius + 5e-6, groove_radius=outer.groove_radius - 5e-6),
        inner=replace(inner, bottom_radius=inner.bottom_radius - 5e-6, groove_radius=inner.groove_radius - 5e-6),
        ball_diameter=bearing.ball_diameter - 5e-6,
    )
    worst = np.degrees(np.arccos(1 - wide.diametral_clearance / (2 * wide.groove_centre_distance)))
    np.testing.assert_allclose(worst, 20.5, atol=0.05)
    assert high < worst


@pytest.mark.slow
def test_the_script_prints_writes_and_draws(run_script, tmp_path: Path) -> None:
    assert "without a cage" in " ".join(run_script("sensitivity.py", "--out", tmp_path).split())
    with (tmp_path / "sensitivity.csv").open(encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len({row["input"] for row in rows}) == 18
    assert all(row["source"] for row in rows)
    assert (tmp_path / "sensitivity.png").stat().st_size > 0
