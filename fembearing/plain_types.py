"""Results as plain Python types: what JSON is written from."""

import json
import math
from collections.abc import Mapping
from dataclasses import Field, fields, is_dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

FORMAT = 8  # of JSON, all files alike; it rises when a key changes its name or meaning
RESIDUE = 1e-15  # SI; less is round-off: in a displacement, the smallest number of a result, 1e-5 of an atom
UNWRITTEN = MappingProxyType({"written": False})  # metadata of a field that `plain` leaves out


def plain(value: Any) -> Any:
    """Dataclasses and mappings as dicts, arrays and tuples as lists, paths as texts, NaN as None, round-off as 0."""
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
    if isinstance(value, float):
        return None if math.isnan(value) else value if abs(value) > RESIDUE else 0.0
    return value


def written_fields(of: Any) -> list[Field[Any]]:
    """The fields of a dataclass that `plain` writes."""
    return [part for part in fields(of) if part.metadata.get("written", True)]


def document(kind: str, content: Any, **more: Any) -> dict[str, Any]:
    """What a file of JSON holds: its kind and format, and a result; more : other tables."""
    return {"kind": f"fembearing {kind}", "format": FORMAT} | plain(content) | plain(more)


def json_of(kind: str, content: Any, **more: Any) -> str:
    """The text of a file with this document."""
    return json.dumps(document(kind, content, **more), indent=1, allow_nan=False)
