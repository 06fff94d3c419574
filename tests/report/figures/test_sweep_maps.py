"""Maps of a sweep's dataset: lines for one axis, colours for two, panels for more."""

from pathlib import Path
from typing import Any

import numpy as np
import xarray
from matplotlib.colors import LogNorm

from fembearing.report.figures.sweep_maps import map_figure, write_maps


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


def test_an_axis_is_logarithmic_where_it_is_wide_and_its_steps_grow() -> None:
    for speeds, scale in (([1.0, 3.0, 10.0, 31.0], "log"), ([1.0, 1.1, 1.21, 1.33], "linear"), ([1, 11, 21], "linear")):
        (panel,) = map_figure(made(speed=speeds), "torque_total").axes
        assert panel.get_xscale() == scale


def test_a_map_with_failures_keeps_its_cells() -> None:
    dataset = made(load=[100.0, 300.0, 500.0, 900.0], speed=[50.0, 90.0, 500.0])
    dataset["torque_total"][1, 1] = np.nan
    assert map_figure(dataset, "torque_total").axes[0].get_ylim() == (0.0, 1100.0)  # half a step beyond 100 and 900


def test_further_axes_stand_side_by_side_and_failures_are_named() -> None:
    dataset = made(load=np.arange(1.0, 6.0), speed=np.arange(2.0, 6.0), viscosity=[0.1, 0.2, 0.3])
    dataset["torque_total"][0, 0, 0] = np.nan
    figure = map_figure(dataset, "torque_total")
    assert [panel.get_title() for panel in figure.axes[:3]] == ["viscosity 0.1", "viscosity 0.2", "viscosity 0.3"]
    assert figure.get_suptitle() == "friction torque (grey: failed)"
    assert len(map_figure(made(a=np.arange(9.0), b=np.arange(8.0), c=np.arange(7.0)), "torque_total").axes) == 7


def mesh_of(panel: Any) -> Any:
    (found,) = (part for part in panel.collections if type(part).__name__ == "QuadMesh")
    return found


def test_a_wide_range_of_values_has_a_logarithmic_scale() -> None:
    dataset = made(load=[100.0, 300.0, 500.0, 900.0], speed=[50.0, 90.0, 500.0])
    for most, wide in ((0.19, False), (0.21, True)):
        dataset["torque_total"].values[:] = np.linspace(0.01, most, 12).reshape(4, 3)
        panel = map_figure(dataset, "torque_total").axes[0]
        assert isinstance(mesh_of(panel).norm, LogNorm) == wide
        (lines,) = map_figure(dataset.isel(speed=[0]), "torque_total").axes
        few = np.ptp(dataset["torque_total"].values[:, 0]) > 19 * 0.01
        assert lines.get_yscale() == ("log" if few else "linear")
    dataset["torque_total"].values[:] = np.linspace(-0.01, 0.21, 12).reshape(4, 3)
    assert not isinstance(mesh_of(map_figure(dataset, "torque_total").axes[0]).norm, LogNorm)


def test_cells_of_a_logarithmic_axis_end_in_the_middle_of_the_logarithm() -> None:
    dataset = made(load=[10.0, 40.0, 160.0, 640.0], speed=[50.0, 90.0, 130.0])
    dataset["torque_total"][1, 1] = np.nan
    panel = map_figure(dataset, "torque_total").axes[0]
    np.testing.assert_allclose(panel.get_ylim(), (5.0, 1280.0), rtol=1e-9)  # half a step of 4 beyond both ends
    np.testing.assert_allclose(panel.get_xlim(), (30.0, 150.0), rtol=1e-9)
    corners = np.asarray(mesh_of(panel).get_coordinates())
    np.testing.assert_allclose(corners[:, 0, 1], [5, 20, 80, 320, 1280], rtol=1e-9)
    np.testing.assert_allclose(corners[0, :, 0], [30, 70, 110, 150], rtol=1e-9)


def test_discrepancies_are_shown_in_per_cent() -> None:
    dataset = made(load=[1.0, 2.0, 3.0]).rename(torque_total="discrepancy_peak_pressure")
    (panel,) = map_figure(dataset, "discrepancy_peak_pressure").axes
    np.testing.assert_allclose(np.asarray(panel.lines[0].get_ydata()), 100 * dataset["discrepancy_peak_pressure"])
    assert panel.get_ylabel().endswith(", %")


def test_pictures_are_written_of_what_has_numbers_and_an_axis(tmp_path: Path) -> None:
    dataset = made(load=[1.0, 2.0, 3.0])
    lost = dataset["torque_total"] * np.nan
    dataset["peak_pressure"] = lost.assign_attrs(dataset["torque_total"].attrs)
    dataset["unknown"] = dataset["torque_total"]
    assert write_maps(dataset, tmp_path) == [tmp_path / "torque_total.png"]
    assert (tmp_path / "torque_total.png").read_bytes().startswith(b"\x89PNG")
    assert write_maps(made(load=[1.0]), tmp_path) == []


def test_lines_are_over_the_longest_axis_where_none_has_three_numbers() -> None:
    for axes in (
        {"pair": ["inner", "outer"], "oil": ["a", "b", "c", "d"]},
        {"oil": ["a", "b", "c", "d"], "pair": ["inner", "outer"]},
    ):
        (panel,) = map_figure(made(**axes), "torque_total").axes
        assert [text.get_text() for text in panel.get_xticklabels()] == ["a", "b", "c", "d"]
        assert [line.get_label() for line in panel.lines] == ["pair inner", "pair outer"]


def test_too_many_lines_are_thinned_evenly_with_both_ends() -> None:
    for count, names in ((8, range(8)), (9, (0, 1, 2, 3, 5, 6, 7, 8)), (15, range(0, 15, 2))):
        dataset = made(name=[f"B{number}" for number in range(count)], load=[1.0, 2.0, 3.0])
        (panel,) = map_figure(dataset, "torque_total").axes
        assert [line.get_label() for line in panel.lines] == [f"name B{number}" for number in names]
    assert panel.get_legend() is not None
    (alone,) = map_figure(made(load=[1.0, 2.0, 3.0]), "torque_total").axes
    assert alone.get_legend() is None
