"""The form of the tables of a terminal, by the lines that are printed."""

from io import StringIO

from rich.console import Console

from fembearing.report.page.template import environment
from fembearing.report.tables.table import Head
from fembearing.report.tables.table import table_of as rows_of
from fembearing.report.terminal.table import printed, table_of


def test_only_the_lines_of_fixed_columns_stay_whole_where_there_is_little_room() -> None:
    whole, broken = "inner race 7", "some words that may be broken"
    table = table_of(["where", "words"], left=("where", "words"), fixed=("where",))
    table.add_row(whole, broken)
    out = StringIO()
    console = Console(file=out, width=len(whole) + 12)  # characters: the first column, and a third of the second
    console.print(table)
    assert whole in out.getvalue()
    assert broken not in out.getvalue()
    assert all(word in out.getvalue() for word in broken.split())  # on lines of their own


def test_terminal_and_page_render_the_same_cells_and_the_page_alone_the_wide_ones() -> None:
    heads = [Head("ball", "name"), Head("load, N"), Head("source", "text", wide=True)]
    table = rows_of("Balls", heads, [["third", "37.2", "a [red] drawing"], ["fifth", "8.9", "<b>a scale</b>"]])
    out = StringIO()
    Console(file=out, width=80).print(printed(table))
    lines = [line.split() for line in out.getvalue().splitlines()]
    assert lines[0] == ["Balls"]
    assert [*lines[1], *lines[3], *lines[4]] == ["ball", "load,", "N", "third", "37.2", "fifth", "8.9"]
    page = str(environment().from_string('{% from "macros.html" import table %}{{ table(given) }}').render(given=table))
    for words in ("Balls", "load, N", "37.2", "8.9", "a [red] drawing", "&lt;b&gt;a scale&lt;/b&gt;"):
        assert words in page
