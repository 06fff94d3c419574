"""The page of the effects lists those of the code. `python -m tests.analytic.effects.test_table` writes it anew."""

import re
from pathlib import Path
from textwrap import wrap

from analytic.effects.table import TABLE, Entry

PAGE = Path(__file__).parents[3] / "docs" / "effects.md"
COMMAND = "python -m tests.analytic.effects.test_table"
WIDTH = 120  # columns of a page


def item(entry: Entry) -> str:
    """An effect in the list of the page."""
    parts = [f"`{entry.name}`: {entry.meaning}"]
    if entry.needs is not None:
        parts.append(f"needs {entry.needs.keys}")
    if entry.kind == "limit":
        parts.append(f"limit: {entry.bound}")
    lines = wrap("; ".join(parts), WIDTH - 2, break_long_words=False, break_on_hyphens=False)
    return "- " + "\n  ".join(lines) + "\n"


def page_with_list(text: str) -> str:
    """The page, with the first list after its heading replaced."""
    heading, effects = text.split("## The effects\n", 1)
    listed = "".join(map(item, TABLE))
    return f"{heading}## The effects\n" + re.sub(r"(?:(?:- |  ).*\n)+", lambda _: listed, effects, count=1)


def test_the_page_lists_the_effects_of_the_code() -> None:
    text = PAGE.read_text("utf-8")
    assert page_with_list(text) == text, f"docs/effects.md differs from analytic/effects/table.py: run {COMMAND}"


if __name__ == "__main__":
    PAGE.write_text(page_with_list(PAGE.read_text("utf-8")), "utf-8")
