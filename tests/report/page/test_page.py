"""The page: everything a reader needs, in its order, in one file."""

import base64
import math
import re
from collections import Counter
from dataclasses import replace
from html.parser import HTMLParser
from pathlib import Path

import pytest

from analytic.oil.own_law import own_traction
from analytic.scene import Scene
from analytic.scenefile.read import load_scene
from fembearing.check.validation import Validation
from fembearing.provenance import provenance_of
from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.pictures.draw import Picture
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page

SUMMARY = (
    "Bearing and operation",
    "Friction torque by effect, N mm",
    "Contacts: Hertz against finite elements",
    "Limits of the bearing",
    "Notes and warnings",
    "Not validated by measurement",
    "Sign-off",
    "Appendices",
)
ALWAYS = (  # of the appendices; no sections of a scene without torque or cage
    "Inputs and effects",
    "Contacts",
    "Meshes and convergence",
    "Cost of accuracy",
    "Warnings and next steps",
    "Provenance",
)


class Page(HTMLParser):
    """Headings, picture sources, addresses and text of a page; every tag must be closed."""

    LONELY = ("meta", "img", "link", "br")

    def __init__(self, content: str) -> None:
        super().__init__()
        self.headings: list[str] = []
        self.links: list[tuple[str, str]] = []  # to a place in the page, and the words
        self.places: list[str] = []
        self.sources: list[str] = []
        self.text = ""
        self.open: list[str] = []
        self.feed(content)
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag not in self.LONELY:
            self.open.append(tag)
        given = dict(attrs)
        self.sources += [value or "" for name, value in attrs if name == "src"]
        self.places += [value or "" for name, value in attrs if name == "id"]
        if tag == "h2":
            self.headings.append("")
        if tag == "a":
            self.links.append((given["href"] or "", ""))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if "h2" in self.open:
            self.headings[-1] += data
        if "a" in self.open:
            self.links[-1] = (self.links[-1][0], self.links[-1][1] + data)
        if "style" not in self.open:
            self.text += data


def with_scene(result: Validation, scene: Scene) -> Validation:
    """As if the numbers were those of another scene."""
    return replace(result, scene=scene, provenance=provenance_of(scene))


def page_of(result: Validation) -> Page:
    return Page(written_page(result))


def words_of(result: Validation) -> str:
    return " ".join(page_of(result).text.split())


@pytest.fixture(scope="module")
def page(checked: Validation, pictures: list[Picture]) -> Page:
    return Page(written_page(checked, pictures=pictures, plots=PLOTS))


def appendices(page: Page) -> dict[str, str]:
    """The title of each appendix by its letter, from its heading."""
    found = (re.fullmatch(r"Appendix ([A-Z]) (.+)", " ".join(heading.split())) for heading in page.headings)
    return {match[1]: match[2] for match in found if match}


def test_the_summary_comes_first_and_the_appendices_follow(page: Page) -> None:
    assert tuple(page.headings[: len(SUMMARY)]) == SUMMARY
    assert "".join(appendices(page)) == "ABCDEFGHIJKL"[: len(page.headings) - len(SUMMARY)]
    assert set(ALWAYS) < set(appendices(page).values())
    listed = [(f"#appendix-{letter}", title) for letter, title in appendices(page).items()]
    assert page.links == listed
    assert {f"appendix-{letter}" for letter in appendices(page)} <= set(page.places)
    assert len(page.places) == len(set(page.places))


def test_every_picture_is_inside(page: Page) -> None:
    # two of each contact; the drawing; every plot but those of a cage that moved and of an interval
    kinds = Counter(source.partition(",")[0] for source in page.sources)
    assert kinds == {"data:image/png;base64": 2 * 4, "data:image/svg+xml;base64": 9}
    for source in page.sources:
        content = base64.b64decode(source.partition(",")[2], validate=True)
        assert content.startswith(b"\x89PNG" if "png" in source[:20] else b"<?xml")
    assert "http" not in page.text


def test_oil_surface_and_own_law_are_those_of_the_scene(checked: Validation) -> None:
    oiled = load_scene(Path("validation/scenes/6205_physical.toml"))
    law = own_traction("mine", math.asinh, distribution="own-laws", version="1.2")
    own = replace(oiled, lubricant=replace(present(oiled.lubricant), traction=law))
    words = words_of(with_scene(checked, own))
    for said in (
        "0.06 Pa s at",
        "rms roughness 1 um of each race, gaussian autocorrelation of 165 um",
        "by mixed lubrication, from the scene's lubricant and surface",
        f"own law of traction mine of own-laws 1.2, SHA-256 {law.sha256[:12]}",
    ):
        assert said in words


def test_names_from_a_scene_cannot_break_the_page(checked: Validation) -> None:
    odd = with_scene(checked, replace(checked.scene, name="<script>alert('x')</script> & co"))
    assert "<script>alert('x')</script> & co" in page_of(odd).text
    assert "<script" not in written_page(odd)


def test_without_cage_and_friction_there_is_neither_pocket_nor_torque(checked: Validation) -> None:
    scene = replace(checked.scene, cage=None, friction_coefficient=None)
    bare = replace(checked, contacts=checked.contacts[:2], torque=None, torque_change=None, sensitivity=None)
    page = page_of(with_scene(replace(bare, creep=()), scene))
    assert tuple(appendices(page).values()) == ALWAYS
    assert not any("torque" in heading for heading in page.headings)
    assert "No torque: no friction coefficient" in " ".join(page.text.split())
    assert "K_pb" not in page.text


def test_a_clearance_is_that_of_a_radial_bearing_alone(checked: Validation) -> None:
    """The grooves of washers lie on one circle, so that the formula of the clearance says nothing there."""
    washers = replace(checked.scene, bearing=replace(checked.scene.bearing, kind="thrust"))
    assert "diametral clearance" in words_of(checked)
    other = words_of(replace(with_scene(checked, washers), torque=None, torque_change=None))
    assert "pitch diameter" in other
    assert "diametral clearance" not in other
