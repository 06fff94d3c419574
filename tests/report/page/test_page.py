"""The page: everything a reader needs, in its order, in one file."""

import base64
import math
import re
from collections import Counter
from dataclasses import replace
from html.parser import HTMLParser
from io import StringIO
from pathlib import Path

import pytest
from rich.console import Console

from analytic.oil.own_law import own_traction
from analytic.scene import Scene
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene, parse_scene
from fembearing.check.contact.solution import ContactSolution
from fembearing.check.hard_record import HardRecord
from fembearing.check.torque_change import change_of_torque
from fembearing.check.validation import Validation
from fembearing.grid_convergence import CAUTIOUS, FINEST, HALF, LEAST, UNSTEADY
from fembearing.plain_types import plain
from fembearing.provenance import provenance_of
from fembearing.quantities import RPM
from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.pictures.draw import Picture
from fembearing.report.report import report_of
from fembearing.report.terminal.validation import print_details
from tests.analytic.scenefile.scene_texts import MOVING
from tests.analytic.specimens import present
from tests.report.page.page_writer import document_of, written_page

SUMMARY = (
    "Bearing and operation",
    "Friction torque by effect, N mm",
    "Contacts: Hertz against finite elements",
    "Physical limits",
    "Notes and warnings",
    "Not validated by measurement",
    "Sign-off",
    "Appendices",
)
ALWAYS = (  # of the appendices; no sections of a scene without torque or cage
    "Inputs and effects",
    "Contacts",
    "Contact pressure",
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


def page_of(result: Validation, folder: Path) -> Page:
    return Page(written_page(result, folder))


@pytest.fixture(scope="module")
def page(checked: Validation, pictures: list[Picture], tmp_path_factory: pytest.TempPathFactory) -> Page:
    return Page(written_page(checked, tmp_path_factory.mktemp("page"), pictures=pictures, plots=PLOTS))


def appendices(page: Page) -> dict[str, str]:
    """The title of each appendix by its letter, from its heading."""
    found = (re.fullmatch(r"Appendix ([A-Z]) (.+)", " ".join(heading.split())) for heading in page.headings)
    return {match[1]: match[2] for match in found if match}


def test_the_summary_comes_first_and_the_appendices_follow(page: Page) -> None:
    assert tuple(page.headings[: len(SUMMARY)]) == SUMMARY
    assert "".join(appendices(page)) == "ABCDEFGHIJKL"[: len(page.headings) - len(SUMMARY)]
    assert set(ALWAYS) < set(appendices(page).values())


def test_the_contents_name_every_appendix_and_lead_to_it(page: Page) -> None:
    listed = [(f"#appendix-{letter}", title) for letter, title in appendices(page).items()]
    assert page.links == listed
    assert {f"appendix-{letter}" for letter in appendices(page)} <= set(page.places)
    assert len(page.places) == len(set(page.places))


def test_every_picture_is_inside(page: Page) -> None:
    assert (
        len(page.sources) == 2 * 4 + 9
    )  # two of each contact; the drawing; every plot but those of a cage that moved and of an interval
    assert "No motion of the cage" in page.text
    kinds = Counter(source.partition(",")[0] for source in page.sources)
    assert kinds == {"data:image/png;base64": 2 * 4, "data:image/svg+xml;base64": 9}
    for source in page.sources:
        content = base64.b64decode(source.partition(",")[2], validate=True)
        assert content.startswith(b"\x89PNG" if "png" in source[:20] else b"<?xml")
    assert "http" not in page.text


def test_the_numbers_are_those_of_the_result(checked: Validation, page: Page) -> None:
    for contact in (each.numbers for each in checked.contacts):
        if contact.judged:
            for each in contact.quantities.values():
                assert f"{each.discrepancy:+.2%}" in page.text
                assert f"{each.relative_uncertainty:.2%}" in page.text
    seat, sheet = (each.numbers for each in checked.contacts[2:])
    for stiffness in (seat.hertz.stiffness, seat.reference.stiffness, sheet.reference.stiffness):
        assert f"{1e-9 * stiffness:.4g}" in page.text
    assert checked.torque_change is not None
    for total in (present(checked.torque).friction.torque.total, checked.torque_change.total):
        assert f"{1e3 * total[0]:.4g}" in page.text
    assert f"{checked.torque_change.uncertainty:.2%}".replace("%", " %") in page.text


def test_the_verdict_is_where_it_is_signed(page: Page) -> None:
    """Before the first appendix: what passed, what it stands on, and what no measurement says."""
    words = " ".join(page.text.split()).partition("Appendix A")[0]
    places = [
        words.index(said) for said in ("References and limits", "Not validated by measurement", "Sign-off", "SHA-256")
    ]
    assert places == sorted(places)


def test_it_says_what_is_assumed_and_what_is_not_validated(page: Page) -> None:
    words = " ".join(page.text.split())
    for said in (
        "Not validated by measurement",
        "coefficient 0.1 at each race, from the scene",
        "typical values, no single source seen",  # of the steel
        "bends on its rim",
    ):
        assert said in words


def test_a_lubricated_scene_is_not_told_as_one_without_a_coefficient(checked: Validation, tmp_path: Path) -> None:
    oiled = load_scene(Path("validation/scenes/6205_physical.toml"))
    words = " ".join(page_of(with_scene(checked, oiled), tmp_path).text.split())
    for said in (
        "0.06 Pa s at",
        "rms roughness 1 um of each race, gaussian autocorrelation of 165 um",
        "by mixed lubrication, from the scene's lubricant and surface",
    ):
        assert said in words
    assert "no torque" not in words
    assert "does not depend on speed" not in words
    out = StringIO()
    print_details(Console(file=out, width=80), report_of(with_scene(checked, oiled)))
    assert "Friction: coefficient of each race by mixed lubrication" in " ".join(out.getvalue().split())


def test_the_page_names_a_users_law_of_traction(checked: Validation, tmp_path: Path) -> None:
    oiled = load_scene(Path("validation/scenes/6205_physical.toml"))
    law = own_traction("mine", math.asinh, distribution="own-laws", version="1.2")
    own = replace(oiled, lubricant=replace(present(oiled.lubricant), traction=law))
    text = page_of(with_scene(checked, own), tmp_path).text
    assert f"own law of traction mine of own-laws 1.2, SHA-256 {law.sha256[:12]}" in " ".join(text.split())
    assert "own law" not in page_of(with_scene(checked, oiled), tmp_path).text


def test_the_page_says_the_rules_of_its_intervals(page: Page) -> None:
    """In the constants of the code, which may change."""
    words = " ".join(page.text.split())
    assert f"the remainder of the last change with order {UNSTEADY:g}, plus {LEAST:.2%}".replace("%", " %") in words
    assert f"three times the last change, plus {LEAST:.2%}. All have {FINEST:.3%} more".replace("%", " %") in words
    assert (HALF, CAUTIOUS) == (1 / 2, 3)  # "half the extrapolation's step", "three times"


def test_names_from_a_scene_cannot_break_the_page(checked: Validation, tmp_path: Path) -> None:
    odd = with_scene(checked, replace(checked.scene, name="<script>alert('x')</script> & co"))
    page = page_of(odd, tmp_path)
    assert "<script>alert('x')</script> & co" in page.text
    assert "<script" not in written_page(odd, tmp_path)


def test_an_appendix_has_the_friction_of_the_heaviest_ball(checked: Validation, page: Page, tmp_path: Path) -> None:
    assert "Spin, conformity and creep" in appendices(page).values()
    words = " ".join(page.text.split())
    creep = checked.creep[0].numbers
    assert f"Friction on the inner race: {creep.inner.load:.4g} N" in words
    assert f"{1e3 * creep.torque.reference:.4g}" in words
    assert "at its operating point changes by" in words
    without = page_of(replace(checked, creep=(), creep_change=None), tmp_path)
    assert "Spin, conformity and creep" not in appendices(without).values()


def test_without_cage_and_friction_there_is_neither_pocket_nor_torque(checked: Validation, tmp_path: Path) -> None:
    scene = replace(checked.scene, cage=None, friction_coefficient=None)
    bare = replace(checked, contacts=checked.contacts[:2], torque=None, torque_change=None, sensitivity=None)
    bare = replace(bare, creep=(), creep_change=None)
    page = page_of(with_scene(bare, scene), tmp_path)
    assert tuple(appendices(page).values()) == ALWAYS
    assert not any("torque" in heading for heading in page.headings)
    assert "none in the scene: no pocket contact" in page.text
    assert "No torque: no friction coefficient" in " ".join(page.text.split())
    assert "K_pb" not in page.text


def test_a_calibration_is_named_or_said_to_be_absent(checked: Validation, page: Page, tmp_path: Path) -> None:
    assert "no calibrated inputs" in page.text
    other = page_of(with_scene(checked, replace(checked.scene, calibration="viscosity to the race torque")), tmp_path)
    assert "viscosity to the race torque" in other.text
    assert "no calibrated inputs" not in other.text


def test_a_clearance_is_that_of_a_radial_bearing_alone(checked: Validation, page: Page, tmp_path: Path) -> None:
    """The grooves of washers lie on one circle, so that the formula of the clearance says nothing there."""
    washers = replace(checked.scene, bearing=replace(checked.scene.bearing, kind="thrust"))
    other = page_of(replace(with_scene(checked, washers), torque=None, torque_change=None), tmp_path)
    assert "diametral clearance" in page.text
    assert "pitch diameter" in other.text
    assert "diametral clearance" not in other.text


def test_hard_cases_and_a_missing_renderer_are_shown(checked: Validation, tmp_path: Path) -> None:
    hard = HardRecord(date="2025-03-04", fembearing="0.7", model_version=5, right=211, refused=34, wrong=2)
    page = Page(written_page(replace(checked, hard=hard), tmp_path, trouble="VTK ended with signal 6"))
    told = "last run 2025-03-04, fembearing 0.7, model version 5: 211 right, 34 correctly refused, 2 wrong"
    assert told in page.text
    assert "Maps by matplotlib: VTK ended with signal 6" in page.text


def test_a_cage_that_moved_has_its_table(checked: Validation, tmp_path: Path) -> None:
    """One that begins in whirl, and would rest from rest."""
    assert "Cage in motion" not in page_of(checked, tmp_path).text
    scene = parse_scene(
        MOVING.replace("500 rpm", "400 rpm").replace('start = "rest"', 'start = "whirl"'), origin="here"
    )
    production = torque_of_scene(scene)
    cage = present(production.friction.cage)
    motion = cage.motion[0]
    assert motion is not None
    assert motion.other is not None
    one = change_of_torque(scene, production.friction, inner=checked.contacts[0], outer=checked.contacts[1])
    moved = replace(checked, torque=production, torque_change=one)
    words = " ".join(page_of(moved, tmp_path).text.split())
    table = words.partition("Cage in motion")[2].partition("Orbit of the cage")[0]
    row = [
        f"1400{motion.state}whirl{motion.mean_force:.3g}{motion.max_force:.3g}",
        f"{motion.max_force_interval[0]:.3g}-{motion.max_force_interval[1]:.3g}{1e3 * motion.torque:.3g}",
        f"{1e3 * motion.torque_interval[0]:.3g}-{1e3 * motion.torque_interval[1]:.3g}{1e3 * motion.signed_moment:.2g}",
        # Without radial load no ball leads.
        f"1400whirl{RPM.factor * motion.whirl_speed:.4g}{1e6 * motion.wobble:.3g}0",
        f"{100 * cage.grip_share[0]:.2g} %{cage.grip_number[0]:.2g}0.02 s in blocks of 0.001 s",
        f"rest from rest, {1e3 * motion.other.torque:.3g} N mm: the start decides",
    ]
    assert motion.state == "whirl"
    places = [table.find(word) for word in row]
    assert places == sorted(places), (row, table)
    assert -1 not in places, (row, table)
    assert "leads to whirl" in words  # the warning
    content = plain(report_of(moved).cage_motion)
    assert [point["state"] for point in content] == ["whirl"]
    assert report_of(checked).cage_motion is None
    document_of(moved)  # it can be read back


def test_a_contact_cut_off_at_a_shoulder_can_be_read_back(
    checked: Validation, cut_contact: ContactSolution, tmp_path: Path
) -> None:
    cut = replace(checked, contacts=(cut_contact, *checked.contacts[1:]))
    document_of(cut)
    words = " ".join(page_of(cut, tmp_path).text.split())
    before, said, _ = words.partition("Cut off at the shoulder, y = 0.8 mm, on one side")
    assert said
    assert before.rpartition("Ball on ")[2].startswith("inner race")
