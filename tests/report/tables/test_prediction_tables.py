"""The tables of an interval: its ends, what makes it, and the inputs with the largest shares."""

from dataclasses import replace
from io import StringIO

from rich.console import Console

from analytic.prediction.rows import PredictionRows
from fembearing.report.tables.prediction import MOST_INPUTS, interval_table, prediction_tables, shares_table
from fembearing.report.terminal.table import show
from tests.report.prediction_rows import content, prediction_of
from tests.report.torque_rows import lost, point, record


def printed(prediction: PredictionRows) -> str:
    out = StringIO()
    for table in (interval_table(prediction, range(2)), shares_table(prediction)):
        show(Console(file=out, width=80), table)
    return out.getvalue()


def test_the_terminal_shows_ends_parts_inputs_and_failures() -> None:
    said = printed(prediction_of(content()))
    assert max(map(len, said.splitlines())) <= 80
    rows = [line.split() for line in said.splitlines()]
    assert ["1", "21.00", "12.6-39.9", "0.2,", "0.7", "20.6-21.6", "14.7-31.5", "16.8-29.4"] in rows
    words = " ".join(said.split())
    for word in (
        "film formula 55 +- 2 61 +- 3 55 +- 2 31 +- 3",
        "95 % interval by 300 Latin hypercube samples, seed 77, in 12 s",
        "the standard error of an end is at most 1.8 %",  # 7e-4 of 1.9 x 0.021
        "2 of 300 samples have no torque and are left out: a ball fell out (2 times).",
        "Not included: the moon.",
        "explains 97 % or more of the variance; the rest is attributed to no input",
        "film formula 18.9-23.1 and 30.6-37.4",
    ):
        assert word in words, word


def test_shares_of_a_regression_that_predicts_nothing_are_said_to_be_unknown() -> None:
    """Left-out predictions can miss by more than the mean does: their share of the variance is then below 0."""
    failed = content()
    failed["points"][1]["explained"] = -1600.7
    words = " ".join(printed(prediction_of(failed)).split())
    assert "explains 0 % or more of the variance: the ranking of the inputs is not known" in words


def test_a_point_without_a_torque_has_no_row_of_an_interval() -> None:
    slow, fast = prediction_of(content()).points
    predicted = replace(prediction_of(content()), points=(slow, slow, fast))
    torque = record(point(0), point(1), point(2), left_out=(lost(1),), prediction=predicted)
    intervals, shares = prediction_tables(torque, [1, 2])
    assert [row[:2] for row in intervals.groups[0].rows] == [["3", "34.00"]]
    assert [head.text for head in shares.heads][1::2] == ["alone, 95.493 rpm", "alone, 477.46 rpm"]  # 10 and 50 rad/s
    assert prediction_tables(replace(torque, prediction=None), [1, 2]) == []


def test_of_many_inputs_those_with_the_largest_shares_are_shown() -> None:
    """Without a formula among the parts, no sentence speaks of formulas."""
    long, count = content(), MOST_INPUTS + 2
    long["inputs"] = [long["inputs"][0] | {"key": f"operation.load_{place}"} for place in range(count)]
    for each in long["points"]:
        del each["made_of"]["model.film"]
        each["indices"] = {name: [0.02 * place for place in range(count)] for name in each["indices"]}
    table = shares_table(prediction_of(long))
    assert [row[0] for row in table.groups[0].rows] == [f"load {place}" for place in range(count - 1, 1, -1)]
    assert not any("Of the formulas" in note for note in interval_table(prediction_of(long), [0]).notes)
