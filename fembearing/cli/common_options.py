"""Options that mean the same in every command that has them: --quiet, --verbose, --force, --units."""

from collections.abc import Callable
from contextlib import ExitStack, contextmanager
from contextvars import ContextVar, Token
from functools import wraps
from typing import TYPE_CHECKING, Annotated, Any, TypeVar

import typer

from fembearing.cli.added_options import Command, given, with_options
from fembearing.cli.status import TALK

if TYPE_CHECKING:
    from collections.abc import Iterator

QUIET: dict[str, Any] = {
    "quiet": Annotated[
        bool,
        typer.Option("--quiet", "-q", help="Print no progress, and no warnings but those of how the input was read."),
    ]
}
VERBOSE: dict[str, Any] = {
    "verbose": Annotated[bool, typer.Option("--verbose", "-v", help="Print each step with its time on standard error.")]
}
FORCE: dict[str, Any] = {
    "force": Annotated[
        bool,
        typer.Option("--force", help="Replace an existing file, or a folder with files of fembearing only."),
    ]
}
Value = TypeVar("Value")


def with_common(options: dict[str, Any]) -> Callable[[Command], Command]:
    """Adds some of these options to a command, and does what they say while it runs."""

    def adding(command: Command) -> Command:
        @with_options(options)
        @wraps(command)
        def run(**arguments: Any) -> None:
            flags = given(QUIET | VERBOSE | FORCE)
            if flags.get("quiet") and flags.get("verbose"):
                from analytic.errors import InputError

                raise InputError("--quiet and --verbose exclude each other: leave one of them out")
            with ExitStack() as stack:
                talk = "quiet" if flags.get("quiet") else "verbose" if flags.get("verbose") else "usual"
                stack.enter_context(_set(TALK, talk))
                if flags.get("force"):
                    from analytic.writing import REPLACES

                    stack.enter_context(_set(REPLACES, True))
                command(**arguments)

        return run

    return adding


@contextmanager
def _set(variable: ContextVar[Value], value: Value) -> "Iterator[None]":
    before: Token[Value] = variable.set(value)
    try:
        yield
    finally:
        variable.reset(before)
