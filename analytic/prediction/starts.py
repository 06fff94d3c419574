"""Where the free balls of a sample begin: as they settle with the inputs as they are, moved on by each input in a line.

It is a start alone: each sample settles by itself. No sample begins where another one ended, so that the numbers do not
depend on their order or on the processes that compute them.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from analytic.errors import FembearingError
from analytic.oil.variation import Variation
from analytic.prediction.settled import FreeStart, free_start
from analytic.scene import Array, Scene


@dataclass(frozen=True, kw_only=True, eq=False)
class SampleStarts:
    """Of scenes with d uncertain inputs."""

    nominal: FreeStart
    slopes: FreeStart  # (d, ...) by the scores; `passes` stays

    def at(self, score: Array) -> FreeStart:
        """Of the sample with this score, (d,)."""
        both = zip(self.nominal[1:], self.slopes[1:], strict=True)
        return FreeStart(self.nominal.passes, *(here + np.tensordot(score, slope, 1) for here, slope in both))


def starts_of(varied: Callable[[Array], tuple[Scene, Variation]], inputs: int) -> SampleStarts | None:
    """The starts of the samples of a scene; None: its balls do not turn freely, or do not settle.

    varied : the scene and its variation at a score
    Each input is moved by a standard deviation. One whose point does not settle there moves no start.
    """
    unmoved = varied(np.zeros(inputs))
    by_rule = free_start(*unmoved)
    nominal = None if by_rule is None else free_start(*unmoved, by_rule)  # to the accuracy of the samples
    if nominal is None or not nominal.passes.all():
        return None
    slopes = FreeStart(nominal.passes, *(np.zeros((inputs, *each.shape)) for each in nominal[1:]))
    starts = SampleStarts(nominal=nominal, slopes=slopes)
    for place, score in enumerate(np.eye(inputs)):
        try:
            moved = free_start(*varied(score), starts.at(np.zeros(inputs)))
        except FembearingError:
            continue
        if moved is not None and moved.passes.all():
            for slope, here, there in zip(slopes[1:], nominal[1:], moved[1:], strict=True):
                slope[place] = there - here
    return starts
