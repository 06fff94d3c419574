"""Mistakes on the command line: one line, a status, and nothing half-written."""

import shlex
from pathlib import Path

import pytest

from analytic.scenefile.template import scene_text
from tests.analytic.scenefile.scene_texts import MINE

USUAL = scene_text("6206", oil="ISO VG 68")
CSV = "inner_speed [rpm],torque [N mm]\n500,7\n"
BARE = (
    'name = "bare"\ntolerance = "5 %"\n[bearing]\ncatalog = "6205"\n[operation]\naxial_load = "1000 N"\n'
    'inner_speed = "500 rpm"\n'
)
PAIR = '[arrangement]\nkind = "X"\npreload = "100 N"\n[friction]\ncoefficient = 0.1\n'
HEAVY = MINE.replace("700 N", "700000 N").replace('"given", value', '"solved", free')
GRID = 'scene = "6206"\n[axes]\noperation.radial_load = ["300 N", "500 N"]\n'
# A command line, another text of the file in it, and words that the line on standard error has. "s.toml" is the usual
# scene, "g.toml" a grid, "d.csv" has measured torques. The scene's own slips are in tests/analytic/scenefile.
CASES: tuple[tuple[str, str | None, tuple[str, ...]], ...] = (
    ("init 6206.toml", None, ("'6206.toml' is no designation",)),
    ("contact 6206 --oil x --samples 5", None, ("No such option: --samples", "torque, compare have it")),
    ("list oils shell-tellus", None, ("none of the oils begins with", "fembearing list oils")),
    ("list", None, ("give a topic", "--schema scene")),
    ("torque 6206 --out there --force", None, ("'there' is not replaced", "no folder that fembearing made")),
    ("torque 6206 --rpm 500", None, ("No such option: --rpm", "for example fembearing torque 6308")),
    ("torque 6206 --load 500N", None, ("No such option: --load", "--radial-load")),
    ("torque 6206 -q -v", None, ("--quiet and --verbose",)),
    ("contact 6206 --mesh new --level two", None, ("--level", "integer")),
    ("contact 6206 --level 2", None, ("--level 2 goes with --mesh",)),
    ("contact 6206 --mesh new --tolerance 1%", None, ("--tolerance '1%' does not go with --mesh",)),
    ("torque s.toml s.toml", None, ("'s.toml' is given twice",)),
    ("torque 6206 --samples 64", None, ("--samples 64 goes with --interval",)),
    ("torque s.toml 6308 -o new", None, ("--out 'new'", "takes one scene")),
    ("torque 6308 s.toml --set 'operation.radial_load=90000 kN'", None, ("6308: the radial load", "lower the load")),
    ("init 6206 --out no/6206.toml", None, ("no/6206.toml", "cannot be made in")),
    ("compare d.csv 6206", None, ("d.csv is no scene; give the scene first",)),
    ("duty d.csv 6206", None, ("d.csv is no scene; give the scene first",)),
    ("compare s.toml d.csv --samples 3", None, ("samples = 3", "at least")),
    ("creep 6205-dry --friction 0", None, ("friction = 0",)),
    ("creep 6205-dry --speed 0rpm", None, ("standstill",)),
    ("creep 6205-dry --load 0N", None, ("--load",)),
    ("creep 6205-dry --load 90kN", None, ("shoulder",)),
    ("creep 6205-dry --load 5N --speed 20000rpm", None, ("skids",)),
    ("creep bare.toml", BARE, ("--friction",)),
    ("creep pair.toml", BARE.replace("6205", "7205C") + PAIR, ("[arrangement]",)),
    ("creep 6205-dry --load 2.5kN --compliance meshed", None, ("past its shoulder",)),
    ("film 6205-dry", None, ("[lubricant]",)),
    ("film paper_6205 --speed 0rpm", None, ("--speed",)),
    ("film paper_6205 --load 90kN", None, ("GPa",)),
    ("film paper_6205 --pair pocket", None, ("pocket",)),
    ("export 6206 --to xlsx", None, ("--to", "xlsx", "netcdf")),
    ("export 6206", None, ("--to",)),
    ("export 6206 --to csv --out s.toml", None, ("s.toml", ".csv")),
    ("export 6206 --to modelica --radial-load '1 kN to 2 kN in 3'", None, ("radial_load has 3 values", "modelica")),
    ("sweep g.toml --out new", GRID.replace("[axes]", "[axis]"), ("axis = ", "did you mean axes?")),
    ("sweep g.toml --out o\udce9ut", None, ("--out 'o\\udce9ut'", "not UTF-8")),
    ("torque caged.toml --out o\udce9ut", MINE + "[cage]", ("--out 'o\\udce9ut'", "not UTF-8")),
    ("validate s.toml --tolerance '-1 %'", None, ("--tolerance", "-1 %", "must be at least 0.0001 %")),
    ("validate heavy.toml", HEAVY, ("operation.axial_load = 700000 N", "shoulder")),
    ("validate --out new.csv", None, ("--out 'new.csv'", "writes a folder")),
    ("validate a.toml b.toml", None, ("b.toml",)),
    ("contact --load 3mm", None, ("--load", "3 mm", "N")),
    ("contact --geometry wall --load 3N --load 5N", None, ("geometry 'wall'", "pocket", "inner")),
    ("contact --load 90kN", None, ("load = 90000 N", "inner", "groove_radius")),  # plastic long before: no mesh
    ("contact --mesh there.txt", "", ("there.txt", "folder")),
    ("contact --mesh s.toml", None, ("s.toml", "writes a folder")),
    ("contact --mesh new --level 77", None, ("--level", "77", "1, 2, 3, 4")),
    ("contact own.toml --pair pocket", MINE, ("[cage]",)),
    ("compare", None, ("Missing argument 'SCENE'; for example fembearing compare bearing.toml data.csv",)),
    ("list foo", None, ("TOPIC", "'foo' is not one of 'bearings', 'oils', 'materials', 'scenes', 'effects'")),
)


@pytest.mark.parametrize(("line", "text", "words"), CASES)
def test_a_slip_gets_one_line_with_its_remedy(
    command, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, line: str, text: str | None, words: tuple[str, ...]
) -> None:
    monkeypatch.chdir(tmp_path)
    files = {"s.toml": USUAL, "g.toml": GRID, "d.csv": CSV, "s.csv": CSV}
    assert text not in files.values(), "a change that changes nothing"
    if text is not None:
        files[next(word for word in line.split() if Path(word).suffix)] = text
    for name, content in files.items():
        Path(name).write_text(content, "utf-8")
    Path("there").mkdir()
    before = sorted(tmp_path.iterdir())
    ended = command(*shlex.split(line))
    assert (ended.status, ended.out, ended.err.count("\n")) == (2, "", 1), ended.err
    assert ended.err.startswith("fembearing: ")
    assert [word for word in words if word not in ended.err] == [], ended.err
    assert sorted(tmp_path.iterdir()) == before
