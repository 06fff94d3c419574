"""The registry of what a torque shows at an operating point: every number once, with its unit, meaning and symbol.

CSV, JSON, datasets, data frames and tables read it.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from analytic.brief import html_table
from analytic.labelled import Column, Labelled
from analytic.scene import Array
from analytic.units import GIGA, MICRO, MILLI, STIFFNESS
from analytic.words import NEWTON, PERCENT, rounded

# The numbers of one operating point by their names, SI; None: left out, not modelled or not known
Point = Mapping[str, Any]
# SI unit -> size below which a number is what rounding leaves of 0.
ROUNDING = {"N m": 1e-15, "rad": 1e-12, "m": 1e-15}
NOTEBOOK = ("inner_speed", "axial_load", "radial_load", "moment", "torque_", "uncertainty_numerical", "interval_")
MOST_ROWS = 12  # of a table in a notebook
OF_MODEL = "uncertainty_model_"  # how the names of the parts of the model's uncertainty begin
MODEL_PARTS = {  # of the uncertainty by the formulas: what is varied
    "film": "film formula",
    "traction": "shear stress of the oil",
    "gap": "law of the load on asperities",
    "surfaces": "spread of surfaces",
    "rolling": "formula of rolling",
    "reach": "reach of the oil",
    "heating": "heating of the inlets",
    "starvation": "starved or flooded inlets",
    "elastic_rolling": "law of elastic rolling",
    "grease_film": "films with grease",
    "unloaded_balls": "unloaded balls",
    "oil_losses": "losses of the oil",
}
# An operating point, as it is given.
COORDINATES: dict[str, Column] = {
    "inner_speed": Column("rad/s", "speed of the inner ring"),
    "axial_load": Column("N", "axial load", "Fa"),
    "radial_load": Column("N", "radial load", "Fr"),
    "moment": Column("N m", "moment", "M"),
}
# What is computed there.
OF_TORQUE: dict[str, Column] = {
    "torque_total": Column("N m", "friction torque"),
    "torque_race": Column("N m", "friction torque of balls on races"),
    "torque_spin": Column("N m", "part of the friction torque by spin"),
    "torque_conformity": Column("N m", "part of the friction torque by conformity"),
    "torque_hysteresis": Column("N m", "part of the friction torque by elastic hysteresis"),
    "torque_rolling": Column("N m", "part of the friction torque by hydrodynamic rolling"),
    "torque_cage": Column("N m", "part of the friction torque by the cage"),
    "torque_oil": Column("N m", "part of the friction torque by oil that flows through, is sheared and stirred"),
    "torque_declared": Column("N m", "part of the friction torque that the scene declares for seals and drag"),
    "uncertainty_numerical": Column("1", "numerical uncertainty of the friction torque, relative", metric=PERCENT),
    "uncertainty_model": Column(
        "1", "uncertainty of the friction torque by the model's formulas, relative, 95 %", metric=PERCENT
    ),
    "contact_angle": Column("rad", "contact angle of the heaviest ball", "al"),
    "ball_load": Column("N", "load of the heaviest ball on the race where it is larger", "Q"),
    "tilt": Column("rad", "tilt of the inner ring about y under unequal loads"),
    "holding_moment": Column("N m", "moment about y that holds the inner ring at its tilt"),
    **{
        f"{name}_{race}": Column(unit, f"{meaning}, {race} race", symbol, metric=metric)
        for name, unit, meaning, symbol, metric in (
            ("friction_coefficient", "1", "friction coefficient", "mu", None),
            ("film", "m", "mean gap that the oil fills", "h", MICRO),
            ("asperity_share", "1", "share of the load on asperities", "s", PERCENT),
            ("boundary_share", "1", "share of the load with boundary friction", "s_b", PERCENT),
            ("load", "N", "load of the heaviest ball", "Q", NEWTON),
            ("semi_axis_rolling", "m", "semi-axis of the contact along rolling", "a", MILLI),
            ("semi_axis_transverse", "m", "transverse semi-axis of the contact", "b", MILLI),
            ("peak_pressure", "Pa", "peak pressure", "p0", GIGA),
            ("approach", "m", "approach of ball and race", "delta", MICRO),
        )
        for race in ("inner", "outer")
    },
    "friction_coefficient_pocket": Column("1", "friction coefficient of ball on cage pocket", "mu"),
}
CONTACT: dict[str, Column] = {  # of a contact that is compared, in the order in which they are shown
    "approach": Column("m", "approach", "delta", metric=MICRO),
    "semi_axis_rolling": Column("m", "semi-axis along rolling", "a", "semi-axis a", MILLI),
    "semi_axis_transverse": Column("m", "transverse semi-axis", "b", "semi-axis b", MILLI),
    "peak_pressure": Column("Pa", "peak pressure", "p0", metric=GIGA),
    "stiffness": Column("N/m^1.5", "stiffness (load over approach^1.5)", "K", "stiffness", STIFFNESS),
}
STRESSES: dict[str, Column] = {  # under the centre of a contact
    "max_shear": Column("Pa", "greatest shear stress", short="shear", metric=GIGA),
    "max_shear_depth": Column("m", "depth of the greatest shear stress", short="its depth", metric=MICRO),
    "max_von_mises": Column("Pa", "greatest von Mises stress", short="von Mises", metric=GIGA),
    "max_von_mises_depth": Column("m", "depth of the greatest von Mises stress", short="its depth", metric=MICRO),
}
# All numbers that are shown.
COLUMNS: dict[str, Column] = {
    **COORDINATES,
    **CONTACT,
    **STRESSES,
    "film": Column("m", "film thickness between the mean planes", "h", "film", MICRO),
    "load": Column("N", "load of the ball", "Q"),
    "viscosity": Column("Pa s", "viscosity"),
    "rms_roughness": Column("m", "rms roughness", "Sq", metric=MICRO),
    "conformity": Column("1", "conformity, groove radius over ball diameter"),
    **OF_TORQUE,
    **{
        f"{OF_MODEL}{name}": Column(
            "1", f"part of the uncertainty by the model's formulas: {words}, relative, 95 %", metric=PERCENT
        )
        for name, words in MODEL_PARTS.items()
    },
    "interval_low": Column("N m", "lower end of the 95 % interval of the friction torque"),
    "interval_high": Column("N m", "upper end of the 95 % interval of the friction torque"),
    "catalogue_low": Column("N m", "lower end of the catalogue band"),
    "catalogue_high": Column("N m", "upper end of the catalogue band"),
    "temperature": Column("K", "temperature of the oil"),
    # Of a step of a duty cycle.
    "duration": Column("s", "duration"),
    "torque": Column("N m", "friction torque"),
    "torque_low": Column("N m", "lower end of the 95 % interval of the friction torque"),
    "torque_high": Column("N m", "upper end of the 95 % interval of the friction torque"),
    "power": Column("W", "power of friction"),
    "energy": Column("J", "energy of friction"),
    # Of a measured torque beside the computed one.
    "measured": Column("N m", "measured friction torque"),
    "computed": Column("N m", "computed friction torque"),
    "error": Column("N m", "computed less measured friction torque"),
    "numerical": Column("N m", "standard uncertainty of the solver"),
    "input": Column("N m", "standard uncertainty by the inputs"),
    "measurement": Column("N m", "standard uncertainty of the measured torque"),
    "validation": Column("N m", "validation uncertainty, of solver, inputs and measurement"),
    "formulas": Column("N m", "standard uncertainty by the formulas"),
    "computed_low": Column("N m", "lower end of the 95 % interval of the computed friction torque"),
    "computed_high": Column("N m", "upper end of the 95 % interval of the computed friction torque"),
    "low": Column("N m", "lower end of the 95 % interval of the measured friction torque"),
    "high": Column("N m", "upper end of the 95 % interval of the measured friction torque"),
    "beyond": Column("N m", "distance of the measured torque from its 95 % interval"),
}

# What the cage does; a closed form has no value of some. A name with a slash is that of a number within a group.
OF_CAGE: dict[str, Column] = {
    "mean_force": Column("N", "sum of the normal forces in all pockets, mean", "F"),
    "max_force": Column("N", "force of one contact, median over blocks of the largest", "F_max"),
    "interval/torque": Column("N m", "95 % interval of the mean torque"),
    "interval/max_force": Column("N", "95 % interval of the largest force"),
    "duration": Column("s", "measured time of all seeds together"),
    "state": Column("", "how it moves"),
    "signed_moment": Column("N m", "moment of the balls on the cage about the axis, balanced by drag and land"),
    "whirl_speed": Column("rad/s", "mean speed of the centre about the axis, with the sign of the orbit"),
    "wobble": Column("m", "root mean square change of the centre's distance from the axis"),
    "ball_lead": Column("m", "how far balls lead on one side of the bearing and lag on the other", "A"),
    "grip_share": Column("1", "share of what the races of all balls carry along the orbit that the mean force uses"),
    "grip_number": Column("1", "the same of a whirl, by the ball with the least grip", "rho"),
    "race_excess": Column("N m", "part of the torque that the races lose more because the cage drags the balls"),
}
# What only a cage that moved has.
OF_MOTION: dict[str, Column] = {
    "torque": Column("N m", "power of sliding and drag over the speed of the ring"),
    "start": Column("", "how the motion begins"),
    "block": Column("s", "length of a block"),
    "other/start": Column("", "another start"),
    "other/state": Column("", "how the cage then moves"),
    "other/torque": Column("N m", "the torque then"),
}
FREEDOMS = ("axial", "x", "y", "tilt_x", "tilt_y")  # of the ring
# The inner ring against the outer one, and every ball between them.
OF_RING: dict[str, Column] = {
    **{
        f"displacement/{name}": Column("rad" if "tilt" in name else "m", f"displacement of the ring, {name}")
        for name in FREEDOMS
    },
    "stiffness": Column("N/m, N or N m", "force or moment of the ring by displacement or tilt"),
    "balls/azimuth": Column("rad", "azimuth of the ball, from x towards y"),
    **{f"balls/{race}_load": Column("N", f"load of the ball, {race} race", "Q") for race in ("inner", "outer")},
    **{
        f"balls/{race}_angle": Column("rad", f"contact angle of a loaded ball, {race} race", "al")
        for race in ("inner", "outer")
    },
    "holding_moment": COLUMNS["holding_moment"],
}


VERDICT = "verdict"  # a column of words beside those of numbers
CONTACT_COLUMNS: dict[str, Column] = {  # of a solved contact
    "load": COLUMNS["load"],
    "contact_angle": Column("rad", "contact angle"),
    **{
        f"{prefix}{name}": Column(unit or each.unit, words.format(each.meaning))
        for prefix, unit, words in (
            ("", "", "{}, finite elements"),
            ("uncertainty_", "1", "numerical uncertainty of the {}, relative, 95 %"),
            ("hertz_", "", "{}, Hertz"),
            ("discrepancy_", "1", "discrepancy of Hertz's {}, over finite elements minus one"),
        )
        for name, each in CONTACT.items()
    },
    "unknowns": Column("1", "unknowns of the finest mesh"),
}


def rows_of(columns: Mapping[str, ArrayLike]) -> tuple[Point, ...]:
    """The rows of columns. None: a number that is not finite, or a group without any that is.

    columns : each (n,) or (n, ...); "balls/azimuth" is `azimuth` in the group `balls`
    """
    listed = [_listed(np.asarray(each)) for each in columns.values()]
    return tuple(_nested(zip(columns, row, strict=True)) for row in zip(*listed, strict=True))


def _listed(values: NDArray[Any]) -> list[Any]:
    """The elements along the first axis."""
    if values.dtype.kind != "f":
        return values.tolist()
    known, values = np.isfinite(values), values.astype(object)
    values[~known] = None
    return values.tolist()


def _nested(row: Iterable[tuple[str, Any]]) -> Point:
    """A row whose values stand in the groups of their names."""
    made: dict[str, Any] = {}
    for name, value in row:
        group, _, inner = name.rpartition("/")
        (made.setdefault(group, {}) if group else made)[inner] = value
    unknown = [name for name, each in made.items() if isinstance(each, dict) and not _is_known([*each.values()])]
    return made | dict.fromkeys(unknown)


def _is_known(value: Any) -> bool:
    return any(map(_is_known, value)) if isinstance(value, list) else value is not None


def without_residue(name: str, values: Array) -> Array:
    """The numbers of a column with 0 in place of what rounding leaves of it, as a spin torque of 1e-33 N m."""
    least = ROUNDING.get(COLUMNS[name].unit, 0.0)
    return np.where(np.abs(values) < least, 0.0, values)


def points_table(columns: Mapping[str, Labelled], *, caption: str, notes: Sequence[str]) -> str:
    """An HTML table of operating points for a notebook, metric, with sentences below it.

    It has the columns of NOTEBOOK that are not 0 or unknown at every point.
    """
    kept = {
        name: (each.column.shown(), np.asarray(each.values, dtype=float))
        for name, each in columns.items()
        if name.startswith(NOTEBOOK) and np.nan_to_num(each.values).any()
    }
    heads = [f"{name.removeprefix('torque_').replace('_', ' ')}, {unit.name}" for name, (unit, _) in kept.items()]
    size = len(next(iter(kept.values()), ((), ()))[1])
    rows = [
        ["" if np.isnan(values[row]) else rounded(unit.number(values[row]), 4) for unit, values in kept.values()]
        for row in range(min(size, MOST_ROWS))
    ]
    more = [f"{size - MOST_ROWS} more points."] if size > MOST_ROWS else []
    return html_table(heads, rows, caption, [*more, *notes])
