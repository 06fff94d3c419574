"""Where a result comes from and how: versions, machine, scene."""

import hashlib
import json
import os
import platform
import sys
from collections.abc import Mapping, Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from types import MappingProxyType
from typing import Any

from analytic.scene import Scene
from fembearing.plain import plain

PACKAGES = (
    "fembearing",
    "numpy",
    "scipy",
    "scikit-fem",
    "meshio",
    "numba",
    "pypardiso",
    "mkl",
    "pyvista",
    "vtk",
    "netCDF4",
)


# What another run of the same scene with the same seeds may tell otherwise; all else of its JSON is the same.
TIMES = ("seconds", "spread", "warm_up", "predicted", "price", "chosen", "choices")  # with what is chosen by them
MEMORY = ("memory", "peak_memory")
ORIGIN = ("date", "command", "python", "platform", "processor", "cores", "versions")
VARYING = frozenset((*TIMES, *MEMORY, *ORIGIN))


def provenance_of(scene: Scene, *, seeds: Mapping[str, Sequence[int]] = MappingProxyType({})) -> dict[str, Any]:
    """The scene in full, SI, and its hash; time, command, machine, and the versions of what computed a result.

    seeds : of all that is random, by what it is; nothing is without them
    """
    content = plain(scene)
    return {
        "scene": scene.name,
        "scene_content": content,
        "scene_sha256": hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest(),
        "seeds": {name: list(values) for name, values in seeds.items()},
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "command": sys.argv,
        "python": platform.python_version(),
        "platform": platform.platform(),
        "processor": platform.machine(),
        "cores": os.cpu_count(),
        "versions": {package: _version(package) for package in PACKAGES},
    }


def repeatable(content: Any) -> Any:
    """A result's JSON without what another run may tell otherwise."""
    if isinstance(content, dict):
        return {key: repeatable(value) for key, value in content.items() if key not in VARYING}
    return [repeatable(value) for value in content] if isinstance(content, list) else content


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None  # optional here: another solver takes its place
