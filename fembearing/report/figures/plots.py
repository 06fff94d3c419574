"""Every plot of the page, in the order of its sections."""

from matplotlib.figure import Figure

from fembearing.report.figures.approach import approach_plot
from fembearing.report.figures.cage import cage_plot
from fembearing.report.figures.convergence import convergence_plot
from fembearing.report.figures.cost import cost_figure
from fembearing.report.figures.friction import friction_plot
from fembearing.report.figures.plot import Document, Plot
from fembearing.report.figures.pressure import pressure_plot
from fembearing.report.figures.sensitivity import sensitivity_plot
from fembearing.report.figures.torque import torque_plot


def _cost(document: Document) -> tuple[Figure, str]:
    ran = " and its memory" if document["cost"]["measured"] else ", for the rungs that this check ran"
    return cost_figure(document["cost"]["ladders"], tolerance=document["tolerance"]), (
        f"Error of each rung against its time{ran}. Formulas take less than some milliseconds, ever finer meshes "
        "seconds. A bar reaches to the bound on the error; the reference is hollow. Rungs whose error and bound are "
        "below the dotted line are within the tolerance; the cheapest of them is enough, and has a ring."
    )


PLOTS: tuple[Plot, ...] = (
    Plot(section="verdicts", heading="Stiffness: load over approach", draw=approach_plot),
    Plot(section="torque", heading="Torque by effect", draw=torque_plot),
    Plot(section="torque", heading="Friction, film and asperities", draw=friction_plot),
    Plot(section="torque", heading="Sensitivity to inputs", draw=sensitivity_plot),
    Plot(section="torque", heading="Orbit of the cage and its forces", draw=cage_plot),
    Plot(section="convergence", heading="Order of convergence", draw=convergence_plot),
    Plot(section="pressure", heading="Pressure along both axes", draw=pressure_plot),
    Plot(section="cost", heading="Error against time", draw=_cost),
)
