"""Numbers in sentences: SI values in the units that engineers read; and what a user gave, in one line.

Every message, warning and reason takes its units here. JSON and Python stay in SI.
"""

import reprlib
from math import log10
from typing import NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

Number = TypeVar("Number", float, NDArray[np.float64])


class Unit(NamedTuple):
    """A unit in which numbers are shown."""

    name: str
    factor: float  # by which an SI value is multiplied
    offset: float = 0.0  # added to that: of a temperature, not of a difference

    def number(self, value: Number) -> Number:
        """SI values in this unit."""
        return value * self.factor + self.offset

    def written(self, value: float, form: str) -> str:
        """An SI value in this unit, with its name."""
        return f"{self.number(value):{form}} {self.name}".rstrip()


RPM, NEWTON, NEWTON_MILLIMETRE = Unit("rpm", 30 / np.pi), Unit("N", 1.0), Unit("N mm", 1e3)
GIGAPASCAL, MILLIMETRE, MICROMETRE = Unit("GPa", 1e-9), Unit("mm", 1e3), Unit("um", 1e6)
MILLINEWTON = Unit("mN", 1e3)
DEGREE, PERCENT = Unit("deg", 180 / np.pi), Unit("%", 100.0)
SHORT = 9e-5  # m: what is shorter is shown in micrometres
LEVEL = 1e-9  # rad: a smaller angle is rounding of 0
MOST_BITS = 2000  # of a whole number in a message
MILLION = 1e6
FAST = 1e5  # rpm: faster has no digits after the point and no power of ten


def length_of(metres: float, form: str = ".4g") -> str:
    """A length in mm, or in um where it is short."""
    return (MICROMETRE if 0 < abs(metres) < SHORT else MILLIMETRE).written(metres, form)


def pressure_of(pascals: float) -> str:
    """A pressure in GPa."""
    return GIGAPASCAL.written(pascals, ".4g")


def torque_of(newton_metres: float) -> str:
    """A torque or a moment in N mm."""
    return NEWTON_MILLIMETRE.written(newton_metres, ".4g")


def speed_of(radians_per_second: float) -> str:
    """An angular velocity in rpm."""
    return RPM.written(radians_per_second, ".0f" if abs(radians_per_second) * RPM.factor >= FAST else ".5g")


def angle_of(radians: float) -> str:
    """An angle in degrees, with radians beside."""
    shown = 0.0 if abs(radians) < LEVEL else radians
    return f"{DEGREE.written(shown, '.4g')} ({shown:.4g} rad)"


def percent_of(share: float, digits: int = 3) -> str:
    """A relative number in per cent."""
    return PERCENT.written(share, ".0f" if abs(share) * PERCENT.factor >= 10**digits else f".{digits}g")


def rounded(value: float, digits: int) -> str:
    """A number to its significant digits, up to a million without a power of ten."""
    text = f"{value:.{digits}g}"
    return f"{float(text):.0f}" if "e+" in text and abs(value) < MILLION else text


class ShortRepr(reprlib.Repr):
    """A value in one line of limited length."""

    def repr_int(self, x: int, level: int) -> str:
        """Python refuses to print integers of thousands of digits."""
        if x.bit_length() > MOST_BITS:
            return f"a number of some {x.bit_length() * log10(2):.0f} digits"
        return super().repr_int(x, level)


def shown(value: object) -> str:
    """A value for a message: one line of limited length."""
    brief = ShortRepr()
    brief.maxstring = brief.maxother = 60
    brief.maxlong, brief.maxlevel, brief.maxlist, brief.maxdict = 40, 2, 3, 3
    return brief.repr(value).replace("\n", " ")  # of an array


def plain(text: str) -> str:
    """The text itself; quoted if it is long or not printable."""
    return text if text.isprintable() and len(text) <= 200 else shown(text)


def about(seconds: float) -> str:
    """A duration in words: one digit, in seconds or minutes."""
    return f"about {round(seconds / 60):d} min" if seconds >= 90 else f"about {float(f'{seconds:.1g}'):g} s"
