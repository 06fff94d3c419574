"""What the packages export: every name stays what it is, whatever is imported later."""

import pkgutil
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
