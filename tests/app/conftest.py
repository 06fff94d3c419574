"""Pages without a browser, opened by the users that NiceGUI simulates."""

import asyncio
from collections.abc import Awaitable, Callable, Coroutine
from typing import Any

import pytest
from nicegui.testing import User, user_simulation

from fembearing.app.page import Page

LONGEST = 1200  # tenths of a second: the machine may do much else, or compile formulas
Opening = Callable[[], Awaitable[tuple[Any, Page]]]  # a new tab: its user and its page
Story = Callable[[Opening], Coroutine[Any, Any, None]]


@pytest.fixture
def run_story() -> Callable[[Story], None]:
    """Runs a coroutine that opens pages."""

    def run(story: Story) -> None:
        pages: list[Page] = []
        faults: list[Exception] = []  # raised at the end: an exception that leaves the simulation keeps its loop alive

        async def whole() -> None:
            async with user_simulation(lambda: pages.append(Page())) as first:

                async def opened() -> tuple[Any, Page]:
                    user = User(first.http_client)
                    await user.open("/")
                    return user, pages[-1]

                try:
                    await story(opened)
                except Exception as fault:
                    faults.append(fault)
                for page in pages:
                    page.close()

        asyncio.run(whole())
        if faults:
            raise faults[0]

    return run


@pytest.fixture
def settled() -> Callable[[Page], Awaitable[None]]:
    """Waits until a page computes nothing."""

    async def wait(page: Page) -> None:
        await asyncio.sleep(0.05)  # in which the computation begins
        for _ in range(LONGEST):
            if not page.is_busy:
                return
            await asyncio.sleep(0.1)
        raise AssertionError("it computes without an end")

    return wait
