"""Pages without a browser, opened by the users that NiceGUI simulates."""

import asyncio
import inspect
from collections.abc import Awaitable, Callable
from functools import cache
from typing import Any

import pytest
from nicegui.testing import User, user_simulation

from fembearing.app import evaluation
from fembearing.app.evaluation import Evaluation, at_once, completed
from fembearing.app.page import FIRST, Page, after_handshake
from fembearing.app.scene_edit import of_bearing

LONGEST = 1200  # tenths of a second: the machine may do much else, or compile formulas


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


class Opening:
    """Opens a page in a new tab: its user and the page."""

    def __init__(self) -> None:
        self.first: Any = None  # user of the simulated server
        self.pages: list[Page] = []

    async def __call__(self) -> tuple[Any, Page]:
        user, before = User(self.first.http_client), len(self.pages)
        await user.open("/")
        while len(self.pages) == before:  # it is built after the handshake
            await asyncio.sleep(0)
        return user, self.pages[-1]


@pytest.fixture
def opened() -> Opening:
    return Opening()


@pytest.hookimpl(tryfirst=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> bool | None:
    """A test that is a coroutine runs beside a simulated server, in which `opened` opens pages."""
    if not inspect.iscoroutinefunction(pyfuncitem.obj):
        return None
    opened: Any = pyfuncitem.funcargs["opened"]
    given = {name: pyfuncitem.funcargs[name] for name in inspect.signature(pyfuncitem.obj).parameters}
    faults: list[Exception] = []  # raised at the end: an exception that leaves the simulation keeps its loop alive

    async def whole() -> None:
        async with user_simulation(after_handshake(lambda: opened.pages.append(Page()))) as opened.first:
            try:
                await pyfuncitem.obj(**given)
            except Exception as fault:
                faults.append(fault)
            for page in opened.pages:
                page.close()

    asyncio.run(whole())
    if faults:
        raise faults[0]
    return True


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
