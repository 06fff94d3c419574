"""`fembearing sweep` as a user calls it, and its maps."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from matplotlib.colors import LogNorm

from fembearing.report.figures.sweep_maps import map_figure
from fembearing.sweep.run import run_sweep

Write = Callable[..., Path]
AXES = (
    'operation.axial_load = { from = "100 N", to = "900 N", count = 4, spacing = "log" }\n'
    'operation.inner_speed = ["90 rpm", "400 rpm", "720 rpm"]\n'
)


@pytest.fixture
def sweep(command: Callable[..., Any], tmp_path: Path, in_process: list[Any]) -> Callable[..., tuple[int, str, str]]:
    """Runs a sweep into `out`: status, standard output and standard error."""
    assert in_process == []
    return lambda grid, *options: command("sweep", str(grid), "--out", str(tmp_path / "out"), *options)


def test_a_sweep_writes_its_files_and_a_second_run_keeps_them(
    sweep: Callable[..., Any], grid_file: Write, tmp_path: Path
) -> None:
    status, told, complaint = sweep(grid_file(AXES), "--json")
    assert (status, complaint) == (0, "")
    result = json.loads(told)
    assert (result["points"], result["computed"], result["kept"], result["failed"]) == (12, 12, 0, 0)
    assert {Path(file).name for file in result["maps"]} == {"torque_total.png", "peak_pressure_inner.png"}
    for file in (result["file"], *result["maps"]):
        assert Path(file).stat().st_size > 5000, file
    written = {file: file.stat().st_mtime_ns for file in (tmp_path / "out" / "parts").iterdir()}
    status, told, complaint = sweep(grid_file(AXES))
    assert (status, complaint) == (0, "")
    assert told.startswith("12 points: 0 computed, 12 from before, 0 failed")
    assert {file: file.stat().st_mtime_ns for file in (tmp_path / "out" / "parts").iterdir()} == written
    # A link to a folder that would be replaced if it were followed
    (tmp_path / "out" / "maps").rename(tmp_path / "mine")
    (tmp_path / "out" / "maps").symlink_to(tmp_path / "mine")
    (tmp_path / "mine" / "torque_total.png").write_text("precious", "utf-8")
    assert sweep(grid_file(AXES))[0] == 0
    assert (tmp_path / "mine" / "torque_total.png").read_text("utf-8") == "precious"


def test_failed_points_end_with_status_3_and_their_reasons(
    sweep: Callable[..., Any], grid_file: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fembearing.report.figures.sweep_maps.write_maps", lambda *_: None)  # which other tests check
    status, told, complaint = sweep(grid_file("bearing.conformity = [0.52, 0.5]\n" + AXES))
    assert (status, complaint) == (3, "")
    assert "24 points: 24 computed, 0 from before, 12 failed" in told
    assert told.count("failed: ") == 1


@pytest.mark.usefixtures("in_process")
def test_a_map_shows_the_dataset_in_common_units(grid_file: Write, tmp_path: Path) -> None:
    dataset = run_sweep(grid_file(AXES.replace("100 N", "20 N")), out=tmp_path / "out").to_dataset()
    figure = map_figure(dataset, "torque_total")
    panel, bar = figure.axes
    (mesh,) = (part for part in panel.collections if type(part).__name__ == "QuadMesh")
    shown, held = np.asarray(mesh.get_array()), 1e3 * dataset["torque_total"].values
    np.testing.assert_allclose(shown.reshape(held.shape), held, rtol=1e-12)  # round-off
    assert (panel.get_ylabel(), panel.get_xlabel()) == ("axial load, N", "speed of the inner ring, rpm")
    assert bar.get_ylabel() == "friction torque, N mm"
    assert panel.get_yscale() == "log"
    assert isinstance(mesh.norm, LogNorm)  # torques from 0.3 to 20 N mm
    np.testing.assert_allclose(panel.get_xlim(), (90, 720))  # colours between computed points end at the outer ones
    np.testing.assert_allclose(panel.get_ylim(), (20, 900))
