"""A solved contact as named columns of one value each: what datasets, sweeps and notebooks show."""

from typing import TYPE_CHECKING, Any

from analytic.torque_columns import Column, html_table

if TYPE_CHECKING:
    from fembearing.compare.contact.discrepancy import ContactSolution

QUANTITIES = {
    "semi_axis_rolling": Column("m", "semi-axis along rolling"),
    "semi_axis_transverse": Column("m", "semi-axis across rolling"),
    "peak_pressure": Column("Pa", "peak pressure"),
    "approach": Column("m", "approach"),
    "stiffness": Column("N/m^1.5", "stiffness (load over approach^1.5)"),
}
COLUMNS: dict[str, Column] = {
    "load": Column("N", "load of the ball"),
    "contact_angle": Column("rad", "contact angle"),
    **{name: Column(unit, f"{meaning}, finite elements") for name, (unit, meaning) in QUANTITIES.items()},
    **{
        f"uncertainty_{name}": Column("1", f"numerical uncertainty of the {meaning}, relative, 95 %")
        for name, (_, meaning) in QUANTITIES.items()
    },
    **{f"hertz_{name}": Column(unit, f"{meaning}, Hertz") for name, (unit, meaning) in QUANTITIES.items()},
    **{
        f"discrepancy_{name}": Column("1", f"discrepancy of Hertz's {meaning}, over finite elements minus one")
        for name, (_, meaning) in QUANTITIES.items()
    },
    "unknowns": Column("1", "unknowns of the finest mesh"),
}
VERDICT = "verdict"  # a word beside the columns


def contact_values(found: "ContactSolution") -> dict[str, float]:
    """The values of COLUMNS."""
    return {
        "load": found.contact.load,
        "contact_angle": found.contact.contact_angle,
        **vars(found.reference),
        **{f"uncertainty_{name}": part.total for name, part in found.estimates.items()},
        **{f"hertz_{name}": value for name, value in vars(found.hertz).items()},
        **{f"discrepancy_{name}": value for name, value in found.discrepancy.items()},
        "unknowns": float(found.meshes[-1].unknowns),
    }


def shown_verdict(found: "ContactSolution") -> str:
    return found.verdict if found.judged else "shown"


def contact_dataset(found: "ContactSolution") -> Any:
    """An xarray.Dataset without dimensions, with units and meanings as attributes."""
    import xarray  # on demand: it takes a second

    return xarray.Dataset(
        {
            name: ((), value, {"units": COLUMNS[name].unit, "long_name": COLUMNS[name].meaning})
            for name, value in contact_values(found).items()
        },
        attrs={
            "pair": found.contact.pair,
            "geometry": found.geometry,
            "rung": found.method,
            "tolerance": found.tolerance,
            VERDICT: shown_verdict(found),
            "warnings": "\n".join(found.warnings),
        },
    )


def contact_html(found: "ContactSolution") -> str:
    """A table for a notebook: a row a quantity."""
    values = contact_values(found)
    rows = [
        [
            f"{meaning}, {unit}",
            f"{values[name]:.5g}",
            f"{100 * values[f'uncertainty_{name}']:.2g}",
            f"{values[f'hertz_{name}']:.5g}",
            f"{100 * values[f'discrepancy_{name}']:+.2f}",
        ]
        for name, (unit, meaning) in QUANTITIES.items()
    ]
    caption = f"{found.contact.pair}, {found.geometry}, {found.contact.load:.4g} N: {shown_verdict(found)}"
    return html_table(["", "finite elements", "uncertainty, %", "Hertz", "Hertz off by, %"], rows, caption)
