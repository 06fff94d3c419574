"""Origin of a result: versions, machine, scene."""

import hashlib
import json
import os
import platform
import re
import sys
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from types import MappingProxyType
from typing import Any

from analytic.scene import Scene
from fembearing.plain_types import plain

PACKAGES = (
    "fembearing",
    "numpy",
    "scipy",
    "scikit-fem",
    "meshio",
    "py-mkl-pardiso",
    "pyvista",
    "vtk",
    "netCDF4",
)

# Folders of an absolute path, alone or in KEY=PATH: a result names no user and no machine.
FOLDERS = re.compile(r"""(^|[="'])([A-Za-z]:)?[/\\][^"\n]*[/\\]""")


@dataclass(frozen=True, kw_only=True)
class Provenance:
    """Where the numbers of a result come from."""

    scene: str  # its name
    scene_content: dict[str, Any]  # whole, SI
    scene_sha256: str
    seeds: dict[str, list[int]]  # of each random quantity, by its name
    date: str
    command: list[str]
    python: str
    platform: str
    processor: str
    cores: int | None
    versions: dict[str, str | None]  # of packages; None: not installed


def provenance_of(scene: Scene, *, seeds: Mapping[str, Sequence[int]] = MappingProxyType({})) -> Provenance:
    """The whole scene in SI and its hash; date, command, kind of machine, and the versions of the packages.

    Of absolute paths in scene and command, the names of the files are left.
    What changes no torque is left out, so that it changes no hash: `Scene.report`, who signs and in which units, and
    `Scene.measured`, whose numbers stand beside the computed ones.
    seeds : of each random quantity, by its name; without them nothing is random
    """
    content = plain(scene)
    del content["report"], content["measured"]
    content = without_folders(content)
    return Provenance(
        scene=scene.name,
        scene_content=content,
        scene_sha256=hashlib.sha256(json.dumps(content, sort_keys=True).encode()).hexdigest(),
        seeds={name: list(values) for name, values in seeds.items()},
        date=datetime.now(UTC).isoformat(timespec="seconds"),
        command=without_folders(sys.argv),
        python=platform.python_version(),
        platform=platform.platform(),
        processor=platform.machine(),
        cores=os.cpu_count(),
        versions={package: _version(package) for package in PACKAGES},
    )


def without_folders(content: Any) -> Any:
    """Plain types with the names of files in place of absolute paths."""
    if isinstance(content, dict):
        return {key: without_folders(value) for key, value in content.items()}
    if isinstance(content, list):
        return [without_folders(value) for value in content]
    return FOLDERS.sub(r"\1", content) if isinstance(content, str) else content


def _version(package: str) -> str | None:
    try:
        return version(package)
    except PackageNotFoundError:
        return None  # optional: another solver replaces it
