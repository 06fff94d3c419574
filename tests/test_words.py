"""Words of help pages."""

import re

import pytest

from fembearing.cli import COMMANDS, command_of

HELP_BANNED = r"without it\.?$|, as [0-9a-z]|^(Of|In|For|From) "  # defaults are written (default: ...)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_says_what_it_is_and_its_default(name: str) -> None:
    """Each begins with a noun or a verb and ends with a full stop."""
    command = command_of(name)
    for parameter in command.params:
        words = getattr(parameter, "help", None)
        assert words, f"{name} {parameter.name} has no help"
        assert not re.search(HELP_BANNED, words), f"{name} {parameter.name}: {words}"
        if parameter.name != "help":
            assert words.endswith("."), f"{name} {parameter.name}: {words}"
