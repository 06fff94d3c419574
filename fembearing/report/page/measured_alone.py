"""Measured torques beside the computed ones as one small HTML page: conclusions, figure and table."""

from analytic.figures.style import WIDTH
from analytic.scene import Scene
from fembearing.check.measured.comparison import MeasuredComparison
from fembearing.provenance import provenance_of
from fembearing.quantities import SYSTEMS
from fembearing.report.figures.measured import caption_of
from fembearing.report.figures.page_plots import PIXELS, ShownPlot, embedded
from fembearing.report.page.template import filled
from fembearing.report.tables.measured import COLUMNS, measured_table


def comparison_page(comparison: MeasuredComparison, scene: Scene, figure: bytes) -> str:
    """The page;  figure : PNG."""
    origin = provenance_of(scene)
    plot = ShownPlot("Measured and computed torque", caption_of(comparison), embedded(figure), round(PIXELS * WIDTH))
    return filled(
        "measured_alone.html",
        comparison=comparison,
        rows=measured_table(comparison, SYSTEMS[scene.report.units])._replace(notes=[*comparison.notes, COLUMNS]),
        plots={"measured": [plot]},
        versions=origin.versions,
        fingerprint=origin.scene_sha256,
    )
