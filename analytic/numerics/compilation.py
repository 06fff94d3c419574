"""Functions that numba compiles once on a machine and keeps between processes.

    @compiled
    def slope(x: float) -> float: ...

Python calls them, and they call each other. They raise nothing: a function that fails gives NaN or a status, and a
division by zero gives infinity or NaN.

Numba keeps them in the folder FEMBEARING_CACHE, else in the platform's folder for caches. Numba notices a change of a
function's own file, but none of a function that it calls or of a constant that it takes. A digest of all files of this
package is therefore part of the folder's name; any of them may hold such a constant. The folder can be deleted at any
time.
"""

import gc
import hashlib
import os
import sys
import tempfile
import time
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from shutil import rmtree
from typing import Any, TypeVar, overload

import llvmlite
import numba
import numpy as np
from numba.core import event
from numpy.typing import ArrayLike, NDArray

Function = TypeVar("Function", bound=Callable[..., Any])
Freedoms = frozenset[str]  # of the compiler with floating point: flags of LLVM
EXACT: Freedoms = frozenset()

FOLDER = "FEMBEARING_CACHE"  # of the environment
PREFIX = "formulas-"  # of the folders in it, one for each version
UNUSED = 30 * 24 * 3600.0  # s after which the folder of another version is deleted
SEAL = "sha256"  # name of the file with the digest of a function's other files
COMPILING = "compiling formulas, once on this machine"
said: set[str] = set()  # lines on standard error: each once a process


def cache_folder() -> Path:
    """Where the folders of all versions are. Raises OSError if the user has none."""
    home = os.path.expanduser("~")
    caches = {"darwin": "Library/Caches", "win32": "AppData/Local"}.get(sys.platform, ".cache")
    given = os.environ.get(FOLDER) or os.path.join(os.environ.get("XDG_CACHE_HOME") or f"{home}/{caches}", "fembearing")
    if given.startswith("~"):
        raise OSError("the user has no home folder")
    return Path(given).absolute()


def _folder_of_this_version() -> Path:
    """Raises OSError if it cannot be written."""
    version = hashlib.sha256(f"{sys.version} {numba.__version__} {llvmlite.__version__}".encode())
    for file in sorted(Path(__file__).parents[1].rglob("*.*")):
        if file.is_file() and "__pycache__" not in file.parts:
            version.update(file.read_bytes())
    folder = cache_folder() / f"{PREFIX}{version.hexdigest()[:16]}"
    if not folder.exists():
        for other in cache_folder().glob(f"{PREFIX}*"):
            if other.stat().st_mtime < time.time() - UNUSED:
                rmtree(other, ignore_errors=True)
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryFile(dir=folder):  # it also marks the folder as used
        return folder


try:
    KEPT_IN, PROBLEM = _folder_of_this_version(), None
except OSError as problem:
    KEPT_IN, PROBLEM = None, problem


def _say(line: str) -> None:
    if line not in said:
        said.add(line)
        with suppress(OSError, AttributeError):  # it takes no more, or a process without a terminal has none
            sys.stderr.write(f"fembearing: {line}\n")


def _say_why(problem: OSError) -> None:
    _say(f"compiled formulas cannot be kept ({problem}); give a writable folder in {FOLDER}")


def show(count: int, most: int) -> None:
    """Called for each function that is compiled, and with a count of 0 after the last; most : functions that may be.

    A program with a progress bar puts its own function in the place of this one.
    """
    if sys.stderr is None or not sys.stderr.isatty():
        _say(COMPILING)
    else:
        with suppress(OSError):
            sys.stderr.write(f"\r\x1b[Kfembearing: {COMPILING}: {count} of at most {most}" if count else "\r\x1b[K")
            sys.stderr.flush()


class _Compilation(event.Listener):
    """Shows which functions are compiled. The garbage collector waits: types and code stay, and are many."""

    def __init__(self) -> None:
        self.functions: set[Any] = set()
        self.count = self.depth = 0
        self.collects = True

    def on_start(self, event: Any) -> None:
        if event.data["dispatcher"] in self.functions:
            if PROBLEM is not None:
                _say_why(PROBLEM)
            if self.depth == 0:
                self.collects = gc.isenabled()
                gc.disable()
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


_compilation = _Compilation()
event.register("numba:compile", _compilation)


@overload
def compiled(function: Function, /) -> Function: ...
@overload
def compiled(*, fastmath: Freedoms = EXACT, inline: bool = False) -> Callable[[Function], Function]: ...
def compiled(function: Any = None, /, *, fastmath: Freedoms = EXACT, inline: bool = False) -> Any:
    """The compiled function; inline : into others, before types are known, which is quicker where it takes many tuples.

    `inspect.unwrap` gives the same in Python.
    """
    if function is None:
        return lambda function: _compiled(function, {*fastmath}, "always" if inline else "never")
    return _compiled(function, {*fastmath}, "always" if inline else "never")


def _compiled(function: Any, fastmath: set[str], inline: str) -> Any:
    own, others = f"{function.__module__}.{function.__qualname__}", numba.config.CACHE_DIR
    numba.config.CACHE_DIR = str(KEPT_IN / own) if KEPT_IN else ""
    options: Any = {"error_model": "numpy", "nogil": True, "no_cfunc_wrapper": True, "inline": inline}
    dispatcher = numba.njit(cache=KEPT_IN is not None, fastmath=fastmath, **options)(function)
    numba.config.CACHE_DIR = others
    _compilation.functions.add(dispatcher)
    if KEPT_IN is not None:
        _guard(dispatcher)
    return dispatcher


def _guard(dispatcher: Any) -> None:
    """Have a damaged file compiled again, and a full disk keep nothing."""
    unguarded, folder = dispatcher.compile, Path(dispatcher.stats.cache_path)
    seal = folder / SEAL

    def digest() -> str:
        files = sorted(file for file in folder.iterdir() if file.suffix in (".nbi", ".nbc"))
        return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()

    def compile_guarded(signature: Any) -> Any:
        try:
            intact = seal.read_bytes() == digest().encode()
        except OSError:  # most often there is none yet
            intact = False
        try:
            if not intact:
                for index in folder.glob("*.nbi"):
                    index.unlink()
            unguarded(signature)
            if not intact or dispatcher.stats.cache_misses:
                seal.write_text(digest())
        except OSError as problem:
            _say_why(problem)
        return unguarded(signature)  # at once: numba has it

    dispatcher.compile = compile_guarded


def rows_of(*values: ArrayLike) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """(k, n) for a loop over n elements from k values that broadcast, and the shape of the elements."""
    shape = np.broadcast(*values).shape
    together = np.empty((len(values), *shape))
    for row, value in enumerate(values):
        together[row] = value
    return together.reshape(len(values), -1), shape
