"""Files and folders that appear whole or not at all: the one place through which anything is written.

What is being made lies in a hidden folder, `.fembearing-TOKEN`, until it is whole. The process that makes it holds a
lock on that folder, which the system ends with the process, so that a later run removes what a killed one left
(`remove_leftovers`).

Every write has named steps, and `at_step` is called at each: "make" before a hidden file or folder is made, "write" and
"written" around the content of a file, "rename" and "renamed" around taking the final name, "remove" before something
is removed. A program that kills a process or fills a disk at a step puts its own function in the place of `at_step`; an
OSError that it raises is what the system would have said.
"""

import errno
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager, suppress
from contextvars import ContextVar
from functools import partial
from pathlib import Path
from secrets import token_hex
from typing import Literal

from analytic.errors import InputError, StorageError

try:
    import fcntl
except ImportError:  # Windows: what a killed process left stays
    fcntl = None

Step = Literal["make", "write", "written", "rename", "renamed", "remove"]

FULL = {errno.ENOSPC, errno.EDQUOT}
BROKEN = {*FULL, errno.EFBIG, errno.EIO}  # the disk's fault: another name beside it would not help
TAKEN = {errno.EEXIST, errno.ENOTEMPTY, errno.ENOTDIR, errno.EISDIR}
HIDDEN, BYTES = ".fembearing-", 8  # how the name of a hidden folder begins, and of its random end
LISTING = ".fembearing"  # in a folder of ours: the names of its files
REPLACES = ContextVar("REPLACES", default=False)  # whether what is new takes the place of what is there


def at_step(step: Step, path: Path) -> None:
    """Called at each step of a write; path : what it makes, writes, names or removes. It does nothing."""


@contextmanager
def new_folder(target: Path) -> Iterator[Path]:
    """A folder to fill that takes its name only when all went well; else nothing of it is left.

    With REPLACES it takes the place of a folder that this function made, and in which nothing else lies.
    Raises InputError, before anything is filled in, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_new(target, _strange_in)
    remove_leftovers(target.parent)
    with _apart(target, make=Path.mkdir) as apart:
        yield apart
        write(apart / LISTING, "".join(f"{path.name}\n" for path in sorted(apart.iterdir())))
        is_there = REPLACES.get() and os.path.lexists(target)
        _take_name(target, partial(_change_places, apart) if is_there else apart.rename)


@contextmanager
def new_file(target: Path) -> Iterator[Path]:
    """A file to write that takes its name only when all went well; else nothing of it is left.

    With REPLACES it takes the place of a file.
    Raises InputError, before anything is written, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_new(target, _no_file)
    remove_leftovers(target.parent)
    with _apart(target) as apart:
        with being_written(apart, named=target):
            yield apart
        _require_new(target, _no_file)  # somebody may have made it meanwhile
        _take_name(target, apart.replace if REPLACES.get() else apart.rename)


@contextmanager
def replaced_file(target: Path, *, besides: str = "") -> Iterator[Path]:
    """A file to write that takes its name, and the place of what has it, only when all went well.

    besides : what else to say where it cannot be written
    Raises InputError where it cannot be made, StorageError for a full disk. What killed processes left stays until
    `remove_leftovers`.
    """
    with _apart(target) as apart:
        with being_written(apart, named=target, besides=besides):
            yield apart
        _take_name(target, apart.replace, besides)


@contextmanager
def _apart(target: Path, make: Callable[[Path], None] = Path.touch) -> Iterator[Path]:
    """What will be the target, in a hidden folder beside it."""
    with ExitStack() as stack:
        try:
            apart = stack.enter_context(scratch_folder(target.parent)) / target.name
            make(apart)
        except OSError as problem:
            if problem.errno in BROKEN:
                raise StorageError(_unwritten(str(target), problem)) from problem
            raise InputError(
                f"{_place(target)} cannot be made in {str(target.parent)!r}: {problem.strerror}; give a name in a "
                "folder that you may write"
            ) from problem
        yield apart


@contextmanager
def scratch_folder(parent: Path) -> Iterator[Path]:
    """A hidden folder for files of a moment. Raises OSError where it cannot be made."""
    apart, lock = _held_folder(parent)
    try:
        yield apart
    finally:
        _remove(apart)
        os.close(lock)


@contextmanager
def being_written(path: Path, *, named: Path | None = None, besides: str = "") -> Iterator[None]:
    """A block that writes one file; named : what the file is to users;  besides : what else to say.

    Raises StorageError, with the reason and the remedy, where it cannot be written.
    """
    try:
        at_step("write", path)
        yield
        at_step("written", path)
    except (OSError, RuntimeError) as problem:
        if isinstance(problem, RuntimeError) and "NetCDF" not in str(problem):  # its error for a full disk
            raise
        raise StorageError(_unwritten(path.name if named is None else str(named), problem, besides)) from problem


def write(path: Path, content: bytes | str) -> None:
    """Write a file in a folder that is being made; text in UTF-8. Raises StorageError where it cannot be written."""
    with being_written(path):
        path.write_bytes(content.encode() if isinstance(content, str) else content)


def require_utf8(target: Path) -> None:
    """Raise InputError for a place whose whole path is not UTF-8: netCDF can open no file there."""
    whole = target
    with suppress(FileNotFoundError):  # the working folder is gone, which the next step says
        whole = target.absolute()
    try:
        os.fspath(whole).encode()
    except UnicodeEncodeError as problem:
        raise InputError(
            f"{_place(target)} lies in {os.fspath(whole)!r}, which is not UTF-8: netCDF opens no file there; give "
            "another name"
        ) from problem


def remove_leftovers(folder: Path) -> None:
    """Remove what dead processes were making in a folder; what cannot be removed stays."""
    if fcntl is None:
        return
    with suppress(OSError):
        for apart in folder.glob(HIDDEN + "[0-9a-f]" * 2 * BYTES):
            with suppress(OSError):
                lock = os.open(apart, os.O_RDONLY)
                try:
                    fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # an error where a process lives that holds it
                    _remove(apart)
                finally:
                    os.close(lock)


def _held_folder(parent: Path) -> tuple[Path, int]:
    """A new hidden folder, and the open file that holds its lock."""
    while True:
        apart = _hidden(parent)
        at_step("make", apart)
        apart.mkdir(mode=0o700)
        if fcntl is None:
            return apart, os.open(os.devnull, os.O_RDONLY)
        with suppress(FileNotFoundError):  # another process took it for a leftover before it had a lock
            lock = os.open(apart, os.O_RDONLY)
            with suppress(OSError):  # of a file system without locks, where nobody removes what another one left
                fcntl.flock(lock, fcntl.LOCK_EX)
            if apart.exists():
                return apart, lock
            os.close(lock)


def _hidden(parent: Path) -> Path:
    return parent / f"{HIDDEN}{token_hex(BYTES)}"


def remove_whole(folder: Path) -> None:
    """Remove a folder so that a killed process leaves all of it, or nothing that has its name."""
    apart = _hidden(folder.parent)
    at_step("rename", apart)
    folder.rename(apart)
    at_step("renamed", apart)
    _remove(apart)


def _take_name(target: Path, rename: Callable[[Path], object], besides: str = "") -> None:
    try:
        at_step("rename", target)
        rename(target)
    except OSError as problem:
        if problem.errno in TAKEN:  # somebody made it meanwhile
            raise InputError(
                f"{_place(target)} cannot be written: {problem.strerror}; nothing is left of it"
            ) from problem
        raise StorageError(_unwritten(str(target), problem, besides)) from problem
    at_step("renamed", target)


def _remove(path: Path) -> None:
    """Remove a file or folder, if it is there and can be removed; a signal in between does not leave it."""
    if not os.path.lexists(path):
        return
    with suppress(OSError):
        try:
            at_step("remove", path)
        finally:
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
            else:
                path.unlink()


def _unwritten(name: str, problem: Exception, besides: str = "") -> str:
    """The message: what cannot be written, why, and what to do."""
    number = getattr(problem, "errno", None)
    reason = getattr(problem, "strerror", None) or " ".join(str(problem).split())
    if number == errno.EFBIG:
        remedy = "raise the limit of file sizes (ulimit -f)"
    elif number in (errno.EACCES, errno.EPERM, errno.EROFS):
        remedy = "give a folder that you may write"
    elif number in (errno.ENOENT, errno.ESTALE):
        remedy = "its folder is gone: make it again"
    else:
        remedy = "free some space"
    return f"{name!r} cannot be written: {reason}; {remedy}{besides}"


def _require_new(target: Path, why_not: Callable[[Path], str | None]) -> None:
    """why_not : the reason, if there is one, for which it must not be replaced"""
    if not os.path.lexists(target):
        return
    if not REPLACES.get():
        raise InputError(f"{_place(target)} exists already: give a new name, remove it first, or give --force")
    reason = why_not(target)
    if reason is not None:
        raise InputError(f"{_place(target)} is not replaced: {reason}; give a new name, or remove it first")


def _no_file(target: Path) -> str | None:
    return None if target.is_file() else "it is no file"


def _strange_in(target: Path) -> str | None:
    """Why a folder may hold what is not of fembearing."""
    try:
        listed = (target / LISTING).read_text("utf-8").split("\n")
        strange = sorted({path.name for path in target.iterdir()} - {*listed, LISTING})
    except OSError:
        return "it is no folder that fembearing made"
    return f"{strange[0]!r} in it is not of fembearing" if strange else None


def _change_places(new: Path, target: Path) -> None:
    """Rename a folder to the target, after what has that name stepped aside; it is removed then, or comes back."""
    aside = target.with_name(f"{target.name}.before-{token_hex(BYTES)}")
    target.rename(aside)
    try:
        new.rename(target)
    except OSError:
        aside.rename(target)
        raise
    _remove(aside)


def _place(target: Path) -> str:
    return f"--out {str(target)!r}"
