"""The two threads that compute for all pages: one for the torque of a change, one for all that may follow later."""

import asyncio
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

first, later = ThreadPoolExecutor(1, "first"), ThreadPoolExecutor(1, "later")


async def computed_first(function: Callable[..., Any], *given: Any) -> Any:
    """What a function gives that computes the torque of a change, while the server goes on."""
    return await asyncio.get_running_loop().run_in_executor(first, function, *given)


async def computed(function: Callable[..., Any], *given: Any) -> Any:
    """What a function gives that takes longer, after the others; the torque of a change does not wait for it."""
    return await asyncio.get_running_loop().run_in_executor(later, function, *given)


def close() -> None:
    """Compute no longer."""
    for thread in (first, later):
        thread.shutdown(wait=False, cancel_futures=True)
