"""Machine code that is kept between processes: a file of the user's cache folder, loaded by LLVM without numba.

Numba takes a fifth of a second to import and a third to set up, whatever it then does. LLVM takes a twentieth and gives
the same code. The folder is FEMBEARING_CACHE, else the one of the platform for caches; it can be deleted at any time.

A kind says what a value is to machine code: "float64", "int64", "boolean" or "none"; ("array", type of the elements as
NumPy's letter, dimension, "C" where it is C-contiguous, else "A"); or ("tuple", class, kind of each element), where a
result has the class as "module:name", and "" for one without a name.
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
from types import ModuleType
from typing import Any

import llvmlite
import llvmlite.binding as llvm
import numpy as np
from numpy.typing import NDArray

from analytic.writing import remove_leftovers, replaced_file

FOLDER = "FEMBEARING_CACHE"  # of the environment
NUMBERS = {"float64": ctypes.c_double, "int64": ctypes.c_int64, "boolean": ctypes.c_bool}
# Of an array, before its shape: owner of its memory, object, number of elements, size of one, and address
ARRAY = (ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int64, ctypes.c_int64, ctypes.c_void_p)
RETURNED = (0, -2)  # statuses of numba's calling convention without an error: a value, or None

Kind = Any  # as above; in a file tuples are lists


@dataclass(frozen=True, kw_only=True)
class MachineCode:
    """One compiled function as numba's calling convention has it."""

    code: bytes  # object file
    symbol: str
    result: Kind
    needs: Sequence[str]  # functions that it calls


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
    """What machine code depends on beside its source: compiler, processor, and the two files that make and load it."""
    here = (Path(__file__).with_name(name).read_text("utf-8") for name in ("compilation.py", "machine_code.py"))
    compiler, features = (_numba() / "_version.py").read_text("utf-8"), llvm.get_host_cpu_features().flatten()
    return " ".join(
        (compiler, llvmlite.__version__, llvm.get_process_triple(), llvm.get_host_cpu_name(), features, *here)
    )


def kept(name: str, key: str) -> MachineCode | None:
    """The machine code that is kept under that name with that key.

    None: there is none, its file is damaged, or it calls what only a process with numba has.
    """
    folder = cache_folder()
    if folder is None:
        return None
    try:
        digest, header, code = _file(folder, name, key).read_bytes().split(b"\n", 2)
    except (OSError, ValueError):
        return None
    if digest != _digest(header + code):
        return None
    made = MachineCode(code=code, **json.loads(header))
    _engine()  # it brings functions of numba
    return made if all(map(llvm.address_of_symbol, made.needs)) else None


def keep(made: MachineCode, name: str, key: str) -> None:
    """Write machine code. Raises OSError or StorageError where no folder can be written."""
    folder = cache_folder()
    if folder is None:
        raise OSError("the user has no home folder")
    folder.mkdir(parents=True, exist_ok=True)
    header = json.dumps({name: value for name, value in vars(made).items() if name != "code"}).encode()
    remove_leftovers(folder)
    with replaced_file(_file(folder, name, key)) as file:
        file.write_bytes(b"\n".join((_digest(header + made.code), header, made.code)))


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


def taken(value: Any) -> tuple[Kind, list[Any]]:
    """The kind of a value, and the pieces that machine code takes for it.

    Raises TypeError for what machine code does not take.
    """
    pieces: list[Any] = []
    return _kind_of(value, pieces), pieces


def _kind_of(value: Any, pieces: list[Any]) -> Kind:
    """Append the pieces of a value."""
    if type(value) is float:  # most of what a scene is
        pieces.append(value)
        return "float64"
    match value:
        case np.ndarray():
            pieces += (None, None, value.size, value.itemsize, value.ctypes.data)
            pieces += value.shape
            pieces += value.strides
            return "array", value.dtype.char, value.ndim, "C" if value.flags.c_contiguous else "A"
        case tuple():
            return ("tuple", type(value), *[_kind_of(each, pieces) for each in value])
        case bool() | np.bool_():
            pieces.append(bool(value))
            return "boolean"
        case float():
            pieces.append(value)
            return "float64"
        case int() | np.integer():
            pieces.append(int(value))
            return "int64"
    raise TypeError(f"compiled functions take no {type(value).__name__}")


def _passed(kind: Kind) -> Iterator[type]:
    """How an argument is passed, or a result of several parts is laid out."""
    match kind:
        case str():
            yield NUMBERS[kind]
        case ["array", _, dimension, _]:
            yield from (*ARRAY, *(2 * dimension * (ctypes.c_int64,)))
        case ["tuple", _, *inside]:
            for each in inside:
                yield from _passed(each)


def _returned(kind: Kind) -> Any:
    """What a result is written to."""
    match kind:
        case "none":
            return ctypes.c_void_p
        case str():
            return NUMBERS[kind]
        case ["tuple", _, *inside]:
            parts = [_returned(each) for each in inside]
        case _:
            parts = [*_passed(kind)]
    return type("Result", (ctypes.Structure,), {"_fields_": [(f"_{index}", part) for index, part in enumerate(parts)]})


def _reader(kind: Kind) -> Callable[[Any], Any]:
    """How Python has a result."""
    match kind:
        case "none":
            return lambda _: None
        case str():
            return attrgetter("value")
    return _inner_reader(kind)


def _inner_reader(kind: Kind) -> Callable[[Any], Any]:
    """The same in a tuple; arrays are copied out of the memory that machine code gave them."""
    match kind:
        case ["array", letter, dimension, _]:
            of_array = attrgetter(*(f"_{index}" for index in (0, 2, 4, *range(5, 5 + dimension))))
            itemsize = np.dtype(letter).itemsize
            return lambda result: _array(letter, itemsize, *of_array(result))
        case ["tuple", name, *inside]:
            readers = [(f"_{index}", _inner_reader(each)) for index, each in enumerate(inside)]
            make = _class(name)._make if name else tuple
            return lambda result: make([read(getattr(result, field)) for field, read in readers])
    return lambda number: number


def _array(letter: str, itemsize: int, owner: int, size: int, address: int, *shape: int) -> NDArray[Any]:
    memory: Any = (ctypes.c_char * (size * itemsize)).from_address(address) if size else b""
    array = np.frombuffer(memory, dtype=letter, count=size).reshape(shape).copy()
    if owner:
        _release()(owner)
    return array


def _class(name: str) -> Any:
    """A class by its module, which the function that gives such tuples has imported, and name."""
    module, _, inside = name.partition(":")
    return attrgetter(inside)(sys.modules[module])


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
