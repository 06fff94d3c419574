"""Recipes: every mesh is made from one, and a mistake in one is named."""

import shutil
from pathlib import Path

import pytest

import analytic
import fembearing
from analytic.errors import FembearingError, InputError
from analytic.scene import Scene
from fembearing.mesh import recipe as recipes
from fembearing.mesh.recipe import load_recipe, parse_recipe

SHIPPED = Path(fembearing.__file__).parent / "meshes"


@pytest.fixture
def scene() -> Scene:
    return analytic.load_scene("6205-dry")


@pytest.mark.parametrize(("name", "geometry"), [("race", "real"), ("hertzian", "hertzian"), ("wall", "wall")])
def test_the_shipped_recipes_are_sound(name: str, geometry: str) -> None:
    recipe = load_recipe(name)
    assert (recipe.name, recipe.geometry) == (name, geometry)
    assert len(recipe.levels) >= 3
    assert recipe.cells.times(3).depth == 3 * recipe.cells.depth


FAULTS = {  # what is replaced, by what, and what the message must name
    "unknown key": ('geometry = "real"', 'geometry = "real"\nsmoothing = 3', "smoothing"),
    "other geometry": ('"real"', '"cylinder"', "'cylinder', accepted: real, hertzian, wall"),
    "levels not rising": ("[1, 2, 3, 4]", "[4, 5, 6]", r"\[4, 5, 6\].*1.3 times"),
    "two levels": ("[1, 2, 3, 4]", "[2, 4]", "three or more"),
    "level zero": ("[1, 2, 3, 4]", "[0, 2, 3]", r"levels = \[0, 2, 3\]"),
    "text for a number": ("core_size = 0.6", 'core_size = "0.6"', "core_size = '0.6'"),
    "flag for a number": ("core = 1", "core = true", "cells.core = True"),
    "broken cell count": ("depth = 3", "depth = 2.5", "cells.depth = 2.5"),
    "not a number": ("extent = 4.0", "extent = nan", "domain.extent = nan"),
    "margin on the contact": ("margin_size = 1.4", "margin_size = 1", "margin_size = 1, .* more than 1, to 1000"),
    "growth of nothing": ("growth = 8.0", "growth = 1.0", "domain.growth = 1.0"),
    "size of nothing": ("core_size = 0.6", "core_size = 0.0", "core_size = 0.0, accepted: a number, more than 0"),
    "bulge inwards": ("core_bulge = 0.5", "core_bulge = -0.1", "core_bulge = -0.1, accepted: a number, 0 or more"),
    "too many cells": ("depth = 3", "depth = 1001", "depth = 1001, accepted: a whole number, 1 or more, to 1000"),
    "levels too near": ("[1, 2, 3, 4]", "[10, 20, 25]", "1.3 times"),
    "missing section": ("[depth]", "[depht]", "depht"),
    "section no table": ("[domain]", "[[domain]]", r"\[domain\]"),
}


SOUND = {  # numbers at their limits
    "flat core": ("core_bulge = 0.5", "core_bulge = 0"),
    "widest margin": ("margin_size = 1.4", "margin_size = 1000"),
    "most cells": ("depth = 3", "depth = 1000"),
    "nearest levels": ("[1, 2, 3, 4]", "[10, 13, 17]"),
    "three levels": ("[1, 2, 3, 4]", "[1, 2, 3]"),
}


@pytest.mark.parametrize("change", [*SOUND, *FAULTS])
def test_a_mistake_is_named_in_one_line(tmp_path: Path, change: str) -> None:
    old, new, *named = (SOUND | FAULTS)[change]
    text = (SHIPPED / "race.toml").read_text("utf-8")
    assert old in text
    (tmp_path / "race.toml").write_text(text.replace(old, new, 1), "utf-8")
    if not named:
        assert parse_recipe(tmp_path / "race.toml", name="race").name == "race"
        return
    with pytest.raises(InputError, match=f"mesh recipe race.*{named[0]}") as caught:
        parse_recipe(tmp_path / "race.toml", name="race")
    assert "\n" not in str(caught.value)


def test_nothing_is_solved_without_its_recipe(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, scene: Scene) -> None:
    """Recipes are read from a copy of the package's folder, then one is deleted from it: no other source of meshes."""
    shutil.copytree(SHIPPED, tmp_path / "meshes")
    monkeypatch.setattr(recipes, "files", lambda _: tmp_path)
    assert load_recipe("race").geometry == "real"
    (tmp_path / "meshes" / "race.toml").unlink()
    for attempt in (
        lambda: load_recipe("race"),
        lambda: fembearing.solve_contact(scene, pair="inner"),
        lambda: fembearing.validate(scene),
    ):
        with pytest.raises(FembearingError, match=r"restore meshes/race\.toml") as caught:
            attempt()
        assert "\n" not in str(caught.value)
    (tmp_path / "meshes" / "hertzian.toml").unlink()
    with pytest.raises(InputError, match=r"restore meshes/hertzian\.toml"):
        fembearing.solve_contact(scene, pair="outer", geometry="hertzian")
