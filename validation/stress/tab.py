"""The page of `fembearing app` without a browser: scenes are pasted into it, and it shows a torque or a refusal."""

import asyncio
import re
import signal
from collections.abc import Callable
from functools import cache
from typing import Any
from unittest.mock import patch

import numpy as np

from analytic.errors import FembearingError, InputError
from validation.stress.damage import changed_scene
from validation.stress.extreme import extreme_scene
from validation.stress.watched import SLOWEST, Input, SilentError

NOT_A_NUMBER = re.compile(r"(?<![\w.-])[-+]?(nan|inf)(?![\w.-])", re.IGNORECASE)


class Tab:
    """A page that a simulated user opens; it computes in this thread, where a signal can end a call."""

    def __init__(self) -> None:
        from nicegui.testing import User, user_simulation

        from fembearing.app import page

        self.loop, self.pages = asyncio.new_event_loop(), []
        self.problem: BaseException | None = None  # by which the last computation ended
        for name, ours in {"computed": self._at_once, "PAUSE": 0.0}.items():
            patch.object(page, name, ours).start()
        patch.dict("os.environ", PYTEST_CURRENT_TEST="stress").start()  # without it NiceGUI simulates no user
        self.simulation = user_simulation(lambda: self.pages.append(page.Page()))
        self.user: User = self._wait(self.simulation.__aenter__())
        self.open()

    def open(self) -> None:
        """Open a new page, after the one before is closed."""
        for each in self.pages:
            each.close()
        if self.user.client is not None:
            self.user.client.delete()
        self.pages.clear()
        self._wait(self.user.open("/"))
        self._wait(self._settled())

    def shows(self, text: str) -> None:
        """Paste a scene. Raises what a computation raised, InputError for a refusal, SilentError for no number."""
        self.problem = None
        self._wait(self._pasted(text))
        lines = {name: line.text for name, line in self.pages[-1].lines.items()}
        if self.problem is not None and not isinstance(self.problem, FembearingError):
            raise self.problem
        if "a defect of fembearing" in lines["problem"]:
            raise RuntimeError(lines["problem"])
        if lines["problem"]:
            raise InputError(lines["problem"])
        for name, line in lines.items():
            if found := NOT_A_NUMBER.search(line):
                raise SilentError(f"{name} shows {found.group()}")

    async def _pasted(self, text: str) -> None:
        self.pages[-1].paste(text)
        await self._settled()

    async def _settled(self) -> None:
        await asyncio.sleep(0)  # in which the computation begins
        while self.pages[-1].is_busy:
            await asyncio.sleep(0)

    async def _at_once(self, function: Callable[..., Any], *given: Any) -> Any:
        if signal.getitimer(signal.ITIMER_PROF)[0]:  # the headline and each slice of the curve are calls of their own
            signal.setitimer(signal.ITIMER_PROF, SLOWEST)
        try:
            return function(*given)
        except BaseException as problem:
            self.problem = problem
            raise

    def _wait(self, work: Any) -> Any:
        return self.loop.run_until_complete(work)


@cache
def tab() -> Tab:
    """The one of this process."""
    return Tab()


def page_input(seed: int) -> Input:
    """An extreme scene, or a damaged one, pasted into the page."""
    rng = np.random.default_rng(seed)
    if seed % 2:
        kind, content = "page, extreme", extreme_scene(rng).encode()
    else:
        kind, content = "page, damaged", changed_scene(rng)
    opened = tab()
    return Input(kind, content, lambda: opened.shows(content.decode("utf-8", "replace")))
