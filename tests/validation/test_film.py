"""Computed films against measured ones: the script's comparison, and the uncertainty that the formula states."""

from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from analytic.oil.film import FORMULA_UNCERTAINTY


@pytest.fixture(scope="module")
def comparison(script: Callable[[str], ModuleType]) -> Any:
    return script("film").compare()


def test_the_formula_states_the_uncertainty_that_the_measured_films_show(comparison: Any) -> None:
    """At least the root mean square of the errors, and not so much more that the measured films would not matter."""
    assert comparison.model_uncertainty <= FORMULA_UNCERTAINTY < 1.5 * comparison.model_uncertainty


def test_the_formula_agrees_within_the_validation_uncertainty(comparison: Any) -> None:
    judged = comparison.judged
    assert judged.sum() == 20  # of 31: counted in the file by hand
    assert np.all(np.abs(comparison.error)[judged] < 2 * comparison.uncertainty[judged])  # 95 %


def test_uncertainties_have_the_sizes_that_the_script_states(comparison: Any) -> None:
    np.testing.assert_allclose(comparison.measurement_uncertainty[comparison.speed <= 0.05], 1.1e-9)
    np.testing.assert_allclose(comparison.measurement_uncertainty[comparison.speed >= 0.1], 18e-9)
    # Elastic and piezoviscous: h ~ (eta u)^(2/3) alpha^(1/2) F^(-1/15) within a few hundredths, so the 15 % of alpha
    # dominate: 0.5 * 15 %, with 2/3 * 2 %, 2/3 * 1 % and less.
    fast = comparison.speed > 0.3
    relative = comparison.input_uncertainty[fast] / comparison.computed[fast]
    np.testing.assert_allclose(relative, np.hypot(0.5 * 0.15, 2 / 3 * np.hypot(0.02, 0.01)), rtol=0.1)


@pytest.mark.slow
def test_the_script_prints_and_draws(run_script, tmp_path: Path) -> None:
    printed = run_script("film.py", "--out", tmp_path)
    assert "20 of 31 points are judged" in printed
    assert "E/D: mean" in printed
    assert (tmp_path / "film.png").stat().st_size > 0
