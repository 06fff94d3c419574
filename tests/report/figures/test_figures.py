"""Every figure: its axes have units, it draws the numbers that it claims, and its words are legible.

`FIGURES` has every function that gives a figure; a test looks for those that it lacks.
"""

import inspect
import json
import pkgutil
import re
from collections.abc import Callable, Iterator
from importlib import import_module
from types import SimpleNamespace
from typing import Any, NamedTuple, cast

import numpy as np
import pytest
import xarray
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle, StepPatch

import analytic.figures
import fembearing.report.figures
from analytic.figures.torque import torque_figure
from analytic.scene_torque import SceneTorque, torque_of_scene
from analytic.scenefile.read import parse_scene
from analytic.units import INCH_POUND, METRIC
from fembearing.check.cage_record import CageRecord
from fembearing.check.contact import figure as contact_figure
from fembearing.check.film import figure as film_figures
from fembearing.check.film.figure import film_figure
from fembearing.check.validation import Validation
from fembearing.report.figures.cage import cage_plot
from fembearing.report.figures.contacts import approach_plot, convergence_plot, pressure_plot
from fembearing.report.figures.duty import duty_figure
from fembearing.report.figures.measured import measured_plot
from fembearing.report.figures.prediction import prediction_plot
from fembearing.report.figures.ring import ring_plot
from fembearing.report.figures.sweep_maps import map_figure
from fembearing.report.figures.torque import compared_figure, friction_plot, torque_plot
from fembearing.report.report import Report, report_of
from tests.analytic.scenefile.scene_texts import OILED, SPEEDS, changed
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import area_of, bars_of, line_of, points_of, require_legible
from tests.report.figures.intervals import INTERVAL
from tests.report.specimens import TWO

TESTED_APART = {  # in files of their own
    "bearing_plot",
    "cost_figures",
    "draw_bearing",
    "height_map_figure",
    "height_map_plot",
    "sensitivity_plot",
}
PARTS = {  # what is called a figure but is a part of one
    "panel_of",
    "lettered",
    "bars_figure",  # of torque_figure and compared_figure
    "contact_columns",
    "pressure_figure",  # of pressure_plot
    "interval_figure",
    "measured_figure",
    "drawing_of",
    "orbit_figure",
}
UNIT = re.compile(r", (rpm|N|N mm|lbf|lbf in|W|s|min|um|mm|GPa|%|ms|deg|semi-axes( a)?)$|% of its peak$")
NUMBERS = {"friction coefficient", "film over roughness", "unknowns", "operating point"}


class Sources(NamedTuple):
    """What figures are drawn of."""

    document: Report  # made by hand
    solved: Report
    checked: Validation
    record: CageRecord


class Drawn(NamedTuple):
    """A figure with the numbers read from it, each beside the number that it should be."""

    figure: Figure
    claims: list[tuple[Any, Any]]


@pytest.fixture(scope="module")
def sources(document: Report, checked: Validation, record: CageRecord) -> Sources:
    return Sources(document, report_of(checked), checked, record)


def torque_at(speeds: str, *, loads: str = '"700 N"', units: str = "metric") -> SceneTorque:
    text = changed('"700 N"', loads, changed(SPEEDS, speeds, OILED))
    return torque_of_scene(parse_scene(f'{text}[report]\nunits = "{units}"\n', origin="here"))


def over_a_decade(_sources: Sources) -> Drawn:
    """The total and its interval are lines on logarithmic axes, with room below the least of them."""
    result = torque_at('["30 rpm", "10 rpm", "300 rpm"]')
    figure = result.plot()
    (panel,) = figure.axes
    order = [1, 0, 2]
    total, ends = 1e3 * result.friction.torque.total[order], 1e3 * present(result.interval)[:, order]
    band = area_of(panel, "95 % interval")
    least = min(total.min(), ends.min())
    rolling = points_of(line_of(panel, "rolling against the oil"))
    makers = {str(line.get_label()) for line in panel.get_lines()}
    return Drawn(
        figure,
        [
            ((panel.get_xscale(), panel.get_yscale()), ("log", "log")),
            (points_of(line_of(panel, "total")), np.column_stack([[10, 30, 300], total])),
            (band, ([10, 30, 300], *ends)),
            (rolling[:, 1], 1e3 * present(result.friction.torque.rolling)[order]),
            (panel.get_ylim()[0] < 0.9 * least, True),
            (makers >= {"SKF", "Palmgren"}, True),  # ISO 15312 has no constants of this bearing
            (figure.get_suptitle(), "6205, oil at 40 degC\n700 N axial"),
        ],
    )


def below_a_decade(_sources: Sources) -> Drawn:
    """Parts are stacked up to the total, in the units of the scene."""
    result = torque_at('["300 rpm", "700 rpm"]', units="inch")
    figure = result.plot()
    (panel,) = figure.axes
    factor = INCH_POUND.torque.factor
    below = np.zeros(2)
    for words, part in (("conformity slip", "conformity"), ("rolling against the oil", "rolling")):
        _, low, high = area_of(panel, words)
        below = below + high - low
        np.testing.assert_allclose(high - low, factor * getattr(result.friction.torque, part), rtol=1e-9)
    edges = [points_of(line)[:, 1] for line in panel.get_lines() if line.get_linestyle() == "--"]
    return Drawn(
        figure,
        [
            (points_of(line_of(panel, "total"))[:, 1], factor * result.friction.torque.total),
            (edges, factor * present(result.interval)),
            (panel.get_ylim()[0], 0),
            (panel.get_ylabel(), "friction torque, lbf in"),
        ],
    )


def point_by_point(_sources: Sources) -> Drawn:
    """Where speed and load change, the bars of a point add up to its total."""
    result = torque_at('["300 rpm", "700 rpm"]', loads='["900 N", "400 N"]')
    figure = result.plot()
    (panel,) = figure.axes
    ends = np.zeros(2)
    for bar in (each for each in panel.patches if isinstance(each, Rectangle)):
        ends[round(bar.get_y() + bar.get_height() / 2)] += bar.get_width()
    names = [text.get_text() for text in panel.get_yticklabels()]
    return Drawn(
        figure,
        [
            (np.round(ends / (1e3 * result.friction.torque.total), 5), [1, 1]),  # a part below 1e-6 has no bar
            (bars_of(panel, "total, 95 % interval", axis=0), 1e3 * present(result.interval).T),
            (names, ["300 rpm, 900 N axial", "700 rpm, 400 N axial"]),
        ],
    )


def one_point(_sources: Sources) -> Drawn:
    """A bar for each part and one for the total, with numbers."""
    result = torque_at('"300 rpm"')
    figure = result.plot()
    (panel,) = figure.axes
    widths = [bar.get_width() for bar in panel.patches if isinstance(bar, Rectangle)]
    total = 1e3 * result.friction.torque.total[0]
    low, high = 1e3 * present(result.interval)[:, 0]
    words = figure.get_suptitle().splitlines()
    return Drawn(
        figure,
        [
            ([widths[-1], sum(widths[:-1])], [total, total]),
            (panel.texts[len(widths) - 1].get_text(), f"{total:.4g}"),
            (words, ["6205, oil at 40 degC", "700 N axial, 300 rpm", f"95 % interval {low:.3g}-{high:.3g} N mm"]),
        ],
    )


def without_interval(_sources: Sources) -> Drawn:
    """A torque alone has its uncertainties, and bearing, oil and temperature in the title."""
    result = torque_at('["300 rpm", "700 rpm"]').friction
    figure = result.plot()
    (panel,) = figure.axes
    half = result.numerical_uncertainty
    edges = [points_of(line)[:, 1] for line in panel.get_lines() if line.get_linestyle() == "--"]
    half = half + (0 if result.model_uncertainty is None else result.model_uncertainty)
    total = 1e3 * result.torque.total
    return Drawn(
        figure,
        [
            (edges, [total * (1 - half), total * (1 + half)]),
            (figure.get_suptitle().splitlines()[0], "a series, oil at 40 degC"),
        ],
    )


def several_scenes(_sources: Sources) -> Drawn:
    """A line for each scene; one at one speed is a mark at this speed."""
    scenes = {"a.toml": torque_at('["10 rpm", "300 rpm"]'), "b.toml": torque_at('"100 rpm"')}
    figure = compared_figure({name: each.drawn for name, each in scenes.items()})
    (panel,) = figure.axes
    (first, second) = (1e3 * each.friction.torque.total for each in scenes.values())
    line = points_of(line_of(panel, "a.toml"))
    (bars,) = bars_of(panel, "b.toml: 6205, oil at 40 degC")
    return Drawn(
        figure,
        [
            (line, np.column_stack([[10, 300], first])),
            (bars, 1e3 * present(scenes["b.toml"].interval)[:, 0]),
            ((panel.get_xscale(), panel.get_yscale()), ("log", "log")),
            (panel.get_ylim()[0] < min(first.min(), second[0]), True),
        ],
    )


def several_points(_sources: Sources) -> Drawn:
    """Scenes of one operating point each have a bar of parts each."""
    scenes = {name: torque_at(f'"{name} rpm"') for name in ("100", "300")}
    figure = compared_figure({name: each.drawn for name, each in scenes.items()})
    (panel,) = figure.axes
    ends = bars_of(panel, "total, 95 % interval", axis=0)
    names = [text.get_text().split(":")[0] for text in panel.get_yticklabels()]
    return Drawn(figure, [(ends, [1e3 * present(each.interval)[:, 0] for each in scenes.values()]), (names, [*scenes])])


def report_torque(sources: Sources) -> Drawn:
    """The report has the figure of the torque."""
    figure, caption = torque_plot(sources.document)
    (panel,) = present(figure).axes
    points = present(sources.document.solved).points
    names = [text.get_text() for text in panel.get_yticklabels()]
    errorbar = bars_of(panel, "total, uncertainty", axis=0)
    totals = np.array([1e3 * point["torque_total"] for point in points])
    return Drawn(
        present(figure), [(len(names), len(points)), (errorbar.mean(axis=1), totals), ("uncertainty" in caption, True)]
    )


def friction(sources: Sources) -> Drawn:
    figure, _ = friction_plot(sources.document)
    panel = present(figure).axes[0]
    points = present(sources.document.solved).points
    drawn = points_of(line_of(panel, "inner"))[:, 1]
    expected = [present(point["friction_coefficient_inner"]) for point in points]
    return Drawn(present(figure), [(drawn, expected)])


def approach(sources: Sources) -> Drawn:
    figure, _ = approach_plot(sources.document)
    above = present(figure).axes[0]
    curve = sources.document.contacts[0].approach_curve
    hertz = points_of(line_of(above, "Hertz"))
    return Drawn(
        present(figure),
        [
            (hertz, np.column_stack([1e6 * np.array(curve.hertz), curve.load])),
            (len(present(figure).axes), 2 * len(sources.document.contacts)),
        ],
    )


def convergence(sources: Sources) -> Drawn:
    """4.4, 5.06 and 5.5 against the limit 5.225; without an order, 32.5 and 27.5 against the finest, 25."""
    figure, _ = convergence_plot(sources.document)
    panels = {axes.get_title(): axes for axes in present(figure).axes}
    settled, scattered = (points_of(line_of(panels[name], "inner race")) for name in ("approach", "stiffness"))
    return Drawn(
        present(figure),
        [
            (settled, [(1200, 82.5 / 5.225), (9500, 16.5 / 5.225), (31000, 27.5 / 5.225)]),
            (scattered, [(1200, 30), (9500, 10)]),
        ],
    )


def pressure(sources: Sources) -> Drawn:
    figure, _ = pressure_plot(sources.solved)
    contact, above = sources.solved.contacts[0], present(figure).axes[0]
    nodes = contact.pressure_profile.rolling.fe
    expected = np.column_stack(
        [np.array(nodes.position) / contact.hertz.semi_axis_rolling, 1e-9 * np.array(nodes.pressure)]
    )
    (alone, _) = sources.checked.contacts[0].plot().axes
    return Drawn(
        present(figure),
        [(points_of(line_of(each, "rolling")), expected) for each in (above, alone)],
    )


def ring(sources: Sources) -> Drawn:
    figure, _ = ring_plot(sources.document)
    polar = present(figure).axes[0]
    ring = present(present(sources.document.solved).friction.ring)
    return Drawn(present(figure), [(np.asarray(polar.get_lines()[0].get_ydata())[:-1], ring.load[0, 0])])


def interval(_sources: Sources) -> Drawn:
    """Ends of the whole, of the parts, and the indices of the inputs that matter."""
    figure, _ = prediction_plot(
        cast(Report, SimpleNamespace(solved=SimpleNamespace(prediction=INTERVAL), units=METRIC))
    )
    slow, _, indices, _ = present(figure).axes
    ends = [(bar.get_x(), bar.get_x() + bar.get_width()) for bar in slow.patches if isinstance(bar, Rectangle)]
    widths = [bar.get_width() for bar in indices.patches if isinstance(bar, Rectangle)]
    expected = 21 * np.array([(0.6, 1.9), (0.98, 1.03), (0.7, 1.5), (0.8, 1.4), (0.9, 1.1)])
    return Drawn(present(figure), [(ends, expected), (widths, [61, 54.9, 14, 12.6])])


def measured(_sources: Sources) -> Drawn:
    figure, _ = measured_plot(cast(Report, SimpleNamespace(measured=TWO, units=METRIC)))
    above, below = present(figure).axes
    marks = [
        [np.asarray(line.get_xydata()) for line in panel.lines if line.get_marker() == "D"] for panel in (above, below)
    ]
    points = [next(each for each in found if each.size) for found in marks]
    return Drawn(present(figure), [(points[0], [(600, 40)]), (points[1], [(600, 25)])])


def cage(sources: Sources) -> Drawn:
    motion = sources.record.drawn()
    figures, _ = cage_plot(cast(Report, SimpleNamespace(cage_records=(motion,), units=METRIC)))
    (figure,) = present(figures)
    orbit, forces, _ = figure.axes
    drawn, largest = points_of(line_of(orbit, "measured")), points_of(line_of(forces, "largest of one ball"))
    pressed = np.array(motion.forces.largest) > 0
    return Drawn(
        figure,
        [
            (drawn, 1e6 * np.array(motion.orbit.measured)),
            (largest[pressed], np.column_stack([1e3 * np.array(motion.forces.time), motion.forces.largest])[pressed]),
        ],
    )


def duty(_sources: Sources) -> Drawn:
    """Steps of 20, 50 and 30 s, the second without an interval."""
    torques, powers, durations = np.array([5e-3, 8e-3, 3e-3]), np.array([0.7, 1.9, 0.4]), (20.0, 50.0, 30.0)
    steps = [
        SimpleNamespace(
            duration=time,
            power=power,
            torque=SimpleNamespace(value=torque, low=0.8 * torque if number != 1 else None, high=1.3 * torque),
        )
        for number, (time, torque, power) in enumerate(zip(durations, torques, powers, strict=True))
    ]
    known: Any = SimpleNamespace(
        steps=steps,
        duration=100.0,
        energy=SimpleNamespace(low=0.02),
        mean_torque=SimpleNamespace(value=6e-3),
        mean_power=SimpleNamespace(value=1.1),
    )
    figure = duty_figure(known)

    def stairs_of(panel: Axes, label: str) -> Any:
        (found,) = (each for each in panel.patches if isinstance(each, StepPatch) and each.get_label() == label)
        return found.get_data()

    above, below = figure.axes
    return Drawn(
        figure,
        [
            (stairs_of(above, "torque").edges, [0, 20, 70, 100]),
            (stairs_of(above, "torque").values, 1e3 * torques),
            (stairs_of(above, "95 %").baseline, 0.8e3 * torques * [1, 0, 1]),
            (stairs_of(below, "power").values, powers),
            (points_of(line_of(above, "mean torque"))[:, 1], [6, 6]),
        ],
    )


def film(_sources: Sources) -> Drawn:
    """Hertz's pressure, and a film that grows outside of its ellipse."""
    a, b, peak, central = 0.13e-3, 0.71e-3, 1.7e9, 0.31e-6  # m, m, Pa, m
    x, y = np.linspace(-2.3 * a, 1.7 * a, 41), np.linspace(0.02 * b, 1.8 * b, 19)
    outside = (x[:, None] / a) ** 2 + (y[None, :] / b) ** 2
    known: Any = SimpleNamespace(
        x=x,
        y=y,
        contact=SimpleNamespace(semi_axes=(a, b), peak_pressure=peak),
        pressure=peak * np.sqrt(np.clip(1 - outside, 0, None)),
        film=central * (1 + outside),
        central_film=SimpleNamespace(value=central),
        minimum_film=SimpleNamespace(value=0.19e-6),
    )
    figure = film_figure(known)
    lines = {str(line.get_label()): points_of(line) for panel in figure.axes for line in panel.get_lines()}
    hertz = lines["Hertz's pressure"]
    return Drawn(
        figure,
        [
            (hertz[:, 0] ** 2 + (hertz[:, 1] / (1e-9 * peak)) ** 2, np.ones(len(hertz))),
            (lines["film"], np.column_stack([x / a, 1e6 * known.film[:, 0]])),
            (lines["pressure"], np.column_stack([x / a, 1e-9 * known.pressure[:, 0]])),
        ],
    )


def swept(**axes: list[float]) -> xarray.Dataset:
    shape = tuple(len(values) for values in axes.values())
    notes = {"units": "N m", "long_name": "friction torque"}
    values = 0.01 + np.arange(np.prod(shape)).reshape(shape) / 1e3
    scene = {"bearing": {"name": "6205"}, "lubricant": {"name": "ISO VG 68", "temperature": 333.15}}
    units = {"axial_load": "N", "inner_speed": "rad/s"}
    found = xarray.Dataset(
        {"torque_total": (tuple(axes), values, notes)},
        {name: (name, each, {"units": units[name]}) for name, each in axes.items()},
    )
    return found.assign_attrs(first_scene=json.dumps(scene))


def sweep_map(_sources: Sources) -> Drawn:
    dataset = swept(axial_load=[100.0, 300.0, 900.0, 500.0], inner_speed=[50.0, 90.0, 500.0])
    figure = map_figure(dataset, "torque_total")
    (mesh,) = (part for part in figure.axes[0].collections if type(part).__name__ == "QuadMesh")
    expected = 1e3 * dataset["torque_total"].sortby("axial_load").values
    return Drawn(figure, [(np.asarray(mesh.get_array()).reshape(4, 3), expected)])


def sweep_lines(_sources: Sources) -> Drawn:
    dataset = swept(inner_speed=[10.0, 30.0, 90.0, 300.0], axial_load=[300.0, 500.0])
    figure = map_figure(dataset, "torque_total")
    (panel,) = figure.axes
    values = 1e3 * dataset["torque_total"].values
    title = "friction torque\n6205, ISO VG 68, 60 degC"
    return Drawn(
        figure,
        [
            ([np.asarray(line.get_ydata()) for line in panel.lines], values.T),
            ((panel.get_xscale(), panel.get_yscale()), ("log", "log")),
            (figure.get_suptitle(), title),
        ],
    )


FIGURES: dict[Callable[[Sources], Drawn], Callable[..., Any]] = {
    over_a_decade: torque_figure,
    below_a_decade: torque_figure,
    point_by_point: torque_figure,
    one_point: torque_figure,
    without_interval: torque_figure,
    several_scenes: compared_figure,
    several_points: compared_figure,
    report_torque: torque_plot,
    friction: friction_plot,
    approach: approach_plot,
    convergence: convergence_plot,
    pressure: pressure_plot,
    ring: ring_plot,
    interval: prediction_plot,
    measured: measured_plot,
    cage: cage_plot,
    duty: duty_figure,
    film: film_figure,
    sweep_map: map_figure,
    sweep_lines: map_figure,
}


def unnamed_axes(figure: Figure) -> Iterator[str]:
    """Axes with numbers at their ticks whose label has no unit, and that do not stand beside one that has."""
    for panel in (each for each in figure.axes if each.axison and each.name != "polar"):
        beside = {axis: any(getattr(each, f"get_{axis}label")() for each in figure.axes) for axis in ("x", "y")}
        for axis in (panel.xaxis, panel.yaxis):
            label = axis.get_label_text().replace("\n", " ")
            ticks = [text.get_text() for text in axis.get_ticklabels() if text.get_visible()]
            is_of_numbers = any(re.fullmatch(r"[\d.,\N{MINUS SIGN}]+", tick) for tick in ticks)
            named = UNIT.search(label) or label in NUMBERS or (not label and beside[axis.axis_name])
            if is_of_numbers and not named:
                yield f"{axis.axis_name} of {panel.get_title()!r}: {label!r}"


@pytest.mark.parametrize("draw", FIGURES, ids=lambda draw: draw.__name__)
def test_a_figure_has_units_draws_its_numbers_and_is_legible(
    draw: Callable[[Sources], Drawn], sources: Sources
) -> None:
    figure, claims = draw(sources)
    for drawn, expected in claims:
        if isinstance(expected, str | bool | int) or isinstance(next(iter(expected), None), str):
            assert drawn == expected
        else:
            np.testing.assert_allclose(np.asarray(drawn, float), np.asarray(expected, float), rtol=1e-9, atol=1e-9)
    require_legible(figure)
    assert [*unnamed_axes(figure)] == []


def test_every_figure_is_in_the_table() -> None:
    modules = [contact_figure, film_figures]
    for package in (analytic.figures, fembearing.report.figures):
        modules += [import_module(f"{package.__name__}.{each.name}") for each in pkgutil.iter_modules(package.__path__)]
    found = {
        name
        for module in modules
        for name, each in vars(module).items()
        if inspect.isfunction(each) and each.__module__ == module.__name__ and not name.startswith("_")
        if "Figure" in str(inspect.signature(each).return_annotation)
    }
    assert found - TESTED_APART - PARTS == {function.__name__ for function in FIGURES.values()}
