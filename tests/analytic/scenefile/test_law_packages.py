"""Laws of traction of installed packages: found by name, with their origin, or refused in one line."""

import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

import analytic
from analytic.scene import OwnTraction
from analytic.scenefile.law_packages import installed_law
from tests.analytic.scenefile.scene_texts import OIL, refusal, scene
from tests.analytic.specimens import present
from tests.traction_packages import install, install_example


@pytest.fixture
def packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A folder of the path, for packages of one test."""
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.delitem(sys.modules, "odd_laws", raising=False)
    installed_law.cache_clear()
    yield tmp_path
    installed_law.cache_clear()


def by(name: str) -> str:
    return OIL.replace("eyring_sinh", name)


def test_a_scene_names_the_law_of_a_package(packages: Path) -> None:
    install_example(packages)
    law = present(scene(by("carreau-squalane")).lubricant).traction
    assert isinstance(law, OwnTraction)
    assert (law.name, law.distribution, law.version) == ("carreau-squalane", "carreau-law", "0.1.0")
    named = analytic.lubricant("ISO VG 68", temperature=330.0, traction="carreau-squalane")
    assert named.traction == law


@pytest.mark.parametrize(
    ("code", "words"),
    [
        ("def law(x):\n    return x / (1 + x * x)\n", ("law of traction odd", "falls", "never falls")),
        ("import no_such_module_anywhere\n", ("odd-laws 0.3", "ModuleNotFoundError", "correct the package")),
        ("raise RuntimeError('two\\nlines')\n", ("odd-laws 0.3", "RuntimeError: two lines")),
        ("def other(x):\n    return x\n", ("odd-laws 0.3", "AttributeError", "correct the package")),
        ("law = 0.7\n", ("odd_laws:law of odd-laws 0.3 is float", "give a function")),
    ],
)
def test_a_package_without_a_law_is_refused_in_one_line(packages: Path, code: str, words: tuple[str, ...]) -> None:
    install(packages, "odd-laws", "0.3", {"odd": "odd_laws:law"})
    (packages / "odd_laws.py").write_text(code, "utf-8")
    message = refusal(by("odd"))
    assert "\n" not in message
    assert [word for word in words if word not in message] == []


def test_a_name_that_two_packages_give_is_refused(packages: Path) -> None:
    for name in ("first-laws", "second-laws"):
        install(packages, name, "1.0", {"mine": "math:asinh"})
    message = refusal(by("mine"))
    assert "first-laws 1.0" in message
    assert "second-laws 1.0" in message
    assert "remove all but one" in message
