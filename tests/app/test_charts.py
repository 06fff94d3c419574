"""The charts hold the numbers of the torque: sums, ends and places."""

import json
import re
from functools import cache

import numpy as np
import pytest

from analytic.scenefile.template import scene_text
from fembearing.app import evaluation
from fembearing.app.charts import curve_options, ellipse_options, part_legend, part_options, ring_options
from fembearing.app.evaluation import Evaluation, at_once, completed, curve_scenes, series_record
from fembearing.app.scene_edit import with_value
from fembearing.quantities import METRIC, SYSTEMS

DIGITS = 2e-5  # charts have at least 5 digits


@cache
def found(speed: str = "730 rpm") -> Evaluation:
    text = with_value(scene_text("6206"), "operation.radial_load", "2 kN")
    return completed(at_once(with_value(text, "operation.inner_speed", json.loads(speed) if "[" in speed else speed)))


def series(options: dict, name: str) -> np.ndarray:
    return np.array(next(each["data"] for each in options["series"] if each["name"] == name))


def test_the_parts_add_up_to_the_torque() -> None:
    options = part_options(found().row, METRIC)
    total = sum(each["data"][0] for each in options["series"])
    assert total == pytest.approx(1e3 * found().row.torque.total, rel=DIGITS)
    assert {each["stack"] for each in options["series"]} == {"torque"}
    assert options["xAxis"]["max"] == pytest.approx(total, rel=DIGITS)  # the bar fills its width
    json.dumps(options, allow_nan=False)


def test_the_legend_has_every_part_and_its_share() -> None:
    legend = part_legend(found().row, METRIC)
    shares = [float(share) for share in re.findall(r"<b>(\d+) %</b>", legend)]
    assert len(shares) == len(part_options(found().row, METRIC)["series"])
    assert sum(shares) == pytest.approx(100, abs=0.5 * len(shares))  # each is rounded to a whole number


def test_a_scene_in_inches_has_charts_in_inches() -> None:
    inch = at_once(f'{scene_text("6206")}\n[report]\nunits = "inch"\n')
    (load, unit), torque = inch.lines["inner"].split(": ")[1].split(", ")[0].split(" "), inch.row.torque.total
    assert unit == "lbf"
    assert float(load) == pytest.approx(inch.row.contact.inner.load / 4.4482216, rel=1e-3)  # 4 digits
    bars = part_options(inch.row, SYSTEMS["inch"])["series"]
    assert sum(each["data"][0] for each in bars) == pytest.approx(torque / 0.1129848, rel=1e-4)  # 6 digits
    assert inch.lines["unit"] == "lbf in"


def test_the_curve_goes_through_the_torque_at_the_speed_of_the_scene(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(evaluation, "SPEEDS", np.array([0.1, 0.7, 1.0, 1.4, 2.0]))  # fewer: each takes 0.25 s
    monkeypatch.setattr(evaluation, "SLICES", 2)
    records = [series_record(scene) for scene in curve_scenes(found())]
    options = curve_options(records, METRIC, marked=found().row.inner_speed)
    torque = series(options, "torque")
    marked = next(each["markLine"]["data"][0]["xAxis"] for each in options["series"] if each["name"] == "torque")
    at = np.argmin(abs(torque[:, 0] - marked))
    assert torque[at] == pytest.approx([730.0, 1e3 * found().row.torque.total], rel=1e-3)  # tolerance of the scene: 5 %
    low, width = series(options, "95 %, from")[at, 1], series(options, "95 %")[at, 1]
    ends = found().record.interval[0]
    assert ends is not None
    # The formulas that vary are those of the whole series, in place of those of one point.
    assert [low, low + width] == pytest.approx([1e3 * end for end in ends], rel=0.02)
    assert np.all(np.diff(torque[:, 0]) > 0)
    json.dumps(options, allow_nan=False)


def test_a_series_is_its_own_curve() -> None:
    many = found('["900 rpm", "300 rpm", "500 rpm"]')
    (scene,) = curve_scenes(many)
    torque = series(curve_options([series_record(scene)], METRIC, marked=None), "torque")
    assert torque[:, 0].tolist() == [300.0, 500.0, 900.0]
    by_speed = [many.record.points[place].torque.total for place in (1, 2, 0)]
    assert torque[:, 1] == pytest.approx(1e3 * np.array(by_speed), rel=DIGITS)
    assert many.row.torque.total == max(by_speed)
    low, high = map(float, many.lines["torque"].split("-"))
    assert [low, high] == pytest.approx([1e3 * min(by_speed), 1e3 * max(by_speed)], rel=1e-3)  # 4 digits


def test_a_bearing_at_rest_has_no_curve() -> None:
    assert curve_scenes(found("0 rpm")) == []


def test_the_ring_is_closed_and_has_every_ball() -> None:
    options, ring = ring_options(found().row, METRIC), found().row.ring
    assert options is not None
    assert ring is not None
    inner = series(options, "inner race")
    assert len(inner) == len(ring.balls.azimuth) + 1
    assert inner[0, 0] == inner[-1, 0]
    assert inner[-1, 1] - inner[0, 1] == pytest.approx(360.0)
    assert inner[:-1, 0] == pytest.approx(np.array(ring.balls.inner_load), rel=DIGITS)
    # Its load balances the bearing's: the sum over the balls along x, at a contact angle of about 0.
    along = np.array(ring.balls.inner_load) @ np.cos(ring.balls.azimuth)
    heaviest = inner[np.argmax(inner[:, 0])]
    assert heaviest[1] % 360 == pytest.approx(180.0)  # from the top, so that it is at the bottom, as the load points
    assert along == pytest.approx(2000.0, rel=0.01)  # contact angle, and forces of inertia at 730 rpm


def test_the_ellipse_has_both_semi_axes_and_lies_between_the_shoulders() -> None:
    for race in ("inner", "outer"):
        contact, row = found().contacts[race], getattr(found().row.contact, race)
        options = ellipse_options(contact, row, METRIC)
        upper, lower = (np.array(each["data"]) for each in options["series"])
        # Its area by the trapezoidal rule, which is 0.03 % too small with 81 points.
        area = np.trapezoid(upper[:, 1], upper[:, 0]) - np.trapezoid(lower[:, 1], lower[:, 0])
        assert area == pytest.approx(1e6 * np.pi * row.semi_axis_rolling * row.semi_axis_transverse, rel=1e-3)
        near, far = sorted(each["xAxis"] for each in options["series"][0]["markLine"]["data"])
        assert near < upper[0, 0] < upper[-1, 0] < far
