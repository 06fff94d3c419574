"""The cost figure by the points that are drawn, and its table, against ladders made by hand."""

import csv
import warnings
from dataclasses import replace
from io import StringIO

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.check.cost.ladder import Ladder, Method, with_choices
from fembearing.report.figures.cost import LEAST, MOST, cost_figures, cost_table
from fembearing.report.phrases import choices_line
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import require_legible

GIB = 2**30


def method(
    name: str, *, error: float | None, seconds: float | None, bound: float | None = None, gib: float = 0
) -> Method:
    memory = int(gib * GIB) or None
    known = max((part for part in (bound, error) if part is not None), default=None)
    return Method(
        name=name,
        error=error,
        bound=bound,
        known_error=known,
        seconds=seconds,
        spread=None,
        repeats=2,
        memory=memory,
    )


CONTACT = with_choices(
    Ladder(
        quantity="the contact",
        reference="the finest",
        methods=(
            method("Hertz", error=0.031, bound=0.036, seconds=2e-6, gib=0.25),
            method("finite elements, level 2", error=0.007, seconds=0.4, gib=0.5),
            Method(
                name="finite elements, level 3",
                error=None,
                seconds=None,
                spread=None,
                repeats=0,
                memory=None,
                failed="no room",
            ),
            method("finite elements, level 4", error=None, bound=2e-4, seconds=3.5, gib=0.75),
        ),
    )
)
LOAD = Ladder(
    quantity="the load",
    reference="the ring",
    methods=(method("thrust", error=0.9, bound=None, seconds=1e-3, gib=0.25),),
)
ABSENT = Ladder(quantity="roughness", reference="none", methods=(), absent="no surface")


def drawn(axes: Axes) -> list[tuple[list[float], list[float]]]:
    """Points of all lines but that of the tolerance."""
    return [
        (np.asarray(line.get_xdata(), dtype=float).tolist(), np.asarray(line.get_ydata(), dtype=float).tolist())
        for line in axes.get_lines()
        if line.get_label() != "tolerance"
    ]


@pytest.fixture(scope="module")
def figure() -> Figure:
    (found,) = cost_figures([CONTACT, ABSENT, LOAD], tolerance=0.04)
    return found


def test_each_quantity_has_a_panel_over_time_and_all_share_one_over_memory(figure: Figure) -> None:
    time, load, memory = figure.axes
    assert [axes.get_title() for axes in figure.axes] == ["The contact", "The load", "Memory"]
    assert (time.get_xscale(), time.get_yscale(), time.get_xlabel()) == ("log", "log", "time, s")
    assert time.get_ylabel() == "error, %"
    assert time.get_ylim() == memory.get_ylim()
    legend = present(memory.get_legend())
    assert [text.get_text() for text in legend.get_texts()] == ["tolerance", "the contact", "the load"]
    assert memory.get_xlabel() == "memory, GiB"
    assert time.get_xlim() == load.get_xlim()  # one scale for all quantities
    assert time.get_ylim()[0] < LEAST


def test_points_bars_and_the_reference_are_drawn_in_per_cent(figure: Figure) -> None:
    hertz, meshes, bar, reference = drawn(figure.axes[0])
    np.testing.assert_allclose(hertz, ([2e-6], [3.1]), rtol=1e-12)  # no line joins it to the meshes
    np.testing.assert_allclose(meshes, ([0.4], [0.7]), rtol=1e-12)
    np.testing.assert_allclose(bar, ([2e-6, 2e-6], [3.1, 3.6]), rtol=1e-12)  # up to its bound
    np.testing.assert_allclose(reference, ([3.5], [0.02]), rtol=1e-12)  # at its own bound
    np.testing.assert_allclose(drawn(figure.axes[2])[0], ([0.25], [3.1]), rtol=1e-12)
    np.testing.assert_allclose(drawn(figure.axes[2])[1], ([0.5], [0.7]), rtol=1e-12)
    (limit,) = (line for line in figure.axes[0].get_lines() if line.get_label() == "tolerance")
    np.testing.assert_allclose(np.asarray(limit.get_ydata(), dtype=float), 4, rtol=1e-12)


def test_every_method_that_answered_has_a_number_beside_it_and_its_name_below(figure: Figure) -> None:
    panel = figure.axes[0]
    numbers = {text.get_text(): text.xy for text in panel.texts if text.get_text().isdigit()}  # pyright: ignore[reportAttributeAccessIssue]
    assert numbers.keys() == {"1", "2", "4"}  # the third failed
    np.testing.assert_allclose(numbers["1"], (2e-6, 3.1), rtol=1e-12)
    np.testing.assert_allclose(numbers["4"], (3.5, 0.02), rtol=1e-12)
    key = present(panel.get_legend())
    assert [text.get_text() for text in key.get_texts()] == ["1 Hertz", "2 FE, level 2", "4 FE, level 4"]
    figure.draw_without_rendering()
    below = key.get_window_extent()
    assert below.y1 < panel.get_window_extent().y0  # under the panel, and within the picture
    assert below.y0 > figure.bbox.y0
    require_legible(figure)


def test_a_ring_marks_the_chosen_method() -> None:
    plain = method("a", error=0.01, seconds=0.1)
    chosen = replace(plain, chosen=True)
    counts = [
        len(drawn(cost_figures([Ladder(quantity="q", reference="r", methods=(one,))], tolerance=0.1)[0].axes[0]))
        for one in (plain, chosen)
    ]
    assert counts[1] == counts[0] + 1


def test_only_levels_of_one_method_are_joined_and_four_panels_share_a_figure() -> None:
    names = ("Hertz", "mesh, level 1", "mesh, level 2", "closed form", "mesh, level 3")
    ladder = Ladder(
        quantity="q",
        reference="r",
        methods=tuple(method(name, error=0.1 / (n + 2), seconds=10.0 ** (n - 4)) for n, name in enumerate(names)),
    )
    figures = cost_figures([*5 * [ladder]], tolerance=0.1)
    assert [len(figure.axes) for figure in figures] == [4, 1]
    require_legible(figures[0])
    first, meshes, closed = drawn(figures[1].axes[0])
    assert (len(first[0]), len(closed[0])) == (1, 1)
    np.testing.assert_allclose(meshes[0], [1e-3, 1e-2, 1.0])


def test_without_memory_there_is_no_panel_for_it() -> None:
    bare = Ladder(quantity="q", reference="r", methods=(method("a", error=0.01, seconds=0.1),))
    assert len(cost_figures([bare], tolerance=0.1)[0].axes) == 1


def test_a_method_without_a_price_or_an_error_is_not_drawn() -> None:
    unknown = method("b", error=None, seconds=0.2)
    unpriced = method("c", error=0.3, seconds=None)
    ladder = Ladder(quantity="q", reference="r", methods=(method("a", error=0.01, seconds=0.1), unknown, unpriced))
    (panel,) = cost_figures([ladder], tolerance=0.1)[0].axes
    assert ([0.1], [1.0]) in drawn(panel)
    assert all(x == [0.1] for x, y in drawn(panel) if 0 < len(x) == len(y))


@pytest.mark.parametrize("tolerance", [1e-308, 0.04, 1e190])
def test_the_scale_of_errors_does_not_depend_on_the_tolerance(tolerance: float) -> None:
    """A damaged report can have any; Matplotlib warns where an axis has no width."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (figure,) = cost_figures([CONTACT, LOAD], tolerance=tolerance)
    assert {panel.get_ylim() for panel in figure.axes} == {(LEAST / 3, MOST)}


def test_the_table_holds_every_method_and_what_is_absent() -> None:
    hertz, second, failed, finest, absent = csv.DictReader(StringIO(cost_table([CONTACT, ABSENT])))
    assert (hertz["name"], float(hertz["error"]), float(hertz["bound"])) == ("Hertz", 0.031, 0.036)
    assert int(second["memory"]) == GIB // 2
    assert (failed["failed"], failed["error"]) == ("no room", "")
    assert finest["reference"] == "the finest"
    assert (absent["quantity"], absent["reference"]) == ("roughness", "absent: no surface")


def test_the_price_of_a_digit_in_words() -> None:
    assert choices_line(CONTACT) == (
        "10 %: Hertz, 2e-06 s; 1 %: FE, level 2, 0.4 s, 2e+05 times as much; "
        "0.1 %: FE, level 4, 3.5 s, 8.8 times as much; 0.01 %: none"
    )


def test_times_and_memories_are_inside_their_axes_with_room(figure: Figure) -> None:
    for panel in figure.axes[:2]:
        low, high = panel.get_xlim()
        assert low == pytest.approx(2e-6 / 5, rel=1e-9)
        assert high == pytest.approx(3.5 * 5, rel=1e-9)
    low, high = figure.axes[2].get_xlim()
    assert low == 0
    assert 0.75 < high < 1  # GiB, of the most
    assert figure.axes[2].get_xscale() == "linear"


def test_panels_fill_rows_of_at_most_four_and_the_left_ones_name_the_error() -> None:
    ladder = Ladder(quantity="q", reference="r", methods=(method("a", error=0.01, seconds=0.1),))
    heights = {}
    for count, columns, rows in ((1, 1, 1), (3, 3, 1), (4, 4, 1), (5, 3, 2), (9, 3, 3)):
        (found,) = cost_figures(count * [ladder], tolerance=0.1, most=count)
        places = [present(panel.get_subplotspec()) for panel in found.axes]
        assert [(place.rowspan.start, place.colspan.start) for place in places] == [
            divmod(number, columns) for number in range(count)
        ]
        assert [bool(panel.get_ylabel()) for panel in found.axes] == [not number % columns for number in range(count)]
        heights[rows] = found.get_figheight()
    assert heights[2] == pytest.approx(2 * heights[1], rel=1e-9)
    assert heights[3] == pytest.approx(3 * heights[1], rel=1e-9)


def test_an_error_off_the_scale_stands_at_its_end() -> None:
    methods = (
        method("a", error=1e-8, seconds=0.1),
        method("b", error=9.0, seconds=0.2),
        method("c", error=0.02, bound=77.0, seconds=0.3),
    )
    (panel,) = cost_figures([Ladder(quantity="q", reference="r", methods=methods)], tolerance=0.1)[0].axes
    points = drawn(panel)
    assert ([0.1], [LEAST]) in points
    assert ([0.2], [MOST]) in points
    assert ([0.3, 0.3], [2.0, MOST]) in points
