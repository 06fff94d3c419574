"""Tables by the lines that a terminal prints, and by the cells of the page: both have the same."""

import re
from io import StringIO

import pytest
from rich.console import Console

from fembearing.check.validation import Validation
from fembearing.report.page.template import environment
from fembearing.report.report import Report, report_of
from fembearing.report.tables.contacts import contacts_of, pocket_table
from fembearing.report.tables.cost import cost_table
from fembearing.report.tables.table import Group, Head, Table, table_of
from fembearing.report.tables.torque import ball_table, change_table, torque_table
from fembearing.report.terminal.table import MANY, printed, show
from fembearing.report.terminal.validation import print_details
from tests.analytic.specimens import present
from tests.report.page.page_writer import written_page
from tests.report.page.tables_of_page import Tables

ROOMY = 400  # columns: no cell is broken into lines
Rows = list[list[str]]


def text_of(table: Table, width: int = ROOMY) -> str:
    out = StringIO()
    show(Console(file=out, width=width), table)
    return out.getvalue()


def in_text(text: str) -> dict[str, Rows]:
    """The rows of each table by the line above its heads, heads first; without empty cells, which leave no trace."""
    lines = text.splitlines()
    found = {}
    for rule in (number for number, line in enumerate(lines) if line.startswith("───")):
        last = next(number for number in range(rule, len(lines) + 1) if number == len(lines) or not lines[number])
        rows = [re.split(r"\s{2,}", line.strip()) for line in (lines[rule - 1], *lines[rule + 1 : last])]
        found[lines[rule - 2].strip()] = [row for row in rows if len(row) > 1]  # notes have one blank between words
    return found


def in_page(page: Tables, title: str) -> Rows:
    """The rows of a table of the page by its heading, or of a group by its title, heads first."""
    if title in page.rows and title:
        return [list(row) for row in page.rows[title]]
    heading = next(heading for heading, rows in page.rows.items() if (title,) in rows)
    return [list(page.rows[heading][0]), *(list(row) for row in page.blocks(heading)[title])]


def html_of(table: Table) -> Tables:
    template = '{% from "macros.html" import titled %}{{ titled(given) }}'
    return Tables(str(environment().from_string(template).render(given=table)))


@pytest.fixture(scope="module")
def tables(document: Report) -> dict[str, Table]:
    torque, change = present(document.solved), present(document.torque_change)
    made = (
        torque_table(torque, "6205", range(3)),
        ball_table(torque, range(3)),
        change_table(torque.points, change, range(3)),
        contacts_of(document),
        present(pocket_table(document.contacts)),
        cost_table(document.cost.ladders),
    )
    return {table.label: table for table in made}


@pytest.mark.parametrize(
    "label",
    [
        "Friction torque of 6205",
        "Heaviest ball",
        "Changes by finite-element contacts",
        "Contacts",
        "Cage pocket: F = K_pb delta^1.5, at 28.5 N",
        "Methods",
    ],
)
def test_text_and_page_have_the_same_cells(tables: dict[str, Table], label: str) -> None:
    """The page alone those of wide columns."""
    table = tables[label]
    page, text = html_of(table), in_text(text_of(table))
    assert list(text) == [group.title or table.label for group in table.groups]
    kept = [place for place, head in enumerate(table.heads) if not head.wide]
    for title, (heads, *rows) in text.items():
        long_heads, *long_rows = in_page(page, title)
        assert long_heads == [head.text for head in table.heads]
        assert heads == [table.heads[place].short or long_heads[place] for place in kept]
        assert {len(row) for row in long_rows} == {len(long_heads)}
        assert rows == [[cell for place in kept if (cell := row[place])] for row in long_rows]
    words = " ".join(text_of(table).split())
    for note in (*table.notes, *(note for group in table.groups for note in group.notes)):
        assert " ".join(note.split()) in words
        assert " ".join(note.split()) in " ".join(page.text.split())


def test_every_table_that_a_check_prints_stands_in_its_page(made: Validation) -> None:
    """With the same rows in the same order; the page may have more columns."""
    out = StringIO()
    print_details(Console(file=out, width=ROOMY), report_of(made))
    page, text = Tables(written_page(made)), in_text(out.getvalue())
    assert len(text) == 4 + 3 + 1 + 2 + 1  # contacts, sliding, pocket, torque and its change, limits
    for title, (_, *rows) in text.items():
        _, *long_rows = in_page(page, title)
        assert len(rows) == len(long_rows)
        for row, long_row in zip(rows, long_rows, strict=True):
            rest = iter(long_row)
            assert all(cell in rest for cell in row), (title, row, long_row)  # each after the one before


def test_only_the_lines_of_fixed_columns_stay_whole_where_there_is_little_room() -> None:
    whole, broken = "inner race 7", "some words that may be broken"
    table = table_of("", [Head("where", "name"), Head("words", "text")], [[whole, broken]])
    text = text_of(table, len(whole) + 12)  # characters: the first column, and a third of the second
    assert whole in text
    assert broken not in text
    assert all(word in text for word in broken.split())  # on lines of their own


def test_terminal_and_page_take_every_text_as_it_is() -> None:
    heads = [Head("ball", "name"), Head("load [N]"), Head("source", "text", wide=True)]
    rows = [["third", "37.2 [red]", "a [red] drawing"], ["fifth", "8.9", "<b>a scale</b>"]]
    table = Table("Balls [bold]", heads, [Group(rows)], ["a [dim] note & <i>more</i>"])
    assert in_text(text_of(table)) == {"Balls [bold]": [[head.text for head in heads[:2]], *(row[:2] for row in rows)]}
    assert "a [dim] note & <i>more</i>" in text_of(table)
    page = html_of(table)
    assert in_page(page, "Balls [bold]") == [[head.text for head in heads], *rows]
    assert "a [dim] note & <i>more</i>" in page.text


def test_many_columns_stand_closer_together() -> None:
    for count, blanks in ((MANY, 2), (MANY + 1, 1)):
        out = StringIO()
        Console(file=out, width=ROOMY).print(printed(table_of("", [Head("ab")] * count, [["12"] * count])))
        assert (" " * blanks).join(["ab"] * count) in out.getvalue()
