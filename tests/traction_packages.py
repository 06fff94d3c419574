"""Packages with a law of traction, as pip installs them: their modules beside a folder with their metadata."""

import shutil
import tomllib
from collections.abc import Mapping
from pathlib import Path

EXAMPLE = Path(__file__).resolve().parents[1] / "examples" / "traction_law"
GROUP = "fembearing.traction"


def install(folder: Path, name: str, version: str, laws: Mapping[str, str]) -> None:
    """The metadata of a package in a folder of the path; laws : "module:function" by the name of the law."""
    made = folder / f"{name.replace('-', '_')}-{version}.dist-info"
    made.mkdir(parents=True, exist_ok=True)
    (made / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\n", "utf-8")
    lines = "\n".join(f"{law} = {place}" for law, place in laws.items())
    (made / "entry_points.txt").write_text(f"[{GROUP}]\n{lines}\n", "utf-8")


def install_example(folder: Path) -> None:
    """The example, by its pyproject.toml; pip itself would ask for its build tool."""
    given = tomllib.loads((EXAMPLE / "pyproject.toml").read_text("utf-8"))
    project = given["project"]
    install(folder, project["name"], project["version"], project["entry-points"][GROUP])
    for file in given["tool"]["hatch"]["build"]["targets"]["wheel"]["only-include"]:
        shutil.copy(EXAMPLE / file, folder)
