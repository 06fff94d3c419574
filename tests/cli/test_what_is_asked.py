"""What a command asks of the library, by its options; nothing is solved."""

from typing import Any

import pytest

from analytic.errors import InputError
from analytic.scene import Scene
from fembearing.cli.status import INPUT_AT_FAULT


@pytest.fixture
def asked(command, monkeypatch: pytest.MonkeyPatch):
    """Runs a command, and gives what it asks of a function, which then refuses."""

    def run(target: str, *arguments: str) -> dict[str, Any]:
        found: dict[str, Any] = {}

        def note(scene: Scene, **how: Any) -> None:
            found.update(how, tolerance=scene.tolerance)
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
