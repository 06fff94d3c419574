"""The plot of a cage in motion, by the numbers that are drawn of a record; what a document keeps of the record."""

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
from matplotlib.patches import Rectangle
from matplotlib.text import Annotation

from analytic.units import METRIC
from fembearing.check.cage_record import CageRecord, DrawnMotion, exceedance
from fembearing.plain_types import plain
from fembearing.report.figures.cage import cage_plot, orbit_figure
from fembearing.report.report import Report
from tests.analytic.specimens import present
from tests.report.figures.figure_reader import as_document, line_of, points_of, require_legible


def motion_of(record: CageRecord) -> DrawnMotion:
    """As the document has it."""
    return record.drawn()


def test_an_exceedance_counts_what_is_above(record: CageRecord) -> None:
    known = replace(record, statistics=replace(record.statistics, block_maxima=(0.3, 0.7, 0.5, 0.9)))
    excess = orbit_figure(motion_of(known), METRIC).axes[2]
    drawn = points_of(line_of(excess, "blocks of all seeds"))
    np.testing.assert_allclose(drawn, [(0.3, 100), (0.5, 75), (0.7, 50), (0.9, 25)], rtol=1e-12)
    for force in (0.4, 0.6, 0.8):  # between two of them the curve is the share that lies above
        after = int(np.searchsorted(drawn[:, 0], force))  # drawn with its steps before the points
        share = 100 * np.mean(np.array([0.3, 0.7, 0.5, 0.9]) > force)
        assert drawn[after, 1] == share
    assert line_of(excess, "blocks of all seeds").get_drawstyle() == "steps-pre"
    assert excess.get_xlim()[0] < 0.3 < 0.9 < excess.get_xlim()[1]
    assert (excess.get_xlabel(), excess.get_ylabel()) == ("largest force of one ball, N", "exceeded in, %")


def test_a_document_keeps_the_extremes_of_a_thinned_motion(record: CageRecord) -> None:
    few = record.drawn(most=60)
    whole, thin = plain(record.drawn()), plain(few)
    for name in ("largest", "sum"):
        assert len(thin["forces"][name]) <= 60
        assert max(thin["forces"][name]) == max(whole["forces"][name])
        assert thin["forces"][name][-1] >= whole["forces"][name][-1]
    assert thin["forces"]["time"][-1] == whole["forces"]["time"][-1]
    assert thin["orbit"]["measured"][-1] == whole["orbit"]["measured"][-1]
    assert {tuple(place) for place in thin["orbit"]["measured"]} <= {
        tuple(place) for place in whole["orbit"]["measured"]
    }
    assert thin["exceedance"]["force"][-1] == max(whole["exceedance"]["force"])
    motions = (few, replace(few, inner_speed=100.0, state="whirl"))
    figures, caption = cage_plot(cast(Report, SimpleNamespace(cage_records=motions, units=METRIC)))
    figure, other = present(figures)
    assert (len(figure.axes), len(other.axes)) == (3, 3)
    assert caption.count("Forces: the largest") == 1  # one caption for both
    assert "The cage rests" in caption
    assert "The cage whirls" in caption
    orbit = line_of(figure.axes[0], "measured")
    np.testing.assert_allclose(points_of(orbit), 1e6 * np.array(thin["orbit"]["measured"]), rtol=1e-12)
    assert orbit.get_linestyle() == "None"  # neighbours in the list are none in time
    require_legible(figure)


def test_a_group_of_instants_is_told_by_its_greatest(record: CageRecord) -> None:
    force = record.series.max_force.size - np.arange(record.series.max_force.size, dtype=float)  # falls to 1 N
    series = replace(record.series, max_force=force)
    thin = replace(record, series=series).drawn(most=60).forces
    step = -(-force.size // 60)
    expected = [force[max(0, end - step + 1)] for end in range(force.size - 1, -1, -step)][::-1]
    np.testing.assert_array_equal(thin.largest, expected)  # the first of each group


def test_a_thinned_exceedance_keeps_the_rarest() -> None:
    force = np.concatenate([np.zeros(500), 3.0 + np.arange(500) / 100])
    whole, share = exceedance(force)
    assert (share[0], share[-1]) == (0.5, 1e-3)  # half of the instants touch nothing
    kept, of = exceedance(force, 20)
    assert kept.size <= 20
    np.testing.assert_array_equal(of, [np.mean(force >= each) for each in kept])
    np.testing.assert_array_equal(kept[-3:], whole[-3:])


def test_a_cage_at_rest_by_its_closed_form_has_a_reason_in_place_of_a_figure() -> None:
    assert cage_plot(as_document({"cage_records": [], "torque": {}})) == (
        None,
        "No motion of the cage: the torque has the closed form of a cage at rest on its balls, or no cage. The motion "
        "is computed for a scene with cage.start, where the cage can leave its rest.",
    )
    assert (
        cage_plot(as_document({"cage_records": [], "torque": None}))[1]
        == "No motion of the cage: the scene has no torque."
    )


def test_an_arrow_shows_where_gravity_pulls(record: CageRecord) -> None:
    for pull, along in (((0.0, -9.81, 0.0), (0, -1)), ((3.0, 0.0, 7.0), (1, 0)), ((0.0, 0.0, 9.81), None)):
        orbit = orbit_figure(replace(motion_of(record), gravity=pull), METRIC).axes[0]
        arrows = [text for text in orbit.texts if isinstance(text, Annotation)]
        assert len(arrows) == (along is not None)
        assert ("gravity" in [text.get_text() for text in orbit.texts]) == (along is not None)
        for arrow in arrows:
            way = np.subtract(arrow.xy, arrow.xyann)
            np.testing.assert_allclose(way / np.linalg.norm(way), present(along), atol=1e-12)
            ends = np.array([arrow.xy, arrow.xyann])
            assert np.all((ends > 0) & (ends < 1))  # inside the panel
            assert np.linalg.norm(way) < 0.2


def test_the_axis_of_forces_reaches_below_the_least_of_them(record: CageRecord) -> None:
    """Half of the least force above 0, as long as that is no tiny share of the largest ones."""
    motion = motion_of(record)
    largest = np.linspace(0.4, 1.9, len(motion.forces.time))
    largest[5] = 0.0
    forces = replace(motion.forces, largest=tuple(largest), sum=tuple(1.3 * largest))
    known = replace(motion, forces=forces, max_force=2.7)
    panel = orbit_figure(known, METRIC).axes[1]
    assert panel.get_ylim()[0] == pytest.approx(0.4 / 2, rel=1e-12)  # round-off
    assert panel.get_ylim()[1] > 1.3 * 1.9
    largest[7] = 1e-5
    tiny = replace(known, forces=replace(forces, largest=tuple(largest)))
    low = orbit_figure(tiny, METRIC).axes[1].get_ylim()[0]
    assert low == pytest.approx(2.7e-3, rel=1e-12)  # a thousandth of the median of the blocks


def test_forces_over_a_wide_range_have_a_logarithmic_scale(record: CageRecord) -> None:
    motion = motion_of(record)
    for most, scale in ((1.5, "linear"), (30.0, "log")):
        force = tuple(np.linspace(1.0, most, 50).tolist())
        share = tuple((np.arange(50, 0, -1) / 50).tolist())
        excess = replace(motion.exceedance, force=force, share=share)
        known = replace(
            motion, exceedance=excess, block_maxima=(1.1, 1.3), max_force=1.2, max_force_interval=(1.1, 1.3)
        )
        panel = orbit_figure(known, METRIC).axes[2]
        assert panel.get_xscale() == scale
        low, high = panel.get_xlim()
        assert low < 1.1
        assert high > most
        assert panel.get_ylim()[1] > 100
        (band,) = (patch for patch in panel.patches if isinstance(patch, Rectangle))
        assert (band.get_x(), band.get_x() + band.get_width()) == pytest.approx((1.1, 1.3), rel=1e-12)
        instants = points_of(line_of(panel, "instants of this motion"))
        np.testing.assert_allclose(instants, np.column_stack([force, 100 * np.array(share)]), rtol=1e-12)
