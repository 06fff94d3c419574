"""A friction torque as named columns, one value an operating point: what datasets, sweeps and notebooks show."""

from html import escape
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from analytic.scene import Array

if TYPE_CHECKING:
    from analytic.result import FrictionTorque

POINT = "point"
MOST_ROWS = 12  # of the table in a notebook


class Column(NamedTuple):
    unit: str  # SI; "1" of a pure number
    meaning: str


COLUMNS: dict[str, Column] = {
    "torque_total": Column("N m", "friction torque"),
    "torque_race": Column("N m", "friction torque of balls on races"),
    "torque_spin": Column("N m", "part of the friction torque by spin"),
    "torque_conformity": Column("N m", "part of the friction torque by conformity"),
    "torque_hysteresis": Column("N m", "part of the friction torque by elastic hysteresis"),
    "torque_rolling": Column("N m", "part of the friction torque by hydrodynamic rolling"),
    "torque_cage": Column("N m", "part of the friction torque by the cage"),
    "torque_declared": Column("N m", "part of the friction torque that the scene declares for seals and drag"),
    "uncertainty_numerical": Column("1", "numerical uncertainty of the friction torque, relative"),
    "uncertainty_model": Column("1", "uncertainty of the friction torque by the film formula, relative, 95 %"),
    "contact_angle": Column("rad", "contact angle of the heaviest ball"),
    "ball_load": Column("N", "load of the heaviest ball on the race where it is larger"),
    **{
        f"{name}_{race}": Column(unit, f"{meaning}, {race} race")
        for name, unit, meaning in (
            ("friction_coefficient", "1", "friction coefficient"),
            ("film", "m", "film thickness between the mean planes"),
            ("asperity_share", "1", "share of the load on asperities"),
            ("load", "N", "load of the heaviest ball"),
            ("semi_axis_rolling", "m", "semi-axis of the contact along rolling"),
            ("semi_axis_transverse", "m", "semi-axis of the contact across rolling"),
            ("peak_pressure", "Pa", "peak pressure"),
            ("approach", "m", "approach of ball and race"),
        )
        for race in ("inner", "outer")
    },
    "friction_coefficient_pocket": Column("1", "friction coefficient of ball on cage pocket"),
}


def torque_values(found: "FrictionTorque") -> dict[str, Array]:
    """The values of COLUMNS, each (n,); NaN where a part was left out or is not modelled."""
    nothing = np.full(found.inner_speed.shape, np.nan)
    values = {f"torque_{name}": part for name, part in vars(found.torque).items()}
    values |= {
        "uncertainty_numerical": found.numerical_uncertainty,
        "uncertainty_model": found.model_uncertainty,
        "contact_angle": found.contact_angle,
        "ball_load": found.ball_load,
    }
    for name in ("friction_coefficient", "film", "asperity_share"):
        values |= {f"{name}_{place}": part for place, part in vars(getattr(found, name)).items()}
    for race in ("inner", "outer"):
        values |= {f"{name}_{race}": part for name, part in vars(getattr(found, race)).items()}
    return {name: nothing if values[name] is None else np.asarray(values[name]) for name in COLUMNS}


def torque_dataset(found: "FrictionTorque") -> Any:
    """An xarray.Dataset over the operating points, with units and meanings as attributes.

    A column that holds nothing, as its part was left out or is not modelled, is not in it.
    """
    import xarray  # on demand: it takes a second

    columns = torque_values(found)
    return xarray.Dataset(
        {
            name: (POINT, columns[name], {"units": column.unit, "long_name": column.meaning})
            for name, column in COLUMNS.items()
            if not np.all(np.isnan(columns[name]))
        },
        coords={
            "inner_speed": (POINT, found.inner_speed, {"units": "rad/s", "long_name": "speed of the inner ring"}),
            "axial_load": (POINT, found.axial_load, {"units": "N", "long_name": "axial load"}),
        },
        attrs={**found.provenance, "warnings": "\n".join(found.warnings)},
    )


def torque_html(found: "FrictionTorque") -> str:
    """A table for a notebook: a row an operating point, the torque in N mm by effect."""
    parts = {name: part for name, part in vars(found.torque).items() if part is not None}
    head = ["speed, rpm", "axial load, N", *(f"{name}, N mm" for name in parts), "uncertainty, %"]
    shown = min(found.inner_speed.size, MOST_ROWS)
    rows = [
        [
            f"{found.inner_speed[i] * 30 / np.pi:.4g}",
            f"{found.axial_load[i]:.4g}",
            *(f"{1e3 * part[i]:.4g}" for part in parts.values()),
            f"{100 * found.numerical_uncertainty[i]:.2g}",
        ]
        for i in range(shown)
    ]
    more = found.inner_speed.size - shown
    return html_table(head, rows, f"friction torque, {more} more points" if more else "friction torque")


def html_table(head: list[str], rows: list[list[str]], caption: str) -> str:
    """Rows of text as an HTML table."""

    def row(cells: list[str], tag: str) -> str:
        return "<tr>" + "".join(f"<{tag}>{escape(cell)}</{tag}>" for cell in cells) + "</tr>"

    body = "".join(row(cells, "td") for cells in rows)
    return f"<table><caption>{escape(caption)}</caption><thead>{row(head, 'th')}</thead><tbody>{body}</tbody></table>"
