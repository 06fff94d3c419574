"""Figures of what is unlike the rest: shoulders, pairs, nothing to draw, more than there is room for."""

from dataclasses import replace
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest
from matplotlib.axes import Axes

from analytic.errors import InputError
from analytic.figures.torque import MOST_NAMES, DrawnTorque, torque_figure
from analytic.units import METRIC
from fembearing.check.contact.solution import ContactSolution
from fembearing.report.figures.contacts import convergence_plot, pressure_plot
from fembearing.report.figures.measured import axis_of, measured_figure
from fembearing.report.figures.prediction import interval_figure
from fembearing.report.figures.ring import LEAST_SPAN, ring_plot
from fembearing.report.figures.torque import friction_plot, torque_plot
from fembearing.report.report import Report
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import as_document, labels_of, line_of, points_of, require_legible
from tests.report.figures.intervals import interval_of
from tests.report.specimens import comparison, row


def report_with(*contacts: Any) -> Report:
    """Nothing but these contacts."""
    return cast(Report, SimpleNamespace(contacts=contacts, units=METRIC))


def torque_drawn(count: int = 2, **columns: Any) -> DrawnTorque:
    """Points at which speed and load change, N m."""
    zero = np.zeros(count)
    known: dict[str, Any] = {"inner_speed": 30.0 + np.arange(count), "radial_load": 500.0 + np.arange(count)}
    given = {"axial_load": zero, "moment": zero, "torque_total": np.full(count, 0.02), "torque_rolling": zero + 0.02}
    every = known | given | {name: np.array(values) for name, values in columns.items()}
    return DrawnTorque(columns=every, makers={}, title="6205", units=METRIC)


def test_a_cut_contact_is_drawn_on_both_sides_up_to_its_shoulder(cut_contact: ContactSolution) -> None:
    record = cut_contact.numbers
    figure, caption = pressure_plot(report_with(record))
    for above, below in (present(figure).axes, cut_contact.plot().axes):
        across = points_of(line_of(above, "transverse"))
        shoulder = 0.8e-3 / cut_contact.numbers.hertz.semi_axis_transverse
        assert across[0, 0] < -0.9
        assert np.all(across[across[:, 0] > 1.001 * shoulder, 1] == 0)  # nothing touches beyond
        (line,) = (points_of(line) for line in above.get_lines() if line.get_linestyle() == ":")
        np.testing.assert_allclose(line[:, 0], shoulder, rtol=1e-12)
        assert above.get_ylim()[1] < 1.51e-9 * cut_contact.numbers.hertz.peak_pressure
        assert below.get_ylim()[1] < 30  # %: not that of the shoulder's node, some 200 %
    assert "Dotted: shoulder" in caption
    require_legible(present(figure))
    half = replace(present(record.shoulder), half=False, sides={"above": 0.8e-3, "below": 0.7e-3})
    figure, _ = pressure_plot(report_with(replace(record, shoulder=half)))
    lines = present(figure).axes[0].get_lines()
    (drawn,) = (points_of(line) for line in lines if line.get_linestyle() == ":")  # the other side is not meshed
    assert drawn[0, 0] > 0


def test_a_cut_contact_has_no_formal_order(cut_contact: ContactSolution) -> None:
    figure, _ = convergence_plot(report_with(cut_contact.numbers))
    labels = [str(line.get_label()) for axes in present(figure).axes for line in axes.get_lines()]
    assert "formal order" not in labels
    assert labels_of(present(figure).axes[-1]) == ["inner race"]
    require_legible(present(figure))


def test_the_formal_order_is_a_slope_below_all_points(document: Report) -> None:
    figure, _ = convergence_plot(document)
    panels = {axes.get_title(): axes for axes in present(figure).axes}
    for name, order in (("approach", 3), ("semi-axis b", 3)):
        first, last = points_of(line_of(panels[name], "formal order"))
        np.testing.assert_allclose(last[1] / first[1], (last[0] / first[0]) ** (-order / 3), rtol=1e-12)
        for place in ("inner race", "outer race", "thick seat", "sheet on its rim"):
            points = points_of(line_of(panels[name], place))
            assert np.all(points[:, 1] > 2 * first[1] * (points[:, 0] / first[0]) ** (-order / 3))


@pytest.mark.parametrize("draw", [torque_plot, friction_plot, ring_plot])
def test_without_a_torque_there_is_a_reason_in_place_of_a_figure(draw: Any) -> None:
    figure, why = draw(as_document({"solved": None}))
    assert figure is None
    assert "neither a friction coefficient nor both lubricant and surface" in why


def test_points_without_a_torque_are_not_drawn_and_none_at_all_is_refused() -> None:
    figure = torque_figure(torque_drawn(3, torque_total=[0.02, np.nan, 0.04], torque_rolling=[0.02, np.nan, 0.04]))
    assert len(figure.axes[0].get_yticks()) == 2
    with pytest.raises(InputError, match="no operating point has a torque"):
        torque_figure(torque_drawn(torque_total=[np.nan, np.nan]))


def test_a_small_part_has_one_digit_a_residue_is_0_and_names_are_no_formulas() -> None:
    parts = {"torque_spin": [1e-9], "torque_hysteresis": [8e-6], "torque_cage": [25e-6], "torque_total": [0.020033]}
    figure = torque_figure(replace(torque_drawn(1, torque_rolling=[0.02], **parts), title="a $ and a $"))
    (panel,) = figure.axes
    names = [label.get_text() for label in panel.get_yticklabels()]
    numbers = dict(zip(names, [text.get_text() for text in panel.texts], strict=True))
    assert [numbers[name] for name in ("spin", "hysteresis", "cage", "total")] == ["0", "0.008", "0.025", "20.03"]
    require_legible(figure)


def test_a_nominal_torque_of_0_has_a_figure() -> None:
    still = torque_drawn(1, torque_total=[0.0], torque_rolling=[0.0], uncertainty_numerical=[np.nan])
    figure = torque_figure(still)
    assert figure.axes[0].get_xlim() == (0, 1)
    assert figure.get_suptitle().endswith("numerical uncertainty unknown")


def test_at_most_so_many_bars_are_named() -> None:
    for count, step in ((MOST_NAMES, 1), (MOST_NAMES + 1, 2)):
        figure = torque_figure(torque_drawn(count))
        assert figure.axes[0].get_yticks().tolist() == list(range(0, count, step))
        require_legible(figure)


def balls(angles: list[float | None], **point: Any) -> Any:
    """A document of three balls, the second without a load on the inner race."""
    found = {"azimuth": (0.3, 1.7, 3.9), "inner_load": (210.0, 0.0, 95.0), "outer_load": (212.0, 1.5, 97.0)}
    row = {"balls": found | {"inner_angle": angles, "outer_angle": angles}}
    one = {"inner_speed": 31.0, "axial_load": 100.0, "radial_load": 200.0, "moment": 0.0}
    loads = {"inner_speed": 1260.0, "axial_load": 1450.0, "radial_load": -2350.0, "moment": 0.75}
    friction = SimpleNamespace(ring=SimpleNamespace(rows=[row, row]))
    solved = SimpleNamespace(points=[one, one | loads | point], friction=friction)
    return SimpleNamespace(solved=solved, units=METRIC)


@pytest.mark.parametrize("angles", [[0.21, None, 0.17], [0.21, 0.21 + 2e-9, None]])
def test_every_ball_is_seen_and_angles_that_are_alike_look_alike(angles: list[float | None]) -> None:
    figure, _ = ring_plot(balls(angles))
    polar, panel, *_ = present(figure).axes
    assert 212.0 < polar.get_ylim()[1] < 300.0
    low, high = panel.get_ylim()
    known = np.degrees([each for each in angles if each is not None])
    assert low < known.min() <= known.max() < high
    spread = float(known.max() - known.min())
    assert high - low == pytest.approx(max(LEAST_SPAN, 1.1 * spread), rel=1e-6)  # of the angles' round-off
    require_legible(present(figure))


def test_a_pair_has_a_reason_in_place_of_its_ring() -> None:
    found = balls([0.1, 0.2, None])
    found.solved.friction.ring = None
    figure, why = ring_plot(found)
    assert figure is None
    assert "Pair of bearings" in why


def names_of(panel: Axes) -> list[str]:
    return [label.get_text() for label in panel.get_yticklabels()]


def test_at_most_eight_inputs_are_drawn_and_none_below_half_a_per_cent() -> None:
    for indices, drawn in (
        ([0.9 - 0.01 * number for number in range(9)], 8),
        ([0.5, 0.0051, 0.0049], 2),
    ):
        keys = [f"bearing.part_{number}" for number in range(len(indices))]
        figure = interval_figure(interval_of(keys, np.transpose([indices, indices])), METRIC)
        assert names_of(figure.axes[2]) == [f"part {number}" for number in range(drawn)]


@pytest.mark.parametrize(
    ("changes", "label", "curves"),
    [
        ([{}, {}], "row", ["computed"]),
        ([{}, {"inner_speed": 15 * np.pi}], "inner speed, rpm", ["computed"]),
        ([{}, {"temperature": 323.15}], "temperature of the oil, degC", ["computed"]),
        (
            [{}, {"axial_load": 300.0}, {"axial_load": 500.0}, {"inner_speed": 15 * np.pi, "axial_load": 300.0}],
            "axial load, N",  # several loads at one speed do not lie on one another
            ["computed, 450 rpm", "computed, 600 rpm"],
        ),
        ([{}, {"axial_load": 300.0, "temperature": 320.0}, {"temperature": 330.0}], "axial load, N", None),
    ],
)
def test_measured_torques_are_over_what_varies_most(
    changes: list[dict[str, float]], label: str, curves: list[str] | None
) -> None:
    axis = axis_of([row(**each) for each in changes], METRIC)
    assert axis.label == label
    assert curves is None or sorted(axis.curves) == curves
    for places in axis.curves.values():
        assert list(axis.values[places]) == sorted(axis.values[places])


def test_more_curves_than_colours_are_drawn_as_points_in_one_colour() -> None:
    rows = [row(axial_load=100.0 * load, inner_speed=speed) for load in range(2, 10) for speed in range(30, 36)]
    figure = measured_figure(comparison(*rows))
    assert [text.get_text() for text in figure.legends[0].get_texts()] == ["computed, 95 %", "measured, missed"]
    require_legible(figure)
