"""The form of the tables of a terminal, by the lines that are printed."""

from io import StringIO

from rich.console import Console

from fembearing.report.terminal.table import table_of


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
