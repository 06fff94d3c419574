"""The parts of the signed pages, each by itself: what stands out, counts of verdicts and inputs, and facts."""

from collections import Counter
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import pytest

from analytic.result import TorqueParts
from analytic.verdicts import NumericalCheck
from fembearing.quantities import METRIC
from fembearing.report.page.sections import bearing as bearing_module
from fembearing.report.page.sections import summary as module
from fembearing.report.report import Report
from fembearing.report.scene_view import OwnLaw, SolvedAngle
from tests.analytic.specimens import present
from tests.report.prediction_rows import content, prediction_of
from tests.report.torque_rows import point, record


def total(value: float) -> TorqueParts:
    return TorqueParts(total=value, race=value, spin=value, conformity=0.0, hysteresis=None)


def test_the_largest_and_the_smallest_total_stand_out_with_their_points() -> None:
    totals = (0.03, 0.05, 0.02)
    series = record(*(point(number, torque=total(each)) for number, each in enumerate(totals)))
    largest, smallest = module._figures(series, METRIC)
    assert (largest.name, largest.value) == ("Largest friction torque", "50.00 N mm")
    assert largest.place.startswith("point 2: 720 N axial")
    assert (smallest.name, smallest.value) == ("Smallest", "20.00 N mm")
    assert smallest.place.startswith("point 3: 740 N axial")
    (alone,) = module._figures(record(point(0, torque=total(0.03))), METRIC)
    assert (alone.name, alone.place) == ("Friction torque", "700 N axial, 600 rpm")
    (same,) = module._figures(record(*(point(number, torque=total(0.03)) for number in range(3))), METRIC)
    assert same.place == "the same at all 3 operating points"


def test_a_total_has_its_interval_and_its_power() -> None:
    """0.03 N m at 600 rpm are 1.88 W; samples come before an estimate."""
    one = record(point(0, torque=total(0.03)))
    assert module._figure("", one, 0, METRIC).spread == "95 % interval not known; 1.88 W"
    backwards = record(point(0, torque=total(0.03), inner_speed=-point(0).inner_speed))
    assert module._figure("", backwards, 0, METRIC).spread.endswith("; 1.88 W")
    known = replace(one, interval=((0.02, 0.05),))
    assert module._figure("", known, 0, METRIC).spread == "95 % interval 20-50 N mm; 1.88 W"
    slow, _ = prediction_of(content()).points
    sampled = replace(known, prediction=replace(prediction_of(content()), points=(slow,)))
    assert module._figure("", sampled, 0, METRIC).spread == "95 % interval 12.6-39.9 N mm; 1.88 W"


def test_inputs_are_counted_and_at_most_eight_assumed_ones_named() -> None:
    def inputs(assumed: int) -> Any:
        given = [SimpleNamespace(key="bearing.ball_count", status="given")] * 2
        return given + [SimpleNamespace(key=f"bearing.part_{number}", status="assumed") for number in range(assumed)]

    assert module._status_of(inputs(0)) == "2 inputs: 2 given."
    assert module._status_of(inputs(1)) == "3 inputs: 2 given, 1 assumed. Assumed: part 0."
    assert module._status_of(inputs(8)).endswith("part 6, part 7.")
    assert module._status_of(inputs(10)).endswith("part 6, part 7 and 2 more.")


def test_words_are_as_long_as_a_fact_may_be() -> None:
    longest = "x" * module.LONGEST
    assert module._shortened(longest) == longest
    assert module._shortened(longest + "y") == f"{longest} ..."


def test_verdicts_are_counted_and_the_solver_error_is_told_or_why_it_is_not_known() -> None:
    assert module._counted(Counter(["pass", "fail", "pass"])) == "2 pass, 1 fail"
    lost = NumericalCheck(verdict="not reached", uncertainty=None, tolerance=0.04, reason="the cage came apart")
    assert module._numerical(lost) == "The uncertainty of the torque is not known: the cage came apart."
    solved = NumericalCheck(verdict="pass", uncertainty=0.013, tolerance=0.04, reason="")
    assert module._numerical(solved) == "Solver error of the torque at most 1.3 %, tolerance 4 %."


def test_a_box_is_there_for_each_kind_of_verdict(document: Report) -> None:
    kinds = [box.kind for box in module._boxes(document)]
    assert kinds == ["Comparison", "Numerical", "Physical"]
    without = replace(document, torque=None, torque_change=None, film_change=None)
    assert [box.kind for box in module._boxes(without)] == ["Comparison", "Physical"]


def test_the_contacts_belong_to_the_heaviest_ball_of_one_bearing_or_of_each(document: Report) -> None:
    torque = present(document.torque)
    assert module._contacts_at(document).startswith("Races: the heaviest ball, at point 3: ")
    assert module.OTHER_LOADS not in module._contacts_at(document)
    fitted = replace(present(document.torque_change), finite_geometry=None)
    assert module._contacts_at(replace(document, torque_change=fitted)).endswith(module.OTHER_LOADS)
    pair: Any = SimpleNamespace(kind="O")
    assert "of each bearing" in module._contacts_at(replace(document, torque=replace(torque, pair=pair)))
    without = replace(document, torque=None, torque_change=None, film_change=None)
    assert module._contacts_at(without) == "Races: the heaviest ball of all operating points."


def test_facts_have_the_play_of_the_rings_and_the_unloaded_angle(document: Report) -> None:
    scene = document.scene
    bearing = scene.bearing
    facts = dict(bearing_module._facts(scene, METRIC))
    gap = 2e6 * (bearing.outer.bottom_radius - bearing.inner.bottom_radius - bearing.ball_diameter)
    pitch = 1e3 * (bearing.inner.bottom_radius + bearing.outer.bottom_radius)
    assert f"pitch diameter {pitch:.5g} mm, diametral clearance {gap:.3g} um" in facts["bearing"]
    washers = replace(scene, bearing=replace(bearing, kind="thrust"), cage=None)
    assert "clearance" not in dict(bearing_module._facts(washers, METRIC))["bearing"]
    assert dict(bearing_module._facts(washers, METRIC))["cage"].startswith("none in the scene")
    for free, words in ((None, "unloaded: that of the clearance"), (0.31, "unloaded: 17.76 deg")):
        solved = replace(scene, contact_angle=SolvedAngle(rule="solved", free=free))
        assert words in dict(bearing_module._facts(solved, METRIC))["contact angle"]


@pytest.mark.parametrize(
    ("law", "words"),
    [
        ("eyring_sinh", ""),
        (
            OwnLaw(name="mine", sha256="0123456789abcdef", distribution="", version=""),
            ", own law of traction mine, SHA",
        ),
        (
            OwnLaw(name="mine", sha256="0123456789abcdef", distribution="own-laws", version="1.2"),
            ", own law of traction mine of own-laws 1.2, SHA-256 0123456789ab",
        ),
    ],
)
def test_an_own_law_of_traction_is_named_with_its_package(law: Any, words: str) -> None:
    found = bearing_module._own_law(law)
    assert found.startswith(words)
    assert bool(found) == bool(words)


def test_a_groove_has_its_conformity_and_both_shoulders(document: Report) -> None:
    groove, ball = document.scene.bearing.inner, document.scene.bearing.ball_diameter
    words = bearing_module._groove(groove, ball, METRIC)
    assert f"conformity {groove.groove_radius / ball:.4f}" in words
    unlike = replace(groove, shoulder_half_width=None, far_shoulder_half_width=2.2e-3)
    assert "shoulders not known from the middle, the far one 2.2 mm" in bearing_module._groove(unlike, ball, METRIC)


def test_loads_that_are_0_are_no_words_where_there_is_no_torque(document: Report) -> None:
    scene = document.scene
    for operation, words in (
        ({"radial_load": 0.0, "moment": 0.0}, "axial load 700, 900 N, inner speed 300 rpm"),
        ({"radial_load": 130.0, "moment": -0.0}, "axial load 700, 900 N, radial load 130 N, inner speed 300 rpm"),
    ):
        given = replace(scene.operation, axial_load=(700.0, 900.0), inner_speed=(31.41592653589793,) * 2, **operation)
        assert bearing_module._operation(replace(scene, operation=given), METRIC) == words
