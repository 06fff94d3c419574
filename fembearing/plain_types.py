"""Results as plain Python types: what JSON is written from."""

import math
from collections.abc import Mapping
from dataclasses import Field, fields, is_dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

UNWRITTEN = MappingProxyType({"written": False})  # metadata of a field that `plain` leaves out


def plain(value: Any) -> Any:
    """Dataclasses and mappings as dicts, arrays and tuples as lists, paths as texts, NaN as None."""
    if is_dataclass(value):
        return {part.name: plain(getattr(value, part.name)) for part in written_fields(value)}
    if isinstance(value, Mapping):
        return {name: plain(part) for name, part in value.items()}
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, tuple | list):
        return [plain(part) for part in value]
    if isinstance(value, Path):
        return str(value)
    return None if isinstance(value, float) and math.isnan(value) else value


def written_fields(of: Any) -> list[Field[Any]]:
    """The fields of a dataclass that `plain` writes."""
    return [part for part in fields(of) if part.metadata.get("written", True)]
