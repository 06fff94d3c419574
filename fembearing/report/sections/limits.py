"""The physical limits."""

from collections.abc import Sequence

from analytic.units import METRIC, Units
from analytic.verdicts import NumericalCheck, PhysicalCheck, Summary
from analytic.words import percent_of
from fembearing.report.document import Head, Section, Table, Text, table_of
from fembearing.report.phrases import capital

CHECKS = {  # the physical verdicts
    "peak_pressure": "peak pressure",
    "shoulder": "load cut off",
    "sliding": "sliding number",
    "gyroscopic_hold": "gyroscopic hold",
    "cage_force": "cage force",
    "tilt": "tilt of the inner ring",
    "replenishment": "starvation, -ln of the factor",
}

HEADS = (
    Head("check", "name"),
    Head("where", "name"),
    Head("#"),
    Head("worst"),
    Head("limit"),
    Head("verdict", "verdict"),
)
POINT = "#: the worst operating point. Parts that are missing in the scene are not checked."


def physical_table(checks: Sequence[PhysicalCheck], units: Units = METRIC) -> Table:
    """Each number with its limit, at the operating point where it is worst."""
    rows = [
        [
            CHECKS[check.name],
            check.where,
            str(check.point + 1),
            worst_of(check, units),
            limit_of(check.limit, check.unit, units),
            check.verdict,
        ]
        for check in checks
    ]
    return table_of("Physical limits", HEADS, rows, [*failures(checks), POINT])


def failures(checks: Sequence[PhysicalCheck]) -> list[str]:
    """Why limits do not hold, or are not known to hold, in sentences."""
    open_ = [check for check in checks if check.verdict != "pass"]
    return list(dict.fromkeys(f"{capital(CHECKS[check.name])}: {check.note}" for check in open_))


def limit_of(value: float, unit: str, units: Units = METRIC) -> str:
    """A number of a physical verdict, SI, as it is shown: shares in per cent, shares and angles below 1e-6 as 0."""
    seen = 0.0 if abs(value) < 1e-6 else value
    if unit == "rad":
        return f"{1e3 * seen:.3g} mrad"
    return units.pressure.written(value, ".3g") if unit == "Pa" else percent_of(seen)


def worst_of(check: PhysicalCheck, units: Units = METRIC) -> str:
    """The number of a physical verdict."""
    if check.value is None:
        return "infinite" if check.verdict == "fail" else "unknown"
    return limit_of(check.value, check.unit, units)


def numerical_words(check: NumericalCheck) -> str:
    """Whether the torque is solved within the tolerance, in a sentence."""
    words = f"Numerical: {check.verdict}, the uncertainty of the torque is {100 * check.uncertainty:.2g} %"
    return f"{words}, {'within' if check.verdict == 'pass' else 'beyond'} the tolerance {100 * check.tolerance:.3g} %."


def limits_section(
    physical: Sequence[PhysicalCheck],
    numerical: NumericalCheck | None,
    notes: Sequence[str],
    summary: Summary,
    units: Units = METRIC,
) -> Section:
    """The physical limits, what else to know of a torque, and all verdicts in a word each."""
    words = [*notes, *([] if numerical is None else [numerical_words(numerical)])]
    verdict = Text(summary.words.partition(": ")[2], verdict=summary.overall)
    return Section("Solver error and limits", [physical_table(physical, units), *map(Text, words), verdict])
