"""The page on the paper holds the numbers that are stored. `python validation/paper/docs.py` writes it anew."""

import json
from pathlib import Path

from validation.paper import docs as program

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs/paper.md").read_text("utf-8")


def test_the_page_is_that_of_the_stored_numbers() -> None:
    stored = json.loads(program.STORED.read_text("utf-8"))
    assert program.page(stored) == PAGE, "docs/paper.md differs from its numbers: run python validation/paper/docs.py"
    stored["readings"][1]["beside"][0]["computed"] *= 1.03  # the page follows the file
    assert program.page(stored) != PAGE


def test_every_number_that_the_paper_prints_stands_on_the_page() -> None:
    stored = json.loads((ROOT / "validation/paper/paper.json").read_text("utf-8"))
    for row in stored["readings"][0]["beside"]:
        value = row["point"]["value"]
        assert f"{value * 1e3 if row['point']['unit'] == 'N mm' else value:.4g}" in PAGE


def test_every_picture_is_there_and_has_words() -> None:
    for number in (5, 6, 7, 8, 9):
        assert f"## Figure {number}: " in PAGE
    pictures = [line for line in PAGE.splitlines() if line.startswith("![")]
    assert len(pictures) == 6
    for line in pictures:
        words, _, place = line.removeprefix("![").partition("](")
        assert len(words) > 20
        assert (ROOT / "docs" / place.rstrip(")")).is_file()
