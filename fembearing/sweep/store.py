"""The folder of a sweep: what was asked, and every piece that is done, each written whole or not at all.

A piece is kept under the hash of all that it follows from: the program's version, the scene, the files it names, the
axes, and which points it holds. So whatever is found under its name is its result, and nothing has to be trusted to be
finished. One process works on a folder at a time.
"""

import hashlib
import json
import os
import zipfile
from collections.abc import Callable, Container, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np

from analytic.errors import InputError
from fembearing.sweep.grid import Grid
from fembearing.sweep.parts import Part, Piece

try:
    import fcntl
except ImportError:  # Windows: that nobody else works there is left to the user
    fcntl = None

ASKED, DONE, RESULT = "sweep.json", "done.json", "sweep.nc"
BYTES = "bytes"  # of the result: whether it is still what was written
PARTS, LOCK = "parts", ".lock"
HEIGHT_MAP = "surface.height_map.path"
DIGITS = 32  # of a hash in a file's name


@dataclass(frozen=True, kw_only=True)
class Store:
    folder: Path
    identity: str  # hash of all that the results follow from

    def path(self, piece: Piece) -> Path:
        digest = hashlib.sha256(f"{self.identity} {piece.start} {piece.stop}".encode()).hexdigest()[:DIGITS]
        return self.folder / PARTS / f"{piece.start:010d}-{digest}.npz"

    def save(self, piece: Piece, part: Part) -> None:
        told = {"reasons": part.reasons, "warnings": part.warnings}
        content = BytesIO()
        arrays: dict[str, Any] = {f"column {name}": values for name, values in part.columns.items()}
        arrays |= {f"word {name}": values for name, values in part.words.items()}
        np.savez(content, allow_pickle=False, told=np.array(json.dumps(told)), **arrays)
        _write_whole(self.path(piece), lambda file: file.write_bytes(content.getvalue()))

    def load(self, piece: Piece, names: Container[str] | None = None) -> Part | None:
        """What was kept of a piece, of its columns these alone if names are given.

        None where the piece is not done, or what is there cannot be read, after a power failure say.
        """
        try:
            with self.path(piece).open("rb") as file, np.load(file, allow_pickle=False) as content:
                told = json.loads(str(content["told"]))
                groups: dict[str, dict[str, Any]] = {"column": {}, "word": {}}
                for key in content.files:
                    kind, _, name = key.partition(" ")
                    if kind == "word" or (kind == "column" and (names is None or name in names)):
                        groups[kind][name] = content[key]
        except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
            return None
        return Part(
            columns=groups["column"],
            words=groups["word"],
            reasons={int(place): reason for place, reason in told["reasons"].items()},
            warnings=tuple(told["warnings"]),
        )

    def keep_result(self, write: Callable[[Path], Any]) -> None:
        """The result, as it is written to a path."""
        (self.folder / DONE).unlink(missing_ok=True)
        _write_whole(self.folder / RESULT, write)

    def finish(self, told: dict[str, Any]) -> None:
        """Every piece is done and the result is there: what a later run can say of it without computing."""
        text = json.dumps(told | {BYTES: (self.folder / RESULT).stat().st_size}, indent=1)
        _write_whole(self.folder / DONE, lambda file: file.write_text(text, "utf-8"))

    def finished(self) -> dict[str, Any] | None:
        """What `finish` was given; None where something is left to do, or the result is not what it was."""
        told = _read_json(self.folder / DONE)
        try:
            is_whole = told is not None and told.pop(BYTES, None) == (self.folder / RESULT).stat().st_size
        except FileNotFoundError:
            return None
        return told if is_whole else None


@contextmanager
def opened_store(folder: Path, grid: Grid) -> Iterator[Store]:
    """The folder for this grid, made if it is missing, and held against other processes.

    Raises InputError for a folder that cannot be made, holds something else, or another sweep, or is being worked on.
    """
    place = f"--out {str(folder)!r}"
    hashes = _hashes(grid)
    asked = folder / ASKED
    if os.path.lexists(folder) and not asked.exists() and not _is_free(folder):
        raise InputError(f"{place} exists and holds no sweep: give a new name, or remove it first")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        lock = (folder / LOCK).open("w")
    except OSError as problem:
        raise InputError(f"{place} cannot be made: {problem.strerror}; give a folder that you may write") from problem
    with lock:
        _hold(lock, place)
        if asked.exists():
            _require_same(_read_json(asked), hashes, place)
        else:
            text = json.dumps({"made_from": hashes, "grid": grid.text}, indent=1)
            _write_whole(asked, lambda file: file.write_text(text, "utf-8"))
        yield Store(folder=folder, identity=json.dumps(hashes, sort_keys=True))


def _write_whole(path: Path, write: Callable[[Path], Any]) -> None:
    """Let a file be written under another name, and give it its own when it is complete.

    The other name is always the same, so that what a killed process leaves goes when the file is written again. Raises
    InputError where it cannot be written.
    """
    apart = path.with_name(f".{path.name}")
    try:
        path.parent.mkdir(exist_ok=True)
        write(apart)
        apart.replace(path)
    except (OSError, RuntimeError) as problem:  # RuntimeError: all that netCDF tells of a full disk
        reason = getattr(problem, "strerror", None) or problem
        raise InputError(
            f"{str(path)!r} cannot be written: {reason}; make room: what is done is kept, and the same sweep goes on"
        ) from problem
    finally:
        apart.unlink(missing_ok=True)


def _hashes(grid: Grid) -> dict[str, str]:
    """Of everything that the results follow from, by a name for people."""
    parts = {
        "what is computed": [grid.what, grid.asked],
        "the scene": grid.document,
        "the axes": [[axis.key, axis.unit, axis.values] for axis in grid.axes],
    }
    hashed = {name: json.dumps(part, sort_keys=True, default=str).encode() for name, part in parts.items()}
    hashed["a height map"] = b"".join(_height_maps(grid))
    return {"the version of fembearing": version("fembearing")} | {
        name: hashlib.sha256(part).hexdigest()[:DIGITS] for name, part in hashed.items()
    }


def _height_maps(grid: Grid) -> Iterator[bytes]:
    """The content of every file of heights that the scene or an axis names."""
    node: Any = grid.document
    for key in HEIGHT_MAP.split("."):
        node = node.get(key) if isinstance(node, dict) else None
    named = [node, *(value for axis in grid.axes if axis.key == HEIGHT_MAP for value in axis.values)]
    for name in named:
        path = Path(grid.folder) / str(name)
        if isinstance(name, str) and path.is_file():  # else the scene will say so
            yield path.read_bytes()


def _is_free(folder: Path) -> bool:
    return folder.is_dir() and all(path.name.startswith(".") for path in folder.iterdir())


def _read_json(path: Path) -> dict[str, Any] | None:
    """None where there is none, or a damaged one."""
    try:
        found = json.loads(path.read_text("utf-8"))
    except (OSError, ValueError):
        return None
    return found if isinstance(found, dict) else None


def _require_same(known: dict[str, Any] | None, hashes: dict[str, str], place: str) -> None:
    before = (known or {}).get("made_from")
    if not isinstance(before, dict):
        raise InputError(f"{place}: {ASKED} in it is damaged; give a new name, or remove the folder to start afresh")
    changed = [name for name, digest in hashes.items() if before.get(name) != digest]
    if changed:
        raise InputError(
            f"{place} holds another sweep: {' and '.join(changed)} changed since; give a new name, or remove it first"
        )


def _hold(lock: Any, place: str) -> None:
    if fcntl is None:
        return
    try:
        fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        raise InputError(f"{place}: another sweep is at work there; wait for it, or give a new name") from None
