"""The table of effects is complete whatever the scene says, and `on` is never without consequence or refusal."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects.ledger import Effect, Effects, Ledger, share_in, size_of
from analytic.effects.table import CHOSEN, ENTRIES, LIMITS, TRIED
from analytic.errors import InputError
from analytic.result import FrictionTorque
from analytic.scene import Bearing, Scene
from analytic.torque import friction_torque
from tests.analytic.specimens import STAMPED_CAGE, drawn, dry, idling, part

# A bound of less than this on the share of an effect may leave the total as it is, to the last digit.
NEXT_TO_NOTHING = 1e-9


def scene_of(bearing: Bearing, random: np.random.Generator) -> Scene:
    """A random scene with a random word on each effect; a cage that moves crosses its pockets once."""
    words: dict[str, Any] = {name: ("auto", "on", "off")[random.integers(3)] for name in CHOSEN}
    scene = replace(
        drawn(bearing, random, 2),
        tolerance=10 ** random.uniform(-3, -1),
        cage=STAMPED_CAGE if random.random() < 0.9 else None,
        effects=words,
    )
    start = ("rest", "ramp", "sudden", "whirl", None)[random.integers(5)]
    moving = replace(STAMPED_CAGE, start=start, seeds=2, duration=0.007)
    return scene if scene.cage is None else replace(scene, cage=moving)


def computed(scene: Scene) -> tuple[Scene, FrictionTorque]:
    """The torque; every refusal must name an effect that the scene says on, which is then left to auto."""
    for _ in range(len(CHOSEN) + 1):
        try:
            return scene, friction_torque(scene)
        except InputError as problem:
            words = str(problem)
        refused = re.match(r'effects\.(\w+) = "on" is refused: \w', words)
        assert refused, words
        name = refused.group(1)
        assert scene.effects[name] == "on"
        scene = replace(scene, effects={**scene.effects, name: "auto"})
    raise AssertionError("more refusals than effects")


MOVING = 4, 16  # as seed 2, with balls and cage in motion
MOTIONS = "cage_dynamics", "ball_dynamics"


@pytest.mark.parametrize(
    "seed", [pytest.param(seed, marks=pytest.mark.nightly if seed in MOVING else ()) for seed in range(24)]
)
def test_every_effect_is_settled_and_none_is_ignored(bearing_6205: Bearing, seed: int) -> None:
    scene, result = computed(scene_of(bearing_6205, np.random.default_rng(71_000 + seed)))
    effects = {effect.name: effect for effect in result.effects}
    assert list(effects) == list(ENTRIES)
    whole = result.settled(scene)
    still = replace(whole, effects={**whole.effects, **dict.fromkeys(MOTIONS, "off")})  # motions take the most time
    _, resting = computed(still)
    for name, word in scene.effects.items():
        assert word in ("auto", effects[name].decision)
        share = effects[name].share
        assert effects[name].decision == "on" or share is None or ENTRIES[name].bound or name in TRIED, name
        if word == "on" and np.any(result.torque.total) and not (share is not None and share < NEXT_TO_NOTHING):
            of_cage = name in ("cage", *MOTIONS)
            decided, total = (whole, result.torque.total) if of_cage else (still, resting.torque.total)
            without = {**decided.effects, name: "off"}
            if name == "centrifugal":  # balls that nothing else presses cannot drive the cage
                without |= dict.fromkeys(("cage", *MOTIONS), "off")
            _, other = computed(replace(decided, effects=without))
            assert np.any(other.torque.total != total), name


def test_without_sliding_the_inlets_act_on_rolling(bearing_6205: Bearing) -> None:
    """At 200 rad/s and 0.043 Pa s each factor takes a visible part of the rolling torque."""
    still: dict[str, Any] = {"spin": "off", "conformity": "off"}
    scene = idling(bearing_6205)
    fast = replace(scene, operation=replace(scene.operation, inner_speed=np.linspace(150.0, 200.0, 9)))
    off = friction_torque(replace(fast, effects=still | {"inlet_heating": "off", "starvation": "off"}))
    assert list(off.effects.decisions) == list(ENTRIES)
    for name in ("inlet_heating", "starvation"):
        others = {"inlet_heating": "off", "starvation": "off"} | {name: "on"}
        on = friction_torque(replace(fast, effects=still | others))
        assert on.effects.decisions[name] == "on"
        assert np.all(np.asarray(on.torque.rolling) < 0.999 * np.asarray(off.torque.rolling))
        # It does the same to rolling in a scene whose balls slide.
        sliding = friction_torque(replace(fast, effects={"finite_geometry": "off", "asperities": "off"} | others))
        np.testing.assert_allclose(part(on.torque, "rolling"), part(sliding.torque, "rolling"), rtol=1e-12)  # round-off


def test_a_motion_of_a_cage_that_is_left_out_is_refused(bearing_6205: Bearing) -> None:
    scene = scene_of(bearing_6205, np.random.default_rng(5))
    assert scene.cage is not None
    words: dict[str, Any] = {"cage": "off", "cage_dynamics": "on"}
    with pytest.raises(InputError, match='cage_dynamics = "on" is refused: the cage is neglected'):
        friction_torque(replace(scene, effects=words))


def test_without_conformity_spin_is_not_measured_against_it(bearing_6205: Bearing) -> None:
    """Spin is then the only part of the torque: leaving it out would leave nothing."""
    scene = replace(dry(bearing_6205), effects={"hysteresis": "off", "conformity": "off"})
    assert friction_torque(scene).effects.decisions["spin"] == "on"


def test_finite_geometry_far_beyond_its_fit_is_not_applied(bearing_6205: Bearing) -> None:
    """Grooves as narrow as these end within the contacts, where no fit holds; what that leaves out is uncertain."""
    rings = {name: replace(getattr(bearing_6205, name), shoulder_half_width=1.5e-3) for name in ("inner", "outer")}
    scene = replace(dry(replace(bearing_6205, **rings)), effects={})
    hertz = friction_torque(replace(scene, effects={"finite_geometry": "off"}))
    for effects in ({}, {"finite_geometry": "on"}):
        found = friction_torque(replace(scene, effects=effects))
        effect = next(effect for effect in found.effects if effect.name == "finite_geometry")
        assert effect.decision == "off"
        assert effect.reason.startswith("not applied: inner: ")
        np.testing.assert_allclose(found.torque.total, hertz.torque.total, rtol=1e-12)  # round-off
        assert np.all(found.numerical_uncertainty > hertz.numerical_uncertainty + 0.01)


def test_the_effects_print_as_lines_in_words(bearing_6205: Bearing) -> None:
    effects = friction_torque(dry(bearing_6205)).effects
    lines = str(effects).splitlines()
    assert len(lines) == len(effects)
    assert lines[0].startswith(f"{effects[0].name}: {effects[0].decision}, ")
    assert repr(effects).startswith("Effects(")
    assert "object at" not in f"{effects}{effects!r}"


def test_the_size_of_an_effect_in_words() -> None:
    for share, words in (
        (0.034, "up to 3.4 % of the torque"),
        (1.0, "up to 100 % of the torque"),
        (1.01, "larger than the torque"),
        (np.inf, "no bound known"),
    ):
        assert size_of(share) == words


def test_a_share_of_no_torque_is_none() -> None:
    np.testing.assert_array_equal(share_in(np.array([3.0, 0.0, 2.0]), np.array([12.0, 0.0, 0.0])), [0.25, 0.0, 0.0])


def test_an_effect_is_decided_by_words_before_its_size(bearing_6205: Bearing) -> None:
    """What lacks its input, then off, then what makes it impossible, then on, then what demands it, then the size."""
    words: dict[str, Any] = {"hysteresis": "off", "spin": "on"}
    ledger = Ledger(replace(dry(bearing_6205), effects=words, tolerance=0.1), 2)
    small, large = np.array([0.01, 0.02]), np.array([0.01, 0.2])
    cases: list[tuple[str, dict[str, Any], str, str]] = [
        ("rolling", {"bound": small}, "off", "no lubricant is given"),
        ("hysteresis", {"demanded": "always"}, "off", "off in the scene; size not computed"),
        ("hysteresis", {"bound": large}, "off", "off in the scene"),
        ("conformity", {"lacks": "nothing slides", "demanded": "always"}, "off", "nothing slides"),
        ("spin", {"bound": small, "demanded": "always"}, "on", "on in the scene"),
        ("conformity", {"bound": small, "demanded": "always"}, "on", "always"),
        ("conformity", {}, "on", "always computed: no cheap bound"),
        ("conformity", {"bound": small}, "off", "up to 2 % of the torque, within the budget of 5 %"),
        ("asperities", {"bound": np.array([0.3, 1.2])}, "off", "coefficient is given"),
        ("finite_geometry", {"bound": np.array([0.3, 1.2])}, "on", "larger than the torque"),
    ]
    for name, given, decision, reason in cases:
        assert ledger.decide(name, **given) == (decision == "on")
        made = ledger.made[name]
        assert made.decision == decision
        assert reason in made.reason, name
    assert ledger.made["finite_geometry"].share == 1.2
    assert ledger.rules_out("hysteresis")
    assert not ledger.rules_out("spin")
    ledger.not_applied("spin", "beyond its fit")
    assert (ledger.is_on("spin"), ledger.made["spin"].reason) == (False, "beyond its fit")
    with pytest.raises(InputError, match='spin = "on" is refused: why'):
        ledger.settle("spin", on=False, reason="why")


def test_a_budget_is_spent_at_each_point_by_itself(bearing_6205: Bearing) -> None:
    ledger = Ledger(replace(dry(bearing_6205), tolerance=0.1), 3)
    np.testing.assert_array_equal(ledger.leaves_out_at(np.array([0.05, 0.06, 0.03])), [True, False, True])
    np.testing.assert_array_equal(ledger.left_out, [0.05, 0.0, 0.03])
    assert not ledger.leaves_out(np.array([0.0, 0.0, 0.03]))
    assert ledger.leaves_out(np.array([0.0, 0.05, 0.0]))
    np.testing.assert_allclose(ledger.left_out, [0.05, 0.05, 0.03], rtol=1e-15)


def test_what_nobody_models_cannot_be_on(bearing_6205: Bearing) -> None:
    for name in LIMITS:
        scene = dry(bearing_6205)
        Ledger(replace(scene, effects={name: "off"}), 1)
        words: dict[str, Any] = {name: "on"}
        with pytest.raises(InputError, match=f'effects.{name} = "on" is refused: not modelled'):
            Ledger(replace(scene, effects=words), 1)


def test_shares_by_trial_are_measured_when_they_are_read() -> None:
    made = {
        "spin": Effect(name="spin", decision="on", share=0.5, reason="a part"),
        "rolling": Effect(name="rolling", decision="on", share=None, reason="tried"),
        "weight": Effect(name="weight", decision="off", share=0.01, reason="small"),
    }
    asked: list[str] = []

    def measure(name: str) -> float:
        asked.append(name)
        return 0.25

    effects = Effects(made, measure, frozenset({"rolling", "weight"}))
    assert (len(effects), effects.decisions) == (3, {"spin": "on", "rolling": "on", "weight": "off"})
    assert repr(effects) == "Effects(2 of 3 on: spin, rolling)"
    assert not asked
    assert [each.share for each in effects] == [0.5, 0.25, 0.01]
    assert asked == ["rolling"]
    assert [each.share for each in Effects(made, None, frozenset({"rolling"}))] == [0.5, None, 0.01]
