"""A scene beside the measured torques of a file: the operating points, the samples, and what is the same either way."""

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Scene
from analytic.scenefile.read import load_scene, parse_scene
from analytic.torque import friction_torque
from fembearing import MeasuredComparison, compare_measured
from fembearing.check.measured.comparison import leading
from tests.analytic.scenefile.scene_texts import MINE
from tests.analytic.scenefile.test_columns import OILED
from tests.refusals import refused

DRY = MINE.replace("0.2 rad", "0.21 rad") + 'spin_rule = "balanced"\n'  # closed kinematics, which are quick
SAMPLES = 64  # enough for an interval of few inputs; no assertion depends on its accuracy


def compared(folder: Path, rows: Sequence[str], scene: Scene | None = None, seed: int = 3) -> MeasuredComparison:
    file = folder / "data.csv"
    file.write_text("\n".join(rows))
    return compare_measured(
        parse_scene(DRY, origin="dry") if scene is None else scene, file, samples=SAMPLES, seed=seed
    )


def test_units_order_and_lines_between_change_nothing(tmp_path: Path) -> None:
    first = compared(
        tmp_path,
        [
            "inner_speed [rpm],axial_load [N],torque [N mm],uncertainty [N mm]",
            "300,980.665,20,0.4",
            "450,490.3325,9,0.45",
        ],
    )
    other = compared(
        tmp_path,
        [
            "# the same",
            "uncertainty [%],torque [N m],axial_load [kgf],inner_speed [deg/s]",
            "",
            "5,0.009,50,2700",
            "2,0.020,100,1800",
        ],
    )
    for one, same in zip(first.rows, reversed(other.rows), strict=True):
        assert one.verdict == same.verdict
        for name, value in vars(one).items():
            if isinstance(value, float):  # rounding of the units, which samples and regression carry on
                assert getattr(same, name) == pytest.approx(value, rel=1e-9, abs=1e-15), name
    assert first.mean_error == pytest.approx(other.mean_error, rel=1e-9)


def test_a_row_has_the_torque_of_its_operating_point(tmp_path: Path) -> None:
    found = compared(tmp_path, ["axial_load [N],torque [N mm]", "300,5", "900,21", "500,8"])
    own = replace(parse_scene(DRY, origin="dry").operation, axial_load=np.array([300.0, 900.0, 500.0]))
    torque = friction_torque(replace(parse_scene(DRY, origin="dry"), operation=own)).torque.total
    np.testing.assert_allclose([row.computed for row in found.rows], torque, rtol=1e-13)  # rounding
    assert [row.inner_speed for row in found.rows] == pytest.approx([3 * np.pi] * 3)  # of the scene, 90 rpm
    assert any("inner speed" in note for note in found.notes)
    assert any("no column uncertainty" in note for note in found.notes)
    frame = found.to_dataframe()
    assert frame["computed"].tolist() == [row.computed for row in found.rows]
    assert frame["verdict"].tolist() == [row.verdict for row in found.rows]
    assert frame.attrs["units"]["error"] == "N m"
    relative = np.array([row.error / row.measured for row in found.rows])
    assert found.mean_error == pytest.approx(relative.mean())
    assert found.scatter == pytest.approx(relative.std(ddof=1))


def test_another_temperature_is_another_scene(tmp_path: Path) -> None:
    file = tmp_path / "data.csv"
    file.write_text("temperature [degC],inner_speed [rpm],torque [N mm]\n70,300,15\n55,300,15\n70,500,16\n")
    (tmp_path / "oiled.toml").write_text(OILED)
    (tmp_path / "warm.toml").write_text(
        OILED.replace("55 degC", "70 degC").replace('"900 rpm"', '["300 rpm", "500 rpm"]')
    )
    scene = load_scene(tmp_path / "oiled.toml", measured=file)
    found = compare_measured(scene, samples=SAMPLES)
    assert found.samples == SAMPLES
    warm = friction_torque(load_scene(tmp_path / "warm.toml")).torque.total
    np.testing.assert_allclose([found.rows[0].computed, found.rows[2].computed], warm, rtol=1e-13)  # rounding
    assert [row.temperature for row in found.rows] == [343.15, 328.15, 343.15]
    assert found.rows[1].computed > found.rows[0].computed  # thicker oil at 55 degC
    assert scene.lubricant is not None
    changed = replace(scene, lubricant=replace(scene.lubricant, viscosity=0.9 * scene.lubricant.viscosity))
    refused(lambda: compare_measured(changed), "oil of the scene was changed", "change the file")
    alone = load_scene(tmp_path / "oiled.toml")
    refused(lambda: compare_measured(alone, file), "data.csv", "70 degC", "its oil at 55 degC alone", "measured=data")
    refused(lambda: compare_measured(parse_scene(DRY, origin="dry"), file), "data.csv", "no oil")


def test_a_seed_fixes_every_number_and_another_one_moves_the_ends(tmp_path: Path) -> None:
    rows = ["inner_speed [rpm],torque [N mm],uncertainty [%]", "300,20,2", "450,9,3"]
    first, again, other = (compared(tmp_path, rows, seed=seed) for seed in (3, 3, 4))
    assert first.rows == again.rows
    assert first.rows != other.rows
    assert [row.computed for row in first.rows] == [row.computed for row in other.rows]
    refused(lambda: compared(tmp_path, rows, seed=-5), "seed = -5", "from 0")


def test_verdicts_follow_the_measured_torque(tmp_path: Path) -> None:
    head = "inner_speed [rpm],torque [N m],uncertainty [%]"
    near = compared(tmp_path, [head, "300,0.02,2"]).rows[0]
    middle, half = (near.computed_low + near.computed_high) / 2, (near.computed_high - near.computed_low) / 2
    moved = [middle, middle + 2 * half, middle - 0.8 * half, max(middle - 2 * half, 0.05 * middle)]
    found = compared(tmp_path, [head, *(f"300,{torque:.12g},0.1" for torque in moved)])
    assert [row.verdict for row in found.rows] == ["inside", "model too low", "inside", "model too high"]
    assert (found.inside, found.verdict) == (2, "fail")
    assert found.conclusions[0] == "Missed: 2 of 4 measured torques are outside their 95 % intervals."
    assert compared(tmp_path, [head, f"300,{middle:.12g},0.1"]).verdict == "pass"


SERIES = DRY.replace('"90 rpm"', '["90 rpm", "120 rpm"]')
MOMENTS = DRY.replace('"700 N"', '"700 N"\nmoment = ["0 N m", "0.3 N m"]').replace('"given", value', '"solved", free')


@pytest.mark.parametrize(
    ("text", "rows", "words"),
    [
        (SERIES, ["axial_load [N],torque [N mm]", "500,8"], ("no column inner_speed", "2 values", "add the column")),
        (MOMENTS, ["inner_speed [rpm],torque [N mm]", "300,8"], ("no column moment", "give one in operation.moment")),
        (DRY, ["axial_load [N],torque [N mm]", "500,8", "0,8"], ("data.csv: row 2 has no load",)),
    ],
)
def test_what_neither_row_nor_scene_says_is_refused(
    tmp_path: Path, text: str, rows: list[str], words: tuple[str, ...]
) -> None:
    refused(lambda: compared(tmp_path, rows, parse_scene(text, origin="scene")), *words)


def test_a_scene_without_measured_torques_says_where_they_go() -> None:
    refused(lambda: compare_measured(parse_scene(DRY, origin="dry")), "no table [measured]", "CSV file")


def test_the_inputs_that_are_named_matter_most_at_any_row() -> None:
    """Three of four, by their largest index at any point of any temperature."""

    def of(*indices: list[float]) -> Any:
        inputs = [SimpleNamespace(key=key) for key in ("a", "b", "c", "d")]
        return SimpleNamespace(inputs=inputs, indices=SimpleNamespace(total=np.array(indices)))

    first = of([0.1, 0.2], [0.5, 0.3], [0.05, 0.04], [0.3, 0.1])
    second = of([0.7, 0.0], [0.1, 0.1], [0.06, 0.01], [0.2, 0.4])
    for predictions in ([first, second], [second, first]):
        assert list(leading(predictions).items()) == [("a", 0.7), ("b", 0.5), ("d", 0.4)]
