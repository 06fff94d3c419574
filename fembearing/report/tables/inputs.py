"""Which effects count, and where the inputs come from."""

from collections.abc import Iterable, Sequence

from analytic.effects import Effect
from analytic.scenefile.inputs import StatedInput
from fembearing.quantities import METRIC, Units
from fembearing.report.phrases import share_of, value_of
from fembearing.report.tables.table import Head, Table, table_of

EFFECTS = (Head("effect", "name"), Head("", "name"), Head("share", fixed=True), Head("reason", "text"))
SHARES = (
    "Share: of the total, the largest of all operating points where the effect has a part of the torque; else the "
    "change of the torque without it"
)
ORIGINS = (
    "Given: in the scene. Printed: in a catalogue or a paper. Derived: computed from printed values. Assumed: no "
    "printed source. +-: one standard deviation."
)
INPUTS = (Head("input", "name"), Head("value", "name"), Head("status", "name"), Head("source", "text", wide=True))


def effects_table(effects: Iterable[Effect], points: Sequence[int] = ()) -> Table:
    """Each effect with its decision, share and reason; points : at which shares are measured, from 0"""
    rows = [[each.name, each.decision, share_of(each.share_is, each.share), each.reason] for each in effects]
    at = ", ".join(str(1 + point) for point in points)
    where = f", at operating point{'s' if len(points) > 1 else ''} {at}" if points else ""
    return table_of("Effects", EFFECTS, rows, [f"{SHARES}{where}. About: estimated, not computed."])


def inputs_table(label: str, inputs: Iterable[StatedInput], units: Units = METRIC) -> Table:
    """Each input with its value and its origin."""
    rows = [
        [each.key, value_of(each.value, each.uncertainty, each.unit, units), each.status, each.source]
        for each in inputs
    ]
    return table_of(label, INPUTS, rows, [ORIGINS])
