"""Entries: the formulas that Python calls as machine code, which is loaded without a compiler.

    @entry(lambda: {"x": 1, "slopes": 1})
    def put_slopes(x: Array, slopes: Array) -> None: ...

An entry takes numbers, records and arrays. What it calls makes no arrays.

The code is built with the wheel, else by numba at the first use, see `analytic.numerics.building`. A file holds one
entry for one family of processors. Its name has a digest of what it was made of: the formulas of this package, the
entry's own file, and the layout of its arguments. It begins with the digest of the rest, so that a damaged file is
noticed. A wheel has its files in `OBJECTS`. Others are kept in the folder FEMBEARING_CACHE, else in the platform's
folder for caches, which can be deleted at any time.
"""

import ctypes
import hashlib
import json
import mmap
import os
import platform
import subprocess
import sys
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from functools import cache, cached_property, partial
from inspect import getfile
from pathlib import Path
from threading import Lock
from types import FunctionType
from typing import Any

import numpy as np

from analytic.errors import FembearingError, require_packages
from analytic.numerics.compilation import EXACT, Compiled, Freedoms
from analytic.processes import MODULE, environment

ENTRIES = (  # of a wheel, the longest one first
    "analytic.solve.kernel.solve",
    "analytic.cage.motion.advance",
    "analytic.loads.ring_rounds.settle_ruled_rings",
    "analytic.contact.finite_geometry_fit.geometries_on",
    "analytic.cage.raceways.roll_without_cage",
    "analytic.free_ball.strips.march_strips",
    "analytic.cage.pocket.put_pocket_coefficients",
)
BUILDER = "analytic.numerics.building"
PACKAGE = Path(__file__).parents[1]
DIGEST = 64  # characters of a digest
OBJECTS, ENDING = Path(__file__).parent / "objects", ".code"
CACHE = "FEMBEARING_CACHE"  # of the environment
UNUSED = 30 * 24 * 3600.0  # s after which a file of another version is deleted
# No formula imports these folders and files.
ABOVE = frozenset(
    {
        "any_scene",
        "columns",
        "discs",
        "effects",
        "figures",
        "function",
        "left_out",
        "limits",
        "makers",
        "pair",
        "prediction",
        "progress",
        "result",
        "scene_torque",
        "scenefile",
        "standing",
        "torque",
        "units",
        "verdicts",
    }
)
# LLVM's names of families of processors, the better ones first, with what they have.
Families = tuple[tuple[str, tuple[str, ...]], ...]
X86: Families = (("x86-64-v3", ("avx2", "bmi2", "fma")), ("x86-64", ()))
FAMILIES: dict[str, Families] = {"x86_64": X86, "amd64": X86}
GENERIC: Families = (("generic", ()),)
# Functions of the C library that code may call
OF_C = (
    *("acos", "asin", "asinh", "atan", "atan2", "cbrt", "cos", "cosh", "erf", "erfc", "exp", "exp2", "expm1", "fmod"),
    *("hypot", "log", "log10", "log1p", "log2", "memcpy", "memmove", "memset", "pow", "sin", "sinh", "sqrt", "tan"),
    "tanh",
)
# Of an argument: a type of numbers, a structured type for one record, a number of dimensions for an array of floats,
# both of these for an array of records, or a tuple of layouts with or without names.
Layout = Any
OF_WINDOWS = ("ucrtbase", "ntdll") if sys.platform == "win32" else ()  # libraries that have them there
STUB, ADDRESS = 16, 8  # bytes of a stub of `linking`, and of the address at its end
_loading = Lock()
_kept: list[Any] = []  # what holds the code: it is never freed


class CompilerError(FembearingError):
    """Formulas do not compile."""


def entry(layout: Callable[[], dict[str, Layout]], *, fastmath: Freedoms = EXACT) -> Callable[[Any], "Entry"]:
    """A formula that Python calls as machine code; it returns nothing or an integer.

    layout : gives the layout of each argument by its name, at the first use; arrays are contiguous
    """
    return lambda function: Entry(function, {"fastmath": {*fastmath}}, layout)


class Entry(Compiled):
    """A formula that Python calls as machine code."""

    def __init__(self, function: FunctionType, options: dict[str, Any], layout: Callable[[], Any]) -> None:
        super().__init__(function, options)
        self.name, self.layout = f"{function.__module__}.{function.__qualname__}", layout

    def __call__(self, *given: Any) -> int:
        return self.bound(*given)()

    def bound(self, *given: Any) -> Callable[[], int]:
        """A call with these arguments, as often as it is wanted: it reads and writes the same memory each time.

        Whoever calls keeps the arrays. Raises ValueError for an array in more than one block of memory.
        """
        numbers: list[int | float] = []
        for each in given:
            _flatten(each, numbers)
        return partial(self._machine_code, *numbers)

    @cached_property
    def _machine_code(self) -> Callable[..., int]:
        return loaded(self)


def loaded(entry: Entry, family: str | None = None) -> Callable[..., int]:
    """The machine code of an entry, for the flat arguments of `Entry.bound`.

    family : of `families`, which this machine belongs to; None: the best one
    Raises MissingPackageError where it has to be built without a compiler, and CompilerError where it fails.
    """
    family = family or _family()
    with _loading:
        kinds = [ctypes.c_double if kind is float else ctypes.c_int64 for _, kind in arguments(entry)[0]]
        code = _intact(entry, family) or _built(entry, family)
        return ctypes.CFUNCTYPE(ctypes.c_int64, *kinds)(_address(code))


def build_process(names: Iterable[str], families: Iterable[str], folder: Path) -> "subprocess.Popen[bytes]":
    """`building.build` in a process of its own, which alone loads the compiler."""
    around = environment() | {"NUMBA_OPT": "0"}  # optimised once, as a whole, the code is as fast, and built sooner
    command = [*MODULE, BUILDER, str(folder.absolute()), *families, "of", *names]
    return subprocess.Popen(command, env=around, cwd=folder)  # numba reads .numba_config.yaml in the working folder


def families() -> tuple[str, ...]:
    """Of this kind of machine, the better ones first."""
    return tuple(name for name, _ in FAMILIES.get(platform.machine().lower(), GENERIC))


def cache_folder() -> Path:
    """Where files of code are kept. Raises OSError if the user has no such folder."""
    caches = {"darwin": "~/Library/Caches", "win32": "~/AppData/Local"}.get(sys.platform, "~/.cache")
    given = os.environ.get(CACHE) or os.path.join(os.environ.get("XDG_CACHE_HOME") or caches, "fembearing")
    folder = Path(os.path.expanduser(given)).absolute()
    if "~" in folder.parts:
        raise OSError("the user has no home folder")
    return folder


@cache
def _family() -> str:
    """The best one that this machine has; an unknown processor is of the last one."""
    has: set[str] = set()
    with suppress(OSError):
        for line in Path("/proc/cpuinfo").read_text("utf-8", "replace").splitlines():
            if line.startswith("flags"):
                has = {*line.split()}
                break
    if sys.platform == "win32" and ctypes.windll.kernel32.IsProcessorFeaturePresent(40):  # AVX2: fma and bmi2 too
        has = {*X86[0][1]}
    of_machine = FAMILIES.get(platform.machine().lower(), GENERIC)
    return next(name for name, needs in of_machine if has.issuperset(needs))


def _intact(entry: Entry, family: str) -> bytes | None:
    """The code of a file that is there and not damaged."""
    for folder in (OBJECTS, cache_folder):
        with suppress(OSError):
            file = (folder if isinstance(folder, Path) else folder()) / file_name(entry, family)
            content = file.read_bytes()
            if content[:DIGEST] == digest(content[DIGEST:]):
                if folder is not OBJECTS:
                    with suppress(OSError):
                        os.utime(file)  # it is used
                return content[DIGEST:]
    return None


def _built(entry: Entry, family: str) -> bytes:
    """The code of a file that is built now."""
    import tempfile

    require_packages(f"to compile {entry.name} for this machine, fembearing", "numba", "elftools")
    _announce()
    with tempfile.TemporaryDirectory() as scratch:
        if build_process([entry.name], [family], Path(scratch)).wait():
            raise CompilerError(f"{entry.name} did not compile: see above")
        content = (Path(scratch) / file_name(entry, family)).read_bytes()
    try:
        _keep(content, cache_folder() / file_name(entry, family))
    except OSError as problem:
        _say(f"compiled formulas cannot be kept ({problem}); give a writable folder in {CACHE}")
    return content[DIGEST:]


def _keep(content: bytes, file: Path) -> None:
    file.parent.mkdir(parents=True, exist_ok=True)
    for other in file.parent.glob(f"*{ENDING}"):
        if other.stat().st_mtime < time.time() - UNUSED:
            other.unlink(missing_ok=True)
    own = file.with_suffix(f".{os.getpid()}")  # others see a whole file
    own.write_bytes(content)
    os.replace(own, file)


def _address(code: bytes) -> int:
    """Where a function is once the code of `linking.linked` is in memory of its own, which nothing can change then.

    Raises OSError where the system runs no code that a program loads.
    """
    from ctypes.util import find_library

    line, _, block = code.partition(b"\n")
    head = json.loads(line)
    libraries = [ctypes.CDLL(name) for name in OF_WINDOWS or (find_library("m"),)]
    called = (next(getattr(each, name) for each in libraries if hasattr(each, name)) for name in head["called"])
    targets = [ctypes.cast(function, ctypes.c_void_p).value for function in called]
    size, system = (
        ctypes.c_size_t(len(block)),
        ctypes.WinDLL("kernel32") if sys.platform == "win32" else ctypes.CDLL(None),
    )
    if sys.platform == "win32":
        system.VirtualAlloc.restype = ctypes.c_void_p
        place = system.VirtualAlloc(None, size, 0x3000, 0x04)  # reserved and committed, to be read and written
        if not place:
            raise OSError("no memory for code")
    else:
        memory = mmap.mmap(-1, len(block), mmap.MAP_PRIVATE | mmap.MAP_ANONYMOUS)
        _kept.append(held := ctypes.c_char.from_buffer(memory))
        place = ctypes.addressof(held)
    image = np.ctypeslib.as_array((ctypes.c_uint8 * len(block)).from_address(place))
    image[:] = np.frombuffer(block, np.uint8)
    stubs = image[len(block) - STUB * len(targets) :].reshape(-1, STUB)
    stubs[:, -ADDRESS:] = np.array(targets, np.uint64)[:, np.newaxis].view(np.uint8)
    for offset in head["addresses"]:
        image[offset : offset + ADDRESS].view(np.uint64)[:] += np.uint64(place)
    at = ctypes.c_void_p(place)
    if sys.platform == "win32":
        done = system.VirtualProtect(at, size, 0x20, ctypes.byref(ctypes.c_uint32()))  # to be read and run
    else:
        done = not system.mprotect(at, size, mmap.PROT_READ | mmap.PROT_EXEC)
        if sys.platform == "darwin":  # elsewhere the system does so
            system.sys_icache_invalidate(at, size)
    if not done:
        raise OSError("this system runs no code that a program loads; allow it for Python")
    return place + head["start"]


def arguments(entry: Entry) -> tuple[list[tuple[str, Any]], list[str]]:
    """The flat arguments with their types, structured ones for pointers, and expressions of the entry's own."""
    flat: list[tuple[str, Any]] = []
    return flat, [_expression(name, layout, flat) for name, layout in entry.layout().items()]


def _expression(name: str, layout: Layout, flat: list[tuple[str, Any]]) -> str:
    named = hasattr(layout, "_fields")
    if layout in (float, int):
        flat.append((name, layout))
        return name
    if layout is bool:
        flat.append((name, int))
        return f"{name} != 0"
    if isinstance(layout, np.dtype):
        flat.append((name, layout))
        return f"carray({name}, 1)[0]"
    if isinstance(layout, int):
        layout = np.dtype(np.float64), layout
    if not named and isinstance(layout[0], np.dtype):
        sizes = [f"{name}_{axis}" for axis in range(layout[1])]
        flat += [(name, layout[0]), *((size, int) for size in sizes)]
        return f"carray({name}, ({', '.join(sizes)},))"
    parts = layout._fields if named else range(len(layout))
    each = [_expression(f"{name}_{part}", of, flat) for part, of in zip(parts, layout, strict=True)]
    return f"{type(layout).__name__ if named else ''}({', '.join(each)},)"


def symbol(entry: Entry) -> str:
    """Name of an entry's function."""
    return entry.name.replace(".", "_")


def file_name(entry: Entry, family: str) -> str:
    """Name of a file of code."""
    made_of = hashlib.sha256(f"{sys.platform} {entry.layout()}".encode() + _formulas())
    made_of.update(Path(getfile(entry.function)).read_bytes())
    return f"{entry.name}-{made_of.hexdigest()[:16]}.{family}{ENDING}"


@cache
def _formulas() -> bytes:
    """Digest of the files of this package that formulas may come from."""
    made_of = hashlib.sha256()
    for file in sorted(PACKAGE.rglob("*.py")):
        if file.relative_to(PACKAGE).with_suffix("").parts[0] not in ABOVE:
            made_of.update(file.read_bytes())
    return made_of.digest()


def digest(code: bytes) -> bytes:
    """How a file of code begins."""
    return hashlib.sha256(code).hexdigest().encode()


@cache
def _announce() -> None:
    _say("compiling formulas, once on this machine")


def _say(line: str) -> None:
    with suppress(OSError, AttributeError):  # it takes no more, or a process without a terminal has none
        sys.stderr.write(f"fembearing: {line}\n")


def _flatten(value: Any, numbers: list[int | float]) -> None:
    if isinstance(value, np.ndarray):
        if not value.flags.c_contiguous:
            raise ValueError(f"an array of shape {value.shape} is not in one block of memory")
        numbers += (value.ctypes.data, *value.shape)
    elif isinstance(value, np.void):
        numbers.append(np.frombuffer(value, np.uint8).ctypes.data)
    elif isinstance(value, tuple):
        for each in value:
            _flatten(each, numbers)
    else:
        numbers.append(value)
