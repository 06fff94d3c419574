"""The headline of a torque: its words and numbers against those of the result."""

from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from analytic.scenefile.read import load_scene
from fembearing.report.headline import makers_words, torque_headline
from fembearing.report.terminal.torque import print_headline
from fembearing.report.torque import Band, torque_record
from fembearing.verify.torque.scene_torque import SceneTorque, torque_of_scene, with_interval
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


def test_the_lubrication_follows_from_the_share_of_the_asperities(result: SceneTorque) -> None:
    for inner, outer, words in (
        (0.003, 0.006, ": full film"),
        (0.004, 0.2, ": full film to mixed"),
        (0.7, 0.95, ": mixed to boundary"),
    ):
        share = replace(result.friction.asperity_share, inner=np.array([inner]), outer=np.array([outer]))
        lines = lines_of(replace(result, friction=replace(result.friction, asperity_share=share)))
        printed = " ".join(" ".join(lines).split())
        assert f"{words} makers" in printed


def test_a_maker_with_two_constants_is_one_maker(result: SceneTorque) -> None:
    values = {"SKF": (0.031, 0.037), "Palmgren, z = 0.0004": (0.011, None), "Palmgren, z = 0.0006": (0.019, 0.023)}
    band = Band(low=(0.011, 0.023), high=(0.031, 0.037), values=values, note="")
    record = torque_record(result)
    two = replace(record, catalogue_band=band, points=2 * record.points, interval=2 * record.interval)
    assert makers_words(two) == "makers: SKF 31-37, Palmgren 11-23 N mm"


def test_without_an_interval_it_says_so(result: SceneTorque) -> None:
    printed = " ".join(" ".join(lines_of(replace(result, interval=None))).split())
    assert "not known" in printed
    assert "try --interval" in printed
