"""Files that a user names: regular files of bounded size, and nothing that waits, never ends or lies elsewhere.

A pipe may never end and a device has no size; both are refused before a byte is read. The size is known before memory
is taken.
"""

import codecs
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from stat import S_ISREG
from typing import BinaryIO
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile

from analytic.errors import InputError

MILLION = 1_000_000
AT_ONCE = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)  # does not wait for a pipe's writer
MARKS = {codecs.BOM_UTF8: "utf-8-sig", codecs.BOM_UTF16_LE: "utf-16", codecs.BOM_UTF16_BE: "utf-16"}
NO_LINK = getattr(os, "O_NOFOLLOW", 0)


@contextmanager
def opened(path: str | os.PathLike[str], *, most: int, remedy: str, linked: bool = True) -> Iterator[BinaryIO]:
    """A regular file of at most `most` bytes, to be read.

    remedy : what to do about a file that cannot be read
    linked : whether a symbolic link is followed
    Raises InputError, which does not name the file, for what is no such file.
    """
    descriptor = _open(path, linked=linked, remedy=remedy)
    try:
        found = os.fstat(descriptor)
        if not S_ISREG(found.st_mode):
            raise InputError(f"is no regular file; {remedy}")
        if found.st_size > most:
            size = f"{most} bytes" if most < MILLION else f"{most // MILLION} MB"
            raise InputError(f"has more than {size}; {remedy}")
        with os.fdopen(descriptor, "rb", closefd=False) as file:
            yield file
    finally:
        os.close(descriptor)


def content_of(path: str | os.PathLike[str], *, most: int, remedy: str, linked: bool = True) -> bytes:
    """The content of a regular file of at most `most` bytes; arguments and errors of `opened`."""
    with opened(path, most=most, remedy=remedy, linked=linked) as file:
        try:
            # Python reserves memory for the whole request. One byte more reads a file without a size.
            return file.read(min(most, os.fstat(file.fileno()).st_size + 1))
        except OSError as problem:  # of the disk
            raise InputError(f"cannot be read: {problem.strerror}; {remedy}") from problem


def text_of(content: bytes) -> str:
    """The text of a file as spreadsheets and instruments save it.

    UTF-8 and UTF-16, each with its byte order mark or without; else the bytes are Windows' western set, or Latin-1.
    """
    for mark, encoding in MARKS.items():
        if content.startswith(mark):
            return content.decode(encoding, "replace")
    if 0 in content[:2]:  # half of the bytes of UTF-16 without its mark, where the text begins with a Latin letter
        return content.decode("utf-16-be" if content[0] == 0 else "utf-16-le", "replace")
    for encoding in ("utf-8", "cp1252"):
        with suppress(UnicodeDecodeError):
            return content.decode(encoding)
    return content.decode("latin-1")


def require_deflated(archive: ZipFile) -> None:
    """Raise InputError for parts that are packed in a rare way: bzip2 and LZMA unpack without a limit."""
    for part in archive.infolist():
        if part.compress_type not in (ZIP_STORED, ZIP_DEFLATED):
            raise InputError(f"has parts in another compression than deflate ({part.compress_type}); save it again")


def require_regular(path: str | os.PathLike[str], *, most: int, remedy: str) -> None:
    """Raise the errors of `opened` for a file that a library will open by its name."""
    with opened(path, most=most, remedy=remedy):
        pass


def _open(path: str | os.PathLike[str], *, linked: bool, remedy: str) -> int:
    try:
        return os.open(path, AT_ONCE | (0 if linked else NO_LINK))
    except OSError as problem:
        raise InputError(f"{problem.strerror or 'cannot be read'}; {remedy}") from problem
    except ValueError as problem:  # a null character
        raise InputError(f"is not a path; {remedy}") from problem
