"""A folder that is written whole or not at all."""

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
    place = f"--out {str(target)!r}"
    if os.path.lexists(target):
        raise InputError(f"{place} exists already: give a new name, or remove it first")
    parent = target.absolute().parent
    temporary = parent / f".{target.name}-{secrets.token_hex(4)}"
    try:
        try:
            temporary.mkdir(mode=0o700)  # nobody but its owner looks in before it is whole
        except OSError as problem:
            raise InputError(
                f"{place} cannot be made in {str(parent)!r}: {problem.strerror}; give a name in a folder that you may "
                "write"
            ) from problem
        yield temporary
        temporary.chmod(0o777 & ~_umask())
        try:
            temporary.rename(target)
        except OSError as problem:  # somebody made it meanwhile
            raise InputError(f"{place} cannot be written: {problem.strerror}; nothing is left of it") from problem
    finally:
        shutil.rmtree(temporary, ignore_errors=True)


def _umask() -> int:
    """The mask of this process: the system gives it only when it is set."""
    mask = os.umask(0)
    os.umask(mask)
    return mask
