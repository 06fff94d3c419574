"""What every table of a scene file is."""

from typing import get_args

from pydantic import BaseModel, ConfigDict
from pydantic.fields import FieldInfo


class Table(BaseModel):
    model_config = ConfigDict(frozen=True, extra="forbid")


def table_of(field: FieldInfo) -> type[Table] | None:
    """The class of the table that a field holds; None for a field that holds a value."""
    for kind in (field.annotation, *get_args(field.annotation)):
        if isinstance(kind, type) and issubclass(kind, Table):
            return kind
    return None
