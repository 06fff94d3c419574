"""Ranges of speed, load and temperature: what they mean, and what is refused."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Array, Scene
from analytic.scenefile.read import load_by_temperature, load_scene
from fembearing.formats.axes import axes_in_words, axes_of, axis_values
from tests.refusals import refused

RPM = np.pi / 30


def axes_at(scene: Scene, over: Mapping[str, Any], *, whole: bool) -> dict[str, Array]:
    return axes_of(load_by_temperature(scene), over, whole=whole)


def test_a_range_has_even_steps_or_equal_ratios_and_its_ends_exactly() -> None:
    speeds = axis_values("speed", "0 rpm to 6000 rpm in 5")
    np.testing.assert_allclose(speeds, RPM * np.array([0.0, 1500.0, 3000.0, 4500.0, 6000.0]), rtol=1e-15)
    loads = axis_values("axial_load", "50 N to 3.2 kN in 4 log")
    np.testing.assert_allclose(loads, [50.0, 200.0, 800.0, 3200.0], rtol=1e-14)
    assert (loads[0], loads[-1]) == (50.0, 3200.0)
    np.testing.assert_allclose(axis_values("temperature", "40C to 70C in 3"), [313.15, 328.15, 343.15], rtol=1e-15)


def test_one_value_and_lists_are_axes_too() -> None:
    np.testing.assert_array_equal(axis_values("radial_load", "2,5 kN"), [2500.0])
    np.testing.assert_allclose(axis_values("speed", '["300 rpm", "450 rpm"]'), [300 * RPM, 450 * RPM], rtol=1e-15)
    np.testing.assert_array_equal(axis_values("axial_load", [120.0, 310.0]), [120.0, 310.0])
    np.testing.assert_array_equal(axis_values("axial_load", ["120 N", "0.31 kN"]), [120.0, 310.0])


@pytest.mark.parametrize(
    ("name", "given", "words"),
    [
        ("speed", "1000 rpm to 2000 rpm", ["is no range", "FIRST to LAST in COUNT"]),
        ("speed", "0 rpm to 6000 rpm in 1", ["speed", "has 1 values", "2 or more"]),
        ("speed", "300 rpm to 300 rpm in 4", ["one value 4 times"]),
        ("speed", "0 rpm to 6000 rpm in 5 log", ["no equal ratios"]),
        ("speed", "-20 rpm to 60 rpm in 5", ["speed begins at -20 rpm"]),
        ("axial_load", "2 kN to 100 N in 5", ["does not ascend"]),
        ("axial_load", "100 N to 200 N in 100001", ["more than 100000"]),
        ("axial_load", [], ["no list"]),
        ("moment", "3 N m", ["moment is no axis", "speed, axial_load"]),
    ],
)
def test_what_is_no_axis_is_refused(name: str, given: object, words: list[str]) -> None:
    refused(lambda: axis_values(name, given), *words)


def test_what_is_not_given_follows_from_the_scene() -> None:
    scene = load_by_temperature("6206", radial_load="3 kN", speed="700 rpm", temperature="50 degC")
    whole, curve = (axes_of(scene, {}, whole=each) for each in (True, False))
    assert whole["speed"][0] == 0
    mean = scene.scene.bearing.pitch_diameter
    assert 1e3 * mean * whole["speed"][-1] / RPM == pytest.approx(1e6)  # n d_m, mm/min, usual in an oil bath
    greased, faster = (
        load_by_temperature("6206", radial_load="3 kN", settings={"lubricant.supply": "grease"}, speed=speed)
        for speed in ("0 rpm", "40000 rpm")
    )
    ends = [axes_of(each, {}, whole=True)["speed"][-1] / RPM for each in (greased, faster)]
    assert ends == pytest.approx([0.5e6 / (1e3 * mean), 40000])
    np.testing.assert_allclose(whole["radial_load"][[0, -1]], [1500.0, 6000.0])  # half and double
    np.testing.assert_array_equal(whole["axial_load"], [0.0])
    np.testing.assert_allclose(whole["temperature"][[0, -1]], [303.15, 343.15])  # 20 K around
    assert {name: values.size for name, values in curve.items() if name != "speed"} == {
        "axial_load": 1,
        "radial_load": 1,
        "temperature": 1,
    }
    given = axes_of(scene, {"speed": "0 rpm to 900 rpm in 4", "temperature": "55 degC"}, whole=False)
    assert axes_in_words(given) == (
        "speed 0 rpm to 900 rpm in 4, axial load 0 N in 1, radial load 3000 N in 1, temperature 55 degC in 1"
    )


def test_a_scene_without_an_oil_has_no_temperature() -> None:
    dry = load_scene("6205-dry")
    assert "temperature" not in axes_at(dry, {}, whole=True)
    refused(lambda: axes_at(dry, {"temperature": "50 degC"}, whole=True), "temperature", "no", "oil")


def test_a_load_with_several_values_in_the_scene_spans_them_in_a_map_and_is_asked_for_in_a_curve() -> None:
    scene = load_scene("6206", radial_load="3 kN", speed="700 rpm")
    series = replace(scene, operation=replace(scene.operation, radial_load=np.array([3000.0, 900.0, 2000.0])))
    np.testing.assert_allclose(axes_at(series, {}, whole=True)["radial_load"], [900, 1425, 1950, 2475, 3000])
    refused(lambda: axes_at(series, {}, whole=False), "radial load has 3 values in the scene", "give radial_load")
    given = axes_at(series, {"radial_load": "500 N"}, whole=False)
    np.testing.assert_array_equal(given["radial_load"], [500.0])


def test_several_moments_make_no_table() -> None:
    scene = load_scene("6206", radial_load="3 kN", speed="700 rpm")
    moments = replace(scene, operation=replace(scene.operation, moment=np.array([0.0, 0.3])))
    refused(lambda: axes_at(moments, {}, whole=True), "operation.moment has several values")
    one = replace(scene, operation=replace(scene.operation, moment=np.array([0.3, 0.3])))
    assert axes_at(one, {}, whole=True)["axial_load"].tolist() == [0.0]


def test_a_negative_load_has_its_range_in_ascending_order() -> None:
    scene = load_scene("6206", radial_load="3 kN", speed="700 rpm")
    pulled = replace(scene, operation=replace(scene.operation, axial_load=np.array([-600.0])))
    loads = axes_at(pulled, {}, whole=True)["axial_load"]
    np.testing.assert_allclose(loads, [-1200, -600 * 2**0.5, -600, -600 / 2**0.5, -300], rtol=1e-12)
