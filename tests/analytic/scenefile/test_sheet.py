"""Tables as spreadsheets of several countries save them: the numbers are right, or the file is refused."""

import csv
import io
import zipfile
from collections.abc import Sequence
from datetime import date
from pathlib import Path
from typing import Any

import hypothesis.strategies as st
import numpy as np
import openpyxl
import pytest
from hypothesis import HealthCheck, given, settings

from analytic.errors import InputError
from analytic.scenefile.bearing_list import read_list
from analytic.scenefile.columns import CYCLE, read_cycle, read_measured
from analytic.scenefile.sheet import LARGEST_UNPACKED
from tests.refusals import refused

PLAIN = "inner_speed [rpm],radial_load [kN],temperature [degC],torque [N mm]\n500,0.5,62.5,8.11\n1500,0.5,64,14.125\n"
GERMAN = (
    "# Pr\u00fcfstand\r\nDatum;Inner speed [U/min];Radial load (kN);Temperature [\u00b0C];Torque (Nmm);Bemerkung;\r\n"
    '12.3.2024;500;0,5;62,5;8,11;"erster; gut";\r\n13.3.2024;1500;0,5;64;14,125;;\r\n;;;;;;\r\n'
)
UNIT_ROW = (
    "speed\tradial-load\ttemperature\ttorque\n[1/min]\t[N]\tC\t(N\u00b7mm)\n"
    "500\t500\t62,5\t8,11\n1500\t500\t64\t14,125\n"
)
QUOTED = (
    'sep=,\n"SPEED [min-1]","Radial load [kN]","Temperature [C]","Torque [N*mm]"\n'
    '500,"0,5","62,5","8,11"\n1500,"0,5",64,"14,125"\n'
)


def workbook(rows: Sequence[Any]) -> bytes:
    book, content = openpyxl.Workbook(), io.BytesIO()
    sheet = book.worksheets[0]
    for row in rows:
        sheet.append(row)
    sheet["K700"] = " "  # a cell that was once used
    book.create_sheet("other").append(["torque [N m]", 5])
    book.save(content)
    return content.getvalue()


HEADS = ("Date", "Speed [rpm]", "radial load [kN]", "Temperature (\u00b0C)", "torque (Nm)", "comment")
ROWS = ((500, 0.5, 62.5, 8.11e-3), (1500, 0.5, 64, 14.125e-3))
SHARES = ("speed [rpm]", "torque [Nmm]", "uncertainty [%]")
BOOK = workbook([["# rig 2"], [], HEADS, *([date(2024, 3, 12), *row, None] for row in ROWS)])


@pytest.mark.parametrize(
    ("content", "others"),
    [
        (PLAIN.replace("\n", "\r").encode("utf-8-sig"), []),
        (GERMAN.encode("cp1252"), ["Datum", "Bemerkung"]),
        (UNIT_ROW.encode("utf-16"), []),
        (UNIT_ROW.encode("utf-16-le"), []),
        (QUOTED.encode(), []),
        (BOOK, ["Date", "comment"]),
    ],
)
def test_a_table_has_the_same_numbers_in_every_dialect(tmp_path: Path, content: bytes, others: list[str]) -> None:
    (tmp_path / "plain.csv").write_text(PLAIN, "utf-8")
    (tmp_path / "data").write_bytes(content)
    plain, found = read_measured(tmp_path / "plain.csv"), read_measured(tmp_path / "data")
    for name in ("inner_speed", "radial_load", "temperature", "torque"):
        # Units differ, so that a factor of ten may round once
        np.testing.assert_allclose(getattr(found, name), getattr(plain, name), rtol=3e-16)
    said = [warning for name in others for warning in found.warnings if name in warning]
    assert (len({*said}), len(said), len(found.warnings)) == (bool(others), len(others), bool(others))


def test_a_cell_in_per_cent_is_read_as_it_is_shown(tmp_path: Path) -> None:
    book, content = openpyxl.load_workbook(io.BytesIO(workbook([SHARES, (500, 35, 0.12125)]))), io.BytesIO()
    book.worksheets[0]["C2"].number_format = "0.0%"
    book.save(content)
    for file, text in (("a", content.getvalue()), ("b", (";".join(SHARES) + "\n500;35;12,125 %\n3;7,5;2").encode())):
        (tmp_path / file).write_bytes(text)
        uncertainty = read_measured(tmp_path / file).uncertainty
        assert uncertainty is not None
        assert uncertainty[0] == pytest.approx(0.12125 * 0.035, rel=1e-15)


DIALECTS = [
    (";", ",", "."),
    (";", ".", ","),
    (";", ",", " "),
    ("\t", ",", "."),
    ("\t", ".", ","),
    (",", ".", ","),
    (",", ".", "'"),
]


@settings(max_examples=300, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.data())
def test_a_number_is_right_or_refused(tmp_path: Path, data: st.DataObject) -> None:
    """Whatever the separators of columns, decimals and thousands, and the number of decimals of each column."""
    separator, decimal, group = data.draw(st.sampled_from(DIALECTS))
    size, grouped = data.draw(st.integers(1, 3)), data.draw(st.booleans())
    values, cells = [], []
    for digits in (data.draw(st.integers(0, 4)), data.draw(st.integers(0, 4))):
        texts = [
            f"{data.draw(st.integers(2, 10**7)) / 10**digits:{',' if grouped else ''}.{digits}f}" for _ in range(size)
        ]
        values.append([float(text.replace(",", "")) for text in texts])
        cells.append([text.translate({ord("."): decimal, ord(","): group}) for text in texts])
    text = io.StringIO()
    table = csv.writer(text, delimiter=separator)
    table.writerow(["duration [s]", "speed [rpm]", "note"])
    table.writerows([*row, data.draw(st.sampled_from(["", "9", "good"]))] for row in zip(*cells, strict=True))
    (tmp_path / "data.csv").write_text(text.getvalue(), "utf-8")
    try:
        found = CYCLE.read(tmp_path / "data.csv")
    except InputError:
        return
    np.testing.assert_allclose(found["duration"], values[0], rtol=1e-15)
    np.testing.assert_allclose(found["inner_speed"], np.array(values[1]) * np.pi / 30, rtol=1e-15)


@pytest.mark.parametrize(
    ("rows", "words"),
    [
        (("1.500;7",), ("duration = '1.500' is ambiguous, a point before three digits: write 1500, or 1.5000",)),
        (("1,500;7",), ("duration = '1,500' is ambiguous, a comma before three digits", "1500, or 1.5000")),
        (("1.500;7", "3,5;7"), ("row 1 (line 2): duration = '1.500' has a point", "write 1500 or 1,500")),
        (("1,500;7", "3.5;7"), ("row 1 (line 2): duration = '1,500' has a comma", "write 1500 or 1.500")),
        (("3.5;7", "3,5;7"), ("row 1 (line 2): duration = '3.5' has a point", "write 3,5")),
        (("1.500,5;7",), ("duration = '1.500,5' groups its digits", "without separators")),
        (("1 500;7",), ("duration = '1 500' groups its digits", "without separators")),
        (("1\u202f500,5;7",), ("duration = '1 500,5' groups its digits",)),
        (("5;#DIV/0!", "#NV;7"), ("row 1 (line 2): inner_speed = '#DIV/0!' is no number",)),
        (("5;7", "#N/A;7"), ("row 2 (line 3): duration = '#N/A' is no number",)),
        (("5;7;9",), ("row 1 (line 2) has 3 values, and there are 2 columns",)),
        (('5;"7',), ("is no CSV at line 2", "correct the quotes")),
    ],
)
def test_what_can_be_read_in_two_ways_is_refused_with_both(
    tmp_path: Path, rows: tuple[str, ...], words: tuple[str, ...]
) -> None:
    (tmp_path / "data.csv").write_text("\n".join(("duration [s];inner_speed [rpm]", *rows)), "utf-8")
    refused(lambda: read_cycle(tmp_path / "data.csv"), "data.csv: ", *words)


def packed(size: int) -> bytes:
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w", zipfile.ZIP_DEFLATED) as parts:
        parts.writestr("xl/worksheets/sheet1.xml", bytes(size))
    return content.getvalue()


def edited(old: bytes, new: bytes, method: int = zipfile.ZIP_DEFLATED) -> bytes:
    """The workbook with other words in its first sheet, and in another compression."""
    content = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(BOOK)) as parts, zipfile.ZipFile(content, "w", method) as changed:
        for name in parts.namelist():
            part = parts.read(name)
            changed.writestr(name, part.replace(old, new) if name.endswith("sheet1.xml") else part)
    return content.getvalue()


@pytest.mark.parametrize(
    ("content", "words"),
    [
        (edited(b'<row r="700"', b'<row r="99999999999"'), "more than 100000 rows"),  # empty ones, one after the other
        (edited(b"", b"", zipfile.ZIP_BZIP2), "compression"),  # which unpacks without a limit
        (packed(LARGEST_UNPACKED + 1), "unpacks to more than 20 MB"),
        (packed(9), "is no .xlsx that can be read"),
        (BOOK[: len(BOOK) // 2], "is no .xlsx that can be read"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "is an .xls"),
    ],
)
def test_a_workbook_that_is_none_is_refused_in_one_line(tmp_path: Path, content: bytes, words: str) -> None:
    (tmp_path / "data.xlsx").write_bytes(content)
    refused(lambda: read_measured(tmp_path / "data.xlsx"), "data.xlsx: ", words, "save")


@pytest.mark.parametrize(
    "content",
    [
        b"Bearing;radial load [kN];axial load;speed [rpm];supply;oil\n"
        b"6206;1,2;;3000;;\n7208B;;2,5 kN;;oil_jet;ISO VG 68\n",
        workbook(
            [
                ["designation", "speed [rpm]", "radial load [kN]", "axial load", "supply", "oil", "pieces"],
                [6206, 3000, 1.2, None, None, None, 4],
                ["7208B", None, None, "2,5 kN", "oil_jet", "ISO VG 68", 2],
            ]
        ),
    ],
)
def test_a_list_has_the_options_of_each_bearing(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "list").write_bytes(content)
    (first, second), _ = read_list(tmp_path / "list")
    assert (first.designation, second.designation) == ("6206", "7208B")
    assert first.options == {"radial_load": "1.2 kN", "speed": "3000 rpm"}
    assert second.options == {"axial_load": "2.5 kN", "supply": "oil_jet", "oil": "ISO VG 68"}
    assert "row 2 (line " in second.place


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("designation,speed [N]\n6206,3", ("column speed [N] is not in a unit like rpm",)),
        ("designation,speed\n,3", ("row 1 (line 2): designation is empty",)),
        ("designation,load [N]\n6206,3", ("'load [N]' is not known", "did you mean axial_load [N]?")),
        ("designation,speed [rpm],oil\n6206,3", ("has 2 values, and there are 3 columns",)),
        ("torque [N m],speed [rpm]\n5,3", ("has a column torque and no column designation", "fembearing compare")),
    ],
)
def test_a_list_with_a_mistake_is_refused(tmp_path: Path, text: str, words: tuple[str, ...]) -> None:
    (tmp_path / "list.csv").write_text(text, "utf-8")
    refused(lambda: read_list(tmp_path / "list.csv"), "list.csv: ", *words)
