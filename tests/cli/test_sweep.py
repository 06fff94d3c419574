"""fembearing sweep as a person calls it, and its maps."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray
from matplotlib.colors import LogNorm

from fembearing import cli
from fembearing.report.figures.sweep_maps import map_figure
from fembearing.sweep.run import run_sweep

Write = Callable[..., Path]
AXES = (
    'operation.axial_load = { from = "100 N", to = "900 N", count = 4, spacing = "log" }\n'
    'operation.inner_speed = ["90 rpm", "400 rpm", "720 rpm"]\n'
)


@pytest.fixture
def command(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, in_process: list[Any]
) -> Callable[..., tuple[int, str, str]]:
    """Runs a sweep into `out`: status, standard output and standard error."""

    def run(grid: Path, *options: str) -> tuple[int, str, str]:
        monkeypatch.setattr("sys.argv", ["fembearing", "sweep", str(grid), "--out", str(tmp_path / "out"), *options])
        with pytest.raises(SystemExit) as stop:
            cli.main()
        captured = capsys.readouterr()
        return int(stop.value.code or 0), captured.out, captured.err

    assert in_process == []
    return run


def test_a_sweep_ends_with_its_files_and_is_found_again(
    command: Callable[..., Any], grid_file: Write, tmp_path: Path
) -> None:
    status, told, complaint = command(grid_file(AXES), "--json")
    assert (status, complaint) == (0, "")
    result = json.loads(told)
    assert (result["points"], result["computed"], result["kept"], result["failed"]) == (12, 12, 0, 0)
    assert {Path(file).name for file in result["maps"]} == {"torque_total.png", "peak_pressure_inner.png"}
    for file in (result["file"], *result["maps"]):
        assert Path(file).stat().st_size > 5000, file
    written = {file: file.stat().st_mtime_ns for file in (tmp_path / "out").rglob("*")}
    status, told, complaint = command(grid_file(AXES))
    assert (status, complaint) == (0, "")
    assert told.startswith("12 points: 0 computed, 12 from before, 0 failed")
    assert {file: file.stat().st_mtime_ns for file in (tmp_path / "out").rglob("*")} == written | {
        tmp_path / "out" / ".lock": (tmp_path / "out" / ".lock").stat().st_mtime_ns
    }


def test_maps_are_all_there_or_drawn_again(
    command: Callable[..., Any], grid_file: Write, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out, drawn = tmp_path / "out", []

    def draw(_dataset: Any, folder: Path) -> None:
        drawn.append(folder)
        (folder / "first.png").write_bytes(b"first")
        if len(drawn) == 1:
            raise KeyboardInterrupt
        (folder / "second.png").write_bytes(b"second")

    monkeypatch.setattr("fembearing.report.figures.sweep_maps.write_maps", draw)
    assert command(grid_file(AXES), "--json")[0] == 130
    assert not (out / "maps").exists()
    for expected in (2, 2):  # the second time they are there
        status, told, _ = command(grid_file(AXES), "--json")
        assert (status, len(json.loads(told)["maps"]), len(drawn)) == (0, 2, expected)
    (out / "sweep.nc").unlink()  # gathered again, as when points that were lost are there at last
    assert command(grid_file(AXES), "--json")[0] == 0
    assert len(drawn) == 3


def test_failed_points_end_with_status_3_and_their_reasons(
    command: Callable[..., Any], grid_file: Write, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("fembearing.report.figures.sweep_maps.write_maps", lambda *_: None)  # of which others tell
    status, told, complaint = command(grid_file("conformity = [0.52, 0.5]\n" + AXES))
    assert (status, complaint) == (3, "")
    assert "24 points: 24 computed, 0 from before, 12 failed" in told
    assert told.count("failed: ") == 1


def test_a_mistake_ends_with_status_2_and_one_line(command: Callable[..., Any], grid_file: Write) -> None:
    for axes in ("operation.axial_load = []", "lode = [3]", 'operation.axial_load = ["3 mm"]'):
        status, told, complaint = command(grid_file(axes))
        assert (status, told, complaint.count("\n")) == (2, "", 1)
    assert command(grid_file(AXES), "--workers", "0")[0] == 2
    assert command(Path("nowhere.toml"))[2].startswith("fembearing: nowhere.toml: No such file or directory; give")


@pytest.mark.usefixtures("in_process")
def test_a_map_shows_what_the_dataset_holds_in_units_of_people(grid_file: Write, tmp_path: Path) -> None:
    dataset = run_sweep(grid_file(AXES.replace("100 N", "20 N")), out=tmp_path / "out").dataset()
    figure = map_figure(dataset, "torque_total")
    panel, bar = figure.axes
    (mesh,) = (part for part in panel.collections if type(part).__name__ == "QuadMesh")
    shown, held = np.asarray(mesh.get_array()), 1e3 * dataset["torque_total"].values
    np.testing.assert_allclose(shown.reshape(held.shape), held, rtol=1e-12)  # round-off
    assert (panel.get_ylabel(), panel.get_xlabel()) == ("axial load, N", "speed of the inner ring, rpm")
    assert bar.get_ylabel() == "friction torque, N mm"
    assert panel.get_yscale() == "log"
    assert isinstance(mesh.norm, LogNorm)  # torques from 0.3 to 20 N mm
    low, high = panel.get_xlim()
    np.testing.assert_allclose((low, high), (90 - 310 / 2, 720 + 320 / 2))  # whole cells, to half way and as far again
    np.testing.assert_allclose(panel.get_ylim(), (20 / 45 ** (1 / 6), 900 * 45 ** (1 / 6)))  # three steps make 45 times


def made(**axes: Any) -> xarray.Dataset:
    """Torques that grow along each axis by a step of its own."""
    shape = tuple(len(values) for values in axes.values())
    values = 0.01 + sum(10.0**-place * np.indices(shape)[place - 3] for place in range(3, 3 + len(shape)))
    notes = {"units": "N m", "long_name": "friction torque"}
    return xarray.Dataset({"torque_total": (tuple(axes), values, notes)}, coords=axes)


def test_one_axis_gives_lines_and_words_their_names() -> None:
    dataset = made(bearing=["6205", "6206"], load=[1.0, 2.0, 3.0])
    (panel,) = map_figure(dataset, "torque_total").axes
    assert [line.get_label() for line in panel.lines] == ["bearing 6205", "bearing 6206"]
    for line, row in zip(panel.lines, dataset["torque_total"].values, strict=True):
        np.testing.assert_allclose(np.asarray(line.get_ydata()), 1e3 * row)
    (panel,) = map_figure(made(pair=["inner", "outer"]), "torque_total").axes
    assert [text.get_text() for text in panel.get_xticklabels()] == ["inner", "outer"]


def test_values_out_of_order_make_the_same_map() -> None:
    mixed = made(load=[300.0, 100.0, 900.0, 500.0], speed=[90.0, 50.0, 500.0])
    for dataset in (mixed, mixed.sortby(["load", "speed"])):
        panel = map_figure(dataset, "torque_total").axes[0]
        (mesh,) = (part for part in panel.collections if type(part).__name__ == "QuadMesh")
        shown = np.asarray(mesh.get_array()).reshape(4, 3)
        np.testing.assert_array_equal(shown, 1e3 * mixed["torque_total"].sortby(["load", "speed"]))
        assert panel.get_ylim() == (0.0, 1100.0)  # half a step beyond 100 and 900


def test_two_values_of_an_axis_are_two_lines() -> None:
    (panel,) = map_figure(made(roughness=[0.1, 0.3], load=[1.0, 2.0, 3.0]), "torque_total").axes
    assert [line.get_label() for line in panel.lines] == ["roughness 0.1", "roughness 0.3"]


def test_further_axes_stand_side_by_side_and_failures_are_named() -> None:
    dataset = made(load=np.arange(1.0, 6.0), speed=np.arange(2.0, 6.0), viscosity=[0.1, 0.2, 0.3])
    dataset["torque_total"][0, 0, 0] = np.nan
    figure = map_figure(dataset, "torque_total")
    assert [panel.get_title() for panel in figure.axes[:3]] == ["viscosity 0.1", "viscosity 0.2", "viscosity 0.3"]
    assert figure.get_suptitle() == "friction torque (grey: failed)"
    assert len(map_figure(made(a=np.arange(9.0), b=np.arange(8.0), c=np.arange(7.0)), "torque_total").axes) == 7
