"""The mutations of formulas: every module that they change exists, contains formulas and has tests."""

import importlib
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def mutations() -> Iterator[ModuleType]:
    with pytest.MonkeyPatch.context() as patch:
        patch.syspath_prepend(ROOT / "validation")
        yield importlib.import_module("mutations")


def test_every_module_has_formulas_and_tests(mutations: ModuleType) -> None:
    for module in mutations.MODULES:
        assert mutations.mutations(ROOT, module), module
        assert (ROOT / mutations.tests_of(module)).is_file(), module
