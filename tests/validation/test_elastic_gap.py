"""Stored gaps of rough surfaces against an independent code, by the script's own comparison."""

import numpy as np

from analytic import catalog
from analytic.scene import Autocorrelation
from analytic.surface.elastic_gap import declared_gap_curve, elastic_log_gap
from validation.film import elastic_gap


def test_the_stored_curve_agrees_with_the_independent_code() -> None:
    assert elastic_gap.against_published()


def test_pressures_of_the_file_are_the_knots() -> None:
    table = catalog.entry("corrections", "elastic_gap")
    curve = declared_gap_curve(Autocorrelation(kind="gaussian", length=32.0, spacing=1.0))
    np.testing.assert_allclose(
        np.exp(elastic_log_gap(*curve.splines, np.log(table["pressure"]))[0]), table["curve"][0]["gap"], rtol=1e-12
    )
