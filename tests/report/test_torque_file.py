"""One file of a torque: the numbers of the table are those of the JSON, every ending gives its kind, whole or not."""

import csv
import json
import re
from io import StringIO
from pathlib import Path

import numpy as np
import pytest

from analytic.columns import COLUMNS
from analytic.errors import InputError
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import parse_scene
from fembearing import cli
from fembearing.plain_types import plain
from fembearing.report import torque_folder
from fembearing.report.sections.torque import ball_table
from fembearing.report.torque import content_of
from fembearing.report.torque_file import CONTENTS, torque_content
from fembearing.report.torque_folder import torque_with_files
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed
from tests.analytic.specimens import present

SERIES = changed('"700 N"', '["900 N", "400 N", "650 N"]', changed(SPEEDS, '["500 rpm", "2000 rpm", "900 rpm"]', OILED))
DRY = SERIES.partition("[lubricant]")[0] + "[friction]\ncoefficient = 0.1\n"
# What one of each unit is in SI, by definition.
SI = {
    "rpm": 2 * np.pi / 60,
    "N": 1.0,
    "N mm": 1e-3,
    "%": 1e-2,
    "deg": np.pi / 180,
    "um": 1e-6,
    "mm": 1e-3,
    "GPa": 1e9,
    "1": 1.0,
}
DIGITS = 1e-12  # relative: 15 digits are printed, and a unit costs one or two of the 17 that a number has


@pytest.fixture(scope="module", params=[SERIES + '[losses]\nseals = "5 N mm"\n', DRY], ids=["oiled", "dry"])
def result(request: pytest.FixtureRequest) -> SceneTorque:
    return torque_of_scene(parse_scene(request.param, origin="here"))


def test_the_table_has_every_number_of_the_json_in_the_unit_of_its_head(result: SceneTorque) -> None:
    points = content_of(result).points
    (count, *heads, last), *rows = csv.reader(StringIO(torque_content(result, ending=".csv").decode()))
    assert (count, last) == ("point", "bearing")
    assert {row[-1] for row in rows} == {result.scene.bearing.name}
    assert [row[0] for row in rows] == ["1", "2", "3"]
    names = []
    for column, head in enumerate(heads, start=1):
        name, unit = present(re.fullmatch(r"(\w+) \[(.+)\]", head)).groups()
        names.append(name)
        for point, row in enumerate(rows):
            expected = points[point][name]
            found = float(row[column]) * SI[unit] if row[column] else None
            assert found == (None if expected is None else pytest.approx(expected, rel=DIGITS, abs=0)), head
    assert {*names} == {name for name, value in points[0].items() if value is not None}  # all that is known


def test_dataset_and_data_frame_hold_the_same_numbers(result: SceneTorque) -> None:
    dataset, frame, points = result.to_dataset(), result.to_dataframe(), content_of(result).points
    assert {*dataset.data_vars, *dataset.coords} == {*frame.columns}
    for name in frame.columns:
        np.testing.assert_array_equal(frame[name], dataset[name])
        assert dataset[name].attrs["units"] == frame.attrs["units"][name] == (COLUMNS)[name].unit
        told = [np.nan if point[name] is None else point[name] for point in points]
        np.testing.assert_array_equal(np.where(np.isfinite(frame[name]), frame[name], np.nan), told)


def test_every_ending_gives_its_kind_of_file(result: SceneTorque, tmp_path: Path) -> None:
    beginnings = {
        ".csv": b"point,",
        ".json": b"{",
        ".png": b"\x89PNG",
        ".svg": b"<?xml",
        ".pdf": b"%PDF-",
        ".html": b"<!DOCTYPE html>",
    }
    assert CONTENTS.keys() == beginnings.keys()
    for ending, content in CONTENTS.items():
        assert content(result).startswith(beginnings[ending])
    assert json.loads(CONTENTS[".json"](result))["points"] == plain(result.points)
    _, lacking = torque_with_files(result.scene, out=tmp_path / "mine.CSV")
    assert lacking is None
    assert [path.name for path in tmp_path.iterdir()] == ["mine.CSV"]
    assert (tmp_path / "mine.CSV").read_bytes() == CONTENTS[".csv"](result)


def test_the_page_needs_nothing_else_and_shows_markup_as_text() -> None:
    named = parse_scene(changed('name = "a series"', 'name = "<b>bold</b> & co"', SERIES), origin="here")
    page = CONTENTS[".html"](torque_of_scene(named)).decode()
    assert "&lt;b&gt;bold&lt;/b&gt; &amp; co" in page
    assert "<b>" not in page
    assert set(re.findall(r'(?:src|href)="(.{10})', page)) == {"data:image"}
    for total in torque_of_scene(named).friction.torque.total:
        assert f'<td class="number">{total * 1e3:#.4g}</td>' in page


@pytest.mark.parametrize(
    ("name", "said"),
    [
        (
            "my.docx",
            "ends with '.docx': give a file that ends with .csv, .json, .png, .svg, .pdf, .html, or a name without",
        ),
        ("there.csv", "there.csv' exists already: give a new name, remove it first, or give --force"),
        ("nowhere/my.csv", "cannot be made in"),
    ],
)
def test_a_name_that_cannot_be_written_is_refused_before_anything_is_computed(
    tmp_path: Path, name: str, said: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "there.csv").write_text("mine")
    monkeypatch.setattr(torque_folder, "torque_of_scene", None)  # would not be called
    monkeypatch.setattr("sys.argv", ["fembearing", "torque", "--out", str(tmp_path / name)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    assert stop.value.code == 2
    line = capsys.readouterr().err
    assert said in line
    assert line.count("\n") == 1
    assert {path.name for path in tmp_path.iterdir()} == {"there.csv"}
    assert (tmp_path / "there.csv").read_text() == "mine"


def test_nothing_is_left_of_a_file_that_fails_or_comes_too_late(
    result: SceneTorque, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    target = tmp_path / "my.csv"

    def stop(*_: object, **__: object) -> SceneTorque:
        raise KeyboardInterrupt

    def late(*_: object, **__: object) -> SceneTorque:
        target.write_text("somebody's")
        return result

    monkeypatch.setattr(torque_folder, "torque_of_scene", stop)
    with pytest.raises(KeyboardInterrupt):
        torque_with_files(result.scene, out=target)
    assert list(tmp_path.iterdir()) == []
    monkeypatch.setattr(torque_folder, "torque_of_scene", late)
    with pytest.raises(InputError, match="exists already"):
        torque_with_files(result.scene, out=target)
    assert [path.name for path in tmp_path.iterdir()] == ["my.csv"]
    assert target.read_text() == "somebody's"


def test_the_balls_of_a_series_have_the_range_of_their_angles() -> None:
    """More thrust raises the angle: the least belongs to the least load, wherever it stands in the series."""
    result = torque_of_scene(parse_scene(SERIES, origin="here"))
    angles = np.degrees(result.friction.contact_angle)
    note = ball_table(result, (0, 1, 2)).notes[0]
    told = [float(each) for each in re.findall(r"(\d+\.\d+) deg", note)]
    assert told == pytest.approx([angles.min(), angles.max()], abs=0.05)  # digits
    assert told[0] < told[1]
