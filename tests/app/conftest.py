"""Pages without a browser: the users that NiceGUI simulates, and a torque that takes no time."""

import asyncio
import warnings
from collections.abc import Callable, Coroutine
from typing import Any

import pytest


@pytest.fixture
def on_page() -> Callable[[Callable[[Any], Coroutine[Any, Any, None]]], None]:
    """Runs a coroutine with a way to open pages: `user = await open_page()`."""
    from fembearing.app.page import Page

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of the modules that it loads
        from nicegui.testing import User, user_simulation

    def run(story: Callable[[Any], Coroutine[Any, Any, None]]) -> None:
        async def whole() -> None:
            async with user_simulation(Page) as first:

                async def open_page() -> Any:
                    user = User(first.http_client)
                    await user.open("/")
                    return user

                await story(open_page)

        asyncio.run(whole())

    return run
