"""The comparison with measured torques: its arithmetic by hand, and the sentences that quote it."""

import csv
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from fembearing.report.phrases import MEASURED, MEASURED_RANGE
from validation.measured import run as measured

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def rig() -> Any:
    """The balls of 3 mm."""
    return measured.compare(3.0)


def test_the_spin_downs_are_those_of_the_file() -> None:
    small, large = measured.spin_downs(3.0), measured.spin_downs(6.35)
    assert small.shape == large.shape == (6, 6)
    assert np.sum(~np.isnan(small), axis=0).tolist() == [6, 5, 4, 3, 2, 1]  # a run passes the speeds below its first
    # K w^n of the last row of each size at its initial speed, as the paper's own tables have the torque: 91.61, 249.28.
    np.testing.assert_allclose([small[-1, -1], large[-1, -1]], [91.61e-6, 249.28e-6], rtol=1e-3)  # K has five digits


def test_the_arithmetic_of_one_point_by_hand(rig: Any) -> None:
    """Two runs at two speeds, worked with pencil: mean, pooled scatter, u_D, u_val and E."""
    runs = np.array([[90e-6, 120e-6], [110e-6, np.nan]])
    known = replace(
        rig,
        runs=runs,
        computed=np.array([70e-6, 130e-6]),
        numerical=np.array([3e-6, 0.0]),
        inputs={"one": np.array([4e-6, 1e-6]), "other": np.array([0.0, 2e-6])},
    )
    np.testing.assert_allclose(known.measured, [100e-6, 120e-6])
    np.testing.assert_allclose(known.error, [-30e-6, 10e-6], rtol=1e-9)  # a difference
    # Deviations of -10 % and +10 %, one degree of freedom: sqrt(0.02).
    np.testing.assert_allclose(known.scatter, np.sqrt(0.02))
    # 0.02/2 + 0.03^2 + 0.025^2 = 0.011525;  0.02 + 0.001525 = 0.021525
    np.testing.assert_allclose(known.measurement, [100e-6 * np.sqrt(0.011525), 120e-6 * np.sqrt(0.021525)])
    # sqrt(3^2 + 4^2 + 10.7355^2) = 11.8427;  sqrt(0 + 5 + 17.6057^2) = 17.7471
    np.testing.assert_allclose(known.validation, [11.8427e-6, 17.7471e-6], rtol=1e-5)  # six digits
    # 30 uN m at a radius of 18 mm on six contacts, on both surfaces of each.
    np.testing.assert_allclose(known.lack_per_contact[0], 30e-6 / (6 * 18e-3))


def test_the_inputs_have_the_sizes_that_the_formula_says(rig: Any) -> None:
    """Rolling: a force with viscosity and speed to the power 2/3 to 3/4 and more, on a lever, times the radius."""
    viscosity, radius = (rig.inputs[name] / rig.computed for name in ("viscosity", "radius of the races"))
    powers = viscosity / 0.065, radius / (3**-0.5 / 18)
    # Between the two regimes the power is above that of both: rolling passes from one level to a higher one.
    assert np.all((powers[0] > 2 / 3) & (powers[0] < 0.95))
    # Other parts of the torque, 3 % at most, do not go with both alike; differences over 6 % are not exactly slopes.
    np.testing.assert_allclose(powers[1], powers[0] + 1, rtol=0.03)
    for name in ("boundary friction", "length of the roughness waves"):
        assert np.all(rig.inputs[name] < 0.01 * rig.computed)


def test_the_sentences_quote_the_report() -> None:
    """The range of E/D in README, the report and docs is that of validation/measured/measured.csv."""
    with (ROOT / "validation" / "measured" / "measured.csv").open(encoding="utf-8") as file:
        rows = [row for row in csv.DictReader(file) if row["rpm"].isdigit()]
    relative = [100 * float(row["E_over_D"]) for row in rows if row["ball_diameter_mm"] in ("3", "6.35")]
    assert len(relative) == 12
    assert all(each < 0 for each in relative)
    low, high = min(map(abs, relative)), max(map(abs, relative))
    assert f"{low:.0f} to {high:.0f} %" == MEASURED_RANGE
    assert MEASURED_RANGE in MEASURED
    for file in (
        "README.md",
        "docs/measured.md",
        "docs/limits.md",
        "docs/validation.md",
        "validation/measured/measured.md",
    ):
        assert MEASURED_RANGE in (ROOT / file).read_text(encoding="utf-8"), file
