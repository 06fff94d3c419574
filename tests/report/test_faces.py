"""One torque in every face: terminal, JSON, CSV, data frame, report.json and page of scenes of all kinds."""

import csv
import re
from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from rich.console import Console

from analytic.columns import COORDINATES
from analytic.result import FrictionTorque
from analytic.scene import Array
from analytic.scene_torque import SceneTorque
from fembearing.check.torque_change import TorqueChange
from fembearing.check.validation import Validation
from fembearing.plain_types import document, plain
from fembearing.provenance import provenance_of
from fembearing.report.report import report_of
from fembearing.report.sections.torque import RESIDUE, torque_sections
from fembearing.report.terminal import print_sections
from fembearing.report.torque import content_of
from fembearing.report.torque_file import torque_content
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page
from tests.report.specimens import SCENES, torque_of

PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage", "oil", "declared")
RACES = ("inner", "outer")
CONTACT = {"load": 1.0, "peak_pressure": 1e-9, "semi_axis_rolling": 1e3, "semi_axis_transverse": 1e3}  # as shown
TO_RPM = 30 / np.pi


@pytest.mark.parametrize("name", ["dry", "sealed", "pair", "thrust", "tilted"])
def test_every_face_of_a_torque_has_the_same_numbers(made: Validation, name: str) -> None:
    result = torque_of(name)
    for face in (json_agrees, csv_agrees, frame_agrees, terminal_agrees):
        face(result)
    page_agrees(checked_with(made, result))


@pytest.mark.parametrize("name", SCENES)
def test_the_json_has_every_part_of_a_torque(name: str) -> None:
    result = torque_of(name)
    friction, content = result.friction, document("torque", content_of(result))
    places = [number for number, point in enumerate(content["points"]) if point["torque_total"] is not None]
    assert places == list(result.places.computed)
    assert content["left_out"] == plain(result.places.left_out)
    assert content["standing"]["word"] == result.standing.word
    assert content["makers"]["torque"] == {each: plain(values) for each, values in result.makers.items()}
    assert [each["decision"] for each in content["effects"]] == [each.decision for each in friction.effects]
    assert [each["key"] for each in content["inputs"]] == [each.key for each in result.inputs]
    ring, cage, pair, prediction = friction.ring, friction.cage, friction.pair, result.prediction
    told = {
        "ring": ring and [content["ring"][n]["displacement"]["axial"] for n in places],
        "cage": cage and [content["cage"][n]["mean_force"] for n in places],
        "pair": pair and [content["pair"]["points"][n]["torque_second"] for n in places],
        "prediction": prediction and [content["prediction"]["points"][n]["total_low"] for n in places],
    }
    known = {
        "ring": ring and plain(present(ring.displacement)[:, 0]),
        "cage": cage and plain(cage.mean_force),
        "pair": pair and plain(pair.total[1]),
        "prediction": prediction and plain(prediction.total.low),
    }
    assert told == known
    assert all((content[part] is None) == (values is None) for part, values in known.items())
    assert not pair or content["pair"]["at_standstill"]["preload"] == pair.equilibrium.preload


def checked_with(made: Validation, result: SceneTorque) -> Validation:
    """A check of a scene with its own torque; its contacts are those made by hand, and change nothing."""
    friction, scene = result.friction, result.scene
    change = TorqueChange(
        production=friction,
        own=friction,
        corrected=friction,
        uncertainties={"total": 0.0137, "contact_angle": 0.0019},
        fitted=None,
        verdict="pass",
    )
    provenance = provenance_of(scene)
    return replace(
        made,
        scene=scene,
        provenance=provenance,
        torque=result,
        torque_change=change,
        sensitivity=None,
        cage_records=(),
    )


def known_parts(friction: FrictionTorque) -> dict[str, Array]:
    parts = {name: getattr(friction.torque, name) for name in PARTS}
    return {name: part for name, part in parts.items() if part is not None}


def json_agrees(result: SceneTorque) -> None:
    """To the last digit."""
    friction, content = result.friction, document("torque", content_of(result))
    for number, point in enumerate(content["points"]):
        assert [point[name] for name in COORDINATES] == [getattr(friction, name)[number] for name in COORDINATES]
        for name in (*PARTS, "race", "total"):
            part = getattr(friction.torque, name)
            assert point[f"torque_{name}"] == (None if part is None else without_residue(part[number]))
        for race in RACES:
            contact = getattr(friction, race)
            assert [point[f"{name}_{race}"] for name in CONTACT] == [getattr(contact, name)[number] for name in CONTACT]


def without_residue(torque: float) -> float:
    """0 in place of what rounding leaves of a torque, N m."""
    return 0.0 if abs(torque) < 1e-15 else torque


def csv_agrees(result: SceneTorque) -> None:
    """To 14 digits: it has 15, of numbers in units."""
    rows = list(csv.DictReader(StringIO(torque_content(result, ending=".csv").decode())))
    friction = result.friction
    columns = {f"torque_{name} [N mm]": 1e3 * part for name, part in known_parts(friction).items()}
    columns["torque_total [N mm]"] = 1e3 * friction.torque.total
    columns["inner_speed [rpm]"] = TO_RPM * friction.inner_speed
    for race in RACES:
        columns[f"load_{race} [N]"] = getattr(friction, race).load
        columns[f"peak_pressure_{race} [GPa]"] = 1e-9 * getattr(friction, race).peak_pressure
    for head, values in columns.items():
        np.testing.assert_allclose([float(row[head]) for row in rows], values, rtol=1e-14, atol=1e-12)


def frame_agrees(result: SceneTorque) -> None:
    frame = result.to_dataframe()
    np.testing.assert_array_equal(frame["torque_total"], result.friction.torque.total)
    for name, part in known_parts(result.friction).items():
        np.testing.assert_array_equal(frame[f"torque_{name}"], np.vectorize(without_residue)(part))


def terminal_agrees(result: SceneTorque) -> None:
    """To the four digits that are printed, of a part that counts."""
    out = StringIO()
    print_sections(Console(file=out, width=300), torque_sections(result))
    lines = out.getvalue().splitlines()
    friction = result.friction
    parts, total = known_parts(friction), friction.torque.total
    rows = rows_after(lines, "Friction torque of")
    assert len(rows) == total.size
    for number, row in enumerate(rows):
        cells = row[place_of(TO_RPM * friction.inner_speed[number], row) + 1 :]
        cells = cells[len(cells) - len(parts) - 2 - (result.catalogue.band is not None) :]
        counted = [p[number] if p[number] > RESIDUE * total[number] else 0.0 for p in parts.values()]
        assert [float(cell) for cell in cells[: len(parts)]] == [digits(1e3 * part, 4) for part in counted]
        assert float(cells[len(parts)]) == digits(1e3 * total[number], 4)
    contacts = rows_after(lines, "Heaviest ball")
    assert len(contacts) == 2 * total.size
    for row in contacts:
        contact = getattr(friction, row[1])
        expected = [digits(factor * getattr(contact, name)[int(row[0]) - 1], 4) for name, factor in CONTACT.items()]
        assert [float(cell) for cell in row[2 : 2 + len(CONTACT)]] == expected


def place_of(speed: float, row: list[str]) -> int:
    """Of the speed among the cells: after the number of the point, to its five digits."""
    return next(place for place, cell in enumerate(row) if place and abs(float(cell) - speed) <= 1e-4 * abs(speed))


def digits(value: float, count: int) -> float:
    return float(f"{value:.{count}g}")


def rows_after(lines: list[str], title: str) -> list[list[str]]:
    """The cells of the rows of the table below a title, up to the first line that is no row."""
    start = next(number for number, line in enumerate(lines) if line.startswith(title))
    rows = []
    for line in lines[start + 3 :]:
        if not line.strip()[:1].isdigit():
            return rows
        rows.append([cell.strip() for cell in line.split("  ") if cell.strip()])
    return rows


def page_agrees(check: Validation) -> None:
    """report.json to the last digit; the page to the four digits of a part, a total and a contact."""
    torque = present(check.torque)
    friction, content = torque.friction, document("torque", content_of(torque))
    written = plain(report_of(check))
    for number, point in enumerate(written["torque"]["points"]):
        assert point == content["points"][number]
    page = written_page(check)
    parts, total = known_parts(friction), friction.torque.total
    shown = [*(np.where(part > RESIDUE * total, part, 0.0) for part in parts.values()), total]
    tables = [*tables_of(page, "Friction torque of"), *tables_of(page, "Friction torque by effect")]
    assert len(tables) == 2
    for rows in tables:
        assert [row["#"] for row in rows] == [str(number + 1) for number in range(friction.torque.total.size)]
        for row in rows:
            number, start = int(row["#"]) - 1, row["speed, rpm"]
            assert float(start) == digits(TO_RPM * friction.inner_speed[number], 5)
            names = [*parts, "total"]
            assert [float(row[name]) for name in names] == [digits(1e3 * part[number], 4) for part in shown]
    judged = [each.numbers for each in check.contacts if each.numbers.judged]
    for row, contact in zip(tables_of(page, "Contacts: Hertz")[0], judged, strict=True):
        assert float(row["ball load, N"]) == digits(contact.load, 4)
        pressures = [float(row["peak pressure, GPa: Hertz"]), float(row["finite elements"])]
        reference = contact.reference.peak_pressure
        assert pressures == [digits(1e-9 * value, 4) for value in (contact.hertz.peak_pressure, reference)]


def tables_of(page: str, label: str) -> list[list[dict[str, str]]]:
    """The rows of the tables of the page whose labels begin so, each by the heads of its columns."""
    tables = []
    for found in re.findall(rf'aria-label="{label}[^"]*"><table.*?</table>', page, re.DOTALL):
        rows = re.findall(r"<tr>(.*?)</tr>", found, re.DOTALL)
        heads, *cells = (re.findall(r"<t[hd][^>]*>(.*?)</t[hd]>", row) for row in rows)
        tables.append([dict(zip(heads, row, strict=True)) for row in cells])
    return tables
