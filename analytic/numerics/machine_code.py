"""Machine code that is kept between processes: a file of the user's cache folder, loaded by LLVM without numba.

Numba takes a fifth of a second to import and a third to set up, whatever it then does. LLVM takes a twentieth and gives
the same code. The folder is FEMBEARING_CACHE, else the one of the platform for caches; it can be deleted at any time.
"""

import ctypes
import hashlib
import os
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader, FileFinder
from importlib.util import find_spec, module_from_spec
from operator import index
from pathlib import Path
from tempfile import NamedTemporaryFile
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import llvmlite
import llvmlite.binding as llvm
import numpy as np

FOLDER = "FEMBEARING_CACHE"  # of the environment
NUMBERS = {float: ctypes.c_double, int: ctypes.c_int64, bool: ctypes.c_bool}
BEFORE_SHAPE = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p)  # of an array
RETURNED = (0, -2)  # statuses of numba's calling convention without an error: a value, or None


@dataclass(frozen=True, kw_only=True)
class MachineCode:
    """One compiled function as numba's calling convention has it."""

    code: bytes  # object file
    symbol: str


def cache_folder() -> Path | None:
    """Where machine code is kept; None: the user has no folder."""
    given, home = os.environ.get(FOLDER), os.path.expanduser("~")
    if given:
        return Path(given)
    if not os.path.isabs(home):
        return None
    caches = {"darwin": "Library/Caches", "win32": "AppData/Local"}.get(sys.platform, ".cache")
    return Path(os.environ.get("XDG_CACHE_HOME") or os.path.join(home, caches), "fembearing")


@cache
def machine() -> str:
    """What machine code depends on beside its source: compiler and processor."""
    features = llvm.get_host_cpu_features().flatten()
    compiler = (_numba() / "_version.py").read_text("utf-8")
    return " ".join((compiler, llvmlite.__version__, llvm.get_process_triple(), llvm.get_host_cpu_name(), features))


def kept(name: str, key: str) -> MachineCode | None:
    """The machine code that is kept under that name with that key; None: there is none, or the file is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    try:
        digest, symbol, code = _file(folder, name, key).read_bytes().split(b"\n", 2)
    except (OSError, ValueError):
        return None
    return MachineCode(code=code, symbol=symbol.decode()) if digest == _digest(symbol + code) else None


def keep(made: MachineCode, name: str, key: str) -> None:
    """Write machine code. Raises OSError where no folder can be written."""
    folder = cache_folder()
    if folder is None:
        raise OSError("the user has no home folder")
    folder.mkdir(parents=True, exist_ok=True)
    symbol = made.symbol.encode()
    with NamedTemporaryFile(dir=folder, delete=False) as file:
        file.write(b"\n".join((_digest(symbol + made.code), symbol, made.code)))
    os.replace(file.name, _file(folder, name, key))


def _file(folder: Path, name: str, key: str) -> Path:
    return folder / f"{name}-{_digest(f'{key} {machine()}'.encode())[:20].decode()}.code"


def _digest(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()


def array_of(annotation: Any) -> tuple[np.dtype[Any], int] | None:
    """Type of the elements and dimension of an array, from `Annotated[NDArray[np.float64], 2]`; None: another thing."""
    if get_origin(annotation) is not Annotated:
        return None
    array, dimension = get_args(annotation)
    return np.dtype(get_args(get_args(array)[1])[0]), dimension


def fields_of(annotation: Any) -> Sequence[Any] | None:
    """What a tuple, named or not, holds; None: another thing."""
    if get_origin(annotation) is tuple:
        return get_args(annotation)
    return [*get_type_hints(annotation, include_extras=True).values()] if hasattr(annotation, "_fields") else None


def text_of(annotation: Any) -> str:
    """A text that changes with what an annotation passes."""
    fields = fields_of(annotation)
    return repr(annotation) if fields is None else f"{annotation} {[text_of(field) for field in fields]}"


def callable_of(made: MachineCode, signature: Mapping[str, Any], result: Any) -> Callable[..., Any]:
    """The function in this process, which checks the arrays that it is given: machine code checks nothing.

    signature, result : annotations of the arguments and of what it returns
    """
    _engine().add_object_file(llvm.ObjectFileRef.from_data(made.code))
    _engine().finalize_object()
    passed = [_passed(name, annotation) for name, annotation in signature.items()]
    kinds = [ctypes.c_void_p, ctypes.c_void_p, *(kind for each, _ in passed for kind in each)]
    native = ctypes.CFUNCTYPE(ctypes.c_int, *kinds)(_engine().get_function_address(made.symbol))
    number = NUMBERS.get(result, ctypes.c_int64)

    def call(*given: Any) -> Any:
        value, problem = number(), ctypes.c_void_p()
        flat = [piece for (_, pieces), each in zip(passed, given, strict=True) for piece in pieces(each)]
        status = native(ctypes.byref(value), ctypes.byref(problem), *flat)
        if status not in RETURNED:
            raise RuntimeError(f"{made.symbol} ended with status {status}")
        return value.value if result in NUMBERS else None

    return call


def _passed(name: str, annotation: Any) -> tuple[Sequence[type], Callable[[Any], Iterable[Any]]]:
    """Of one argument: the types that the machine code takes, and the function that takes a value apart into these."""
    shape, fields = array_of(annotation), fields_of(annotation)
    if shape is not None:
        dtype, dimension = shape

        def of_array(array: Any) -> Iterable[Any]:
            if array.dtype != dtype or array.ndim != dimension or not array.flags.c_contiguous:
                raise TypeError(
                    f"{name} is {array.dtype} of shape {array.shape} and strides {array.strides}, not a C-contiguous "
                    f"array of {dtype} with {dimension} dimensions"
                )
            return None, None, array.size, array.itemsize, array.ctypes.data, *array.shape, *array.strides

        return (*BEFORE_SHAPE, *(2 * dimension * (ctypes.c_int64,))), of_array
    if fields is not None:
        inside = [_passed(name, field) for field in fields]

        def of_tuple(values: Any) -> Iterable[Any]:
            return [piece for (_, pieces), each in zip(inside, values, strict=True) for piece in pieces(each)]

        return [kind for kinds, _ in inside for kind in kinds], of_tuple
    whole = index if annotation is int else lambda number: number  # ctypes takes no integers of NumPy
    return (NUMBERS[annotation],), lambda number: (whole(number),)


@cache
def _engine() -> llvm.ExecutionEngine:
    """What machine code lives in until the process ends."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    for name, address in _memory().items():
        llvm.add_symbol(name, address)
    target = llvm.Target.from_default_triple().create_target_machine(jit=True)
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), target)


def _memory() -> dict[str, int]:
    """Addresses of the functions that give arrays their memory: a part of numba that needs nothing of the others."""
    finder = FileFinder(str(_numba() / "core" / "runtime"), (ExtensionFileLoader, EXTENSION_SUFFIXES))
    found = finder.find_spec("_nrt_python")
    assert found is not None
    assert found.loader is not None
    runtime = module_from_spec(found)
    found.loader.exec_module(runtime)
    return {name if name.startswith("_") else f"NRT_{name}": address for name, address in runtime.c_helpers.items()}


def _numba() -> Path:
    """The folder of numba, which is not imported."""
    found = find_spec("numba")
    assert found is not None
    assert found.origin is not None
    return Path(found.origin).parent
