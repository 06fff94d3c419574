"""Progress of long work: a function that takes the share done, 0 to 1, and a text on the current step."""

from collections.abc import Callable

Progress = Callable[[float, str], None]


def silent(_share: float, _step: str) -> None:
    """Progress that is not shown."""


def part_of(progress: Progress, begin: float, end: float) -> Progress:
    """Progress of a part of the work, which runs from the share `begin` of the whole to the share `end`."""
    return lambda share, step: progress(begin + share * (end - begin), step)
