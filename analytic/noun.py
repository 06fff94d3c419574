"""What all nouns of a problem share: plain numbers in SI, known words, a short `repr`, mappings that do not change."""

import copyreg
from collections.abc import Mapping
from functools import cache
from types import MappingProxyType, NoneType, UnionType
from typing import Any, Literal, NamedTuple, Union, get_args, get_origin, get_type_hints

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.units import has_unit, unit_of, why_no_unit
from analytic.words import shown


def read_only(mapping: Mapping) -> MappingProxyType:
    return MappingProxyType(mapping)


# Scenes and results are sent between processes, and read-only mappings cannot be pickled without this.
copyreg.pickle(MappingProxyType, lambda mapping: (read_only, (dict(mapping),)))


def nothing() -> Mapping:
    """An empty mapping, for a field's default."""
    return read_only({})


class Worded(NamedTuple):
    """A field that takes known words: itself, or as the values of a mapping."""

    name: str
    is_mapping: bool
    words: tuple[str, ...]
    kinds: tuple[type, ...]  # whose objects it takes too, as None

    def require(self, owner: str, given: Any) -> None:
        """Raise InputError for any other word; owner : class of the field."""
        field = f"{owner}.{self.name}"
        if not self.is_mapping:
            self._require_known(field, given)
        elif not isinstance(given, Mapping):
            raise InputError(f"{field} must be a mapping of names to {self._choice()}, got {shown(given)}")
        else:
            for name, value in given.items():
                self._require_known(f"{field}.{name}", value)

    def _require_known(self, field: str, given: Any) -> None:
        if not (isinstance(given, str) and given in self.words) and not isinstance(given, self.kinds):
            raise InputError(f"{field} must be {self._choice()}, got {shown(given)}")

    def _choice(self) -> str:
        names = ("None" if kind is NoneType else kind.__name__ for kind in self.kinds)
        *others, last = *(f'"{word}"' for word in self.words), *names
        return f"{', '.join(others)} or {last}" if others else last


@cache
def worded_fields(noun: type) -> tuple[Worded, ...]:
    """The fields of a noun whose annotation has a Literal."""
    found = []
    for name, hint in get_type_hints(noun).items():
        is_mapping = get_origin(hint) is Mapping
        taken = get_args(hint)[1] if is_mapping else hint
        parts = get_args(taken) if get_origin(taken) in (Union, UnionType) else (taken,)
        words = tuple(word for part in parts if get_origin(part) is Literal for word in get_args(part))
        if words:
            kinds = tuple(part for part in parts if isinstance(part, type))
            found.append(Worded(name, is_mapping, words, kinds))
    return tuple(found)


class Noun(Brief):
    """A base of frozen dataclasses. Raises InputError for a number with a unit of its own, and for unknown words."""

    def __post_init__(self) -> None:
        values = vars(self)
        for name, value in values.items():
            if type(value) is not float and value is not None and has_unit(value):
                field = f"{type(self).__name__}.{name}"
                raise InputError(why_no_unit(field, value, unit_of(field)))
        for worded in worded_fields(type(self)):
            value = values[worded.name]
            # The usual word is known at once.
            if worded.is_mapping or type(value) is not str or value not in worded.words:
                worded.require(type(self).__name__, value)
