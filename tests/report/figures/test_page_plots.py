"""How a plot becomes part of the page."""

import base64
import re
from types import SimpleNamespace
from typing import cast

import pytest
from matplotlib.figure import Figure

from fembearing.report.document import Drawing, Text
from fembearing.report.figures.page_plots import PIXELS, Plot, plots_of
from fembearing.report.report import Report


def test_a_figure_comes_as_a_picture_of_its_width_and_none_as_its_reason_alone() -> None:
    figures = [Figure(figsize=(2.5, 0.75)), Figure(figsize=(3.25, 0.5))]
    plots = [
        Plot(section="torque", heading="Drawn", draw=lambda _: (figures[0], "what is drawn")),
        Plot(section="torque", heading="Empty", draw=lambda _: (None, "why there is none")),
        Plot(section="cost", heading="Two", draw=lambda _: (figures, "what both show")),
    ]
    shown = plots_of(cast(Report, SimpleNamespace()), plots)
    drawn, empty = shown["torque"]
    assert empty == Text("why there is none", wide=True, quiet=True)
    found = [each for each in (drawn, *shown["cost"]) if isinstance(each, Drawing)]
    words = [("Drawn", "what is drawn"), ("Two", "what both show"), ("Two, continued", "")]
    assert [(plot.heading, plot.caption) for plot in found] == words
    for plot, inches in zip(found, (2.5, 2.5, 3.25), strict=True):
        assert plot.width == PIXELS * inches
        kind, content = plot.source.split(",")
        assert kind == "data:image/svg+xml;base64"
        size = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', base64.b64decode(content).decode())
        assert size is not None
        assert float(size[1]) == pytest.approx(72 * inches)  # points
