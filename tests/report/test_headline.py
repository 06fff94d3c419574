"""The headline of a torque: its words and numbers against those of the result."""

from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from analytic.scene_torque import SceneTorque, torque_of_scene, with_interval
from analytic.scenefile.read import load_scene
from fembearing.report.document import Table
from fembearing.report.sections.headline import (
    declared_by,
    film_words,
    headline_section,
    headline_table,
    split_of,
    torque_headline,
)
from fembearing.report.terminal import print_sections
from tests.analytic.specimens import present


@pytest.fixture(scope="module")
def result() -> SceneTorque:
    return torque_of_scene(load_scene("6206", radial_load="2 kN", speed="1500 rpm", oil="ISO VG 46"))


def lines_of(result: SceneTorque) -> list[str]:
    out = StringIO()
    print_sections(Console(file=out, width=80), [headline_section(result)])
    return out.getvalue().splitlines()


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


def cells_of(table: Table) -> list[list[str]]:
    return [[str(cell) for cell in row] for group in table.groups for row in group.rows]


@pytest.fixture(scope="module")
def series() -> SceneTorque:
    loads = [f"{load} N" for load in range(300, 1000, 100)]
    return torque_of_scene(load_scene("6205-dry", axial_load=loads, speed="400 rpm"))


def test_a_long_series_is_told_by_six_of_its_points_with_both_ends(series: SceneTorque) -> None:
    table = headline_table(series)
    assert [row[0] for row in cells_of(table)] == ["1", "2", "3", "5", "6", "7"]
    assert "6 of 7 operating points" in " ".join(table.notes)
    assert "No interval" in " ".join(headline_table(replace(series, interval=None)).notes)


def test_a_series_is_told_from_its_least_to_its_greatest(series: SceneTorque) -> None:
    found, totals = torque_headline(series), 1e3 * series.friction.torque.total
    low, high = 1e3 * present(series.interval)
    assert found.torque == f"{totals.min():.4g}-{totals.max():.4g}"
    assert found.interval == f"{low.min():.3g}-{high.max():.3g}"


def test_the_parts_are_shares_of_the_total_from_the_largest_and_none_of_0_per_cent(result: SceneTorque) -> None:
    (point,) = result.points
    parts = dict.fromkeys((name for name in point if name.startswith("torque_")), None)
    for values, words in (
        ({"rolling": 0.012, "hysteresis": 0.002, "conformity": 0.006}, "roll. 60 %, conf. 30 %, hyst. 10 %"),
        ({"rolling": 0.0199, "hysteresis": 0.00009}, "roll. 100 %"),
        ({"rolling": 0.0198, "hysteresis": 0.00012}, "roll. 99 %, hyst. 1 %"),
        ({"rolling": 0.002, "declared": 0.018}, "seals 90 %, roll. 10 %"),
    ):
        given = {f"torque_{name}": value for name, value in (values | {"total": 0.02}).items()}
        shares = split_of({**point, **parts, **given}, "seals")
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
    assert declared_by(torque_of_scene(scene, estimate=False)) == words


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
