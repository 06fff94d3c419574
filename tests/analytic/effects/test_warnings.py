"""Warnings of a torque: of balls that carry enough to matter, and of no others."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects.ledger import Ledger
from analytic.effects.warnings import _film, torque_warnings
from analytic.scene import Bearing, Clearances, Losses, Scene, ShearedPockets
from analytic.solve.records import BALL, POINT
from analytic.solve.solution import Solution
from analytic.surface.roughness import GapRoughness
from tests.analytic.specimens import FINISH, OIL, STAMPED_CAGE, dry

LOAD = np.array([[310.0, 325.0], [2.9, 3.4]])  # N: the second ball carries 0.94 % inside and 1.05 % outside


@pytest.mark.parametrize(
    ("name", "words"), [("film_capped", "limited to the space"), ("film_extrapolated", "extrapolated")]
)
def test_the_film_of_a_ball_that_hardly_carries_is_not_warned_of(name: str, words: str) -> None:
    balls = np.zeros((1, 2), BALL)
    balls["load"], balls[name][0, 1] = LOAD, True
    assert list(_film(balls, 0)) == []
    (line,) = _film(balls, 1)
    assert words in line
    assert "outer race" in line


@pytest.mark.parametrize(("rolling", "transverse", "words"), [(0.3, 0.1, "not known"), (0.1, 1.7, "-8 to +1 %")])
def test_an_extrapolated_film_says_by_how_much(rolling: float, transverse: float, words: str) -> None:
    balls = np.zeros((1, 2), BALL)
    balls["load"], balls["film_extrapolated"] = LOAD, True
    balls["semi_axis_rolling"], balls["semi_axis_transverse"] = 1e-3 * rolling, 1e-3 * transverse
    assert all(words in line for race in range(2) for line in _film(balls, race))


def test_what_the_total_lacks_comes_before_how_it_was_read(complete: Scene) -> None:
    scene = replace(complete, cage=None, warnings=("of the file",))
    limit, lacking, read = told(scene)
    assert "without the cage" in lacking
    assert (limit, read) == ("a limit", "of the file")


def told(scene: Scene, *, rolling: bool = False, starvation: bool = True, **points: Any) -> list[str]:
    """The warnings of a torque in which nothing was found but these fields of a point."""
    ledger = Ledger(scene, 1)
    for name, on in (("rolling", rolling), ("starvation", starvation)):
        ledger.settle(name, on=on, reason="of the test")
    found = Solution(points=np.zeros(1, POINT), balls=np.zeros((1, 1), BALL))
    for name, value in points.items():
        found.points[name] = value
    return torque_warnings(ledger, found, roughness=None, limits=("a limit",))


@pytest.fixture(scope="module")
def complete(bearing_6205: Bearing) -> Scene:
    """A scene that needs no warning."""
    scene = replace(dry(bearing_6205), cage=STAMPED_CAGE, lubricant=OIL, surface=FINISH, friction_coefficient=None)
    return replace(scene, effects={})


def test_a_complete_scene_has_no_warning_of_its_own(complete: Scene) -> None:
    assert told(complete) == ["a limit"]
    assert told(replace(complete, warnings=("of the file",))) == ["a limit", "of the file"]


SEALS: dict[str, Any] = {"seals": "2RS1", "seals_rub": True}
GREASED = replace(OIL, supply="grease")


def tightened(operating: float) -> Clearances:
    return Clearances(
        unmounted=12e-6, mounted=3e-6, operating=operating, shaft_interference=9e-6, housing_interference=0.0,
        shaft_pressure=1e6, housing_pressure=0.0, ball_load=17.3,
    )  # fmt: skip


@pytest.mark.parametrize(
    ("changed", "bearing", "words"),
    [
        ({"friction_coefficient": 0.07}, {}, "the friction coefficient 0.07 is from the scene"),
        ({"microslip": "as_printed"}, {}, '"as_printed" is no model'),
        ({"cage": None}, {}, "the total is without the cage"),
        ({"cage": None, "effects": {"cage": "off"}}, {}, None),
        ({"cage": None, "losses": Losses(pockets=ShearedPockets(clearance=2e-4, thickness=3e-3))}, {}, None),
        ({"lubricant": None}, {}, "without the hydrodynamic rolling resistance"),
        ({"lubricant": None, "effects": {"rolling": "off"}}, {}, None),
        ({}, SEALS, "without the drag of the seals (2RS1)"),
        ({"losses": Losses(seals=0.0)}, SEALS, None),
        ({}, {**SEALS, "seals_rub": False}, None),
        ({"clearances": tightened(-4e-6)}, {}, "12 um unmounted, 3 um mounted, an interference of 4 um"),
        ({"clearances": tightened(0.0)}, {}, None),
        ({"lubricant": GREASED}, {}, None),  # 39 mm, as measured
    ],
)
def test_each_gap_of_a_scene_is_warned_of(
    complete: Scene, changed: dict[str, Any], bearing: dict[str, Any], words: str | None
) -> None:
    scene = replace(complete, bearing=replace(complete.bearing, **bearing), **changed)
    limit, *found = told(scene)
    assert limit == "a limit"
    assert len(found) == (words is not None), found
    assert words is None or words in found[0]


@pytest.mark.parametrize(("pitch", "is_told"), [(32.9e-3, True), (33.1e-3, False), (65.9e-3, False), (66.1e-3, True)])
def test_films_with_grease_are_extrapolated_beyond_the_measured_sizes(
    complete: Scene, pitch: float, is_told: bool
) -> None:
    """6204 to 6209: 33 to 66 mm of pitch diameter."""
    wider = (pitch - complete.bearing.pitch_diameter) / 2
    inner, outer = (
        replace(groove, bottom_radius=groove.bottom_radius + wider)
        for groove in (complete.bearing.inner, complete.bearing.outer)
    )
    scene = replace(complete, bearing=replace(complete.bearing, inner=inner, outer=outer), lubricant=GREASED)
    assert any("films with grease are extrapolated" in warning for warning in told(scene)) == is_told
    assert not any("films with grease" in warning for warning in told(scene, starvation=False))
    assert not any("films with grease" in warning for warning in told(replace(scene, lubricant=OIL)))


def test_extrapolated_rolling_is_told_of_its_race_where_it_counts(complete: Scene) -> None:
    for race, words in ((0, "rolling on the inner race"), (1, "rolling on the outer race")):
        beyond = np.arange(2) == race
        found = told(complete, rolling=True, rolling_extrapolated=beyond)
        assert [words in each for each in found] == [False, True]
        assert told(complete, rolling=False, rolling_extrapolated=beyond) == ["a limit"]


def test_what_is_neglected_is_told_from_the_tolerance_on(complete: Scene) -> None:
    """Unless it counts, and in a thrust bearing but for what the uncertainty has."""
    for name, on, share, kind, is_told in (
        ("centrifugal", False, 0.051, "radial", True),
        ("centrifugal", False, 0.049, "radial", False),
        ("centrifugal", True, 0.051, "radial", False),
        ("centrifugal", False, 0.051, "thrust", False),
        ("hysteresis", False, 0.051, "thrust", True),
    ):
        scene = replace(complete, bearing=replace(complete.bearing, kind=kind), tolerance=0.05)  # pyright: ignore[reportArgumentType]
        ledger = Ledger(scene, 1)
        for other in ("rolling", "starvation"):
            ledger.settle(other, on=False, reason="of the test")
        ledger.settle(name, on=on, share=share, reason="for a reason")
        found = Solution(points=np.zeros(1, POINT), balls=np.zeros((1, 1), BALL))
        warnings = torque_warnings(ledger, found, roughness=None, limits=())
        told_ = f"{name} is neglected, up to 5.1 % of the torque, tolerance 5 %: for a reason"
        assert (told_ in warnings) == is_told, (name, on, share, kind)


def test_films_are_warned_of_where_a_roughness_shares_their_load(complete: Scene) -> None:
    ledger = Ledger(complete, 1)
    for name in ("rolling", "starvation"):
        ledger.settle(name, on=False, reason="of the test")
    found = Solution(points=np.zeros(1, POINT), balls=np.zeros((1, 1), BALL))
    found.balls["load"], found.balls["film_capped"] = 5.0, [0, 1]
    fields = dict.fromkeys(GapRoughness.__dataclass_fields__, 1e-7)
    rough = GapRoughness(**fields | {"warnings": ("of the surface",)})  # pyright: ignore[reportArgumentType]
    warnings = torque_warnings(ledger, found, roughness=rough, limits=())
    assert warnings[0] == "of the surface"
    assert "the film on the outer race is limited" in warnings[1]
    assert len(warnings) == 2
