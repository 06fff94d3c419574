"""Torque and friction over the operating points, by the numbers that are drawn of a document made by hand."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle

from fembearing.quantities import INCH_POUND, METRIC, Units
from fembearing.report.figures.friction import friction_plot
from fembearing.report.figures.torque import torque_plot
from tests.analytic.specimens import present
from tests.report.figures import figure_reader
from tests.report.figures.figure_reader import area_of, bars_of, labels_of, line_of, points_of, require_legible

RPM = np.pi / 30
PARTS = ("spin", "conformity", "hysteresis", "rolling", "cage", "oil", "declared")
SPEEDS = (500.0, 100.0, 300.0)  # rpm, in no order
TORQUES = {  # N mm, at those speeds; the cage was left out
    "spin": (7.8, 7.6, 7.7),
    "conformity": (4.9, 4.6, 4.75),
    "hysteresis": (2.5, 2.4, 2.45),
    "rolling": (20.1, 6.2, 13.3),
    "cage": None,
    "oil": (1.1, 0.2, 0.7),
    "declared": (5.0, 5.0, 5.0),
}
TOTALS = np.array([41.4, 26.0, 33.9])
GAP = 0.14e-6  # m
Document = dict[str, Any]  # keys of a document, which a test may change


def as_document(content: Document, units: Units = METRIC, makers: dict[str, Any] | None = None) -> Any:
    """The document with what stands beside the torque: no interval, and the makers' values, if the test gives none."""
    document = figure_reader.as_document(content, units)
    if document.torque is not None:
        document.torque.left_out = []
        document.torque.interval = getattr(document.torque, "interval", [None] * len(document.torque.points))
        document.torque.catalogue_band = SimpleNamespace(values=makers or {})
    return document


def point(number: int, *, speed: float, load: float = 1000.0, radial: float = 0.0) -> dict[str, Any]:
    torque = {name: None if values is None else 1e-3 * values[number] for name, values in TORQUES.items()}
    return {
        "inner_speed": speed * RPM,
        "axial_load": load,
        "radial_load": radial,
        "moment": 0.0,
        "torque": torque | {"total": 1e-3 * TOTALS[number], "race": None},
        "uncertainty": {"numerical": (0.02, 0.01, 0.015)[number], "model": (0.03, 0.04, 0.035)[number]},
        "friction_coefficient": {
            "inner": (0.034, 0.036, 0.035)[number],
            "outer": (0.031, 0.033, 0.032)[number],
            "pocket": None,
        },
        "film": {"inner": (0.28e-6, 0.021e-6, 0.07e-6)[number], "outer": (0.3e-6, 0.028e-6, 0.09e-6)[number]},
        "asperity_share": {"inner": (0.13, 0.15, 0.14)[number], "outer": (0.12, 0.16, 0.135)[number]},
    }


@pytest.fixture
def document() -> Document:
    points = [point(number, speed=speed) for number, speed in enumerate(SPEEDS)]
    return {
        "torque": {"points": points, "gap_roughness": GAP},
        "cage_records": [],
    }


def test_a_cage_that_moved_is_said_to_be_in_the_total(document: Document) -> None:
    assert "its motion" not in torque_plot(as_document(document))[1]
    assert "The part of the cage includes its motion." in torque_plot(as_document(document | {"cage_records": [{}]}))[1]


def panel_of(found: tuple[Figure | None, str]) -> Axes:
    figure, _ = found
    return present(figure).axes[0]


def test_the_parts_are_stacked_up_to_the_total_in_order_of_speed(document: Document) -> None:
    panel = panel_of(torque_plot(as_document(document)))
    order = np.argsort(SPEEDS)
    below = np.zeros(3)
    for name, words in (
        ("spin", "spin"),
        ("conformity", "conformity slip"),
        ("hysteresis", "hysteresis"),
        ("rolling", "rolling against the oil"),
        ("oil", "oil outside the contacts"),
        ("declared", "declared: seals, drag"),
    ):
        x, low, high = area_of(panel, words)
        np.testing.assert_allclose(x, [100, 300, 500], rtol=1e-12)
        np.testing.assert_allclose(low, below, atol=1e-9)
        np.testing.assert_allclose(high - low, np.array(TORQUES[name])[order], rtol=1e-9)  # differences of near values
        below = high
    total = points_of(line_of(panel, "total"))
    np.testing.assert_allclose(total, np.column_stack([[100, 300, 500], TOTALS[order]]), rtol=1e-12)
    np.testing.assert_allclose(below, total[:, 1], rtol=1e-9)
    assert "cage" not in labels_of(panel)  # left out
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("inner speed, rpm", "friction torque, N mm")
    assert panel.get_ylim()[0] == 0


def test_the_band_holds_both_uncertainties(document: Document) -> None:
    found = torque_plot(as_document(document))
    panel = panel_of(found)
    low, high = (line for line in panel.get_lines() if line.get_linestyle() == "--")
    np.testing.assert_allclose(
        points_of(high)[:, 1], np.array([26.0, 33.9, 41.4]) * (1 + np.array([0.05, 0.05, 0.05])), rtol=1e-9
    )
    np.testing.assert_allclose(points_of(low)[:, 1], np.array([26.0, 33.9, 41.4]) * 0.95, rtol=1e-9)
    assert "numerical and of the model's formulas at 95 %" in found[1]
    for each in document["torque"]["points"]:
        each["uncertainty"] = {"numerical": None, "model": None}
    found = torque_plot(as_document(document))
    assert "its uncertainty, not known" in found[1]


def test_the_interval_takes_the_place_of_the_uncertainty_and_makers_stand_beside(document: Document) -> None:
    """In the order of the speeds; a maker with two constants is one band, where one of them holds."""
    document["torque"]["interval"] = [[0.031, 0.058], [0.017, 0.039], None]
    makers = {
        "SKF": [0.044, 0.029, 0.037],
        "Palmgren, z = 0.0004": [0.033, 0.024, 0.028],
        "Palmgren, z = 0.0006": [0.047, 0.031, 0.039],
        "ISO 15312": [None, None, None],
    }
    figure, caption = torque_plot(as_document(document, makers=makers))
    panel = present(figure).axes[0]
    low, high = (line for line in panel.get_lines() if line.get_linestyle() == "--")
    np.testing.assert_allclose(points_of(low)[:, 1], [17, np.nan, 31], rtol=1e-12)
    np.testing.assert_allclose(points_of(high)[:, 1], [39, np.nan, 58], rtol=1e-12)
    np.testing.assert_allclose(points_of(line_of(panel, "SKF"))[:, 1], [29, 37, 44], rtol=1e-12)
    edges = [line for line in panel.get_lines() if line.get_linestyle() == ":"]
    np.testing.assert_allclose([points_of(edge)[:, 1] for edge in edges], [[31, 39, 47], [24, 28, 33]], rtol=1e-12)
    legend = [text.get_text() for text in present(figure).legends[0].get_texts()]
    assert legend[-4:] == ["95 % interval", "total", "SKF", "Palmgren"]
    assert "Red: SKF, Palmgren" in caption
    assert "its 95 % interval" in caption
    require_legible(present(figure))


def test_points_that_no_line_joins_have_bars_of_their_interval_with_the_makers_beside(document: Document) -> None:
    document["torque"]["points"][0]["axial_load"] = 700.0  # speed and load change
    document["torque"]["interval"] = [[0.031, 0.058], [0.017, 0.039], [0.035, 0.046]]  # the last lies above its total
    makers = {"SKF": [0.044, 0.029, 0.037], "Palmgren, z = 0.0004": [0.033, 0.024, 0.028]}
    panel = panel_of(torque_plot(as_document(document, makers=makers)))
    ends = bars_of(panel, "total, 95 % interval")
    np.testing.assert_allclose(ends, [(31, 58), (17, 39), (33.9, 46)], rtol=1e-12)
    spin = [patch for patch in panel.patches if isinstance(patch, Rectangle)][:3]
    assert [bar.get_height() for bar in spin] == pytest.approx([7.8, 7.6, 7.7], rel=1e-12)
    skf = points_of(line_of(panel, "SKF"))
    np.testing.assert_allclose(skf[:, 1], [44, 29, 37], rtol=1e-12)
    right = [bar.get_x() + bar.get_width() for bar in spin]
    assert np.all((skf[:, 0] > right) & (skf[:, 0] < np.array(right) + 0.2))  # beside the bar, not on the next one


def test_a_series_of_loads_is_drawn_over_the_load_and_a_mixed_one_point_by_point(document: Document) -> None:
    loads = (900.0, 300.0, 600.0)
    document["torque"]["points"] = [point(number, speed=200.0, load=load) for number, load in enumerate(loads)]
    panel = panel_of(torque_plot(as_document(document)))
    total = points_of(line_of(panel, "total"))
    np.testing.assert_allclose(total, [(300, 26.0), (600, 33.9), (900, 41.4)], rtol=1e-12)
    assert panel.get_xlabel() == "axial load, N"
    document["torque"]["points"][2]["inner_speed"] = 250 * RPM
    panel = panel_of(torque_plot(as_document(document)))
    assert panel.get_xlabel() == "operating point"
    bars = [patch for patch in panel.patches if isinstance(patch, Rectangle)]
    tops = [max(bar.get_y() + bar.get_height() for bar in bars if round(bar.get_x() + 0.3) == at) for at in range(3)]
    np.testing.assert_allclose(tops, TOTALS, rtol=1e-9)
    assert [text.get_text() for text in panel.get_xticklabels()] == [
        "200 rpm, 900 N axial",
        "200 rpm, 300 N axial",
        "250 rpm, 600 N axial",
    ]


def test_a_series_of_radial_loads_is_drawn_over_them_and_named_at_the_ticks(document: Document) -> None:
    radial = (3000.0, 1000.0, 2000.0)
    points = [point(number, speed=200.0, load=0.0, radial=load) for number, load in enumerate(radial)]
    document["torque"]["points"] = points
    panel = panel_of(torque_plot(as_document(document)))
    np.testing.assert_allclose(points_of(line_of(panel, "total"))[:, 0], [1000, 2000, 3000], rtol=1e-12)
    assert panel.get_xlabel() == "radial load, N"
    points[2]["inner_speed"] = 250 * RPM
    panel = panel_of(torque_plot(as_document(document)))
    assert panel.get_xticklabels()[0].get_text() == "200 rpm, 3000 N radial"


def test_speeds_over_more_than_a_decade_are_on_a_logarithmic_scale(document: Document) -> None:
    assert panel_of(torque_plot(as_document(document))).get_xscale() == "linear"
    document["torque"]["points"][0]["inner_speed"] = 1500 * RPM
    assert panel_of(torque_plot(as_document(document))).get_xscale() == "log"


def test_coefficients_film_over_roughness_and_asperities_have_a_panel_each(document: Document) -> None:
    figure, caption = friction_plot(as_document(document))
    assert figure is not None
    friction, film, asperities = figure.axes
    inner = points_of(line_of(friction, "inner"))
    np.testing.assert_allclose(inner, [(100, 0.036), (300, 0.035), (500, 0.034)], rtol=1e-12)
    outer = points_of(line_of(film, "outer"))
    np.testing.assert_allclose(outer, [(100, 0.2), (300, 9 / 14), (500, 15 / 7)], rtol=1e-12)  # over 0.14 um
    shares = points_of(line_of(asperities, "outer"))
    np.testing.assert_allclose(shares, [(100, 16), (300, 13.5), (500, 12)], rtol=1e-12)
    assert [axes.get_ylabel() for axes in figure.axes] == [
        "friction coefficient",
        "film over roughness",
        "load on asperities, %",
    ]
    legend = [text.get_text() for text in figure.legends[0].get_texts()]
    assert (friction.get_yscale(), film.get_yscale()) == ("linear", "log")  # 0.15 to 2.1 crosses a decade
    assert legend[:2] == ["inner", "outer"]
    assert "pocket" not in legend
    assert "pocket" not in caption
    assert "No film" not in caption
    require_legible(figure)


def test_a_film_alone_is_not_said_to_be_none(document: Document) -> None:
    for each in document["torque"]["points"]:
        each["asperity_share"] = {"inner": None, "outer": None}
    figure, caption = friction_plot(as_document(document))
    assert [axes.get_title() for axes in present(figure).axes] == ["Friction", "Film"]
    assert "No film" not in caption
    assert "Film: central thickness" in caption


def test_many_points_that_no_line_joins_keep_their_marks(document: Document) -> None:
    points = document["torque"]["points"]
    document["torque"]["points"] = 10 * points  # speeds come again and again
    figure = present(friction_plot(as_document(document))[0])
    inner = line_of(figure.axes[0], "inner")
    assert (inner.get_marker(), inner.get_linestyle()) == ("o", "None")
    document["torque"]["points"] = [points[0] | {"inner_speed": 1.0 + number} for number in range(30)]
    figure, _ = friction_plot(as_document(document))
    inner = line_of(present(figure).axes[0], "inner")
    assert (inner.get_marker(), inner.get_linestyle()) == ("None", "-")


def test_a_given_coefficient_has_no_film(document: Document) -> None:
    document["torque"]["gap_roughness"] = None
    for each in document["torque"]["points"]:
        each["film"] = each["asperity_share"] = {"inner": None, "outer": None}
        each["friction_coefficient"] = {"inner": 0.1, "outer": 0.1, "pocket": 0.07}
    figure, caption = friction_plot(as_document(document))
    assert [text.get_text() for text in present(figure).legends[0].get_texts()] == ["inner", "outer", "pocket"]
    assert "No film: the scene gives a constant coefficient" in caption
    for each in document["torque"]["points"]:
        each["friction_coefficient"] = dict.fromkeys(("inner", "outer", "pocket"))
    assert friction_plot(as_document(document)) == (
        None,
        "No friction coefficient: no sliding was computed.",
    )


@pytest.mark.parametrize("draw", [torque_plot, friction_plot])
def test_one_point_has_no_figure(document: Document, draw: Any) -> None:
    document["torque"]["points"] = document["torque"]["points"][:1]
    assert draw(as_document(document)) == (None, "")


def test_inch_and_pound_are_on_both_axes(document: Document) -> None:
    """900, 300 and 600 N are 202.3, 67.4 and 134.9 lbf; 1 lbf in is 112.98 N mm."""
    loads = (900.0, 300.0, 600.0)
    document["torque"]["points"] = [point(number, speed=200.0, load=load) for number, load in enumerate(loads)]
    panel = panel_of(torque_plot(as_document(document, INCH_POUND)))
    total = points_of(line_of(panel, "total"))
    np.testing.assert_allclose(total[:, 0], np.array([300, 600, 900]) / 4.4482216152605, rtol=1e-12)
    np.testing.assert_allclose(total[:, 1], np.array([26.0, 33.9, 41.4]) / (4.4482216152605 * 25.4), rtol=1e-12)
    assert (panel.get_xlabel(), panel.get_ylabel()) == ("axial load, lbf", "friction torque, lbf in")


@pytest.mark.parametrize("draw", [torque_plot, friction_plot])
def test_without_a_torque_there_is_a_reason_in_place_of_a_figure(draw: Any) -> None:
    figure, why = draw(as_document({"torque": None}))
    assert figure is None
    assert "neither a friction coefficient nor both lubricant and surface" in why


def test_the_film_from_which_summits_part_is_a_line_where_it_is_in_sight(document: Document) -> None:
    """Film over roughness: up to 2.14 in the document, on a scale that ends above 3 only with thicker films."""
    for thickest, drawn in ((0.3e-6, False), (0.9e-6, True)):
        document["torque"]["points"][0]["film"]["outer"] = thickest
        figure = present(friction_plot(as_document(document))[0])
        lines = [line for line in figure.axes[1].get_lines() if line.get_label() == "summits part, about"]
        assert len(lines) == drawn
        for line in lines:
            assert np.asarray(line.get_ydata()).tolist() == [3, 3]
        assert not any(line.get_label() == "summits part, about" for line in figure.axes[0].get_lines())


def test_a_linear_scale_begins_at_0_and_has_room_above(document: Document) -> None:
    friction, _, shares = present(friction_plot(as_document(document))[0]).axes
    assert friction.get_ylim() == pytest.approx((0, 1.15 * 0.036), rel=1e-9)
    assert shares.get_ylim() == pytest.approx((0, 1.15 * 16), rel=1e-9)


def test_the_figure_of_coefficients_alone_says_that_there_is_no_film(document: Document) -> None:
    for lacking, words in (({"gap_roughness": None}, "Asperities: share"), ({}, "Film: central thickness")):
        changed = {"torque": document["torque"] | lacking, "cage_records": []}
        figure, caption = friction_plot(as_document(changed))
        assert words in caption
        assert len(present(figure).axes) == (2 if lacking else 3)
