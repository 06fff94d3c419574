"""The line that tells what the scene of a bearing of the catalogue assumes."""

import shlex
from collections.abc import Iterable


def tell_assumed(assumed: Iterable[str], *, before: str = "", change: str = "with --set KEY=VALUE") -> None:
    """Print "key = value" of what is assumed, and how to change it; nothing where nothing is assumed."""
    from fembearing.cli.console import out

    words = ", ".join(assumed)
    if words:
        out.tell(f"{before}assumed: {words}; change {change}")


def in_a_file(name: str) -> str:
    """How to change what is assumed by a command without --set; name : of the bearing."""
    return f"in a scene file: fembearing init {shlex.quote(name)}"
