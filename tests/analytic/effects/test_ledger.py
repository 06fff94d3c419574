"""The table of effects is complete whatever the scene says, and `on` is never without consequence or refusal."""

import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from analytic.effects.table import CHOSEN, ENTRIES, TRIED
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
