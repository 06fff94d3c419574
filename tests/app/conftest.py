"""Pages without a browser, opened by the users that NiceGUI simulates."""

import asyncio
from collections.abc import Awaitable, Callable, Coroutine
from functools import cache
from typing import Any

import pytest
from nicegui.testing import User, user_simulation

from fembearing.app import evaluation
from fembearing.app.evaluation import Evaluation, at_once, completed
from fembearing.app.page import FIRST, Page
from fembearing.app.scene_edit import of_bearing

LONGEST = 1200  # tenths of a second: the machine may do much else, or compile formulas
Opening = Callable[[], Awaitable[tuple[Any, Page]]]  # a new tab: its user and its page
Story = Callable[[Opening], Coroutine[Any, Any, None]]


@cache
def first_torque(text: str) -> Evaluation:
    return at_once(text)


@cache
def first_interval(text: str) -> Evaluation:
    return completed(first_torque(text))


@pytest.fixture(autouse=True)
def opened_before(monkeypatch: pytest.MonkeyPatch) -> None:
    """The torque of a page as it opens is computed once for all tests: each opens one or two."""
    opening = of_bearing(FIRST, "")
    monkeypatch.setattr(evaluation, "at_once", lambda text: (first_torque if text == opening else at_once)(text))
    monkeypatch.setattr(
        evaluation, "completed", lambda found: first_interval(opening) if found.text == opening else completed(found)
    )


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
