"""Stored gaps of rough surfaces against an independent code and Tamaas, by the script's own comparison."""

from collections.abc import Callable

import numpy as np
import pytest

from analytic import catalog
from analytic.scene import Autocorrelation
from analytic.surface.elastic_gap import declared_gap_curve, elastic_log_gap
from validation.film import elastic_gap


def test_the_stored_curve_agrees_with_the_independent_code() -> None:
    assert elastic_gap.against_published()


@pytest.mark.nightly
def test_a_stored_curve_comes_from_the_command() -> None:
    """Two of its surfaces: within four standard deviations of two, at each pressure."""
    stored = next(c for c in catalog.entry("corrections", "elastic_gap")["curve"] if c["points"] == 200)
    made = elastic_gap.mean_curve("exponential", 10, 2, jobs=1)
    error = np.log(made["gap"] / stored["gap"])
    assert np.all(np.abs(error) < 4 * np.array(stored["spread"]) / np.sqrt(2))


def test_pressures_of_the_file_are_the_knots() -> None:
    table = catalog.entry("corrections", "elastic_gap")
    curve = declared_gap_curve(Autocorrelation(kind="gaussian", length=32.0, spacing=1.0))
    np.testing.assert_allclose(
        np.exp(elastic_log_gap(*curve.splines, np.log(table["pressure"]))[0]), table["curve"][0]["gap"], rtol=1e-12
    )


@pytest.mark.nightly
def test_the_command_agrees_with_tamaas(run_script: Callable[..., str]) -> None:
    pytest.importorskip("tamaas", reason="its wheels are for Linux on x86-64 only")
    printed = run_script("film/elastic_gap.py", "--check")
    assert printed.count("Agrees within the tolerances") == 3
