"""Files of every kind that a user names, damaged at random, and what reads them.

A file is changed at a few places: values of scenes and grids become absurd, lines vanish or double, bytes are cut,
inserted or replaced. Tables of torques and cycles get other cells, rows and units.
"""

import io
import os
import re
import shutil
import tempfile
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import meshio
import numpy as np

from analytic import friction_torque, load_scene
from analytic.prediction.duty import cycle_with_torques
from analytic.scenefile.columns import read_cycle
from analytic.scenefile.read import load_by_temperature
from analytic.standing import worst_standing
from analytic.surface.heightmap import measure, read_height_map
from fembearing.check.measured.comparison import compare_measured
from fembearing.mesh.meshfile import read_body
from fembearing.sweep.grid import load_grid
from validation.stress.extreme import SHIPPED, require_finite
from validation.stress.watched import Input
from validation.study import ROOT

MOST_CHANGES = 4  # in one file
FEW = 64  # samples of the interval of a comparison
JUNK = (
    *("nan", "inf", "-inf", "-0.0", "1e400", "1e-400", "0", "-1", "9" * 5000, "true", "[]", "{}", '""', "1_0", "0x10"),
    *('"1 m"', '"1e309 N"', '"-5 N"', '"1 N m N"', '"1 m^9"', '"1 m**9999999"', '"5 degC"', '"7 %"', '"\\u0000"'),
    *("\"__import__('os').system('false') m\"", '"{0.__class__}"', '"../../../etc/passwd"', '"/dev/zero"', '"1 dB"'),
    *('"on"', '"off"', '"auto"', '"solved"', '"given"', '"1 µm"', '"1 Ω"', '"' + "a" * 300 + '"', "2024-01-01"),
    *("[" * 200, "a." * 40 + "b", '{ from = "1 N", to = "1e300 N", count = 1000000 }'),
)
HEADS = (
    *("duration [s]", "duration [h]", "inner_speed [rad/s]", "axial_load [kN]", "radial_load [lbf]", "torque [N m]"),
    *("temperature [degC]", "uncertainty [%]", "inner_speed", "axial_load [rpm]", "torque []", "[N]", "=1+1 [N]"),
)
BYTES = (b"\x00", b"\xff\xfe", b"\xef\xbb\xbf", b"\r", b"\n", b"'''", b'"""', *(bytes([each]) for each in b"[]=#{}<>"))
MESHES = tuple(sorted((ROOT / "meshes" / "reference").glob("*.vtu")))
INPUTS = Path(__file__).parent / "inputs"
GRID, CYCLE, MEASURED = (
    (INPUTS / name).read_text("utf-8") for name in ("damaged_grid.toml", "cycle.csv", "measured.csv")
)


def place_in(folder: Path) -> Path:
    """Where the last damaged file of this process is."""
    return folder / str(os.getpid())


def damaged_input(seed: int, folder: Path) -> Input:
    """A damaged file of one of the kinds, and what reads it."""
    kinds: tuple[tuple[str, Callable[[np.random.Generator], tuple[str, bytes]], Callable[[Path], object]], ...] = (
        ("scene", lambda rng: ("scene.toml", changed_scene(rng)), read_scene),
        ("height map", changed_map, lambda path: measure(read_height_map(path, spacing=2e-6))),
        ("mesh", changed_mesh, lambda path: read_body(path, name="ball")),
        ("grid", lambda rng: ("grid.toml", changed_toml(GRID, rng)), lambda path: load_grid(path).first_scene()),
        ("cycle", lambda rng: ("cycle.csv", changed_table(CYCLE, rng)), read_duty),
        ("measured torques", lambda rng: ("measured.csv", changed_table(MEASURED, rng)), read_torques),
    )
    kind, change, read = kinds[seed % len(kinds)]
    name, content = change(np.random.default_rng(seed))
    place = place_in(folder)
    if place.exists():
        shutil.rmtree(place)
    place.mkdir()
    (place / name).write_bytes(content)
    return Input(kind, content, lambda: read(place / name))


def read_scene(path: Path) -> None:
    """Read a scene, and compute the torque at its first point."""
    scene = load_scene(path)
    if scene.has_friction:
        first = {name: np.atleast_1d(value)[:1] for name, value in scene.operation.points.items()}
        result = friction_torque(replace(scene, operation=replace(scene.operation, **first)))
        require_finite(result.rows)


def read_duty(path: Path) -> None:
    """Read a duty cycle, and compute its energy."""
    cycle, torques = cycle_with_torques(load_by_temperature("6205-dry"), read_cycle(path))
    require_finite((cycle, worst_standing(torques)))


def read_torques(path: Path) -> None:
    """Read measured torques, and compare the torque of a scene with them."""
    require_finite(compare_measured(load_scene("6205-dry"), path, samples=FEW))


def changed_scene(rng: np.random.Generator) -> bytes:
    """A scene that ships, damaged."""
    return changed_toml(SHIPPED[rng.integers(len(SHIPPED))].read_text("utf-8"), rng)


def changed_toml(text: str, rng: np.random.Generator) -> bytes:
    for _ in range(changes(rng)):
        lines = text.splitlines()
        at, other = rng.integers(len(lines), size=2)
        match rng.integers(6):
            case 0:
                lines[at] = re.sub(r"=.*", lambda _: "= " + str(rng.choice(JUNK)), lines[at])
            case 1:
                del lines[at]
            case 2:
                lines.insert(at, lines[other])
            case 3:
                lines[at] = re.sub(r"\d+\.?\d*", lambda _: f"{10 ** rng.uniform(-12, 12):.3g}", lines[at])
            case 4:
                lines[at] = lines[at].replace(str(rng.choice(list(lines[at] or "a"))), str(rng.choice(JUNK)), 1)
            case _:
                return changed_bytes(text.encode(), rng)
        text = "\n".join(lines) or "a = 1"
    return text.encode("utf-8", "surrogatepass")


def changed_table(text: str, rng: np.random.Generator) -> bytes:
    """A table of commas with other cells and rows."""
    rows = [line.split(",") for line in text.splitlines()]
    for _ in range(changes(rng)):
        at = int(rng.integers(len(rows)))
        cell = int(rng.integers(len(rows[at])))
        match rng.integers(6):
            case 0:
                rows[at][cell] = str(rng.choice(JUNK))
            case 1:
                rows[at][cell] = f"{10 ** rng.uniform(-12, 12):.3g}"
            case 2:
                rows.insert(at, rows[rng.integers(len(rows))])
            case 3:
                del rows[at][cell:]
            case 4:
                rows[0][cell % len(rows[0])] = str(rng.choice(HEADS)) if rows[0] else ""
            case _:
                return changed_bytes("\n".join(map(",".join, rows)).encode("utf-8", "surrogatepass"), rng)
        rows = [row or [""] for row in rows]
    return "\n".join(map(",".join, rows)).encode("utf-8", "surrogatepass")


def changed_map(rng: np.random.Generator) -> tuple[str, bytes]:
    heights = 1e-7 * rng.standard_normal((33, 40))
    if rng.random() < 0.5:
        kinds = ("<f8", "<f4", "<i2", "<c16", "<U3", "|O", "|b1")
        given = heights.astype(kinds[rng.integers(len(kinds))])
        file = io.BytesIO()
        np.save(file, given if rng.random() < 0.8 else given[..., None], allow_pickle=True)
        content = bytearray(file.getvalue())
        if rng.random() < 0.5:  # only the header
            content[:128] = changed_bytes(bytes(content[:128]), rng)
            return "map.npy", bytes(content)
        return "map.npy", changed_bytes(bytes(content), rng)
    rows = [",".join(f"{height:.3g}" for height in row) for row in heights]
    for _ in range(changes(rng) - 1):
        cells = rows[rng.integers(len(rows))].split(",")
        cells[rng.integers(len(cells))] = str(rng.choice(JUNK))
        rows[rng.integers(len(rows))] = ",".join(cells)
    content = "\n".join(rows).encode()
    return "map.csv", content if rng.random() < 0.5 else changed_bytes(content, rng)


def changed_mesh(rng: np.random.Generator) -> tuple[str, bytes]:
    chosen = MESHES[rng.integers(len(MESHES))]
    text = chosen.read_text("utf-8")
    match rng.integers(5):
        case 4:  # numbers in the arrays of an intact file
            return "body.vtu", with_changed_arrays(chosen, rng)
        case 0:  # a number in an XML attribute
            places = list(re.finditer(r'"\d+"', text))
            place = places[rng.integers(len(places))]
            text = text[: place.start()] + f'"{10 ** rng.integers(0, 19)}"' + text[place.end() :]
        case 1:  # a tag, or the value of an attribute
            words = list(re.finditer(r"[A-Z][A-Za-z]+\d*", text))
            place = words[rng.integers(len(words))]
            other = words[rng.integers(min(40, len(words)))].group()
            text = text[: place.start()] + other + text[place.end() :]
        case 2:
            head = '<!DOCTYPE a [<!ENTITY b "' + "b" * 1000 + '"><!ENTITY c "' + "&b;" * 1000 + '">]>'
            text = text.replace("<VTKFile", head + "<VTKFile", 1).replace("<Points>", "<Points>&c;", 1)
        case _:
            pass
    return "body.vtu", changed_bytes(text.encode(), rng) if rng.random() < 0.7 else text.encode()


def with_changed_arrays(path: Path, rng: np.random.Generator) -> bytes:
    mesh = meshio.read(path)
    arrays = [mesh.points, mesh.cells[0].data, *mesh.point_data.values()]
    for _ in range(changes(rng)):
        array = arrays[rng.integers(len(arrays))]
        odd = (np.nan, np.inf, 1e300, 0.0) if array.dtype.kind == "f" else (-1, -(10**9), 10**9, 0, array.max())
        array.flat[rng.integers(array.size)] = np.array(odd[rng.integers(len(odd))]).astype(array.dtype)
    with tempfile.TemporaryDirectory() as folder:
        meshio.write(Path(folder) / "body.vtu", mesh)
        return (Path(folder) / "body.vtu").read_bytes()


def changes(rng: np.random.Generator) -> int:
    """The number of changes, mostly one: a file with many errors is refused for the first."""
    return min(int(rng.geometric(0.6)), MOST_CHANGES)


def changed_bytes(content: bytes, rng: np.random.Generator) -> bytes:
    """The content cut, partly doubled, or with some bytes replaced."""
    changed = bytearray(content)
    for _ in range(changes(rng)):
        at = int(rng.integers(len(changed) + 1))
        match rng.integers(5):
            case 0:
                del changed[at:]
            case 1:
                changed[at:at] = BYTES[rng.integers(len(BYTES))]
            case 2:
                changed[at : at + 1] = rng.bytes(1)
            case 3:
                changed[at:at] = changed[at : at + int(rng.integers(1, 60))]
            case _:
                del changed[at : at + int(rng.integers(1, 30))]
    return bytes(changed)
