"""How far long work has come: a function that is called with the share done, 0 to 1, and a word on the step at hand."""

from collections.abc import Callable

Progress = Callable[[float, str], None]


def silent(_share: float, _step: str) -> None:
    """Progress that nobody watches."""


def part_of(progress: Progress, begin: float, end: float) -> Progress:
    """Progress of a part of the work, which takes the whole from one share to another."""
    return lambda share, step: progress(begin + share * (end - begin), step)
