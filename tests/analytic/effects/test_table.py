"""The page of the effects shows the table of the code. `python -m tests.analytic.effects.test_table` writes it anew."""

import re
from pathlib import Path

from analytic.effects.table import TABLE

PAGE = Path(__file__).parents[3] / "docs" / "effects.md"
HEAD = "| effect | meaning | needs | bound or limit |\n| --- | --- | --- | --- |\n"
COMMAND = "python -m tests.analytic.effects.test_table"


def table_of_page() -> str:
    rows = (
        (f"`{entry.name}`", entry.meaning, "" if entry.needs is None else entry.needs.keys, entry.bound or "")
        for entry in TABLE
    )
    return HEAD + "".join("".join(f"| {cell} " if cell else "| " for cell in row) + "|\n" for row in rows)


def page_with_table(text: str) -> str:
    """The page, with the first table after its heading replaced."""
    heading, effects = text.split("## The effects\n", 1)
    return f"{heading}## The effects\n" + re.sub(r"(\|.*\n)+", lambda _: table_of_page(), effects, count=1)


def test_the_page_shows_the_table_of_the_code() -> None:
    text = PAGE.read_text("utf-8")
    assert page_with_table(text) == text, f"docs/effects.md differs from analytic/effects/table.py: run {COMMAND}"


if __name__ == "__main__":
    PAGE.write_text(page_with_table(PAGE.read_text("utf-8")), "utf-8")
