"""The page of the effects lists those of the code. `python -m tests.analytic.effects.test_table` writes it anew."""

import re
from dataclasses import replace
from pathlib import Path
from textwrap import wrap
from typing import Any

import pytest

from analytic.effects.table import ENTRIES, TABLE, Entry, ruled
from analytic.scene import Bearing, ContactAngle, Losses, Scene, ShearedLand, ShearedPockets
from tests.analytic.specimens import OIL, STAMPED_CAGE, idling

PAGE = Path(__file__).parents[3] / "docs" / "effects.md"
COMMAND = "python -m tests.analytic.effects.test_table"
WIDTH = 120  # columns of a page


def item(entry: Entry) -> str:
    """An effect in the list of the page."""
    parts = [f"`{entry.name}`: {entry.meaning}"]
    if entry.needs is not None:
        parts.append(f"needs {entry.needs.keys}")
    if entry.kind == "limit":
        parts.append(f"limit: {entry.bound}")
    lines = wrap("; ".join(parts), WIDTH - 2, break_long_words=False, break_on_hyphens=False)
    return "- " + "\n  ".join(lines) + "\n"


def page_with_list(text: str) -> str:
    """The page, with the first list after its heading replaced."""
    heading, effects = text.split("## The effects\n", 1)
    listed = "".join(map(item, TABLE))
    return f"{heading}## The effects\n" + re.sub(r"(?:(?:- |  ).*\n)+", lambda _: listed, effects, count=1)


def test_the_page_lists_the_effects_of_the_code() -> None:
    text = PAGE.read_text("utf-8")
    assert page_with_list(text) == text, f"docs/effects.md differs from analytic/effects/table.py: run {COMMAND}"


LAND = ShearedLand(ring="inner", diameter=36e-3, clearance=0.34e-3, width=5e-3)
POCKETS = ShearedPockets(clearance=0.23e-3, thickness=1.7e-3)
GIVEN = ContactAngle(rule="given", value=0.3)
NO_OIL: dict[str, Any] = {"lubricant": None}
GREASE = replace(OIL, supply="grease")
SEALED = {"seals": "2RS1: rubber seal that rubs, on both sides"}


@pytest.fixture(scope="module")
def scene(bearing_6205: Bearing) -> Scene:
    """With oil, surface, a solved angle and free balls, without a cage and without a direction of gravity."""
    return replace(idling(bearing_6205), spin_rule="free")


def of_bearing(scene: Scene, **changed: Any) -> Scene:
    return replace(scene, bearing=replace(scene.bearing, **changed))


@pytest.mark.parametrize(
    ("name", "changed", "bearing", "words"),
    [
        ("rolling", {}, {}, None),
        ("rolling", NO_OIL, {}, "no lubricant is given"),
        ("inlet_heating", NO_OIL, {}, "no lubricant is given"),
        ("load_distribution", {}, {}, None),
        ("load_distribution", {"contact_angle": GIVEN}, {}, 'use "solved"'),
        ("centrifugal", {}, {"kind": "thrust"}, "not modelled in a thrust bearing"),
        ("gyroscopic", {"contact_angle": GIVEN}, {}, 'use "solved"'),
        ("gyroscopic", {"contact_angle": GIVEN}, {"kind": "thrust"}, None),
        ("weight", {}, {}, "operation.down is needed"),
        ("weight", {"down": (0.0, 0.0, 1.0)}, {}, None),
        ("weight", {"down": (0.0, 0.0, 1.0), "contact_angle": GIVEN}, {}, 'use "solved"'),
        ("asperities", {}, {}, None),
        ("asperities", {"friction_coefficient": 0.07}, {}, "the friction coefficient is given"),
        ("starvation", {}, {}, None),
        ("starvation", {}, {"bore_diameter": None}, "bore_diameter and bearing.outside_diameter are not given"),
        ("starvation", {}, {"outside_diameter": None}, "bore_diameter and bearing.outside_diameter are not given"),
        ("starvation", {"lubricant": replace(OIL, starvation_degree=1.4)}, {"bore_diameter": None}, None),
        ("starvation", NO_OIL, {}, "no lubricant is given"),
        ("starvation", NO_OIL, {"bore_diameter": None}, "no lubricant is given"),
        ("unloaded_balls", {}, {}, None),
        ("unloaded_balls", NO_OIL, {}, "no lubricant is given"),
        ("unloaded_balls", {"lubricant": GREASE}, {}, 'lubricant.supply = "grease"'),
        ("unloaded_balls", {"contact_angle": GIVEN}, {}, 'use "solved"'),
        ("creep", {}, {}, None),
        ("creep", {"sliding": "free_ball"}, {}, '"free_ball" has no creep'),
        ("creep", {"sliding": "over_ellipse"}, {}, '"over_ellipse" has no creep'),
        ("creep", {"spin_rule": "balanced"}, {}, '"balanced" prescribes the rotation'),
        ("creep", {"microslip": "as_printed"}, {}, '"as_printed" has no creep'),
        ("creep", {"effects": {"conformity": "off"}}, {}, 'effects.conformity = "off" neglects'),
        ("creep", {"effects": {"spin": "off", "conformity": "on"}}, {}, 'effects.spin = "off" neglects'),
        ("cage", {}, {}, "no cage is given"),
        ("cage", {"cage": STAMPED_CAGE}, {}, None),
        ("cage", {"cage": STAMPED_CAGE}, {"kind": "thrust"}, None),
        ("cage_dynamics", {}, {}, "no cage is given"),
        ("cage", {"effects": {"cage": "off"}}, {}, "left out"),
        ("cage_dynamics", {"cage": STAMPED_CAGE}, {}, "cage.start is not given"),
        ("cage_dynamics", {"cage": replace(STAMPED_CAGE, start="rest")}, {}, None),
        ("cage_dynamics", {"cage": STAMPED_CAGE}, {"kind": "thrust"}, "its cage rests on its balls"),
        ("cage_dynamics", {}, {"kind": "thrust"}, "no cage is given"),
        ("ball_dynamics", {}, {}, "no cage is given"),
        ("ball_dynamics", {"cage": STAMPED_CAGE}, {}, "cage.start is not given"),
        ("ball_dynamics", {"cage": replace(STAMPED_CAGE, start="rest")}, {}, None),
        ("ball_dynamics", {"cage": replace(STAMPED_CAGE, start="rest")}, {"kind": "thrust"}, "rests on its balls"),
        ("seals", {}, {}, "not declared"),
        ("seals", {"losses": Losses(seals=0.0)}, SEALED, None),
        ("seals", {}, {**SEALED, "seals_rub": True}, "not declared: 2RS1"),
        ("seals", {}, {"seals": "2Z: shield"}, "no drag: 2Z"),
        ("drag", {}, {}, "not declared"),
        ("drag", {"losses": Losses(drag=0.0)}, {}, None),
        ("through_flow", {}, {}, "losses.oil_flow is not given"),
        ("through_flow", {"losses": Losses(oil_flow=1e-5)}, {}, None),
        ("ball_drag", {"losses": Losses(oil_flow=1e-5)}, {}, "losses.oil_share is not given"),
        ("ball_drag", {"losses": Losses(oil_share=0.0)}, {}, None),
        ("cage_shear", {}, {}, "losses.land or losses.pockets are not given"),
        ("cage_shear", {"cage": STAMPED_CAGE}, {}, "[cage] includes the friction in the pockets"),
        ("cage_shear", {"cage": replace(STAMPED_CAGE, gives_way=True)}, {}, "losses.land or losses.pockets"),
        ("cage_shear", {"losses": Losses(land=LAND)}, {}, None),
        ("cage_shear", {"losses": Losses(pockets=POCKETS)}, {}, None),
        ("spin", NO_OIL, {}, None),
    ],
)
def test_an_effect_says_what_it_lacks(
    scene: Scene, name: str, changed: dict[str, Any], bearing: dict[str, Any], words: str | None
) -> None:
    told = ENTRIES[name].lacks(of_bearing(replace(scene, **changed), **bearing))
    assert (told is None) == (words is None), told
    assert words is None or words in (told or "")


def test_balls_turn_freely_unless_a_rule_or_a_method_says_otherwise(scene: Scene) -> None:
    assert ruled(scene) is None
    assert ruled(replace(scene, sliding="free_ball")) is None  # which has no creep, but turns freely
    assert ruled(replace(scene, effects={"spin": "on", "conformity": "auto"})) is None
    for method in ("single_coefficient", "along_axis", "over_ellipse"):
        assert ruled(replace(scene, sliding=method)) is not None


def test_bounds_in_words_have_the_numbers_of_the_page() -> None:
    """As docs/effects.md states them."""
    for name, words in (
        ("load_distribution", "1.25 (Fr tan al + 2 M/d_m)/Fa"),
        ("centrifugal", "4.5 times the force"),
        ("gyroscopic", "3 times the moment"),
        ("weight", "4.5 times the weight"),
        ("weight", "1/(1 - 3 X/delta)"),
        ("weight", "0.5 times the weight over their mean load, and 8 times that of sliding"),
        ("cage_shear", "0.025 ball diameters clearance and 0.11 thickness"),
        ("ball_drag", "0.05 with `oil_bath`, 0.02 with `oil_jet`"),
    ):
        assert words in (ENTRIES[name].bound or ""), name


if __name__ == "__main__":
    PAGE.write_text(page_with_list(PAGE.read_text("utf-8")), "utf-8")
