"""Quantities: `"7.94 mm"` in a scene file is 0.00794 for the model.

A quantity is a number and a unit; the unit is a product of names with one-digit powers. Nothing else reaches pint,
which would evaluate any expression. Degrees and revolutions are angles, and a radian is not a pure number: `"100 Hz"`
is not an angular speed. For a speed, `"1/min"` and the like are revolutions per minute.
"""

import re
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, lru_cache
from math import isfinite
from typing import Any

import pint
from pydantic_core import CoreSchema, core_schema

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,4})?"
FACTOR = r"(?:[A-Za-zµμ°Ω][A-Za-z_µμ°Ω]{0,29}|%)(?:(?:\^|\*\*)?-?\d)?"
UNIT = rf"(?:1? */ *)?{FACTOR}(?: *[*/·] *{FACTOR}| +{FACTOR})*"
QUANTITY = re.compile(rf" *({NUMBER}) *({UNIT}|\") *", re.ASCII)
LONGEST = 80  # characters; limits the time of a match
RAISED = {"⁻¹": "^-1", "²": "^2", "³": "^3"}

# Units without their spaces, as people write them; pint does not know them or means something else.
SPELLINGS = {'"': "inch", "kp": "kgf"}
SPEEDS = dict.fromkeys(("RPM", "Rpm", "r/min", "rev/min", "U/min", "1/min", "/min", "min-1", "min^-1"), "rpm")
# Units that are not what people mean by them: what is meant, and why it must be written so.
MISTAKEN = {
    "C": ("degC", "C is coulomb"),
    "F": ("degF", "F is farad"),
    "Hz": ("rpm", "Hz may count turns or radians"),
    "1/s": ("rpm", "1/s may count turns or radians"),
    "s-1": ("rpm", "s-1 may count turns or radians"),
    "kg": ("kgf", "kg is a mass"),
    "lb": ("lbf", "lb is a mass"),
    "lbs": ("lbf", "lbs is a mass"),
    "Nm": ("N m", "units stand apart"),
    "Nmm": ("N mm", "units stand apart"),
    "kNm": ("kN m", "units stand apart"),
    "Pas": ("Pa s", "units stand apart"),
    "mPas": ("mPa s", "units stand apart"),
}


@dataclass(frozen=True, kw_only=True)
class Dimension:
    """What a key accepts: a unit in SI, a closed range in that unit, and an example for messages."""

    unit: str  # SI; "" for a pure number, which has no unit (or percent)
    low: float
    high: float
    example: str  # as in a scene file, with its quotes

    @property
    def accepted(self) -> str:
        """The end of every message: range, in the unit of the example, and example."""
        low, high = (_registry().Quantity(Decimal(repr(bound)), self.unit) for bound in (self.low, self.high))
        shown = " to ".join(
            f"{float(bound.to(self.shown_unit or 'dimensionless').magnitude):g}" for bound in (low, high)
        )
        return f"give {shown} {self.shown_unit}".strip() + f", for example {self.example}"

    @property
    def shown_unit(self) -> str:
        """The unit of the example, in which messages tell the range; "" for a pure number."""
        quoted = re.match(r'"([^"]*)"', self.example)
        match = QUANTITY.fullmatch(quoted[1]) if quoted else None
        return match[2] if match else ""

    @property
    def _kind(self) -> str:
        return f"in a unit like {self.shown_unit}" if self.unit else "a pure number"

    def __get_pydantic_core_schema__(self, _source: object, _handler: object) -> CoreSchema:
        """Makes `Annotated[float, Dimension(...)]` a field of a table."""
        return core_schema.no_info_plain_validator_function(self.field_value)

    def field_value(self, given: object) -> Any:
        """What a field of a table holds; the errors of read."""
        return self.read(given)

    def read(self, given: object) -> float:
        """The value in SI. Raises ValueError that says what is wrong and what is accepted."""
        return self.checked(self._in_si(given))

    def checked(self, value: float) -> float:
        """The value, which is in SI. Raises ValueError if it is out of range."""
        if not isfinite(value):
            raise ValueError(f"is not finite; {self.accepted}")
        if not self.low <= value <= self.high:
            raise ValueError(f"is out of range; {self.accepted}")
        return value

    def _in_si(self, given: object) -> float:
        if isinstance(given, bool) or not isinstance(given, str | int | float):
            raise ValueError(f"is not a quantity; {self.accepted}")
        if isinstance(given, int | float):
            if self.unit:
                raise ValueError(f"has no unit; {self.accepted}")
            try:
                return float(given)
            except OverflowError:
                raise ValueError(f"is too large; {self.accepted}") from None
        match = QUANTITY.fullmatch(_plain_powers(given)) if len(given) <= LONGEST else None
        if match is None:
            raise ValueError(f"is not a number and a unit{self._hint(given)}; {self.accepted}")
        number, unit = Decimal(match[1]), self._unit(match[2])
        remedy = self._remedy(match[2])
        if unit is None:
            raise ValueError(f"has the unknown unit {match[2]!r}{remedy}; {self.accepted}")
        if not self._fits(unit):
            raise ValueError(f"is not {self._kind}{remedy}; {self.accepted}")
        try:
            return float(_registry().Quantity(number, unit).to(self.unit or "dimensionless").magnitude)
        except (pint.PintError, ArithmeticError):
            raise ValueError(f"is not {self._kind}{remedy}; {self.accepted}") from None

    def _unit(self, written: str) -> pint.Unit | None:
        """The unit that is written; None if a name in it is unknown."""
        compact = written.replace(" ", "").replace("**", "^")
        spellings = SPELLINGS | SPEEDS if self.unit == "rad/s" else SPELLINGS
        return _unit(spellings.get(compact, written))

    def _fits(self, unit: pint.Unit) -> bool:
        wanted = _unit(self.unit) if self.unit else _registry().Unit("percent")
        return wanted is not None and _roots(unit) == _roots(wanted)

    def _remedy(self, written: str) -> str:
        """What to write in place of a unit that is often mistaken for one of this dimension."""
        meant, reason = MISTAKEN.get(written.replace(" ", ""), ("", ""))
        unit = _unit(meant) if meant else None
        return f" ({reason}: write {meant})" if unit is not None and self._fits(unit) else ""

    def _hint(self, given: str) -> str:
        if re.fullmatch(rf"\s*{NUMBER}\s*", given[:LONGEST]):
            return " (no quotes around a pure number)" if not self.unit else " (the unit is missing)"
        if re.match(r"\s*[+-]?\d+,\d", given[:LONGEST]):
            return " (write a decimal point)"
        return ""


def _plain_powers(text: str) -> str:
    for raised, plain in RAISED.items():
        text = text.replace(raised, plain)
    return text


@cache
def _registry() -> pint.UnitRegistry:
    # With Decimal "7.94 mm" is 0.00794 to the last digit. Pint documents Decimal, but its annotation allows only float.
    return pint.UnitRegistry(non_int_type=Decimal)  # pyright: ignore[reportArgumentType]


@lru_cache(maxsize=200)  # pint takes half a millisecond for a unit, and scene files repeat the same few
def _unit(text: str) -> pint.Unit | None:
    """The product of the factors of the unit; None if a name is unknown."""
    product = _registry().Unit("dimensionless")
    inverse, known = False, True
    for token in re.findall(rf"{FACTOR}|[/*·]|1", text, re.ASCII):
        if token in "/*·1":
            inverse = token == "/"
            continue
        name = token.rstrip("^*-0123456789")
        power = token[len(name) :].lstrip("^*")
        try:
            factor = _registry().Unit("percent" if name == "%" else name)
        except (pint.PintError, AttributeError, TypeError, ValueError):
            known = False
            break
        product = product * factor ** (int(power or 1) * (-1 if inverse else 1))
        inverse = False
    return product if known else None


@lru_cache(maxsize=200)
def _roots(unit: pint.Unit) -> pint.Unit:
    """The unit in root units (metre, gram, second, kelvin, radian ...): the same for all units of one dimension."""
    return _registry().get_root_units(unit)[1]


@dataclass(frozen=True, kw_only=True)
class QuantityOrWord(Dimension):
    """A quantity, or one of a few words in its place."""

    words: tuple[str, ...]
    meaning: str  # what the words stand for

    @property
    def accepted(self) -> str:
        return f"{super().accepted}, or {self.meaning}: {', '.join(self.words)}"

    def read(self, given: object) -> Any:
        """The value in SI, or the word. Raises ValueError as `Dimension.read`."""
        return given if given in self.words else super().read(given)
