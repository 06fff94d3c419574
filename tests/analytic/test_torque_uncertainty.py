"""What of a torque is not known, and in which words: each part by itself, with the others at rest."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic import torque
from analytic.cage.drive import SQUEEZE_SPREAD
from analytic.effects.ledger import Ledger
from analytic.effects.trial import OF_FREE_BALLS, OF_METHODS
from analytic.races import WEDGED
from analytic.scene import Array, ContactAngle, Operation, Scene
from analytic.solve.freely import BETWEEN
from analytic.solve.solution import Solution
from analytic.torque import NO_EDGE, NO_SOLUTION, SQUEEZED_BY_WEIGHT, InAnyDirection, Unsure
from tests.analytic.solve.test_solution import forged
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, STAMPED_CAGE, present, thrust
from tests.refusals import refused

SCENE = Scene(
    bearing=BEARING_6205,
    contact_angle=ContactAngle(rule="solved", free=0.26),
    operation=Operation(
        axial_load=np.array([310.0, 470.0, 890.0]),
        inner_speed=np.array([31.0, 47.0, 300.0]),
        radial_load=np.array([60.0, 95.0, 40.0]),
    ),
    lubricant=OIL,
    surface=FINISH,
)
TOTAL = np.array([4.0, 5.0, 8.0])
RACE = np.array([2.0, 4.0, 5.0])  # of the total
NOTHING = InAnyDirection(*np.zeros((3, 3)))

TRIAL = SimpleNamespace(
    is_of_all=True,
    points=np.zeros((3, 5)),
    tried=np.arange(3),
    model=SimpleNamespace(numbers=SimpleNamespace(arm=0.02)),
)


def races_of(**changed: Any) -> Any:
    """Races whose torque is known exactly, and which no weight moves."""
    known: dict[str, Any] = {
        "scene": SCENE,
        "total": RACE,
        "found": forged(spin=1.0, conformity=0.5),
        "parts": {},
        "error": np.zeros(3),
        "method": "along_axis",
        "computed": 3,
        "other": np.full(3, np.nan),
        "brink": np.zeros(3),
        "beyond_fit": False,
        "is_wedged": False,
        "is_free": False,
        "slides": True,
        "growth": 1.0,
        "any_direction": np.zeros(3, dtype=bool),
        "trial": TRIAL,
        "change_at_edge": lambda: np.zeros(3),
    }
    return SimpleNamespace(**(known | changed))


def ledger_of(scene: Scene = SCENE, left_out: float = 0.0) -> Ledger:
    ledger = Ledger(scene, 3)
    ledger.left_out = np.full(3, left_out)
    return ledger


def unsure_of(races: Any, weight: InAnyDirection = NOTHING, left_out: float = 0.0) -> Unsure:
    return torque._unsure(ledger_of(left_out=left_out), races, TOTAL, weight)


def test_a_torque_without_any_doubt_is_certain() -> None:
    found = unsure_of(races_of())
    np.testing.assert_array_equal(found.share, np.zeros(3))
    assert found.unknown == ()


def test_doubts_about_the_races_are_shares_of_the_total() -> None:
    np.testing.assert_allclose(unsure_of(races_of(), left_out=0.02).share, 0.02 * RACE / TOTAL, rtol=1e-14)
    sliding = unsure_of(races_of(error=np.full(3, 0.03)))
    np.testing.assert_allclose(sliding.share, 0.03 * 1.5 / TOTAL, rtol=1e-14)
    edge = unsure_of(races_of(change_at_edge=lambda: np.array([0.1, 0.0, 0.4])))
    np.testing.assert_allclose(edge.share, [0.025, 0.0, 0.05], rtol=1e-14)
    tilted = unsure_of(races_of(), NOTHING._replace(share=np.array([0.01, 0.0, 0.02])))
    np.testing.assert_array_equal(tilted.share, [0.01, 0.0, 0.02])


def test_contacts_outside_the_fit_and_held_balls_add_their_shares(monkeypatch: pytest.MonkeyPatch) -> None:
    far = by_rule(np.full(3, 1.0), np.array([1.4, 1.0, 1.8]))
    outside = races_of(beyond_fit=True, by_rule=far)
    np.testing.assert_allclose(unsure_of(outside).share, np.array([0.4, 0.0, 0.8]) / TOTAL, rtol=1e-12)
    monkeypatch.setattr(torque, "held_in_the_middle", lambda *_, **__: np.array([0.01, 0.0, 0.02]))
    held = unsure_of(outside, NOTHING._replace(share=np.full(3, 0.05)))
    expected = np.array([0.4, 0.0, 0.8]) / TOTAL + 0.05 + np.array([0.01, 0.0, 0.02])
    np.testing.assert_allclose(held.share, expected, rtol=1e-12)


def test_doubts_add_up_and_grow_at_the_brink() -> None:
    """But for another steady state, which is not nearer there."""
    brink, apart = np.array([0.0, 3.0, 1.0]), np.array([0.2, 0.3, np.nan])
    found = unsure_of(
        races_of(
            error=np.full(3, 0.03), brink=brink, other=RACE + apart, change_at_edge=lambda: np.array([0.1, 0.0, 0.4])
        ),
        NOTHING._replace(share=np.array([0.01, 0.0, 0.02])),
        left_out=0.02,
    )
    once = 0.02 * RACE / TOTAL + 0.03 * 1.5 / TOTAL + np.array([0.01, 0.0, 0.02]) + np.array([0.1, 0.0, 0.4]) / TOTAL
    np.testing.assert_allclose(found.share, once * (1 + brink) + [0.05, 0.06, 0.0], rtol=1e-14)


def test_of_a_long_series_one_point_in_two_states_makes_all_unsure() -> None:
    other = np.array([2.3, np.nan, 4.6])
    alone = unsure_of(races_of(other=other)).share
    np.testing.assert_allclose(alone, [0.3 / 4, 0.0, 0.4 / 8], rtol=1e-14)
    long = SimpleNamespace(is_of_all=False, points=np.zeros((3, 5)), tried=np.arange(2))
    np.testing.assert_allclose(unsure_of(races_of(other=other, trial=long)).share, 0.4 / TOTAL, rtol=1e-14)


def test_what_is_not_known_is_infinite_and_has_its_reason() -> None:
    lost = np.array([0.0, np.inf, 0.0])
    for races, weight, words in (
        (races_of(is_wedged=True), NOTHING, WEDGED),
        (races_of(change_at_edge=lambda: lost), NOTHING, NO_EDGE),
        (races_of(), NOTHING._replace(share=lost), NO_SOLUTION),
        (races_of(error=lost), NOTHING, "no estimate of the error of sliding by the method along_axis is known"),
    ):
        found = unsure_of(races, weight)
        assert found.unknown == (words,)
        assert np.isposinf(found.share[1])
        assert np.isposinf(found.share).all() == (words == WEDGED)


def by_rule(own: Array, far: Array) -> Any:
    def solve(at: NDArray[np.intp], *, farthest: bool = False) -> Solution:
        return forged(len(at), rolling=far if farthest else own)

    return solve


def test_contacts_outside_the_fit_change_the_torque_up_to_their_far_end() -> None:
    own, far = np.array([1.0, 2.0, 3.0]), np.array([1.3, 1.8, 3.0])
    inside = torque._beyond_the_fit(races_of(by_rule=by_rule(own, far)), TOTAL)
    np.testing.assert_array_equal(inside.share, np.zeros(3))
    outside = torque._beyond_the_fit(races_of(beyond_fit=True, by_rule=by_rule(own, far)), TOTAL)
    np.testing.assert_allclose(outside.share, [0.3 / 4, 0.2 / 5, 0.0], rtol=1e-14)
    assert outside.unknown == ()
    lost = torque._beyond_the_fit(races_of(beyond_fit=True, by_rule=by_rule(own, np.array([1.3, np.nan, 3.0]))), TOTAL)
    np.testing.assert_allclose(lost.share, [0.3 / 4, np.inf, 0.0], rtol=1e-14)
    assert len(lost.unknown) == 1


# A weight in an unknown direction


def with_weight(spin: dict[tuple[float, ...], float], **fields: Any) -> Any:
    """Balls by rule that lose 2 without weight, and otherwise in some directions."""

    def solve(at: NDArray[np.intp], down: tuple[float, float, float] | None) -> Solution:
        found = forged(len(at), spin=2.0 + spin.get(down or (), 0.0), conformity=2.0 - spin.get(down or (), 0.0))
        found.points["ball_rate"] = 3.0
        if down is not None:
            for name, values in fields.items():
                found.points[name] = values.get(down, 3.0 if name == "ball_rate" else 0.0)
        return found

    return solve


OPEN = np.array([True, False, True])
X, Y, Z = (1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0)
RULED = replace(SCENE, spin_rule="balanced")


def test_the_worst_direction_counts_by_all_parts() -> None:
    """Parts that cancel in a sum add up, with balls that come off; only where nobody knows the direction."""
    spin = {X: 0.1, Y: -0.3, Z: 0.2}
    races = races_of(scene=RULED, any_direction=OPEN, with_weight=with_weight(spin, coming_off={Y: 0.05, Z: 0.01}))
    found = torque._in_any_direction(races, TOTAL)
    change = OF_METHODS * (2 * 0.3 + 0.05) / 4
    np.testing.assert_allclose(found.share, change * OPEN * RACE / TOTAL, rtol=1e-12)
    np.testing.assert_array_equal(found.ball_lead, np.zeros(3))
    known = torque._in_any_direction(races_of(), TOTAL)
    assert not np.any(known.share)


def test_rate_and_lead_are_those_of_the_farthest_direction() -> None:
    races = races_of(
        scene=RULED,
        any_direction=OPEN,
        with_weight=with_weight({}, ball_rate={X: 3.3, Z: 2.4}, ball_lead={X: 2e-6, Y: -7e-6}),
    )
    found = torque._in_any_direction(races, TOTAL)
    np.testing.assert_allclose(found.cage_rate, OF_METHODS * 0.2 * OPEN, rtol=1e-12)
    np.testing.assert_allclose(found.ball_lead, 7e-6 * OPEN, rtol=1e-12)


def test_a_direction_without_a_solution_leaves_the_torque_open() -> None:
    races = races_of(scene=RULED, any_direction=OPEN, with_weight=with_weight({Y: np.nan}))
    np.testing.assert_array_equal(torque._in_any_direction(races, TOTAL).share, np.where(OPEN, np.inf, 0.0))


def test_balls_by_rule_that_stand_for_free_ones_slip_too(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(torque, "slip_by_weight", lambda *_: np.array([0.01, 0.02, 0.03]))
    solve = with_weight({X: 0.1})
    change = 0.2 / 4
    for scene, slides, factor, slip in (
        (SCENE, True, OF_FREE_BALLS, np.array([0.01, 0.02, 0.03])),
        (SCENE, False, OF_FREE_BALLS, np.zeros(3)),
        (RULED, True, OF_METHODS, np.zeros(3)),
    ):
        races = races_of(scene=scene, slides=slides, any_direction=OPEN, with_weight=solve)
        found = torque._in_any_direction(races, TOTAL).share
        np.testing.assert_allclose(found, (factor * change + slip) * OPEN * RACE / TOTAL, rtol=1e-12)


def freely(asked: list[Any], sizes: Any) -> Any:
    """Free balls that lose 2 without weight, and otherwise by direction: torque, rate, more off, lead."""

    def solve(at: NDArray[np.intp], down: tuple[float, float, float] | None) -> Solution:
        asked.append((len(at), down))
        spin, rate, off, lead = (2.0, 3.0, 0.0, 0.0) if down is None else sizes(np.array(down))
        return forged(len(at), spin=spin, ball_rate=rate, coming_off=off, ball_lead=lead)

    return solve


def free_races(sizes: Any, asked: list[Any] | None = None, **changed: Any) -> Any:
    solve = freely([] if asked is None else asked, sizes)
    return races_of(is_free=True, freely_with_weight=solve, with_weight=with_weight({X: 0.1}), **changed)


def change_of(sizes: Any, *, asked: list[Any] | None = None, rule: float = 0.05, **changed: Any) -> Any:
    at = np.array([0, 2])
    return torque._change_of_free_balls(free_races(sizes, asked, **changed), at, np.full(2, rule), np.full(2, 1e-6))


def test_free_balls_that_no_direction_changes_are_certain() -> None:
    share, rate, lead = change_of(lambda _: (2.0, 3.0, 0.0, -4e-6))
    np.testing.assert_allclose([share, rate], 0.0, atol=1e-15)
    np.testing.assert_allclose(lead, 4e-6, rtol=1e-12)


def test_directions_lie_along_the_axes_or_close_together_where_friction_wedges_balls() -> None:
    """Of thrust only the tilt against the axis counts."""
    same = lambda _: (2.0, 3.0, 0.0, 0.0)  # noqa: E731 - of each of these calls
    upright = replace(SCENE, operation=thrust(310.0, 470.0, 890.0))
    for scene, growth, rule, count in (
        (SCENE, 1.0, 0.05, 6),
        (SCENE, 2.0, 0.05, 6),
        (SCENE, 2.001, 0.05, 26),
        (SCENE, 1.0, np.inf, 26),
        (upright, 1.0, 0.05, 5),
        (upright, 2.001, 0.05, 25),
    ):
        asked: list[Any] = []
        change_of(same, asked=asked, rule=rule, scene=scene, growth=growth)
        downs = np.array([down for _, down in asked if down is not None])
        assert len(downs) == count
        np.testing.assert_allclose(np.linalg.norm(downs, axis=1), 1.0, rtol=1e-12)


def test_between_directions_lies_at_most_their_difference_beyond_the_farthest() -> None:
    """Six directions along the axes: neighbours are those at right angles."""
    base = np.exp(0.1)

    def one_way(down: Array) -> tuple[float, float, float, float]:
        return (2.0 * base if down[0] > 0.5 else 2.0, 3.0, 0.0, 0.0)

    share, rate, _ = change_of(one_way)
    np.testing.assert_allclose(share, np.exp(0.1 + 0.1) - 1, rtol=1e-12)
    np.testing.assert_allclose(rate, 0.0, atol=1e-12)

    def opposite(down: Array) -> tuple[float, float, float, float]:
        return (2.0, 3.0 * np.exp(0.1 * down[0]), 0.0, 0.0)  # neighbours differ by half of what the ends do

    np.testing.assert_allclose(change_of(opposite)[1], np.exp(0.1 + 0.1) - 1, rtol=1e-12)

    def coming_off(down: Array) -> tuple[float, float, float, float]:
        return (2.0, 3.0, 0.2 * (down[1] > 0.5), 0.0)

    np.testing.assert_allclose(change_of(coming_off)[0], 1.1 - 1, rtol=1e-12)


def test_directions_that_change_alike_leave_nothing_between_them() -> None:
    share, rate, lead = change_of(lambda down: (2.0 * np.exp(0.1), 3.0 * np.exp(-0.2), 0.0, -5e-6 * (down[0] > 0.5)))
    np.testing.assert_allclose(share, np.expm1(0.1), rtol=1e-12)
    np.testing.assert_allclose(rate, np.expm1(0.2), rtol=1e-12)
    np.testing.assert_allclose(lead, 5e-6, rtol=1e-12)  # of the farthest


def test_free_balls_that_do_not_settle_in_a_direction_have_no_bound() -> None:
    share, _, _ = change_of(lambda down: (np.nan if down[2] > 0.3 else 2.0, 3.0, 0.0, 0.0))
    assert np.isposinf(share).all()


def test_free_balls_without_a_torque_have_no_bound() -> None:
    """In one direction, or without weight."""
    lost = free_races(lambda down: (0.0 if down[2] > 0.3 else 2.0, 3.0, 0.0, 0.0))
    still = free_races(lambda _: (2.0, 3.0, 0.0, 0.0))
    still.freely_with_weight = lambda at, _: forged(len(at), ball_rate=3.0)
    for races in (lost, still):
        found = torque._change_of_free_balls(races, np.array([0, 2]), np.full(2, 0.05), np.full(2, 1e-6))
        assert np.isposinf(found[0]).all()


def test_a_direction_that_does_not_settle_is_tried_a_little_aside() -> None:
    """By 0.03 to 0.1 rad; those that settle stay."""
    asked: list[Any] = []

    def sizes(down: Array) -> tuple[float, float, float, float]:
        exact = np.any(np.abs(down) > 1 - 1e-12)
        return (np.nan if exact and down[0] > 0.5 else 2.2, 3.0, 0.0, 0.0)

    races = free_races(sizes, asked)
    found = torque._with_weight_along(races, np.array([0, 2]), np.array(X))
    np.testing.assert_allclose(found[0], 2.2, rtol=1e-12)
    turned = np.arccos(np.array(asked[1][1])[0])
    assert 0.03 < turned < 0.11
    assert np.linalg.norm(asked[1][1]) == pytest.approx(1.0, rel=1e-12)
    asked.clear()
    torque._with_weight_along(races, np.array([0, 2]), np.array(Y))
    assert len(asked) == 1


def test_far_points_tell_how_much_more_free_balls_change_than_those_by_rule(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Of a series of many points; between them it is larger."""
    count = 40
    points = np.zeros((count, 5))
    points[:, 0], points[:, 3] = 300.0 + np.arange(count), 50.0
    at, far = np.arange(count), np.array([3, 30])
    monkeypatch.setattr(torque, "tried_points", lambda *_: far)
    trial = SimpleNamespace(points=points, is_of_all=False, model=SimpleNamespace(numbers=SimpleNamespace(arm=0.02)))
    races = free_races(
        lambda down: (2.2 if down[0] > 0.5 else 2.0, 3.0 + 0.3 * (down[0] > 0.5), 0.0, 5e-6 * (down[1] > 0.5)),
        trial=trial,
    )
    rule, lead = np.linspace(0.04, 0.05, count), np.linspace(1e-6, 2e-6, count)
    share, rates, leads = torque._change_of_free_balls(races, at, rule, lead)
    own = 1.1**2 - 1
    expected = BETWEEN * (own / rule[far].min()) * rule
    expected[far] = own
    np.testing.assert_allclose(share, expected, rtol=1e-12)
    np.testing.assert_allclose(rates, BETWEEN * own, rtol=1e-12)
    farther = BETWEEN * (5e-6 / lead[far].min()) * lead
    farther[far] = 5e-6
    np.testing.assert_allclose(leads, farther, rtol=1e-12)
    nothing = rule.copy()
    nothing[far[1]] = 0.0  # of which no factor follows
    assert np.isposinf(torque._change_of_free_balls(races, at, nothing, lead)[0]).all()


@pytest.mark.parametrize("count", [32, 33])
def test_each_point_of_a_short_series_is_turned_in_every_direction(monkeypatch: pytest.MonkeyPatch, count: int) -> None:
    monkeypatch.setattr(torque, "tried_points", lambda *_: np.array([1, 4]))
    trial = SimpleNamespace(
        points=np.zeros((count, 5)), is_of_all=False, model=SimpleNamespace(numbers=SimpleNamespace(arm=0.02))
    )
    asked: list[Any] = []
    races = free_races(lambda _: (2.0, 3.0, 0.0, 0.0), asked, trial=trial)
    torque._change_of_free_balls(races, np.arange(count), np.full(count, 0.05), np.full(count, 1e-6))
    assert {points for points, _ in asked} == {count if count <= 32 else 2}


@pytest.mark.parametrize(("gravity", "flank"), [("across", 1.0), ("along", np.sin(0.31)), ("off", 1.0)])
def test_a_cage_with_an_upright_axis_rests_on_flanks_of_its_pockets(gravity: Any, flank: float) -> None:
    scene = replace(SCENE, cage=replace(STAMPED_CAGE, gravity=gravity))
    found = forged(ball_rate=3.0, contact_angle=0.31)
    np.testing.assert_allclose(torque._rate_at_cage(races_of(scene=scene), found), 3.0 * flank, rtol=1e-14)
    np.testing.assert_allclose(torque._rate_at_cage(races_of(), found), 3.0, rtol=1e-14)


# The cage


def cage_of(**changed: Any) -> Any:
    known = {
        "torque": np.full(3, 2.0),
        "half_interval": np.array([0.1, 0.2, 0.3]),
        "unsure": np.array([0.01, 0.02, 0.03]),
        "unknown": ("so",),
        "warnings": ("cage",),
    }
    return SimpleNamespace(**(known | changed))


def drive_of(lead: float, room: float = 1e-4) -> Any:
    return SimpleNamespace(
        spread_by_axis=0.05, room=room, grip=SimpleNamespace(ball_lead=np.full(3, lead)), leading=lambda far: far
    )


OWN_LEAD = np.array([0.5e-4, 0.6e-4, 4e-4])  # of the balls that drive the cage, m


def of_cage(races: Any, drive: Any, weight: InAnyDirection = NOTHING, **more: Any) -> Any:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(torque, "squeezed_torque", lambda _, at: 0.5 * (at if isinstance(at, np.ndarray) else OWN_LEAD))
        patch.setattr(torque, "may_squeeze", lambda *_: ("squeezes",))
        patch.setattr(torque, "_farthest_lead", lambda *_: more.get("farthest", np.zeros(3)))
        return torque._unsure_of_cage(cage_of(), drive, races, weight)


def test_a_cage_adds_its_own_doubts() -> None:
    """How balls turn by rule counts where friction would turn them otherwise."""
    own = np.array([0.11, 0.22, 0.33])
    for races, by_axis in ((races_of(), 0.1), (races_of(is_free=True), 0.0), (races_of(scene=RULED), 0.0)):
        unsure, unknown, warnings = of_cage(races, drive_of(0.0))
        np.testing.assert_allclose(unsure, own + by_axis, rtol=1e-14)
        assert (unknown, warnings) == (("so",), ("cage", "squeezes"))
    turned = of_cage(races_of(is_free=True), drive_of(0.0), NOTHING._replace(cage_rate=np.array([0.0, 0.1, 0.2])))
    np.testing.assert_allclose(turned[0], own + np.array([0.0, 0.2, 0.4]), rtol=1e-14)
    for cage, drive in ((None, None), (None, drive_of(0.0)), (cage_of(), None)):
        without = torque._unsure_of_cage(cage, drive, races_of(), NOTHING)
        assert not np.any(without[0])
        assert without[1:] == ((), ())


def test_balls_that_may_squeeze_a_cage_leave_its_torque_open_where_a_weight_decides() -> None:
    farthest = np.array([0.9e-4, 1e-4, 3e-4])
    unsure, unknown, _ = of_cage(races_of(is_free=True), drive_of(0.0), farthest=farthest)
    # Beyond what they squeeze already, and never less than that.
    more = (1 + SQUEEZE_SPREAD) * 0.5 * np.maximum(farthest - OWN_LEAD, 0.0)
    np.testing.assert_allclose(unsure, np.array([0.11, 0.22, 0.33]) + more, rtol=1e-12)
    assert unknown == ("so",)
    open_ = of_cage(
        races_of(is_free=True, any_direction=np.array([True, False, True])), drive_of(0.0), farthest=farthest
    )
    np.testing.assert_array_equal(np.isposinf(open_[0]), [False, False, True])
    assert open_[1] == ("so", SQUEEZED_BY_WEIGHT)
    free = of_cage(races_of(is_free=True), drive_of(0.0), farthest=0.999e-4 * np.ones(3))
    np.testing.assert_allclose(free[0], [0.11, 0.22, 0.33], rtol=1e-12)


def test_balls_lead_farther_by_what_is_left_out_by_weights_and_by_the_quadrature() -> None:
    spread: list[Any] = []

    def lead_spread(at: NDArray[np.intp]) -> Array:
        spread.append(at.tolist())
        return np.linspace(1e-6, 3e-6, at.size)

    def farthest(lead: float, by_weight: float = 0.0, **changed: Any) -> Array:
        spread.clear()
        races = races_of(lead_spread=lead_spread, with_weight=with_weight({}), **changed)
        weight = NOTHING._replace(ball_lead=np.full(3, by_weight))
        return torque._farthest_lead(races, drive_of(lead), weight)

    # From a fifth of the free clearance, 1e-4 m, on other quadratures are tried.
    np.testing.assert_allclose(farthest(-0.199e-4), 1.05 * 0.199e-4, rtol=1e-12)
    assert not spread
    np.testing.assert_allclose(farthest(-0.201e-4), 1.05 * 0.201e-4 + np.array([2e-6, 4e-6, 6e-6]), rtol=1e-12)
    assert spread == [[0, 1, 2]]
    np.testing.assert_allclose(farthest(0.05e-4, 0.09e-4), 1.05 * 2 * 0.09e-4, rtol=1e-12)
    for ruled in (races_of(slides=False), races_of(scene=RULED)):
        found = torque._farthest_lead(ruled, drive_of(0.5e-4), NOTHING)
        np.testing.assert_allclose(found, 1.05 * 0.5e-4, rtol=1e-12)
        assert not spread
    long = SimpleNamespace(is_of_all=False, points=np.zeros((3, 5)), tried=np.array([0, 2]))
    np.testing.assert_allclose(farthest(0.5e-4, trial=long), 1.05 * 0.5e-4 + 2 * 3e-6, rtol=1e-12)
    assert spread == [[0, 2]]
    nothing = SimpleNamespace(is_of_all=False, points=np.zeros((3, 5)), tried=np.array([], dtype=int))
    np.testing.assert_allclose(farthest(0.5e-4, trial=nothing), 1.05 * 0.5e-4, rtol=1e-12)


@pytest.mark.parametrize(("near", "directions"), [(0.999, 0), (1.001, 26)])
def test_weights_between_the_axes_are_tried_from_a_tenth_of_the_clearance_on(near: float, directions: int) -> None:
    asked: list[Any] = []

    def solve(at: NDArray[np.intp], down: tuple[float, float, float]) -> Solution:
        asked.append(down)
        return forged(len(at), ball_lead=-3e-5 if down[0] > 0.5 and down[1] > 0.5 else 0.0)

    weight = NOTHING._replace(ball_lead=np.array([0.0, near * 0.1e-4, 0.0]))
    races = races_of(scene=RULED, with_weight=solve)
    found = torque._farthest_lead(races, drive_of(0.0), weight)
    assert len(asked) == directions
    expected = 3e-5 if directions else near * 0.1e-4
    np.testing.assert_allclose(found, [0.0, 1.05 * 2 * expected, 0.0], rtol=1e-12)


# Words


def test_two_steady_states_are_told_where_they_differ_most() -> None:
    """Beside the torque of the point: half as much more here, a quarter at the next one."""
    points = np.zeros((3, 5))
    points[:, 3] = [2 * np.pi * 25, 10.0, 30.0]  # 25 turns a second
    trial = SimpleNamespace(points=points, is_of_all=True)
    (words,) = torque._two_states(races_of(other=np.array([3.0, 5.0, np.nan]), trial=trial))
    assert "two steady states at 1500 rpm: the races resist 2000 N mm or 3000 N mm" in words
    assert torque._two_states(races_of(trial=trial)) == ()


def test_balls_that_nearly_turn_across_their_grooves_are_told() -> None:
    points = np.zeros((3, 5))
    points[:, 3] = [10.0, 2 * np.pi * 25, 30.0]
    found = forged(gyroscopic_hold=[0.2, 0.953, 0.94])
    trial = SimpleNamespace(points=points, is_of_all=True)
    (words,) = torque._nearly_turned(races_of(found=found, trial=trial, brink=np.array([0.0, 11.0, 7.0])))
    assert "takes 95.3 % of the friction" in words
    assert "at 1500 rpm" in words
    assert torque._nearly_turned(races_of(found=found, trial=trial)) == ()


def test_the_method_and_the_inlets_are_told() -> None:
    assert torque._sliding_words(races_of()) == "along_axis"
    assert torque._sliding_words(races_of(computed=2)) == "along_axis at 2 of 3 points"
    assert torque._sliding_words(races_of(slides=False)) == "nothing slides"
    ledger = ledger_of()
    ledger.settle("starvation", on=False, reason="so")
    assert torque._inlet_words(ledger, races_of()) == "flooded"
    found = forged()
    found.balls["starvation_degree"] = [[[5.0, 7.0], [4.0, 6.0]]] * 3
    ledger.settle("starvation", on=True, reason="so")
    assert torque._inlet_words(ledger, races_of(found=found)).endswith("m = 4 at least")
    dry = replace(SCENE, lubricant=None, surface=None)
    assert torque._inlet_words(ledger_of(dry), races_of()) == "no lubricant"
    assert torque._law_in_words(SCENE) == "eyring_sinh"
    for scene in (dry, replace(SCENE, surface=None), replace(SCENE, lubricant=None)):
        assert torque._law_in_words(scene) == "given coefficient"


@pytest.mark.parametrize(
    ("changed", "words"),
    [
        ({"friction_coefficient": 0.07}, "both determine the friction"),
        ({"lubricant": None, "surface": None}, "friction.coefficient is missing"),
        ({"lubricant": None}, "[lubricant] is missing"),
        ({"surface": None}, "[surface] is missing"),
    ],
)
def test_friction_has_one_source(changed: dict[str, Any], words: str) -> None:
    refused(lambda: torque._require_friction(replace(SCENE, **changed)), words)


def test_a_pair_of_oil_and_surface_or_a_coefficient_is_one_source() -> None:
    torque._require_friction(SCENE)
    torque._require_friction(replace(SCENE, surface=None, friction_coefficient=0.07))
    torque._require_friction(replace(SCENE, surface=None, lubricant=None, friction_coefficient=0.0))


# The whole


@pytest.fixture(scope="module")
def caged() -> Scene:
    """Fast balls by rule with a cage, whose centrifugal force presses on the outer race."""
    return replace(
        SCENE,
        operation=thrust(310.0, 890.0, speed=[900.0, 700.0]),
        cage=STAMPED_CAGE,
        spin_rule="balanced",
        sliding="single_coefficient",
        effects={"cage_dynamics": "off", "ball_dynamics": "off"},
    )


def test_the_uncertainty_has_the_doubts_of_races_limits_and_cage(caged: Scene, monkeypatch: pytest.MonkeyPatch) -> None:
    """That of the cage in N m; the record has the reasons and warnings of all."""
    limits = torque.check_limits
    monkeypatch.setattr(torque, "_unsure", lambda *_: Unsure(np.array([0.02, 0.03]), ("races",)))
    monkeypatch.setattr(
        torque,
        "check_limits",
        lambda *each: replace(limits(*each), uncertainty=np.array([0.3, 0.1]), unknown=("limit",)),
    )
    monkeypatch.setattr(
        torque, "_unsure_of_cage", lambda *_: (np.array([1e-3, 2e-3]), ("cage",), ("the cage may do so",))
    )
    found = torque.friction_torque(caged)
    shares = np.array([0.32, 0.13]) + np.array([1e-3, 2e-3]) / found.torque.total
    np.testing.assert_allclose(found.numerical_uncertainty, shares, rtol=1e-12)
    assert found.unknown == ("limit", "races", "cage")
    assert "the cage may do so" in found.warnings


def test_a_result_has_the_parts_of_races_and_cage(caged: Scene) -> None:
    found = torque.friction_torque(caged)
    assert 0 < found.seconds < 100
    cage = present(found.torque.cage)
    parts = sum(present(getattr(found.torque, name)) for name in ("spin", "conformity", "hysteresis", "rolling"))
    np.testing.assert_allclose(found.torque.race, parts, rtol=1e-14)
    np.testing.assert_allclose(found.torque.total, parts + cage, rtol=1e-14)
    assert np.all(found.outer.load > found.inner.load)
    np.testing.assert_array_equal(found.ball_load, found.outer.load)
    angles = [np.arcsin(axial / (9 * found.inner.load[place])) for place, axial in enumerate((310.0, 890.0))]
    assert np.all(found.contact_angle < np.array(angles))  # the mean with the flatter outer one
    both = present(found.gap_roughness)
    assert both == pytest.approx(np.hypot(0.21e-6, 0.21e-6), rel=1e-12)
    assert present(found.friction_coefficient.pocket).shape == (2,)
    assert present(found.limits.cage_grip).shape == (2,)
    assert found.provenance["cage"] != "left out"
    for without in (replace(caged, cage=None), replace(caged, effects={**caged.effects, "cage": "off"})):
        bare = torque.friction_torque(without)
        np.testing.assert_allclose(bare.torque.total, parts, rtol=1e-12)
        assert (bare.cage, bare.friction_coefficient.pocket, bare.limits.cage_grip) == (None, None, None)
        assert bare.provenance["cage"] == "left out"
    dry = torque.friction_torque(replace(caged, surface=None, friction_coefficient=0.07))
    assert dry.gap_roughness is None
    assert (dry.film.inner, dry.asperity_share.outer, dry.boundary_share.inner) == (None, None, None)
    np.testing.assert_allclose(present(dry.friction_coefficient.outer), 0.07, rtol=1e-12)


def test_a_name_takes_the_arguments_of_a_scene_and_a_scene_takes_none(caged: Scene) -> None:
    by_name = torque.friction_torque("6205-dry", tolerance="4 %")
    assert present(by_name.torque.spin).size == 5
    refused(lambda: torque.friction_torque(caged, radial_load="3 kN"), "radial_load goes with a designation")
    assert torque.friction_torque(caged, tolerance=0.04).provenance["scene"] == caged.name
