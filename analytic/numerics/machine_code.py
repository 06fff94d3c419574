"""Machine code that is kept between processes: a file of the user's cache folder, loaded by LLVM without numba.

Numba takes a fifth of a second to import and a third to set up, whatever it then does. LLVM takes a twentieth and gives
the same code. The folder is FEMBEARING_CACHE, else the one of the platform for caches; it can be deleted at any time.

A kind says what a value is to machine code: `float64`, `int64` or `boolean`, `none`; `("d", 2, "C")` for an array
of two dimensions, with NumPy's letter of its type, "A" where it is not C-contiguous; and a list of kinds for a tuple.
"""

import ctypes
import hashlib
import json
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from importlib.machinery import EXTENSION_SUFFIXES, ExtensionFileLoader, FileFinder
from importlib.util import find_spec, module_from_spec
from operator import attrgetter
from pathlib import Path
from tempfile import NamedTemporaryFile
from types import ModuleType
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np

FOLDER = "FEMBEARING_CACHE"  # of the environment
NUMBERS = {"float64": ctypes.c_double, "int64": ctypes.c_int64, "boolean": ctypes.c_bool}
# Of an array, before its shape: owner of its memory, object, number of elements, size of one, and address
ARRAY = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p)
RETURNED = (0, -2)  # statuses of numba's calling convention without an error: a value, or None

Kind = Any


@dataclass(frozen=True, kw_only=True)
class MachineCode:
    """One compiled function as numba's calling convention has it."""

    code: bytes  # object file
    symbol: str
    result: Kind


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
    compiler, features = (_numba() / "_version.py").read_text("utf-8"), llvm.get_host_cpu_features().flatten()
    return " ".join((compiler, llvmlite.__version__, llvm.get_process_triple(), llvm.get_host_cpu_name(), features))


def kept(name: str, key: str) -> MachineCode | None:
    """The machine code that is kept under that name with that key; None: there is none, or the file is damaged."""
    folder = cache_folder()
    if folder is None:
        return None
    try:
        digest, header, code = _file(folder, name, key).read_bytes().split(b"\n", 2)
    except (OSError, ValueError):
        return None
    return MachineCode(code=code, **json.loads(header)) if digest == _digest(header + code) else None


def keep(made: MachineCode, name: str, key: str) -> None:
    """Write machine code. Raises OSError where no folder can be written."""
    folder = cache_folder()
    if folder is None:
        raise OSError("the user has no home folder")
    folder.mkdir(parents=True, exist_ok=True)
    header = json.dumps({"symbol": made.symbol, "result": made.result}).encode()
    with NamedTemporaryFile(dir=folder, delete=False) as file:
        file.write(b"\n".join((_digest(header + made.code), header, made.code)))
    os.replace(file.name, _file(folder, name, key))


def _file(folder: Path, name: str, key: str) -> Path:
    return folder / f"{name}-{_digest(f'{key} {machine()}'.encode())[:20].decode()}.code"


def _digest(content: bytes) -> bytes:
    return hashlib.sha256(content).hexdigest().encode()


def callable_of(made: MachineCode, kinds: Sequence[Kind]) -> Callable[[Sequence[Any]], Any]:
    """The function in this process, by the pieces of its arguments; kinds : of the arguments."""
    _engine().add_object_file(llvm.ObjectFileRef.from_data(made.code))
    _engine().finalize_object()
    passed = (ctypes.c_void_p, ctypes.c_void_p, *(part for kind in kinds for part in _passed(kind)))
    native = ctypes.CFUNCTYPE(ctypes.c_int, *passed)(_engine().get_function_address(made.symbol))
    returned, read, byref = _returned(made.result), _reader(made.result), ctypes.byref

    def call(pieces: Sequence[Any]) -> Any:
        value, problem = returned(), ctypes.c_void_p()
        status = native(byref(value), byref(problem), *pieces)
        if status not in RETURNED:
            raise RuntimeError(f"{made.symbol} ended with status {status}")
        return read(value)

    return call


def taken(value: Any) -> tuple[Any, list[Any]]:
    """The kind of a value, of tuples as tuples with their class first, and the pieces that machine code takes for it.

    Raises TypeError for what machine code does not take.
    """
    match value:
        case np.ndarray():
            layout = "C" if value.flags.c_contiguous else "A"
            pieces = [None, None, value.size, value.itemsize, value.ctypes.data, *value.shape, *value.strides]
            return (value.dtype.char, value.ndim, layout), pieces
        case bool() | np.bool_():
            return "boolean", [bool(value)]
        case float():
            return "float64", [value]
        case int() | np.integer():
            return "int64", [int(value)]
        case tuple():
            inside = [taken(each) for each in value]
            return (type(value), *(kind for kind, _ in inside)), [piece for _, pieces in inside for piece in pieces]
    raise TypeError(f"compiled functions take no {type(value).__name__}")


def _passed(kind: Kind) -> Iterator[type]:
    """How an argument is passed."""
    if isinstance(kind, list):
        for each in kind:
            yield from _passed(each)
    elif isinstance(kind, tuple):
        yield from (*ARRAY, *(2 * kind[1] * (ctypes.c_int64,)))
    else:
        yield NUMBERS[kind]


def _returned(kind: Kind) -> Any:
    """What a result is written to."""
    if kind == "none":
        return ctypes.c_void_p
    if isinstance(kind, str):
        return NUMBERS[kind]
    parts = list(_passed(tuple(kind))) if _is_array(kind) else [_returned(each) for each in kind]
    return type("Result", (ctypes.Structure,), {"_fields_": [(f"_{index}", part) for index, part in enumerate(parts)]})


def _is_array(kind: Sequence[Any]) -> bool:
    return len(kind) == 3 and isinstance(kind[1], int)


def _reader(kind: Kind) -> Callable[[Any], Any]:
    """How Python has a result; arrays are copied out of the memory that machine code gave them."""
    if kind == "none":
        return lambda _: None
    if isinstance(kind, str):
        return attrgetter("value")
    return lambda result: _value(result, kind)


def _value(result: Any, kind: Kind) -> Any:
    if isinstance(kind, str):  # inside a tuple
        return result
    fields = [getattr(result, name) for name, *_ in result._fields_]
    if not _is_array(kind):
        return tuple(map(_value, fields, kind))
    owner, _, size, itemsize, address = fields[: len(ARRAY)]
    shape = fields[len(ARRAY) : len(ARRAY) + kind[1]]
    memory = (ctypes.c_char * (size * itemsize)).from_address(address) if size else b""
    array = np.frombuffer(memory, dtype=kind[0], count=size).reshape(shape).copy()
    if owner:
        _release()(owner)
    return array


@cache
def _engine() -> llvm.ExecutionEngine:
    """What machine code lives in until the process ends."""
    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    for prefix, module in (("NRT_", _memory()), ("numba_", _extension(".", "_helperlib"))):
        for name, address in module.c_helpers.items():
            llvm.add_symbol(name if name.startswith("_") else prefix + name, address)
    target = llvm.Target.from_default_triple().create_target_machine(jit=True)
    return llvm.create_mcjit_compiler(llvm.parse_assembly(""), target)


@cache
def _release() -> Callable[[int], None]:
    """The function that gives the memory of an array back."""
    return ctypes.CFUNCTYPE(None, ctypes.c_void_p)(_memory().c_helpers["MemInfo_release"])


@cache
def _memory() -> ModuleType:
    """The functions that give arrays their memory."""
    return _extension("core/runtime", "_nrt_python")


def _extension(folder: str, name: str) -> ModuleType:
    """A part of numba in C, which needs nothing of the others."""
    finder = FileFinder(str(_numba() / folder), (ExtensionFileLoader, EXTENSION_SUFFIXES))
    found = finder.find_spec(name)
    assert found is not None
    assert found.loader is not None
    extension = module_from_spec(found)
    found.loader.exec_module(extension)
    return extension


def _numba() -> Path:
    """The folder of numba, which is not imported."""
    found = find_spec("numba")
    assert found is not None
    assert found.origin is not None
    return Path(found.origin).parent
