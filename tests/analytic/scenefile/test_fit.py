"""Parts that do not fit together are named from their limit on, and not before."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.scene import Arrangement, Bearing, ContactAngle, Groove, Surface
from analytic.scenefile import fit
from tests.analytic.specimens import BEARING_6205, FINISH, STAMPED_CAGE
from tests.contacts import PEEK, STEEL

BALL = 7.94e-3  # m
GAP = "the key of the gap"


def bearing(*, inner: dict[str, Any] | None = None, outer: dict[str, Any] | None = None, **changed: Any) -> Bearing:
    """The 6205 with other dimensions; its shoulders are of 3.1 mm half-width."""
    rings = replace(BEARING_6205.inner, **inner or {}), replace(BEARING_6205.outer, **outer or {})
    return replace(BEARING_6205, inner=rings[0], outer=rings[1], **changed)


def keys(misfits: Iterable[tuple[str, str]]) -> list[str]:
    return [key for key, _ in misfits]


def misfits(given: Bearing, *own: str) -> list[str]:
    return keys(fit.bearing_misfits(given, gap_key=GAP, own=own))


def height(half_width: float, groove: float) -> float:
    """Of a shoulder over the bottom of a groove."""
    return groove - np.sqrt(groove**2 - half_width**2)


def washers(**changed: Any) -> Bearing:
    groove = Groove(bottom_radius=19.5e-3, groove_radius=4.2e-3, shoulder_half_width=3.1e-3, material=STEEL)
    known: dict[str, Any] = {"kind": "thrust", "bore_diameter": None, "outside_diameter": None}
    return replace(BEARING_6205, **(known | {"inner": groove, "outer": groove} | changed))


def test_the_specimens_fit() -> None:
    assert misfits(bearing()) == misfits(washers()) == []


@pytest.mark.parametrize("ring", ["inner", "outer"])
def test_grooves_are_wider_than_balls_and_shoulders_within_them(ring: str) -> None:
    loose: dict[str, Any] = {"shoulder_half_width": 2.0e-3}
    assert misfits(bearing(**{ring: loose | {"groove_radius": 3.97e-3}})) == [f"bearing.{ring}.groove_radius"]
    ((_, words),) = fit.bearing_misfits(bearing(**{ring: loose | {"groove_radius": 3.97e-3}}))
    assert words == (
        "must exceed the ball radius 3.97 mm (equal radii are a line contact); usual are 4.0494 mm to 4.2876 mm"
    )
    for key in ("shoulder_half_width", "far_shoulder_half_width"):
        radius = getattr(BEARING_6205, ring).groove_radius
        assert misfits(bearing(**{ring: {key: radius}})) == [f"bearing.{ring}.{key}"]
        assert misfits(bearing(**{ring: {key: 0.77 * radius}})) == []


def test_a_ball_of_ones_own_fits_between_rings_and_neighbours() -> None:
    """13.5 mm between bore and outside diameter; 39.01 sin 20 deg = 13.342 mm to the next ball, if there is one."""
    for size, count, own, fits in (
        (13.35e-3, 9, ("ball_diameter",), False),
        (13.35e-3, 9, (), True),  # that of the catalogue is not judged by it
        (13.35e-3, 9, ("ball_diameter", "ball_count"), True),
        (13.35e-3, 1, ("ball_diameter",), True),
        (13.51e-3, 1, ("ball_diameter",), False),
    ):
        found = misfits(bearing(ball_diameter=size, ball_count=count), *own)
        assert (found == ["bearing.ball_diameter"]) != fits, (size, count, own)
    for unknown in ("bore_diameter", "outside_diameter"):
        large: dict[str, Any] = {unknown: None, "ball_diameter": 13.51e-3, "ball_count": 1}
        assert misfits(bearing(**large), "ball_diameter") != ["bearing.ball_diameter"]
    told = dict(fit.bearing_misfits(bearing(ball_diameter=14e-3), own=("ball_diameter",)))
    assert told["bearing.ball_diameter"] == "does not fit: rings and neighbouring balls leave 13.3422 mm"


def test_the_rings_are_apart_by_a_clearance_that_balls_can_bear() -> None:
    """At least -5 % of the ball, and below 2 (4.13 + 4.21 - 7.94) = 0.8 mm."""
    touching = 15.53e-3 + BALL
    for clearance, fits in ((-0.0499 * BALL, True), (-0.0501 * BALL, False), (0.799e-3, True), (0.801e-3, False)):
        given = bearing(outer={"bottom_radius": touching + clearance / 2, "shoulder_half_width": 1e-3})
        assert (misfits(given) == [GAP]) != fits, clearance
    assert misfits(bearing(outer={"groove_radius": 23.47e-3, "shoulder_half_width": None})) == []
    assert "bearing.outer.groove_radius" in misfits(bearing(outer={"groove_radius": 23.48e-3}))


@pytest.mark.parametrize("far", [False, True])
def test_shoulders_that_face_each_other_leave_a_gap(far: bool) -> None:
    """A near shoulder faces the far one of the other ring. The lands meet where their heights fill the grooves' gap."""
    tall: dict[str, Any] = {"shoulder_half_width": 4.12e-3, "far_shoulder_half_width": 1e-3}
    room = 23.48e-3 - 15.53e-3 - height(4.12e-3, 4.13e-3)  # for the shoulder of the outer ring
    widest = np.sqrt(4.21e-3**2 - (4.21e-3 - room) ** 2)
    for factor, fits in ((0.9999, True), (1.0001, False)):
        own = {"shoulder_half_width": 1e-3, "far_shoulder_half_width": 1e-3}
        own["far_shoulder_half_width" if far else "shoulder_half_width"] = factor * widest
        found = misfits(bearing(inner=tall, outer=own))
        assert (found == ["bearing.inner.shoulder_half_width"]) == (far and not fits)
    for ring in ("inner", "outer"):
        bare = {ring: {"shoulder_half_width": None}, ("outer" if ring == "inner" else "inner"): tall}
        assert misfits(bearing(**bare)) == []


def test_bore_outside_diameter_and_width_enclose_the_grooves() -> None:
    for changed, key, fits in (
        ({"bore_diameter": 31.05e-3}, "bore_diameter", True),
        ({"bore_diameter": 31.06e-3}, "bore_diameter", False),
        ({"outside_diameter": 46.97e-3}, "outside_diameter", True),
        ({"outside_diameter": 46.96e-3}, "outside_diameter", False),
        ({"width": 6.21e-3}, "width", True),
        ({"width": 6.2e-3}, "width", False),
        ({"width": 6.21e-3, "outer": {"far_shoulder_half_width": 3.2e-3}}, "width", False),
    ):
        found = misfits(bearing(**changed))  # pyright: ignore[reportArgumentType]
        assert (found == [f"bearing.{key}"]) != fits, changed
    bare = {"shoulder_half_width": None}
    assert misfits(bearing(inner=bare, outer=bare, width=1e-6)) == []


def test_a_pitch_circle_of_ones_own_is_blamed_where_a_size_is_not() -> None:
    narrow, wide = {"bore_diameter": 31.1e-3}, {"outside_diameter": 46.9e-3}
    for sizes, key in ((narrow, "bore_diameter"), (wide, "outside_diameter")):
        given = bearing(**sizes)  # pyright: ignore[reportArgumentType]
        assert misfits(given, "pitch_diameter") == ["bearing.pitch_diameter"]
        assert misfits(given, "pitch_diameter", key) == misfits(given, key) == misfits(given) == [f"bearing.{key}"]


def test_balls_leave_each_other_room() -> None:
    """d_m sin(pi/Z) of 15 balls is 8.11 mm, and of 16 it is 7.6105 mm."""
    assert misfits(bearing(ball_count=15)) == []
    ((key, words),) = fit.bearing_misfits(bearing(ball_count=16))
    assert key == "bearing.ball_count"
    assert words == "leaves 7.61047 mm from ball to ball, less than ball_diameter 7.94 mm; at most 15 fit"
    assert misfits(bearing(ball_count=1)) == []
    assert fit.pitch_chord(bearing(ball_count=1)) == pytest.approx(0.0, abs=1e-17)


def test_washers_do_not_touch_and_lie_around_their_balls() -> None:
    limit = (7.94e-3 / 2, 4.2e-3)  # height of both shoulders, groove
    half = np.sqrt(limit[1] ** 2 - (limit[1] - limit[0]) ** 2)
    for factor, fits in ((0.9999, True), (1.0001, False)):
        for name in ("shoulder_half_width", "far_shoulder_half_width"):
            groove = replace(washers().inner, **{name: factor * half})
            found = misfits(washers(inner=groove, outer=groove))
            assert (found == ["bearing.inner.shoulder_half_width"]) != fits
    bare = replace(washers().inner, shoulder_half_width=None)
    assert misfits(washers(inner=bare)) == misfits(washers(outer=bare)) == []
    for changed, key, fits in (
        ({"bore_diameter": 38.9e-3}, "bore_diameter", True),
        ({"bore_diameter": 39e-3}, "bore_diameter", False),
        ({"outside_diameter": 39.1e-3}, "outside_diameter", True),
        ({"outside_diameter": 39e-3}, "outside_diameter", False),
    ):
        assert (misfits(washers(**changed)) == [f"bearing.{key}"]) != fits
    close = replace(washers().inner, bottom_radius=3.97e-3)
    assert "bearing.pitch_diameter" in misfits(washers(inner=close, outer=close, ball_count=1))
    apart = replace(washers().inner, bottom_radius=3.98e-3)
    assert misfits(washers(inner=apart, outer=apart, ball_count=1)) == []


def test_an_angle_stays_below_the_lower_shoulder() -> None:
    """asin(3.1/4.21), of the wider groove; with one shoulder alone the other one's."""
    limit = float(np.arcsin(3.1 / 4.21))
    for name in ("value", "free"):
        for angle, fits in ((limit - 1e-6, True), (limit + 1e-6, False)):
            rule = ContactAngle(rule="given" if name == "value" else "solved", **{name: angle})  # pyright: ignore[reportArgumentType]
            assert (keys(fit.angle_misfits(bearing(), rule)) == [f"bearing.contact_angle.{name}"]) != fits
    alone = bearing(outer={"shoulder_half_width": None})
    steep = ContactAngle(rule="given", value=float(np.arcsin(3.1 / 4.13)) - 1e-6)
    assert keys(fit.angle_misfits(alone, steep)) == []
    bare = bearing(inner={"shoulder_half_width": None}, outer={"shoulder_half_width": None})
    assert keys(fit.angle_misfits(bare, ContactAngle(rule="given", value=1.5))) == []


def test_an_offset_presses_as_far_as_elastic_contacts_carry() -> None:
    """5 % of the ball on the diameter beyond the distance of the groove centres, by Pythagoras; less the play."""
    bare = bearing(inner={"shoulder_half_width": None}, outer={"shoulder_half_width": None})
    distance, rule = 0.4e-3, ContactAngle(rule="solved")
    for clearance in (20e-6, -14e-6):
        loose = replace(bare, outer=replace(bare.outer, bottom_radius=15.53e-3 + BALL + clearance / 2))
        across, play = distance - clearance / 2, max(clearance / 2, 0.0)
        pressed = np.sqrt((distance + 0.025 * BALL) ** 2 - across**2)
        limit = 2 * (pressed - np.sqrt(play * (2 * distance - play)))
        for factor, fits in ((0.999, True), (1.001, False)):
            pair = Arrangement(kind="O", offset=factor * limit)
            found = list(fit.arrangement_misfits(loose, rule, pair))
            assert (keys(found) == ["arrangement.offset"]) != fits
        assert found[0][1] == f"must be at most {limit * 1e6:.4g} um: elastic contacts do not carry more"
    assert list(fit.arrangement_misfits(bare, rule, Arrangement(kind="O", preload=9.0))) == []


def test_each_part_of_a_cage_has_its_limit() -> None:
    chord = 39.01e-3 * np.sin(np.pi / 9)
    for changed, overlap, expected in (
        ({}, False, []),
        ({"pocket_diameter": 7.94e-3, "pocket_depth": 3.97e-3}, False, ["cage.pocket"]),
        ({"pocket_depth": 4.071e-3}, False, ["cage.pocket_depth"]),
        ({"pocket_depth": 3.97e-3}, False, ["cage.pocket_depth"]),
        ({"pocket_depth": 3.98e-3}, False, []),
        ({"wall_thickness": 4.07e-3}, False, ["cage.wall_thickness"]),
        ({"wall_thickness": 4.069e-3}, False, []),
        ({"pocket_diameter": chord}, False, ["cage.pocket"]),
        ({"pocket_diameter": chord}, True, []),
        ({"pocket_diameter": chord - 0.89e-3}, False, ["cage.wall_thickness"]),
        ({"pocket_diameter": chord - 0.91e-3}, False, []),
    ):
        cage = replace(STAMPED_CAGE, **changed)  # pyright: ignore[reportArgumentType]
        found = fit.cage_misfits(bearing(), cage, pocket="pocket", pockets_may_overlap=overlap)
        assert keys(found) == expected, changed
    wide = replace(STAMPED_CAGE, pocket_diameter=chord)
    assert keys(fit.cage_misfits(bearing(ball_count=1), wide, pocket="pocket", pockets_may_overlap=False)) == []
    assert [each for each in fit.warnings(bearing(), wide) if "neighbouring pockets overlap" in each]
    assert list(fit.warnings(bearing(), replace(wide, pocket_diameter=0.999 * chord))) == []
    assert list(fit.warnings(bearing(ball_count=1), wide)) == []


def test_a_ball_whose_mass_is_not_that_of_its_size_is_warned_of() -> None:
    solid = 7850 * np.pi / 6 * BALL**3
    for share, is_told in ((0.951, False), (0.949, True), (1.049, False), (1.051, True)):
        assert bool(list(fit.warnings(bearing(ball_mass=share * solid), None))) == is_told


def test_summits_that_yield_need_a_hardness() -> None:
    """Of the softest body; elastic summits never yield, and without oil none carries load."""
    rough, hard = replace(FINISH, gap="truncated", hardness=None), replace(STEEL, hardness=7.8e9)
    steel = bearing(ball_material=hard, inner={"material": hard}, outer={"material": hard})
    soft_ball, soft_cage = replace(steel, ball_material=PEEK), replace(STAMPED_CAGE, material=PEEK)

    def missing(surface: Surface | None, given: Bearing = steel, *, cage: Any = None, oil: bool = True) -> bool:
        return keys(fit.surface_misfits(surface, given, cage, is_lubricated=oil)) == ["surface.hardness"]

    assert not missing(rough)
    assert missing(rough, soft_ball)
    assert missing(rough, replace(steel, inner=replace(steel.inner, material=PEEK)))
    assert missing(rough, replace(steel, outer=replace(steel.outer, material=PEEK)))
    assert missing(rough, cage=soft_cage)
    for harmless in (
        None,
        replace(rough, hardness=3e9),
        replace(rough, gap="elastic"),
        replace(rough, asperities="greenwood_williamson"),
    ):
        assert not missing(harmless, soft_ball, cage=soft_cage)
    assert not missing(rough, soft_ball, oil=False)
