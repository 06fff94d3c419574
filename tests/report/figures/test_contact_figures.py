"""Plots of the contacts by the points that are drawn, against a result made by hand: see `made` in conftest.py."""

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.container import ErrorbarContainer
from matplotlib.lines import Line2D

from fembearing.check.contact.solution import ContactNumbers, ContactSolution
from fembearing.check.validation import Validation
from fembearing.quantities import METRIC
from fembearing.report.figures.approach import approach_plot
from fembearing.report.figures.convergence import convergence_plot
from fembearing.report.figures.pressure import pressure_plot
from fembearing.report.figures.style import BLACK
from fembearing.report.report import Report, report_of
from tests.analytic.specimens import present
from tests.report.conftest import INNER
from tests.report.figures.figure_reader import labels_of, line_of, points_of, require_legible

PLACES = ("inner race", "outer race", "thick seat", "sheet on its rim")


def report_with(*contacts: ContactNumbers) -> Report:
    """Nothing but these contacts."""
    return cast(Report, SimpleNamespace(contacts=contacts, units=METRIC))


def check_points(line: Line2D, x: list[float], y: list[float]) -> None:
    np.testing.assert_allclose(points_of(line), np.column_stack([x, y]), rtol=1e-10)  # differences of near values


def drawn_in(axes: Axes) -> list[str]:
    """Labels of the lines."""
    return [str(line.get_label()) for line in axes.get_lines()]


@pytest.fixture(scope="module")
def panels(document: Report) -> dict[str, Axes]:
    figure, _ = convergence_plot(document)
    return {axes.get_title(): axes for axes in present(figure).axes if axes.get_title()}


def test_meshes_with_an_order_are_drawn_by_their_distance_from_the_limit(panels: dict[str, Axes]) -> None:
    inner = line_of(panels["approach"], "inner race")
    # 4.4, 5.06 and 5.5 against 5.225, %
    check_points(inner, [1200, 9500, 31000], [82.5 / 5.225, 16.5 / 5.225, 27.5 / 5.225])
    assert inner.get_linestyle() == "-"
    outer = line_of(panels["peak pressure"], "outer race")
    check_points(outer, [1300, 8700, 29000], [15 / 1.6, 5 / 1.6, 2 / 1.6])


def test_meshes_without_an_order_are_drawn_by_their_distance_from_the_finest(panels: dict[str, Axes]) -> None:
    line = line_of(panels["stiffness"], "inner race")
    check_points(line, [1200, 9500], [30, 10])  # 32.5 and 27.5 against 25
    assert line.get_linestyle() == "--"


def test_the_formal_order_is_a_slope_below_all_points(panels: dict[str, Axes]) -> None:
    for name, order in (("approach", 4), ("semi-axis b", 3)):
        (first, last) = points_of(line_of(panels[name], "formal order"))
        assert [text.get_text() for text in panels[name].texts] == [f"order {order}"]
        unknowns = last[0] / first[0]
        np.testing.assert_allclose(last[1] / first[1], unknowns ** (-order / 3), rtol=1e-12)
        for place in PLACES:
            points = points_of(line_of(panels[name], place))
            slope = first[1] * (points[:, 0] / first[0]) ** (-order / 3)
            assert np.all(points[:, 1] > 2 * slope)
    assert "formal order" not in drawn_in(panels["peak pressure"])  # it has none


def test_every_axis_of_a_convergence_has_at_least_two_numbers(panels: dict[str, Axes]) -> None:
    """The axis of unknowns goes from 1000 to 51 000: of the powers of ten it has one alone."""
    for axes in panels.values():
        for low, high, ticks in ((*axes.get_xlim(), axes.get_xticks()), (*axes.get_ylim(), axes.get_yticks())):
            assert sum(low <= tick <= high for tick in ticks) >= 2


def test_every_contact_is_in_every_panel(panels: dict[str, Axes]) -> None:
    assert set(panels) == {"approach", "semi-axis a", "semi-axis b", "peak pressure", "stiffness"}
    for axes in panels.values():
        assert drawn_in(axes)[:4] == [*PLACES]
        assert (axes.get_xscale(), axes.get_yscale()) == ("log", "log")
        assert axes.get_xlabel() == "unknowns"


def test_a_cut_contact_has_no_formal_order(cut_contact: ContactSolution) -> None:
    figure, _ = convergence_plot(report_with(cut_contact.numbers))
    assert not any("formal order" in drawn_in(axes) for axes in present(figure).axes)
    require_legible(present(figure))
    assert labels_of(present(figure).axes[-1]) == ["inner race"]


def bars_of(axes: Axes) -> list[ErrorbarContainer]:
    return [each for each in axes.containers if isinstance(each, ErrorbarContainer)]


def test_approaches_are_in_micrometres_with_their_intervals(document: Report) -> None:
    figure = present(approach_plot(document)[0])
    above, below = figure.axes[:2]
    assert (above.get_xlabel(), above.get_ylabel()) == ("approach, um", "load, N")
    hertz = points_of(line_of(above, "Hertz"))
    expected = document.contacts[0].approach_curve
    np.testing.assert_allclose(hertz, np.column_stack([1e6 * np.array(expected.hertz), expected.load]))
    given = INNER["approach"]
    (bar,) = bars_of(above)
    np.testing.assert_allclose(points_of(bar.lines[0]), [(5.225, 371.5)], rtol=1e-9)  # the limit, no far boundary
    (bar,) = bars_of(below)
    (point,) = points_of(bar.lines[0])
    np.testing.assert_allclose(point, (371.5, 100 * (5.225e-6 / given.hertz - 1)), rtol=1e-9)
    (segment,) = bar.lines[2][0].get_segments()
    half = 100 * 5.225e-6 / given.hertz * np.hypot(given.mesh, given.domain)
    np.testing.assert_allclose(np.diff(segment[:, 1]), 2 * half, rtol=1e-9)
    assert len(figure.axes) == 8
    assert np.isnan(points_of(line_of(figure.axes[4], "Hertz, corrected"))[:, 0]).all()  # no fit reaches a pocket


def test_the_band_of_corrected_hertz_is_its_uncertainty_to_both_sides(document: Report) -> None:
    curve = document.contacts[0].approach_curve
    known = [number for number, approach in enumerate(curve.corrected) if approach is not None]
    half = np.linspace(0.004, 0.029, len(curve.load))
    curve = replace(curve, uncertainty=tuple(half.tolist()))
    contact = replace(document.contacts[0], approach_curve=curve)
    figure = present(approach_plot(report_with(contact))[0])
    (band,) = (each for each in figure.axes[1].collections if isinstance(each, PolyCollection))
    load, hertz, corrected = (np.array(values)[known] for values in (curve.load, curve.hertz, curve.corrected))
    (middle,) = (points_of(line) for line in figure.axes[1].get_lines() if line.get_linestyle() == "--")
    expected = np.column_stack([load, 100 * (corrected / hertz - 1).astype(float)])
    np.testing.assert_allclose(middle[known], expected, rtol=1e-9, atol=1e-9)  # %, near values
    assert len(known) > 2
    corners = np.concatenate([np.asarray(path.vertices, dtype=float) for path in band.get_paths()])
    for at, ratio, part in zip(load, (corrected / hertz).astype(float), half[known], strict=True):
        heights = corners[np.isclose(corners[:, 0], at, rtol=1e-9), 1]  # round-off
        ends = 100 * (ratio * (1 - part) - 1), 100 * (ratio * (1 + part) - 1)
        np.testing.assert_allclose((heights.min(), heights.max()), ends, rtol=1e-9, atol=1e-9)  # %, near values


def test_contacts_stand_side_by_side_in_rows_of_equal_length(document: Report) -> None:
    """At most four beside each other, each with its two panels one above the other."""
    for count, rows, columns in ((2, 1, 2), (4, 1, 4), (5, 2, 3), (9, 3, 3)):
        contacts = (3 * list(document.contacts))[:count]
        figure, _ = approach_plot(report_with(*contacts))
        places = [present(panel.get_subplotspec()) for panel in present(figure).axes]
        found = [(place.rowspan.start, place.colspan.start) for place in places]
        assert len(found) == 2 * count
        assert {row for row, _ in found} == {*range(2 * rows)}
        assert {column for _, column in found} == {*range(columns)}
        require_legible(present(figure))


def test_pressure_is_drawn_in_semi_axes_and_less_hertz(checked: Validation) -> None:
    document = report_of(checked)
    figure = present(pressure_plot(document)[0])
    for column, contact in enumerate(document.contacts):
        above, below = figure.axes[2 * column : 2 * column + 2]
        peak = contact.hertz.peak_pressure
        for axis, name, label in (
            ("rolling", "semi_axis_rolling", "rolling"),
            ("transverse", "semi_axis_transverse", "transverse"),
        ):
            nodes = getattr(contact.pressure_profile, axis).fe
            position = np.array(nodes.position) / getattr(contact.hertz, name)
            drawn = points_of(line_of(above, label))
            np.testing.assert_allclose(drawn, np.column_stack([position, 1e-9 * np.array(nodes.pressure)]))
            ellipse = np.sqrt(np.maximum(0, 1 - position**2))
            expected = 100 * (np.array(nodes.pressure) / peak - ellipse)
            (apart,) = (line for line in below.get_lines() if line.get_marker() == ("o" if axis == "rolling" else "s"))
            np.testing.assert_allclose(points_of(apart)[:, 1], expected, atol=1e-9)
            lines = [line for line in below.get_lines() if line.get_color() == apart.get_color()]
            (fitted,) = (line for line in lines if line is not apart)
            place, height = points_of(fitted).T
            ratio = getattr(contact.reference, name) / getattr(contact.hertz, name)
            ellipses = contact.reference.peak_pressure / peak * np.sqrt(np.maximum(0, 1 - (place / ratio) ** 2))
            np.testing.assert_allclose(height, 100 * (ellipses - np.sqrt(np.maximum(0, 1 - place**2))), atol=1e-5)
        line = points_of(line_of(above, "Hertz"))
        np.testing.assert_allclose(line[:, 1], 1e-9 * peak * np.sqrt(np.maximum(0, 1 - line[:, 0] ** 2)), atol=1e-7)
        # 1e-7 GPa: the root of round-off at the edge
    assert figure.axes[0].get_ylabel() == "pressure, GPa"
    assert figure.axes[0].get_title() == "Ball on inner race\n372.2 N"
    require_legible(figure)


def test_a_cut_contact_is_drawn_on_both_sides_up_to_its_shoulder(cut_contact: ContactSolution) -> None:
    figure, caption = pressure_plot(report_with(cut_contact.numbers))
    above, below = present(figure).axes
    semi_axis = cut_contact.numbers.hertz.semi_axis_transverse
    across = points_of(line_of(above, "transverse"))
    assert across[0, 0] < -0.9
    hertz = [points_of(line) for line in above.get_lines() if line.get_color() == BLACK]
    ends = [(line[:, 0].min(), line[:, 0].max()) for line in hertz]
    np.testing.assert_allclose(sorted(ends), [(-ends[1][1], 0), (0, ends[1][1])], atol=1e-12)  # one half mirrored
    assert np.all(across[across[:, 0] > 1.001 * 0.8e-3 / semi_axis, 1] == 0)  # nothing touches beyond
    (shoulder,) = (line for line in above.get_lines() if line.get_linestyle() == ":")
    np.testing.assert_allclose(np.asarray(shoulder.get_xdata(), dtype=float), 0.8e-3 / semi_axis, rtol=1e-12)
    assert above.get_ylim()[1] < 1.51e-9 * cut_contact.numbers.hertz.peak_pressure
    assert below.get_ylim()[1] < 30  # %: not that of the shoulder's node, some 200 %
    assert "Dotted: shoulder" in caption
    require_legible(present(figure))
    record = cut_contact.numbers
    half = replace(present(record.shoulder), half=False, sides={"above": 0.8e-3, "below": 0.7e-3})
    figure, _ = pressure_plot(report_with(replace(record, shoulder=half)))
    lines = present(figure).axes[0].get_lines()
    (shoulder,) = (points_of(line) for line in lines if line.get_linestyle() == ":")  # the other side is not meshed
    assert shoulder[0, 0] > 0
    assert sum(line.get_color() == BLACK for line in lines) == 1


def test_differences_beyond_nine_tenths_of_the_edge_do_not_set_the_scale(document: Report) -> None:
    """Nodes 3 % of Hertz's peak above his semi-ellipse at the centre, and 40 % above it beside the edge."""
    contact = document.contacts[0]
    axes = {}
    for axis, name in (("rolling", "semi_axis_rolling"), ("transverse", "semi_axis_transverse")):
        semi_axis, peak = getattr(contact.hertz, name), contact.hertz.peak_pressure
        share = np.array([0.0, 0.5, 0.89, 0.95])
        pressure = peak * (np.sqrt(1 - share**2) + np.array([0.03, 0.02, 0.01, 0.4]))
        profile = getattr(contact.pressure_profile, axis)
        nodes = replace(profile.fe, position=tuple(semi_axis * share), pressure=tuple(pressure))
        axes[axis] = replace(profile, fe=nodes)
    changed = replace(contact, pressure_profile=replace(contact.pressure_profile, **axes))
    _, below = present(pressure_plot(report_with(changed))[0]).axes
    assert below.get_ylim() == pytest.approx((-2.5 * 3, 2.5 * 3), rel=1e-9)
    quiet = {
        axis: replace(part, fe=replace(part.fe, pressure=tuple(contact.hertz.peak_pressure * np.sqrt(1 - share**2))))
        for axis, part in axes.items()
    }
    still = replace(contact, pressure_profile=replace(contact.pressure_profile, **quiet))
    _, below = present(pressure_plot(report_with(still))[0]).axes
    assert below.get_ylim() == pytest.approx((-1, 1), rel=1e-9)  # %: round-off is not to be seen
