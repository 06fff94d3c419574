"""The scripts of validation/: imported as modules, or run in a process of their own."""

import importlib
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from types import ModuleType

import pytest

VALIDATION = Path(__file__).resolve().parents[2] / "validation"


@pytest.fixture(scope="session")
def script() -> Iterator[Callable[[str], ModuleType]]:
    """Imports a script by its name; scripts import each other the same way."""
    with pytest.MonkeyPatch.context() as patch:
        for folder in (VALIDATION / "benchmarks", VALIDATION):
            patch.syspath_prepend(folder)
        yield importlib.import_module


@pytest.fixture(scope="session")
def run_script() -> Callable[..., str]:
    """Runs a script with these arguments and returns what it prints; it must end with status 0."""

    def run(name: str, *arguments: str | Path) -> str:
        command = [sys.executable, VALIDATION / name, *arguments]
        return subprocess.run(command, check=True, capture_output=True, text=True, timeout=600).stdout

    return run
