"""`fembearing report`: the page from the numbers alone, and every way in which numbers can be none."""

import copy
import json
import os
import random
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from analytic.errors import InputError, StorageError
from fembearing import cli
from fembearing.plain_types import plain
from fembearing.report import report as reading
from fembearing.report.figures import page_plots
from fembearing.report.folder import write_report
from fembearing.report.page import write as page_module
from fembearing.report.page.rebuild import rebuild_page
from fembearing.report.page.write import page_of
from fembearing.report.pictures.draw import Picture
from fembearing.report.report import report_in, report_of
from fembearing.verify.validation import Validation
from tests.report.page.page_writer import document_of

BROKEN = ("/nowhere/python",)  # draws no picture: maps take their place, in a second
FEW = [plot for plot in page_plots.PLOTS if plot.section in ("torque", "meshes")]  # all would take seconds


@pytest.fixture(scope="module")
def report(checked: Validation, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """As the main job writes it, for the two races."""
    folder = tmp_path_factory.mktemp("report")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("fembearing.report.pictures.draw.draw_pictures.__kwdefaults__", {"renderer": BROKEN})
        patch.setattr(page_plots, "PLOTS", FEW)
        write_report(replace(checked, contacts=checked.contacts[:2], creep=(), creep_change=None), folder)
    return folder


@pytest.fixture
def document(made: Validation, pictures: list[Picture]) -> dict[str, Any]:
    return plain(document_of(made, pictures[:2]))


@pytest.fixture
def without_plots(monkeypatch: pytest.MonkeyPatch) -> None:
    """They take a second, and are tested by themselves."""
    monkeypatch.setattr(page_module, "PLOTS", ())


def write(folder: Path, document: object) -> Path:
    file = folder / "report.json"
    file.write_text(json.dumps(document), "utf-8")
    return file


def test_a_page_made_again_is_the_same_to_the_byte(report: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(page_module, "PLOTS", FEW)
    first = (report / "report.html").read_bytes()
    found = rebuild_page(report / "report.json")
    assert (found.page, found.missing) == (report / "report.html", ())
    assert (report / "report.html").read_bytes() == first
    assert b"data:image/png;base64," in first
    assert not [file for file in report.iterdir() if file.name.startswith(".")]


@pytest.mark.usefixtures("without_plots")
def test_the_page_of_a_file_is_that_of_its_result(made: Validation, tmp_path: Path) -> None:
    """Of a result with every verdict in it, written elsewhere; a file of `validate --json` has no pictures."""
    document = plain(report_of(made))
    numbers = write(tmp_path, document)
    out = tmp_path / "for-a-customer.html"
    assert rebuild_page(numbers, out=out).page == out
    told = out.read_text("utf-8")
    assert "+10.00%" in told
    assert "No pictures for these numbers" in told
    assert told == page_of(report_in(document), tmp_path)


@pytest.mark.usefixtures("without_plots")
def test_a_picture_that_is_not_there_leaves_a_word(
    document: dict[str, Any], pictures: list[Picture], tmp_path: Path
) -> None:
    first, second = (picture.file for picture in pictures[:2])
    (tmp_path / first.name).write_bytes(first.read_bytes())
    found = rebuild_page(write(tmp_path, document))
    assert found.missing == (second.name,)
    text = found.page.read_text("utf-8")
    assert text.count("data:image/png") == 1
    assert f"The picture {second.name} is missing beside report.json." in text
    (tmp_path / second.name).write_text("no picture")
    text = rebuild_page(tmp_path / "report.json").page.read_text("utf-8")
    assert f"The file {second.name} beside report.json is no picture." in text


@pytest.mark.usefixtures("without_plots")
@pytest.mark.parametrize(("kind", "replaced"), [("page", True), ("notes", False), ("folder", False), ("image", False)])
def test_only_such_a_page_is_replaced(document: dict[str, Any], tmp_path: Path, kind: str, replaced: bool) -> None:
    numbers, out = write(tmp_path, document), tmp_path / "out.html"
    if kind == "folder":
        out.mkdir()
    elif kind == "page":
        rebuild_page(numbers, out=out)
        out.write_text(out.read_text("utf-8")[:2000], "utf-8")  # cut off: still one of ours
    else:
        out.write_bytes(b"mine" if kind == "notes" else b"\x89PNG\xff")
    before = None if kind == "folder" else out.read_bytes()
    if replaced:
        rebuild_page(numbers, out=out)
        assert out.read_text("utf-8").rstrip().endswith("</html>")
    else:
        with pytest.raises(InputError, match="exists and is no page of fembearing"):
            rebuild_page(numbers, out=out)
        assert out.is_dir() if before is None else out.read_bytes() == before
    assert {file.name for file in tmp_path.iterdir()} == {"report.json", "out.html"}


@pytest.mark.usefixtures("without_plots")
def test_nothing_is_left_of_a_page_that_fails(
    document: dict[str, Any], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    numbers = write(tmp_path, document)
    rebuild_page(numbers)
    before = (tmp_path / "report.html").read_bytes()

    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", full)
    with pytest.raises(StorageError, match=r"report\.html' cannot be written: No space left on device; free some"):
        rebuild_page(numbers)
    assert (tmp_path / "report.html").read_bytes() == before
    assert {file.name for file in tmp_path.iterdir()} == {"report.json", "report.html"}


def put(document: dict[str, Any], place: str | tuple[str, ...], value: object) -> None:
    *way, last = place.split(".") if isinstance(place, str) else place
    here: Any = document
    for step in way:
        here = here[int(step)] if isinstance(here, list) else here[step]
    here[int(last) if isinstance(here, list) else last] = value


@pytest.mark.parametrize(
    ("place", "value", "words"),
    [
        ("contacts.0.hertz.approach", "6 um", ["contacts.0.hertz.approach = '6 um' is no number"]),
        ("contacts.1.load", None, ["contacts.1.load = None is no number"]),
        ("contacts.1.judged", 1, ["contacts.1.judged = 1 is neither true nor false"]),
        ("verdicts.3.verdict", "good", ["verdicts.3.verdict = 'good'", "outside validity"]),
        ("tolerance", float("inf"), ["Infinity is no number of JSON"]),
        ("tolerance", float("nan"), ["NaN is no number of JSON"]),
        ("format", 8, ["format 8", "reads format 7", "is of fembearing 0.1.0"]),
        ("kind", "sweep", ["no report of `fembearing validate`"]),
        ("pictures.0.file", "../secret.png", ["pictures.0 has a picture '../secret.png', which is no plain name"]),
        ("pictures.0.pair", "pocket", ["has no contact for the picture"]),
        ("contacts.0.convergence.stiffness.values", [3.0], ["1 values of stiffness on 3 meshes"]),
        ("torque_change.change.total", [0.1], ["torque_change of other than the 3 points"]),
        ("torque_change", None, ["torque without torque_change"]),
        ("physical.0.point", 3, ["physical verdict on a point beyond the 3 points"]),
        ("cost.ladders.0.methods.0.seconds", -1.5, ["seconds = -1.5"]),
        ("cost.ladders.0.methods.0.name", "$\\frac$", ["has a name '$", "a formula begins"]),
        ("sensitivity.inputs.0.unit", "$", ["has a name '$'"]),
        ("provenance.platform", "\ud800", ["surrogates not allowed"]),
        ("torque.points.1.torque.drag", "2 N mm", ["torque.points.1.torque.drag = '2 N mm' is not known"]),
        (
            "torque.catalogue_band",
            {"low": [1e-3], "high": [2e-3] * 3, "values": {}, "note": "half"},
            ["has 1 values of", "3 points"],
        ),
        ("contacts", {}, ["contacts = {} is no list"]),
        ("provenance.scene_content.bearing", [], ["provenance.scene_content.bearing = [] is no table"]),
    ],
)
def test_numbers_that_are_none_get_one_line(
    document: dict[str, Any], tmp_path: Path, place: str, value: object, words: list[str]
) -> None:
    document["contacts"] = document["contacts"][:2] if place == "pictures.0.pair" else document["contacts"]
    put(document, place, value)
    with pytest.raises(InputError) as refusal:
        rebuild_page(write(tmp_path, document))
    told = str(refusal.value)
    assert all(word in told for word in [*words, "report.json"]), told
    assert "\n" not in told
    assert [file.name for file in tmp_path.iterdir()] == ["report.json"]


@pytest.mark.parametrize("place", ["pictures.0.kind", "contacts.0.convergence.approach.mesh"])
def test_a_key_that_the_page_reads_is_missed(document: dict[str, Any], tmp_path: Path, place: str) -> None:
    way, _, last = place.rpartition(".")
    here: Any = document
    for step in way.split("."):
        here = here[int(step)] if isinstance(here, list) else here[step]
    del here[last]
    with pytest.raises(InputError, match=rf"{place.replace('.', '[.]')} is missing"):
        rebuild_page(write(tmp_path, document))


def test_a_missing_key_is_named_with_both_versions_where_they_differ(document: dict[str, Any], tmp_path: Path) -> None:
    del document["contacts"][2]["meshes"]
    with pytest.raises(InputError, match=r"contacts\.2\.meshes is missing; it was changed: run"):
        rebuild_page(write(tmp_path, document))
    document["provenance"]["versions"]["fembearing"] = "0.0.3"
    with pytest.raises(InputError, match=r"contacts\.2\.meshes is missing; .*written by fembearing 0\.0\.3, this is"):
        rebuild_page(write(tmp_path, document))


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (b"", "is no JSON, or cut off"),
        (b'{"kind": "fembearing valid', "is no JSON, or cut off"),
        (b"\xff\xfe\x00", "is no JSON, or cut off"),
        (b"[" * 100000, "is no JSON, or cut off"),
        (b"[1, 2]", "no report of"),
        (b'"text"', "no report of"),
        (b"{}", "no report of"),
        (b'{"kind": "fembearing validation", "format": 7, "tolerance": 1e999}', "tolerance inf is larger than"),
        (None, "No such file or directory; give the report.json"),
    ],
)
def test_a_file_that_is_no_report_gets_one_line_and_status_2(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    content: bytes | None,
    words: str,
) -> None:
    file = tmp_path / "report.json"
    if content is not None:
        file.write_bytes(content)
    monkeypatch.setattr("sys.argv", ["fembearing", "report", str(file)])
    with pytest.raises(SystemExit) as stop:
        cli.main()
    told = capsys.readouterr()
    assert (stop.value.code, told.out, told.err.count("\n")) == (2, "", 1)
    assert words in told.err


def test_neither_a_device_nor_a_pipe_is_read(tmp_path: Path) -> None:
    """A pipe that nobody writes to never ends."""
    pipe = tmp_path / "report.json"
    os.mkfifo(pipe)
    for place in (pipe, Path("/dev/zero"), tmp_path):
        with pytest.raises(InputError, match="is no regular file; give the report"):
            rebuild_page(place)


def test_a_huge_file_is_not_read_to_its_end(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "LARGEST_FILE", 5_000_000)
    file = tmp_path / "report.json"
    with file.open("wb") as sparse:
        sparse.truncate(5_000_001)
    with pytest.raises(InputError, match="has more than 5 MB; give the report"):
        rebuild_page(file)
    with file.open("wb") as sparse:
        sparse.truncate(5_000_000)
    with pytest.raises(InputError, match="is no JSON"):
        rebuild_page(file)


@pytest.mark.usefixtures("without_plots")
def test_options_take_the_place_of_the_details_of_the_report(document: dict[str, Any], tmp_path: Path, command) -> None:
    document["report"] |= {"author": "A. Noether", "checker": "E. Bolza", "date": "2026-03-01"}
    numbers = write(tmp_path, document)
    before = numbers.read_bytes()
    assert command("report", str(numbers), "--checker", "<script>H. W.</script>", "--revision", "D&E").status == 0
    text = (tmp_path / "report.html").read_text("utf-8")
    for shown in ("A. Noether", "&lt;script&gt;H. W.&lt;/script&gt;", "D&amp;E", "2026-03-01"):
        assert shown in text
    assert "Bolza" not in text
    assert "<script>H" not in text
    assert numbers.read_bytes() == before
    refused = command("report", str(numbers), "--author", "two\nlines")
    assert (refused.status, refused.err.count("\n")) == (2, 1)
    assert "--author 'two\\nlines' is no name" in refused.err


def places(value: object, way: tuple[str, ...] = ()) -> Iterator[tuple[str, ...]]:
    """Of everything in a document."""
    parts = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for name, part in parts:
        here = (*way, str(name))
        yield here
        yield from places(part, here)


@pytest.mark.usefixtures("without_plots")
def test_no_damage_is_answered_by_a_traceback(document: dict[str, Any], tmp_path: Path) -> None:
    """One thing at a time is taken out or made another: a page, or one line."""
    chance = random.Random(20251)
    refused = []
    for place in chance.sample(list(places(document)), 30):
        damaged = copy.deepcopy(document)
        put(damaged, place, chance.choice([None, "text", -1.5, [], {}, True, 10**400, {"new": "key"}]))
        try:
            rebuild_page(write(tmp_path, damaged))
        except InputError as refusal:
            refused.append(str(refusal))
    assert len(refused) > 10  # much of it is read by the page
    assert not any("\n" in told for told in refused)


def test_the_command_says_where_the_page_is(
    report: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    os.link(report / "report.json", tmp_path / "numbers.json")
    monkeypatch.setattr("sys.argv", ["fembearing", "report", str(tmp_path / "numbers.json"), "--json"])
    monkeypatch.setattr(page_module, "PLOTS", ())
    with pytest.raises(SystemExit) as stop:
        cli.main()
    told = capsys.readouterr()
    content = json.loads(told.out)
    assert (stop.value.code or 0) == 0
    assert content["page"] == str(tmp_path / "report.html")
    assert len(content["missing"]) == told.err.count("\n") == 2
    assert "inner-real-pressure.png is missing beside" in told.err
