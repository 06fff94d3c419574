"""Packaging: data are installed with the code, and messages and lists name the packages that are needed."""

import tomllib
from importlib.resources import files
from pathlib import Path

import pytest
from packaging.requirements import Requirement

from analytic.errors import BROUGHT_BY

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]


@pytest.mark.parametrize(("package", "folder"), [("fembearing", "meshes"), ("analytic", "catalog")])
def test_data_is_found_as_package_data(package: str, folder: str) -> None:
    data = Path(str(files(package) / folder))
    assert list(data.rglob("*.toml"))


def extra(name: str) -> set[str]:
    """Names of the packages of an extra, with those of the extras in it."""
    found = set()
    for requirement in map(Requirement, EXTRAS[name]):
        inner = requirement.extras if requirement.name == "fembearing" else ()
        found |= set().union(*map(extra, inner)) if inner else {requirement.name}
    return found


def test_an_error_names_the_extra_that_has_the_package() -> None:
    for package, name in BROUGHT_BY.values():
        assert package in extra(name) | {"dask"}  # distributed needs the same version of it


def test_the_torque_needs_no_package_of_the_check() -> None:
    assert not {Requirement(line).name for line in PROJECT["dependencies"]} & extra("check")
