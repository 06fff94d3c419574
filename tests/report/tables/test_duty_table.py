"""The tables of a duty cycle, by cells that are worked out by hand."""

from dataclasses import replace

import numpy as np

from analytic.prediction.duty import DutyCycle, DutyStep, Estimate
from analytic.prediction.steady import SteadyTemperature
from fembearing.quantities import INCH_POUND
from fembearing.report.tables.duty import MOST_ROWS, NOTES, cycle_table, steps_table

RPM = np.pi / 30


def estimate(value: float) -> Estimate:
    return Estimate(value=value, low=0.7 * value, high=1.9 * value)


def step(number: int, *, temperature: float | None = 313.15, power: float = 2.5, speed: float = 600.0) -> DutyStep:
    """Each lasts 3 s longer than the one before."""
    duration = 20.0 + 3 * number
    return DutyStep(
        inner_speed=speed * RPM,
        axial_load=300.0 + 40 * number,
        radial_load=0.0,
        moment=0.0,
        duration=duration,
        temperature=temperature,
        torque=estimate(0.04 if power else 0.0),
        power=power,
        energy=power * duration,
    )


def cycle(*steps: DutyStep) -> DutyCycle:
    return DutyCycle(
        scene="a spindle",
        file="cycle.csv",
        steps=steps,
        duration=sum(each.duration for each in steps),
        energy=estimate(sum(each.energy for each in steps)),
        mean_torque=estimate(0.03),
        worst_torque=estimate(0.05),
        worst_step=1,
        mean_power=estimate(1.4),
        steady=None,
        warnings=(),
        seconds=0.1,
    )


def test_a_step_has_its_numbers_and_its_share_of_the_energy() -> None:
    table = steps_table(cycle(step(0), step(1), step(2, power=0.0)))
    assert [head.text for head in table.heads] == [
        "#", "duration, s", "speed, rpm", "axial load, N", "torque, N mm", "95 %", "power, W", "energy, J", "share, %"
    ]  # fmt: skip
    rows = table.groups[0].rows
    assert rows[0] == ["1", "20", "600", "300", "40", "28-76", "2.5", "50", "46.5"]  # 50 of 107.5 J
    assert rows[1] == ["2", "23", "600", "340", "40", "28-76", "2.5", "57.5", "53.5"]
    assert rows[2] == ["3", "26", "600", "380", "0", "-", "0", "0", "0"]
    assert table.label == "Steps of cycle.csv, oil at 40 degC"
    assert table.notes == []


def test_oil_that_warms_by_friction_is_steady_and_says_why() -> None:
    warm = SteadyTemperature(temperature=313.15, power=2.5, ambient=293.15, resistance=8.0)
    steady = replace(cycle(step(0), step(1)), steady=warm)
    assert steps_table(steady).label == "Steps of cycle.csv, oil at 40 degC (steady)"
    assert cycle_table(steady).notes[0].startswith("Oil temperature: steady: 20 degC of the surroundings and 8 K/W")
    assert cycle_table(replace(steady, steady=None)).notes == [NOTES]


def test_oil_that_changes_has_a_column_and_none_has_no_word() -> None:
    heads = [head.text for head in steps_table(cycle(step(0), step(1, temperature=323.15))).heads]
    assert heads[4] == "oil, degC"
    table = steps_table(cycle(step(0), step(1, temperature=323.15)), INCH_POUND)
    assert [row[4] for row in table.groups[0].rows] == ["104", "122"]  # degF
    dry = steps_table(cycle(step(0, temperature=None), step(1, temperature=None)))
    assert "oil" not in dry.label
    assert not any("oil" in head.text for head in dry.heads)


def test_a_long_cycle_shows_the_steps_with_the_most_energy_in_their_order() -> None:
    whole = steps_table(cycle(*(step(number) for number in range(MOST_ROWS))))
    assert len(whole.groups[0].rows) == MOST_ROWS
    assert whole.notes == []
    long = steps_table(cycle(*(step(number, power=0.1 if number == 12 else 2.5) for number in range(MOST_ROWS + 3))))
    assert [row[0] for row in long.groups[0].rows] == [str(n) for n in range(3, MOST_ROWS + 4) if n != 13]
    assert long.notes == [f"{MOST_ROWS} of {MOST_ROWS + 3} steps, those with the most energy."]


def test_a_cycle_at_rest_has_no_shares() -> None:
    rows = steps_table(cycle(step(0, power=0.0), step(1, power=0.0))).groups[0].rows
    assert [row[-1] for row in rows] == ["-", "-"]


def test_the_cycle_has_energy_in_both_units_and_its_worst_step() -> None:
    table = cycle_table(cycle(step(0), step(1)))
    assert table.label == "a spindle, 43 s"
    assert table.groups[0].rows == [
        ["energy", "107.5", "75.25-204.2", "J"],
        ["energy", "0.02986", "0.0209-0.05674", "Wh"],  # 3600 J
        ["mean torque", "30", "21-57", "N mm"],
        ["worst torque, step 2", "50", "35-95", "N mm"],
        ["mean power", "1.4", "0.98-2.66", "W"],
    ]
    open_ = replace(cycle(step(0), step(1)), energy=Estimate(value=107.5, low=None, high=None))
    assert cycle_table(open_).groups[0].rows[0] == ["energy", "107.5", "not known", "J"]
    assert "No interval: no torque at the bound of an input." in cycle_table(open_).notes
