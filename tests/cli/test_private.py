"""What every output keeps to itself: the home folder, the user and the machine."""

import shutil
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

INPUTS = Path(__file__).parents[2] / "validation" / "stress" / "inputs"
RANGES = ("--speed", "0 rpm to 3000 rpm in 3", "--axial-load", "900 N")
COARSE = "--no-film --no-creep --tolerance 90%"
COMMANDS = {  # of scene, tables, grid and map, with what they write
    "new": "torque {}/mapped.toml --out",
    "new.json": "torque {}/mapped.toml --set surface.height_map.path={}/map.npy --out",
    "new.html": "torque {}/scene.toml --out",
    "cycle": "duty {}/scene.toml {}/cycle.csv --out",
    "measured": "compare {}/scene.toml {}/measured.csv --samples 64 --out",
    "swept": "sweep {}/grid.toml --out",
    "drawn.svg": "draw {}/scene.toml --out",
    "drawn.pdf": "draw {}/scene.toml --out",
    "meshes": "contact {}/scene.toml --pair inner --mesh",
    "map.csv": "export {}/scene.toml --to csv --out",
    "map.nc": "export {}/scene.toml --to netcdf --out",
    "map.mo": "export {}/scene.toml --to modelica --out",
    "map.m": "export {}/scene.toml --to simscape --out",
    "map.fmu": "export {}/scene.toml --to fmu --out",
}


@pytest.mark.usefixtures("in_process")
@pytest.mark.parametrize(
    ("name", "line"),
    [*COMMANDS.items(), pytest.param("report", f"validate {{}}/scene.toml {COARSE} --out", marks=pytest.mark.slow)],
)
def test_no_output_names_the_home_the_user_or_the_host(
    command: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, name: str, line: str
) -> None:
    home = tmp_path / "home-of-zaphod"
    shutil.copytree(INPUTS, home)
    np.save(home / "map.npy", 1e-7 * np.random.default_rng(3).standard_normal((64, 64)))
    for text in (home / "mapped.toml", home / "grid.toml"):
        text.write_text(text.read_text("utf-8").replace("PATH", f"{home}/map.npy"), "utf-8")
    for table in (home / "measured.csv", home / "cycle.csv"):  # with a column that is not read
        head, *rows = table.read_text("utf-8").splitlines()
        table.write_text("\n".join([f"{head},remark", *(f"{row},none" for row in rows)]), "utf-8")
    for variable in ("USER", "LOGNAME", "USERNAME"):
        monkeypatch.setenv(variable, "zaphod")
    for function in ("socket.gethostname", "platform.node"):
        monkeypatch.setattr(function, lambda: "zaphod")
    ended = command(*line.format(home, home).split(), str(home / name), *(RANGES if "export" in line else ()))
    assert ended.status in (0, 1, 3), ended.err
    written = [path for path in (home / name).rglob("*") if path.is_file()] or [home / name]
    for path in written:
        texts = {str(path): path.read_bytes()}
        if zipfile.is_zipfile(path):
            with zipfile.ZipFile(path) as archive:
                texts |= {inside: archive.read(inside) for inside in archive.namelist()}
        assert not [each for each, content in texts.items() if b"zaphod" in content]
