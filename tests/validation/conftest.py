"""The scripts of validation/: imported as modules, or run in a process of their own."""

import importlib
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import pytest

VALIDATION = Path(__file__).resolve().parents[2] / "validation"


def importer(*folders: str) -> Iterator[Callable[[str], ModuleType]]:
    """Imports a script of these folders by its name; scripts import each other the same way.

    The scripts are forgotten at the end: two folders have a run.py.
    """
    with pytest.MonkeyPatch.context() as patch:
        for folder in folders:
            patch.syspath_prepend(VALIDATION / folder)
        yield importlib.import_module
    for name, module in list(sys.modules.items()):
        if VALIDATION in Path(getattr(module, "__file__", None) or "").parents:
            del sys.modules[name]


@pytest.fixture(scope="module")
def script() -> Iterator[Callable[[str], ModuleType]]:
    """Imports a script of the benchmarks or of the folder above them."""
    yield from importer("benchmarks", ".")


@pytest.fixture(scope="module")
def part() -> Iterator[Callable[[str], ModuleType]]:
    """Imports a script of the attacks."""
    yield from importer(".", "robustness")


@pytest.fixture(scope="session")
def run_script() -> Callable[..., str]:
    """Runs a script with these arguments and returns what it prints; it must end with status 0."""

    def run(name: str, *arguments: str | Path) -> str:
        command = [sys.executable, VALIDATION / name, *arguments]
        return subprocess.run(command, check=True, capture_output=True, text=True, timeout=600).stdout

    return run
