"""Maps of a sweep's dataset: lines for one axis, colours for two, panels for more."""

import json
from typing import Any

import numpy as np
import xarray

from fembearing.report.figures.sweep_maps import map_figure
from tests.report.figures.figure_reader import require_legible


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
        assert panel.get_ylim() == (100.0, 900.0)
        assert mesh.get_clim() == (shown.min(), shown.max())
        require_legible(map_figure(dataset, "torque_total"))


def test_an_axis_is_logarithmic_where_it_is_wide_and_its_steps_grow() -> None:
    for speeds, scale in (([1.0, 3.0, 10.0, 31.0], "log"), ([1.0, 1.1, 1.21, 1.33], "linear"), ([1, 11, 21], "linear")):
        (panel,) = map_figure(made(speed=speeds), "torque_total").axes
        assert panel.get_xscale() == scale


def test_two_values_of_an_axis_are_two_lines() -> None:
    (panel,) = map_figure(made(roughness=[0.1, 0.3], load=[1.0, 2.0, 3.0]), "torque_total").axes
    assert [line.get_label() for line in panel.lines] == ["roughness 0.1", "roughness 0.3"]


def test_the_title_names_what_no_axis_changes() -> None:
    """SI: 333.15 K are 60 degrees Celsius, 157.08 rad/s are 1500 rpm."""
    scene = {
        "bearing": {"name": "6205"},
        "lubricant": {"name": "ISO VG 68", "temperature": 333.15},
        "operation": {"axial_load": [300.0, 500.0], "radial_load": [750.0], "inner_speed": [157.07963]},
    }
    dataset = made(load=[100.0, 300.0, 500.0], viscosity=[0.1, 0.2, 0.3]).assign_attrs(first_scene=json.dumps(scene))
    assert map_figure(dataset, "torque_total").get_suptitle().splitlines()[1] == (
        "6205, ISO VG 68, 60 degC, radial 750 N, inner 1500 rpm"
    )
    dataset["viscosity"].attrs["key"] = "lubricant.temperature"
    assert "degC" not in map_figure(dataset, "torque_total").get_suptitle()


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
