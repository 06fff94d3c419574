"""Quantities: `"7.94 mm"` in a scene file is 0.00794 for the model.

A quantity is a number and a unit; the unit is a product of names with one-digit powers. `COMMON` has the names that
scenes use; any other name is looked up in pint, whose units take a third of a second to build. Degrees and revolutions
are angles, and a radian is not a pure number: `"100 Hz"` is not an angular speed. For a speed, `"1/min"` and the like
are revolutions per minute.

A key says how its unit is read, wherever people write it: "60 C" is 60 degC, "3 KN" is 3 kN, "2,5 kN" is 2.5 kN.
"""

import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from decimal import Decimal
from functools import cache, lru_cache
from math import inf, isclose, isfinite, prod
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

NUMBER = r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d{1,4})?"
FACTOR = r"(?:[A-Za-zµμ°Ω][A-Za-z_µμ°Ω]{0,29}|%)(?:(?:\^|\*\*)?-?\d)?"
UNIT = rf"(?:1? */ *)?{FACTOR}(?: *[*/·] *{FACTOR}| +{FACTOR})*"
QUANTITY = re.compile(rf" *({NUMBER}) *({UNIT}|\") *", re.ASCII)
LONGEST = 80  # characters; limits the time of a match
RAISED = {"⁻¹": "^-1", "²": "^2", "³": "^3", "\N{DOT OPERATOR}": "·", "º": "°"}

# Units without their spaces, as people write them; pint does not know them or means something else.
SPELLINGS = {'"': "inch", "kp": "kgf", "Pas": "Pa s", "mPas": "mPa s"}
SPELLINGS |= {"Nm": "N m", "Ncm": "N cm", "Nmm": "N mm", "kNm": "kN m", "mNm": "mN m"}
IN_CONTEXT = {  # names in small letters, for keys of each SI unit. "mN" and "MN" differ by their case alone.
    "K": {"c": "degC", "°c": "degC", "degc": "degC", "f": "degF", "°f": "degF", "degf": "degF", "k": "K"},
    "N": {"n": "N", "kn": "kN"},
    "rad/s": dict.fromkeys(
        ("rpm", "r/min", "rev/min", "u/min", "tr/min", "varv/min", "1/min", "/min", "min-1", "min^-1"), "rpm"
    ),
}
TYPED = re.compile(r"\s*([+-]?[\d.,]+(?:[eE][+-]?\d+)?)\s*((?:(?:1? */|[^\d\s+_-]).*?)?)\s*")
AMBIGUOUS = re.compile(r"([+-]?[1-9]\d*),(\d{3})")  # 0,500 is no group of thousands
DECIMAL_COMMA = re.compile(r"[+-]?\d*,\d+(?:[eE][+-]?\d+)?")
# Units that are not what people mean by them: what is meant, and why it must be written so.
MISTAKEN = {
    "Hz": ("rpm", "Hz may count turns or radians"),
    "1/s": ("rpm", "1/s may count turns or radians"),
    "s-1": ("rpm", "s-1 may count turns or radians"),
    "kg": ("kgf", "kg is a mass"),
    "lb": ("lbf", "lb is a mass"),
    "lbs": ("lbf", "lbs is a mass"),
}


Powers = frozenset[tuple[str, int]]  # of root units by their names in pint


class SI(float):
    """A number of Python in SI, in a document in place of a text; a whole number too large for one is infinite."""

    unit: str

    def __new__(cls, value: float, unit: str) -> "SI":
        """unit : in SI"""
        try:
            made = super().__new__(cls, value)
        except OverflowError:
            made = super().__new__(cls, inf if value > 0 else -inf)
        made.unit = unit
        return made

    def __reduce__(self) -> tuple[Any, ...]:
        return SI, (float(self), self.unit)

    def __repr__(self) -> str:
        return f"{float(self)!r} {self.unit}"


@dataclass(frozen=True)
class Unit:
    """A unit by root units: metre, gram, second, kelvin, radian and others."""

    factor: Decimal
    powers: Powers
    zero: Decimal = Decimal(0)  # of its scale, in root units: 273.15 for degC


def _common() -> dict[str, Unit]:
    """The units that scenes use. With Decimal "7.94 mm" is 0.00794 to the last digit."""
    pi = Decimal("3.14159265358979323846264338328")
    kinds: tuple[tuple[dict[str, int], dict[str, str | Decimal]], ...] = (
        ({"meter": 1}, {"m": "1", "cm": "1e-2", "mm": "1e-3", "um": "1e-6", "µm": "1e-6", "nm": "1e-9"}),
        ({"gram": 1}, {"kg": "1e3", "g": "1", "mg": "1e-3"}),
        ({"meter": 3}, {"l": "1e-3", "ml": "1e-6"}),
        ({"second": 1}, {"s": "1", "ms": "1e-3", "min": "60"}),
        ({"kelvin": 1}, {"K": "1"}),
        ({"radian": 1}, {"rad": "1", "mrad": "1e-3", "deg": pi / 180}),
        ({"radian": 1, "second": -1}, {"rpm": pi / 30}),
        ({"gram": 1, "meter": 1, "second": -2}, {"N": "1e3", "kN": "1e6", "MN": "1e9", "mN": "1"}),
        ({"gram": 1, "meter": -1, "second": -2}, {"Pa": "1e3", "mPa": "1", "kPa": "1e6", "MPa": "1e9", "GPa": "1e12"}),
        ({"gram": 1, "meter": 2, "second": -3}, {"W": "1e3"}),
        ({"meter": 2, "second": -1}, {"cSt": "1e-6"}),
        ({}, {"%": "1e-2", "percent": "1e-2"}),
    )
    common = {
        name: Unit(Decimal(factor), frozenset(powers.items()))
        for powers, names in kinds
        for name, factor in names.items()
    }
    celsius = Unit(Decimal(1), common["K"].powers, Decimal("273.15"))
    return common | {"\N{GREEK SMALL LETTER MU}m": common["um"], "degC": celsius, "°C": celsius}


COMMON = _common()


@dataclass(frozen=True, kw_only=True)
class Dimension:
    """What a key accepts: a unit in SI, a closed range in that unit, and an example for messages."""

    unit: str  # SI; "" for a pure number, which has no unit (or percent)
    low: float
    high: float
    example: str  # as in a scene file, with its quotes

    @property
    def accepted(self) -> str:
        """The end of every message: an example."""
        return f"give for example {self.example}"

    @property
    def span(self) -> str:
        """The range, in the unit of the example: "0 to 10000 mm"."""
        low, high = (self.written(bound) for bound in (self.low, self.high))
        return f"{low} to {high} {self.shown_unit}".strip()

    def written(self, value: float) -> str:
        """The number that stands before the unit of the example; value : SI."""
        unit = self._unit(self.shown_unit)
        assert unit is not None
        return f"{float((Decimal(repr(value)) * self._si.factor - unit.zero) / unit.factor):g}"

    @property
    def shown_unit(self) -> str:
        """The unit of the example, in which messages tell the range; "" for a pure number."""
        quoted = re.match(r'"([^"]*)"', self.example)
        match = QUANTITY.fullmatch(quoted[1]) if quoted else None
        return match[2] if match else ""

    @property
    def _kind(self) -> str:
        return f"in a unit like {self.shown_unit}" if self.unit else "a pure number"

    def read(self, given: object) -> float:
        """The value in SI. Raises ValueError that says what is wrong and what is accepted."""
        return self.checked(self._in_si(given))

    def checked(self, value: float) -> float:
        """The value, which is in SI. Raises ValueError if it is out of range."""
        if not isfinite(value):
            raise ValueError(f"is not finite; {self.accepted}")
        if not self.low <= value <= self.high:
            limit = f"least {self.written(self.low)}" if value < self.low else f"most {self.written(self.high)}"
            raise ValueError(f"must be at {limit} {self.shown_unit}".rstrip() + f"; {self.accepted}")
        return value

    def tidy(self, given: str) -> str:
        """The quantity as files have it: "2,5KN" is "2.5 kN". What is none stays as it is.

        Raises ValueError for a number that can be read in two ways.
        """
        found = TYPED.fullmatch(given) if len(given) <= LONGEST else None
        if found is None:
            return given
        number, unit = found.groups()
        if group := AMBIGUOUS.fullmatch(number):
            whole, rest = group.groups()
            decimal = f"{whole}.{rest}".rstrip("0").rstrip(".")
            readings = " or ".join(f"{each} {unit}".rstrip() for each in (whole + rest, decimal))
            raise ValueError(f"is ambiguous, a comma before three digits: write {readings}")
        if DECIMAL_COMMA.fullmatch(number):
            number = number.replace(",", ".")
        return f"{number} {self._in_context(unit)}".rstrip()

    def _in_context(self, written: str) -> str:
        return IN_CONTEXT.get(self.unit, {}).get(written.replace(" ", "").replace("**", "^").lower(), written)

    def _in_si(self, given: object) -> float:
        if isinstance(given, bool) or not isinstance(given, str | int | float):
            raise ValueError(f"is not a quantity; {self.accepted}")
        if isinstance(given, int | float):
            if self.unit and not isinstance(given, SI):
                raise ValueError(f"has no unit; {self.accepted}")
            try:
                return float(given)
            except OverflowError:
                raise ValueError(f"is too large; {self.accepted}") from None
        match = QUANTITY.fullmatch(_plain_powers(self.tidy(given))) if len(given) <= LONGEST else None
        if match is None:
            raise ValueError(f"is not a number and a unit{self._hint(given)}; {self.accepted}")
        try:
            unit = self.known_unit(match[2])
        except ValueError as problem:
            raise ValueError(f"{problem}; {self.accepted}") from None
        return float((Decimal(match[1]) * unit.factor + unit.zero) / self._si.factor)

    def known_unit(self, written: str) -> Unit:
        """The unit that is written. Raises ValueError for one that is unknown or of another kind."""
        short = written if len(written) < LONGEST else ""
        match = QUANTITY.fullmatch(_plain_powers(self.tidy(f"1 {short}")))  # `unit_of` passes over other signs
        unit, remedy = None if match is None else self._unit(match[2]), self._remedy(written)
        if unit is None:
            raise ValueError(f"has the unknown unit {written[:LONGEST]!r}{remedy}")
        if unit.powers != self._si.powers:
            raise ValueError(f"is not {self._kind}{remedy}")
        return unit

    @property
    def _si(self) -> Unit:
        unit = unit_of(self.unit)
        assert unit is not None
        return unit

    def _unit(self, written: str) -> Unit | None:
        """The unit that is written; None if a name in it is unknown."""
        meant = self._in_context(written)
        return unit_of(SPELLINGS.get(meant.replace(" ", ""), meant))

    def _remedy(self, written: str) -> str:
        """What to write in place of a unit that is often mistaken for one of this dimension."""
        meant, reason = MISTAKEN.get(written.replace(" ", ""), ("", ""))
        unit = unit_of(meant) if meant else None
        return f" ({reason}: write {meant})" if unit is not None and unit.powers == self._si.powers else ""

    def _hint(self, given: str) -> str:
        if re.fullmatch(rf"\s*{NUMBER}\s*", given[:LONGEST]):
            return " (no quotes around a pure number)" if not self.unit else " (the unit is missing)"
        if re.match(r"\s*[+-]?[\d.]+,\d", given[:LONGEST]):
            return " (write a decimal point)"
        if grouped := re.match(r"\s*([+-]?\d{1,3}(?:[ _']\d{3})+)(?!\d)", given[:LONGEST]):
            return f" (write {re.sub(r'[^0-9+-]', '', grouped[1])} without spaces)"
        return ""


def _plain_powers(text: str) -> str:
    for raised, plain in RAISED.items():
        text = text.replace(raised, plain)
    return text


@lru_cache(maxsize=200)
def unit_of(text: str) -> Unit | None:
    """The product of the factors of the unit; None if a name is unknown."""
    factors: list[tuple[Unit, int]] = []
    inverse = False
    for token in re.findall(rf"{FACTOR}|[/*·]|1", text, re.ASCII):
        if token in "/*·1":
            inverse = token == "/"
            continue
        name = token.rstrip("^*-0123456789")
        unit = COMMON.get(name) or looked_up(name)
        if unit is None:
            return None
        factors.append((unit, int(token[len(name) :].lstrip("^*") or 1) * (-1 if inverse else 1)))
        inverse = False
    if [power for _, power in factors] == [1]:
        return factors[0][0]
    powers = Counter[str]()
    for unit, power in factors:
        powers.update({root: power * each for root, each in unit.powers})
        if unit.zero:
            powers["a scale with a zero of its own"] = 1
    factor = prod((unit.factor**power for unit, power in factors), start=Decimal(1))
    return Unit(factor, frozenset((root, power) for root, power in powers.items() if power))


def in_si(number: str, unit: str) -> float:
    """A number of a table in SI; unit : that of its column."""
    known = unit_of(unit)
    assert known is not None, unit
    kilogram = Decimal(1000) ** dict(known.powers).get("gram", 0)  # in place of the gram
    return float(Decimal(number) * known.factor / kilogram)


@cache
def looked_up(name: str) -> Unit | None:
    """The unit of that name in pint; None if pint does not know it, or if its scale is not even."""
    import pint

    try:
        roots = [_registry().Quantity(Decimal(number), name).to_root_units() for number in range(3)]
        zero, one, two = (each.magnitude for each in roots)
    except (pint.PintError, ArithmeticError, AttributeError, TypeError, ValueError):
        return None
    if not isclose(two - one, one - zero, rel_tol=1e-15):
        return None
    return Unit(one - zero, frozenset((root, int(power)) for root, power in roots[0].unit_items()), zero)


@cache
def _registry() -> Any:
    import pint

    return pint.UnitRegistry(non_int_type=Decimal)  # pyright: ignore[reportArgumentType]


def word_like(given: object, words: Iterable[str]) -> str | None:
    """The word that is meant, in any case and with blanks or dashes for _; None: none of them."""
    meant = re.sub(r"[\s_-]+", "_", given.strip()).casefold() if isinstance(given, str) else None
    return next((word for word in words if word.casefold() == meant), None)


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
        word = word_like(given, self.words)
        return super().read(given) if word is None else word


@dataclass(frozen=True, kw_only=True)
class Series:
    """A quantity, a list of them, or a range "FIRST to LAST in COUNT"."""

    of: Dimension

    @property
    def accepted(self) -> str:
        """The end of every message."""
        return self.of.accepted

    def read(self, given: object) -> Any:
        """The values in SI, a list. Raises ValueError as `Dimension.read`, and for an empty list."""
        if given == []:
            raise ValueError("is empty; give a quantity or a list of them")
        if isinstance(given, str) and (parts := range_of(given)) is not None:
            return parts.values(self.of.read(parts.first), self.of.read(parts.last)).tolist()
        return [self.of.read(each) for each in (given if isinstance(given, list) else [given])]


MOST = 100_000  # values of a range: more is a slip
RANGE = re.compile(r"\s*(?P<first>.+?)\s+to\s+(?P<last>.+?)\s+in\s+(?P<count>[+-]?\d+)(?P<log>\s+log)?\s*")


class Range(NamedTuple):
    """The parts of a text "FIRST to LAST in COUNT", with " log" for equal ratios."""

    first: str
    last: str
    size: int
    log: bool

    def values(self, first: float, last: float) -> NDArray[np.float64]:
        """(size,) from one end to the other, which are exact. Raises ValueError for ends or a number without sense."""
        if self.size < 2:
            raise ValueError(f"has {self.size} values: a range takes 2 or more, and one value stands alone")
        if self.size > MOST:
            raise ValueError(f"has {self.size} values, more than {MOST}; give fewer")
        if first == last:
            raise ValueError(f"is one value {self.size} times; give two different ends")
        if self.log and first * last <= 0:
            raise ValueError("is a range from 0 or through 0, which has no equal ratios; leave out log")
        values = (np.geomspace if self.log else np.linspace)(first, last, self.size)
        values[[0, -1]] = first, last
        return values


def range_of(text: str) -> Range | None:
    """The parts of a range; None for another text. Raises ValueError for a range without its number of values."""
    found = RANGE.fullmatch(text)
    if found is None and " to " in text:
        raise ValueError(f'is no range; give FIRST to LAST in COUNT, as "{text} in 15"')
    return found and Range(found["first"], found["last"], int(found["count"]), found["log"] is not None)
