"""Effects are decided by trial: shares are measured, few points compute all, long series keep their tolerance."""

from dataclasses import replace

import numpy as np
import pytest
from numpy.typing import NDArray

from analytic.effects import trial
from analytic.effects.ledger import Ledger
from analytic.effects.table import (
    PER_CENTRIFUGAL,
    PER_CONFORMITY,
    PER_DISTRIBUTION,
    PER_GYROSCOPIC_SLIP,
    PER_LAG,
    PER_ORBIT,
    PER_WEIGHT_SLIDING,
    PER_WEIGHT_SLIP,
    TRIED,
)
from analytic.effects.trial import (
    FEW,
    Trial,
    at_all_points,
    decide_effects,
    growth_by_wedging,
    left_out_at_all,
    method_of_changes,
    part_by_asperities,
    possible,
    rolls_otherwise,
    slip_by_gyroscopic_moment,
    slip_by_weight,
    trial_of,
    unequal_loads,
    unseen_by_trial,
)
from analytic.oil.variation import NOMINAL
from analytic.result import FrictionTorque
from analytic.scene import Array, Bearing, ContactAngle, Operation, Scene
from analytic.sliding.judge import OVER_ELLIPSE, SINGLE_COEFFICIENT
from analytic.solve.records import BALL, POINT
from analytic.solve.solution import FAR, Solution
from analytic.torque import friction_torque
from tests.analytic.specimens import FINISH, OIL, STAMPED_CAGE, drawn, dry, idling, present, without
from tests.drawn_scenes import drawn_scene

# Parts of the torque that the same balls lose: contact angles and shares of load are solved to 1e-12 or better.
SAME = 1e-9
HAVE_PARTS = ("spin", "conformity")  # stated by their part of the torque, which is not what leaving them out changes


@pytest.fixture(scope="module")
def rich(bearing_6205: Bearing) -> Scene:
    """Every effect of balls and races has its input, and takes a visible share at one of these points."""
    return Scene(
        name="rich",
        tolerance=0.02,
        bearing=bearing_6205,
        contact_angle=idling(bearing_6205).contact_angle,
        operation=Operation(
            axial_load=np.array([310.0, 45.0, 890.0]),
            inner_speed=np.array([820.0, 37.0, 240.0]),
            radial_load=np.array([95.0, 170.0, 0.0]),
            moment=np.array([0.3, 0.0, 0.7]),
        ),
        down=(0.6, 0.0, -0.8),
        lubricant=OIL,
        surface=FINISH,
        hysteresis_loss=0.006,
        spin_rule="balanced",
        sliding="single_coefficient",  # by which shares are measured
        effects=dict.fromkeys(TRIED, "on"),
    )


WEIGHT = 2.04e-3 * 9.80665  # N, of a ball of the 6205


def balls_of(points: int = 1, balls: int = 2, **fields: object) -> Solution:
    """A solution that nobody solved, with these fields of its balls; those of its points begin with `of_`."""
    found = Solution(points=np.zeros(points, POINT), balls=np.zeros((points, balls), BALL))
    for name, values in fields.items():
        if name.startswith("of_"):
            found.points[name[3:]] = values
        else:
            found.balls[name] = values
    return found


def ledger_of(bearing: Bearing, points: int, tolerance: float = 0.05, **changed: object) -> Ledger:
    scene = replace(dry(bearing), tolerance=tolerance, spin_rule="balanced", **changed)  # pyright: ignore[reportArgumentType]
    return Ledger(scene, points)


def test_unequal_loads_are_those_of_statics_over_the_thrust(bearing_6205: Bearing) -> None:
    """(Fr tan al + 2 M/d_m)/Fa, infinite without thrust, and nothing without either."""
    operation = Operation(
        axial_load=np.array([300.0, 700.0, 0.0, 0.0, 0.0]),
        inner_speed=np.ones(5),
        radial_load=np.array([-40.0, 0.0, 3.0, 0.0, 0.0]),
        moment=np.array([0.0, -1.3, 0.0, 0.2, 0.0]),
    )
    angles = np.array([0.31, -0.27, 0.2, 0.2, 0.2])
    found = balls_of(5, 1, angle=angles[:, None, None] * [1.0, 0.9])
    expected = [40 * np.tan(0.31) / 300, 2 * 1.3 / 39.01e-3 / 700, np.inf, np.inf, 0.0]
    np.testing.assert_allclose(unequal_loads(dry(bearing_6205), operation, found), expected, rtol=1e-12)


def test_the_part_of_asperities_is_the_largest_change_of_friction() -> None:
    with_, without_ = (np.array([[[0.05, 0.02], [0.08, 0.0]]]), np.array([[[0.04, 0.03], [0.08, 0.0]]]))
    change = part_by_asperities(balls_of(friction_coefficient=with_), balls_of(friction_coefficient=without_))
    np.testing.assert_allclose(change, [1 / 3], rtol=1e-12)  # 0.01 of 0.03 on the outer race


def test_slip_by_the_gyroscopic_moment_goes_with_what_friction_holds(bearing_6205: Bearing) -> None:
    """At the worst ball; one without friction slips without a bound."""
    ledger = ledger_of(bearing_6205, 2)
    found = balls_of(2, 2, gyroscopic_use=[[0.01, 0.04], [np.nan, 0.0]])
    np.testing.assert_allclose(slip_by_gyroscopic_moment(ledger, found), [0.04 * PER_GYROSCOPIC_SLIP, np.inf])


def test_slip_by_weight_is_that_of_balls_that_friction_does_not_hold(bearing_6205: Bearing) -> None:
    """mu Q of the weaker race against m g: half of the balls slip wholly here; sliding is a fifth of the torque."""
    loads = np.array([[[2.0, 3.0], [0.5, 0.4]]])
    friction = np.array([[[0.05, 0.04], [0.02, 0.03]]])
    found = balls_of(load=loads, friction_coefficient=friction, of_spin=2.0, of_rolling=8.0)
    held = np.array([0.1, 0.01])  # N, of the weaker race
    slips = np.minimum(WEIGHT / held, 1).mean()
    per = PER_WEIGHT_SLIP + PER_WEIGHT_SLIDING * 0.2
    heaviest = np.array([3.0, 0.5])
    np.testing.assert_allclose(slip_by_weight(bearing_6205, found), per * slips * WEIGHT / heaviest.mean(), rtol=1e-12)
    # A ball that lags adds what unequal loads do: its lightest race counts.
    found.points["rolling_force"], found.points["most_friction"] = 0.03, [0.2, 0.3]
    lags = PER_DISTRIBUTION * 0.15 * WEIGHT / np.mean([2.0, 0.4])
    np.testing.assert_allclose(
        slip_by_weight(bearing_6205, found), per * slips * WEIGHT / heaviest.mean() + lags, rtol=1e-12
    )
    # A race without load holds nothing and does not count, and a ball without any has no friction.
    free = balls_of(load=[[[0.0, 3.0], [0.0, 0.0]]], friction_coefficient=0.05, of_spin=2.0, of_rolling=8.0)
    slips = (WEIGHT / 0.15 + 1) / 2
    np.testing.assert_allclose(slip_by_weight(bearing_6205, free), per * slips * WEIGHT / 1.5, rtol=1e-12)


def test_free_balls_roll_otherwise_by_conformity_and_by_the_orbit(bearing_6205: Bearing) -> None:
    """y^2/(2 r R) at the end of the longer contact, R of the deformed groove; orbits differ by the grooves' radii."""
    widths, angles = np.array([[[1.1e-3, 0.9e-3], [0.8e-3, 1.3e-3]]]), np.array([[[0.31, -0.37], [0.2, 0.3]]])
    radius, inner, outer = 3.97e-3, 4.13e-3, 4.21e-3
    conforms = max(1.1e-3**2 * (1 / inner + 1 / radius), 1.3e-3**2 * (1 / outer + 1 / radius)) / 2 / (2 * radius)
    wider = (outer - inner) / 2 * (1 - np.cos(0.37))
    expected = PER_CONFORMITY * conforms + PER_ORBIT * wider / (39.01e-3 / 2 - radius)
    found = balls_of(semi_axis_transverse=widths, angle=angles)
    np.testing.assert_allclose(rolls_otherwise(bearing_6205, found), expected, rtol=1e-9)  # of a sum of radii
    washers = replace(bearing_6205, kind="thrust")
    np.testing.assert_allclose(rolls_otherwise(washers, found), PER_CONFORMITY * conforms, rtol=1e-9)


def test_shares_of_some_points_count_more_between_them(bearing_6205: Bearing) -> None:
    """Of all points each has its own; of some the largest, times 1.25. Trials by rule say less of free balls."""
    ruled = ledger_of(bearing_6205, 3)
    free = Ledger(replace(ruled.scene, spin_rule="free"), 3)
    some, own = np.array([0.01, 0.03]), np.array([0.01, 0.03, 0.02])
    np.testing.assert_allclose(at_all_points(ruled, some), [1.25 * 0.03] * 3, rtol=1e-12)
    np.testing.assert_array_equal(at_all_points(ruled, own), own)
    np.testing.assert_allclose(left_out_at_all(ruled, own), 2.5 * own, rtol=1e-12)
    np.testing.assert_allclose(left_out_at_all(free, own), 6.0 * own, rtol=1e-12)


def tried(scene: Scene, known: dict[tuple[bool, bool], Solution], names: tuple[str, ...]) -> Trial:
    """A trial whose solutions are known: with all of `names`, and without the one that the key says."""
    count = len(next(iter(known.values())).points)
    model: object = None
    filled = {}
    for (all_count, judges), found in known.items():
        counted = dict.fromkeys(names, all_count)
        for method in (SINGLE_COEFFICIENT, OVER_ELLIPSE):
            filled[tuple(sorted(counted.items())), method, judges] = found
    return Trial(
        scene=scene,
        operation=scene.operation.as_series(),
        model=model,  # pyright: ignore[reportArgumentType]
        points=np.zeros((count, 5)),
        tried=np.arange(count),
        known=filled,
    )


def test_a_force_of_the_balls_counts_more_where_a_ball_is_lighter_than_at_any_tried_point(rich: Scene) -> None:
    """Point 7 is not tried, and its radial load leaves one ball with less load."""
    radial, speed = np.linspace(10.0, 45.0, 12), np.linspace(40.0, 44.0, 12)
    radial[7] = 800.0
    operation = Operation(axial_load=np.full(12, 310.0), radial_load=radial, inner_speed=speed)
    made = replace(trial_of(rich, operation.as_series(), None, NOMINAL), tried=np.array([0, 2, 5, 6, 8, 9, 10, 11]))
    found = made.under_load.points
    for name in ("centrifugal", "gyroscopic", "weight"):
        factor = made.further(name)
        most = found[f"{name}_share"][made.tried].max()
        expected = np.where(np.arange(12) == 7, found[f"{name}_share"] / most, 1.0)
        np.testing.assert_allclose(factor, expected, rtol=1e-12)
        assert expected[7] > 1.2
    found["weight_share"][[3, 7]] = np.nan, np.inf  # a point that does not settle, and one with a ball without load
    np.testing.assert_array_equal(made.further("weight"), np.where(np.arange(12) == 7, np.inf, 1.0))
    found["weight_share"][5] = np.inf  # tried
    assert made.further("weight") == 1.0
    assert made.further("finite_geometry") == 1.0
    assert replace(made, tried=np.arange(12)).further("centrifugal") == 1.0


def test_a_share_is_the_change_of_the_torque_over_it(bearing_6205: Bearing) -> None:
    """Of all together; by parts their changes add up by size."""
    base = balls_of(3, 1, of_spin=[2.0, 0.0, 0.0], of_rolling=[5.0, 0.0, 0.0])
    other = balls_of(3, 1, of_spin=[3.0, 0.0, 0.1], of_rolling=[4.5, 0.0, 0.0])
    trial_ = tried(dry(bearing_6205), {(True, False): base, (False, False): other}, ("hysteresis",))
    counted = {"hysteresis": True}
    np.testing.assert_allclose(trial_.share(counted, "hysteresis"), [0.5 / 7, 0.0, np.inf], rtol=1e-12)
    np.testing.assert_allclose(trial_.share_by_parts(counted, "hysteresis"), [1.5 / 7, 0.0, np.inf], rtol=1e-12)
    assert trial_.measure(counted)("hysteresis") == np.inf
    assert trial_.is_of_all


NAMES = ("asperities", "conformity", "gyroscopic", "load_distribution", "weight")


def test_what_a_trial_does_not_see_is_added_for_each_effect(bearing_6205: Bearing) -> None:
    """Balls slip across the grooves and under their weight, and lag behind; asperities are part of what holds them."""
    operation = Operation(axial_load=np.full(2, 300.0), inner_speed=np.ones(2), radial_load=np.array([40.0, 10.0]))
    ledger = ledger_of(bearing_6205, 2, operation=operation)
    given: dict[str, object] = {
        "load": 2.0,
        "friction_coefficient": 0.05,
        "gyroscopic_use": 0.02,
        "of_spin": 2.0,
        "of_rolling": 8.0,
        "of_rolling_force": 0.03,
        "of_most_friction": [0.2, 0.3],
        "angle": 0.3,
    }
    base = balls_of(2, 1, **given)
    smooth = balls_of(2, 1, **{**given, "friction_coefficient": 0.04})
    counted: dict[str, bool] = dict.fromkeys(NAMES, True)
    trial_ = tried(ledger.scene, {(True, True): base}, NAMES)
    without_ = tuple(sorted({**counted, "asperities": False}.items())), SINGLE_COEFFICIENT, True
    trial_.known[without_] = smooth
    vars(trial_)["under_thrust"] = vars(trial_)["under_load"] = base
    weight, gyroscopic = slip_by_weight(bearing_6205, base), np.full(2, 0.02 * PER_GYROSCOPIC_SLIP)
    unequal = unequal_loads(ledger.scene, operation, base)
    expected: dict[str, Array] = {
        "gyroscopic": gyroscopic,
        "weight": weight,
        "conformity": np.full(2, PER_LAG * 0.15),
        "load_distribution": PER_DISTRIBUTION * unequal * 0.15,
        "asperities": 0.2 * (gyroscopic + weight + 0.15),  # 0.01 of 0.05
        "hysteresis": np.zeros(2),
    }
    for name, change in expected.items():
        found = unseen_by_trial(ledger, trial_, counted, (name,))
        np.testing.assert_allclose(found, change, rtol=1e-12, err_msg=name)
    base.points["rolling_force"][1] = 0.0  # balls lag at the first point alone
    unlike = unseen_by_trial(ledger, trial_, counted, ("load_distribution",))
    np.testing.assert_allclose(unlike, expected["load_distribution"], rtol=1e-12)
    base.points["rolling_force"][1] = 0.03
    both = unseen_by_trial(ledger, trial_, counted, ("load_distribution", "weight"))
    np.testing.assert_allclose(both, expected["load_distribution"] + weight, rtol=1e-12)


def acting(scene: Scene) -> set[str]:
    return {name for name, counts in possible(scene).items() if counts}


def test_effects_that_have_nothing_to_act_on_are_no_trial(rich: Scene) -> None:
    """Thrust, standstill, a scene without oil or sliding, and what asks for an effect all the same."""
    auto = replace(rich, effects={})
    everything = set(TRIED)
    assert acting(auto) == everything
    still = replace(rich.operation, inner_speed=np.zeros(3))
    inertia = {"centrifugal", "gyroscopic"}
    assert acting(replace(auto, operation=still)) == everything - inertia
    assert acting(replace(auto, operation=still, effects={"gyroscopic": "on"})) == everything - {"centrifugal"}
    thrust = replace(rich.operation, radial_load=np.zeros(3), moment=np.zeros(3))
    assert acting(replace(auto, operation=thrust)) == everything - {"load_distribution"}
    assert acting(replace(auto, operation=thrust, effects={"load_distribution": "on"})) == everything
    alike = replace(auto, operation=thrust, down=None)
    assert acting(alike) == everything - {"load_distribution", "weight", "unloaded_balls"}
    asked = replace(alike, effects={"unloaded_balls": "on"})
    assert acting(asked) == everything - {"load_distribution", "weight"}
    inlets = {"inlet_heating", "starvation"}
    assert acting(without(auto, "spin", "conformity")) == everything - {"spin", "conformity", "asperities"}
    assert acting(without(auto, "spin")) == everything - {"spin"}
    assert acting(without(auto, "rolling")) == everything - {"rolling", "unloaded_balls"}
    nothing = without(auto, "rolling", "spin", "conformity")
    assert acting(nothing) == everything - {"rolling", "unloaded_balls", "spin", "conformity", "asperities"} - inlets
    given = replace(auto, friction_coefficient=0.06, surface=None)
    assert acting(given) == everything - {"asperities"}
    assert acting(without(given, "rolling")) == everything - {"asperities", "rolling", "unloaded_balls"} - inlets


def decided(scene: Scene, base: Solution, *, known: "Same | None" = None, has_factors: bool = False) -> Ledger:
    """The decisions of a scene whose trial is known; by default it changes nothing."""
    ledger = Ledger(scene, len(base.points))
    trial_ = Trial(
        scene=scene,
        operation=scene.operation.as_series(),
        model=None,  # pyright: ignore[reportArgumentType]
        points=np.zeros((len(base.points) + 1, 5)),  # more than are tried
        tried=np.arange(len(base.points)),
        known=Same(base) if known is None else known,
    )
    vars(trial_)["under_thrust"] = vars(trial_)["under_load"] = base
    decide_effects(ledger, trial_, base, has_factors=has_factors)
    return ledger


class Same(dict):  # pyright: ignore[reportMissingTypeArgument]
    """The same solution whatever counts, and another one where all of these effects are left out together."""

    def __init__(self, found: Solution, *without: str, other: Solution | None = None) -> None:
        self.found, self.other, self.without = found, other, without

    def __contains__(self, key: object) -> bool:
        return True

    def __getitem__(self, key: object) -> Solution:
        assert isinstance(key, tuple)
        left_out = {name for name, counts in key[0] if not counts}
        return self.other if self.other is not None and {*self.without} <= left_out else self.found


LOADED = {"load": 2.0, "friction_coefficient": 0.05, "asperity_share": 0.0, "of_spin": 2.0, "of_rolling": 8.0}


def test_what_changes_the_torque_by_more_than_half_of_the_tolerance_counts(rich: Scene) -> None:
    """2.5 times the change by trial, whose balls slide by one coefficient."""
    scene = replace(rich, effects={}, tolerance=0.04)
    for change, is_on in ((0.079, False), (0.081, True)):  # of 10: 2.5 times as much may be 2 %
        other = balls_of(3, 2, **{**LOADED, "of_rolling": 8.0 + change})
        base = balls_of(3, 2, **LOADED)
        ledger = decided(scene, base, known=Same(base, "hysteresis", other=other))
        assert ledger.is_on("hysteresis") == is_on
        assert not ledger.is_on("centrifugal")


def test_a_radial_load_is_tried_together_with_the_weight_that_its_ring_has(rich: Scene) -> None:
    """Both leave out a ring of all balls; where the ring is there, both are computed."""
    scene = replace(rich, effects={}, tolerance=0.04)
    base, other = balls_of(3, 2, **LOADED), balls_of(3, 2, **{**LOADED, "of_rolling": 9.0})
    both = decided(scene, base, known=Same(base, "load_distribution", "weight", other=other))
    assert both.is_on("load_distribution")
    alone = decided(scene, base)
    assert not alone.is_on("load_distribution")
    assert alone.made["weight"].reason == "neglected with load_distribution, whose share includes it"
    assert not alone.is_on("weight")
    asked = decided(replace(scene, effects={"weight": "on"}), base)
    assert asked.made["load_distribution"].reason == "computed together with the weight"
    inertia = decided(scene, base, known=Same(base, "centrifugal", "weight", other=other))
    assert not inertia.is_on("centrifugal")  # which is tried by itself


def test_what_an_effect_has_nothing_to_act_on_is_said(rich: Scene) -> None:
    still = Operation(axial_load=np.full(3, 300.0), inner_speed=np.zeros(3))
    scene = without(replace(rich, operation=still.as_series(), effects={}, down=None), "spin", "conformity", "rolling")
    made = decided(scene, balls_of(3, 1, **LOADED)).made
    for name, words in (
        ("load_distribution", "pure thrust: equal ball loads"),
        ("centrifugal", "no rotation"),
        ("gyroscopic", "no rotation"),
        ("asperities", 'no sliding without spin and conformity: give effects.conformity = "auto"'),
        ("starvation", 'nothing slides or rolls in oil: give effects.rolling = "auto"'),
        ("unloaded_balls", "every ball carries load"),
    ):
        assert (made[name].decision, made[name].reason, made[name].share) == ("off", words, 0.0)


def test_given_factors_take_the_place_of_the_fit_for_finite_geometry(rich: Scene) -> None:
    scene, base = replace(rich, effects={}), balls_of(3, 2, **LOADED)
    given, fitted = (decided(scene, base, has_factors=each).made for each in (True, False))
    assert given["finite_geometry"].reason == "factors on the contacts given in the call"
    assert (fitted["finite_geometry"].decision, fitted["finite_geometry"].reason) == ("off", "no effect here")
    assert given["hysteresis"].decision == "off"
    off = decided(without(scene, "hysteresis"), base, known=Same(base, other=balls_of(3, 2, **LOADED)))
    assert off.made["hysteresis"].share == 0.0
    # an effect of the oil that is off, and would have nothing to act on, is not tried
    nothing = without(scene, "rolling", "spin", "conformity", "starvation")
    found = decided(
        nothing, base, known=Same(balls_of(3, 2, **{**LOADED, "of_rolling": 9.0}), "starvation", other=base)
    )
    assert found.made["starvation"].share == 0.0


def test_changes_by_conformity_are_tried_by_the_ellipse(bearing_6205: Bearing) -> None:
    base, along = balls_of(2, 1, of_spin=2.0), balls_of(2, 1, of_spin=3.0)
    trial_ = tried(dry(bearing_6205), {(True, True): base, (False, False): base}, ("conformity",))
    trial_.known[(("conformity", False),), OVER_ELLIPSE, False] = along
    np.testing.assert_allclose(trial_.share({"conformity": True}, "conformity"), 0.0)
    np.testing.assert_allclose(trial_.share_by_parts({"conformity": True}, "conformity"), 0.5)


def test_asperities_count_from_the_tolerance_on(rich: Scene) -> None:
    scene = replace(rich, effects={}, tolerance=0.02)
    for share, decision in ((0.019, "off"), (0.021, "on")):
        base = balls_of(3, 2, load=2.0, friction_coefficient=0.05, asperity_share=[[[0.0, share]] * 2] * 3, of_spin=2.0)
        made = decided(scene, base).made["asperities"]
        assert made.decision == decision
        assert ("asperities carry up to 2.1 % of a contact's load" in made.reason) == (decision == "on")


def test_balls_that_lead_through_half_of_their_pockets_count(rich: Scene) -> None:
    """0.2 mm of free clearance: a lead of more than 0.1 mm squeezes the cage, if there is one that counts."""
    scene = replace(rich, effects={}, cage=STAMPED_CAGE)
    for lead, effects, cage, is_on in (
        (0.101e-3, {}, STAMPED_CAGE, True),
        (-0.101e-3, {}, STAMPED_CAGE, True),
        (0.099e-3, {}, STAMPED_CAGE, False),
        (0.101e-3, {"cage": "off"}, STAMPED_CAGE, False),
        (0.101e-3, {}, None, False),
    ):
        base = balls_of(3, 2, load=2.0, friction_coefficient=0.05, of_spin=2.0, of_ball_lead=lead)
        ledger = decided(replace(scene, effects=effects, cage=cage), base)
        assert ledger.is_on("load_distribution") == is_on, (lead, effects)
        told = "ball lead up to 0.101 mm, free clearance of the pockets 0.2 mm"
        assert (ledger.made["load_distribution"].reason == told) == is_on


def test_an_effect_without_its_input_has_the_bound_of_what_acts_on_a_ball(rich: Scene) -> None:
    given = replace(rich, contact_angle=ContactAngle(rule="given", value=0.3), effects={}, down=None)
    base = balls_of(
        3, 1, load=2.0, friction_coefficient=0.05, of_spin=2.0, angle=0.3,
        of_centrifugal_share=[0.01, 0.02, 0.0], of_gyroscopic_share=[0.03, 0.0, 0.0], of_weight_share=[0.0, 0.04, 0.0],
    )  # fmt: skip
    made = decided(given, base).made
    unequal = unequal_loads(given, given.operation, base)
    for name, share in (
        ("centrifugal", PER_CENTRIFUGAL * 0.02),
        ("gyroscopic", 0.03),
        ("weight", PER_CENTRIFUGAL * 0.04),
        ("load_distribution", PER_DISTRIBUTION * unequal.max()),
    ):
        assert made[name].decision == "off"
        assert made[name].share == pytest.approx(share, rel=1e-12), name
    assert made["asperities"].reason == "no effect here"
    assert made["unloaded_balls"].share is None


def shares(found: FrictionTorque) -> dict[str, float | None]:
    return {effect.name: effect.share for effect in found.effects}


def share_of(found: FrictionTorque, name: str) -> float:
    return present(shares(found)[name])


def under_thrust(scene: Scene) -> Scene:
    operation = replace(scene.operation, radial_load=np.zeros(3), moment=np.zeros(3))
    return without(replace(scene, operation=operation), "load_distribution")


@pytest.mark.parametrize("name", sorted(set(TRIED) - {"unloaded_balls"}))  # here every ball is loaded
def test_an_effect_changes_the_torque_by_its_stated_share(rich: Scene, name: str) -> None:
    """Where it counts, and where the scene leaves it out."""
    for scene in (rich, under_thrust(rich)):
        if scene.effects[name] == "off":
            continue
        having, lacking = friction_torque(scene), friction_torque(without(scene, name))
        ratio = having.torque.total / lacking.torque.total
        assert np.abs(ratio - 1).max() > 1e-6  # far above round-off: the effect acts
        np.testing.assert_allclose(share_of(lacking, name), np.abs(ratio - 1).max(), rtol=SAME, atol=SAME)
        if name not in HAVE_PARTS:
            np.testing.assert_allclose(share_of(having, name), np.abs(1 / ratio - 1).max(), rtol=SAME, atol=SAME)


@pytest.mark.parametrize("name", HAVE_PARTS)
def test_what_slides_is_stated_by_its_part(rich: Scene, name: str) -> None:
    found = friction_torque(rich)
    part = np.asarray(getattr(found.torque, name)) / found.torque.total
    np.testing.assert_allclose(share_of(found, name), part.max(), rtol=SAME)


@pytest.mark.parametrize("points", [1, 2, FAR])
def test_few_points_compute_every_effect(bearing_6205: Bearing, points: int) -> None:
    scene = replace(idling(bearing_6205), down=(0.0, 0.6, 0.8))
    few = {name: getattr(scene.operation, name)[:points] for name in ("axial_load", "inner_speed")}
    aside = Operation(**few, radial_load=np.full(points, 0.3))
    found = friction_torque(replace(scene, tolerance=0.9, operation=aside))  # at which trial would leave all out
    on = {name for name in TRIED if found.is_on(name)}
    assert on == set(TRIED) - {"load_distribution", "weight"}  # which would cost a ring of all balls
    assert {effect.reason for effect in found.effects if effect.name in on} == {FEW}
    ring = friction_torque(replace(scene, operation=aside, tolerance=1e-7))  # nothing fits into it
    assert all(ring.is_on(name) for name in TRIED)


def test_a_longer_series_decides(bearing_6205: Bearing) -> None:
    scene = idling(bearing_6205)
    assert scene.operation.inner_speed.size == FAR + 1
    loose, strict = (friction_torque(replace(scene, tolerance=tolerance)) for tolerance in (0.9, 1e-9))
    assert {name for name in TRIED if loose.is_on(name)} <= {"rolling", "hysteresis"}  # nearly all of the torque
    assert loose.is_on("rolling")
    # No radial load, no direction, a finish far below the film, no ball without load
    idle = {"load_distribution", "weight", "asperities", "unloaded_balls"}
    assert {name for name in TRIED if strict.is_on(name)} == set(TRIED) - idle


def test_changes_of_spin_alone_are_tried_by_the_ellipse(rich: Scene) -> None:
    """Of both together one coefficient shows the change, since their torque follows the creep in second order."""
    assert method_of_changes(rich) == SINGLE_COEFFICIENT
    assert method_of_changes(replace(rich, effects={**rich.effects, "conformity": "off"})) == OVER_ELLIPSE


def test_asperities_that_carry_load_count_whatever_they_change(bearing_6205: Bearing) -> None:
    """Half of the load on asperities that resist as the oil does: else film and share would not be the contact's."""
    rough = replace(FINISH, rms_roughness=0.1e-6, boundary_friction=0.02)
    scene = replace(idling(bearing_6205), surface=rough)
    found = friction_torque(scene)
    asperities = next(effect for effect in found.effects if effect.name == "asperities")
    assert asperities.decision == "on"
    assert present(asperities.share) < scene.tolerance / 2  # which trial alone would leave out
    assert np.all(present(found.asperity_share.inner) > scene.tolerance)
    assert "asperities carry up to" in asperities.reason


def points_of(scene: Scene, chosen: NDArray[np.intp]) -> Operation:
    return scene.operation.as_series().at(chosen)


def spread(scene: Scene, seed: int, count: int) -> Scene:
    """The scene at unlike points: 1.5 decades of load, two of speed; radial loads on some where there were any."""
    random = np.random.default_rng(seed)
    load, speed = 10 ** random.uniform(1.6, 3.1, count), 10 ** random.uniform(0.3, 2.4, count)
    if scene.bearing.kind == "thrust":
        load, speed = 3 * load, speed / 10
    aside = 0.0 if scene.operation.is_thrust else load * random.uniform(0, 1.7, count) * (random.random(count) < 0.6)
    return replace(scene, operation=Operation(axial_load=load, inner_speed=speed, radial_load=aside))


def assert_auto_meets_everything_on(scene: Scene) -> None:
    """Auto is within its uncertainty, whatever it leaves out."""
    found = friction_torque(scene)
    whole = friction_torque(replace(scene, tolerance=1e-7))  # into which nothing fits
    error = np.abs(found.torque.total / whole.torque.total - 1)
    assert np.all(error <= found.numerical_uncertainty + whole.numerical_uncertainty)


LONG = 105, 111  # with all inputs, as 104 and 110, and slower


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=pytest.mark.nightly if seed in LONG else ()) for seed in range(100, 112)]
)
def test_auto_meets_everything_on_in_scenes_of_all_kinds(seed: int) -> None:
    scene = replace(drawn_scene(seed), tolerance=0.05, spin_rule="balanced")
    assert_auto_meets_everything_on(spread(scene, seed, 10 + seed % 9))


@pytest.mark.parametrize("seed", range(60, 66))
def test_auto_meets_everything_on_where_balls_turn_freely(bearing_6205: Bearing, seed: int) -> None:
    """Under thrust, whose free balls take little time; their creep has to settle to a tenth of the tolerance."""
    ruled = drawn(bearing_6205, np.random.default_rng(seed), points=12)
    thrust = replace(ruled.operation, radial_load=np.zeros(12))
    free = replace(ruled, tolerance=0.05, spin_rule="free", sliding="auto", effects={}, operation=thrust)
    found, whole = friction_torque(free), friction_torque(replace(free, tolerance=5e-3))
    error = np.abs(found.torque.total / whole.torque.total - 1)
    assert np.all(error <= found.numerical_uncertainty + whole.numerical_uncertainty)


@pytest.mark.parametrize("seed", range(3))
def test_a_point_has_its_torque_in_any_series(bearing_6205: Bearing, seed: int) -> None:
    """Of so many points each thread has some; few are solved by one."""
    random = np.random.default_rng(700 + seed)
    scene = drawn(bearing_6205, random, points=150)
    scene = friction_torque(scene).settled(scene)
    whole = friction_torque(scene).torque.total
    for chosen in (random.permutation(150), np.arange(17, 40), np.array([23]), np.array([5, 5, 131])):
        found = friction_torque(replace(scene, operation=points_of(scene, chosen)))
        np.testing.assert_allclose(found.torque.total, whole[chosen], rtol=SAME)


@pytest.mark.parametrize("seed", range(4))
def test_neither_order_nor_direction_changes_what_auto_decides(bearing_6205: Bearing, seed: int) -> None:
    random = np.random.default_rng(800 + seed)
    scene = replace(drawn(bearing_6205, random, points=26), tolerance=0.05, effects={}, sliding="auto")
    order = random.permutation(26)
    mixed = points_of(scene, order)
    found, other = (
        friction_torque(scene),
        friction_torque(replace(scene, operation=replace(mixed, inner_speed=-mixed.inner_speed))),
    )
    assert other.effects.decisions == found.effects.decisions
    assert other.sliding == found.sliding
    np.testing.assert_allclose(other.torque.total, found.torque.total[order], rtol=SAME)


@pytest.mark.parametrize("unlike", [(0.02, 0.0), (0.0, 300.0)])
def test_one_point_changes_no_other(rich: Scene, unlike: tuple[float, float]) -> None:
    """A light one, which trials see, and one under a radial load alone, which asks for a ring."""
    random = np.random.default_rng(8)
    load, speed = random.uniform(60, 1900, 40), random.uniform(3, 240, 40)
    thrust = Operation(axial_load=load, inner_speed=speed, radial_load=np.zeros(40))
    load, aside = load.copy(), np.zeros(40)
    load[19], aside[19] = unlike
    one = Operation(axial_load=load, inner_speed=speed, radial_load=aside)
    # Weight would load all balls unlike at every point.
    alike, mixed = (friction_torque(replace(without(rich, "weight"), operation=each)) for each in (thrust, one))
    others = np.arange(40) != 19
    np.testing.assert_allclose(mixed.torque.total[others], alike.torque.total[others], rtol=SAME)
    assert abs(mixed.torque.total[19] / alike.torque.total[19] - 1) > 0.1


@pytest.mark.parametrize(("power", "lean"), [(1.0, 0.02), (1.0, 0.04), (1.0, 0.09)])
def test_friction_across_the_grooves_softens_a_ball_as_in_the_triangle_of_centres(
    bearing_6205: Bearing, power: float, lean: float
) -> None:
    """By the change of the distance of the groove centres with the load, for a lean as the load to a power.

    A ball, both centres of curvature and two springs: the centres are apart as the third side of a triangle.
    """
    inner, outer = (
        groove.groove_radius - bearing_6205.ball_radius for groove in (bearing_6205.inner, bearing_6205.outer)
    )
    softness, load = (4.1e-7, 3.7e-7), 2.3  # m/N^(2/3), N

    def approaches(force: float) -> tuple[float, float]:
        return softness[0] * force ** (2 / 3), softness[1] * force ** (2 / 3)

    def distance(force: float, lean: float) -> float:
        arms = inner + approaches(force)[0], outer + approaches(force)[1]
        angle = 2 * lean * (force / load) ** power
        return float(np.sqrt(arms[0] ** 2 + arms[1] ** 2 + 2 * arms[0] * arms[1] * np.cos(angle)))

    step = 1e-3 * load
    soft, bare = (distance(load + step, each) - distance(load - step, each) for each in (lean, 0.0))
    expected = bare / soft if soft > 0 else np.inf
    balls, straight = (np.zeros((1, 1), BALL) for _ in range(2))
    for each, angles in ((straight, (0.31, 0.31)), (balls, (0.31 + lean, 0.31 - lean))):
        each["load"], each["approach"], each["angle"] = load, approaches(load), angles
    (found,) = growth_by_wedging(
        bearing_6205, *(Solution(points=np.zeros(1, POINT), balls=each) for each in (straight, balls))
    )
    np.testing.assert_allclose(found, expected, rtol=0.02)  # the arms are longer than l by the approach, 1 % of them
    assert (found == np.inf) == (lean == 0.09)
    assert found > 1.05


def test_balls_are_wedged_by_their_loads(bearing_6205: Bearing) -> None:
    """A ball of twice the load counts twice, and one that its own force presses on a race by the other race alone."""

    def growth(loads: list[tuple[float, float]], leans: list[float], approaches: list[float]) -> Array:
        balls, straight = (np.zeros((1, len(loads)), BALL) for _ in range(2))
        lean = np.array(leans)[:, None] * [1.0, -1.0]
        for each, angles in ((balls, 0.31 + lean), (straight, 0.31)):
            each["load"], each["angle"] = loads, angles
            each["approach"] = np.array(approaches)[:, None] * [0.6, 0.4]
        solutions = (Solution(points=np.zeros(1, POINT), balls=each) for each in (straight, balls))
        return growth_by_wedging(bearing_6205, *solutions)

    once = growth([(2.0, 2.0), (4.0, 4.0)], [0.02, 0.01], [1.3e-6, 1.9e-6])
    twice = growth([(2.0, 2.0)] * 3, [0.02, 0.01, 0.01], [1.3e-6, 1.9e-6, 1.9e-6])
    np.testing.assert_allclose(once, twice, rtol=1e-12)
    assert once > 1.01
    pressed = growth([(2.0, 5.0), (4.0, 4.0)], [0.02, 0.01], [1.3e-6, 1.9e-6])
    np.testing.assert_allclose(pressed, once, rtol=1e-12)
    np.testing.assert_array_equal(growth([(0.0, 0.0)], [0.02], [0.0]), 1.0)  # nothing presses a ball


@pytest.mark.parametrize(
    ("inner_radius", "angle", "load", "needed"),
    [
        pytest.param(4.9e-3, 0.6, 2.0, "PER_ORBIT", id="grooves of unlike radii"),
        pytest.param(4.13e-3, 0.02, 900.0, "PER_CONFORMITY", id="a long contact"),
    ],
)
def test_how_fast_free_balls_roll_is_bounded(
    bearing_6205: Bearing, monkeypatch: pytest.MonkeyPatch, inner_radius: float, angle: float, load: float, needed: str
) -> None:
    """Without creep and inertia, and with friction enough, balls by rule differ from free ones by this alone."""
    scene = Scene(
        name="slow",
        tolerance=1e-6,
        bearing=replace(bearing_6205, inner=replace(bearing_6205.inner, groove_radius=inner_radius)),
        contact_angle=ContactAngle(rule="given", value=angle),
        operation=Operation(axial_load=np.array([load * np.sin(angle)]), inner_speed=np.array([0.3])),
        friction_coefficient=0.02,
        effects=dict.fromkeys(("creep", "centrifugal", "gyroscopic", "weight"), "off"),
    )
    ruled, free = (friction_torque(replace(scene, sliding=method)) for method in ("over_ellipse", "free_ball"))
    error = ruled.numerical_uncertainty[0] + free.numerical_uncertainty[0]
    apart = abs(free.torque.total[0] / ruled.torque.total[0] - 1) - error
    balls = trial_of(scene, scene.operation.as_series(), None, NOMINAL).under_thrust
    (bound,) = rolls_otherwise(scene.bearing, balls)
    assert 0 < apart < bound < 20 * apart
    monkeypatch.setattr(trial, needed, 0.0)
    (other,) = rolls_otherwise(scene.bearing, balls)
    assert other < apart  # each part is needed
