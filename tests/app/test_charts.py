"""The charts hold the numbers of the torque: sums, ends and places."""

import json
import re
from dataclasses import replace
from functools import cache
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scenefile.template import scene_text
from analytic.units import METRIC, SYSTEMS
from fembearing.app import evaluation
from fembearing.app.charts import curve_options, ellipse_options, part_legend, part_options, ring_options
from fembearing.app.evaluation import Evaluation, at_once, completed, curve_scenes, series_of
from fembearing.app.scene_edit import with_value
from tests.analytic.specimens import present

DRY = """
name = "dry"
tolerance = "5 %"
[bearing]
catalog = "6206"
[operation]
radial_load = "2 kN"
inner_speed = "700 rpm"
[friction]
coefficient = 0.08
"""
DIGITS = 2e-5  # charts have at least 5 digits


@cache
def found(speed: str = "730 rpm") -> Evaluation:
    text = with_value(scene_text("6206"), "operation.radial_load", "2 kN")
    return completed(at_once(with_value(text, "operation.inner_speed", json.loads(speed) if "[" in speed else speed)))


def made_of(points: list[dict[str, Any]]) -> Any:
    """A torque with these points."""
    return SimpleNamespace(points=points)


def series(options: dict, name: str) -> np.ndarray:
    return np.array(next(each["data"] for each in options["series"] if each["name"] == name))


def test_the_parts_add_up_to_the_torque() -> None:
    options = part_options(found().row, METRIC)
    total = sum(each["data"][0] for each in options["series"])
    assert total == pytest.approx(1e3 * found().row["torque_total"], rel=DIGITS)
    assert {each["stack"] for each in options["series"]} == {"torque"}
    assert options["xAxis"]["max"] == pytest.approx(total, rel=DIGITS)  # the bar fills its width
    json.dumps(options, allow_nan=False)


def test_a_scene_in_inches_has_charts_in_inches() -> None:
    inch = at_once(f'{scene_text("6206")}\n[report]\nunits = "inch"\n')
    (load, unit), torque = inch.lines["inner"].split(": ")[1].split(", ")[0].split(" "), inch.row["torque_total"]
    assert unit == "lbf"
    assert float(load) == pytest.approx(inch.row["load_inner"] / 4.4482216, rel=1e-3)  # 4 digits
    bars = part_options(inch.row, SYSTEMS["inch"])["series"]
    assert sum(each["data"][0] for each in bars) == pytest.approx(torque / 0.1129848, rel=1e-4)  # 6 digits
    assert inch.lines["unit"] == "lbf in"


def test_the_curve_goes_through_the_torque_at_the_speed_of_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(evaluation, "SPEEDS", np.array([0.1, 0.7, 1.0, 1.4, 2.0]))  # fewer: each takes 0.25 s
    monkeypatch.setattr(evaluation, "SLICES", 2)
    records = [series_of(scene) for scene in curve_scenes(found())]
    options = curve_options(records, METRIC, marked=found().row["inner_speed"])
    torque = series(options, "torque")
    marked = next(each["markLine"]["data"][0]["xAxis"] for each in options["series"] if each["name"] == "torque")
    at = np.argmin(abs(torque[:, 0] - marked))
    assert torque[at] == pytest.approx(
        [730.0, 1e3 * found().row["torque_total"]], rel=1e-3
    )  # tolerance of the scene: 5 %
    low, width = series(options, "95 %, from")[at, 1], series(options, "95 %")[at, 1]
    ends = found().row["interval_low"], found().row["interval_high"]
    # The formulas that vary are those of the whole series, in place of those of one point.
    assert [low, low + width] == pytest.approx([1e3 * end for end in ends], rel=0.02)
    assert np.all(np.diff(torque[:, 0]) > 0)
    json.dumps(options, allow_nan=False)


def test_a_series_is_its_own_curve() -> None:
    many = found('["900 rpm", "300 rpm", "500 rpm"]')
    (scene,) = curve_scenes(many)
    torque = series(curve_options([series_of(scene)], METRIC, marked=None), "torque")
    assert torque[:, 0].tolist() == [300.0, 500.0, 900.0]
    by_speed = [many.result.points[place]["torque_total"] for place in (1, 2, 0)]
    assert torque[:, 1] == pytest.approx(1e3 * np.array(by_speed), rel=DIGITS)
    assert many.row["torque_total"] == max(by_speed)
    low, high = map(float, many.lines["torque"].split("-"))
    assert [low, high] == pytest.approx([1e3 * min(by_speed), 1e3 * max(by_speed)], rel=1e-3)  # 4 digits


def test_a_bearing_at_rest_has_no_curve() -> None:
    assert curve_scenes(found("0 rpm")) == []


def test_the_ring_is_closed_and_has_every_ball() -> None:
    ring = found().result.friction.ring
    options = ring_options(found().result.friction, 0, METRIC)
    assert options is not None
    assert ring is not None
    inner = series(options, "inner race")
    assert len(inner) == len(ring.azimuth) + 1
    assert inner[0, 0] == inner[-1, 0]
    assert inner[-1, 1] - inner[0, 1] == pytest.approx(360.0)
    assert inner[:-1, 0] == pytest.approx(ring.load[0, 0], rel=DIGITS)
    # Its load balances the bearing's: the sum over the balls along x, at a contact angle of about 0.
    along = ring.load[0, 0] @ np.cos(ring.azimuth)
    heaviest = inner[np.argmax(inner[:, 0])]
    assert heaviest[1] % 360 == pytest.approx(180.0)  # from the top, so that it is at the bottom, as the load points
    assert along == pytest.approx(2000.0, rel=0.01)  # contact angle, and forces of inertia at 730 rpm


def test_the_curve_shades_what_is_known_at_every_point_and_marks_a_speed_alone() -> None:
    names = ("interval_low", "interval_high", "catalogue_low", "catalogue_high")
    ends = ((0.002, 0.005, 0.01, 0.04), (0.001, 0.009, 0.03, 0.05), (0.003, 0.007, 0.02, 0.07))
    points = [
        {**found().row, "inner_speed": 10.0 * number, **dict(zip(names, each, strict=True))}
        for number, each in zip((3, 1, 2), ends, strict=True)
    ]
    whole = made_of(points)
    options = curve_options([whole], METRIC, marked=None)
    for name, low, high in (
        ("95 %", (1.0, 3.0, 2.0), (9.0, 7.0, 5.0)),
        ("makers' formulas", (30.0, 20.0, 10.0), (50.0, 70.0, 40.0)),
    ):
        ground, height = series(options, f"{name}, from")[:, 1], series(options, name)[:, 1]
        np.testing.assert_allclose(ground, low, rtol=1e-9)
        np.testing.assert_allclose(ground + height, high, rtol=1e-9)
    assert [each["name"] for each in options["legend"]["data"][:-1]] == ["makers' formulas", "95 %"]
    # Empty, as the chart of the scene before may have a line there.
    assert [each["markLine"]["data"] for each in options["series"] if "markLine" in each] == [[]]
    for marked in (30.0, -30.0):  # the axis has no sign
        (line,) = (
            each["markLine"] for each in curve_options([whole], METRIC, marked=marked)["series"] if "markLine" in each
        )
        assert line["data"][0]["xAxis"] == pytest.approx(30.0 * 30 / np.pi, rel=1e-12)
    for name in ("interval_low", "catalogue_high"):
        lacking = curve_options([made_of([{**points[0], name: None}, *points[1:]])], METRIC, marked=None)
        assert len(lacking["legend"]["data"]) == 2
    mixed = made_of([{**points[0], "axial_load": 77.0}, *points[1:]])
    torque = series(curve_options([mixed], METRIC, marked=None), "torque")
    assert torque[:, 0].tolist() == [1.0, 2.0, 3.0]  # point by point


def test_points_without_a_torque_are_not_in_the_curve() -> None:
    points = [{**found().row, "inner_speed": 10.0 * number} for number in (1, 2, 3)]
    points[1]["torque_total"] = None
    whole = made_of(points)
    torque = series(curve_options([whole], METRIC, marked=None), "torque")
    np.testing.assert_allclose(torque[:, 0], np.array([10.0, 30.0]) * 30 / np.pi, rtol=DIGITS)


def test_a_part_that_is_none_or_nothing_has_no_bar() -> None:
    row = found().row
    nothing = dict.fromkeys(f"torque_{name}" for name in ("cage", "oil", "declared", "spin"))

    def with_parts(**parts: float) -> Any:
        return {**row, **nothing, **{f"torque_{name}": part for name, part in parts.items()}}

    torque = with_parts(rolling=0.012, conformity=0.008, hysteresis=1e-12, total=0.02)
    options = part_options(torque, METRIC)
    assert [each["name"] for each in options["series"]] == ["conformity slip", "rolling against the oil"]
    legend = part_legend(torque, METRIC)
    assert re.findall(r"<b>(\d+) %</b>, ([\d.]+ N mm)", legend) == [("40", "8 N mm"), ("60", "12 N mm")]
    still = with_parts(rolling=0.0, conformity=0.0, hysteresis=0.0, total=0.0)
    assert part_options(still, METRIC)["xAxis"]["max"] == 1.0


def test_the_room_around_an_ellipse_is_that_of_its_groove() -> None:
    """A shoulder that is not known is not drawn; twice the ellipse is then shown on its side."""
    contact, row = found().contacts["inner"], found().row
    across, half = 1e3 * row["semi_axis_transverse_inner"], 1e3 * row["semi_axis_rolling_inner"]
    known = replace(contact, shoulder=3.2e-3, far_shoulder=2.6e-3)
    options = ellipse_options(known, row, METRIC)
    x, y, room = options["xAxis"], options["yAxis"], options["grid"]
    assert [each["xAxis"] for each in options["series"][0]["markLine"]["data"]] == [-2.6, 3.2]
    assert (x["min"], x["max"]) == pytest.approx((-1.15 * 2.6, 1.15 * 3.2), rel=DIGITS)
    assert half < y["max"] == -y["min"] < 2.5 * half
    assert y["max"] / y["interval"] == pytest.approx(round(y["max"] / y["interval"]))  # both ends have a number
    scales = room["height"] / (y["max"] - y["min"]), room["width"] / (x["max"] - x["min"])  # pixels of a millimetre
    said = re.findall(r"rolling (\d+) times larger", x["name"])
    assert int(said[0]) == pytest.approx(scales[0] / scales[1], rel=0.01)  # the height is in whole pixels
    upper, lower = (np.array(each["data"]) for each in options["series"])
    np.testing.assert_allclose(upper[[0, -1], 0], [-across, across], rtol=DIGITS)
    np.testing.assert_allclose(upper[:, 1], -lower[:, 1])
    np.testing.assert_allclose((upper[:, 0] / across) ** 2 + (upper[:, 1] / half) ** 2, 1, rtol=1e-4)
    open_side = ellipse_options(replace(known, far_shoulder=np.inf), row, METRIC)
    assert [each["xAxis"] for each in open_side["series"][0]["markLine"]["data"]] == [3.2]
    assert open_side["xAxis"]["min"] == pytest.approx(-1.15 * 2 * across, rel=DIGITS)


def test_the_lines_of_a_scene_say_what_is_not_known() -> None:
    one, many = found(), found('["900 rpm", "300 rpm", "500 rpm"]')
    assert one.lines["split"] == ""  # its bar says it
    assert many.lines["split"].startswith("At point 1: 2000 N radial, 900 rpm, the highest torque: ")
    assert "points down" in one.lines["ring"]
    assert one.lines["contact"] == ""
    lost = replace(one, no_contact="no shoulder is known")
    assert lost.lines["contact"] == "no shoulder is known"
    pair = replace(one, result=replace(one.result, friction=replace(one.result.friction, ring=None)))
    assert "Balls of a pair" in pair.lines["ring"]
    dry = at_once(DRY)
    assert dry.lines["film"] == "film: not computed without oil and surface"
    assert dry.number("lubricant.temperature") is None
    assert dry.derived["lubricant.supply"] == "none"
    assert dry.number("operation.radial_load") == 2000.0
    assert one.number("lubricant.temperature") == present(one.result.scene.lubricant).temperature


def test_the_curve_has_every_speed_once_and_ends_at_twice_the_own_one() -> None:
    scenes = curve_scenes(found())
    assert len(scenes) == evaluation.SLICES
    speeds = np.concatenate([scene.operation.inner_speed for scene in scenes])
    own = found().row["inner_speed"]
    np.testing.assert_allclose(np.sort(speeds), own * evaluation.SPEEDS, rtol=1e-12)
    assert all(np.all(np.diff(scene.operation.inner_speed) > 0) for scene in scenes)
