"""The pages of the reference that are made from the tree: every key, with range and unit."""

import re

import analytic
from analytic.scene_torque import torque_of_scene
from docs.extensions.json_page import json_page
from docs.extensions.keys_page import keys_page
from fembearing.plain_types import plain
from fembearing.report.torque import content_of


def cells(page: str, heading: str) -> dict[str, list[str]]:
    """The rows of the table below a heading, by their first cell."""
    section = page.split(f"\n## {heading}\n", 1)[1].split("\n## ", 1)[0]
    rows = [re.split(r" (?<!\\)\| ", line[2:-2]) for line in section.splitlines() if line.startswith("| ")]
    return {row[0]: row[1:] for row in rows[2:]}


def test_a_key_has_its_unit_range_and_default() -> None:
    page = keys_page()
    assert cells(page, "`[cage]`")["`duration`"][1:] == ["s", "0.0001 to 1000", "`0.2 s`", '`"0.2 s"`']
    assert cells(page, "`[mounting]`")["`mounting_temperature`"][1:4] == ["degC", "-73.15 to 326.85", "`20 degC`"]
    assert cells(page, "`[operation]`")["`inner_speed`"][1:4] == ["rpm, or a list", "-1e+07 to 1e+07", "required"]
    assert cells(page, "`[operation]`")["`down`"][1] == "three numbers"
    assert cells(page, "`[lubricant]`")["`supply`"][1:4:2] == [
        "`oil_bath` or `oil_jet` or `oil_spot` or `grease`",
        "`oil_bath`",
    ]
    assert cells(page, "`[lubricant]`")["`compressible`"][1] == "`true` or `false`"
    assert cells(page, "`[bearing]`")["`clearance`"][2].endswith("or `C2`, `CN`, `C3`, `C4`, `C5`")


def test_the_keys_of_a_torque_in_json_are_there() -> None:
    page = json_page()
    torque = plain(content_of(torque_of_scene(analytic.load_scene("6205-dry"))))
    assert set(torque) == {name.strip("`") for name in cells(page, "TorqueContent")}
    assert set(torque["points"][0]) <= {name.strip("`") for name in cells(page, "Columns")}
    assert cells(page, "Columns")["`axial_load`"][:2] == ["Fa", "N"]
    links = re.findall(r"\]\(#([\w-]+)\)", page)
    headings = {heading.lower().replace(" ", "-") for heading in re.findall(r"^## (.+)$", page, re.MULTILINE)}
    assert set(links) <= headings
