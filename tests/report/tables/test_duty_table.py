"""The tables of a duty cycle, by cells that are worked out by hand."""

from dataclasses import replace

from analytic.prediction.steady import SteadyTemperature
from analytic.units import INCH_POUND
from fembearing.report.sections.duty import MOST_ROWS, NOTES, cycle_table, steps_table
from tests.report.specimens import cycle, step


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
