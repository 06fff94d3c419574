"""The folder of a sweep: what its grid is made of, and every finished piece, each written whole or not at all.

The file name of a piece is a hash of everything that determines it: the version of the program, the scene, the files
and the laws of traction that it names, the axes, the columns, and the points of the piece. A file of that name is
therefore the result of the piece, or damaged. It has the digest of the rest, a line of JSON with the words, and the
numbers of each column.
One process works on a folder at a time. No link in the folder is followed, and nothing but a regular file is opened.
"""

import hashlib
import json
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from stat import S_ISDIR, S_ISREG
from typing import Any

import numpy as np

from analytic.errors import InputError
from analytic.reading import AT_ONCE, MILLION, NO_LINK, content_of
from analytic.scene import OwnTraction
from analytic.scenefile.law_packages import BUILT_IN, installed_law
from analytic.writing import replaced_file, require_utf8
from fembearing.sweep.grid import Grid
from fembearing.sweep.parts import Part, Piece, blank, column_notes

try:
    import fcntl
except ImportError:  # Windows: the user has to ensure that no other sweep works in the folder
    fcntl = None

GRID, RESULT = "sweep.json", "sweep.nc"
WARNINGS = "warnings"  # beside the columns of words
MOST_WARNINGS = 20  # kept for a piece
PARTS, LOCK = "parts", ".lock"
KINDS = {GRID: S_ISREG, RESULT: S_ISREG, LOCK: S_ISREG, PARTS: S_ISDIR}
HEIGHT_MAP, TRACTION = "surface.height_map.path", "lubricant.traction"
LARGEST_MAP = 400_000_000  # bytes
LONGEST = 2_000  # bytes of the words at one point
DIGITS = 32  # of a hash in a file name
DIGEST = hashlib.sha256().digest_size


@dataclass(frozen=True, kw_only=True)
class Store:
    """The folder of one sweep."""

    folder: Path
    grid: Grid
    identity: str  # hashes of everything that determines the results

    def path(self, piece: Piece) -> Path:
        """The file of a piece."""
        digest = hashlib.sha256(f"{self.identity} {piece.start} {piece.stop}".encode()).hexdigest()[:DIGITS]
        return self.folder / PARTS / f"{piece.start:010d}-{digest}"

    def save(self, piece: Piece, part: Part) -> None:
        """Keep the results of a piece."""
        words = {name: [*values] for name, values in part.values.items() if values.dtype == object}
        words[WARNINGS] = [*part.warnings][:MOST_WARNINGS]
        numbers = [values.astype("<f8").tobytes() for name, values in part.values.items() if name not in words]
        self.result.unlink(missing_ok=True)  # it lacks this piece
        path = self.path(piece)
        path.parent.mkdir(exist_ok=True)
        content = b"\n".join([json.dumps(words).encode(), b"".join(numbers)])
        _write(path, hashlib.sha256(content).digest() + content)

    def load(self, piece: Piece) -> Part | None:
        """The results of a piece; None where it is not finished, or its file is damaged, as by a power failure."""
        values = blank(self.grid, len(piece))
        most = (8 * len(values) + LONGEST) * len(piece) + MILLION
        try:
            content = content_of(self.path(piece), most=most, remedy="", linked=False)
            digest, content = content[:DIGEST], content[DIGEST:]
            head, _, body = content.partition(b"\n")
            words: dict[str, list[str]] = json.loads(head)
            given = {name for name, column in values.items() if column.dtype == object} | {WARNINGS}
            words_are_sound = all(word.isprintable() for each in words.values() for word in each)
            if not words_are_sound or words.keys() != given or digest != hashlib.sha256(content).digest():
                return None
            warnings = dict.fromkeys(words.pop(WARNINGS))
            numbers = [name for name in values if name not in words]
            values |= {name: np.array([*each], dtype=object).reshape(len(piece)) for name, each in words.items()}
            values |= zip(numbers, np.frombuffer(body, "<f8").reshape(len(numbers), len(piece)), strict=True)
        except (ValueError, TypeError, AttributeError, RecursionError):
            return None
        return Part(values=values, warnings=warnings)

    @property
    def result(self) -> Path:
        """The file of the dataset."""
        return self.folder / RESULT


@contextmanager
def opened_store(folder: Path, grid: Grid) -> Iterator[Store]:
    """The folder of this grid, made if it is missing, and locked for other processes.

    A folder of this run is removed again where an error ends the block before anything is computed.
    Raises InputError for a folder that cannot be made, holds something else or another sweep, or is locked.
    """
    place = f"--out {str(folder)!r}"
    require_utf8(folder)
    was_there = os.path.lexists(folder)
    hashes = _hashes(grid)
    description = folder / GRID
    _require_own(folder, place)
    if was_there and not description.exists() and not _is_free(folder):
        raise InputError(f"{place} exists and holds no sweep: give a new name, or remove it first")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = os.open(folder / LOCK, AT_ONCE | NO_LINK | os.O_RDWR | os.O_CREAT, 0o666)
    except OSError as problem:
        raise InputError(f"{place} cannot be made: {problem.strerror}; give a folder that you may write") from problem
    with os.fdopen(lock, "rb"):
        _hold(lock, place)
        is_new = not description.exists()
        try:
            if is_new:
                _write(description, json.dumps({"made_from": hashes}, indent=1).encode())
            else:
                _require_same(description, hashes, place)
            identity = json.dumps([hashes, [*column_notes(grid)]], sort_keys=True)
            yield Store(folder=folder, grid=grid, identity=identity)
        except BaseException:
            if is_new and not (folder / PARTS).exists():
                _remove(folder, whole=not was_there)
            raise


def _require_own(folder: Path, place: str) -> None:
    """Refuse a folder in which something else has one of our names: a link leads elsewhere, a pipe never ends."""
    for name, is_right in KINDS.items():
        with suppress(FileNotFoundError, NotADirectoryError):
            if not is_right((folder / name).lstat().st_mode):
                raise InputError(f"{place}: {name!r} in it is not of a sweep: give a new name, or remove it first")


def _remove(folder: Path, *, whole: bool) -> None:
    """Remove what a sweep that computed nothing has made; whole : the folder too."""
    with suppress(OSError):
        for name in (GRID, LOCK):
            (folder / name).unlink(missing_ok=True)
        if whole:
            folder.rmdir()


def _write(path: Path, content: bytes) -> None:
    with replaced_file(path) as file:
        file.write_bytes(content)


def _hashes(grid: Grid) -> dict[str, str]:
    """Hashes of everything that determines the results, by names for the user."""
    parts = {
        "what is computed": [grid.what, grid.fixed, grid.samples],
        "the scene": grid.document,
        "the axes": [[axis.key, axis.unit, axis.values] for axis in grid.axes],
    }
    hashed = {name: json.dumps(part, sort_keys=True, default=str).encode() for name, part in parts.items()}
    hashed["a height map"] = b"".join(_height_maps(grid))
    if laws := [law.sha256 for law in _own_laws(grid)]:
        hashed["a law of traction"] = json.dumps(laws).encode()
    return {"the version of fembearing": version("fembearing")} | {
        name: hashlib.sha256(part).hexdigest()[:DIGITS] for name, part in hashed.items()
    }


def _height_maps(grid: Grid) -> Iterator[bytes]:
    """Content of every height map that the scene or an axis names."""
    for name in _given(grid, HEIGHT_MAP):
        with suppress(InputError):  # reading the scene raises it
            yield content_of(Path(grid.folder) / name, most=LARGEST_MAP, remedy="")


def _own_laws(grid: Grid) -> Iterator[OwnTraction]:
    """Every law of traction of a user's package that the scene or an axis names: the name alone is no law."""
    for name in _given(grid, TRACTION):
        if name not in BUILT_IN:
            with suppress(InputError):  # reading the scene raises it
                yield installed_law(name)


def _given(grid: Grid, key: str) -> Iterator[str]:
    """The texts that the scene and the axes give for a key."""
    node: Any = grid.document
    for part in key.split("."):
        node = node.get(part) if isinstance(node, dict) else None
    values = [node, *(value for axis in grid.axes if axis.key == key for value in axis.values)]
    yield from (value for value in values if isinstance(value, str))


def _is_free(folder: Path) -> bool:
    return folder.is_dir() and all(path.name.startswith(".") for path in folder.iterdir())


def _require_same(description: Path, hashes: dict[str, str], place: str) -> None:
    try:
        before = json.loads(content_of(description, most=MILLION, remedy="", linked=False))["made_from"]
        changed = [name for name, digest in hashes.items() if before.get(name) != digest]
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        remedy = "give a new name, or remove the folder to start afresh"
        raise InputError(f"{place}: {GRID} in it is damaged; {remedy}") from None
    if changed:
        raise InputError(
            f"{place} holds another sweep: {' and '.join(changed)} changed since; give a new name, or remove it first"
        )


def _hold(lock: int, place: str) -> None:
    if fcntl is None:
        return
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(f"{place}: another sweep is at work there; wait for it, or give a new name") from None
