"""The torque map: torques of the function, the interval of its points, and standstill; and its files."""

import csv
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import xarray

from analytic import friction_torque, parse_scene, scene_text, torque_function
from analytic.prediction.first_order import first_order_ends
from analytic.scene import Operation, Scene
from analytic.scenefile.read import SceneByTemperature, load_by_temperature, load_scene, parse_by_temperature
from fembearing.formats.axes import axes_of
from fembearing.formats.choice import export, export_of
from fembearing.formats.torque_map import TorqueMap, from_standstill, mapped_torque
from tests.refusals import refused

OVER = {
    "speed": "0 rpm to 3600 rpm in 7",
    "axial_load": "0 N to 800 N in 3",
    "radial_load": "900 N",
    "temperature": "45 degC to 75 degC in 3",
}


BALANCED = {"friction.spin_rule": "balanced"}
OWN_OILS = {
    "data sheet": 'base_oil = "mineral"\nviscosity = ["46 cSt at 40 degC", "6.8 cSt at 100 degC"]',
    "named oil, own viscosities": 'name = "ISO VG 68"\nviscosity = ["75 cSt at 40 degC", "9.6 cSt at 100 degC"]',
}


@pytest.fixture(scope="module")
def found() -> SceneByTemperature:
    return load_by_temperature("6206", speed="1500 rpm", radial_load="900 N", oil="ISO VG 68", settings=BALANCED)


@pytest.fixture(scope="module")
def scene(found: SceneByTemperature) -> Scene:
    return found.scene


@pytest.fixture(scope="module")
def table(found: SceneByTemperature) -> TorqueMap:
    return mapped_torque(found, axes_of(found, OVER, whole=True))


def test_the_torque_is_that_of_the_function_at_each_node(table: TorqueMap) -> None:
    """At the scene's own temperature; elsewhere the oil is that of the catalogue there, as the next test has it."""
    speeds, axial, radial, warm = table.axes.values()
    function = torque_function(table.law.found.scene)
    for at in ((1, 0, 0), (3, 2, 0), (6, 1, 0)):
        given = {"inner_speed": speeds[at[0]], "axial_load": axial[at[1]], "radial_load": radial[at[2]]}
        np.testing.assert_allclose(table.nominal[*at, 1], function(**given), rtol=1e-10)  # two starts of the ring
    assert table.scene.lubricant is not None
    assert warm[1] == pytest.approx(table.scene.lubricant.temperature)


@pytest.mark.parametrize("name", OWN_OILS)
def test_an_oil_of_its_own_viscosities_is_that_of_the_scene_at_each_temperature(name: str) -> None:
    """With no tolerance to neglect an effect; the local slope of the viscosity would be 5 % to 11 % off."""
    text = scene_text("6206").replace('name = "ISO VG 68"', OWN_OILS[name])
    settings = {**BALANCED, "tolerance": 1e-4, "operation.radial_load": 900.0, "operation.inner_speed": "1500 rpm"}
    found = parse_by_temperature(text, origin=name, settings=settings)
    over = {"speed": "1500 rpm", "axial_load": "0 N", "radial_load": "900 N", "temperature": "30 degC to 90 degC in 3"}
    table = mapped_torque(found, axes_of(found, over, whole=True))
    for place, celsius in enumerate((30, 60, 90)):
        there = parse_scene(text, origin=name, settings=settings | {"lubricant.temperature": f"{celsius} degC"})
        right = friction_torque(there)
        assert table.nominal[0, 0, 0, place] == pytest.approx(right.torque.total[0], rel=1e-3)
        ends = first_order_ends(there, right)
        assert ends is not None
        np.testing.assert_allclose(table.torque[::2, 0, 0, 0, place], ends[:, 0], rtol=0.03)  # one sliding coefficient


def test_an_oil_that_is_known_at_one_temperature_has_no_other(scene: Scene, tmp_path: Path) -> None:
    """A Scene of Python, and a name with one viscosity: the axis has the temperature of the scene, and no other."""
    settings = {**BALANCED, "lubricant.name": "ISO VG 68", "lubricant.viscosity": "0.031 Pa s"}
    settings["lubricant.temperature"] = "60 degC"
    named = load_by_temperature("6206", speed="1500 rpm", radial_load="900 N", settings=settings)
    made = load_by_temperature(scene)
    for each, words in (
        (made, ["a Scene holds its oil at one temperature"]),
        (named, ["oil at 45 degC", "0.031 Pa s", "give two viscosities"]),
    ):
        axes = axes_of(each, {}, whole=True)
        assert axes["temperature"].tolist() == pytest.approx([333.15])
        assert axes["radial_load"].size == 5
        refused(lambda each=each: mapped_torque(each, axes_of(each, OVER, whole=True)), *words)
    over = {"speed": [20.0], "axial_load": "0 N", "radial_load": "900 N"}
    export(scene, to="csv", out=tmp_path / "map.csv", over=over)
    rows = (tmp_path / "map.csv").read_text("utf-8").splitlines()
    assert len(rows) == 2


def test_the_interval_is_that_of_each_point(scene: Scene, table: TorqueMap) -> None:
    """Between the nodes at which it is computed, too: its logarithms are interpolated."""
    speeds, axial, radial, warm = table.axes.values()
    assert scene.lubricant is not None
    for at in ((1, 0, 0, 2), (2, 1, 0, 1), (5, 2, 0, 0), (4, 1, 0, 1)):
        point = Operation(inner_speed=speeds[at[:1]], axial_load=axial[[at[1]]], radial_load=radial[[at[2]]])
        there = replace(scene, operation=point, lubricant=replace(scene.lubricant, temperature=float(warm[at[3]])))
        nominal = friction_torque(there)
        ends = first_order_ends(there, nominal)
        assert ends is not None
        ratios = (ends / nominal.torque.total)[:, 0]
        np.testing.assert_allclose(table.torque[::2, *at] / table.nominal[at], ratios, rtol=0.03)


def test_standstill_is_the_limit_of_small_speeds(table: TorqueMap) -> None:
    _, axial, radial, _ = table.axes.values()
    assert np.isfinite(table.torque).all()
    assert (table.torque > 0).all()
    function = torque_function(table.law.found.scene)
    for place, load in enumerate(axial):
        slow = function.series(inner_speed=[0.0, 1e-4, 1e-3], axial_load=load, radial_load=radial[0])
        np.testing.assert_allclose(table.nominal[0, place, 0, 1], slow, rtol=0.02)  # as at 0.01 rpm, and at 0 itself


def test_standstill_and_slow_speeds_come_first() -> None:
    moved = from_standstill({"speed": np.array([3.0, 7.0]), "axial_load": np.array([50.0])})["speed"]
    np.testing.assert_array_equal(moved[-3:], [1.5, 3.0, 7.0])
    np.testing.assert_allclose(moved[2:-1] / moved[1:-2], 2.0, rtol=1e-15)
    assert moved[0] == 0 < moved[1] <= 7e-5
    refused(lambda: from_standstill({"speed": np.array([0.0])}), "speed 0 alone")


def test_csv_and_netcdf_have_the_map(found: SceneByTemperature, table: TorqueMap, tmp_path: Path) -> None:
    made = export_of(found, to="netcdf", out=tmp_path / "map.nc", over=OVER)
    with xarray.open_dataset(made.file) as file:
        data = file.load()
    names = ("inner_speed", "axial_load", "radial_load", "temperature")
    for name, values in zip(("torque_low", "torque", "torque_high"), table.torque, strict=True):
        assert data[name].dims == names
        assert data[name].attrs["units"] == "N m"
        np.testing.assert_allclose(data[name], values, rtol=1e-9)  # rounding in sums of threads
    for name, values in zip(names, table.axes.values(), strict=True):
        np.testing.assert_array_equal(data[name], values)
    assert [data[name].attrs["units"] for name in names] == ["rad/s", "N", "N", "K"]
    assert '"name": "6206"' in data.attrs["scene"]
    made = export_of(found, to="csv", out=tmp_path / "map.csv", over=OVER)
    head, *rows = csv.reader(made.file.read_text("utf-8").splitlines())
    assert head[:4] == ["inner_speed [rpm]", "axial_load [N]", "radial_load [N]", "temperature [degC]"]
    assert head[4:] == ["torque_low [N mm]", "torque [N mm]", "torque_high [N mm]"]
    numbers = np.array(rows, dtype=float)
    np.testing.assert_allclose(numbers[:, 4:].T, 1e3 * table.torque.reshape(3, -1), rtol=1e-9)
    np.testing.assert_allclose(np.unique(numbers[:, 0]), np.linspace(0, 3600, 7), rtol=1e-12)
    np.testing.assert_allclose(np.unique(numbers[:, 3]), [45, 60, 75], rtol=1e-12)


def test_free_balls_have_the_interval_of_balanced_ones() -> None:
    """The ends over the torque, as the map has them: within 10 %, where they are 0.47 to 3.8 of it."""
    scene = load_scene("6206", speed="1500 rpm", radial_load="2 kN")
    made = load_by_temperature(scene)
    found = mapped_torque(made, axes_of(made, {"speed": [0.3, 3.0, 30.0]}, whole=False))
    point = Operation(inner_speed=np.array([0.3, 30.0]), axial_load=np.zeros(2), radial_load=np.full(2, 2000.0))
    nominal = friction_torque(replace(scene, operation=point))
    assert nominal.sliding == "marched_creep"
    ends = first_order_ends(replace(scene, operation=point), nominal)
    assert ends is not None
    low, torque, high = found.curve[1][:, ::2]
    np.testing.assert_allclose([low / torque, high / torque], ends / nominal.torque.total, rtol=0.1)
    np.testing.assert_allclose(torque, nominal.torque.total, rtol=scene.tolerance)


def test_mistakes_are_refused_in_one_line(scene: Scene, tmp_path: Path) -> None:
    (tmp_path / "there.csv").touch()
    wrong = {
        ("csv", "there.csv"): ["there.csv", "exists already"],
        ("csv", "map.nc"): ["map.nc", ".csv"],
        ("xlsx", "map.xlsx"): ["xlsx", "is no format", "csv, netcdf"],
        ("csv", "no/map.csv"): ["no/map.csv", "cannot be made"],
    }
    for (to, name), words in wrong.items():
        refused(lambda to=to, name=name: export(scene, to=to, out=tmp_path / name, over=OVER), *words)  # pyright: ignore[reportArgumentType]
    refused(lambda: export(scene, to="csv", out=tmp_path / "map.csv", over={"load": "3 N"}), "load is no axis")
    assert [path.name for path in tmp_path.iterdir()] == ["there.csv"]
