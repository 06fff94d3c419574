"""The programs of validation/, run in a process of their own."""

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

VALIDATION = Path(__file__).resolve().parents[2] / "validation"


@pytest.fixture(scope="session")
def run_script() -> Callable[..., str]:
    """Runs a script with these arguments and returns what it prints; it must end with status 0."""

    def run(name: str, *arguments: str | Path) -> str:
        command = [sys.executable, VALIDATION / name, *arguments]
        return subprocess.run(command, check=True, capture_output=True, text=True, timeout=600).stdout

    return run
