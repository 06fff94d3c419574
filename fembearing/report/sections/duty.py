"""A duty cycle: its steps, and energy, torque and power of the whole."""

from analytic.prediction.duty import DutyCycle, DutyStep, Estimate
from analytic.units import METRIC, Units
from analytic.words import Unit
from fembearing.report.document import Head, Row, Section, Table, table_of
from fembearing.report.sections.points import fixed_loads, point_cells, point_heads

JOULE, WATT_HOUR, WATT = Unit("J", 1.0), Unit("Wh", 1 / 3600), Unit("W", 1.0)
MOST_ROWS = 24  # steps that are shown
NOT_KNOWN = "not known"
NOTES = (
    "95 %: to first order; the error of an input is the same in all steps, different inputs are independent. Mean "
    "torque: energy over the angle turned. Mean power: energy over the whole duration. Inertia and warm-up time are "
    "neglected."
)


def steps_table(cycle: DutyCycle, units: Units = METRIC) -> Table:
    """A row for each step; of a long cycle those with the most energy, in their order."""
    steps = cycle.steps
    points = [vars(step) for step in steps]
    chosen = sorted(sorted(range(len(steps)), key=lambda place: -steps[place].energy)[:MOST_ROWS])
    temperatures = {step.temperature for step in steps}
    heads = point_heads(points, units)
    heads[1:1] = [Head("duration, s", short="s")]
    heads += [Head(f"oil, {units.temperature.name}", short=units.temperature.name)] if len(temperatures) > 1 else []
    heads += [Head(f"torque, {units.torque.name}", short=units.torque.name), Head("95 %", fixed=True)]
    heads += [Head("power, W", short="W"), Head("energy, J", short="J"), Head("share, %", short="%")]

    def cells(place: int, step: DutyStep) -> Row:
        number, *point = point_cells(points, place, units)
        warm = step.temperature
        oil = [] if len(temperatures) < 2 or warm is None else [f"{units.temperature.number(warm):.4g}"]
        return [
            number,
            f"{step.duration:.4g}",
            *point,
            *oil,
            f"{units.torque.number(step.torque.value):.4g}",
            _ends(step.torque, units.torque) if step.power else "-",
            f"{step.power:.3g}",
            f"{step.energy:.4g}",
            f"{100 * step.energy / cycle.energy.value:.3g}" if cycle.energy.value else "-",
        ]

    words = [f"Steps of {cycle.file}", *fixed_loads(points, units)]
    if len(temperatures) == 1 and (warm := steps[0].temperature) is not None:
        steady = "" if cycle.steady is None else " (steady)"
        words.append(f"oil at {units.temperature.written(warm, '.4g')}{steady}")
    notes = [f"{MOST_ROWS} of {len(steps)} steps, those with the most energy."] if len(chosen) < len(steps) else []
    return table_of(", ".join(words), heads, [cells(place, steps[place]) for place in chosen], notes)


def cycle_table(cycle: DutyCycle, units: Units = METRIC) -> Table:
    """Energy, mean and worst torque and mean power of the cycle."""
    rows = [
        _row("energy", cycle.energy, JOULE),
        _row("energy", cycle.energy, WATT_HOUR),
        _row("mean torque", cycle.mean_torque, units.torque),
        _row(f"worst torque, step {cycle.worst_step + 1}", cycle.worst_torque, units.torque),
        _row("mean power", cycle.mean_power, WATT),
    ]
    notes = [] if cycle.steady is None else [f"Oil temperature: {cycle.steady.words}."]
    if cycle.energy.low is None:
        notes.append("No interval: no torque at the bound of an input.")
    heads = [Head("of the cycle", "name"), Head("value"), Head("95 %", fixed=True), Head("unit", "name")]
    return table_of(f"{cycle.scene}, {cycle.duration:.5g} s", heads, rows, [*notes, NOTES])


def _row(name: str, estimate: Estimate, unit: Unit) -> Row:
    return [name, f"{unit.number(estimate.value):.4g}", _ends(estimate, unit), unit.name]


def _ends(estimate: Estimate, unit: Unit) -> str:
    if estimate.low is None or estimate.high is None:
        return NOT_KNOWN
    return "-".join(f"{unit.number(end):.4g}" for end in (estimate.low, estimate.high))


def duty_section(cycle: DutyCycle, units: Units = METRIC) -> Section:
    """The steps, and the whole cycle."""
    return Section("", [steps_table(cycle, units), cycle_table(cycle, units)])
