"""Titles, sentences and numbers as text, which terminal, page and figures share."""

from collections.abc import Sequence

import numpy as np

from analytic.columns import MODEL_PARTS
from analytic.words import Unit, percent_of, rounded

LONGEST_LIST = 12  # values in a cell of a table
MEASURED_RANGE = "34 % too low to 10 % too high"  # of validation/measured/measured.csv, which a test compares
MEASURED = f"Against the only measured torques, of three balls in oil, the torque is {MEASURED_RANGE}."
AXES = "a along rolling (x), b transverse (y), load along z"


def capital(words: str) -> str:
    """As at the beginning of a sentence; what follows the first letter is left as it is."""
    return words[:1].upper() + words[1:]


def digits(value: float | None, factor: float = 1.0, count: int = 5, *, absent: str = "-") -> str:
    """A value with its significant digits, zeros at the end included: numbers below each other are as exact."""
    return absent if value is None else f"{value * factor:#.{count}g}".removesuffix(".")


def shown(value: float | None, form: str, factor: float = 1.0, unit: str = "", *, absent: str = "-") -> str:
    """A value in the unit of a table, `factor` times the SI value."""
    return absent if value is None else f"{value * factor:{form}}{unit}"


def between(ends: Sequence[float] | None, unit: Unit) -> str:
    """Both ends of an interval, SI, in the unit of a table."""
    return "-" if ends is None else "-".join(rounded(unit.number(end), 3) for end in ends)


def percent(value: float | None) -> str:
    """A relative number in per cent; "unknown" where nothing is known of it."""
    if value is None or not np.isfinite(value):
        return "unknown"
    return percent_of(value, 2)


def angle_cell(radians: float | None) -> str:
    """An angle in a column of degrees, with radians beside."""
    return "-" if radians is None else f"{np.degrees(radians):z.2f} ({radians:z.4f})"


def listed(values: float | Sequence[float], factor: float = 1.0) -> str:
    """Distinct values in their order; a long series by its ends."""
    series = values if isinstance(values, Sequence) else [values]
    distinct = list(dict.fromkeys(f"{value * factor:.4g}" for value in series))
    if len(distinct) > LONGEST_LIST:
        return f"{distinct[0]} to {distinct[-1]}, {len(distinct)} values"
    return ", ".join(distinct)


def input_name(key: str) -> str:
    """The name of an uncertain input for narrow places: its key in words."""
    if key.startswith("model."):
        return MODEL_PARTS[key.partition(".")[2]]
    table, _, rest = key.partition(".")
    words = rest.replace(".", " ").replace("_", " ") or "numerical uncertainty"
    return f"{words} (cage)" if table == "cage" else words
