"""What all nouns of a problem share: plain numbers in SI, a short `repr`, mappings that do not change."""

import copyreg
from collections.abc import Mapping
from types import MappingProxyType

from analytic.brief import Brief
from analytic.errors import InputError
from analytic.units import has_unit, unit_of, why_no_unit


def read_only(mapping: Mapping) -> MappingProxyType:
    return MappingProxyType(mapping)


# Scenes and results are sent between processes, and read-only mappings cannot be pickled without this.
copyreg.pickle(MappingProxyType, lambda mapping: (read_only, (dict(mapping),)))


def nothing() -> Mapping:
    """An empty mapping, for a field's default."""
    return read_only({})


class Noun(Brief):
    """A base of frozen dataclasses. Raises InputError for a number with a unit of its own."""

    def __post_init__(self) -> None:
        for name, value in vars(self).items():
            if type(value) is not float and value is not None and has_unit(value):
                field = f"{type(self).__name__}.{name}"
                raise InputError(why_no_unit(field, value, unit_of(field)))
