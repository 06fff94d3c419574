"""Quantities: `"7.94 mm"` in a scene file is 0.00794 for the model.

A quantity is a number and a unit; the unit is a product of names with one-digit powers. Nothing else reaches pint,
which would evaluate any expression. Degrees and revolutions are angles, and a radian is not a pure number: `"100 Hz"`
is not an angular speed.
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
FACTOR = r"(?:[A-Za-zµμ°Ω][A-Za-z_µμ°Ω]{0,29}|%)(?:(?:\^|\*\*)-?\d)?"
UNIT = rf"(?:1 */ *)?{FACTOR}(?: *[*/·] *{FACTOR}| +{FACTOR})*"
QUANTITY = re.compile(rf" *({NUMBER}) *({UNIT}) *", re.ASCII)
LONGEST = 80  # characters; limits the time of a match


@dataclass(frozen=True, kw_only=True)
class Dimension:
    """What a key accepts: a unit in SI, a closed range in that unit, and an example for messages."""

    unit: str  # SI; "" for a pure number, which has no unit (or percent)
    low: float
    high: float
    example: str  # as in a scene file, with its quotes

    @property
    def accepted(self) -> str:
        """The end of every message: range and example."""
        bounds = f"{self.low:g} to {self.high:g} {self.unit}".strip()
        return f"give {bounds}, for example {self.example}"

    @property
    def _kind(self) -> str:
        return f"in a unit like {self.unit}" if self.unit else "a pure number"

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
        match = QUANTITY.fullmatch(given) if len(given) <= LONGEST else None
        if match is None:
            raise ValueError(f"is not a number and a unit{self._hint(given)}; {self.accepted}")
        number, unit = Decimal(match[1]), _unit(match[2])
        if unit is None:
            raise ValueError(f"has the unknown unit {match[2]!r}; {self.accepted}")
        wanted = _unit(self.unit) if self.unit else _registry().Unit("percent")
        if wanted is None or _roots(unit) != _roots(wanted):
            raise ValueError(f"is not {self._kind}; {self.accepted}")
        try:
            return float(_registry().Quantity(number, unit).to(self.unit or "dimensionless").magnitude)
        except (pint.PintError, ArithmeticError):
            raise ValueError(f"is not {self._kind}; {self.accepted}") from None

    def _hint(self, given: str) -> str:
        if re.fullmatch(rf"\s*{NUMBER}\s*", given[:LONGEST]):
            return " (no quotes around a pure number)" if not self.unit else " (the unit is missing)"
        if re.match(r"\s*[+-]?\d+,\d", given[:LONGEST]):
            return " (write a decimal point)"
        return ""


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
        name, _, power = token.replace("**", "^").partition("^")
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
