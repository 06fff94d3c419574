"""What the packages export: every name stays what it is, whatever is imported later."""

import importlib
import pkgutil
from collections.abc import Callable
from importlib.resources import files
from types import ModuleType
from typing import Any

import pytest

import analytic
import fembearing
from tests.refusals import refused

OF_SCENES: dict[str, Callable[[Any], Any]] = {
    "predict": analytic.predict,
    "torque_function": analytic.torque_function,
    "torque_of_scene": fembearing.torque_of_scene,
    "draw_bearing": fembearing.draw_bearing,
    "compare_measured": fembearing.compare_measured,
    "validate": fembearing.validate,
    "solve_contact": lambda scene: fembearing.solve_contact(scene, pair="inner"),
    "solve_load_series": lambda scene: fembearing.solve_load_series(scene, pair="inner", loads=[30.0, 70.0]),
}
OF_NAMES: dict[str, Callable[[Any], Any]] = {
    "load_scene": analytic.load_scene,
    "steady_scene": analytic.steady_scene,
    "friction_torque": analytic.friction_torque,
    "export": lambda scene: fembearing.export(scene, to="csv", out="torque.csv"),
}


@pytest.mark.parametrize("package", [analytic, fembearing])
def test_no_exported_name_is_that_of_a_part_of_the_package(package: ModuleType) -> None:
    """Importing a part of a package puts it in the place of a function of the same name."""
    parts = {module.name for module in pkgutil.iter_modules(package.__path__)}
    assert len(parts) > 5
    assert parts & set(package.__all__) == set()


@pytest.mark.parametrize("package", [analytic, fembearing])
def test_dir_lists_what_the_package_exports_and_nothing_else(package: ModuleType) -> None:
    for module in pkgutil.iter_modules(package.__path__):
        if module.name not in ("cli", "meshes"):
            importlib.import_module(f"{package.__name__}.{module.name}")  # a part that is imported is an attribute too
    assert sorted(package.__all__) == dir(package)
    for name in dir(package):
        assert not name.startswith("_")
        assert getattr(package, name).__module__.startswith(f"{package.__name__}.")


@pytest.mark.parametrize("package", [analytic, fembearing])
def test_the_package_says_that_it_has_types(package: ModuleType) -> None:
    assert (files(package) / "py.typed").is_file()


@pytest.mark.parametrize("name", OF_SCENES)
@pytest.mark.parametrize("given", ["6206", None, {"bearing": "6206"}], ids=repr)
def test_what_takes_a_scene_refuses_anything_else(name: str, given: Any) -> None:
    refused(lambda: OF_SCENES[name](given), f"scene must be a Scene, got {given!r}; ", 'load_scene("6206")')


@pytest.mark.parametrize("name", OF_NAMES)
@pytest.mark.parametrize("given", [None, {"bearing": "6206"}, b"6206"], ids=repr)
def test_what_takes_a_name_refuses_what_is_none(name: str, given: Any) -> None:
    refused(lambda: OF_NAMES[name](given), f"{given!r} is not the name of a bearing or a file", 'example "6206"')
