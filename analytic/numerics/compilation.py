"""Loops that numba compiles, once for a machine; later processes load them without numba.

    @part()
    def _slope(x): ...

    @compiled()
    def fill(heights: Line, out: Table, count: int) -> float: ...

Python calls loops, loops call parts. The annotations of a loop are its signature: float, int, bool, arrays, and tuples
of these, named or not; it returns a number or nothing. Both take numbers, tuples, arrays and parts from their module,
as constants. A division by zero gives infinity or NaN. `analytic.numerics.machine_code` keeps the machine code.
"""

import sys
from collections.abc import Callable, Iterator
from functools import cached_property, update_wrapper
from types import BuiltinFunctionType, CodeType, FunctionType, ModuleType
from typing import Annotated, Any, get_type_hints

import numpy as np
from numpy.typing import NDArray

from analytic.numerics import machine_code

# C-contiguous arrays of one, two and three dimensions
Line = Annotated[NDArray[np.float64], 1]
Table = Annotated[NDArray[np.float64], 2]
Block = Annotated[NDArray[np.float64], 3]
Freedoms = frozenset[str]  # of the compiler with floating point: flags of LLVM
EXACT: Freedoms = frozenset()
DIVISION = "numpy"  # by zero
CONSTANT_MODULES = ("numpy", "math")  # others may change without a change of the byte code

FIRST_TIME = "compiling loops, once for this machine: up to half a minute in all"
said: set[str] = set()  # lines on standard error: each once a process


class Part:
    """A function that loops call. Called from Python it runs as Python."""

    def __init__(self, function: FunctionType, options: dict[str, Any]) -> None:
        self.function, self.options = function, options  # of numba.njit
        update_wrapper(self, function)

    def __call__(self, *given: Any) -> Any:
        return self.function(*given)

    @property
    def parts(self) -> dict[str, "Part"]:
        """The parts that it calls, by their names in its module."""
        return {name: value for name, value in self.globals.items() if isinstance(value, Part)}

    @property
    def globals(self) -> dict[str, object]:
        """What it takes from its module."""
        around = self.function.__globals__
        names = {name for code in _codes(self.function.__code__) for name in code.co_names}
        return {name: around[name] for name in sorted(names & around.keys())}

    @cached_property
    def dispatcher(self) -> Any:
        """The same for numba."""
        from numba import njit

        return njit(error_model=DIVISION, **self.options)(self.of_numba())

    def of_numba(self) -> FunctionType:
        """The function with what numba calls in place of its parts."""
        parts = {name: each.dispatcher for name, each in self.parts.items()}
        return FunctionType(self.function.__code__, self.function.__globals__ | parts, self.function.__name__)


class Loop(Part):
    """A function that Python calls as machine code; `function` is the same in Python."""

    def __call__(self, *given: Any) -> Any:
        """Raises TypeError for an array that the signature does not have, RuntimeError where the loop raises."""
        return self._call(*given)

    @cached_property
    def key(self) -> str:
        """A text that changes with what the loop does."""
        hints = get_type_hints(self.function, include_extras=True)
        return "\n".join((*map(machine_code.text_of, hints.values()), *_source_of(self)))

    @cached_property
    def _call(self) -> Callable[..., Any]:
        signature = get_type_hints(self.function, include_extras=True)
        result = signature.pop("return")
        name = f"{self.function.__module__}.{self.function.__qualname__}"
        made = machine_code.kept(name, self.key)
        if made is None:
            _say(FIRST_TIME)
            made = _compiled(self, [*signature.values()], result)
            try:
                machine_code.keep(made, name, self.key)
            except OSError as problem:
                _say(
                    f"compiled loops cannot be kept ({problem}), so that every start compiles them again; give a "
                    f"folder that can be written in {machine_code.FOLDER}"
                )
        return machine_code.callable_of(made, signature, result)


def compiled(*, fastmath: Freedoms = EXACT) -> Callable[[Callable[..., Any]], Loop]:
    """A function as a loop."""
    return lambda function: Loop(function, {"fastmath": {*fastmath}})  # pyright: ignore[reportArgumentType]


def part(*, fastmath: Freedoms = EXACT, inline: bool = False) -> Callable[[Callable[..., Any]], Part]:
    """A function as a part of loops; inline : before types are known, which is quicker where it takes many tuples."""
    options = {"fastmath": {*fastmath}, "inline": "always" if inline else "never"}
    return lambda function: Part(function, options)  # pyright: ignore[reportArgumentType]


def _say(line: str) -> None:
    if line not in said:
        said.add(line)
        sys.stderr.write(f"fembearing: {line}\n")


def _compiled(loop: Loop, arguments: list[Any], result: Any) -> machine_code.MachineCode:
    from numba.core import compiler, registry, types

    def type_of(annotation: Any) -> Any:
        shape = machine_code.array_of(annotation)
        inside = machine_code.fields_of(annotation)
        if shape is not None:
            dtype, dimension = shape
            return types.Array(getattr(types, dtype.name), dimension, "C")
        if inside is not None:
            named = annotation if isinstance(annotation, type) else None
            return types.BaseTuple.from_types([type_of(each) for each in inside], named)
        return {float: types.float64, int: types.int64, bool: types.boolean, type(None): types.none}[annotation]

    flags: Any = compiler.Flags()
    flags.nrt, flags.error_model, flags.fastmath = True, DIVISION, loop.options["fastmath"]
    flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True  # they need numba in the process
    target = registry.cpu_target
    made = compiler.compile_extra(
        target.typing_context,
        target.target_context,
        loop.of_numba(),
        [type_of(each) for each in arguments],
        type_of(result),
        flags,
        {},
    )
    return machine_code.MachineCode(code=made.library._get_compiled_object(), symbol=made.fndesc.llvm_func_name)


def _source_of(function: Part) -> Iterator[str]:
    """All that the machine code of a function depends on: its byte code, its constants and its parts."""
    ahead, known = [function], {function}
    while ahead:
        current = ahead.pop()
        yield f"{current.function.__qualname__} {sorted(current.options['fastmath'])} {current.options.get('inline')}"
        for code in _codes(current.function.__code__):
            yield f"{code.co_code.hex()} {code.co_names} {code.co_varnames}"
            yield from (repr(value) for value in code.co_consts if not isinstance(value, CodeType))
        yield from (
            f"{name} {_constant(value)}" for name, value in current.globals.items() if name not in current.parts
        )
        ahead += [each for each in current.parts.values() if each not in known]
        known |= {*current.parts.values()}


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for value in code.co_consts:
        if isinstance(value, CodeType):
            yield from _codes(value)


def _constant(value: object) -> str:
    """A text that changes with a value of a module."""
    if isinstance(value, type):
        return f"{value.__qualname__} {getattr(value, '_fields', '')}"
    if isinstance(value, BuiltinFunctionType) or (isinstance(value, ModuleType) and value.__name__ in CONSTANT_MODULES):
        return value.__name__
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {value.tobytes().hex()}"
    if isinstance(value, int | float | str | tuple | None):
        return repr(value)
    raise TypeError(f"a loop takes no {type(value).__name__} from its module")
