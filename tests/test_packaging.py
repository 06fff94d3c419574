"""Packaging: the data are installed with the code, and constraints.txt pins every version that the gate runs."""

import re
import tomllib
from importlib.metadata import PackageNotFoundError, requires
from importlib.resources import files
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

from analytic.errors import BROUGHT_BY

ROOT = Path(__file__).resolve().parents[1]
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
EXTRAS = PROJECT["optional-dependencies"]
DECLARED = [
    requirement
    for lines in (PROJECT["dependencies"], *EXTRAS.values())
    for requirement in map(Requirement, lines)
    if requirement.name != "fembearing"
]
PINNED = {
    canonicalize_name(pin.name): pin
    for line in (ROOT / "constraints.txt").read_text("utf-8").splitlines()
    if line and not line.startswith("#")
    for pin in [Requirement(line)]
}


def applies(requirement: Requirement, extra: str = "") -> bool:
    return requirement.marker is None or requirement.marker.evaluate({"extra": extra})


def closure(start: list[Requirement]) -> set[str]:
    """Every package that these requirements install on this machine, themselves included."""
    known: set[tuple[str, str]] = set()
    ahead = [(canonicalize_name(r.name), extra) for r in start if applies(r) for extra in ("", *r.extras)]
    while ahead:
        name, extra = ahead.pop()
        if (name, extra) in known:
            continue
        known.add((name, extra))
        try:
            needs = [Requirement(line) for line in requires(name) or []]
        except PackageNotFoundError:
            continue
        ahead += [(canonicalize_name(r.name), e) for r in needs if applies(r, extra) for e in ("", *r.extras)]
    return {name for name, _ in known}


@pytest.mark.parametrize(("package", "folder"), [("fembearing", "meshes"), ("analytic", "catalog")])
def test_data_is_found_as_package_data(package: str, folder: str) -> None:
    data = Path(str(files(package) / folder))
    assert list(data.rglob("*.toml"))


def test_a_version_is_exact_and_has_no_address() -> None:
    for pin in PINNED.values():
        assert re.fullmatch(r"==[^,*]+", str(pin.specifier)), pin
        assert pin.url is None


@pytest.mark.parametrize("requirement", DECLARED, ids=str)
def test_the_tested_version_lies_in_the_declared_range(requirement: Requirement) -> None:
    pin = PINNED[canonicalize_name(requirement.name)]
    (exact,) = pin.specifier
    assert requirement.specifier.contains(exact.version)
    assert (requirement.marker is None) == (pin.marker is None)


def test_every_installed_package_is_pinned() -> None:
    assert closure(DECLARED) <= set(PINNED)


@pytest.mark.parametrize("purpose", ["main", "docs", "tests"])
def test_the_readme_marks_its_commands(purpose: str) -> None:
    readme = (ROOT / "README.md").read_text("utf-8")
    command = re.search(rf"^<!-- command: {purpose} -->\n```bash\n(.+)\n```$", readme, re.MULTILINE)
    assert command, "the gate runs this command; it must be one line"
    assert command[1].startswith("python3 -m venv ")
    assert " install -c constraints.txt " in command[1]


def extra(name: str) -> set[str]:
    """Names of the packages of an extra, with those of the extras in it."""
    found = set()
    for requirement in map(Requirement, EXTRAS[name]):
        inner = requirement.extras if requirement.name == "fembearing" else ()
        found |= set().union(*map(extra, inner)) if inner else {requirement.name}
    return found


def test_all_is_what_a_user_can_have_and_the_tests_have_it_too() -> None:
    assert extra("all") == set().union(*(extra(name) for name in EXTRAS if name not in ("dev", "docs", "peers")))
    assert extra("all") < extra("dev")
    assert extra("sweep") < extra("docs")  # its examples sweep


def test_the_torque_alone_needs_a_part_of_the_dependencies() -> None:
    lines = (ROOT / "requirements-torque.txt").read_text("utf-8").splitlines()
    torque = {line for line in lines if not line.startswith("#")}
    assert torque < set(PROJECT["dependencies"])
    packages = {package for package, installed_by in BROUGHT_BY.values() if not installed_by}
    left_out = {Requirement(line).name for line in set(PROJECT["dependencies"]) - torque}
    assert left_out == packages | {"py-mkl-pardiso"}  # which SciPy can replace


def test_an_error_names_the_extra_that_has_the_package() -> None:
    for package, name in BROUGHT_BY.values():
        assert not name or package in extra(name) | {"dask"}  # distributed needs the same version of it
