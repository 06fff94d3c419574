"""The paper's numbers beside a scene's, and what is not set beside them."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from analytic import catalog
from analytic.scene import Operation, Scene
from analytic.scenefile.read import load_scene
from analytic.torque import friction_torque
from fembearing.compare.torque.published import BesidePaper, Chosen, beside_paper, is_papers_case, printed_numbers
from fembearing.plain_types import plain
from tests.analytic.specimens import present

SCENES = Path(__file__).parents[3] / "validation" / "scenes"
RPM = np.pi / 30


@pytest.fixture(scope="module")
def calibrated() -> Scene:
    return load_scene(SCENES / "6205_paper_calibrated.toml")


@pytest.fixture(scope="module")
def beside(calibrated: Scene) -> BesidePaper:
    return beside_paper(calibrated, friction_torque(calibrated))


def test_the_numbers_are_those_that_the_paper_prints() -> None:
    """A few of them, typed from the text once more."""
    found = {
        (one.quantity, round(one.rms_roughness * 1e7), round(one.inner_speed / RPM)): one for one in printed_numbers()
    }
    assert len(found) == 16
    assert found["total_torque", 10, 500].value == pytest.approx(25.09e-3, rel=1e-12)  # round-off
    assert found["cage_max_force", 10, 500].value == 27.95
    assert (found["race_torque", 1, 500].value, found["race_torque", 1, 500].note) == (pytest.approx(7e-3), "about")


def test_a_scene_stands_beside_the_numbers_of_its_own_speed_and_roughness(
    calibrated: Scene, beside: BesidePaper
) -> None:
    race = friction_torque(calibrated).torque.race
    assert beside.absent is None
    # Without a cage the scene has neither its torque nor its force, and no such total.
    assert [(row.quantity, row.rms_roughness) for row in beside.rows] == [("race_torque", 1e-6)] * 2
    assert [row.ours for row in beside.rows] == [race[0], race[4]]  # 100 and 500 rpm of five speeds
    row = plain(beside)["rows"][1]
    assert row["deviation"] == pytest.approx((row["ours"] - row["value"]) / row["value"], abs=1e-12)  # round-off


def test_what_was_fitted_is_named_and_what_was_chosen_too(calibrated: Scene, beside: BesidePaper) -> None:
    assert beside.calibration == calibrated.calibration is not None
    assert beside.chosen["surface hardness"] == Chosen(value=7.8e9, unit="Pa")
    assert beside.chosen["autocorrelation length"].value == pytest.approx(150e-6, rel=1e-12)  # read from um
    assert {load_scene(name).calibration for name in catalog.names("scenes")} == {None}


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"friction_coefficient": 0.07}, "mixed lubrication"),
        ({"surface": None}, "mixed lubrication"),
        (
            {"operation": Operation(axial_load=np.array([990.0]), inner_speed=np.array([50.0]))},
            "1000 N of thrust alone",
        ),
        (
            {"operation": Operation(axial_load=np.array([1e3]), inner_speed=np.array([50.0]), radial_load=30.0)},
            "1000 N of thrust alone",
        ),
        ("balls", "another bearing"),
    ],
)
def test_another_case_stands_beside_nothing(calibrated: Scene, change: dict | str, words: str) -> None:
    if isinstance(change, str):
        scene = replace(calibrated, bearing=replace(calibrated.bearing, ball_count=8))
    else:
        scene = replace(calibrated, **change)
    assert is_papers_case(calibrated)
    assert not is_papers_case(scene)
    found = beside_paper(scene, friction_torque(calibrated))
    assert words in (found.absent or "")
    assert (found.rows, found.chosen) == ((), {})


def test_another_roughness_stands_beside_nothing(calibrated: Scene) -> None:
    scene = replace(calibrated, surface=replace(present(calibrated.surface), rms_roughness=0.7e-6))
    found = beside_paper(scene, friction_torque(calibrated))
    assert "Sq 0.1 and 1 um" in (found.absent or "")
    assert found.rows == ()
