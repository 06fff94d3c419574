"""Measured torques in a CSV file: one row for each operating point, in columns as `analytic.scenefile.columns` reads.

Every message is one line with the place, the value and what is accepted.
"""

import os
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from analytic.declared import read_only
from analytic.errors import InputError
from analytic.quantity import Dimension
from analytic.scene import Lubricant, MeasuredTorque
from analytic.scenefile.columns import OPERATING, Columns, Row, operating_column
from analytic.scenefile.keys import Values
from analytic.scenefile.oil import lubricant_of
from analytic.words import plain, torque_of


@dataclass(frozen=True, kw_only=True)
class Magnitude(Dimension):
    """A quantity that is given without its sign."""

    def read(self, given: object) -> float:
        """The value in SI. Raises ValueError as `Dimension.read`, and for a value below 0."""
        if isinstance(given, str) and given.startswith("-"):
            raise ValueError("is below 0; give its magnitude, whatever its sign")
        return super().read(given)


TORQUE = Magnitude(unit="N m", low=1e-12, high=1e6, example='"35.1 N mm"')
COLUMNS = Columns(
    known={
        **{name: operating_column(name) for name in OPERATING},
        "torque": TORQUE,
        "uncertainty": Dimension(unit="N m", low=0.0, high=TORQUE.high, example='"0.8 N mm"'),
    },
    required="torque",
    row="measured torque",
    where="where the torques were measured",
    example=("inner_speed", "torque", "uncertainty"),
    shares=read_only({"uncertainty": Dimension(unit="", low=0, high=1, example='"2 %"')}),  # over its torque
)


def read_measured(path: str | os.PathLike[str]) -> MeasuredTorque:
    """The measured torques in a CSV file, without the oils at their temperatures.

    Raises InputError as `Columns.read`, and for a row where nothing turns or whose uncertainty exceeds its torque.
    """
    columns, rows = COLUMNS.read(path)
    file = plain(os.fspath(path))
    if any(column.is_share for column in columns):
        for row in rows:
            row.values["uncertainty"] *= row.values["torque"]
    for row in rows:
        _require_fit(row, file)
    values: dict[str, Any] = {column.name: np.array([row.values[column.name] for row in rows]) for column in columns}
    return MeasuredTorque(file=file, **values)


def _require_fit(row: Row, file: str) -> None:
    torque, uncertainty = row.values["torque"], row.values.get("uncertainty", 0.0)
    if row.values.get("inner_speed") == 0:
        raise InputError(f"{file}: {row.place}: inner_speed = 0: nothing turns; give the speed, or leave the row out")
    if uncertainty > torque:
        raise InputError(
            f"{file}: {row.place}: uncertainty = {torque_of(uncertainty)} is larger than the torque, "
            f"{torque_of(torque)}; give the standard uncertainty of the measured torque (k = 1)"
        )


def with_oils(measured: MeasuredTorque, values: Values, own: Lubricant | None, *, ball_radius: float) -> MeasuredTorque:
    """The same, with the oil that the scene describes at the temperature of each row.

    values, own : of the scene;  ball_radius : m. Raises InputError for temperatures without an oil, or beyond its data.
    """
    if measured.temperature is None:
        return measured
    if own is None:
        raise InputError(
            f"{measured.file}: the column temperature is that of the oil, and the scene has no [lubricant]; "
            "leave the column out"
        )
    oils = {own.temperature: own}
    for temperature in np.unique(measured.temperature).tolist():
        if temperature not in oils:
            try:
                oils[temperature] = lubricant_of(values.at(temperature), ball_radius=ball_radius)
            except InputError as problem:
                row = int(np.flatnonzero(measured.temperature == temperature)[0]) + 1
                raise InputError(
                    f"{measured.file}: row {row}: temperature = {temperature - 273.15:.4g} degC: {problem}"
                ) from problem
    return replace(measured, oils=read_only(oils))
