"""The document: written and read back as it is, and damaged numbers drawn or refused."""

import copy
import json
import random
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from analytic.prediction.prediction import predict
from analytic.scenefile.read import parse_scene
from analytic.torque import friction_torque
from fembearing.check.cage_record import record_cage
from fembearing.check.validation import Validation
from fembearing.plain_types import plain
from fembearing.report.figures.cage import cage_plot
from fembearing.report.figures.contacts import approach_plot, pressure_plot
from fembearing.report.figures.measured import measured_plot
from fembearing.report.figures.page_plots import PLOTS
from fembearing.report.figures.prediction import prediction_plot
from fembearing.report.figures.sensitivity import sensitivity_plot
from fembearing.report.figures.torque import friction_plot, torque_plot
from fembearing.report.page.write import page_of
from fembearing.report.report import report_in, report_of
from tests.analytic.scenefile.scene_texts import MOVING
from tests.report.test_measured import TWO

Document = dict[str, Any]  # what report.json holds
OF_PLOTS = {  # a key, and the module's function that reads it
    "sensitivity": sensitivity_plot,
    "cage_records": cage_plot,
    "pressure_profile": pressure_plot,
    "approach_curve": approach_plot,
    "film": friction_plot,
    "asperity_share": friction_plot,
    "torque": torque_plot,
    "prediction": prediction_plot,
    "measured": measured_plot,
}


@pytest.fixture(scope="module")
def document(checked: Validation) -> Document:
    """With a cage that moved, an interval, and measured torques."""
    scene = parse_scene(MOVING, origin="here")
    record = record_cage(scene, friction_torque(scene), 0)
    assert record is not None
    assert checked.torque is not None
    torque = replace(checked.torque, prediction=predict(checked.scene, samples=64, workers=1))
    whole = replace(checked, cage_records=(record,), torque=torque, measured_torques=TWO)
    return json.loads(json.dumps(plain(report_of(whole)), allow_nan=False))


def places(value: object, way: tuple[str | int, ...] = ()) -> Iterator[tuple[str | int, ...]]:
    parts = value.items() if isinstance(value, dict) else enumerate(value[:2]) if isinstance(value, list) else ()
    for name, part in parts:
        yield (*way, name)
        yield from places(part, (*way, name))


def at(document: Document, place: tuple[str | int, ...]) -> Any:
    here: Any = document
    for step in place:
        here = here[step]
    return here


def damaged(document: Document, place: tuple[str | int, ...], value: object) -> Document:
    found = copy.deepcopy(document)
    here: Any = found
    for step in place[:-1]:
        here = here[step]
    here[place[-1]] = value
    return found


def test_what_is_written_is_read_back_as_the_same(document: Document) -> None:
    read = report_in(document)
    assert plain(read) == document


def test_writing_computes_nothing(checked: Validation, monkeypatch: pytest.MonkeyPatch) -> None:
    """A document is the same whatever became of the formulas since it was built."""
    built = report_of(checked)
    before = plain(built)
    for name in (
        "torque.catalogue.scene_band",
        "contact.hertz.corrected_hertz",
    ):
        monkeypatch.setattr(f"fembearing.check.{name}", None)
    monkeypatch.setattr("fembearing.check.memory.peak_memory", None)
    assert plain(built) == before == plain(report_of(checked))


def test_no_key_gets_lost(document: Document) -> None:
    """Every table but the scene's refuses a key that it does not name; one of each kind, for all rows are alike."""
    of_kinds = {tuple(step for step in place if not isinstance(step, int)): place for place in places(document)}
    tables = [way for way in places(document) if isinstance(at(document, way), dict) and "scene_content" not in way]
    tables = [way for way in tables if way in of_kinds.values()]
    keyed = (
        "values",
        "chosen",
        "seeds",
        "versions",
        "uncertainties",
        "shares",
        "model_parts",
    )  # by names that the results choose
    strict = [way for way in tables if way[-1] not in keyed]
    assert len(strict) > 50
    for way in strict:
        with pytest.raises(ValueError, match="new"):
            report_in(damaged(document, (*way, "new"), 1.0))


def test_every_plot_is_drawn_from_the_document(document: Document) -> None:
    read = report_in(document)
    for plot in PLOTS:
        figure, caption = plot.draw(read)
        assert figure is not None
        assert caption.endswith(".")


def test_the_page_begins_with_the_torque_and_its_interval(document: Document, tmp_path: Path) -> None:
    read = report_in(document)
    text = page_of(read, tmp_path, plots={})  # they take seconds
    totals = [point["torque"]["total"] for point in document["torque"]["points"]]
    point = document["torque"]["prediction"]["points"][totals.index(max(totals))]
    low, high = (f"{point['total'][end] * 1e3:.3g}" for end in ("low", "high"))
    begin = text.partition("Bearing and operation")[0]
    assert f"<strong>{max(totals) * 1e3:#.4g} N mm</strong>" in begin
    assert f"95 % interval {low}-{high} N mm" in begin
    assert f'<td class="number">{low}-{high}</td>' in text
    assert "64 Latin hypercube samples" in text


def test_no_damage_is_answered_by_a_traceback(document: Document) -> None:
    chance = random.Random(20252)
    read = [place for place in places(document) if any(step in OF_PLOTS for step in place)]
    refused = 0
    for place in chance.sample(read, 90):
        other = damaged(document, place, chance.choice([None, "text", -1.5, 0.0, [], {}, True, [1.0, 2.0]]))
        try:
            read = report_in(other)
        except ValueError:
            refused += 1
            continue
        OF_PLOTS[next(str(step) for step in reversed(place) if step in OF_PLOTS)](read)
    assert 45 < refused < 90  # most of it is read


@pytest.mark.parametrize("step", [3, pytest.param(1, marks=pytest.mark.nightly)])  # all of them take nine seconds
def test_a_number_of_the_other_sign_is_drawn_or_refused(document: Document, step: int) -> None:
    of_plots = OF_PLOTS | {"fe": approach_plot, "uncertainty": approach_plot}
    of_kinds = {tuple(step for step in place if not isinstance(step, int)): place for place in places(document)}
    read = [place for place in of_kinds.values() if any(step in of_plots for step in place)]
    numbers = [place for place in read if isinstance(at(document, place), float)]
    drawn = 0
    for place in numbers[::step]:
        plot = next(of_plots[str(step)] for step in reversed(place) if step in of_plots)
        try:
            changed = report_in(damaged(document, place, -at(document, place) or -1e-9))
        except ValueError:
            continue
        drawn += plot(changed)[0] is not None
    assert drawn > 80 / step  # most numbers may have either sign


@pytest.mark.parametrize(
    ("place", "value", "words"),
    [
        (("contacts", 0, "pressure_profile", "rolling", "fe", "pressure"), [1e9], "lists of 1 and 11 values"),
        (("contacts", 1, "approach_curve", "corrected"), [None], "lists of 1 and 25 values"),
        (("sensitivity", "inputs", 0, "change_low"), [0.1, 0.2, 0.3], "lists of 2 and 3 values"),
        (("cage_records", 0, "forces", "sum"), [1.0], "values that belong together"),
        (("cage_records", 0, "exceedance", "share"), [1.0], "values that belong together"),
        (("verdicts", 1, "production"), -1e308, "-1e.308 is larger than 1e.200"),
        (("cage_records", 0, "forces", "sum"), [-1e201], "is larger than"),
        (("cage_motion",), [], "cage_motion of other than"),
        (("contacts", 0, "fe", "approach"), -1e-6, "greater than 0"),
        (("contacts", 1, "uncertainty", "approach"), -1e-6, "greater than or equal to 0"),
    ],
)
def test_what_no_figure_can_show_is_refused(
    document: Document, place: tuple[str | int, ...], value: object, words: str
) -> None:
    with pytest.raises(ValueError, match=words):
        report_in(damaged(document, place, value))


def test_each_contact_stands_once_and_a_pocket_has_both_models(document: Document) -> None:
    contacts = document["contacts"]
    inner, *_, seat, sheet = contacts
    assert (seat["geometry"], sheet["geometry"]) == ("real", "wall")
    with pytest.raises(ValueError, match="a contact twice"):
        report_in(damaged(document, ("contacts",), [*contacts, sheet]))
    with pytest.raises(ValueError, match="other models than real and wall"):
        report_in(damaged(document, ("contacts",), [*contacts, sheet | {"bearing": "second"}]))
    with pytest.raises(ValueError, match="other models than real and wall"):
        report_in(damaged(document, ("contacts",), [inner, seat]))


def test_a_verdict_is_on_a_point_of_the_series(document: Document) -> None:
    count = len(document["torque"]["points"])
    place = ("torque", "verdicts", "physical", 0, "point")
    report_in(damaged(document, place, count - 1))
    with pytest.raises(ValueError, match=f"verdict on point {count}, and {count} points"):
        report_in(damaged(document, place, count))
