"""Files and folders: whole or not there, whatever ends their making; --force replaces what is ours alone."""

import errno
import os
from pathlib import Path

import pytest

from analytic import writing
from analytic.errors import InputError, StorageError
from tests.refusals import refused


def fill(target: Path, **how: bool) -> None:
    with writing.new_folder(target, **how) as folder:
        writing.write(folder / "a.bin", b"\x00\r\n\xff")
        writing.write(folder / "b.txt", "1 \u00b5m\n")


def names(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def test_what_is_written_is_what_is_read(tmp_path: Path) -> None:
    fill(tmp_path / "made")
    assert (tmp_path / "made/a.bin").read_bytes() == b"\x00\r\n\xff"
    assert (tmp_path / "made/b.txt").read_bytes() == "1 \u00b5m\n".encode()  # no system's own line ends
    assert (tmp_path / "made/.fembearing").read_text() == "a.bin\nb.txt\n"
    assert names(tmp_path) == ["made"]


@pytest.mark.parametrize("make", [writing.new_file, writing.new_folder, writing.replaced_file])
@pytest.mark.parametrize("stop", [KeyboardInterrupt(), SystemExit(143), ValueError("ours")])
def test_what_is_stopped_leaves_nothing(tmp_path: Path, make, stop: BaseException) -> None:
    target = tmp_path / "made"

    def half() -> None:
        with make(target) as apart:
            assert not target.exists()
            (apart / "a.txt" if apart.is_dir() else apart).write_text("half")
            raise stop

    with pytest.raises(type(stop)):
        half()
    assert names(tmp_path) == []


@pytest.mark.parametrize(
    ("number", "kind", "words"),
    [
        (errno.ENOSPC, StorageError, "free some space"),
        (errno.EIO, StorageError, "Input/output error"),
        (errno.EROFS, InputError, "a folder that you may write"),
        (errno.ENAMETOOLONG, InputError, "File name too long"),
    ],
)
def test_a_disk_that_fails_is_not_a_wrong_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, kind: type[Exception], words: str
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, "mkdir", fail)
    with pytest.raises(kind, match=words), writing.new_folder(tmp_path / "made"):
        pass
    assert names(tmp_path) == []


@pytest.mark.parametrize(
    ("number", "remedy"), [(errno.ENOSPC, "free some space"), (errno.EFBIG, "ulimit -f"), (errno.EACCES, "may write")]
)
def test_a_write_that_fails_leaves_nothing_and_names_the_remedy(tmp_path: Path, number: int, remedy: str) -> None:
    words = pytest.raises(StorageError, match=f"made' cannot be written: .*; .*{remedy}")
    with words, writing.new_file(tmp_path / "made") as apart:
        raise OSError(number, os.strerror(number), str(apart))
    with pytest.raises(StorageError, match="NetCDF: HDF error"), writing.new_file(tmp_path / "made"):
        raise RuntimeError("NetCDF: HDF error")
    assert names(tmp_path) == []


def test_a_file_elsewhere_that_fails_is_not_that_of_the_target(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError), writing.new_folder(tmp_path / "made"):
        (tmp_path / "gone.toml").read_text()
    assert names(tmp_path) == []


def test_force_replaces_what_is_of_fembearing_alone(tmp_path: Path) -> None:
    target = tmp_path / "made"
    fill(target)
    refused(lambda: fill(target), "exists already", "--force")
    (target / "a.bin").unlink()
    fill(target, force=True)
    assert names(target) == [".fembearing", "a.bin", "b.txt"]
    (target / "mine.txt").touch()
    refused(lambda: fill(target, force=True), "'mine.txt' in it is not of fembearing")
    (tmp_path / "other").mkdir()
    refused(lambda: fill(tmp_path / "other", force=True), "no folder that fembearing made")
    assert names(tmp_path) == ["made", "other"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="the system has no pipes in folders")
def test_force_neither_follows_a_link_nor_waits_for_a_pipe(tmp_path: Path) -> None:
    """The listing of a folder that others prepared, and a link to a folder that would be replaced."""
    fill(tmp_path / "made")
    listing = tmp_path / "made" / ".fembearing"
    prepare = {
        "pipe": lambda: os.mkfifo(listing),
        "link": lambda: listing.symlink_to(tmp_path / "listing"),
        "3 GB": lambda: (listing.touch(), os.truncate(listing, 3 * 10**9)),
        "no text": lambda: listing.write_bytes(b"\xff"),
    }
    listing.rename(tmp_path / "listing")
    for make in prepare.values():
        make()
        refused(lambda: fill(tmp_path / "made", force=True), "it is no folder that fembearing made")
        listing.unlink()
    (tmp_path / "listing").rename(listing)
    (tmp_path / "made/b.txt").write_text("precious")
    (tmp_path / "link").symlink_to(tmp_path / "made")
    fill(tmp_path / "link", force=True)
    assert (tmp_path / "made/b.txt").read_text() == "precious"
    os.mkfifo(tmp_path / "pipe")
    for make in (writing.new_file, writing.new_folder):
        refused(lambda: make(tmp_path / "pipe", force=True).__enter__(), "is not replaced")  # noqa: B023


@pytest.mark.parametrize("stop", [OSError(errno.EIO, "broken", "new", None, "made"), KeyboardInterrupt()])
def test_a_folder_comes_back_if_the_new_one_cannot_take_its_name(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, stop: BaseException
) -> None:
    fill(tmp_path / "made")
    (tmp_path / "made/b.txt").write_text("old")

    def fails(self: Path, target: Path) -> Path:
        if isinstance(stop, OSError):
            stop.filename, stop.filename2 = str(self), str(target)
        raise stop

    monkeypatch.setattr(Path, "rename", fails)
    with pytest.raises(StorageError if isinstance(stop, OSError) else KeyboardInterrupt):
        fill(tmp_path / "made", force=True)
    assert names(tmp_path) == ["made"]
    assert (tmp_path / "made/b.txt").read_text() == "old"
