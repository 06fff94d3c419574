"""Options that several commands have in common, beside the parameters of their functions."""

import inspect
from collections.abc import Callable, Mapping
from contextvars import ContextVar
from functools import wraps
from types import MappingProxyType
from typing import Any

Command = Callable[..., None]
NOTHING: Mapping[str, Any] = MappingProxyType({})
GIVEN: ContextVar[Mapping[str, Any]] = ContextVar("given", default=NOTHING)  # by the added options of the command


def with_options(options: Mapping[str, Any]) -> Callable[[Command], Command]:
    """Adds options, annotations by name, to a command whose function need not take them: `given` has what they say."""

    def adding(command: Command) -> Command:
        @wraps(command)
        def run(**arguments: Any) -> None:
            before = GIVEN.set({**GIVEN.get(), **{name: arguments.pop(name) for name in options}})
            try:
                command(**arguments)
            finally:
                GIVEN.reset(before)

        own = inspect.signature(command)
        kind = inspect.Parameter.KEYWORD_ONLY
        added = [inspect.Parameter(name, kind, default=None, annotation=option) for name, option in options.items()]
        vars(run)["__signature__"] = own.replace(parameters=[*own.parameters.values(), *added])
        return run

    return adding


def given(options: Mapping[str, Any]) -> dict[str, Any]:
    """What is given of these options."""
    return {name: value for name, value in GIVEN.get().items() if name in options and value is not None}
