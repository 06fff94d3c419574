"""The machine and versions of a benchmark run, for the head of its results. Standard library only."""

import os
import platform
from importlib.metadata import version


def machine() -> str:
    return f"{platform.machine()}, {os.cpu_count()} cores, {platform.system()}, Python {platform.python_version()}"


def versions(*packages: str) -> str:
    return ", ".join(f"{package} {version(package)}" for package in packages)
