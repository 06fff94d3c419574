"""What the packages export: every name stays what it is, whatever is imported later."""

import importlib
import pkgutil
from importlib.resources import files
from types import ModuleType

import pytest

import analytic
import fembearing


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
        assert getattr(package, name).__module__.partition(".")[0] in (package.__name__, "analytic")


@pytest.mark.parametrize("package", [analytic, fembearing])
def test_the_package_says_that_it_has_types(package: ModuleType) -> None:
    assert (files(package) / "py.typed").is_file()
