"""The command line as a user sees it: exit status, the content of each stream, one line for each mistake."""

import csv
import json
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from analytic.writing import LISTING
from fembearing.check.contact import scene_contact
from fembearing.check.cost import scene_cost as cost
from fembearing.fem import solution
from fembearing.mesh.recipe import Recipe
from tests.analytic.scenefile.scene_texts import MINE

COMPARED = {"semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach"}  # held to the asked accuracy
QUANTITIES = {"semi_axis_rolling", "semi_axis_transverse", "peak_pressure", "approach", "stiffness"}


@pytest.fixture
def levels(shallow: Callable[[str], Recipe], monkeypatch: pytest.MonkeyPatch) -> Callable[..., None]:
    """Makes these levels, of meshes of few cells, the only ones."""

    def only(*given: int) -> None:
        monkeypatch.setattr(scene_contact, "load_recipe", lambda name: replace(shallow(name), levels=given))

    return only


def test_a_contact_within_its_accuracy_is_a_success_whatever_the_error_of_hertz(command, tmp_path: Path) -> None:
    """At this load Hertz deviates by 1.4 % in approach and 2.3 % in b: only the scene's tolerance judges that."""
    scene = tmp_path / "scene.toml"
    scene.write_text(MINE.replace("4 %", "0.5 %"))
    result = command("contact", str(scene), "--load", "620 N", "--tolerance", "0.3 %", "--json")
    found = json.loads(result.out)
    assert max(found["quantities"][name]["relative_uncertainty"] for name in COMPARED) <= found["accuracy"] == 0.003
    assert 0.01 < max(abs(each["discrepancy"]) for each in found["quantities"].values()) < 0.03
    assert (found["verdict"], result.status, result.err) == ("fail", 0, "")


@pytest.mark.parametrize("loads", [("28 N",), ("28 N", "9 N")])
def test_a_contact_beyond_its_accuracy_ends_with_status_3_and_its_uncertainty(
    command, loads: tuple[str, ...], levels: Callable[..., None]
) -> None:
    levels(1, 2)  # which no finer one follows
    given = [part for load in loads for part in ("--load", load)]
    result = command("contact", "--pair", "pocket", *given, "--tolerance", "0.005 %", "--json")
    assert json.loads(result.out)["pair"] == "pocket"  # the answer is there, as uncertain as it is
    assert result.status == 3
    assert "not solved to 0.005 %: " in result.err


@pytest.mark.usefixtures("coarse")
def test_json_is_alone_on_standard_output(command) -> None:
    result = command("contact", "--geometry", "hertzian", "--load", "51 N", "--json")
    found = json.loads(result.out)
    assert found["load"] == 51.0
    assert set(found["quantities"]) == QUANTITIES
    shear, peak = found["subsurface"]["quantities"]["max_shear"], found["quantities"]["peak_pressure"]
    assert 0.3 < shear["reference"] / peak["reference"] < 0.33  # 0.300 for a line, 0.310 for a circle
    assert result.status == 0
    assert result.err == ""  # no progress where there is no terminal


@pytest.mark.usefixtures("coarse")
def test_a_sheet_is_shown_and_not_judged(command, tmp_path: Path) -> None:
    """And the pocket of the printed table cannot be made: the result has a warning."""
    scene = tmp_path / "printed.toml"
    scene.write_text(MINE + '[cage]\nvariant = "as_printed"\n')
    result = command("contact", str(scene), "--pair", "pocket", "--geometry", "wall", "--tolerance", "90 %", "--json")
    found = json.loads(result.out)
    assert (found["verdict"], result.status) == ("shown", 0)
    assert found["load"] == 28.0  # the largest ball-cage force that the paper reports
    warnings = " ".join(found["warnings"])
    assert "neighbouring pockets overlap" in warnings
    assert "bends on its rim" in warnings


def test_meshes_that_do_not_converge_are_undecided(
    command, monkeypatch: pytest.MonkeyPatch, levels: Callable[..., None]
) -> None:
    """Peak pressure is changed by 3 % up and down from mesh to mesh, as in solvers that take it from one node."""
    true = solution.peak_pressure
    signs: dict[int, int] = {}  # one for each level, which its number of nodes tells
    turns = (1, -1, -1)  # the second level is solved before the first, then the third
    levels(1, 2, 3)  # the fewest that can swing

    def swinging(x: Any, *rest: Any, **options: Any) -> float:
        return true(x, *rest, **options) * (1 + 0.03 * signs.setdefault(x.size, turns[len(signs)]))

    monkeypatch.setattr(solution, "peak_pressure", swinging)
    result = command("contact", "--geometry", "hertzian", "--load", "77 N", "--json")
    found = json.loads(result.out)
    assert found["verdict"] == "undecided"
    assert "do not converge in peak pressure" in " ".join(found["warnings"])
    assert result.status == 3


@pytest.mark.usefixtures("coarse")
def test_several_loads_make_a_series_with_its_law(command) -> None:
    """Within 80 columns, in the order given, and with the numbers of the JSON."""
    arguments = [part for load in ("310 N", "1e-6 N", "120 N") for part in ("--load", load)]
    table = command("contact", "--geometry", "hertzian", *arguments)
    told = command("contact", "--geometry", "hertzian", *arguments, "--json")
    found = json.loads(told.out)
    assert table.status == told.status == 0
    assert [part["load"] for part in found["points"]] == [310.0, 1e-6, 120.0]
    rows = [line.split()[0] for line in table.out.splitlines() if re.match(r" *[0-9]\S* +[0-9]", line)]
    assert rows[:3] == ["310", "1e-06", "120"]
    assert f"n {found['law']['exponent']:.4f} +- {found['law']['exponent_uncertainty']:.4f}" in table.out
    assert max(map(len, table.out.splitlines())) <= 80
    assert "\N{HORIZONTAL ELLIPSIS}" not in table.out


@pytest.mark.usefixtures("coarse")
def test_no_command_gives_the_idealisation_a_shoulder(command, tmp_path: Path) -> None:
    """A narrow groove: the ellipse of 700 N reaches beyond its shoulder."""
    scene = tmp_path / "narrow.toml"
    scene.write_text(
        MINE.replace('catalog = "paper_6205"', 'catalog = "paper_6205"\ninner = { shoulder_half_width = "1.6 mm" }')
    )
    for_mesh = ("contact", str(scene), "--level", "1", "--load", "700 N", "--json", "--mesh")
    cells = {}
    for geometry in ("real", "hertzian"):
        told = json.loads(command(*for_mesh, str(tmp_path / geometry), "--geometry", geometry).out)
        cells[geometry] = [part["cells"] for part in told["meshes"].values()]
    wide = json.loads(command("contact", "--geometry", "hertzian", *for_mesh[2:], str(tmp_path / "wide")).out)
    assert cells["hertzian"] == [part["cells"] for part in wide["meshes"].values()]
    assert max(cells["real"]) > max(cells["hertzian"])  # half of the contact, not a quarter
    for loads in (["700 N"], ["700 N", "650 N", "610 N"]):
        arguments = [part for load in loads for part in ("--load", load)]
        found = json.loads(command("contact", str(scene), "--geometry", "hertzian", *arguments, "--json").out)
        assert found["verdict"] == "pass"
        assert not found["warnings"]


@pytest.mark.slow
def test_cost_shows_error_and_time_of_each_method(
    command, shallow: Callable[[str], Recipe], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """Printed, as JSON, and in a folder with its picture and its table."""
    monkeypatch.setattr(cost, "load_recipe", lambda name: replace(shallow(name), levels=(1, 2)))
    folder, scene = tmp_path / "cost", tmp_path / "scene.toml"
    scene.write_text(MINE)
    shown = command("cost", str(scene), "--tolerance", "0.5 %", "--out", str(folder))
    assert shown.status == 0
    for words in ("Hertz contact", "Load of the heaviest ball", "Contact, inner", "Price of the next digit", "GiB"):
        assert words in shown.out
    assert "Roughness\nDoes not apply: the scene has no [surface]." in shown.out
    chosen = [line.split()[1] for line in shown.out.splitlines() if line.startswith("> ")]
    assert chosen[:2] == ["exact", "over"]  # of two meshes none is known to be that good
    assert max(map(len, shown.out.splitlines())) <= 80
    assert sorted(file.name for file in folder.iterdir()) == [LISTING, "cost.csv", "cost.json", "cost.png"]
    told = json.loads((folder / "cost.json").read_text())
    rows = list(csv.DictReader((folder / "cost.csv").read_text("utf-8").splitlines()))
    assert [(row["quantity"], row["name"]) for row in rows if row["name"]] == [
        (ladder["quantity"], method["name"]) for ladder in told["ladders"] for method in ladder["methods"]
    ]
    for one in told["ladders"]:
        assert one["absent"] or {"name", "error", "seconds", "memory", "chosen"} <= set(one["methods"][0])


NO_BORE = """
name = "tried"
tolerance = "5 %"
[bearing]
ball_count = 9
ball_diameter = "7.94 mm"
ball_material = "steel"
contact_angle = { rule = "given", value = "0.3 rad" }
inner = { bottom_radius = "15.53 mm", groove_radius = "4.13 mm", shoulder_half_width = "3.1 mm", material = "steel" }
outer = { bottom_radius = "23.48 mm", groove_radius = "4.21 mm", shoulder_half_width = "3.1 mm", material = "steel" }
[operation]
axial_load = "30 N"
inner_speed = "300 rpm"
"""


@pytest.mark.slow
@pytest.mark.usefixtures("coarse")
def test_without_bore_and_cage_the_races_are_checked_alone(command, tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(NO_BORE, "utf-8")
    ended = command("validate", str(tmp_path / "scene.toml"), "--json")
    found = json.loads(ended.out)
    assert (ended.status, ended.err) == (0, "")
    assert [(contact["pair"], contact["ring"]) for contact in found["contacts"]] == [("inner", None), ("outer", None)]
    assert {"bore_diameter", "outside_diameter"} <= set(re.findall(r"\w+", " ".join(found["warnings"])))


@pytest.mark.usefixtures("coarse")
def test_the_line_of_the_contacts_comes_before_the_friction_is_solved(command, tmp_path: Path) -> None:
    """Beside the progress alone; the result has it too, broken into lines of a terminal."""
    scene = tmp_path / "scene.toml"
    scene.write_text(NO_BORE + "[friction]\ncoefficient = 0.07\n", "utf-8")
    told = command("validate", str(scene), "--json", "--verbose").err.splitlines()
    (early,) = [line for line in told if line.startswith("fembearing: contacts: ")]
    assert told.index(early) < next(place for place, line in enumerate(told) if "friction solved" in line)
    usual = command("validate", str(scene))
    assert early.removeprefix("fembearing: ") in " ".join(usual.out.split())
    assert "contacts: " not in usual.err
