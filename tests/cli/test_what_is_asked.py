"""What a command asks of the library, by its options; nothing is solved."""

from typing import Any

import pytest

from analytic.errors import InputError
from fembearing.cli.status import INPUT_AT_FAULT


@pytest.fixture
def asked(command, monkeypatch: pytest.MonkeyPatch):
    """Runs a command, and gives what it asks of a function, which then refuses."""

    def run(target: str, *arguments: str) -> dict[str, Any]:
        found: dict[str, Any] = {}

        def note(_: object, **how: Any) -> None:
            found.update(how)
            raise InputError("enough")

        monkeypatch.setattr(target, note)
        assert command(*arguments).status == INPUT_AT_FAULT
        return found

    return run


@pytest.mark.parametrize(
    ("options", "expected"),
    [
        ((), {"cost": False, "samples": None, "film": True, "creep": True}),
        (("--no-film",), {"film": False, "creep": True}),
        (("--no-creep",), {"film": True, "creep": False}),
        (("--interval", "--cost"), {"samples": "enough", "cost": True}),
        (("--tolerance", "7 %"), {"tolerance": pytest.approx(0.07, rel=1e-12)}),
    ],
)
def test_a_check_has_what_its_options_say(asked, options: tuple[str, ...], expected: dict[str, Any]) -> None:
    found = asked("fembearing.report.folder.validate", "validate", "6205-dry", *options)
    assert {name: found[name] for name in expected} == expected


@pytest.mark.parametrize(
    ("command_", "target"),
    [
        ("film", "fembearing.check.film.scene_film.film_of"),
        ("creep", "fembearing.check.creep.scene_creep.creep_of"),
    ],
)
def test_load_and_tolerance_are_the_scenes_unless_they_are_given(asked, command_: str, target: str) -> None:
    usual = asked(target, command_, "6205-dry")
    assert (usual["load"], usual["compliance"]) == (None, "half-space")
    given = asked(target, command_, "6205-dry", "--load", "0.31 kN", "--tolerance", "3 %")
    assert (given["load"], given["tolerance"]) == (pytest.approx(310.0), pytest.approx(0.03))
    if command_ == "creep":
        assert usual["friction"] is None
        assert asked(target, command_, "6205-dry", "--friction", "0.07")["friction"] == 0.07
