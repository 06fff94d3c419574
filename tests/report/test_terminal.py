"""Tables as a terminal prints them: without wide columns, every text as it is."""

import re
from io import StringIO

from rich.console import Console

from fembearing.report.document import Bullets, Group, Head, Section, Table, Text, table_of
from fembearing.report.terminal import print_sections


def text_of(*blocks: Table | Text | Bullets, width: int = 400) -> str:
    out = StringIO()
    print_sections(Console(file=out, width=width), [Section("a title", blocks)])
    return out.getvalue()


def test_only_the_lines_of_fixed_columns_stay_whole_where_there_is_little_room() -> None:
    whole, broken = "inner race 7", "some words that may be broken"
    table = table_of("", [Head("where", "name"), Head("words", "text")], [[whole, broken]])
    text = text_of(table, width=len(whole) + 12)  # characters: the first column, and a third of the second
    assert whole in text
    assert broken not in text
    assert all(word in text for word in broken.split())  # on lines of their own


def test_texts_are_taken_as_they_are_and_wide_ones_left_to_the_page() -> None:
    heads = [Head("ball", "name"), Head("load [N]", short="[N]"), Head("source", "text", wide=True)]
    rows = [["third", "37.2 [red]", "a drawing"], ["fifth", "8.9", "a scale"]]
    table = Table("Balls [bold]", heads, [Group(rows)], ["a [dim] note & <i>more</i>"])
    text = text_of(
        table, Text("for [b] all", "pass"), Text("for the page", wide=True), Bullets(["[i] one"], "[u] items")
    )
    lines = [re.split(r"\s{2,}", line.strip()) for line in text.splitlines() if line.strip()]
    assert lines[0] == ["Balls [bold]"]
    assert [lines[1], *lines[3:5]] == [["ball", "[N]"], ["third", "37.2 [red]"], ["fifth", "8.9"]]
    assert lines[5:] == [["a [dim] note & <i>more</i>"], ["pass: for [b] all"], ["[u] items"], ["[i] one"]]
