"""What all figures share: scales and their ticks, and contacts side by side."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from fembearing.quantities import METRIC
from fembearing.report.figures.style import BLACK, BLUE, LETTERS, TITLE, contact_columns, look_of, plain_numbers, scaled


def panel_of(*values: float) -> Axes:
    panel = Figure().subplots()
    panel.plot(values, values)
    return panel


@pytest.mark.parametrize(
    ("values", "scale"),
    [
        ((2.0, 19.9), "linear"),
        ((2.0, 20.0), "log"),
        ((2.0, 20.1, np.nan), "log"),
        ((0.0, 700.0), "linear"),
        ((-2.0, 700.0), "linear"),
        ((np.nan, np.inf), "linear"),
    ],
)
@pytest.mark.parametrize("axis", ["x", "y"])
def test_values_above_0_over_a_decade_are_on_a_logarithmic_scale(
    values: tuple[float, ...], scale: str, axis: str
) -> None:
    panel = panel_of(1.0, 3.0)
    scaled(panel, np.array(values), axis=axis)
    found = {"x": panel.get_xscale(), "y": panel.get_yscale()}
    assert found == {"x": "linear", "y": "linear"} | {axis: scale}


def test_numbers_of_a_scale_below_four_decades_are_written_out() -> None:
    for most, plain in ((9e3, True), (1.1e4, False)):
        panel = panel_of(1.0, most)
        scaled(panel, np.array([1.0, most]))
        words = panel.yaxis.get_major_formatter()(1000.0)
        assert (words == "1000") == plain


def test_a_short_scale_has_ticks_between_its_powers_of_ten() -> None:
    for high, ticks in ((14.0, [1, 2, 5, 10]), (16.0, [1, 3, 10]), (99.0, [1, 3, 10, 30]), (101.0, [1, 10, 100])):
        panel = panel_of(1.0, high)
        panel.set(yscale="log", ylim=(1.0, high))
        plain_numbers(panel.yaxis)
        shown = [tick for tick in panel.get_yticks() if 1 <= tick <= high]
        np.testing.assert_allclose(shown, ticks, rtol=1e-9)


def test_an_unknown_contact_is_black() -> None:
    assert look_of("inner", "real") == (BLUE, "o")
    assert look_of("inner", "hertzian")[0] == BLACK


@pytest.mark.parametrize("shared", [True, False])
def test_contacts_have_two_panels_each_with_names_at_the_left(shared: bool) -> None:
    """Five contacts in two rows of three; the upper panel is higher than the lower one."""
    drawn: list[tuple[str, int]] = []

    def draw(place: str) -> Any:
        def each(panel: Axes, contact: Any, _: Any) -> None:
            drawn.append((place, contact.number))
            panel.plot([0, contact.number], [0, 1], label=place)
            panel.set_title("a title")

        return each

    contacts: Any = [SimpleNamespace(number=number) for number in range(1, 6)]
    figure = contact_columns(contacts, draw("above"), draw("below"), units=METRIC, labels=("up", "down"), shared=shared)
    assert drawn == [(place, number) for number in range(1, 6) for place in ("above", "below")]
    panels = figure.axes
    assert [panel.get_ylabel() for panel in panels] == [
        word for number in range(5) for word in (("up", "down") if number % 3 == 0 else ("", ""))
    ]
    for above, below in zip(panels[::2], panels[1::2], strict=True):
        assert above.get_shared_x_axes().joined(above, below) == shared
    assert not panels[0].get_shared_x_axes().joined(panels[0], panels[2])
    figure.draw_without_rendering()
    heights = [panel.get_position().height for panel in panels[:2]]
    assert 1.2 < heights[0] / heights[1] < 1.5
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["above"]
    two = contact_columns(contacts[:2], draw("above"), draw("below"), units=METRIC, labels=("up", "down"))
    assert 1.7 < (figure.get_figheight() - 0.3) / (two.get_figheight() - 0.3) < 2.3  # a row of contacts each
    assert panels[0].title.get_fontsize() == TITLE > LETTERS == panels[0].yaxis.label.get_fontsize()
