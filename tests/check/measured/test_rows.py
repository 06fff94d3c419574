"""A row by hand: the error, its uncertainty, the interval of the measured torque, and the verdict."""

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from analytic.scene import MeasuredTorque
from fembearing.check.measured.conclusions import conclusions_of
from fembearing.check.measured.rows import MeasuredRow, row_of

# N m. Twice 1.959964 standard uncertainties between the ends: 1.8/3.919928 = 0.459192, 0.7/3.919928 = 0.178575.
COMPUTED, LOW, MEDIAN, HIGH = 5.0, 3.8, 4.9, 6.7
ENDS = {"input": (4.2, 6.0), "model": (4.6, 5.3)}
SOLVER = 0.06  # relative, 95 %: a standard uncertainty of 0.15


def row(measured: float, *, uncertainty: float | None = 0.3, solver: float = SOLVER) -> MeasuredRow:
    """The second row of a file at the third point of a prediction; the others hold other numbers."""

    def at(value: float) -> np.ndarray:
        return np.array([77.0, 78.0, value])

    prediction: Any = SimpleNamespace(
        nominal=SimpleNamespace(
            torque=SimpleNamespace(total=at(COMPUTED)),
            numerical_uncertainty=at(solver),
            inner_speed=at(31.0),
            axial_load=at(700.0),
            radial_load=at(40.0),
            moment=at(0.2),
        ),
        total=SimpleNamespace(low=at(LOW), median=at(MEDIAN), high=at(HIGH)),
        made_of={name: np.array([at(low), at(high)]) for name, (low, high) in ENDS.items()},
    )
    data = MeasuredTorque(
        file="data.csv",
        torque=np.array([55.0, measured]),
        uncertainty=None if uncertainty is None else np.array([9.0, uncertainty]),
    )
    scene: Any = SimpleNamespace(lubricant=SimpleNamespace(temperature=330.0))
    return row_of(data, 1, prediction, 2, scene)


def test_error_and_uncertainty_are_those_by_hand() -> None:
    found = row(4.0)
    assert (found.inner_speed, found.axial_load, found.radial_load, found.moment) == (31.0, 700.0, 40.0, 0.2)
    assert (found.temperature, found.measured, found.computed, found.error) == (330.0, 4.0, 5.0, 1.0)
    assert found.relative == 0.25
    assert (found.numerical, found.measurement) == (0.15, 0.3)
    assert found.input == pytest.approx(0.459192, abs=1e-6)  # six digits, as computed by hand
    assert found.formulas == pytest.approx(0.178575, abs=1e-6)
    # sqrt(0.15^2 + 0.459192^2 + 0.3^2): the formulas are not in it.
    assert found.validation == pytest.approx(0.568645, abs=1e-6)
    assert not found.resolved  # 1 < 1.96 x 0.568645 = 1.1145
    assert row(3.88).resolved  # 1.12


def test_the_interval_of_the_measured_torque_is_wider_by_its_uncertainty() -> None:
    found = row(4.0)
    assert (found.computed_low, found.computed_high) == (LOW, HIGH)
    # From the median: 4.9 - sqrt(1.1^2 + 0.587989^2) and 4.9 + sqrt(1.8^2 + 0.587989^2), 1.959964 x 0.3 = 0.587989.
    assert found.low == pytest.approx(3.652711, abs=1e-6)
    assert found.high == pytest.approx(6.793603, abs=1e-6)
    exact = row(4.0, uncertainty=None)
    assert (exact.low, exact.high, exact.measurement) == (pytest.approx(LOW), pytest.approx(HIGH), None)
    assert exact.validation == pytest.approx(np.hypot(0.15, 0.459192), abs=1e-6)


@pytest.mark.parametrize(
    ("measured", "verdict", "beyond"),
    [
        (3.65, "model too high", 0.002711),
        (3.66, "inside", 0.0),
        (6.79, "inside", 0.0),
        (6.80, "model too low", 0.006397),
    ],
)
def test_the_verdict_turns_where_the_measured_torque_leaves_the_interval(
    measured: float, verdict: str, beyond: float
) -> None:
    found = row(measured)
    assert found.verdict == verdict
    assert found.beyond == pytest.approx(beyond, abs=1e-6)


def concluded(*measured: float, **kind: Any) -> list[str]:
    rows = [row(each, **kind) for each in measured]
    relative = np.array([each.relative for each in rows])
    scatter = float(relative.std(ddof=1)) if len(rows) > 1 else None
    return list(conclusions_of(rows, float(relative.mean()), scatter, {"lubricant.viscosity": 0.61}))


def test_what_is_missed_comes_first() -> None:
    missed, side, meaning, spread, course = concluded(9.0, 5.0, 8.0, 8.5)
    assert missed == "Missed: 3 of 4 measured torques are outside their 95 % intervals."
    assert side == "The model is too low at rows 1, 3 and 4, by 38 to 44 %."  # 5/8 - 1, 5/9 - 1
    assert "one torque of 20 by chance" in meaning
    assert "exceeds its stated uncertainty" in meaning
    # -44.4, 0, -37.5, -41.2 %: mean -30.8 %, standard deviation 20.7 %.
    assert spread == "Over all rows E, computed less measured, is -44 to +0 %, mean -30.8 %, standard deviation 21 %."
    assert "a common cause" in course
    assert "lubricant.viscosity 61 %" in course


def test_both_sides_are_named_and_no_factor_explains_them() -> None:
    found = concluded(9.0, 3.0, 2.9)
    assert found[0].startswith("Missed: 3 of 3 measured torques are")
    assert found[1] == "The model is too low at row 1, by 44 %."
    assert found[2] == "The model is too high at rows 2 and 3, by 67 to 72 %."
    assert concluded(9.0, 8.8, 2.9)[-1].startswith("The standard deviation of E exceeds its mean")


def test_agreement_is_worth_what_the_data_can_show() -> None:
    inside, meaning = concluded(4.0)
    assert inside == "The measured torque is inside its 95 % interval."
    # 1.96 x 0.568645/4 = 28 %
    assert "show no error of the formulas" in meaning
    assert "below 28 %" in meaning
    assert "The formulas err at row 1" in concluded(3.88)[1]


def test_one_row_of_several_is_in_the_singular() -> None:
    assert concluded(9.0, 5.0)[0] == "Missed: 1 of 2 measured torques is outside its 95 % interval."
    assert concluded(4.6, 5.0)[0] == "All 2 measured torques are inside their 95 % intervals."
