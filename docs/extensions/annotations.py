"""What an annotation is made of."""

from collections.abc import Iterator
from typing import Any, Literal, get_args, get_origin


def with_parts(kind: Any) -> Iterator[Any]:
    """An annotation, all that it is made of, and what is generic in it; no words of a Literal or notes of Annotated."""
    yield kind
    if get_origin(kind) is not None:
        yield get_origin(kind)  # a class that is made for any kind of entry
    if get_origin(kind) is not Literal:
        for part in get_args(kind)[:1] if hasattr(kind, "__metadata__") else get_args(kind):
            yield from with_parts(part)


def words_in(kind: Any) -> list[str]:
    """The words of every Literal within an annotation."""
    return [str(word) for part in with_parts(kind) if get_origin(part) is Literal for word in get_args(part)]
