"""Text of files that other programs save, in their encodings."""

import pytest

from analytic.reading import text_of

HEADS = "Drehzahl [rpm];Temperatur [°C];Öl\n500;62,5;VG 68\n"


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be", "cp1252", "latin-1"])
def test_a_text_is_read_in_the_encodings_of_spreadsheets(encoding: str) -> None:
    assert text_of(HEADS.encode(encoding)) == HEADS


def test_any_bytes_are_some_text() -> None:
    assert text_of(bytes(range(1, 256)) + b"\x81").startswith("\x01\x02")
    assert text_of(b"") == ""
