"""Files that a user names: whatever lies there, it is read within its limit, or refused without waiting."""

import os
from pathlib import Path

import pytest

from analytic.errors import InputError
from analytic.reading import content_of
from analytic.scenefile.read import load_scene
from analytic.surface.heightmap import read_height_map
from fembearing.mesh.meshfile import read_body
from fembearing.sweep.grid import load_grid

READERS = {  # every face by which a user names a file
    "a.toml": load_scene,
    "grid.toml": load_grid,
    "a.csv": lambda path: read_height_map(path, spacing=2e-6),
    "a.npy": lambda path: read_height_map(path, spacing=2e-6),
    "a.vtu": lambda path: read_body(path, name="ball"),
}


@pytest.mark.skipif(os.name == "nt", reason="pipes and devices of POSIX")
@pytest.mark.parametrize("name", READERS)
def test_neither_a_pipe_nor_a_device_nor_a_folder_is_read(tmp_path: Path, name: str) -> None:
    """A pipe that nobody writes to never ends, nor does /dev/zero."""
    path = tmp_path / name
    for make in (os.mkfifo, lambda place: place.symlink_to("/dev/zero"), os.mkdir):
        make(path)
        with pytest.raises(InputError, match="is no regular file") as refusal:
            READERS[name](path)
        assert name in str(refusal.value)
        assert "\n" not in str(refusal.value)
        path.rmdir() if path.is_dir() else path.unlink()


@pytest.mark.parametrize("name", READERS)
def test_a_file_that_is_too_large_is_refused_by_its_size(tmp_path: Path, name: str) -> None:
    """A sparse file of 8 TB, of which nobody could read a byte in vain."""
    with (tmp_path / name).open("wb") as sparse:
        sparse.truncate(8 * 10**12)
    with pytest.raises(InputError, match="has more than"):
        READERS[name](tmp_path / name)


@pytest.mark.parametrize("name", READERS)
def test_a_name_that_is_no_path(tmp_path: Path, name: str) -> None:
    with pytest.raises(InputError, match="is not a path"):
        READERS[name](tmp_path / f"a\0{name}")


def test_a_link_is_followed_only_where_it_may_be(tmp_path: Path) -> None:
    (tmp_path / "there").write_bytes(b"content")
    (tmp_path / "link").symlink_to(tmp_path / "there")
    assert content_of(tmp_path / "link", most=7, remedy="") == b"content"
    with pytest.raises(InputError):
        content_of(tmp_path / "link", most=7, remedy="", linked=False)
    with pytest.raises(InputError, match="has more than 6 bytes; give less"):
        content_of(tmp_path / "there", most=6, remedy="give less")


def test_a_file_that_the_disk_does_not_give_is_an_input_that_cannot_be_read() -> None:
    """As the memory of a process, whose first page is none."""
    if not Path("/proc/self/mem").is_file():
        pytest.skip("this system has no such file")
    with pytest.raises(InputError, match="cannot be read: Input/output error; give another"):
        content_of("/proc/self/mem", most=7, remedy="give another")
