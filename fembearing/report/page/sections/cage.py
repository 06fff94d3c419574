"""The cage: the stiffness of its pockets by each model, and its motion."""

from collections.abc import Sequence
from typing import NamedTuple

from fembearing.quantities import Units
from fembearing.report.contact import ContactRecord, sheet_in_series
from fembearing.report.phrases import digits, place_of, shown
from fembearing.report.report import Report
from fembearing.report.tables.cage import motion_table, regime_table
from fembearing.report.tables.table import Head, Row, Table, table_of


class CageSection(NamedTuple):
    """Tables of the section; None where there is nothing to show."""

    pocket: Table | None
    load: str  # of the pocket
    sheet: str | None  # stiffness of the sheet in series with the seat, and its uncertainty
    motion: Table | None
    regimes: Table | None


def cage_section(document: Report) -> CageSection:
    """What the section shows."""
    units = document.units
    rows = enumerate(document.cage_motion or (), start=1)
    moved = {number: point for number, point in rows if point.torque is not None}
    return CageSection(
        pocket=_pocket(document.contacts, units),
        load=units.force.written(document.contacts[-1].load, ".4g"),
        sheet=_sheet(document.contacts, units),
        motion=motion_table(moved, units) if moved else None,
        regimes=regime_table(moved, units) if moved else None,
    )


def _sheet(contacts: Sequence[ContactRecord], units: Units) -> str | None:
    series = sheet_in_series(*contacts[2:]) if len(contacts) == 4 else None
    return series and f"{units.tangent.written(series.stiffness, '.4g')} +- {series.uncertainty:.2%}"


def _pocket(contacts: Sequence[ContactRecord], units: Units) -> Table | None:
    """Each model of the pocket, Hertz first; None without a cage."""
    if len(contacts) < 4:
        return None
    approach, stiffness = units.small_length, units.stiffness
    models = [("Hertz: two half spaces", contacts[2].hertz, None)]
    models += [(place_of(each.pair, each.geometry), each.fe, each.uncertainty.stiffness) for each in contacts[2:]]
    heads = [
        Head("model", "text"),
        Head(f"K_pb, {stiffness.name}"),
        Head("uncertainty"),
        Head("less Hertz's, of Hertz's"),
        Head(f"approach, {approach.name}"),
    ]
    rows: list[Row] = [
        [
            model,
            digits(values.stiffness, stiffness.factor, 4),
            shown(uncertainty, ".2%", absent=""),
            f"{values.stiffness / contacts[2].hertz.stiffness - 1:+.1%}",
            digits(values.approach, approach.factor, 4),
        ]
        for model, values, uncertainty in models
    ]
    return table_of("stiffness of the pocket", heads, rows)
