"""Nouns refuse words that they do not know: a wrong word would choose another formula without a sign."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Literal

import numpy as np
import pytest

from analytic.declared import Noun, declarations, nothing
from analytic.scene import Scene
from tests.analytic.specimens import BEARING_6205, FINISH, OIL, thrust
from tests.refusals import refused

SCENE = Scene(bearing=BEARING_6205, operation=thrust(310.0, 89.0), friction_coefficient=0.08)


@pytest.mark.parametrize(
    ("noun", "changed", "words"),
    [
        (OIL, {"rolling_formula": "Houpert"}, ('must be "numerical", "biboulet" or "houpert", got \'Houpert\'',)),
        (OIL, {"supply": None}, ('"grease", got None',)),
        (OIL, {"traction": "x"}, ('"eyring_sinh", "eyring_constant" or OwnTraction, got',)),
        (FINISH, {"asperities": ["greenwood_williamson"]}, ("got ['greenwood_williamson']",)),
        (BEARING_6205, {"grade": "a"}, ('"C", "D" or None, got \'a\'',)),
        (SCENE, {"spin_rule": {"free": 2}}, ("got {'free': 2}",)),
    ],
)
def test_an_unknown_word_is_refused_with_those_that_are_known(noun: Any, changed: dict, words: tuple[str, ...]) -> None:
    (name,) = changed
    refused(lambda: replace(noun, **changed), f"{type(noun).__name__}.{name} must be ", *words)


@pytest.mark.parametrize("wrong", ["Off", "OFF", "maybe", False, None])
def test_a_decision_on_an_effect_is_a_known_word(wrong: Any) -> None:
    effects = {"hysteresis": "on", "rolling": wrong}
    refused(
        lambda: replace(SCENE, effects=effects),
        f'Scene.effects.rolling must be "auto", "on" or "off", got {wrong!r}',
    )


@pytest.mark.parametrize("wrong", ["off", None, ["rolling"]])
def test_effects_are_a_mapping(wrong: Any) -> None:
    refused(lambda: replace(SCENE, effects=wrong), "Scene.effects must be a mapping of names to", f"got {wrong!r}")


Colour = Literal["red", "green"]


@dataclass(frozen=True, kw_only=True)
class Painted(Noun):
    """Annotations as texts, and a word that stands alone."""

    colour: "Colour | None" = None
    coats: "Mapping[str, Colour]" = field(default_factory=nothing)
    finish: "Literal['matt']" = "matt"
    name: str = "any word"


def test_annotations_may_be_texts() -> None:
    assert [name for name, said in declarations(Painted).items() if said.kind] == ["colour", "coats", "finish"]
    assert Painted(colour="red", coats={"first": "green"}, name="other").colour == "red"
    wrong: Any = "blue"
    refused(lambda: Painted(colour=wrong), 'Painted.colour must be "red", "green" or None, got \'blue\'')
    refused(lambda: Painted(coats={"first": wrong}), 'Painted.coats.first must be "red" or "green", got')
    refused(lambda: Painted(finish=wrong), "Painted.finish must be \"matt\", got 'blue'")


def test_a_notebook_shows_inputs_with_their_units_and_meanings() -> None:
    text = replace(
        SCENE, name="a <b>", operation=replace(SCENE.operation, inner_speed=np.array([3.7, 89.0]))
    )._repr_html_()
    assert "<td>a &lt;b&gt;</td>" in text
    assert f"<td>operation.inner_speed</td><td>{3.7 * 30 / np.pi:g} to {89 * 30 / np.pi:g} rpm</td>" in text
    assert (
        f"<td>bearing.ball_diameter</td><td>{BEARING_6205.ball_diameter * 1e3:g} mm</td><td>of every ball, D</td>"
        in text
    )
