"""Where a contact lies in its picture: one frame for every renderer, and for whoever reads the picture back."""

import math
from dataclasses import dataclass
from typing import NamedTuple

WIDEST, HIGHEST = 1400, 640  # pixels of the part that shows the contact
NARROWEST = 760  # pixels: title and colour bar need them
ROOM = 1.3, 1.7  # shown around the contact: half widths along its longer and its shorter semi-axis
TITLE, BAR = 76, 120  # pixels kept free above and below
ROUND = 1.001  # ratio up to which a contact counts as a circle: round-off shall not turn the picture
LONGEST_BAR = 260  # pixels


@dataclass(frozen=True, kw_only=True)
class Frame:
    """A picture to scale, seen along the load: the longer semi-axis to the right."""

    width: int  # pixels
    height: int  # pixels
    scale: float  # pixels per m
    centre: tuple[float, float]  # of the contact, pixels from the left and from the top
    rolling_is_horizontal: bool
    bar: float  # length of the scale bar, m


class PressureScale(NamedTuple):
    """How pressure is coloured."""

    unit: str
    factor: float  # what Pa are multiplied by
    peak: float  # the end of the colours, in that unit
    ticks: list[float]  # likewise


def frame_of(*, semi_axis_rolling: float, semi_axis_transverse: float) -> Frame:
    """Room for a contact of these semi-axes, m."""
    longer, shorter = (
        max(semi_axis_rolling, semi_axis_transverse),
        min(semi_axis_rolling, semi_axis_transverse),
    )
    scale = min(WIDEST / (2 * ROOM[0] * longer), HIGHEST / (2 * ROOM[1] * shorter))
    width = max(NARROWEST, round(2 * ROOM[0] * longer * scale))
    shown = round(2 * ROOM[1] * shorter * scale)
    return Frame(
        width=width,
        height=TITLE + shown + BAR,
        scale=scale,
        centre=(width / 2, TITLE + shown / 2),
        rolling_is_horizontal=semi_axis_rolling > ROUND * semi_axis_transverse,
        bar=round_length(LONGEST_BAR / scale),
    )


def round_length(most: float) -> float:
    """The largest of 1, 2, 5 times a power of ten that is no more than `most`."""
    power = 10.0 ** math.floor(math.log10(most))
    return max(step * power for step in (1, 2, 5) if step * power <= most)
