"""A folder or a file that is written whole or not at all."""

import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from analytic.errors import InputError


@contextmanager
def whole_folder(target: Path) -> Iterator[Path]:
    """A folder to fill that takes its name only when all went well; else nothing of it is left.

    Raises InputError, before anything is filled in, if it exists or cannot be made.
    """
    temporary = _hidden_beside(target)
    try:
        with _refused_in(target):
            temporary.mkdir(mode=0o700)  # nobody but its owner looks in before it is whole
        yield temporary
        temporary.chmod(0o777 & ~_umask())
        try:
            temporary.rename(target)
        except OSError as problem:  # somebody made it meanwhile
            raise InputError(
                f"{_place(target)} cannot be written: {problem.strerror}; nothing is left of it"
            ) from problem
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


@contextmanager
def whole_file(target: Path) -> Iterator[Path]:
    """A file to write that takes its name only when all went well; else nothing of it is left.

    Raises InputError, before anything is written, if it exists or cannot be made.
    """
    temporary = _hidden_beside(target)
    try:
        with _refused_in(target):
            temporary.touch(mode=0o600, exist_ok=False)
        yield temporary
        temporary.chmod(0o666 & ~_umask())
        _require_new(target)  # somebody may have made it meanwhile
        temporary.rename(target)
    finally:
        temporary.unlink(missing_ok=True)


def _hidden_beside(target: Path) -> Path:
    """A name in the same folder that is free."""
    _require_new(target)
    return target.absolute().parent / f".{target.name}-{secrets.token_hex(4)}"


def _require_new(target: Path) -> None:
    if os.path.lexists(target):
        raise InputError(f"{_place(target)} exists already: give a new name, or remove it first")


@contextmanager
def _refused_in(target: Path) -> Iterator[None]:
    """Raise InputError where nothing can be made beside the target."""
    try:
        yield
    except OSError as problem:
        parent = str(target.absolute().parent)
        raise InputError(
            f"{_place(target)} cannot be made in {parent!r}: {problem.strerror}; give a name in a folder that you may "
            "write"
        ) from problem


def _place(target: Path) -> str:
    return f"--out {str(target)!r}"


def _umask() -> int:
    """The mask of this process: the system gives it only when it is set."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
