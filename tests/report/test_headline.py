"""The headline of a torque: its words and numbers against those of the result."""

from collections.abc import Sequence
from dataclasses import replace
from io import StringIO
from typing import Any

import numpy as np
import pytest
from rich.console import Console

from analytic.scene_torque import SceneTorque, torque_of_scene, with_interval
from analytic.scenefile.read import load_scene
from fembearing.report.headline import (
    declared_by,
    film_words,
    headline_table,
    headline_title,
    side_by_side,
    span_of,
    split_of,
    torque_headline,
    torque_words,
)
from fembearing.report.tables.table import Table
from fembearing.report.terminal.table import show
from fembearing.report.terminal.torque import print_headline
from fembearing.report.torque import Band, TorqueRecord, torque_record
from tests.analytic.specimens import present


@pytest.fixture(scope="module")
def result() -> SceneTorque:
    return torque_of_scene(load_scene("6206", radial_load="2 kN", speed="1500 rpm", oil="ISO VG 46"))


def lines_of(result: SceneTorque) -> list[str]:
    out = StringIO()
    print_headline(Console(file=out, width=80), result)
    return out.getvalue().splitlines()


def test_it_has_torque_interval_power_and_verdict(result: SceneTorque) -> None:
    lines, total = lines_of(result), float(result.friction.torque.total[0])
    assert lines[0].startswith("6206, radial 2000 N, 1500 rpm, ISO VG 46")  # a load of 0 is no word
    low, high = (1e3 * float(end) for (end,) in present(result.interval))
    row = lines[3].split()
    assert row[:5] == ["1", "1500", f"{1e3 * total:.4g}", f"{low:.3g}-{high:.3g}", f"{total * 50 * np.pi:.3g}"]
    assert lines[-1].startswith(f"{result.standing.word}: ")
    assert max(map(len, lines)) <= 80
    assert len(lines) <= 12


def test_the_headline_in_words_is_the_printed_one(result: SceneTorque) -> None:
    printed, words = " ".join(" ".join(lines_of(result)).split()), torque_headline(result)
    for said in (words.title, words.torque, words.interval, words.power, words.split, words.film, words.makers):
        assert said in printed
    assert printed.endswith(f"{words.verdict}: {words.reason}")
    assert f"torque, {words.unit}" in printed


def test_the_interval_may_come_later(result: SceneTorque) -> None:
    without = torque_of_scene(result.scene, estimate=False)
    assert without.interval is None
    assert without.standing == result.standing
    np.testing.assert_allclose(present(with_interval(without).interval), present(result.interval), rtol=1e-6)  # solver


def test_a_headline_says_where_the_oil_returns_slowly(result: SceneTorque) -> None:
    """Above ln 2, where less than half of rolling is left, at any point."""
    for exponents, said in (([0.69], False), ([0.1, 0.7], True), (None, False)):
        values = None if exponents is None else np.array(exponents)
        limits = replace(result.friction.limits, replenishment=values)
        found = film_words(replace(result, friction=replace(result.friction, limits=limits)))
        assert present(found).endswith(", starved to flooded") == said


def test_numbers_of_the_headline_have_no_power_of_ten_and_no_part_of_0_per_cent(result: SceneTorque) -> None:
    fast = torque_of_scene(load_scene("6206", radial_load="60 kN", speed="100000 rpm", oil="ISO VG 46"))
    title, *_, row = lines_of(fast)[:4]
    assert "radial 60000 N, 100000 rpm" in title
    assert "e+" not in row
    for lines in (lines_of(result), lines_of(fast)):
        assert " 0 %" not in lines[3]
        assert "e-" not in " ".join(lines)


def test_scenes_side_by_side_have_one_row_each(result: SceneTorque) -> None:
    names = ("spindle-6206.toml", "b.toml")
    table = side_by_side(dict.fromkeys(names, result))
    out = StringIO()
    show(Console(file=out, width=80), table)
    assert [line.split()[0] for line in out.getvalue().splitlines()[3:5]] == list(names)


def record_of(result: SceneTorque, *, totals: Sequence[float], **changed: Any) -> TorqueRecord:
    """The record with one point for each of these totals, N m, at 10, 20, ... rad/s, each with the same shares."""
    record = torque_record(result)
    (point,) = record.points
    own = point.torque.total
    points = []
    for number, total in enumerate(totals, start=1):
        parts = {name: value and value * total / own for name, value in vars(point.torque).items()}
        torque = replace(point.torque, **parts)
        points.append(replace(point, inner_speed=10.0 * number, torque=torque))
    count = len(points)
    band = Band(low=None, high=None, values={}, note="")
    usual: dict[str, Any] = {"points": tuple(points), "interval": (None,) * count, "catalogue_band": band}
    return replace(record, **(usual | changed))


def cells_of(table: Table) -> list[list[str]]:
    return [[str(cell) for cell in row] for group in table.groups for row in group.rows]


def test_a_long_series_is_told_by_six_of_its_points_with_both_ends(result: SceneTorque) -> None:
    for count, places in ((6, range(6)), (7, (0, 1, 2, 4, 5, 6)), (11, range(0, 11, 2))):
        record = record_of(result, totals=[1e-3 * (20 + number) for number in range(count)])
        table = headline_table(result.scene, record)
        column = [head.text for head in table.heads].index("torque, N mm")
        assert [row[column] for row in cells_of(table)] == [f"{20 + place}" for place in places]
        said = " ".join(table.notes)
        assert (f"6 of {count} operating points" in said) == (count > 6)
        assert "No interval" in said
        assert "skipped" not in said


def test_a_series_is_told_from_its_least_to_its_greatest(result: SceneTorque) -> None:
    record = record_of(result, totals=[0.05, 0.02, 0.03], interval=((0.04, 0.07), (0.01, 0.03), (0.02, 0.09)))
    found = span_of(record)
    assert (found.torque, found.interval, found.power) == ("20-50", "10-90", "0.4-0.9")  # W at 10, 20 and 30 rad/s
    assert span_of(replace(record, interval=(None, (0.01, 0.03), (0.02, 0.09)))).interval == "not known"
    assert torque_words(record).startswith("torque 20-50 N mm at 3 points, 95 % 10-90, 0.4-0.9 W: ")
    alone = record_of(result, totals=[0.05], interval=((0.04, 0.07),))
    assert torque_words(alone).startswith("torque 50 N mm, 95 % 40-70, 0.5 W: ")


def test_the_parts_are_shares_of_the_total_from_the_largest_and_none_of_0_per_cent(result: SceneTorque) -> None:
    (point,) = torque_record(result).points
    parts = dict.fromkeys(vars(point.torque))
    for values, words in (
        ({"rolling": 0.012, "hysteresis": 0.002, "conformity": 0.006}, "roll. 60 %, conf. 30 %, hyst. 10 %"),
        ({"rolling": 0.0199, "hysteresis": 0.00009}, "roll. 100 %"),
        ({"rolling": 0.0198, "hysteresis": 0.00012}, "roll. 99 %, hyst. 1 %"),
        ({"rolling": 0.002, "declared": 0.018}, "seals 90 %, roll. 10 %"),
    ):
        shares = split_of(replace(point, torque=replace(point.torque, **(parts | values | {"total": 0.02}))), "seals")
        assert shares == words


@pytest.mark.parametrize(
    ("losses", "words"),
    [
        *(({"seals": "5 N mm"}, "seals"), ({"drag": "2 N mm"}, "drag"), ({"seals": "off"}, "")),
        ({"seals": "5 N mm", "drag": "2 N mm"}, "seals+drag"),
    ],
)
def test_seals_and_drag_are_named_as_what_they_are(losses: dict[str, str], words: str) -> None:
    scene = load_scene("6206", settings={f"losses.{key}": value for key, value in losses.items()})
    assert declared_by(torque_record(torque_of_scene(scene))) == words


def test_the_film_is_full_mixed_or_boundary_by_what_the_asperities_carry(result: SceneTorque) -> None:
    friction = result.friction
    for carried, words in (
        (0.0, "no load: full film"),
        (9e-5, "no load: full film"),
        (1.1e-4, "up to 0.011 %: full film"),
        (0.0099, "full film"),
        (0.0101, "up to 1 %: mixed"),
        (0.899, "up to 90 %: mixed"),
        (0.901, "up to 90 %: boundary"),
    ):
        share = replace(friction.asperity_share, inner=np.array([carried]), outer=np.array([carried]))
        said = present(film_words(replace(result, friction=replace(friction, asperity_share=share))))
        assert said.endswith(words)
    roughness = present(friction.gap_roughness)
    thin = replace(friction.film, inner=np.array([9e-4 * roughness]), outer=np.array([1.7 * roughness]))
    assert "lambda 0 inner, 1.7 outer;" in present(film_words(replace(result, friction=replace(friction, film=thin))))
    for lacking in (
        {"gap_roughness": None},
        {"film": replace(friction.film, outer=None)},
        {"asperity_share": replace(friction.asperity_share, inner=None)},
    ):
        assert film_words(replace(result, friction=replace(friction, **lacking))) is None


def test_the_title_has_the_loads_and_the_speed_that_are_the_same_everywhere(result: SceneTorque) -> None:
    scene = result.scene
    record = record_of(result, totals=[0.02, 0.03])
    words = "6206, radial 2000 N, ISO VG 46"
    assert headline_title(scene, record).startswith(words)  # two speeds
    first, second = record.points
    alike = replace(record, points=(first, replace(second, inner_speed=first.inner_speed)))
    assert "radial 2000 N, 95.493 rpm, ISO VG 46" in headline_title(scene, alike)
    other = replace(record, points=(first, replace(second, radial_load=900.0, axial_load=0.0)))
    assert headline_title(scene, other).startswith("6206, ISO VG 46")
    assert headline_title(replace(scene, lubricant=None), alike).endswith("95.493 rpm, dry")
    dry = replace(scene, lubricant=None, friction_coefficient=0.08)
    assert headline_title(dry, alike).endswith("95.493 rpm, friction coefficient 0.08")
