"""Files and folders that appear whole or not at all: the one place through which anything is written.

What is being made has a hidden name, `.fembearing-MACHINE-PROCESS-START-NUMBER`, until it is whole. The name says which
process makes it, so that a later run removes what a killed one left (`remove_leftovers`).

Every write has named steps, and `at_step` is called at each: "make" before a hidden file or folder is made, "write" and
"written" around the content of a file, "rename" and "renamed" around taking the final name, "remove" before something
is removed. A program that kills a process or fills a disk at a step puts its own function in the place of `at_step`; an
OSError that it raises is what the system would have said.
"""

import errno
import hashlib
import os
import re
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from functools import cache
from itertools import count
from pathlib import Path
from typing import Literal

from analytic.errors import InputError, StorageError

Step = Literal["make", "write", "written", "rename", "renamed", "remove"]

FULL = {errno.ENOSPC, errno.EDQUOT}
BROKEN = {*FULL, errno.EFBIG, errno.EIO}  # the disk's fault: another name beside it would not help
TAKEN = {errno.EEXIST, errno.ENOTEMPTY, errno.ENOTDIR, errno.EISDIR}
APART = re.compile(r"\.fembearing-(\w+)-(\d+)-(\d+)-\d+")
PROCESSES = Path("/proc")  # of Linux
START = 19  # where a process's stat has its start, counted from behind its name; its state is the first there
DEAD = ("Z", "X")  # states of a process that has ended, and whose parent has not heard of it
UNKNOWN = "0"  # start of a process, where the system does not say it
_numbers = count()


def at_step(step: Step, path: Path) -> None:
    """Called at each step of a write; path : what it makes, writes, names or removes. It does nothing."""


@contextmanager
def new_folder(target: Path) -> Iterator[Path]:
    """A folder to fill that takes its name only when all went well; else nothing of it is left.

    Raises InputError, before anything is filled in, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_new(target)
    remove_leftovers(target.parent)
    apart = _made(target, lambda path: path.mkdir(mode=0o700))
    try:
        yield apart
        apart.chmod(0o777 & ~_umask())
        _take_name(target, apart.rename)
    finally:
        _remove(apart)


@contextmanager
def new_file(target: Path) -> Iterator[Path]:
    """A file to write that takes its name only when all went well; else nothing of it is left.

    Raises InputError, before anything is written, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_new(target)
    remove_leftovers(target.parent)
    apart = _made(target, lambda path: path.touch(mode=0o600, exist_ok=False))
    try:
        with being_written(apart, named=target):
            yield apart
        apart.chmod(0o666 & ~_umask())
        _require_new(target)  # somebody may have made it meanwhile
        _take_name(target, apart.rename)
    finally:
        _remove(apart)


@contextmanager
def replaced_file(target: Path, *, besides: str = "") -> Iterator[Path]:
    """A file to write that takes its name, and the place of what has it, only when all went well.

    besides : what else to say where it cannot be written
    Raises InputError where it cannot be made, StorageError for a full disk. What killed processes left stays until
    `remove_leftovers`.
    """
    apart = _made(target, lambda path: path.touch(exist_ok=False))
    try:
        with being_written(apart, named=target, besides=besides):
            yield apart
        _take_name(target, apart.replace, besides)
    finally:
        _remove(apart)


@contextmanager
def scratch_folder(parent: Path) -> Iterator[Path]:
    """A hidden folder for files of a moment. Raises OSError where it cannot be made."""
    apart = parent / _name_apart()
    remove_leftovers(parent)
    at_step("make", apart)
    apart.mkdir(mode=0o700)
    try:
        yield apart
    finally:
        _remove(apart)


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
    """Remove what dead processes of this machine were making in a folder; what cannot be removed stays.

    Only Linux says of a process when it started; elsewhere nothing is removed.
    """
    with suppress(OSError):
        for path in folder.iterdir():
            named = APART.fullmatch(path.name)
            if named and named[1] == _machine() and _start_of(int(named[2])) not in (named[3], UNKNOWN):
                _remove(path)


def remove_whole(folder: Path) -> None:
    """Remove a folder so that a killed process leaves all of it, or nothing that has its name."""
    apart = folder.parent / _name_apart()
    at_step("rename", apart)
    folder.rename(apart)
    at_step("renamed", apart)
    _remove(apart)


def _made(target: Path, make: Callable[[Path], None]) -> Path:
    """A new hidden file or folder in the folder of the target."""
    apart = target.parent / _name_apart()
    try:
        at_step("make", apart)
        make(apart)
    except OSError as problem:
        if problem.errno in BROKEN:
            raise StorageError(_unwritten(str(target), problem)) from problem
        raise InputError(
            f"{_place(target)} cannot be made in {str(target.parent)!r}: {problem.strerror}; give a name in a folder "
            "that you may write"
        ) from problem
    return apart


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
    """Remove a file or folder, if it is there and can be removed."""
    if not os.path.lexists(path):
        return
    with suppress(OSError):
        at_step("remove", path)
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


def _require_new(target: Path) -> None:
    if os.path.lexists(target):
        raise InputError(f"{_place(target)} exists already: give a new name, or remove it first")


def _place(target: Path) -> str:
    return f"--out {str(target)!r}"


def _name_apart() -> str:
    """A hidden name that no other process gives, and this one not again."""
    return f".fembearing-{_machine()}-{os.getpid()}-{_start_of(os.getpid())}-{next(_numbers)}"


def _start_of(process: int) -> str | None:
    """When a process started, in ticks of this system; None: there is none; `UNKNOWN`: the system does not say."""
    try:
        stat = (PROCESSES / str(process) / "stat").read_text("utf-8", "replace")
    except OSError:
        return None if (PROCESSES / "self" / "stat").exists() else UNKNOWN
    state = stat.rpartition(")")[2].split()
    return None if state[0] in DEAD else state[START]


@cache
def _machine() -> str:
    """What tells processes of the same number apart: the machine since its start, and the container."""
    try:
        boot = (PROCESSES / "sys/kernel/random/boot_id").read_text("utf-8")
        known = boot + os.readlink(PROCESSES / "self/ns/pid")
    except OSError:
        known = ""
    return hashlib.sha256(known.encode()).hexdigest()[:8]


def _umask() -> int:
    """The mask of this process: the system gives it only when it is set."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
