"""What counts of balls and races, how the balls turn and by which method they slide: both sides of each decision."""

from collections.abc import Mapping
from dataclasses import replace
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic import races
from analytic.contact.factors import ContactCorrection
from analytic.effects.ledger import Ledger
from analytic.effects.table import ENTRIES, PER_CENTRIFUGAL, PER_LAG
from analytic.effects.trial import OF_FREE_BALLS, OF_METHODS
from analytic.errors import ConvergenceError, InputError
from analytic.free_ball.rotation import QUADRATURES
from analytic.oil.variation import NOMINAL, Variation
from analytic.races import NOT_UNIQUE, WEDGED, RaceTorque, loaded_balls_of
from analytic.scene import Array, ContactAngle, Operation, Scene
from analytic.sliding.judge import ALONG_AXIS, AS_PRINTED, FINE, METHODS, OVER_ELLIPSE, SINGLE_COEFFICIENT
from analytic.solve.freely import BETWEEN
from analytic.solve.solution import Solution
from analytic.torque import friction_torque
from tests.analytic.solve.test_solution import forged
from tests.analytic.specimens import BEARING_6205, OIL, present, thrust
from tests.analytic.test_torque_uncertainty import SCENE as OILED
from tests.refusals import refused

TOLERANCE = 0.06
BUDGET = TOLERANCE / 2  # half of the tolerance is for effects that are left out
NEAR = (0.999, 1.001)  # of a limit
SCENE = replace(OILED, tolerance=TOLERANCE, down=(0.6, -0.8, 0.0))
ALL_ON: dict[str, bool] = dict.fromkeys(
    (
        *("load_distribution", "weight", "centrifugal", "gyroscopic", "finite_geometry", "asperities"),
        *("inlet_heating", "starvation", "spin", "conformity", "hysteresis", "rolling", "unloaded_balls"),
    ),
    True,
)


class Numbers:
    """A model that computes nothing and keeps its arguments."""

    def __init__(self, **asked: Any) -> None:
        self.asked, self.tables = asked, SimpleNamespace(factors=np.zeros((0, 2, 4, 1)))

    def counting(self, counted: Mapping[str, bool]) -> "Numbers":
        return Numbers(**{**self.asked, "counted": dict(counted)})

    def with_numbers(self, **numbers: Any) -> "Numbers":
        return Numbers(**{**self.asked, **numbers})

    def turning_freely(self, _bearing: Any, creep: str) -> "Numbers":
        return Numbers(**{**self.asked, "creep": creep})

    def at(self, _points: Any) -> "Numbers":
        return self

    def weighing(self, weights: Array) -> "Numbers":
        return Numbers(**{**self.asked, "weights": weights})


def trial_of(found: Solution, *, scene: Scene = SCENE, is_of_all: bool = True, **more: Any) -> Any:
    """A trial that finds the same whatever counts."""
    return SimpleNamespace(
        scene=scene,
        model=Numbers(),
        points=np.zeros((len(found.points) * (1 if is_of_all else 4), 5)),
        tried=np.arange(len(found.points)),
        is_of_all=is_of_all,
        **({"solved": lambda *_, **__: found} | more),
    )


def resisted(found: Solution, *, scene: Scene = SCENE, **changed: Any) -> RaceTorque:
    count = len(found.points)
    known: dict[str, Any] = {
        "scene": scene,
        "trial": trial_of(found),
        "counted": ALL_ON,
        "found": found,
        "method": "marched_creep",
        "error": np.zeros(count),
        "computed": count,
        "warnings": (),
        "beyond_fit": False,
        "any_direction": np.zeros(count, dtype=bool),
        "other": np.full(count, np.nan),
        "is_wedged": False,
    }
    return RaceTorque(**(known | changed))


def test_parts_are_those_that_count() -> None:
    found = forged(spin=2.0, conformity=3.0, hysteresis=5.0, rolling=7.0)
    some = resisted(found, counted=ALL_ON | {"conformity": False})
    assert {name: float(part[0]) for name, part in some.parts.items()} == {
        "spin": 2.0,
        "hysteresis": 5.0,
        "rolling": 7.0,
    }
    np.testing.assert_array_equal(some.total, [17.0] * 3)


@pytest.mark.parametrize(
    ("method", "slides", "is_free"),
    [("auto", False, False), ("single_coefficient", True, False), ("free_ball", True, True)],
)
def test_a_method_says_whether_balls_slide_and_turn_freely(method: Any, slides: bool, is_free: bool) -> None:
    found = forged(rolling_force=1.0, most_friction=4.0, gyroscopic_hold=0.3)
    found.balls["friction_coefficient"] = [[[0.05, 0.08], [0.06, 0.09]]] * 3
    each = resisted(found, method=method)
    assert (each.slides, each.is_free, each.is_mixed) == (slides, is_free, slides)
    assert not resisted(found, method=method, scene=replace(SCENE, friction_coefficient=0.07)).is_mixed
    assert (each.gap_roughness is not None) == slides
    assert resisted(found, method=method, scene=replace(SCENE, surface=None)).gap_roughness is None
    assert (each.sliding_number is not None) == slides
    assert resisted(found, method=method, counted=ALL_ON | {"rolling": False}).sliding_number is None
    assert (each.gyroscopic_hold is not None) == slides
    for scene in (replace(SCENE, effects={"gyroscopic": "off"}), replace(SCENE, contact_angle=GIVEN)):
        assert resisted(found, method=method, scene=scene).gyroscopic_hold is None
    assert (each.coefficient is not None) == slides
    if slides:
        np.testing.assert_array_equal(present(each.coefficient)[1], [[0.08, 0.09]] * 3)


GIVEN = ContactAngle(rule="given", value=0.31)


def test_the_heaviest_ball_presses_hardest_on_either_race() -> None:
    found = forged(2)
    found.balls["load"] = [[[30.0, 31.0], [29.0, 47.0]], [[52.0, 40.0], [51.0, 44.0]]]
    np.testing.assert_array_equal(resisted(found).heaviest["load"], [[29.0, 47.0], [52.0, 40.0]])
    assert not resisted(found).are_alike
    assert resisted(Solution(points=found.points, balls=found.balls[:, :1])).are_alike


@pytest.mark.parametrize(
    ("used", "expected"),
    [(0.5, 0.0), (0.9, 0.0), (0.95, 19.0 - 9.0), (1.05, 21.0 - 9.0), (np.inf, 0.0), (np.nan, 0.0)],
)
def test_errors_grow_where_the_gyroscopic_moment_takes_nearly_all_friction(used: float, expected: float) -> None:
    """By u/(1 - u), from 0.9 on, of balls that turn freely."""
    found = forged(gyroscopic_hold=used)
    np.testing.assert_allclose(resisted(found).brink, expected, rtol=1e-12, atol=1e-12)
    assert not np.any(resisted(found, method="along_axis").brink)
    assert not np.any(resisted(found, counted=ALL_ON | {"gyroscopic": False}).brink)


def test_friction_that_is_all_used_leaves_a_millionth() -> None:
    assert resisted(forged(gyroscopic_hold=1.0)).brink[0] == pytest.approx(1e6 - 9.0, rel=1e-9)


def test_what_takes_balls_off_a_race_changes_rolling(monkeypatch: pytest.MonkeyPatch) -> None:
    """With all forces that may act, or without those that are left out; free balls where these alone count."""
    calls: list[tuple[str, bool, list[int], bool]] = []

    def solver(how: str) -> Any:
        def solve(_: RaceTorque, model: Numbers, at: NDArray[np.intp]) -> Solution:
            counted = model.asked["counted"]
            calls.append((how, counted["weight"], at.tolist(), counted["unloaded_balls"]))
            step = {"free": 0.3, "rule": 0.2}[how]
            return forged(len(at), rolling=np.where(at == 4, np.nan, 1.0 - step * counted["weight"]))

        return solve

    monkeypatch.setattr(RaceTorque, "_cheaply", solver("free"))
    monkeypatch.setattr(RaceTorque, "_by_rule", solver("rule"))
    at_edge = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 1], [1, 0, 0]]  # by weight, centrifugal force and moment
    found = forged(5, at_edge=at_edge)
    without = ALL_ON | {"weight": False, "unloaded_balls": False}
    change = resisted(found, counted=without).change_at_edge()
    np.testing.assert_allclose(change, [0.0, 0.3, 0.2, 0.3, np.inf], rtol=1e-12)
    assert sorted(calls) == sorted(
        [(how, weighs, at, weighs) for how, at in (("rule", [2]), ("free", [1, 3, 4])) for weighs in (True, False)]
    )
    calls.clear()
    for counted in (ALL_ON, without | {"rolling": False}):
        np.testing.assert_array_equal(resisted(found, counted=counted).change_at_edge(), np.zeros(5))
    assert not calls
    impossible = replace(SCENE, down=None)  # a weight without direction takes no part
    np.testing.assert_array_equal(resisted(found, scene=impossible, counted=without).change_at_edge(), np.zeros(5))


def test_the_edge_is_tried_by_the_first_quadrature_of_free_balls_or_by_rule(monkeypatch: pytest.MonkeyPatch) -> None:
    free, rule = forged(1), forged(1)
    asked: list[dict[str, Any]] = []

    def solved(model: Numbers, _points: Array) -> Solution:
        asked.append(model.asked)
        return free

    monkeypatch.setattr(races, "solved", solved)
    monkeypatch.setattr(RaceTorque, "_by_rule", lambda *_: rule)
    model: Any = Numbers()
    at = np.array([1])
    assert resisted(forged(), method="closed_creep")._cheaply(model, at) is free
    assert asked == [{"creep": "closed", "passes": 1, "cold": False}]
    assert resisted(forged(), method="along_axis")._cheaply(model, at) is rule


def test_the_growth_by_wedging_is_that_of_the_worst_point(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(races, "growth_by_wedging", lambda *_: np.array([1.0, 3.5, 2.0]))
    assert resisted(forged()).growth == 3.5


@pytest.mark.parametrize(("method", "creep"), [("closed_creep", "closed"), ("single_coefficient", "marched")])
def test_how_far_balls_lead_is_compared_with_two_coarser_quadratures(
    monkeypatch: pytest.MonkeyPatch, method: Any, creep: str
) -> None:
    """The coarsest with the second, balls by rule with both, and one that does not settle shows nothing."""
    asked: list[tuple[str, int]] = []

    def solved(model: Numbers, points: Array) -> Solution:
        asked.append((model.asked["creep"], model.asked["passes"]))
        return forged(len(points), ball_lead=[np.nan, 0.0, 1e-6, 3e-6, 6e-6, 1e-5, 2e-5, 3e-5][model.asked["passes"]])

    monkeypatch.setattr(races, "solved", solved)
    own = np.array([0, 1, 3, 2])
    found = forged(4, passes=own, ball_lead=0.0)
    spread = resisted(found, method=method).lead_spread(np.array([0, 1, 2, 3]))
    # Of the first quadrature 0, of the second 1e-6, of the third 3e-6.
    np.testing.assert_allclose(spread, [1e-6, 1e-6, 1e-6, 0.0], atol=1e-20)
    assert {name for name, _ in asked} == {creep}
    assert {number for _, number in asked} <= set(range(1, len(QUADRATURES)))
    np.testing.assert_array_equal(resisted(found, method=method).lead_spread(np.array([3])), [0.0])
    lost = forged(1, passes=4, ball_lead=8e-6)
    np.testing.assert_allclose(resisted(lost).lead_spread(np.array([0])), [8e-6 - 1e-6], rtol=1e-12)


@pytest.mark.parametrize(
    ("changed", "counts", "expected"),
    [
        ({}, True, True),
        ({"effects": {"unloaded_balls": "off"}}, True, False),
        ({"lubricant": replace(OIL, supply="oil_jet")}, True, False),
        ({}, False, False),
    ],
)
def test_balls_that_a_weight_takes_off_roll_in_oil(changed: dict[str, Any], counts: bool, expected: bool) -> None:
    scene = replace(SCENE, **changed)
    each = resisted(forged(), scene=scene, counted={**ALL_ON, "rolling": counts, "load_distribution": False})
    down: Any = each._weighing((0.0, 0.0, 1.0))
    none: Any = each._weighing(None)
    heavy, light = down.asked, none.asked
    assert heavy["counted"]["unloaded_balls"] == light["counted"]["unloaded_balls"] == expected
    assert (heavy["counted"]["weight"], light["counted"]["weight"]) == (True, False)
    assert heavy["counted"]["load_distribution"]


def solved_with(
    *,
    left_out: float = 0.0,
    creep: Any = None,
    reason: str = "so",
    correction: ContactCorrection | None = None,
    off: tuple[str, ...] = (),
) -> tuple[Any, Any]:
    """The races of a scene whose effects are settled so, and what was asked of each step."""
    asked: dict[str, Any] = {}
    found, apart = forged(), np.full(3, 17.0)

    def decide(ledger: Ledger, *_: Any, has_factors: bool) -> dict[str, bool]:
        ledger.left_out = np.full(3, left_out)
        ledger.settle("weight", on=False, reason=reason)
        asked["has_factors"] = has_factors
        return ALL_ON | dict.fromkeys(off, False)

    def by_rule(_scene: Any, _trial: Any, _counted: Any, allowed: Array, *, slides: bool) -> Any:
        asked.update(allowed=allowed, slides=slides)
        return found, np.zeros(3), "along_axis", 2

    def finite_geometry(*_: Any, is_given: bool) -> Any:
        asked["is_given"] = is_given
        return (), False

    with pytest.MonkeyPatch.context() as patch:
        for name, value in {
            "trial_of": lambda *_: trial_of(found),
            "_base": lambda *_: found,
            "decide_effects": decide,
            "_any_direction": lambda *_: np.zeros(3, dtype=bool),
            "_free_creep": lambda *_, slides: asked.update(creeps=slides) or creep,
            "_slide_freely": lambda *_: (found, np.zeros(3)),
            "_slide_by_rule": by_rule,
            "_finite_geometry": finite_geometry,
            "_other_states": lambda *_: apart,
        }.items():
            patch.setattr(races, name, value)
        each = races.race_torque(Ledger(SCENE, 3), SCENE.operation, correction=correction, variation=NOMINAL)
    return each, asked


def test_sliding_may_err_by_what_effects_leave_of_the_tolerance() -> None:
    each, asked = solved_with(left_out=0.013)
    np.testing.assert_allclose(asked["allowed"], TOLERANCE - 0.013, rtol=1e-12)
    assert (each.method, each.computed, each.is_wedged) == ("along_axis", 2, False)
    assert np.isnan(each.other).all()
    assert (asked["has_factors"], asked["is_given"]) == (False, False)


def test_free_balls_have_other_states_and_their_own_method() -> None:
    each, asked = solved_with(creep="closed")
    assert (each.method, each.computed) == ("closed_creep", 3)
    np.testing.assert_array_equal(each.other, np.full(3, 17.0))
    assert "allowed" not in asked


def test_spin_or_conformity_slides() -> None:
    for off, slides in (
        (("spin",), True),
        (("conformity",), True),
        (("spin", "conformity"), False),
    ):
        _, asked = solved_with(off=off)
        assert (asked["slides"], asked["creeps"]) == (slides, slides)


def test_factors_of_the_call_and_wedged_balls_are_passed_on() -> None:
    _, asked = solved_with(correction=ContactCorrection())
    assert (asked["has_factors"], asked["is_given"]) == (True, True)
    assert solved_with(reason=NOT_UNIQUE)[0].is_wedged


# Loads


@pytest.mark.parametrize(("name", "known"), [("microslip", 2), ("spin_rule", 4), ("sliding", 7)])
def test_a_word_that_is_unknown_is_refused_with_the_known_ones(name: str, known: int) -> None:
    with pytest.raises(InputError, match=f"{name} must be .* or .*, got 'guess'") as caught:
        friction_torque(replace(SCENE, **{name: "guess"}))
    assert str(caught.value).count(",") == known - 1  # all but the last one, and the value


def test_as_many_balls_as_fit_have_a_torque_and_no_more() -> None:
    """15 balls of 7.94 mm leave 8.11 mm from ball to ball, 16 leave 7.61 mm; samples vary the balls of a full ring."""
    full, crowded = (replace(SCENE, bearing=replace(BEARING_6205, ball_count=count)) for count in (15, 16))
    words = "bearing.ball_count = 16 leaves 7.61", "less than ball_diameter 7.94 mm; at most 15 fit"
    refused(lambda: loaded_balls_of(crowded), *words)
    refused(lambda: friction_torque(crowded), *words)
    assert (loaded_balls_of(full).load > 0).all()
    assert friction_torque(crowded, variation=Variation(film=1.1)).torque.total[0] > 0


@pytest.mark.parametrize(("changed", "is_refused"), [
    ({}, True),
    ({"effects": {"load_distribution": "off"}}, False),
    ({"contact_angle": GIVEN}, False),
    ({"operation": thrust(310.0)}, False),
])  # fmt: skip
def test_a_ring_needs_balls_all_round(changed: dict[str, Any], is_refused: bool) -> None:
    scene = replace(SCENE, bearing=replace(BEARING_6205, ball_count=2), tolerance=0.5, **changed)
    if is_refused:
        with pytest.raises(InputError, match="ball"):
            races._require_loads(scene, scene.operation.as_series())
    else:
        races._require_loads(scene, scene.operation.as_series())


@pytest.mark.parametrize("factor", NEAR)
def test_a_radial_load_at_a_given_angle_is_refused_beyond_the_tolerance(factor: float) -> None:
    """Fr tan(al)/Fa is how unequal it makes the balls; a solved angle takes any."""
    radial = factor * TOLERANCE * 310.0 / np.tan(0.31)
    operation = Operation(
        axial_load=np.array([310.0, 310.0]), inner_speed=np.array([31.0, 47.0]), radial_load=np.array([radial, 0.0])
    )
    scene = replace(
        SCENE,
        contact_angle=GIVEN,
        operation=operation,
        down=None,
        spin_rule="balanced",
        surface=None,
        lubricant=None,
        friction_coefficient=0.07,
    )
    if factor > 1:
        refused(lambda: friction_torque(scene), "of the thrust")
    else:
        assert np.all(friction_torque(scene).torque.total > 0)


def test_of_loads_that_a_thrust_bearing_does_not_carry_the_largest_is_told() -> None:
    operation = replace(SCENE.operation, radial_load=np.array([3.0, -11.0, 0.0]), moment=0.0)
    refused(lambda: races._require_thrust(operation), "operation.radial_load = -11 N")
    races._require_thrust(replace(operation, radial_load=0.0))


def test_loaded_balls_carry_the_thrust_whatever_resists_sliding() -> None:
    bare = replace(SCENE, lubricant=None, surface=None, down=None, operation=thrust(310.0, 890.0))
    bare = replace(bare, effects={"gyroscopic": "off"})  # which friction across the grooves holds
    balls = loaded_balls_of(bare)
    assert balls.alike == BEARING_6205.ball_count  # one stands for all
    np.testing.assert_allclose(balls.total((balls.load * np.sin(balls.contact_angle))[1]), [310.0, 890.0], rtol=1e-9)


# Directions of the weight


def weighing(share: float, angle: float, **changed: Any) -> list[bool]:
    scene = replace(SCENE, down=None, **changed)
    found = forged(weight_share=share, contact_angle=angle)
    return races._any_direction(Ledger(scene, 3), trial_of(found, scene=scene), ALL_ON).tolist()


@pytest.mark.parametrize(("angle", "lean"), [(0.7, 1.0), (0.5, 1.0), (0.25, 2.0)])
@pytest.mark.parametrize(("effects", "alone"), [({}, 1.0), ({"conformity": "off"}, OF_METHODS)])
def test_a_weight_without_direction_counts_beyond_the_budget(
    angle: float, lean: float, effects: dict[str, Any], alone: float
) -> None:
    """Steep contacts turn by less of their angle; spin alone changes by more than both parts of sliding."""
    limit = BUDGET / (PER_CENTRIFUGAL * lean * alone)
    assert [weighing(factor * limit, angle, effects=effects) for factor in NEAR] == [[False] * 3, [True] * 3]


def test_a_weight_whose_direction_is_known_or_that_is_off_has_no_other() -> None:
    assert weighing(np.inf, 0.7) == [True] * 3
    assert weighing(np.inf, 0.7, effects={"weight": "off"}) == [False] * 3
    assert weighing(np.inf, 0.7, contact_angle=GIVEN) == [False] * 3
    found = forged(weight_share=np.inf, contact_angle=0.7)
    assert not races._any_direction(Ledger(SCENE, 3), trial_of(found), ALL_ON).any()


def test_each_point_of_a_long_series_has_its_own_weight(monkeypatch: pytest.MonkeyPatch) -> None:
    scene, asked = replace(SCENE, down=None), []

    def solved(model: Numbers, points: Array, **_: Any) -> Solution:
        asked.append(model.asked["counted"])
        return forged(len(points), weight_share=[1e-9, 1.0] * (len(points) // 2), contact_angle=0.7)

    monkeypatch.setattr(races, "solved", solved)
    found = races._any_direction(Ledger(scene, 12), trial_of(forged(), scene=scene, is_of_all=False), ALL_ON)
    np.testing.assert_array_equal(found, [False, True] * 6)
    assert asked == [dict.fromkeys(races.LOADING, True)]


# How the balls turn


def creeping(share: float, *, is_of_all: bool = True, suffices: bool = True, **changed: Any) -> Any:
    """How surfaces creep whose share this is; what else tells free balls from closed kinematics may suffice or not."""
    scene = replace(SCENE, **changed)
    slides, ledger = changed.get("slides", True), Ledger(scene, 3 if is_of_all else 12)
    trial = trial_of(forged(creep=[0.1 * share, share, 0.0]), scene=scene, is_of_all=is_of_all)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(races, "_rule_suffices", lambda *_: suffices)
        return races._free_creep(ledger, trial, dict(ALL_ON), forged(creep=share), slides=slides)


@pytest.mark.parametrize("is_of_all", [True, False])
@pytest.mark.parametrize(("sliding", "creep"), [("auto", "marched"), ("closed_creep", "closed")])
def test_creep_counts_beyond_the_budget_or_where_its_method_is_given(is_of_all: bool, sliding: Any, creep: str) -> None:
    """Between the points that are tried it is larger."""
    limit = BUDGET / (1.0 if is_of_all else BETWEEN)
    below, above = (creeping(factor * limit, is_of_all=is_of_all, sliding=sliding) for factor in NEAR)
    assert below == (None if sliding == "auto" else creep)
    assert above == creep


def test_a_lag_counts_as_creep() -> None:
    limit = BUDGET / PER_LAG
    for factor, expected in zip(NEAR, (None, "marched"), strict=True):
        found = forged(rolling_force=[[0.1 * factor * limit, factor * limit]] * 3, most_friction=1.0)
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(races, "_rule_suffices", lambda *_: True)
            creep = races._free_creep(Ledger(SCENE, 3), trial_of(found), dict(ALL_ON), found, slides=True)
        assert creep == expected


def test_balls_turn_freely_where_closed_kinematics_do_not_suffice() -> None:
    assert creeping(1e-6, suffices=True) is None
    assert creeping(1e-6, suffices=False) == "none"
    assert creeping(1e-6, sliding="free_ball") == "none"  # the scene sets them
    assert creeping(np.inf, spin_rule="balanced") is None
    assert creeping(np.inf, effects={"creep": "off"}, suffices=False) == "none"


def test_a_method_of_free_balls_is_refused_where_a_rule_turns_them() -> None:
    for method in ("free_ball", "closed_creep", "marched_creep"):
        refused(lambda: creeping(0.1, sliding=method, spin_rule="balanced"), f'"{method}" is refused', "spin_rule")  # noqa: B023
    for method in ("closed_creep", "marched_creep"):
        refused(lambda: creeping(0.1, sliding=method, effects={"creep": "off"}), "neglects the creep")  # noqa: B023
    assert creeping(0.1, sliding="free_ball", effects={"creep": "off"}) == "none"


def test_what_does_not_slide_turns_by_rule_and_free_balls_always_spin() -> None:
    ledger, counted = Ledger(SCENE, 3), ALL_ON | {"spin": False, "conformity": False}
    found = forged(creep=np.inf)
    assert races._free_creep(ledger, trial_of(found), counted, found, slides=False) is None
    assert ledger.made["creep"].reason == ENTRIES["creep"].idle
    counted["conformity"] = True
    assert races._free_creep(ledger, trial_of(found), counted, found, slides=True) == "marched"
    assert counted["spin"]
    assert ledger.made["spin"].reason == ENTRIES["spin"].given


@pytest.mark.parametrize(
    ("source", "needs", "factor"),
    [
        ("rolls_otherwise", None, 1.0),
        ("share_by_parts", "centrifugal", OF_FREE_BALLS),
        ("slip_by_weight", "weight", 1.0),
        ("slip_by_gyroscopic_moment", "gyroscopic", 1.0),
        ("lag", "creep", PER_LAG),
    ],
)
def test_closed_kinematics_suffice_within_the_budget(
    monkeypatch: pytest.MonkeyPatch, source: str, needs: str | None, factor: float
) -> None:
    """Of each part by which free balls roll or slide otherwise, where it counts."""

    def suffices(near: float, *, counts: bool = True) -> bool:
        size = near * BUDGET / factor
        values = {name: np.zeros(3) for name in ("rolls_otherwise", "slip_by_weight", "slip_by_gyroscopic_moment")}
        share = np.zeros(3)
        if source in values:
            values[source] = np.full(3, size)
        elif source == "share_by_parts":
            share = np.full(3, size)
        for name, value in values.items():
            monkeypatch.setattr(races, name, lambda *_, value=value: value)
        force = size if source == "lag" else 0.0
        found = forged(rolling_force=[[force, 0.1 * force]] * 3, most_friction=1.0)
        scene = replace(SCENE, effects={"creep": "off"}) if source == "lag" and counts else SCENE
        counted = dict.fromkeys(ALL_ON, False) | ({needs: True} if needs in ALL_ON and counts else {})
        trial = trial_of(found, scene=scene, share_by_parts=lambda *_: share)
        return races._rule_suffices(Ledger(scene, 3), trial, counted, found)

    assert [suffices(near) for near in NEAR] == [True, False]
    if needs is not None:
        assert suffices(3.0, counts=False)


def test_both_forces_of_inertia_are_tried_together() -> None:
    asked: list[tuple[str, ...]] = []

    def share_by_parts(_: Any, *names: str) -> Array:
        asked.append(names)
        return np.zeros(3)

    found = forged()
    found.balls["load"] = 90.0
    found.balls["friction_coefficient"] = 0.07
    trial = trial_of(found, share_by_parts=share_by_parts)
    assert races._rule_suffices(Ledger(SCENE, 3), trial, dict.fromkeys(ALL_ON, False), found)
    assert not asked
    races._rule_suffices(Ledger(SCENE, 3), trial, ALL_ON, found)
    assert asked == [("centrifugal", "gyroscopic")]


# Friction that wedges balls


def wedged(
    growth: float, *, fails: bool = False, share: float = 0.01, scene: Scene = SCENE, **counts: bool
) -> tuple[Ledger, Any, int]:
    """The ledger, what counts, and how often free balls were solved, where unequal loads grow so."""
    counted, calls = ALL_ON | {"load_distribution": False, "weight": False} | counts, []
    ledger = Ledger(scene, 3)
    ledger.left_out = np.array([0.0, 0.002, 0.001])
    for name in ("load_distribution", "weight"):
        ledger.settle(name, on=False, share=share / (1 if name == "weight" else 3), reason="by trial")

    def slide_freely(_scene: Scene, model: Numbers, _points: Array) -> tuple[Solution, Array]:
        calls.append(dict(counted))
        assert (model.asked["counted"], model.asked["creep"]) == (counted, "marched")
        # What effects leave of the tolerance, at the point where they leave least.
        assert model.asked["allowed"] == pytest.approx(TOLERANCE - ledger.left_out.max(), rel=1e-12)
        if fails and len(calls) > 1:
            raise ConvergenceError(iterations=3, residual=0.2, tolerance=0.1)
        return forged(), np.full(3, 0.004)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(races, "slide_freely", slide_freely)
        patch.setattr(races, "growth_by_wedging", lambda *_: np.array([1.0, growth, 1.0]))
        _, error = races._slide_freely(ledger, trial_of(forged(), scene=scene), counted, "marched")
    np.testing.assert_array_equal(error, [0.004] * 3)
    return ledger, counted, len(calls)


@pytest.mark.parametrize("near", NEAR)
def test_what_wedged_balls_feel_more_counts_beyond_the_budget(near: float) -> None:
    growth = 1 + near * (BUDGET - 0.002) / 1.002 / 0.01  # beside the 0.002 that is left out already
    ledger, counted, times = wedged(growth)
    counts = near > 1
    assert (counted["load_distribution"], counted["weight"], times) == (counts, counts, 2 if counts else 1)
    assert ledger.made["weight"].reason == (WEDGED if counts else "by trial")
    if counts:
        assert present(ledger.made["weight"].share) == pytest.approx(growth * 0.01, rel=1e-12)


def test_wedged_balls_whose_loads_are_not_unique_leave_them_out() -> None:
    ledger, counted, times = wedged(np.inf, fails=True)
    assert (counted["load_distribution"], counted["weight"], times) == (False, False, 2)
    assert {ledger.made[name].reason for name in ("weight", "load_distribution")} == {NOT_UNIQUE}
    assert {ledger.made[name].decision for name in ("weight", "load_distribution")} == {"off"}


def test_wedged_balls_feel_what_the_scene_leaves_to_auto_alone() -> None:
    _, counted, times = wedged(np.inf, scene=replace(SCENE, effects={"weight": "off"}))
    assert (counted["load_distribution"], counted["weight"], times) == (True, False, 2)
    off = replace(SCENE, effects={"weight": "off", "load_distribution": "off"})
    assert wedged(np.inf, scene=off)[2] == 1


def test_loads_that_count_already_or_change_nothing_are_solved_once() -> None:
    assert wedged(np.inf, weight=True)[2] == 1
    assert wedged(1e9, share=0.0)[2] == 1


# Methods of sliding


def slid(errors: Mapping[int, float], scene: Scene = SCENE, *, is_of_all: bool = True, **found: Any) -> Any:
    """By methods with these errors of their torque, of which sliding is a half."""
    asked: list[int] = []

    def of_method(method: int, count: int) -> Solution:
        share = errors.get(method, 0.5)
        return forged(count, **({"spin": 3.0, "rolling": 3.0, "sliding_error": 3.0 * share} | found))

    def tried(_: Any, method: int, **__: Any) -> Solution:
        asked.append(method)
        return of_method(method, 3)

    def solved(model: Numbers, points: Array) -> Solution:
        return of_method(model.asked.get("method", SINGLE_COEFFICIENT), len(points))

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(races, "solved", solved)
        patch.setattr(races, "slide_by_sample", lambda *_: None)
        trial = trial_of(forged(), scene=scene, is_of_all=is_of_all, solved=tried)
        count = 3 if is_of_all else 12
        allowed = np.full(count, 0.09)
        allowed[1] = 0.05  # the point that allows least decides
        result = races._slide_by_rule(scene, trial, ALL_ON, allowed, slides=True)
    return *result[1:], asked


RULED = replace(SCENE, spin_rule="balanced")


@pytest.mark.parametrize("near", NEAR)
def test_the_cheapest_method_whose_error_is_allowed_slides(near: float) -> None:
    """Sliding is half of the torque, and may err by twice as much."""
    error, method, computed, asked = slid({SINGLE_COEFFICIENT: 0.1 * near, ALONG_AXIS: 0.02}, RULED)
    assert method == METHODS[SINGLE_COEFFICIENT if near < 1 else ALONG_AXIS]
    np.testing.assert_allclose(error, 0.1 * near if near < 1 else 0.02, rtol=1e-12)
    assert computed == 3
    assert asked[0] == SINGLE_COEFFICIENT


def test_the_best_method_slides_where_none_is_accurate_enough() -> None:
    error, method, _, asked = slid({FINE: 0.3}, RULED)
    assert (method, asked[-1]) == (METHODS[FINE], FINE)
    np.testing.assert_allclose(error, 0.3, rtol=1e-12)


def test_a_method_that_is_given_slides_whatever_its_error() -> None:
    for name, number in (("single_coefficient", SINGLE_COEFFICIENT), ("along_axis", ALONG_AXIS)):
        _, method, _, asked = slid({}, replace(RULED, sliding=name))
        assert (method, asked) == (name, [number])
    assert slid({}, replace(RULED, sliding="over_ellipse"))[3] == [OVER_ELLIPSE, FINE]
    _, method, _, asked = slid({}, replace(RULED, microslip="as_printed"))
    assert (method, asked) == ("single_coefficient", [AS_PRINTED])


@pytest.mark.parametrize("near", NEAR)
def test_of_a_long_series_the_error_lies_below_the_limit_by_what_lies_between(near: float) -> None:
    """Where it does not, the error of every point decides, and here every point has the same."""
    error, method, computed, _ = slid({SINGLE_COEFFICIENT: near * 0.1 / BETWEEN}, RULED, is_of_all=False)
    assert (method, computed, error.shape) == ("single_coefficient", 12, (12,))
    own = near * 0.1 / BETWEEN
    np.testing.assert_allclose(error, BETWEEN * own if near < 1 else own, rtol=1e-12)
    worse = slid({SINGLE_COEFFICIENT: near * 0.1, ALONG_AXIS: 0.01}, RULED, is_of_all=False)
    assert worse[1] == ("single_coefficient" if near < 1 else "along_axis")
    np.testing.assert_allclose(worse[0], near * 0.1 if near < 1 else BETWEEN * 0.01, rtol=1e-12)


def test_a_torque_that_is_lost_by_a_method_is_no_torque_of_it() -> None:
    """An error that is not known does not pass for a small one."""
    lost = slid({}, RULED, sliding_error=np.nan)
    assert lost[1] == METHODS[FINE]


def test_nothing_slides_without_an_error() -> None:
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(races, "solved", lambda _, points: forged(len(points), rolling=2.0))
        found = races._slide_by_rule(RULED, trial_of(forged()), ALL_ON, np.full(3, 0.05), slides=False)
    assert found[2:] == ("auto", 3)
    np.testing.assert_array_equal(found[1], np.zeros(3))


# Finite geometry


@pytest.mark.parametrize(
    ("beyond", "applied", "is_given", "is_on", "expected"),
    [
        (True, True, False, True, (("outside",), True, "on")),
        (True, False, False, True, (("outside",), True, "off")),
        (False, True, False, True, ((), False, "on")),
        (True, True, True, True, ((), False, "on")),
        (True, True, False, False, ((), False, "off")),
    ],
)
def test_contacts_outside_the_fit_are_told(
    monkeypatch: pytest.MonkeyPatch, beyond: bool, applied: bool, is_given: bool, is_on: bool, expected: Any
) -> None:
    """Where no contact is inside, the effect is not applied."""
    ledger = Ledger(SCENE, 3)
    ledger.settle("finite_geometry", on=is_on, reason="so")
    found = forged(beyond_fit=[False, beyond, False], fit_applied=[False, False, applied])
    monkeypatch.setattr(races, "corrections_of", lambda *_: SimpleNamespace(warnings=("outside",)))
    monkeypatch.setattr(Solution, "loaded_balls", lambda *_: None)
    warnings, is_beyond = races._finite_geometry(ledger, SCENE, found, is_given=is_given)
    assert (warnings, is_beyond, ledger.made["finite_geometry"].decision) == expected
