"""Files and folders that appear whole or not at all: each is made in a hidden folder beside its place.

A process that is killed leaves that folder, `.fembearing-NAME`, and nothing else.
"""

import atexit
import errno
import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from secrets import token_hex

from analytic.errors import InputError, StorageError
from analytic.reading import MILLION, content_of

HIDDEN, LISTING = ".fembearing-", ".fembearing"  # LISTING: in a folder of ours, the names of its files
REMEDIES = {
    errno.EFBIG: "raise the limit of file sizes (ulimit -f)",
    **dict.fromkeys((errno.EACCES, errno.EPERM, errno.EROFS), "give a folder that you may write"),
    **dict.fromkeys((errno.ENOENT, errno.ESTALE), "its folder is gone: make it again"),
}


@contextmanager
def new_file(target: Path, *, force: bool = False) -> Iterator[Path]:
    """A file to write that takes its name only when all went well; else nothing of it is left.

    force : it takes the place of a file
    Raises InputError, before anything is written, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_free(target, force, None if target.is_file() else "it is no file")
    with _beside(target) as apart:
        yield apart
        _require_free(target, force, None)  # somebody may have made it meanwhile
        apart.replace(target)


@contextmanager
def new_folder(target: Path, *, force: bool = False) -> Iterator[Path]:
    """A folder to fill that takes its name only when all went well; else nothing of it is left.

    force : it takes the place of a folder that this function made, and in which nothing else lies
    Raises InputError, before anything is filled in, if it exists or cannot be made; StorageError for a full disk.
    """
    _require_free(target, force, _strange_in(target))
    with _beside(target) as apart:
        apart.mkdir()
        yield apart
        write(apart / LISTING, "".join(f"{path.name}\n" for path in sorted(apart.iterdir())))
        _require_free(target, force, _strange_in(target))
        before = apart.with_name(LISTING)  # which goes with the hidden folder
        if target.exists():
            target.replace(before)
        try:
            apart.rename(target)
        except BaseException:  # Ctrl-C too: the hidden folder goes with what is in it
            if before.exists():
                before.replace(target)
            raise


@contextmanager
def replaced_file(target: Path) -> Iterator[Path]:
    """A file to write that takes its name, and the place of what has it, only when all went well.

    Raises InputError where it cannot be made, StorageError for a full disk.
    """
    with _beside(target) as apart:
        yield apart
        apart.replace(target)


@contextmanager
def _beside(target: Path) -> Iterator[Path]:
    """What will be the target, in a hidden folder beside it."""
    place = target.parent / f"{HIDDEN}{token_hex(4)}"
    remove = partial(shutil.rmtree, place, ignore_errors=True)
    atexit.register(remove)  # for a signal between two lines, the folder's making and its removal included
    try:
        place.mkdir(mode=0o700)
    except OSError as problem:
        if problem.errno in (errno.ENOSPC, errno.EDQUOT, errno.EIO):
            raise StorageError(_unwritten(target, problem)) from problem
        raise InputError(
            f"{_place(target)} cannot be made in {str(target.parent)!r}: {problem.strerror}; give a name in a folder "
            "that you may write"
        ) from problem
    try:
        with being_written(target, only=place):
            yield place / target.name
    finally:
        remove()
        atexit.unregister(remove)


@contextmanager
def being_written(path: Path, *, only: Path | None = None) -> Iterator[None]:
    """A block that writes one file; only : failures of files in this folder count, others pass.

    Raises StorageError, with the reason and the remedy, where it cannot be written.
    """
    try:
        yield
    except OSError as problem:
        named = problem.filename
        if only is not None and named is not None and not Path(os.fsdecode(named)).is_relative_to(only):
            raise
        raise StorageError(_unwritten(path, problem)) from problem
    except RuntimeError as problem:
        if "NetCDF" not in str(problem):  # its error for a full disk
            raise
        raise StorageError(_unwritten(path, problem)) from problem


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


def _unwritten(path: Path, problem: Exception) -> str:
    """The message: what cannot be written, why, and what to do."""
    reason = getattr(problem, "strerror", None) or " ".join(str(problem).split())
    return f"{str(path)!r} cannot be written: {reason}; {REMEDIES.get(getattr(problem, 'errno', 0), 'free some space')}"


def _require_free(target: Path, force: bool, why_not: str | None) -> None:
    """why_not : the reason, if there is one, for which it must not be replaced"""
    if not os.path.lexists(target):
        return
    if not force:
        raise InputError(f"{_place(target)} exists already: give a new name, remove it first, or give --force")
    if why_not is not None:
        raise InputError(f"{_place(target)} is not replaced: {why_not}; give a new name, or remove it first")


def _strange_in(target: Path) -> str | None:
    """Why a folder may hold what is not of fembearing."""
    try:
        listed = content_of(target / LISTING, most=MILLION, remedy="", linked=False).decode().split("\n")
        strange = sorted({path.name for path in target.iterdir()} - {*listed, LISTING})
    except (OSError, ValueError):
        return "it is no folder that fembearing made"
    return f"{strange[0]!r} in it is not of fembearing" if strange else None


def _place(target: Path) -> str:
    return f"--out {str(target)!r}"
