"""Resident memory of this process: the peak so far, and the peak while a function runs."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

try:
    import resource
except ImportError:  # Windows
    resource = None

Result = TypeVar("Result")
STATUS, RESET = Path("/proc/self/status"), Path("/proc/self/clear_refs")  # Linux
RESET_PEAK = "5"  # makes the kernel measure the peak from now on

_peak_before_reset = 0  # bytes: the peak before the last reset


def peak_memory() -> int | None:
    """Largest resident memory of this process so far, bytes; None where the system does not record it."""
    if resource is None:
        return None
    largest = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return max(
        _peak_before_reset, largest if sys.platform == "darwin" else 1024 * largest
    )  # bytes on macOS, kilobytes elsewhere


def peak_while(run: Callable[[], Result]) -> tuple[Result, int | None]:
    """The result of `run`, and the largest resident memory while it ran, bytes.

    It includes the memory that the process had before: interpreter and libraries are part of the cost. Only Linux can
    reset the peak; elsewhere it is the largest so far, of this run and those before it.
    """
    global _peak_before_reset  # the process has one peak
    before = peak_memory()
    try:
        RESET.write_text(RESET_PEAK)
    except OSError:  # no such file, or no permission
        return run(), peak_memory()
    _peak_before_reset = max(_peak_before_reset, before or 0)
    return run(), _peak_since_reset()


def _peak_since_reset() -> int | None:
    line = next((line for line in STATUS.read_text().splitlines() if line.startswith("VmHWM:")), None)
    return None if line is None else 1024 * int(line.split()[1])
