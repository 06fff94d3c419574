"""Where a result comes from: versions, machine, scene."""

import platform
import sys
from importlib.metadata import PackageNotFoundError, version
from typing import Any

from analytic.scene import Scene

PACKAGES = ("fembearing", "numpy", "scipy", "scikit-fem", "meshio", "numba", "pypardiso", "mkl", "pyvista", "vtk")


def provenance_of(scene: Scene) -> dict[str, Any]:
    """Versions of what computed a result, the machine, the command and the scene's name."""
    return {
        "scene": scene.name,
        "command": sys.argv,
        "python": platform.python_version(),
        "platform": platform.platform(),
        "processor": platform.machine(),
        "versions": {package: _version(package) for package in PACKAGES},
    }


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None  # optional here: another solver takes its place
