"""What accuracy costs: its table, its file and its figures show the same ladders."""

import csv
from dataclasses import replace
from io import StringIO

import numpy as np
from matplotlib.axes import Axes

from fembearing.check.cost.ladder import Ladder, Method
from fembearing.report.figures.cost import LEAST, MOST, cost_figures
from fembearing.report.tables.cost import cost_csv, cost_table
from tests.report.figures.figure_reader import require_legible

HERTZ = Method(name="Hertz", error=0.031, bound=0.036, known_error=0.036, seconds=2e-6, memory=2**28, chosen=True)
COARSE = Method(name="finite elements, level 2", error=0.007, known_error=0.0072, seconds=0.4, spread=0.06, unknowns=31)
FAILED = Method(name="finite elements, level 3", failed="no room")
FINEST = Method(
    name="finite elements, level 4", bound=2e-4, known_error=2e-4, seconds=3.5, warm_up=0.8, memory=3 * 2**28
)
CONTACT = Ladder(quantity="the contact", reference="the finest", methods=(HERTZ, COARSE, FAILED, FINEST))
FAR = Ladder(
    quantity="the load",
    reference="the ring",
    methods=(Method(name="thrust", error=9.0, seconds=1e-3), Method(name="ring", error=1e-9, bound=77.0, seconds=0.1)),
)
ABSENT = Ladder(quantity="roughness", absent="no surface")


def test_the_table_shows_each_method_and_the_price_of_a_digit() -> None:
    contact, absent = cost_table([CONTACT, ABSENT]).groups
    assert contact.rows == [
        ["> Hertz", "3.1 %", "3.6 %", "2e-06", "", "", "0.25", ""],
        ["FE, level 2", "0.7 %", "", "0.4", "0.06", "", "", "31"],
        ["FE, level 3", "failed", "", "", "", "", "", ""],
        ["FE, level 4", "reference", "0.02 %", "3.5", "", "0.8", "0.75", ""],
    ]
    assert contact.notes == [
        "finite elements, level 3 failed: no room",
        "Price of the next digit: 10 %: Hertz, 2e-06 s; 1 %: FE, level 2, 0.4 s, 2e+05 times as much; "
        "0.1 %: FE, level 4, 3.5 s, 8.8 times as much; 0.01 %: none.",
        "Reference: the finest.",
    ]
    assert (absent.rows, absent.notes) == ([], ["Does not apply: no surface."])


def test_the_file_holds_every_method_and_what_is_absent() -> None:
    hertz, coarse, failed, finest, absent = csv.DictReader(StringIO(cost_csv([CONTACT, ABSENT])))
    assert (hertz["name"], float(hertz["error"]), float(hertz["bound"]), hertz["chosen"]) == (
        "Hertz",
        0.031,
        0.036,
        "True",
    )
    assert (coarse["unknowns"], coarse["bound"]) == ("31", "")
    assert (failed["failed"], failed["error"]) == ("no room", "")
    assert (finest["reference"], int(finest["memory"])) == ("the finest", 3 * 2**28)
    assert (absent["quantity"], absent["reference"], absent["name"]) == ("roughness", "absent: no surface", "")


def drawn(panel: Axes) -> list[tuple[list[float], ...]]:
    """Points of all lines but that of the tolerance, to nine digits."""
    lines = (np.asarray(line.get_data(), dtype=float) for line in panel.get_lines()[1:])
    return [tuple([float(f"{each:.9g}") for each in values] for values in line) for line in lines]


def test_points_bars_and_the_reference_are_drawn_in_per_cent() -> None:
    """Only levels of one discretisation are joined; what is off the scale stands at its end; a ring is chosen."""
    finer = replace(COARSE, name="finite elements, level 5", error=0.002, seconds=40.0)
    (figure,) = cost_figures([replace(CONTACT, methods=(*CONTACT.methods, finer)), ABSENT, FAR], tolerance=0.04)
    contact, load, memory = (panel for panel in figure.axes if panel.axison)
    hertz, bar, ring = ([2e-6], [3.1]), ([2e-6, 2e-6], [3.1, 3.6]), ([2e-6], [3.1])
    assert drawn(contact) == [hertz, ([0.4, 40.0], [0.7, 0.2]), bar, ring, ([3.5], [0.02])]
    assert drawn(load) == [([1e-3], [MOST]), ([0.1], [LEAST]), ([0.1, 0.1], [LEAST, MOST])]
    assert ([0.25], [3.1]) in drawn(memory)
    assert contact.get_xlim() == load.get_xlim()
    assert {text.get_text() for text in contact.texts} == {"1", "2", "4", "5"}  # the third failed
    require_legible(figure)


def test_four_panels_share_a_figure_of_the_page_and_all_are_in_one_file() -> None:
    ladders = [replace(CONTACT, quantity=f"quantity {number}") for number in range(6)]
    figures = [*cost_figures(ladders, tolerance=0.1), *cost_figures(ladders, tolerance=1e-308, most=7)]
    assert [sum(panel.axison for panel in figure.axes) for figure in figures] == [4, 3, 7]
    for figure in figures:
        require_legible(figure)
