"""The thread that computes for all pages, one thing after the other: each takes all cores."""

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

computer = ThreadPoolExecutor(1, "computer")


async def computed(function: Callable[..., Any], *given: Any) -> Any:
    """What a function gives that computes, while the server goes on."""
    return await asyncio.get_running_loop().run_in_executor(computer, function, *given)
