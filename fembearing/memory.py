"""Resident memory of this process: its largest so far, and its largest while one thing runs."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

try:
    import resource
except ImportError:  # Windows
    resource = None

Result = TypeVar("Result")
STATUS, FORGET = Path("/proc/self/status"), Path("/proc/self/clear_refs")  # Linux
FORGET_PEAK = "5"  # what the kernel takes for "count the peak from now on"

_forgotten = 0  # bytes: the largest that a peak which was counted anew has shown before


def peak_memory() -> int | None:
    """Largest resident memory of this process so far, bytes; None where the system keeps no such record."""
    if resource is None:
        return None
    largest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return max(_forgotten, largest if sys.platform == "darwin" else 1024 * largest)  # bytes there, kilobytes elsewhere


def peak_while(run: Callable[[], Result]) -> tuple[Result, int | None]:
    """What `run` returns, and the largest resident memory while it ran, bytes.

    It counts what the process held already: interpreter and libraries are part of the price. Only Linux counts a peak
    anew; elsewhere it is the largest so far, of this run and those before it.
    """
    global _forgotten  # the peak belongs to the process, as there is one of it
    before = peak_memory()
    try:
        FORGET.write_text(FORGET_PEAK)
    except OSError:  # no such file, or not allowed
        return run(), peak_memory()
    _forgotten = max(_forgotten, before or 0)
    return run(), _counted_anew()


def _counted_anew() -> int | None:
    line = next((line for line in STATUS.read_text().splitlines() if line.startswith("VmHWM:")), None)
    return None if line is None else 1024 * int(line.split()[1])
