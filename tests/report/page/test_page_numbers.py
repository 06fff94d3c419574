"""Each number of the page in its row and column, against a result made by hand: see `made` in conftest.py."""

import re
from html.parser import HTMLParser

import pytest

from fembearing.check.validation import Validation
from tests.report.page.page_writer import written_page

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


@pytest.fixture(scope="module")
def tables(made: Validation, tmp_path_factory: pytest.TempPathFactory) -> Tables:
    return Tables(written_page(made, tmp_path_factory.mktemp("numbers")))


def test_each_verdict_stands_with_its_numbers(tables: Tables) -> None:
    """Quantity, Hertz, finite elements, the difference with a star where it exceeds the uncertainty of mesh and far
    boundary together, that uncertainty, the order of convergence, and the verdict."""
    blocks = tables.blocks("Contacts")
    inner, outer, seat, sheet = blocks
    assert inner.startswith("Ball on inner race")
    assert inner.endswith("371.5 N")
    assert outer.startswith("Ball on outer race")
    assert outer.endswith("368.5 N")
    assert seat == "Ball in cage pocket, thick seat: 28.5 N"
    assert blocks[inner] == [
        ("approach, um", "5.3295", "5.2250", "+2.00% *", "1.14%", "3.6", "pass"),
        ("semi-axis a, mm", "0.11760", "0.12000", "-2.00%", "2.03%", "2.7", "pass"),
        ("semi-axis b, mm", "0.96800", "0.88000", "+10.00% *", "1.80%", "1.4", "fail"),
        ("peak pressure, GPa", "1.7850", "1.7000", "+5.00% *", "1.39%", "4.2", "undecided"),
        ("stiffness, GN/m^1.5", "24.250", "25.000", "-3.00% *", "1.41%", "none", "undecided"),
    ]
    assert blocks[outer] == [
        ("approach, um", "6.0800", "6.4000", "-5.00% *", "0.81%", "3.3", "outside"),
        ("semi-axis a, mm", "0.14140", "0.14000", "+1.00%", "1.31%", "2.9", "outside"),
        ("semi-axis b, mm", "0.78000", "0.75000", "+4.00% *", "2.73%", "1.8", "outside"),
        ("peak pressure, GPa", "1.5680", "1.6000", "-2.00% *", "0.25%", "4.7", "outside"),
        ("stiffness, GN/m^1.5", "22.800", "24.000", "-5.00%", "5.02%", "2.2", "outside"),
    ]
    assert blocks[seat] == [
        ("approach, um", "0.60900", "0.58000", "+5.00% *", "0.48%", "3.1", "undecided"),
        ("semi-axis a, mm", "0.31310", "0.31000", "+1.00% *", "0.21%", "1.9", "pass"),
        ("semi-axis b, mm", "0.31680", "0.32000", "-1.00% *", "0.25%", "2.1", "pass"),
        ("peak pressure, GPa", "0.13720", "0.14000", "-2.00%", "3.07%", "2.4", "undecided"),
        ("stiffness, GN/m^1.5", "60.800", "64.000", "-5.00% *", "0.52%", "3.4", "undecided"),
    ]
    assert blocks[sheet][0] == ("approach, um", "0.60900", "0.87000", "-30.00% *", "0.33%", "2.8", "shown")
    corrected = "approach 5.2198 um (-0.10%), semi-axis a 0.1203 mm (+0.25%), semi-axis b 0.8778 mm (-0.25%)"
    assert corrected in " ".join(tables.text.split())


def test_no_verdict_wears_the_colour_of_another(tables: Tables) -> None:
    colours = {"pass": "pass", "fail": "fail", "undecided": "undecided", "outside validity": "outside"}
    for verdict, colour in colours.items():
        assert {style for style, text in tables.styled if text == verdict} == {colour}


def test_the_pocket_is_set_against_hertz(tables: Tables) -> None:
    (heading,) = (each for each in tables.rows if each.startswith("Cage pocket"))
    assert [row[1:] for row in tables.rows[heading][1:]] == [
        ("60.80", "", "+0.0%", "0.6090"),
        ("64.00", "0.52%", "+5.3%", "0.5800"),  # 64/60.8; the other way round it would be -5.0 %
        ("39.52", "0.57%", "-35.0%", "0.8700"),
    ]


def test_each_operating_point_has_its_torque_and_what_contacts_change_in_it(tables: Tables) -> None:
    """The total that `torque` computes, by its parts, and the same total with what finite elements change."""
    assert tables.rows["Friction torque of 6205"][1:] == [
        ("1", "150", "700", "17.10", "11.40", "2.500", "34.00", "1.1 %", "21 %"),
        ("2", "300", "900", "22.50", "14.30", "3.200", "42.00", "1.2 %", "22 %"),
        ("3", "600", "910", "27.00", "19.00", "4.000", "53.00", "1.3 %", "23 %"),
    ]
    assert tables.rows["Changes by finite-element contacts"][1:] == [
        ("1", "150", "700", "34.00", "16.16 (0.2820)", "-", "-", "-", "-"),
        ("2", "300", "900", "42.00", "17.26 (0.3013)", "43.00", "17.18 (0.2998)", "+2.38", "-2.13"),  # 1 N mm more
        ("3", "600", "910", "53.00", "17.37 (0.3032)", "51.50", "17.30 (0.3019)", "-2.83", "-2.67"),
    ]
    assert "the change is the whole effect of the true shapes" in " ".join(tables.text.split())
    assert "1.37 %" in tables.text
    assert "the torque does not depend on speed" not in tables.text  # no lubricant, and yet it does


def test_each_row_has_a_cell_for_each_head(tables: Tables) -> None:
    """A row of one cell is a heading between rows."""
    assert len(tables.rows) > 15
    for heading, (head, *rows) in tables.rows.items():
        assert {len(row) for row in rows} <= {1, len(head)}, heading


def test_each_input_stands_with_its_origin(tables: Tables) -> None:
    rows = tables.rows["Sources of the inputs"][1:]
    assert ("bearing.ball_count", "9", "printed", "Table 1 of [Paper]") in rows


def test_each_effect_stands_with_its_share_and_reason(tables: Tables) -> None:
    assert tables.rows["Effects"][1:] == [
        ("spin", "on", "56.2 %", "asked for"),
        ("rolling", "off", "not known", "nobody knows it"),
    ]


def test_the_mesh_study_shows_what_each_mesh_gave(tables: Tables) -> None:
    """Quantity, values, order, GCI, extrapolated, uncertainty from the meshes and from the far boundary."""
    inner, outer, seat, sheet = tables.blocks("Meshes and convergence").values()
    assert inner == [
        ("approach, um", "4.4000, 5.0600, 5.5000", "3.6", "3.30%", "5.2250", "1.10%", "0.30%"),
        ("semi-axis a, mm", "0.12600, 0.12120, 0.11950", "2.7", "5.85%", "0.12000", "1.95%", "0.55%"),
        ("semi-axis b, mm", "0.79200, 0.86240, 0.89000", "1.4", "5.10%", "0.88000", "1.70%", "0.60%"),
        ("peak pressure, GPa", "1.8700, 1.7340, 1.6900", "4.2", "3.60%", "1.7000", "1.20%", "0.70%"),
        ("stiffness, GN/m^1.5", "32.500, 27.500, 25.000", "none", "none", "", "1.40%", "0.20%"),
    ]
    assert outer[0] == ("approach, um", "7.1000, 6.5000, 6.3000", "3.3", "2.40%", "6.4000", "0.80%", "0.10%")
    assert seat[3] == ("peak pressure, GPa", "0.16000, 0.15000, 0.13500", "2.4", "8.61%", "0.14000", "2.87%", "1.10%")
    assert sheet[4] == ("stiffness, GN/m^1.5", "43.000, 41.000, 39.000", "3.2", "1.71%", "39.520", "0.57%", "0.00%")


def test_the_whole_is_as_bad_as_its_worst_quantity(made: Validation, tables: Tables) -> None:
    assert made.verdict == "fail"
    assert "References and limits fail" in " ".join(tables.text.split())
