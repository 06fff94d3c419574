"""Mesh files: meshio loses nothing, damaged files are refused, and VTK reads the cells with positive volume."""

from collections.abc import Callable
from pathlib import Path

import meshio
import numpy as np
import pytest
import pyvista

from analytic.errors import InputError, StorageError
from fembearing.mesh.bodies import BodyMesh
from fembearing.mesh.meshfile import read_body, write_body
from fembearing.mesh.pair import pair_mesh
from fembearing.mesh.quality import mesh_quality
from fembearing.mesh.recipe import load_recipe
from tests.contacts import OUTER

SEMI_AXES = 0.11e-3, 0.83e-3  # m


def bodies(recipe: str, level: int = 2) -> tuple[BodyMesh, BodyMesh]:
    pair = pair_mesh(OUTER, recipe=load_recipe(recipe), level=level, semi_axes=SEMI_AXES)
    return pair.upper, pair.lower


@pytest.mark.parametrize("recipe", ["race", "hertzian"])
def test_a_body_comes_back_as_it_was(recipe: str, tmp_path: Path) -> None:
    """Bit for bit, including the order of the touching nodes, which pairs the contact nodes of the two bodies."""
    for body in bodies(recipe):
        write_body(tmp_path / "body.vtu", body)
        again = read_body(tmp_path / "body.vtu", name=body.name)
        assert again.name == body.name
        np.testing.assert_array_equal(again.mesh.doflocs, body.mesh.doflocs)
        np.testing.assert_array_equal(again.mesh.t, body.mesh.t)
        np.testing.assert_array_equal(again.touching, body.touching)
        assert (np.diff(body.touching) < 0).any()  # else sorting them would pass for keeping their order
        np.testing.assert_array_equal(again.surface, body.surface)
        np.testing.assert_array_equal(again.far, body.far)
        for plane, expected in zip(again.planes, body.planes, strict=True):
            np.testing.assert_array_equal(plane, expected)


@pytest.mark.parametrize("recipe", ["race", "hertzian"])
def test_vtk_reads_every_cell_with_its_volume(recipe: str, tmp_path: Path) -> None:
    """A node order that VTK reads differently gives negative or wrong volumes."""
    for body in bodies(recipe, level=3):
        write_body(tmp_path / "body.vtu", body)
        grid = pyvista.read(tmp_path / "body.vtu")
        assert isinstance(grid, pyvista.UnstructuredGrid)
        assert set(grid.celltypes) == {pyvista.CellType.TRIQUADRATIC_HEXAHEDRON}
        volume = np.asarray(grid.compute_cell_sizes(length=False, area=False).cell_data["Volume"])
        assert volume.min() > 0
        # VTK cuts a cell into flat-faced tetrahedra: exact for the idealisation's bricks, not for a ball's curved cells
        tolerance = 1e-12 if recipe == "hertzian" else 0.02
        np.testing.assert_allclose(volume.sum(), mesh_quality(body.mesh).volume, rtol=tolerance)


def test_fields_are_written_with_the_mesh(tmp_path: Path) -> None:
    body = bodies("race", level=1)[0]
    displacement = np.random.default_rng(5).normal(size=(body.mesh.doflocs.shape[1], 3))
    write_body(tmp_path / "body.vtu", body, displacement=displacement)
    np.testing.assert_array_equal(pyvista.read(tmp_path / "body.vtu").point_data["displacement"], displacement)


def test_a_failed_write_leaves_the_old_file_and_nothing_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    body = bodies("race", level=1)[0]
    write_body(tmp_path / "body.vtu", body)
    before = (tmp_path / "body.vtu").read_bytes()

    def disk_full(path: str, _: object) -> None:
        Path(path).write_text("half a mesh")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(meshio.vtu, "write", disk_full)
    with pytest.raises(StorageError, match="No space left"):
        write_body(tmp_path / "body.vtu", body)
    assert (tmp_path / "body.vtu").read_bytes() == before
    assert [path.name for path in tmp_path.iterdir()] == ["body.vtu"]


def written(change: Callable[[bytes], bytes]) -> Callable[[Path], object]:
    return lambda path: path.write_bytes(change(path.read_bytes()))


def with_changed(change: Callable[[meshio.Mesh], object]) -> Callable[[Path], object]:
    def write(path: Path) -> None:
        content = meshio.vtu.read(str(path))
        change(content)
        meshio.vtu.write(str(path), content)

    return write


def corrupted(content: bytes) -> bytes:
    middle = content.index(b"AQAAAA") + 60  # inside the first compressed block
    return content[:middle] + b"AAAAAAAAAAAA" + content[middle + 12 :]


def tetrahedra(content: meshio.Mesh) -> None:
    content.points, content.cells = np.eye(4, 3), [meshio.CellBlock("tetra", np.arange(4)[None])]
    content.point_data = {name: values[:4] for name, values in content.point_data.items()}


def straight_hexahedra(content: meshio.Mesh) -> None:
    content.cells = [meshio.CellBlock("hexahedron", content.cells[0].data[:, :8])]


def twice(content: meshio.Mesh) -> None:
    content.point_data["touching"][content.point_data["touching"] == 2] = 1


NO_MESH, NO_NODE = "not a mesh written by fembearing", "a cell names a node that does not exist"
FAULTS: dict[str, tuple[Callable[[Path], object], str]] = {
    "missing": (lambda path: path.unlink(), r"body\.vtu: No such file or directory"),
    "empty": (written(lambda _: b""), NO_MESH),
    "text": (written(lambda _: b"this is no mesh\n"), NO_MESH),
    "no grid": (written(lambda _: b'<VTKFile type="UnstructuredGrid" version="0.1"></VTKFile>'), NO_MESH),
    "cut late": (written(lambda content: content[: len(content) * 7 // 10]), NO_MESH),
    "corrupted": (written(corrupted), NO_MESH),
    "binary": (written(lambda _: bytes(range(256)) * 20), NO_MESH),
    "byte order mark": (written(lambda content: content.replace(b'"binary"', b'"binary\xef\xbb\xbf"')), NO_MESH),
    "tetrahedra": (with_changed(tetrahedra), NO_MESH),
    "straight hexahedra": (with_changed(straight_hexahedra), NO_MESH),
    "no touching": (with_changed(lambda content: content.point_data.pop("touching")), NO_MESH),
    "nowhere": (with_changed(lambda content: content.points[5].fill(np.nan)), "a position is not finite"),
    "no node": (with_changed(lambda content: content.cells[0].data[3:4, 4].fill(len(content.points))), NO_NODE),
    "node -1": (with_changed(lambda content: content.cells[0].data[3:4, 4].fill(-1)), NO_NODE),
    "twice": (with_changed(twice), "nodes that may touch are not numbered in a row"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_a_broken_file_is_refused_in_one_line(tmp_path: Path, fault: str) -> None:
    path, (damage, words) = tmp_path / "body.vtu", FAULTS[fault]
    write_body(path, bodies("race", level=1)[0])
    read_body(path, name="ball")  # sound so far
    damage(path)
    with pytest.raises(InputError, match=words) as caught:
        read_body(path, name="ball")
    assert str(caught.value).isprintable()
