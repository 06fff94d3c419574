"""Functions that numba compiles once on a machine and keeps between processes.

    @compiled
    def slope(x: float) -> float: ...

Python calls them, and they call each other by names of their modules, but not in a circle. They raise nothing: a
function that fails gives NaN or a status, and a division by zero gives infinity or NaN.

Numba keeps them in the folder FEMBEARING_CACHE, else in the platform's folder for caches. Numba notices a change of a
function's own code, but none of a function that it calls or of a constant that it takes. A digest of the files of this
package is therefore part of the folder's name. It leaves out the folders in ABOVE, which no compiled function imports.
A function outside this package has a folder named after the files of itself and of the functions that it calls, too;
it takes constants from these files and from this package alone. Where a package lies does not matter. The folder can
be deleted at any time.
"""

import gc
import hashlib
import os
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from functools import cache, cached_property, update_wrapper
from mmap import mmap
from pathlib import Path
from shutil import rmtree
from threading import RLock
from types import CodeType, FunctionType
from typing import Any, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

Function = TypeVar("Function", bound=Callable[..., Any])
Freedoms = frozenset[str]  # of the compiler with floating point: flags of LLVM
EXACT: Freedoms = frozenset()

FOLDER = "FEMBEARING_CACHE"  # of the environment
PREFIX = "formulas-"  # of the folders in it, one for each version
UNUSED = 30 * 24 * 3600.0  # s after which the folder of another version is deleted
ABOVE = frozenset(
    {"bearings", "effects", "materials", "prediction", "scenefile", "scenes"}
)  # formulas import none of it
SOURCE = "formulas.py"  # name of an empty file, which stands for the files of all functions
SEAL = "sha256"  # name of the file with the digest of a function's other files
PACKAGE = Path(__file__).parents[1]
COMPILING = "compiling formulas, once on this machine"
# Bytes of addresses for numba, LLVM and SciPy, and for each thread of OpenBLAS; 228 and 42 MB were measured on Linux.
ADDRESSES, ADDRESSES_OF_THREAD = 250_000_000, 45_000_000
said: set[str] = set()  # lines on standard error: each once a process
_making = RLock()  # a function must not become two for numba, and may need others


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
    """A function that numba gets with its first call: many commands need no formula, and numba is slow to import.

    What Python calls is kept, with all that it calls in it. What only formulas call is compiled within these: without
    files and entries from Python of its own it takes a third less time.
    """

    def __init__(self, function: FunctionType, options: dict[str, Any]) -> None:
        self.function, self.options = function, options  # of numba.njit
        update_wrapper(self, function)

    def __call__(self, *given: Any) -> Any:
        return self.dispatcher(*given)

    @cached_property
    def dispatcher(self) -> Any:
        """The function of numba that Python calls."""
        return self._made("dispatcher", kept_in(), {})

    @cached_property
    def inside(self) -> Any:
        """The function of numba that other formulas call."""
        return self._made("inside", None, {"no_cpython_wrapper": True})

    def _made(self, name: str, folder: Path | None, more: dict[str, Any]) -> Any:
        with _making:
            if name not in vars(self):  # another thread has made it
                vars(self)[name] = self._for_numba(folder, more)
        return vars(self)[name]

    def _for_numba(self, folder: Path | None, more: dict[str, Any]) -> Any:
        from numba import njit

        code, around = self.function.__code__, self.function.__globals__
        called = {name: each.inside for name, each in self._called().items()}
        copy = FunctionType(code, around | called, argdefs=self.function.__defaults__)
        update_wrapper(copy, self.function)
        options: Any = {"error_model": "numpy", "nogil": True, "no_cfunc_wrapper": True, **self.options, **more}
        made = njit(**options)(copy) if folder is None else _kept(copy, options, folder / self._folder_name())
        if folder is None:
            _unite_constants(made)
        _compilation().functions.add(made)
        return made

    def _called(self) -> dict[str, "Compiled"]:
        around = self.function.__globals__
        found = {name: around.get(name) for name in _names(self.function.__code__)}
        return {name: each for name, each in found.items() if isinstance(each, Compiled)}

    def _files(self) -> set[Path]:
        """Of this function and of all that it calls."""
        own = Path(self.function.__code__.co_filename)
        return {own}.union(*(each._files() for each in self._called().values()))

    def _folder_name(self) -> str:
        """With a digest of files outside this package, which is not in the name of the folder above."""
        name = f"{self.function.__module__}.{self.function.__qualname__}"
        contents = sorted(file.read_bytes() for file in self._files() if PACKAGE not in file.parents)
        return f"{name}-{hashlib.sha256(b''.join(contents)).hexdigest()[:16]}" if contents else name


@cache
def require_addresses() -> None:
    """Raise MemoryError where a limit (ulimit -v) leaves too few addresses to load numba.

    Numba loads SciPy's OpenBLAS, which raises no error there but asks for addresses without an end.
    """
    if sys.platform == "win32" or sys.modules.keys() >= {"numba", "scipy.linalg"}:  # no such limit, or they are there
        return
    import resource

    if resource.getrlimit(resource.RLIMIT_AS)[0] == resource.RLIM_INFINITY:
        return
    given = (os.environ.get(name) for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"))
    threads = next((int(each) for each in given if each and each.isdecimal()), os.cpu_count() or 1)
    needed = ADDRESSES + threads * ADDRESSES_OF_THREAD
    try:
        mmap(-1, needed).close()
    except OSError as problem:
        raise MemoryError(f"{needed / 1e6:.0f} MB of addresses are needed to load the formulas") from problem


def _names(code: CodeType) -> set[str]:
    """All that code, and comprehensions in it, may take from its module."""
    inside = (_names(value) for value in code.co_consts if isinstance(value, CodeType))
    return {*code.co_names}.union(*inside)


def rows_of(*values: ArrayLike) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """(k, n) for a loop over n elements from k values that broadcast, and the shape of the elements."""
    shape = np.broadcast(*values).shape
    together = np.empty((len(values), *shape))
    for row, value in enumerate(values):
        together[row] = value
    return together.reshape(len(values), -1), shape


def cache_folder() -> Path:
    """Where the folders of all versions are. Raises OSError if the user has none."""
    caches = {"darwin": "~/Library/Caches", "win32": "~/AppData/Local"}.get(sys.platform, "~/.cache")
    given = os.environ.get(FOLDER) or os.path.join(os.environ.get("XDG_CACHE_HOME") or caches, "fembearing")
    folder = Path(os.path.expanduser(given)).absolute()
    if "~" in folder.parts:
        raise OSError("the user has no home folder")
    return folder


@cache
def kept_in() -> Path | None:
    """The folder of this version, in which compiled functions are kept; None: it cannot be written, which is said.

    Raises MemoryError as `require_addresses`.
    """
    require_addresses()
    import llvmlite
    import numba

    version = hashlib.sha256(f"{sys.version} {numba.__version__} {llvmlite.__version__}".encode())
    for file in sorted(PACKAGE.rglob("*.*")):
        if file.is_file() and {"__pycache__", *ABOVE}.isdisjoint(file.relative_to(PACKAGE).parts):
            version.update(file.read_bytes())
    try:
        folder = cache_folder() / f"{PREFIX}{version.hexdigest()[:16]}"
        if not folder.exists():
            for other in cache_folder().glob(f"{PREFIX}*"):
                if other.stat().st_mtime < time.time() - UNUSED:
                    rmtree(other, ignore_errors=True)
        folder.mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder).close()  # it also marks the folder as used
        (folder / SOURCE).touch()
        os.utime(folder / SOURCE, (0, 0))
    except OSError as problem:
        _say_why(problem)
        return None
    return folder


def _kept(function: FunctionType, options: dict[str, Any], own: Path) -> Any:
    """own : folder of this function alone"""
    import numba
    from numba.core import config

    settings: Any = config  # it has no types
    before = settings.CACHE_DIR
    settings.CACHE_DIR = str(own)  # numba takes it from here only
    # Numba looks for the path and time of a function's file. With these of one file every checkout and environment of
    # this version has the same functions.
    code = function.__code__.replace(co_filename=str(own.parent / SOURCE))
    copy = FunctionType(code, function.__globals__, argdefs=function.__defaults__)
    made: Any = numba.njit(cache=True, **options)(update_wrapper(copy, function))
    settings.CACHE_DIR = before
    if own in Path(made.stats.cache_path).parents:
        _guard(made)
        return made
    _say_why(f"{own} is not writable")  # numba has chosen a folder that takes no notice of other files
    return numba.njit(**options)(function)


def _unite_constants(dispatcher: Any) -> None:
    """Compile a function once for all constants: 3 is no other type than 4."""
    from numba.core.types import unliteral

    each = dispatcher.compile
    dispatcher.compile = lambda given: each(tuple(map(unliteral, given)))


def _guard(dispatcher: Any) -> None:
    """Have a function with a damaged file compiled again, and do without files where none can be written."""
    from numba.core.types import unliteral

    unguarded, folder = dispatcher.compile, Path(dispatcher.stats.cache_path)
    seal = folder / SEAL

    def digest() -> bytes:
        files = sorted(file for file in folder.iterdir() if file.suffix in (".nbi", ".nbc"))
        return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest().encode()

    def compile_guarded(given: Any) -> Any:
        signature = tuple(map(unliteral, given))  # 3 is no other type than 4, which would be compiled once more
        try:
            intact = seal.exists() and seal.read_bytes() == digest()
            if not intact:
                for index in folder.glob("*.nbi"):
                    index.unlink()
            unguarded(signature)
            if not intact or dispatcher.stats.cache_misses:
                seal.write_bytes(digest())
        except OSError as problem:
            _say_why(problem)
        return unguarded(signature)  # numba has it already

    dispatcher.compile = compile_guarded


def _say(line: str) -> None:
    if line not in said:
        said.add(line)
        with suppress(OSError, AttributeError):  # it takes no more, or a process without a terminal has none
            sys.stderr.write(f"fembearing: {line}\n")


def _say_why(problem: object) -> None:
    _say(f"compiled formulas cannot be kept ({problem}); give a writable folder in {FOLDER}")


def show(count: int, most: int) -> None:
    """Called when a function is compiled, the `count`th of `most` or fewer; and with a count of 0 when that is done.

    A program with a progress bar puts its own function in the place of this one.
    """
    if sys.stderr is None or not sys.stderr.isatty():
        _say(COMPILING)
    else:
        with suppress(OSError):
            sys.stderr.write(f"\r\x1b[Kfembearing: {COMPILING}: {count} of {most}" if count else "\r\x1b[K")
            sys.stderr.flush()


@cache
def _compilation() -> Any:
    """What hears of each function that numba compiles."""
    from numba.core import event

    class Compilation(event.Listener):
        def __init__(self) -> None:
            self.functions: set[Any] = set()  # ours: the user may have others
            self.count = self.depth = 0
            self.collects = True

        def on_start(self, event: Any) -> None:
            if event.data["dispatcher"] in self.functions:
                if self.depth == 0:
                    self.collects = gc.isenabled()
                    gc.disable()  # what the compiler makes is much, and stays
                self.depth += 1
                self.count += 1
                show(self.count, len(self.functions))

        def on_end(self, event: Any) -> None:
            if event.data["dispatcher"] in self.functions:
                self.depth -= 1
                if self.depth == 0:
                    show(0, len(self.functions))
                    if self.collects:
                        gc.enable()

    listener = Compilation()
    event.register("numba:compile", listener)
    return listener
