"""The tables of a page, read back."""

import re
from html.parser import HTMLParser

Row = tuple[str, ...]
APPENDIX = re.compile(r"^Appendix [A-Z]\s+")  # before the title of one


class Tables(HTMLParser):
    """The rows of cells under each heading."""

    def __init__(self, content: str) -> None:
        super().__init__()
        self.rows: dict[str, list[Row]] = {}
        self.text = ""
        self.heading = ""
        self.cells: list[str] = []
        self.style = ""  # class of the cell at hand
        self.styled: set[tuple[str, str]] = set()  # class and text of each cell
        self.place = ""  # the element that the text is in, if it is one of those read here
        self.feed(content)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        if tag in ("h2", "h3", "td", "th"):
            self.place = tag
        if tag in ("h2", "h3"):
            self.heading = ""
        elif tag == "tr":
            self.cells = []
        elif tag in ("td", "th"):
            self.cells.append("")
            self.style = dict(attrs).get("class") or ""

    def handle_endtag(self, tag: str) -> None:
        if tag in ("td", "th"):
            self.styled.add((self.style, self.cells[-1]))
        if tag == self.place:
            self.place = ""
        elif tag == "tr":
            heading = APPENDIX.sub("", self.heading)
            self.rows.setdefault(heading, []).append(tuple(" ".join(cell.split()) for cell in self.cells))

    def handle_data(self, data: str) -> None:
        self.text += data
        if self.place in ("h2", "h3"):
            self.heading += data
        elif self.place:
            self.cells[-1] += data

    def blocks(self, heading: str) -> dict[str, list[Row]]:
        """The rows below each row of a single cell."""
        found: dict[str, list[Row]] = {}
        for row in self.rows[heading]:
            if len(row) == 1:
                found[row[0]] = []
            elif found:
                found[next(reversed(found))].append(row)
        return found
