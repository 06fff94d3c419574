"""What measured torques show of the computed ones, in sentences."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby
from pathlib import Path

from analytic.scene import MeasuredTorque
from analytic.scenefile.columns import OPERATING
from analytic.words import percent_of
from fembearing.check.measured.rows import COVERAGE, MeasuredRow

FEW = 3  # rows: fewer show no course of the error
SIDES = {"model too low": "too low", "model too high": "too high"}


def conclusions_of(
    rows: Sequence[MeasuredRow], mean_error: float, scatter: float | None, shares: Mapping[str, float]
) -> Iterator[str]:
    """What is missed first; then the error of all rows, and what follows from it.

    mean_error, scatter : of E/D;  shares : of the variance of S, by input
    """
    places = {verdict: [p for p, row in enumerate(rows) if row.verdict == verdict] for verdict in SIDES}
    missed = sum(map(len, places.values()))
    if missed:
        where = "is outside its 95 % interval" if missed == 1 else "are outside their 95 % intervals"
        yield f"Missed: {missed} of {len(rows)} measured torques {where}."
    for verdict, side in SIDES.items():
        if places[verdict]:
            off = _span([abs(rows[place].relative) for place in places[verdict]])
            yield f"The model is {side} at {_listed(places[verdict])}, by {off}."
    if not missed:
        all_rows = f"All {len(rows)} measured torques are inside their 95 % intervals."
        yield all_rows if len(rows) > 1 else "The measured torque is inside its 95 % interval."
    yield from _meaning(rows, missed=bool(missed))
    if scatter is not None:
        ends = _span([row.relative for row in rows], "+.0f")
        spread = f"{ends}, mean {100 * mean_error:+.1f} %, standard deviation {percent_of(scatter, 2)}"
        yield f"Over all rows E, computed less measured, is {spread}."
    if scatter is not None and len(rows) >= FEW and any(row.resolved for row in rows):
        leading = ", ".join(f"{key} {100 * share:.0f} %" for key, share in shares.items())
        yield (
            "The mean of E exceeds its standard deviation: a common cause can explain most of it. Shares in the "
            f"variance of the computed torque: {leading}."
            if abs(mean_error) > scatter
            else "The standard deviation of E exceeds its mean: no constant factor explains it."
        )


def _meaning(rows: Sequence[MeasuredRow], *, missed: bool) -> Iterator[str]:
    """What can be concluded."""
    if missed:
        yield (
            "A 95 % interval misses one torque of 20 by chance. More misses mean that the error of an input, of the "
            "measurement or of a formula exceeds its stated uncertainty."
        )
        return
    resolved = [place for place, row in enumerate(rows) if row.resolved]
    if resolved:
        yield (
            f"The formulas err at {_listed(resolved)}, |E| > 2 u_val, within their stated uncertainty; this holds if "
            "the uncertainties of inputs and measurement are right."
        )
    else:
        finest = max(COVERAGE * row.validation / row.measured for row in rows)
        yield (
            "Uncertainties of solver, inputs and measurement explain every difference, |E| < 2 u_val: these data show "
            f"no error of the formulas. They do not resolve an error below {percent_of(finest, 2)} at every row."
        )


def notes_of(measured: MeasuredTorque, rows: Sequence[MeasuredRow]) -> Iterator[str]:
    """What was taken from the scene, and what the file lacks."""
    file = Path(measured.file).name
    taken = [name.replace("_", " ") for name in OPERATING if getattr(measured, name) is None and getattr(rows[0], name)]
    if taken:
        yield f"From the scene, without a column in {file}: {', '.join(taken)}."
    if measured.uncertainty is None:
        yield f"{file} has no column uncertainty: measured torques count as exact."


def _listed(places: Sequence[int]) -> str:
    """Rows by their numbers, from 1: "rows 1 to 3 and 7"."""
    runs = [[place + 1 for _, place in run] for _, run in groupby(enumerate(places), lambda each: each[1] - each[0])]
    words = [word for run in runs for word in (map(str, run) if len(run) < FEW else [f"{run[0]} to {run[-1]}"])]
    listed = " and ".join(part for part in (", ".join(words[:-1]), words[-1]) if part)
    return f"row{'s' if len(places) > 1 else ''} {listed}"


def _span(shares: Sequence[float], form: str = ".0f") -> str:
    """The least and the largest share in per cent."""
    ends = dict.fromkeys(format(100 * each, form) for each in (min(shares), max(shares)))
    return f"{' to '.join(ends)} %"
