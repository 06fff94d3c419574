"""A solved contact as named columns of one value each: what datasets, sweeps and notebooks show."""

import math
from collections.abc import Mapping
from typing import Any

from analytic.errors import InputError
from analytic.labelled import Column, Labelled, dataset_of, html_table
from fembearing.quantities import CONTACT, QUANTITIES

COLUMNS: dict[str, Column] = {
    "load": Column("N", QUANTITIES["load"].meaning),
    "contact_angle": Column("rad", "contact angle"),
    **{name: Column(each.unit, f"{each.meaning}, finite elements") for name, each in CONTACT.items()},
    **{
        f"uncertainty_{name}": Column("1", f"numerical uncertainty of the {each.meaning}, relative, 95 %")
        for name, each in CONTACT.items()
    },
    **{f"hertz_{name}": Column(each.unit, f"{each.meaning}, Hertz") for name, each in CONTACT.items()},
    **{
        f"discrepancy_{name}": Column("1", f"discrepancy of Hertz's {each.meaning}, over finite elements minus one")
        for name, each in CONTACT.items()
    },
    "unknowns": Column("1", "unknowns of the finest mesh"),
}
VERDICT = "verdict"  # a word that goes with the columns


def require_finite_results(values: Mapping[str, float | None], *, of: str) -> None:
    """Raise InputError for a number that is not finite, so that no face of the result shows it.

    values : by their meaning; None where one is left out;  of : what they belong to
    """
    for meaning, value in values.items():
        if value is not None and not math.isfinite(value):
            raise InputError(
                f"the {meaning} is {value:g}, {of}: the numbers of the scene are outside the computable range; give "
                "usual ones"
            )


def contact_dataset(values: Mapping[str, float], attributes: Mapping[str, Any]) -> Any:
    """An xarray.Dataset without dimensions, with units and meanings as attributes.

    values : of COLUMNS
    """
    variables = {name: Labelled((), value, COLUMNS[name]) for name, value in values.items()}
    return dataset_of(variables, coordinates={}, attributes=attributes)


def contact_html(values: Mapping[str, float], caption: str) -> str:
    """A table for a notebook: a row for each quantity.

    values : of COLUMNS
    """
    rows = [
        [
            f"{each.meaning}, {each.unit}",
            f"{values[name]:.5g}",
            f"{100 * values[f'uncertainty_{name}']:.2g}",
            f"{values[f'hertz_{name}']:.5g}",
            f"{100 * values[f'discrepancy_{name}']:+.2f}",
        ]
        for name, each in CONTACT.items()
    ]
    return html_table(["", "finite elements", "uncertainty, %", "Hertz", "Hertz off by, %"], rows, caption)
