"""The page without a browser: what a user changes, and what is shown then."""

import asyncio
import zipfile
from io import BytesIO, StringIO
from typing import Any

import numpy as np
import pytest
from nicegui import app
from rich.console import Console

from analytic.errors import InputError
from analytic.prediction.steady import steady_scene
from analytic.scene_torque import torque_of_scene
from analytic.scenefile.read import load_scene
from analytic.scenefile.template import scene_text
from fembearing.app import evaluation
from fembearing.app.check import CHECKS, Check
from fembearing.app.evaluation import Evaluation
from fembearing.app.page import Page
from fembearing.app.scene_edit import CATALOG, with_value
from fembearing.app.server import add_report
from fembearing.report.sections.headline import headline_section, torque_headline
from fembearing.report.terminal import print_sections

LOAD, SPEED = "operation.radial_load", "operation.inner_speed"


@pytest.fixture
def no_curve(monkeypatch: pytest.MonkeyPatch) -> None:
    """The curve takes seconds, and these tests look at the headline."""

    async def none(_page: Page, _found: Evaluation) -> None: ...

    monkeypatch.setattr(Page, "_follow_speed", none)


def words(page: Page) -> str:
    """What the headline says, without how it is broken into lines."""
    return " ".join(label.text for label in page.lines.values())


async def test_the_headline_is_that_of_the_command(opened, settled, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(evaluation, "SPEEDS", np.array([0.4, 1.0, 1.7]))  # a quarter, each of which takes 0.25 s
    monkeypatch.setattr(evaluation, "SLICES", 2)
    _, page = await opened()
    page.fields[LOAD].value = "2 kN"
    page.fields[SPEED].value = "1500"
    await settled(page)
    out = StringIO()
    result = torque_of_scene(load_scene("6206", radial_load="2 kN", speed="1500 rpm"))
    print_sections(Console(file=out, width=500), [headline_section(result)])
    title, _, _, row, *rest = [line.strip() for line in out.getvalue().splitlines() if line.strip()]
    shown = words(page)
    assert title in shown
    torque, ends, power, *_ = row.split()[2:]
    assert page.lines["torque"].text == torque
    assert page.lines["interval"].text == f"95 %: {ends}"
    assert page.lines["power"].text == f"power {power} W"
    for line in rest:
        verdict, mark, reason = line.partition(": ")
        assert line in shown or (mark and f"{verdict} {reason}" in shown)
    assert "is read as 1500 rpm" in page.lines["problem"].text
    curve = next(each for each in page.charts["curve"].options["series"] if each["name"] == "torque")
    assert [round(float(speed)) for speed, _ in curve["data"]] == [600, 1500, 2550]  # of all slices


@pytest.mark.usefixtures("no_curve")
@pytest.mark.parametrize(
    ("key", "option", "typed"),
    [
        (LOAD, "radial_load", "5 kg"),
        (LOAD, "radial_load", "500"),
        (LOAD, "radial_load", "nan"),
        (LOAD, "radial_load", "1,500 N"),
        (SPEED, "speed", "1,500"),
        (SPEED, "speed", "12 Hz"),
        ("lubricant.temperature", "temperature", "60"),
    ],
)
async def test_a_refused_input_has_the_words_of_the_command_beside_its_field(
    opened, settled, key, option, typed
) -> None:
    _, page = await opened()
    await settled(page)
    before, usual = page.lines["torque"].text, page.fields[key].value
    page.fields[key].value = typed
    await settled(page)
    with pytest.raises(InputError) as told:
        load_scene("6206", **{option: typed})
    words_of_the_command = str(told.value).removeprefix("scene of 6206: ")
    assert page.fields[key].error == f"scene: {words_of_the_command}"
    assert [each for each, field in page.fields.items() if field.error] == [key]
    assert page.lines["torque"].text == before
    assert {"old"} & {*page.lines["torque"].classes} & {*page.results.classes}
    page.fields[CATALOG].value = "6299"
    assert "6299" in page.fields[CATALOG].error
    assert page.fields[key].error is None
    page.fields[CATALOG].value = "6206"  # as it was: the refusal goes
    page.fields[key].value = usual
    await settled(page)
    assert not any(field.error for field in page.fields.values())
    assert not {"old"} & {*page.lines["torque"].classes, *page.results.classes}
    page.fields[LOAD].value = "700 N"
    await settled(page)
    assert page.lines["torque"].text != before


@pytest.mark.usefixtures("no_curve")
async def test_a_cleared_field_shows_what_is_computed_with_in_grey(opened, settled) -> None:
    _, page = await opened()
    await settled(page)
    diameter, supply = (page.fields[key] for key in ("bearing.ball_diameter", "lubricant.supply"))
    for typed, is_refused in (("30 mm", True), ("", False), ("9.4 mm", False), ("", False)):
        diameter.value = typed
        await settled(page)
        assert bool(diameter.error) == is_refused
    shown = page.evaluation.result.scene.bearing.ball_diameter
    assert (diameter.value, diameter.props["placeholder"]) == ("", f"{1e3 * shown:g} mm")
    for word, nothing in (("grease", "derived"), ("", "oil bath")):
        supply.value = word
        await settled(page)
        assert supply.options[""] == nothing


@pytest.mark.usefixtures("no_curve")
async def test_friction_settles_the_temperature_where_a_thermal_resistance_is_given(opened, settled) -> None:
    _, page = await opened()
    page.fields["thermal.resistance"].value = "0.6 K/W"
    await settled(page)
    assert page.fields["thermal.ambient"].error == 'scene: thermal.ambient is missing; give for example "40 degC"'
    page.fields["thermal.ambient"].value = "31C"
    await settled(page)
    settings = {"thermal.resistance": "0.6 K/W", "thermal.ambient": "31 degC"}
    told = torque_of_scene(steady_scene("6206", settings=settings))
    assert page.lines["title"].text == torque_headline(told).title
    assert page.lines["torque"].text == torque_headline(told).torque


async def test_requests_without_a_browser_build_and_compute_nothing(opened) -> None:
    """Nor do they take a page from those who have one."""
    user, page = await opened()
    for _ in range(200):
        response = await user.http_client.get("/")
        assert response.status_code == 200
    assert opened.pages == [page]
    assert page.is_open
    assert len([*app.clients()]) < 50
    assert len((await opened())[1].fields) > 20


@pytest.mark.usefixtures("no_curve")
async def test_a_slider_sets_its_field_and_follows_it(opened, settled) -> None:
    _, page = await opened()
    page.fields[LOAD].value = "2 kN"
    await settled(page)
    assert page.sliders[LOAD].value == 2000.0
    page.slide(LOAD, 640.0)
    await settled(page)
    assert page.fields[LOAD].value == "640 N"
    assert page.evaluation.row["radial_load"] == 640.0
    page.slide("lubricant.temperature", 35.0)
    await settled(page)
    assert page.evaluation.result.scene.lubricant.temperature == pytest.approx(308.15)
    assert page.sliders["lubricant.temperature"].value == 35.0


@pytest.mark.usefixtures("no_curve")
async def test_a_pasted_scene_fills_the_fields(opened, settled) -> None:
    _, page = await opened()
    await settled(page)
    page.fields["scene"].value = with_value(scene_text("7208B"), SPEED, "2200 rpm")
    await settled(page)
    assert (page.fields[CATALOG].value, page.fields[SPEED].value) == ("7208B", "2200 rpm")
    assert page.lines["title"].text.startswith("7208B, axial ")
    page.fields["scene"].value = "[bearing"
    assert page.fields["scene"].error.startswith("scene: not TOML")


NAMES = ("6004", "6205", "6206", "6308")


async def test_users_have_the_files_of_their_own_checks(opened, monkeypatch: pytest.MonkeyPatch) -> None:
    """Over HTTP, at once; nobody guesses the address of another, and a closed check has no files."""
    checks = [Check(text=name) for name in NAMES]
    for check in checks:
        monkeypatch.setitem(CHECKS, check.token, check)
        check.folder.mkdir()
        (check.folder / "report.html").write_text(f"report of {check.text}", "utf-8")
    add_report()
    users = [(await opened())[0] for _ in checks]
    files = (
        user.http_client.get(f"/check/{check.token}/report.html") for user, check in zip(users, checks, strict=True)
    )
    found = [response.text for response in await asyncio.gather(*files)]
    assert found == [f"report of {name}" for name in NAMES]
    checks[1].close()
    closed = await users[1].http_client.get(f"/check/{checks[1].token}/report.html")
    other = await users[1].http_client.get(f"/check/{checks[2].token}/../{checks[3].token}/other.html")
    assert (closed.status_code, other.status_code) == (404, 404)
    for check in checks:
        check.close()


async def test_a_closed_tab_ends_its_check_and_its_curve(opened) -> None:
    user, page = await opened()
    checking = asyncio.create_task(page.check.run())
    await asyncio.sleep(0.3)
    check = page.check.check
    assert check is not None
    assert check.token in CHECKS
    user.client.delete()
    await asyncio.wait_for(checking, 20)
    assert check.token not in CHECKS
    assert not check.folder.parent.exists()
    for _ in range(1200):
        if not page.is_busy:
            break
        await asyncio.sleep(0.1)
    assert not page.is_busy


@pytest.mark.usefixtures("no_curve")
async def test_the_download_has_the_scene_and_its_torque(opened, settled) -> None:
    user, page = await opened()
    page.fields[SPEED].value = "730 rpm"
    await settled(page)
    await page.check.download()
    response = await user.download.next()
    archive = zipfile.ZipFile(BytesIO(response.content))
    assert archive.namelist() == ["scene.toml", "torque.csv", "torque.json", "torque.html"]
    assert archive.read("scene.toml").decode() == page.text
    head, row = archive.read("torque.csv").decode().splitlines()
    torque = float(row.split(",")[head.split(",").index("torque_total [N mm]")])
    assert f"{torque:.4g}" == page.lines["torque"].text


async def test_checks_of_two_tabs_take_turns(opened, monkeypatch: pytest.MonkeyPatch) -> None:
    running: list[Check] = []
    most: list[int] = []

    def start(check: Check) -> None:
        running.append(check)
        most.append(len(running))

    def look(check: Check) -> None:
        check.problem = "ended"
        running.remove(check)

    monkeypatch.setattr(Check, "start", start)
    monkeypatch.setattr(Check, "look", look)
    pages: list[Any] = [(await opened())[1] for _ in range(2)]
    await asyncio.gather(*(page.check.run() for page in pages))
    assert most == [1, 1]
    assert [page.check.said.text for page in pages] == ["ended", "ended"]
