"""What accuracy costs: its file and its figures show the same ladders."""

import csv
from dataclasses import replace
from io import StringIO

import numpy as np
from matplotlib.axes import Axes

from fembearing.report.figures.cost import LEAST, MOST, cost_figures
from fembearing.report.sections.cost import cost_csv
from tests.report.figures.figure_reader import require_legible
from tests.report.specimens import ABSENT, COARSE, CONTACT, FAR


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
