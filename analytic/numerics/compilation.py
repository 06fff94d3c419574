"""Functions that numba compiles, once for a machine; later processes load them without numba.

    @compiled
    def slope(x: float) -> float: ...

Python calls them as machine code, and they call each other. They take and give floats, integers, bools, arrays, and
tuples of these, named or not, and take such constants from their modules. They raise nothing: a function that fails
gives NaN or a status, and a division by zero gives infinity or NaN. `analytic.numerics.machine_code` keeps the code.
"""

import dis
import inspect
import re
import sys
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import cached_property, update_wrapper
from threading import RLock
from types import CodeType, FunctionType, ModuleType
from typing import Any, TypeVar, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.errors import StorageError
from analytic.numerics import machine_code
from analytic.numerics.machine_code import Kind, MachineCode

Function = TypeVar("Function", bound=Callable[..., Any])
Freedoms = frozenset[str]  # of the compiler with floating point: flags of LLVM
EXACT: Freedoms = frozenset()
DIVISION = "numpy"  # by zero
INSIDE = {"no_cpython_wrapper": True, "no_cfunc_wrapper": True}  # only machine code calls it; a quarter of the time
CONSTANT_MODULES = ("numpy", "math")  # others may change without a change of the byte code

MOST_TUPLES = 16  # that a function remembers
FIRST_TIME = "compiling formulas, once for this machine; this may take a minute"
said: set[str] = set()  # lines on standard error: each once a process
_making = RLock()  # LLVM takes code from one thread at a time; a function that is compiled may need another


@overload
def compiled(function: Function, /) -> Function: ...
@overload
def compiled(*, fastmath: Freedoms = EXACT, inline: bool = False) -> Callable[[Function], Function]: ...
def compiled(function: Any = None, /, *, fastmath: Freedoms = EXACT, inline: bool = False) -> Any:
    """The compiled function; inline : into others, before types are known, which is quicker where it takes many tuples.

    `inspect.unwrap` gives the same in Python.
    """
    options = {"fastmath": {*fastmath}, "inline": "always" if inline else "never"}
    return Compiled(function, options) if function else lambda function: Compiled(function, options)


class Compiled:
    """A compiled function."""

    def __init__(self, function: FunctionType, options: dict[str, Any]) -> None:
        self.function, self.options = function, options  # of numba.njit
        update_wrapper(self, function)
        self._variants: dict[Any, Callable[..., Any]] = {}  # by the kinds of the arguments
        self._of_numbers: dict[tuple[type, ...], Callable[..., Any]] = {}  # which need not be looked at
        self._tuples: dict[int, tuple[tuple[Any, ...], Any, list[Any]]] = {}  # taken apart once, by their identity

    def __call__(self, *given: Any) -> Any:
        """Raises TypeError for an argument that machine code does not take, RuntimeError where the function raises."""
        of_numbers = self._of_numbers.get(tuple(map(type, given)))
        if of_numbers is not None:
            return of_numbers(given)
        kinds, flat = [], []
        for place, value in enumerate(given):
            if isinstance(value, tuple):
                known = self._tuples.get(id(value))
                if known is None:
                    known = value, *machine_code.taken(value)
                    if len(self._tuples) >= MOST_TUPLES:
                        self._tuples.clear()
                    self._tuples[id(value)] = known
                _, kind, pieces = known
            else:
                kind, pieces = machine_code.taken(float(value) if place in self._floats else value)
            kinds.append(kind)
            flat += pieces
        variant = self._variants.get(tuple(kinds))
        if variant is None:
            with _making:
                variant = self._variants.get(tuple(kinds)) or self._variant(kinds)
                self._variants[tuple(kinds)] = variant
        if all(isinstance(value, float | int) for value in given):
            self._of_numbers[tuple(map(type, given))] = variant
        return variant(flat)

    @cached_property
    def _floats(self) -> set[int]:
        """Arguments that are floats by their annotations, and may be given as integers."""
        hints = [each.annotation for each in inspect.signature(self.function).parameters.values()]
        return {place for place, hint in enumerate(hints) if hint in (float, "float")}

    def _variant(self, kinds: list[Any]) -> Callable[..., Any]:
        name = f"{self.function.__module__}.{self.function.__qualname__}"
        key = "\n".join((*map(_text_of, kinds), *self.source()))
        made = machine_code.kept(name, key)
        if made is None:
            _say(FIRST_TIME)
            made = _compile(self, kinds)
            try:
                machine_code.keep(made, name, key)
            except (OSError, StorageError) as problem:
                _say(
                    f"compiled formulas cannot be kept ({problem}), so that every start compiles them again; give a "
                    f"folder that can be written in {machine_code.FOLDER}"
                )
        return machine_code.callable_of(made, kinds)

    def source(self) -> Iterator[str]:
        """All that the machine code depends on: byte code, constants, and the same of the functions that are called."""
        ahead: list[Compiled] = [self]
        known = {*ahead}
        while ahead:
            current = ahead.pop()
            yield f"{current.function.__qualname__} {sorted(current.options['fastmath'])} {current.options['inline']}"
            for code in _codes(current.function.__code__):
                yield f"{code.co_code.hex()} {code.co_names} {code.co_varnames}"
                yield from (repr(value) for value in code.co_consts if not isinstance(value, CodeType))
            for name, value in current.globals.items():
                if not isinstance(value, Compiled):
                    yield f"{name} {_constant(value)}"
                elif value not in known:
                    known.add(value)
                    ahead.append(value)

    @property
    def globals(self) -> dict[str, object]:
        """What it takes from its module; and, at no harm, what has the name of an attribute."""
        around = self.function.__globals__
        names = {name for code in _codes(self.function.__code__) for name in code.co_names}
        return {name: around[name] for name in sorted(names & around.keys())}

    @cached_property
    def dispatcher(self) -> Any:
        """The same for numba."""
        from numba import njit

        return njit(error_model=DIVISION, **INSIDE, **self.options)(self.of_numba())

    def of_numba(self) -> FunctionType:
        """The function with what numba calls in place of the compiled functions."""
        around, codes = self.function.__globals__, _codes(self.function.__code__)
        names = {each.argval for code in codes for each in dis.get_instructions(code) if each.opname == "LOAD_GLOBAL"}
        called = {name: around[name] for name in names if isinstance(around.get(name), Compiled)}
        numbas = {name: value.dispatcher for name, value in called.items()}
        return FunctionType(self.function.__code__, around | numbas, self.function.__name__)


def rows_of(*values: ArrayLike) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """(k, n) for a loop over n elements from k values that broadcast, and the shape of the elements."""
    shape = np.broadcast(*values).shape
    together = np.empty((len(values), *shape))
    for row, value in enumerate(values):
        together[row] = value
    return together.reshape(len(values), -1), shape


def _say(line: str) -> None:
    if line not in said:
        said.add(line)
        with suppress(OSError, AttributeError):  # it takes no more, or a process without a terminal has none
            sys.stderr.write(f"fembearing: {line}\n")


def _compile(function: Compiled, kinds: list[Any]) -> MachineCode:
    """Raises TypeError for a result that machine code cannot hand to Python."""
    from numba.core import compiler, registry, types

    def type_of(kind: Kind) -> Any:
        match kind:
            case ("array", letter, dimension, layout):
                return types.Array(getattr(types, np.dtype(letter).name), dimension, layout)
            case ("tuple", made, *inside):
                return types.BaseTuple.from_types([type_of(each) for each in inside], None if made is tuple else made)
        return getattr(types, kind)

    def kind_of(given: Any) -> Kind:
        result = types.unliteral(given)
        if isinstance(result, types.BaseTuple):
            made = getattr(result, "instance_class", None)
            name = "" if made is None else f"{made.__module__}:{made.__qualname__}"
            return ("tuple", name, *(kind_of(each) for each in tuple(cast(Any, result))))
        if isinstance(result, types.Array) and result.layout == "C":
            return ("array", np.dtype(result.dtype.name).char, result.ndim, "C")
        for name in (*machine_code.NUMBERS, "none"):
            if result == getattr(types, name):
                return name
        raise TypeError(f"{function.function.__qualname__} cannot give {result}")

    flags: Any = compiler.Flags()
    flags.nrt, flags.error_model, flags.fastmath = True, DIVISION, function.options["fastmath"]
    flags.no_cpython_wrapper = flags.no_cfunc_wrapper = True  # they need numba in the process
    target, arguments = registry.cpu_target, [type_of(kind) for kind in kinds]
    made = compiler.compile_extra(
        target.typing_context, target.target_context, function.of_numba(), arguments, None, flags, {}
    )
    return MachineCode(
        code=made.library._get_compiled_object(),
        symbol=made.fndesc.llvm_func_name,
        result=kind_of(made.signature.return_type),
        needs=re.findall(r'^declare .*?@"?(?!llvm\.)([^"( ]+)', made.library.get_llvm_str(), re.MULTILINE),
    )


def _text_of(kind: Kind) -> str:
    """A text that changes with a kind, and with the names of a tuple."""
    match kind:
        case ("tuple", made, *inside):
            return f"{made.__qualname__}{getattr(made, '_fields', '')}({', '.join(map(_text_of, inside))})"
    return str(kind)


def _codes(code: CodeType) -> Iterator[CodeType]:
    yield code
    for value in code.co_consts:
        if isinstance(value, CodeType):
            yield from _codes(value)


def _constant(value: object) -> str:
    """A text that changes with a value of a module."""
    if isinstance(value, ModuleType):
        if value.__name__ not in CONSTANT_MODULES:
            raise TypeError(f"a compiled function names {value.__name__}: import what it takes from there by name")
        return value.__name__
    if isinstance(value, tuple):
        return f"({', '.join(map(_constant, value))})"
    if isinstance(value, np.ndarray):
        return f"{value.dtype} {value.shape} {value.tobytes().hex()}"
    if isinstance(value, int | float | str | None):
        return repr(value)
    return f"{type(value).__name__} {getattr(value, '__qualname__', '')} {getattr(value, '_fields', '')}"
