"""Slips of TOML: the line is quoted, and its remedy, written as it says, is read."""

import pytest

from analytic.errors import InputError
from analytic.scenefile.find import parse_text
from tests.refusals import refused

SLIPS = {  # a line with a slip: what the message says, and the line as the remedy has it; "": no remedy is sure
    'a = "C:\\data\\new.csv"': ("write text with \\ in single quotes: 'C:\\data\\new.csv'", "a = 'C:\\data\\new.csv'"),
    'a = "C:\\users\\x"': ("write text with \\ in single quotes: 'C:\\users\\x'", "a = 'C:\\users\\x'"),
    "a = 0,5": ("write a decimal point: 0.5", "a = 0.5"),
    "a = 1,000.5": ("", ""),
    "a = 700 N": ('write the value in quotes: "700 N"', 'a = "700 N"'),
    "a = 700 N # load": ('write the value in quotes: "700 N"', 'a = "700 N"'),
    "a = [100 rpm, 3]": ('write the value in quotes: "100 rpm"', 'a = ["100 rpm", 3]'),
    'a = ["1 N" "2 N"]': ("write a comma between the values", 'a = ["1 N", "2 N"]'),
    "a = { b = 0.9 c = 0.8 }": ("write a comma between the keys", "a = { b = 0.9, c = 0.8 }"),
    'a = { b = "x",\n c = "y" }': ("write a table in { } in one line", 'a = { b = "x", c = "y" }'),
    "a = [1, 2": ("close the list: ]", "a = [1, 2]"),
    "a = 5 b = 6": ("write each key in a line of its own", "a = 5\nb = 6"),
    "a = 5 // load": ("a comment begins with #", "a = 5 # load"),
    "a = 5 ; load": ("a comment begins with #", "a = 5 # load"),
    "% load\na = 5": ("a comment begins with #", "# load\na = 5"),
    "a = 5;": ("leave out the semicolon at the end", "a = 5"),
    "a = .5": ("write 0.5", "a = 0.5"),
    "a = -.5": ("write -0.5", "a = -0.5"),
    "a = 5.": ("write 5.0", "a = 5.0"),
    "a = 1.e5": ("write 1.0e5", "a = 1.0e5"),
    "a == 5": ("write one =", "a = 5"),
    "a b: 5": ("write a_b = and the value", "a_b = 5"),
    'a = "700 N': ("close the quotes", 'a = "700 N"'),
    "a = '700 N\nb = 5": ("close the quotes", "a = '700 N'\nb = 5"),
    "a = True": ("write true in small letters", "a = true"),
    "a = \u201c700 N\u201d": ('write straight quotes, "', 'a = "700 N"'),
    "[a": ("close the bracket: [a]", "[a]"),
    "[a b]": ("", ""),
    "[a]\nb = 1\n[a]": ("[a] is given twice: put its keys into one table", "[a]\nb = 1"),
    "a = 1\na = 2": ("a is given twice: leave one of them out", "a = 2"),
    "l\u00e4 = 5": ("", ""),
    'a = "5 N" axial': ("", ""),
}


@pytest.mark.parametrize("text", SLIPS)
def test_a_slip_is_quoted_and_its_remedy_is_read(text: str) -> None:
    remedy, mended = SLIPS[text]
    with pytest.raises(InputError, match="x: not TOML: ") as found:
        parse_text(text, origin="x")
    said = str(found.value)
    assert any(f"), in {line.strip()}" in said for line in text.split("\n")), said
    if remedy:
        assert f"; {remedy}" in said
        assert parse_text(mended, origin="x") != {}
    else:
        assert "; " not in said


def test_a_key_of_many_parts_is_refused() -> None:
    refused(lambda: parse_text("a" + ".a" * 20 + " = 1", origin="x"), "too many parts", "at most four")
