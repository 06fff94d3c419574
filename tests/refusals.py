"""What is refused: an InputError of one line, with the words that name the key and its value."""

from collections.abc import Callable
from typing import Any

import pytest

from analytic.errors import InputError


def message_of(call: Callable[[], Any]) -> str:
    """The one line with which the call is refused."""
    with pytest.raises(InputError) as found:
        call()
    message = str(found.value)
    assert "\n" not in message, message
    return message


def refused(call: Callable[[], Any], *words: str) -> None:
    """The call is refused with these words."""
    message = message_of(call)
    assert [word for word in words if word not in message] == [], message


def refuses(call: Callable[..., Any], **wrong: Any) -> None:
    """Each of these values by itself is refused by its name."""
    for name, value in wrong.items():
        refused(lambda: call(**{name: value}), name)  # noqa: B023 - called at once
