"""Where a result comes from and what it took: versions, machine, scene, memory."""

import platform
import sys
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from analytic.scene import Scene

try:
    import resource
except ImportError:  # Windows
    resource = None

PACKAGES = ("fembearing", "numpy", "scipy", "scikit-fem", "meshio", "numba", "pypardiso", "mkl", "pyvista", "vtk")


def provenance_of(scene: Scene) -> dict[str, Any]:
    """Scene, time, command, machine, and the versions of what computed a result."""
    return {
        "scene": scene.name,
        "date": datetime.now(UTC).isoformat(timespec="seconds"),
        "command": sys.argv,
        "python": platform.python_version(),
        "platform": platform.platform(),
        "processor": platform.machine(),
        "versions": {package: _version(package) for package in PACKAGES},
    }


def peak_memory() -> int | None:
    """Largest resident memory of this process so far, bytes; None where the system keeps no such record."""
    if resource is None:
        return None
    largest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return largest if sys.platform == "darwin" else 1024 * largest  # bytes there, kilobytes elsewhere


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None  # optional here: another solver takes its place
