"""`fembearing compare`: measured torques of a file beside the computed ones."""

import csv
import json
from collections.abc import Callable
from pathlib import Path

import jsonschema
import numpy as np
import pytest

import analytic
from analytic.scenefile.read import load_scene
from analytic.writing import LISTING
from fembearing.plain_types import FORMAT
from fembearing.report.schema import schema_of
from tests.analytic.scenefile.scene_texts import MINE
from tests.conftest import Result

Run = Callable[..., Result]
ROOT = Path(__file__).resolve().parents[2]
QUICK = ("--samples", "64")  # no assertion depends on the accuracy of the interval
HEAD = "inner_speed [rpm],torque [N mm],uncertainty [%]\n"


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The working folder, with a scene and its measured torques, all inside."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "scene.toml").write_text(MINE + 'spin_rule = "balanced"\n[measured]\nfile = "data.csv"\n')
    scene = MINE + 'spin_rule = "balanced"\n'
    (tmp_path / "bare.toml").write_text(scene)
    torque = 1e3 * analytic.friction_torque(load_scene("bare.toml")).torque.total[0]
    (tmp_path / "data.csv").write_text(f"{HEAD}90,{0.96 * torque:.6g},2\n90,{1.03 * torque:.6g},2\n")
    (tmp_path / "far.csv").write_text(f"{HEAD}90,{0.96 * torque:.6g},2\n90,{9 * torque:.6g},2\n")
    return tmp_path


def test_a_scene_alone_names_its_data_and_passes(command: Run, place: Path) -> None:
    assert place.is_dir()
    own, given = command("compare", "scene.toml", *QUICK), command("compare", "bare.toml", "data.csv", *QUICK)
    assert (own.status, given.status) == (0, 0)
    assert own.out.splitlines()[:-1] == given.out.splitlines()[:-1]  # the last one has the seconds
    assert "All 2 measured torques are inside" in own.out
    assert command("compare", "scene.toml", "far.csv", *QUICK).status == 1  # in place of the scene's own


def test_a_bearing_has_the_loads_of_the_file_alone_and_tells_what_is_assumed(command: Run, place: Path) -> None:
    (place / "thrust.csv").write_text("axial_load [N],torque [N mm]\n300,14\n")
    ended = command("compare", "6206", "thrust.csv", *QUICK)
    (told,) = (line for line in ended.out.splitlines() if line.startswith("assumed: "))
    assert "operation.radial_load = 0 N, operation.inner_speed = 1000 rpm" in told
    assert "operation.axial_load" not in told
    assert told.endswith("; change with --set KEY=VALUE")
    assert not np.any(load_scene("6206", measured="thrust.csv").operation.radial_load)
    assert "assumed: " not in command("compare", "bare.toml", "data.csv", *QUICK).out


def test_columns_that_are_not_read_are_told_once(command: Run, place: Path) -> None:
    text = (place / "data.csv").read_text("utf-8").replace("\n", ",12.3.2024\n").replace("12.3.2024", "date", 1)
    (place / "dated.csv").write_text(text, "utf-8")
    ended = command("compare", "bare.toml", "dated.csv", "--quiet", *QUICK)
    assert ended.status == 0
    assert ended.err == "fembearing: warning: dated.csv: columns that are not read: date\n"


def test_json_fits_its_schema_and_is_alone_on_standard_output(command: Run, place: Path) -> None:
    assert place.is_dir()
    ended = command("compare", "scene.toml", "--json", "--seed", "5", *QUICK)
    found = json.loads(ended.out)
    jsonschema.validate(found, schema_of("compare"))
    assert json.loads(command("list", "--schema", "compare").out) == json.loads(json.dumps(schema_of("compare")))
    assert (found["kind"], found["format"]) == ("fembearing compare", FORMAT)
    assert (found["seed"], found["samples"], found["inside"]) == (5, 64, 2)
    assert found["rows"][0]["error"] == pytest.approx(found["rows"][0]["computed"] - found["rows"][0]["measured"])
    again = json.loads(command("compare", "scene.toml", "--json", "--seed", "5", *QUICK).out)
    assert found.pop("seconds") > 0
    assert again.pop("seconds") > 0
    assert found == again


def test_a_folder_has_page_numbers_table_and_figure(command: Run, place: Path) -> None:
    ended = command("compare", "bare.toml", "far.csv", "--out", "found", *QUICK)
    assert "report: found" in ended.out
    folder = place / "found"
    names = {"compare.html", "compare.json", "compare.csv", "compare.png", "compare.svg", LISTING}
    assert {file.name for file in folder.iterdir()} == names
    numbers = json.loads((folder / "compare.json").read_text("utf-8"))
    assert numbers["run"]["seeds"] == {"samples beside the measured torques": [1]}
    with (folder / "compare.csv").open(encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert [row["verdict"] for row in rows] == ["inside", "model too low"]
    for row, same in zip(rows, numbers["rows"], strict=True):
        assert float(row["error [N mm]"]) == pytest.approx(1e3 * same["error"], rel=1e-12)  # 15 digits are written
        assert float(row["inner_speed [rpm]"]) == pytest.approx(90)
        assert row["temperature [degC]"] == ""  # the scene has no oil
    assert (folder / "compare.png").read_bytes().startswith(b"\x89PNG")
    assert b"<svg" in (folder / "compare.svg").read_bytes()
    page = (folder / "compare.html").read_text("utf-8")
    assert "Missed: 1 of 2 measured torques is outside its 95 % interval." in page
    assert 'class="too">too low' in page
    assert "data:image/svg+xml;base64," in page
