"""The page on the paper holds the numbers that are stored. `python validation/paper/docs.py` writes it anew."""

import json
from pathlib import Path

from validation.paper import docs as program

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "validation/paper/figures.md").read_text("utf-8")


def test_the_page_is_that_of_the_stored_numbers() -> None:
    stored = json.loads(program.STORED.read_text("utf-8"))
    assert program.page(stored) == PAGE, "figures.md differs from its numbers: run python validation/paper/docs.py"
    stored["readings"][1]["beside"][0]["computed"] *= 1.03  # the page follows the file
    assert program.page(stored) != PAGE
