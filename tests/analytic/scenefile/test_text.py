"""Slips of TOML: the line is quoted, and the remedy is that line as TOML has it."""

import pytest

from analytic.errors import InputError
from analytic.scenefile.find import parse_text
from tests.refusals import refused

MISTAKES = {  # text that is no TOML, and the statement in TOML that the message gives; "": none is sure
    'a = "C:\\data\\new.csv"': "a = 'C:\\data\\new.csv'",
    'a = "C:\\users\\x"': "a = 'C:\\users\\x'",
    "a = C:\\data\\x.csv": "a = 'C:\\data\\x.csv'",
    "a = ~/x.csv": 'a = "~/x.csv"',
    "a = 0,5": "a = 0.5",
    "a = 1,5 mm": 'a = "1.5 mm"',
    "a = { b = 0,515, c = 3 }": "a = { b = 0.515, c = 3 }",
    "a = 2,500": "",
    "a = 1.000,5": "",
    "a = 700 N # load": 'a = "700 N"',
    "a = 5 %": 'a = "5 %"',
    "a = [100 rpm, 3]": 'a = ["100 rpm", 3]',
    "a = 5 N, 6 N": 'a = ["5 N", "6 N"]',
    'a = ["1 N" "2 N"]': 'a = ["1 N", "2 N"]',
    "a = (1, 2)": "a = [1, 2]",
    "a = [1,\n2\n3]": "a = [1, 2, 3]",
    "a = { b = 0.9 c = 0.8 }": "a = { b = 0.9, c = 0.8 }",
    "a = { b = 9; c = 8 }": "a = { b = 9, c = 8 }",
    "a = {b: 5, c:6}": "a = {b = 5, c = 6}",
    'a = { b = "x", c = 60 um }': 'a = { b = "x", c = "60 um" }',
    'a = { b = "x",\n c = "y" }': 'a = { b = "x", c = "y" }',
    "a = [1, 2": "a = [1, 2]",
    "a = 5 b = 6": "a = 5 and, in a line of its own, b = 6",
    "a = 5 // load": "a = 5 # load",
    "a = 5 ; load": "a = 5 # load",
    "% load\na = 5": "# load",
    "a = 5;": "a = 5",
    "a = .5": "a = 0.5",
    "a = -,5": "a = -0.5",
    "a = 5.": "a = 5.0",
    "a = 1.e5": "a = 1.0e5",
    "a = 05": "a = 5",
    "a == 5": "a = 5",
    "a b: 5": "a_b = 5",
    "a 5": "a = 5",
    "a:\n  b: 5": "[a]",
    'a = "700 N': 'a = "700 N"',
    "a = '700 N\"": "a = '700 N'",
    "a = '700 N\nb = 5": "a = '700 N'",
    "a = True": "a = true",
    "a = \u201e700 N\u201c": 'a = "700 N"',
    "[a": "[a]",
    "[a b]": "",
    "l\u00e4 = 5": "",
    'a = "5 N" axial': "",
}


@pytest.mark.parametrize(("text", "corrected"), MISTAKES.items())
def test_a_message_quotes_the_mistake_and_gives_the_statement_in_toml(text: str, corrected: str) -> None:
    with pytest.raises(InputError, match="x: not TOML: ") as found:
        parse_text(text, origin="x")
    said, _, remedy = str(found.value).partition("; write ")
    assert any(said.endswith(f"), in {line.partition(' #')[0].strip()}") for line in text.split("\n")), said
    assert remedy == corrected
    parse_text(remedy.replace(" and, in a line of its own, ", "\n"), origin="x")


@pytest.mark.parametrize("text", ["[a]\nb = 1\n[a]", "a = 1\na = 2"])
def test_what_is_given_twice_is_said(text: str) -> None:
    refused(lambda: parse_text(text, origin="x"), f"in {text.splitlines()[-1]}; it is given twice")


def test_a_key_of_many_parts_is_refused() -> None:
    refused(lambda: parse_text("a" + ".a" * 20 + " = 1", origin="x"), "too many parts", "at most four")
