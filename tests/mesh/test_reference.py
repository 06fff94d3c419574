"""The committed reference meshes: unchanged, and the recipes still make them."""

import hashlib
from pathlib import Path

import numpy as np
import pytest
from typer.testing import CliRunner

import fembearing
from fembearing.cli import app
from fembearing.mesh.bodies import BodyMesh, BodyName
from fembearing.mesh.meshfile import read_body

REFERENCE = Path(fembearing.__file__).parent / "meshes" / "reference"
BODIES: dict[tuple[str, str], BodyName] = {
    ("real", "upper"): "ball",
    ("real", "lower"): "race",
    ("hertzian", "upper"): "half space",
    ("hertzian", "lower"): "half space",
    ("wall", "upper"): "ball",
    ("wall", "lower"): "pocket wall",
}
CONTACTS = [("inner", "real"), ("inner", "hertzian"), ("outer", "real"), ("outer", "hertzian"), ("pocket", "wall")]


def test_the_files_are_as_committed() -> None:
    lines = (REFERENCE / "SHA256SUMS").read_text("ascii").splitlines()
    listed = {name: digest for digest, name in (line.split() for line in lines)}
    present = {path.name: hashlib.sha256(path.read_bytes()).hexdigest() for path in REFERENCE.glob("*.vtu")}
    assert present == listed
    assert sorted(present) == sorted(
        f"{pair}-{geometry}-{side}.vtu" for pair, geometry in CONTACTS for side in ("upper", "lower")
    )


def sets(body: BodyMesh) -> list[np.ndarray]:
    return [body.touching, body.surface, body.far, body.clamped, *body.planes]


@pytest.mark.parametrize(("pair", "geometry"), CONTACTS)
def test_the_recipes_still_make_them(pair: str, geometry: str, tmp_path: Path) -> None:
    """By the command that made them: a changed recipe, mesh or built-in scene must come with new files."""
    wanted = ["contact", "--pair", pair, "--geometry", geometry, "--level", "1", "--mesh", str(tmp_path)]
    result = CliRunner().invoke(app, wanted)
    assert result.exit_code == 0, result.output
    for side in ("upper", "lower"):
        name = f"{pair}-{geometry}-{side}.vtu"
        old, new = (read_body(folder / name, name=BODIES[geometry, side]) for folder in (REFERENCE, tmp_path))
        np.testing.assert_array_equal(new.mesh.t, old.mesh.t)
        for expected, found in zip(sets(old), sets(new), strict=True):
            np.testing.assert_array_equal(found, expected)
        # Round-off of the contact angle's root finder (4 eps) and of the sine on another machine, with a margin.
        size = np.abs(old.mesh.doflocs).max()
        np.testing.assert_allclose(new.mesh.doflocs, old.mesh.doflocs, rtol=0, atol=1e-9 * size)
